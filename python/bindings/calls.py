# SPDX-License-Identifier: MIT
"""Determines from its declaration how each public function can be called from another language."""

import re
from dataclasses import dataclass
from typing import Dict, List, Optional

from .declarations import Declarations, Function, Parameter, Struct

# The functions of law.h for which each binding has code written by hand, and their names in Python
BY_HAND = {
    "cor_law_function": "function",
    "cor_law_value": "value",
    "cor_law_array": "value",
    "cor_law_arrayf": "value",
    "cor_law_name": "laws",
    "cor_end_name": "ends",
    "cor_quantity_name": "quantities",
}


@dataclass(frozen=True)
class Call:
    """A function, its loop over an array, and the kind of call.

    kind is one of
        elementwise  returns a number; arguments are numbers, and structs that are the same for all elements
        record       returns a status and a struct of results; the same kinds of arguments
        init         returns a status and a struct that other functions accept
        other        any other function; it needs a wrapper written by hand
    """

    kind: str
    function: Function
    array: Optional[Function] = None

    @property
    def structs(self) -> List[Parameter]:
        return [p for p in self.function.parameters if input_struct(p)]

    @property
    def values(self) -> List[Parameter]:
        return [p for p in self.function.parameters if is_value(p)]

    @property
    def loop(self) -> str:
        return "cor_loop_" + self.function.name[len("cor_") :]


def is_value(p: Parameter) -> bool:
    return p.type in ("double", "int", "size_t") or p.type.startswith("enum ") and "*" not in p.type


def input_struct(p: Parameter) -> str:
    found = re.fullmatch(r"const struct (cor_\w+) \*", p.type)
    return found[1] if found else ""


def output_struct(p: Parameter) -> str:
    found = re.fullmatch(r"struct (cor_\w+) \*", p.type)
    return found[1] if found else ""


def form_of(functions: Dict[str, Function], name: str) -> str:
    """Returns the name of the function to call: this one or, for an array loop, its scalar function."""
    base = re.sub("_arrayf?$", "", name)
    return base if base in functions and is_elementwise(functions[base]) else name


def calls(declared: Declarations) -> Dict[str, Call]:
    """Returns every public function by name, except those in BY_HAND and array loops of other functions."""
    functions = declared.functions
    taken = {input_struct(p) for f in functions.values() for p in f.parameters}
    found = {}
    for name, function in functions.items():
        if name not in BY_HAND and form_of(functions, name) == name:
            kind = _kind(function, taken)
            found[name] = Call(kind, function, functions.get(name + "_array") if kind == "elementwise" else None)
    return found


def is_elementwise(function: Function) -> bool:
    return function.result in ("double", "size_t") and all(is_value(p) or input_struct(p) for p in function.parameters)


def _kind(function: Function, taken: "set[str]") -> str:
    if is_elementwise(function):
        return "elementwise"
    out = [output_struct(p) for p in function.parameters if output_struct(p)]
    others = [p for p in function.parameters if not output_struct(p)]
    if function.result != "int" or len(out) != 1 or not all(is_value(p) or input_struct(p) for p in others):
        return "other"
    return "init" if out[0] in taken else "record"


def is_plain(struct: Struct) -> bool:
    """True if all fields are numbers."""
    return all(is_value(field) for field in struct.fields)
