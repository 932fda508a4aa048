# SPDX-License-Identifier: MIT
"""How each public function can be called from another language, judged by its declaration alone."""

import re
from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from .declarations import Declarations, Function, Parameter, Struct


# The table of law.h, which each binding has by hand, and its names in Python
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
    """A function in all of its forms, and how it is called.

    kind is one of
        elementwise  a number from numbers, and from structs that are the same for all elements
        record       a status and a struct of results, likewise
        init         a status and a struct that other functions take
        other        anything else; it needs a wrapper written by hand
    """

    kind: str
    function: Function
    array: Optional[Function] = None

    @property
    def structs(self) -> List[Parameter]:
        return [p for p in self.function.parameters if is_input(p)]

    @property
    def values(self) -> List[Parameter]:
        return [p for p in self.function.parameters if is_value(p)]

    @property
    def out(self) -> str:
        """The name of the struct of results of a record or an init."""
        return next(name for name in map(output_struct, self.function.parameters) if name)

    @property
    def loop(self) -> str:
        return "cor_loop_" + self.function.name[len("cor_") :]


def is_value(p: Parameter) -> bool:
    return p.type in ("double", "float", "int", "size_t") or p.type.startswith("enum ") and "*" not in p.type


def input_struct(p: Parameter) -> str:
    found = re.fullmatch(r"const struct (cor_\w+) \*", p.type)
    return found[1] if found else ""


def is_input(p: Parameter) -> bool:
    return bool(input_struct(p))


def output_struct(p: Parameter) -> str:
    found = re.fullmatch(r"struct (cor_\w+) \*", p.type)
    return found[1] if found else ""


def form_of(functions: Dict[str, Function], name: str) -> str:
    """The function through which one is reached: itself, or the one whose loop over arrays it is."""
    base = re.sub("(_fast)?(f|_arrayf?)$", "", name)
    return base if base in functions and is_elementwise(functions[base]) else name


def calls(declared: Declarations) -> Dict[str, Call]:
    """Every public function but those of BY_HAND and the loops of others over arrays, by name."""
    functions = declared.functions
    taken = {input_struct(p) for f in functions.values() for p in f.parameters if is_input(p)}
    found = {}
    for name, function in functions.items():
        if name not in BY_HAND and form_of(functions, name) == name:
            kind = _kind(function, taken)
            array = functions.get(name + "_array") if kind == "elementwise" else None
            found[name] = Call(kind, function, array)
    return found


def is_elementwise(function: Function) -> bool:
    return function.result in ("double", "size_t") and all(is_value(p) or is_input(p) for p in function.parameters)


def _kind(function: Function, taken: "set[str]") -> str:
    if is_elementwise(function):
        return "elementwise"
    out = [output_struct(p) for p in function.parameters if output_struct(p)]
    others = [p for p in function.parameters if not output_struct(p)]
    if function.result != "int" or len(out) != 1 or not all(is_value(p) or is_input(p) for p in others):
        return "other"
    return "init" if out[0] in taken else "record"


def is_plain(struct: Struct) -> bool:
    """Whether all fields are numbers."""
    return all(is_value(field) for field in struct.fields)


def argument_names(function: Function) -> List[str]:
    """The names of the parameters; for one that a macro calls x, the name that the comment gives to it."""
    return [_documented_name(function) if p.name == "x" else p.name for p in function.parameters]


def _documented_name(function: Function) -> str:
    described = re.findall(r"(cor_[\w<>]+)\(double (\w+)\)", function.doc)
    for pattern, name in described:
        if re.fullmatch(pattern.replace("<end>", r"\w+?"), function.name):
            return str(name)
    names = {name for _, name in described}
    return str(names.pop()) if len(names) == 1 else "x"
