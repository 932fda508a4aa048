# SPDX-License-Identifier: MIT
# Build type and compiler flags of everything in this project; none of it reaches a user's project.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(CMAKE_C_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")
  set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of the Release build" FORCE)
endif()
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_C_STANDARD_REQUIRED ON)

# No -ffast-math, no -march=native, no contraction: results are the same bits on every IEEE machine.
add_library(cor_defaults INTERFACE)
target_compile_options(cor_defaults INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off $<$<BOOL:${COR_WERROR}>:-Werror>)
