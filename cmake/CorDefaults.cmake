# SPDX-License-Identifier: MIT
# Build type and compiler flags of everything in this project. They do not affect a user's project. If cor is a part
# of another project (add_subdirectory, FetchContent), variables are set for this directory only. No cache entry of
# the other project is made or changed.

if(COR_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(CMAKE_C_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG") # CMake's default; any other is the user's choice
  set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_C_STANDARD_REQUIRED ON)

# A call of a function that no header declares, and similar mistakes, are errors for every value of COR_WERROR and every
# compiler, as in GCC since 14.
set(cor_errors implicit-function-declaration implicit-int int-conversion incompatible-pointer-types)
list(TRANSFORM cor_errors PREPEND -Werror=)

# No -ffast-math, no -march=native, no contraction: results are the same bits on every IEEE machine. A project without
# a build type also gets an optimized library. Clang puts independent operations into vectors and fills unused elements
# with numbers whose sums and products may overflow. -fno-slp-vectorize prevents the floating-point exceptions that
# these would raise. On s390x, gcc computes floats in double unless -fexcess-precision=fast.
add_library(cor_defaults INTERFACE)
target_compile_options(cor_defaults INTERFACE
  $<$<CONFIG:>:-O2> -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off
  $<$<C_COMPILER_ID:GNU>:-fexcess-precision=fast>
  $<$<BOOL:${MINGW}>:-Wno-float-conversion> # its isinf is a macro that also mentions float
  "$<$<C_COMPILER_ID:GNU,Clang,AppleClang>:${cor_errors}>"
  $<$<C_COMPILER_ID:Clang,AppleClang>:-fno-slp-vectorize> $<$<BOOL:${COR_WERROR}>:-Werror>)
