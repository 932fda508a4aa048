# SPDX-License-Identifier: MIT
# cmake -DRUNTIME=<runtime/> -DOUTPUT=<file.c> -P EvaluatorText.cmake
# Writes the evaluator's sources as C arrays of bytes (gen/support/emit_c.h).
set(text "#include \"support/emit_c.h\"\n")
foreach(pair number/inline:inline number/pair:pair number/elementary:elementary number/fifth_root:fifth_root table/row:row sphere/eval:sphere
        table/law:law)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 file)
  list(GET pair 1 name)
  file(READ "${RUNTIME}/${file}.h" source)
  string(REGEX REPLACE "/\\* SPDX[^\n]*\n" "" source "${source}")
  string(REGEX REPLACE "#include \"[^\n]*\n" "" source "${source}")
  string(HEX "${source}" bytes)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(APPEND text "const char evaluator_${name}[] = {${bytes}0};\n")
endforeach()
file(WRITE "${OUTPUT}" "${text}")
