# SPDX-License-Identifier: MIT
# The loops of array functions and disks. Each <stem>_kernel.c is compiled once for each instruction set
# (runtime/number/sets.h). cor_defaults forbids contraction, so every set gives the same bits. The loops vectorise only
# if sqrt need not set errno and comparisons may be evaluated ahead. -Wno-psabi omits a warning on functions with
# vectors as arguments, which are always inlined here.
set(cor_array_options $<IF:$<CONFIG:Debug>,-Og,-O3> -fno-math-errno -fno-trapping-math -Wno-psabi)
set(avx2 -mavx2)
# AVX-512 has fused operations, which gcc 12 uses when it vectorises straight code, in spite of -ffp-contract.
set(avx512 -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512 -fno-tree-slp-vectorize)

set(cor_with_tables_kernels law/array sphere/array table/row)
set(cor_disk_without_tables_kernels disk/mode_source disk/collision disk/hard_wall disk/rayleigh)
set(sets portable)
# The compiler identifies its target; CMAKE_SYSTEM_PROCESSOR is empty under many toolchain files.
include(CheckCSourceCompiles)
check_c_source_compiles("
#ifndef __x86_64__
#error another processor
#endif
int main(void) { return 0; }" COR_FOR_X86_64)
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND COR_FOR_X86_64)
  list(APPEND sets avx2 avx512)
  set(cor_sets_definition COR_X86_SETS)
endif()
list(JOIN sets ", " sets_text)
message(STATUS "Instruction sets of array functions: ${sets_text}")

foreach(part ${cor_parts})
  target_compile_definitions(${part} PRIVATE ${cor_sets_definition})
  set(${part}_objects $<TARGET_OBJECTS:${part}>)
  if(NOT ${part}_kernels)
    continue()
  endif()
  list(TRANSFORM ${part}_kernels REPLACE "(.+)" "runtime/\\1_kernel.c" OUTPUT_VARIABLE kernels)
  foreach(set ${sets})
    add_library(${part}_${set} OBJECT ${kernels})
    target_compile_definitions(${part}_${set} PRIVATE COR_SET=${set} ${cor_sets_definition})
    if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
      target_compile_options(${part}_${set} PRIVATE ${cor_array_options} ${${set}})
    endif()
    list(APPEND ${part}_objects $<TARGET_OBJECTS:${part}_${set}>)
    list(APPEND cor_parts ${part}_${set})
  endforeach()
endforeach()
