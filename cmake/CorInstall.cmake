# SPDX-License-Identifier: MIT
# Libraries, headers, corgen with its man pages and completions, pkg-config files, CMake package, licence, examples.
# The installed tree can be moved, because the pkg-config files find their prefix from their own place. Documents are
# installed where Debian puts them, share/doc/cor.
include(CMakePackageConfigHelpers)

file(RELATIVE_PATH COR_PC_TO_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
set(COR_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/cor)
if(BUILD_SHARED_LIBS AND WIN32)
  set(COR_PC_CFLAGS " -DCOR_SHARED")
endif()
# install_library(COR_PC_LIBRARY COR_PC_ABOUT [COR_PC_REQUIRES]): a library with its pkg-config and CMake files
function(install_library COR_PC_LIBRARY COR_PC_ABOUT)
  set(COR_PC_REQUIRES ${ARGN})
  string(REPLACE _ - COR_PC_NAME ${COR_PC_LIBRARY})
  install(TARGETS ${COR_PC_LIBRARY} EXPORT ${COR_PC_NAME}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT ${COR_PC_NAME}-targets NAMESPACE cor:: DESTINATION ${COR_CMAKE_DIR})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/cor.pc.in ${PROJECT_BINARY_DIR}/${COR_PC_NAME}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${COR_PC_NAME}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
install_library(cor "${PROJECT_DESCRIPTION}")
install_library(cor_disk "Coefficient of restitution of elastic disks")
install_library(cor_scene "Contacts as simulators have them" cor)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/cor DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_SOURCE_DIR}/generated/cor_sphere.h ${PROJECT_SOURCE_DIR}/generated/sphere_rows.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(file LICENSE README.md CITATION.cff CHANGELOG.md CONTRIBUTING.md)
  install(FILES ${PROJECT_SOURCE_DIR}/${file} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/web/calculator.html DESTINATION ${CMAKE_INSTALL_DOCDIR}/web)
# Each Fortran compiler has its own format of module files, so users compile the module with their program.
install(FILES ${PROJECT_SOURCE_DIR}/fortran/cor.f90 DESTINATION ${CMAKE_INSTALL_DATADIR}/cor)
if(COR_HAVE_GENERATOR)
  install(TARGETS corgen RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  include(CorDocuments) # completion by shells, man pages
endif()

if(COR_IS_TOP_LEVEL)
  add_custom_target(uninstall VERBATIM COMMAND ${CMAKE_COMMAND}
    -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt -P ${PROJECT_SOURCE_DIR}/cmake/Uninstall.cmake)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/cor-config.cmake.in ${PROJECT_BINARY_DIR}/cor-config.cmake
  INSTALL_DESTINATION ${COR_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cor-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cor-config.cmake ${PROJECT_BINARY_DIR}/cor-config-version.cmake
  DESTINATION ${COR_CMAKE_DIR})
