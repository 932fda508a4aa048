# SPDX-License-Identifier: MIT
# Completion of corgen's command lines in bash and zsh, and the man pages of corgen if help2man is installed. Both
# come from the program's help texts and tables of options, so a program for another machine has neither.
if(CMAKE_CROSSCOMPILING)
  return()
endif()
set(completions ${PROJECT_BINARY_DIR}/completions)
file(MAKE_DIRECTORY ${completions})
add_custom_command(OUTPUT ${completions}/corgen ${completions}/_corgen
  COMMAND corgen --completion bash >${completions}/corgen
  COMMAND corgen --completion zsh >${completions}/_corgen
  DEPENDS corgen)
add_custom_target(completion ALL DEPENDS ${completions}/corgen ${completions}/_corgen)
install(FILES ${completions}/corgen DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${completions}/_corgen DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)

find_program(HELP2MAN help2man)
if(HELP2MAN)
  set(pages ${PROJECT_BINARY_DIR}/man)
  add_custom_command(OUTPUT ${pages}/corgen.1
    COMMAND ${CMAKE_COMMAND} -DCORGEN=$<TARGET_FILE:corgen> -DHELP2MAN=${HELP2MAN} -DVERSION=${PROJECT_VERSION}
      -DOUTPUT=${pages} -P ${PROJECT_SOURCE_DIR}/cmake/ManPages.cmake
    DEPENDS corgen ${PROJECT_SOURCE_DIR}/cmake/ManPages.cmake
    VERBATIM)
  # in a build for tests, the test that installs the pages makes them, because they take a second for each new corgen
  if(COR_BUILD_TESTS)
    add_custom_target(man DEPENDS ${pages}/corgen.1)
  else()
    add_custom_target(man ALL DEPENDS ${pages}/corgen.1)
  endif()
  install(DIRECTORY ${pages}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
else()
  message(STATUS "man pages are left out: help2man not found")
endif()
