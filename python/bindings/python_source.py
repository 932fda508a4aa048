# SPDX-License-Identifier: MIT
"""The Python modules of the package, one for each header: functions, classes, enums and constants with type hints, and
with the comments of the headers as their docstrings."""

import os
import re
from typing import Dict, List

from .calls import BY_HAND, Call, argument_names, calls, input_struct, is_input, is_plain, is_value, output_struct
from .cffi_source import constant_type, has_float, kind_of
from .declarations import Declarations, Enum, Parameter, Struct

HEAD = '''# SPDX-License-Identifier: MIT
# Written by python/bindings from the headers of cor.
"""{summary}"""

# flake8: noqa
from __future__ import annotations

from enum import IntEnum
from typing import Any, Final, Optional

from numpy.typing import ArrayLike

from ._cor import lib
from ._evaluate import Array, Elementwise, Init, Record, Struct, pointer, string
'''

NAMED = ("cor_law", "cor_end", "cor_quantity")  # enums of which Python has the names

# "double cor_f(double x), cor_g(double y): " in a comment, or the first of these alone
PROTOTYPE = re.compile(r"\bdouble cor_([\w<>]+)\([^)]*\)((?:,\s+\w+(?:\([^)]*\))?)*:\s+)?")

DIR = """

def __dir__() -> "list[str]":
    return __all__
"""


def modules(declared: Declarations) -> Dict[str, str]:
    """The text of each module, by name."""
    names = dict.fromkeys(declared.module(header) for header in declared._module)
    return {name: _Module(declared, name).text() for name in names}


def class_name(declared: Declarations, struct: str) -> str:
    words = declared.short_name(struct, declared.structs[struct].header).split("_")
    name = "".join(word.capitalize() for word in words)
    return "DiskModes" if struct == "cor_disk_modes" else name


class _Module:
    def __init__(self, declared: Declarations, name: str) -> None:
        self.declared = declared
        self.name = name
        self.headers = [h for h in declared._module if declared.module(h) == name]
        self.calls = {n: c for n, c in calls(declared).items() if c.function.header in self.headers}
        self.public: List[str] = []

    def short(self, name: str) -> str:
        short = self.declared.short_name(name, self.headers[0])
        if short in self.public:
            raise SyntaxError(f"two names {short} in module {self.name}")
        self.public.append(short)
        return short

    def text(self) -> str:
        parts = [self._constants()]
        parts += [
            self._enum(e) for e in self.declared.enums.values() if e.header in self.headers and e.name not in NAMED
        ]
        parts.append(self._written_by_hand())
        parts += [self._struct(s) for s in self.declared.structs.values() if self._has_class(s)]
        parts += [self._function(c) for c in self.calls.values() if c.kind != "other"]
        summary = " and ".join(f"cor/{header}" for header in self.headers)
        names = "".join(f'    "{name}",\n' for name in sorted(self.public))
        head = HEAD.format(summary=f"The declarations of {summary}.")
        return head + "\n" + "\n\n".join(p for p in parts if p) + f"\n\n__all__ = [\n{names}]\n" + DIR

    def _has_class(self, struct: Struct) -> bool:
        taken = {input_struct(p) for c in calls(self.declared).values() for p in c.function.parameters}
        return struct.header in self.headers and is_plain(struct) and struct.name in taken

    def _constants(self) -> str:
        text = ""
        for constant in self.declared.constants.values():
            if constant.header not in self.headers:
                continue
            name = self.short(constant.name)
            if constant.parameters:
                text += self._macro(name, constant.name, constant.parameters, constant.doc)
            else:
                kind = constant_type(constant)
                value = f"string(lib.{constant.name})" if kind == "str" else f"lib.{constant.name}"
                text += f"{name}: Final[{kind}] = {value}\n"
        for made in self.declared.objects.values():
            if made.header in self.headers:
                self.short(made.name)
        return text

    def _macro(self, name: str, macro: str, parameters: "tuple[str, ...]", doc: str) -> str:
        kinds, given = "d" * len(parameters), " ".join(parameters)
        signature = "".join(f"{p}: ArrayLike, " for p in parameters)
        text = f'_{name} = Elementwise("{macro}", "{kinds}", "d", False, "{given}")\n\n\n'
        text += f"def {name}({signature}*, out: Optional[Array] = None) -> Any:\n{_docstring(doc, 4)}"
        return text + f"    return _{name}((), ({', '.join(parameters)},), out)\n\n\n"

    def _enum(self, enum: Enum) -> str:
        prefix = os.path.commonprefix([name for name, _, _ in enum.members])
        prefix = prefix[: prefix.rindex("_") + 1]
        name = class_name_of_enum(self.declared, enum)
        self.public.append(name)
        text = f"class {name}(IntEnum):\n{_docstring(enum.doc, 4)}\n"
        for member, value, comment in enum.members:
            text += "".join(f"    # {line}\n" for line in comment.split("\n") if line)
            text += f"    {member[len(prefix):]} = {value}\n"
        return text + "\n"

    def _written_by_hand(self) -> str:
        """Names that a module of the same name with _ before it has to have: an ImportError says which it lacks."""
        names = [self.short(c.function.name) for c in self.calls.values() if c.kind == "other"]
        if self.name == "law":
            names += sorted(set(BY_HAND.values()))
            self.public += names
        made = [o for o in self.declared.objects.values() if o.header in self.headers]
        names += [self.declared.short_name(o.name, o.header) for o in made]
        if self.name == "disk":
            extra = ["CollisionDetail", "DiskModes", "HardWallDetail"]
            self.public += extra
            names += extra
        listed = "".join(f"    {name},\n" for name in sorted(names))
        return f"from ._{self.name} import (\n{listed})\n\n" if names else ""

    def _struct(self, struct: Struct) -> str:
        name = class_name(self.declared, struct.name)
        self.public.append(name)
        inits = [c for c in self.calls.values() if c.kind == "init" and c.out == struct.name]
        doc = struct.doc
        text = f"class {name}(Struct):\n{_docstring(doc, 4)}\n"
        text += f'    _struct = "{struct.name}"\n    _fields = {tuple(f.name for f in struct.fields)!r}\n\n'
        text += self._constructors(struct, inits)
        for field in struct.fields:
            kind = "float" if field.type == "double" else "int"
            text += f"    @property\n    def {field.name}(self) -> {kind}:\n{_docstring(field.doc, 8)}"
            text += f"        return {kind}(self._c.{field.name})\n\n"
        for call in self.calls.values():
            if call.kind == "elementwise" and call.structs and call.function.parameters[0] in call.structs[:1]:
                if input_struct(call.structs[0]) == struct.name:
                    text += self._method(call)
        return text.rstrip() + "\n"

    def _constructors(self, struct: Struct, inits: List[Call]) -> str:
        if not inits:
            signature, names = [], []
            for field in struct.fields:
                kind = "float" if field.type == "double" else "int = 0"
                signature.append(f"{field.name}: {kind}")
                names.append(field.name)
            text = f"    def __init__(self, {', '.join(signature)}) -> None:\n"
            return text + f"        super().__init__({', '.join(names)})\n\n"
        text = ""
        for call in inits:
            name = call.function.name
            arguments = [p.name for p in call.function.parameters if not output_struct(p)]
            signature = ", ".join(self._typed(p) for p in call.function.parameters if not output_struct(p))
            made = f"_{self.declared.short_name(name, call.function.header)}"
            if name == struct.name + "_init":
                text += f"    def __init__(self, {signature}) -> None:\n{_docstring(call.function.doc, 8)}"
                text += f"        self._c = {made}({self._split(call, arguments)})\n\n"
            else:
                way = name.replace(struct.name + "_init_", "").replace("_contact_init", "").replace("cor_", "")
                text += f'    @classmethod\n    def from_{way}(cls, {signature}) -> "{class_name(self.declared, struct.name)}":\n'
                text += _docstring(call.function.doc, 8)
                text += f"        return cls._of({made}({self._split(call, arguments)}))\n\n"
        return text

    def _typed(self, p: Parameter) -> str:
        kind = f'"{class_name(self.declared, input_struct(p))}"' if is_input(p) else "ArrayLike"
        return f"{p.name}: {kind}"

    def _split(self, call: Call, names: List[str]) -> str:
        """The arguments of a loop: addresses of structs, then numbers."""
        parameters = [p for p in call.function.parameters if not output_struct(p)]
        pairs = list(zip(parameters, names))
        structs = "".join(
            "self._c, " if n == "self" else f'pointer({n}, "{input_struct(p)}", "{n}"), '
            for p, n in pairs
            if is_input(p)
        )
        values = "".join(f"{n}, " for p, n in pairs if is_value(p))
        return f"({structs.strip()}), ({values.strip()})"

    def _method(self, call: Call) -> str:
        short = self.declared.short_name(call.function.name, call.function.header)
        others = call.function.parameters[1:]
        signature = "".join(f", {self._typed(p)}" for p in others)
        text = f"    def {short}(self{signature}, *, out: Optional[Array] = None) -> Any:\n"
        text += _docstring(call.function.doc, 8)
        arguments = ["self"] + [p.name for p in others]
        return text + f"        return _{short}({self._split(call, arguments)}, out)\n\n"

    def _function(self, call: Call) -> str:
        function = call.function
        short = self.short(function.name)
        names = [n for n, p in zip(argument_names(function), function.parameters) if not output_struct(p)]
        parameters = [p for p in function.parameters if not output_struct(p)]
        typed = [self._typed(p).replace(p.name, n, 1) for p, n in zip(parameters, names)]
        kinds = "".join(kind_of(p) for p in call.values)
        given = " ".join(n for n, p in zip(names, parameters) if is_value(p))
        text = ""
        if call.kind == "elementwise":
            result = "d" if function.result == "double" else "n"
            text += (
                f'_{short} = Elementwise("{function.name}", "{kinds}", "{result}", {has_float(call)}, "{given}")\n\n\n'
            )
            typed += ["*", "out: Optional[Array] = None"]
            if any(p.name == "x" for p in parameters):
                typed.insert(1, "/")
            returned, last = "Any", ", out"
        else:
            made = "Record" if call.kind == "record" else "Init"
            text += f'_{short} = {made}("{function.name}", "{call.out}", "{kinds}", "{given}")\n\n\n'
            returned = "Any" if call.kind == "record" else f'"{class_name(self.declared, call.out)}"'
            last = ""
        body = f"_{short}({self._split(call, names)}{last})"
        if call.kind == "init":
            body = f"{class_name(self.declared, call.out)}._of({body})"
        doc = self._without_prototypes(function.doc) + self._forms(call)
        text += f"def {short}({', '.join(typed)}) -> {returned}:\n{_docstring(doc, 4)}"
        return text + f"    return {body}\n"

    def _without_prototypes(self, doc: str) -> str:
        """help() has the Python signature: a comment begins with what it says, or, of several functions, their names."""
        doc = re.sub("^---- (.*) ----\n", r"\1.\n", doc)
        found = list(PROTOTYPE.finditer(doc))
        if len(found) == 1 and found[0].start() == 0 and found[0][2]:
            return doc[found[0].end()].upper() + doc[found[0].end() + 1 :]
        return PROTOTYPE.sub(lambda f: re.sub(f"^{self.name}_", "", f[1]) + (": " if f[2] else ""), doc)

    def _forms(self, call: Call) -> str:
        forms = [f.name for f in (call.function, call.array) if f]
        return f"\n\nC: {', '.join(forms)}"


def class_name_of_enum(declared: Declarations, enum: Enum) -> str:
    short = enum.name if enum.name == "cor_status" else declared.short_name(enum.name, enum.header)
    return "".join(word.capitalize() for word in re.sub("^cor_", "", short).split("_"))


def _docstring(text: str, indent: int) -> str:
    if not text:
        return ""
    text = text.replace("\\", "\\\\").replace('"""', "'''")
    lines = [(" " * indent + line).rstrip() for line in ('"""' + text).split("\n")]
    end = '"""\n' if len(lines) == 1 else "\n" + " " * indent + '"""\n'
    return "\n".join(lines) + end


def docs(declared: Declarations) -> str:
    """The module _docs: the comments of the functions whose wrappers are written by hand."""
    text = '# SPDX-License-Identifier: MIT\n# Written by python/bindings from the headers of cor.\n"""Comments of the headers."""\n\n'
    text += "DOCS = {\n"
    for name, call in calls(declared).items():
        if call.kind == "other":
            text += f"    {name!r}: {call.function.doc!r},\n"
    return text + "}\n"
