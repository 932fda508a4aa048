# SPDX-License-Identifier: MIT
# cor_defaults forbids contraction, so that every set gives the same bits. The loops vectorise only where sqrt need not
# set errno and comparisons may be evaluated ahead.
# -Wno-psabi: vectors are arguments of functions that are all inlined.
set(cor_array_options $<$<NOT:$<CONFIG:Debug>>:-O3> -fno-math-errno -fno-trapping-math -Wno-psabi)
set(cor_array_kernels sphere/array disk/rayleigh disk/collision disk/hard_wall law/array law/dashpot_array core/mode_source)
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
  foreach(kernel ${cor_array_kernels})
    set_source_files_properties(runtime/${kernel}_portable.c PROPERTIES COMPILE_OPTIONS "${cor_array_options}")
  endforeach()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    set(avx2 -mavx2)
    # AVX-512 has fused operations, which gcc 12 takes where it vectorises straight code, whatever -ffp-contract says.
    set(avx512 -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512 -fno-tree-slp-vectorize)
    foreach(set avx2 avx512)
      foreach(kernel ${cor_array_kernels})
        if(kernel MATCHES "^(core|disk)/|^law/array")
          target_sources(cor_without_tables PRIVATE runtime/${kernel}_${set}.c)
        else()
          target_sources(cor_with_tables PRIVATE runtime/${kernel}_${set}.c)
        endif()
        set_source_files_properties(runtime/${kernel}_${set}.c PROPERTIES
          COMPILE_OPTIONS "${cor_array_options};${${set}}")
      endforeach()
    endforeach()
    target_compile_definitions(cor_with_tables PRIVATE COR_X86_SETS)
    target_compile_definitions(cor_without_tables PRIVATE COR_X86_SETS)
  endif()
endif()
