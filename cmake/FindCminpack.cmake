# SPDX-License-Identifier: MIT
# cminpack: least squares by the Levenberg-Marquardt method of MINPACK, in C.
#   Cminpack::Cminpack   everything to compile and link with
#   Cminpack_FOUND       true or false
#   Cminpack_MISSING     "cminpack" if it was not found
# CMINPACK_ROOT says where to look first.

find_path(CMINPACK_INCLUDE_DIR cminpack.h HINTS ${CMINPACK_ROOT} ENV CMINPACK_ROOT PATH_SUFFIXES cminpack-1
  include/cminpack-1 include)
find_library(CMINPACK_LIBRARY cminpack HINTS ${CMINPACK_ROOT} ENV CMINPACK_ROOT PATH_SUFFIXES lib)

set(Cminpack_MISSING "")
if(NOT CMINPACK_INCLUDE_DIR OR NOT CMINPACK_LIBRARY)
  set(Cminpack_MISSING cminpack)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Cminpack REQUIRED_VARS CMINPACK_INCLUDE_DIR CMINPACK_LIBRARY)
mark_as_advanced(CMINPACK_INCLUDE_DIR CMINPACK_LIBRARY)

if(Cminpack_FOUND AND NOT TARGET Cminpack::Cminpack)
  add_library(Cminpack::Cminpack INTERFACE IMPORTED)
  set_target_properties(Cminpack::Cminpack PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${CMINPACK_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${CMINPACK_LIBRARY};m")
endif()
