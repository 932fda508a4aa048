# SPDX-License-Identifier: MIT
# cor_reference: laws and motions in long double, the reference of the library's tests and benchmarks
if(NOT TARGET cor_reference)
  add_library(cor_reference STATIC ${PROJECT_SOURCE_DIR}/tests/reference/laws.c)
  target_include_directories(cor_reference PRIVATE ${PROJECT_SOURCE_DIR}/include
    PUBLIC ${PROJECT_SOURCE_DIR}/tests/reference ${PROJECT_SOURCE_DIR}/tests/unit)
  target_link_libraries(cor_reference PRIVATE cor_defaults m)
  set_target_properties(cor_reference PROPERTIES C_STANDARD 99)
endif()
