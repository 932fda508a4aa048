# SPDX-License-Identifier: MIT
# corgen, and corgen_core, which has everything except main.c so that tests can link it.

set(COR_HAVE_GENERATOR FALSE)
if(NOT COR_BUILD_GENERATOR MATCHES "^(AUTO|auto|OFF|off|FALSE|0|NO)$")
  find_package(FLINT)
  if(NOT FLINT_FOUND)
    message(FATAL_ERROR "COR_BUILD_GENERATOR=${COR_BUILD_GENERATOR}, but corgen needs GMP, MPFR and FLINT (2.9 or later), "
      "with FLINT 2 Arb, too. Not found: ${FLINT_MISSING}. "
      "On Debian: apt-get install libgmp-dev libmpfr-dev libflint-dev libflint-arb-dev")
  endif()
elseif(COR_BUILD_GENERATOR MATCHES "^(AUTO|auto)$")
  find_package(FLINT QUIET)
  if(NOT FLINT_FOUND)
    message(STATUS "corgen is left out: ${FLINT_MISSING} not found")
  endif()
endif()

if(FLINT_FOUND)
  set(COR_HAVE_GENERATOR TRUE)
  file(STRINGS "${FLINT_INCLUDE_DIR}/flint/flint.h" flint_version REGEX "define FLINT_VERSION ")
  string(REGEX MATCH "[0-9.]+" flint_version "${flint_version}")
  message(STATUS "corgen will be built (FLINT ${flint_version})")
  set(tables ${cor_with_tables_objects} ${cor_disk_with_tables_objects} $<TARGET_OBJECTS:cor_scene_with_tables>)
  file(GLOB COR_GENERATOR_SOURCES RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/gen/*/*.c)
  list(REMOVE_ITEM COR_GENERATOR_SOURCES gen/cli/main.c)
  if(COR_BOOTSTRAP) # omits sources that call functions with tables
    set(tables)
    list(FILTER COR_GENERATOR_SOURCES EXCLUDE REGEX "^gen/(contact|embed|plan|cli/(contact|embed|plan|sample)\\.c)")
  endif()
  list(TRANSFORM COR_GENERATOR_SOURCES PREPEND "${PROJECT_SOURCE_DIR}/")
  # the generated headers embed the runtime's evaluator
  set(evaluator ${PROJECT_BINARY_DIR}/evaluator_text.c)
  add_custom_command(OUTPUT ${evaluator}
    COMMAND ${CMAKE_COMMAND} -DRUNTIME=${PROJECT_SOURCE_DIR}/runtime -DOUTPUT=${evaluator}
      -P ${PROJECT_SOURCE_DIR}/cmake/EvaluatorText.cmake
    DEPENDS ${PROJECT_SOURCE_DIR}/cmake/EvaluatorText.cmake ${PROJECT_SOURCE_DIR}/runtime/number/inline.h
      ${PROJECT_SOURCE_DIR}/runtime/number/pair.h ${PROJECT_SOURCE_DIR}/runtime/number/fifth_root.h
      ${PROJECT_SOURCE_DIR}/runtime/table/row.h ${PROJECT_SOURCE_DIR}/runtime/table/law.h
      ${PROJECT_SOURCE_DIR}/runtime/sphere/eval.h
    VERBATIM)
  set(THREADS_PREFER_PTHREAD_FLAG ON)
  find_package(Threads REQUIRED)
  add_library(corgen_core STATIC ${COR_GENERATOR_SOURCES} ${evaluator}
    ${tables} $<TARGET_OBJECTS:cor_scene_without_tables> ${cor_without_tables_objects} ${cor_disk_without_tables_objects})
  target_include_directories(corgen_core PUBLIC ${PROJECT_SOURCE_DIR}/gen ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(corgen_core PUBLIC _POSIX_C_SOURCE=200809L $<$<BOOL:${COR_BOOTSTRAP}>:COR_BOOTSTRAP>)
  target_link_libraries(corgen_core PUBLIC FLINT::FLINT m Threads::Threads PRIVATE cor_defaults)
  # corgen spends most of its time in FLINT; -O2 for its own code takes longer to compile and gains little
  target_compile_options(corgen_core PRIVATE $<$<AND:$<CONFIG:Release>,$<C_COMPILER_ID:GNU,Clang,AppleClang>>:-O1>)
  # -O2 only for complex_*.c, which computes in doubles, and formula.c, which each node of an integral calls
  file(GLOB of_corgen CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/gen/enclosure/complex_*.c)
  set_source_files_properties(${of_corgen} ${PROJECT_SOURCE_DIR}/gen/support/formula.c PROPERTIES
    COMPILE_OPTIONS $<$<AND:$<CONFIG:Release>,$<C_COMPILER_ID:GNU,Clang,AppleClang>>:-O2>)
  # FLINT's headers take half the time of a compilation, so gcc precompiles them, except for sources with other options
  # or with feature macros such as _GNU_SOURCE. With clang nothing is precompiled, because tools read the compile
  # commands before a build has made the precompiled header.
  if(CMAKE_C_COMPILER_ID STREQUAL GNU)
    target_precompile_headers(corgen_core PRIVATE ${PROJECT_SOURCE_DIR}/gen/support/flint.h)
    set(other support/console.c support/formula.c support/output.c support/parallel.c tables/directory.c)
    list(TRANSFORM other PREPEND ${PROJECT_SOURCE_DIR}/gen/)
    set_source_files_properties(${of_corgen} ${other} ${evaluator} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
  set_target_properties(corgen_core PROPERTIES C_STANDARD 11)

  add_executable(corgen ${PROJECT_SOURCE_DIR}/gen/cli/main.c)
  target_compile_definitions(corgen PRIVATE COR_VERSION="${PROJECT_VERSION}")
  target_link_libraries(corgen PRIVATE corgen_core cor_defaults)
  set_target_properties(corgen PROPERTIES C_STANDARD 11)
endif()
