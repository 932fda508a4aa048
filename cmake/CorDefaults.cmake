# SPDX-License-Identifier: MIT
# Build type and compiler flags of everything in this project. They do not affect a user's project. If cor is a part
# of another project (add_subdirectory, FetchContent), variables are set for this directory only. No cache entry of
# the other project is made or changed.

if(COR_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(CMAKE_C_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG") # CMake's default: the user chose no flags
  set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_C_STANDARD_REQUIRED ON)

# A call of a function that no header declares, and similar mistakes, are errors for every value of COR_WERROR and every
# compiler, as in GCC since 14.
set(cor_errors implicit-function-declaration implicit-int int-conversion incompatible-pointer-types)
list(TRANSFORM cor_errors PREPEND -Werror=)

# No -ffast-math, no -march=native, no contraction: results are the same bits on every IEEE machine. A project without
# a build type also gets an optimized library. -fno-slp-vectorize: clang would join independent operations into vectors
# and compute on their unused elements, which could raise floating-point exceptions. -fexcess-precision=fast: without
# it, gcc computes floats in double on s390x.
add_library(cor_defaults INTERFACE)
target_compile_options(cor_defaults INTERFACE
  $<$<CONFIG:>:-O2> -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off
  $<$<C_COMPILER_ID:GNU>:-fexcess-precision=fast>
  $<$<BOOL:${MINGW}>:-Wno-float-conversion> # the macro isinf of mingw-w64 also calls a function of float
  "$<$<C_COMPILER_ID:GNU,Clang,AppleClang>:${cor_errors}>"
  $<$<C_COMPILER_ID:Clang,AppleClang>:-fno-slp-vectorize> $<$<BOOL:${COR_WERROR}>:-Werror>)
