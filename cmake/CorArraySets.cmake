# SPDX-License-Identifier: MIT
# cor_defaults forbids contraction, so that every set gives the same bits. The loops vectorise only where sqrt need not
# set errno and comparisons may be evaluated ahead.
set(cor_array_options -O3 -fno-math-errno -fno-trapping-math)
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
  set_source_files_properties(runtime/disk_rayleigh_spectrum.c PROPERTIES COMPILE_OPTIONS "${cor_array_options}")
  set_source_files_properties(runtime/sphere_array_portable.c PROPERTIES COMPILE_OPTIONS "${cor_array_options}")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    set(avx2 -mavx2)
    set(avx512 -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512)
    foreach(set avx2 avx512)
      target_sources(cor PRIVATE runtime/sphere_array_${set}.c)
      set_source_files_properties(runtime/sphere_array_${set}.c PROPERTIES
        COMPILE_OPTIONS "${cor_array_options};${${set}}")
    endforeach()
    target_compile_definitions(cor PRIVATE COR_X86_SETS)
  endif()
endif()
