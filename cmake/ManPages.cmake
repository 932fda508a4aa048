# SPDX-License-Identifier: MIT
# cmake -DCORGEN=<program> -DHELP2MAN=<program> -DVERSION=<version> -DOUTPUT=<dir> -P ManPages.cmake
# Writes corgen.1 and corgen-SUBCOMMAND.1 from the help texts of corgen. The pages have no date.
# With -DCOR=<program> -DCORGEN= it writes cor.1, cor-audit.1 and cor-fit.1 of the Python package instead.
get_filename_component(folder "${CORGEN}${COR}" DIRECTORY)
get_filename_component(program "${CORGEN}${COR}" NAME)
set(subcommands)
if(CORGEN)
  execute_process(COMMAND "${CORGEN}" --completion zsh OUTPUT_VARIABLE completion RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${CORGEN} --completion zsh failed: ${status}")
  endif()
  string(REPLACE ";" "," completion "${completion}") # the separator of a list
  string(REGEX MATCHALL "\n    '[a-z-]+:[^\n]*'" subcommands "${completion}")
endif()

# man_page(NAME WORDS SUMMARY SEE): the page NAME.1 of the command WORDS
function(man_page name words summary see)
  set(page "${OUTPUT}/${name}.1")
  file(WRITE "${page}.also" "[SEE ALSO]\n${see}\n")
  execute_process(COMMAND "${HELP2MAN}" --no-info --no-discard-stderr "--version-string=${name} ${VERSION}"
      "--name=${summary}" "--include=${page}.also" "${words}"
    WORKING_DIRECTORY "${folder}" OUTPUT_VARIABLE text RESULT_VARIABLE status)
  file(REMOVE "${page}.also")
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "help2man ${words} failed: ${status}")
  endif()
  # no date, no hyphens within commands, and line breaks after the commas of lists of columns
  string(REGEX REPLACE "(\\.TH [^ ]+ \"1\") \"[^\"]*\"([^\n]*\n)" "\\1 \"\"\\2.nh\n.ad l\n" text "${text}")
  string(REGEX REPLACE ",([a-z])" ",\\\\:\\1" text "${text}")
  file(WRITE "${page}" "${text}")
endfunction()

file(REMOVE_RECURSE "${OUTPUT}")
set(see)
foreach(line IN LISTS subcommands)
  string(REGEX REPLACE "\n    '([a-z-]+):(.*)'" "\\1;\\2" line "${line}")
  list(GET line 0 name)
  list(GET line 1 summary)
  man_page(corgen-${name} "./${program} ${name}" "${summary}" ".BR corgen (1)")
  list(APPEND see ".BR corgen-${name} (1)")
endforeach()
list(JOIN see ",\n" see)
if(COR)
  execute_process(COMMAND "${COR}" audit --help RESULT_VARIABLE status OUTPUT_QUIET)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${COR} audit --help failed: ${status}")
  endif()
  man_page(cor-audit "./${program} audit" "the restitution that the input of a simulator realises" ".BR cor (1)")
  man_page(cor-fit "./${program} fit" "models of measured bounces" ".BR cor (1)")
  man_page(cor "./${program}" "restitution in decks of simulators and in measurements"
    ".BR cor-audit (1),\n.BR cor-fit (1),\n.BR corgen (1)")
  return()
endif()
man_page(corgen "./${program}" "restitution of colliding bodies for simulations" "${see}")
