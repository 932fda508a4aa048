# SPDX-License-Identifier: MIT
# cor_reference: the equation of motion in long double, what tests and benchmarks judge the library by.
if(NOT TARGET cor_reference)
  add_library(cor_reference STATIC ${PROJECT_SOURCE_DIR}/tests/unit/reference_ode.c)
  target_include_directories(cor_reference PUBLIC ${PROJECT_SOURCE_DIR}/tests/unit)
  target_link_libraries(cor_reference PRIVATE cor_defaults m)
  set_target_properties(cor_reference PROPERTIES C_STANDARD 99)
endif()
