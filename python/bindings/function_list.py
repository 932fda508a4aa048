# SPDX-License-Identifier: MIT
"""Writes the list of all public functions, generated/public_functions.inc, from which tests call every function.

    python3 python/bindings/function_list.py [--check]     writes the file, or fails if the file differs
"""

import re
import sys
from pathlib import Path
from typing import List

if __package__ in (None, ""):
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bindings.calls import BY_HAND, calls, input_struct, is_elementwise  # noqa: E402
from bindings.cffi_source import scene_declarations  # noqa: E402
from bindings.declarations import ROOT, Declarations, Function, Parameter, write_or_check  # noqa: E402

MACROS = {
    "NUMBER(name)": "the name of a parameter that is a double or a float",
    "SCALAR(function, type, given)": "a number from numbers and structs",
    "ARRAY(function, given, element)": "fills y[0..n-1]; `element` gives y[i]",
    "FLOATS(function, given)": "fills y[0..n-1] in float arithmetic",
    "INIT(function, type, given)": "fills the struct at out",
    "OTHER(function)": "of another kind",
    "SCENE_FUNCTION(type, function, given)": "of scene.h",
    "SCENE_PROCEDURE(function, given)": "of scene.h, without a result",
}
HEAD = """/* SPDX-License-Identifier: MIT */
/* Every public function, written from the headers by python/bindings/function_list.py. Whoever includes this list
 * defines the macros that it needs:
 *
"""


def _argument(p: Parameter, index: str) -> str:
    """Returns the argument for a parameter: element `index` of the values drawn for all parameters of its name."""
    struct = input_struct(p)
    if struct:
        return f"&a->{struct[len('cor_'):] if p.name == 'options' else p.name}[{index}]"
    return f"a->{p.name}[{index}]"


def _is_array(function: Function) -> bool:
    last = [p.type for p in function.parameters[-2:]]
    return function.result == "void" and last in (["double *", "size_t"], ["float *", "size_t"])


def _array(function: Function) -> str:
    given, element = [], []
    for p in function.parameters[:-2]:
        suffix = "f" if "float" in p.type else ""
        pointer = p.type in ("const double *", "const float *")
        given.append(f"a->{p.name}{suffix}" if pointer else _argument(p, "0"))
        element.append(given[-1] + "[i]" * pointer)
    if function.parameters[-2].type == "float *":
        return f"FLOATS({function.name}, ({', '.join(given)}, y, n))"
    return f"ARRAY({function.name}, ({', '.join(given)}, y, n), {function.name[:-len('_array')]}({', '.join(element)}))"


def lines(declared: Declarations) -> List[str]:
    found, numbers = [], set()
    kinds = {name: call.kind for name, call in calls(declared).items()}
    for name, function in declared.functions.items():
        given = function.parameters[kinds.get(name) == "init" :]
        arguments = ", ".join(_argument(p, "i") for p in given)
        if name in BY_HAND:
            found.append(f"OTHER({name})")
            continue
        numbers |= {p.name for p in given if p.type in ("double", "const double *", "const float *")}
        if _is_array(function):
            found.append(_array(function))
        elif is_elementwise(function):
            found.append(f"SCALAR({name}, {function.result}, ({arguments}))")
        elif kinds.get(name) == "init":
            found.append(f"INIT({name}, {function.parameters[0].type.split()[1]}, (&out, {arguments}))")
        else:
            found.append(f"OTHER({name})")
    return [f"NUMBER({name})" for name in sorted(numbers)] + found


def text() -> str:
    made = HEAD + "".join(f" *     {macro:<40}{meaning}\n" for macro, meaning in MACROS.items()) + " */\n"
    made += "".join(f"#ifndef {macro.split('(')[0]}\n#define {macro}\n#endif\n" for macro in MACROS)
    made += "\n".join(lines(Declarations(ROOT / "include" / "cor")) + scene_lines()) + "\n"
    return made + "".join(f"#undef {macro.split('(')[0]}\n" for macro in MACROS)


def scene_lines() -> List[str]:
    found = []
    pattern = r"^(?!typedef|static)(\w[\w ]*?[ *]+)(cor_\w+)\(([^()]*)\);"
    for kind, name, words in re.findall(pattern, scene_declarations(ROOT / "include" / "cor"), flags=re.M):
        names = ", ".join(re.findall(r"(\w+)(?:\[\w+\])?(?:,|$)", words))
        start = "SCENE_PROCEDURE(" if kind.strip() == "void" else f"SCENE_FUNCTION({kind.strip()}, "
        found.append(f"{start}{name}, ({names}))")
    return found


if __name__ == "__main__":
    sys.exit(write_or_check(ROOT / "generated" / "public_functions.inc", text(), sys.argv[1:], __doc__))
