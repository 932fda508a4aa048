# SPDX-License-Identifier: MIT
"""Generates the package's Python modules, one for each header: functions, classes, enums and constants with type hints.
Their docstrings are the comments of the headers."""

import os
import re
from typing import Dict, List

from .calls import BY_HAND, Call, calls, input_struct, is_plain, output_struct
from .cffi_source import constant_type
from .declarations import Declarations, Enum, Parameter, Struct

NAMED = ("cor_law", "cor_end", "cor_quantity")  # enums whose names Python uses
BESIDE = {"disk": ["CollisionDetail", "DiskModes", "HardWallDetail"], "law": sorted(set(BY_HAND.values()))}
HEAD = '''# SPDX-License-Identifier: MIT
# Written by python/bindings from the headers of cor.
"""The declarations of {headers}."""

# flake8: noqa
from __future__ import annotations

from enum import IntEnum
from typing import Any, Final, Optional

from numpy.typing import ArrayLike

from ._cor import lib
from ._evaluate import Array, Elementwise, Init, Record, Struct, string
'''
TAIL = """
__all__ = {names!r}


def __dir__() -> "list[str]":
    return __all__
"""
# Matches "double cor_f(double x), cor_g(double y): " in a comment, or "double cor_f(double x)" without a colon
PROTOTYPE = re.compile(r"\bdouble cor_([\w<>]+)\([^)]*\)((?:,\s+\w+(?:\([^)]*\))?)*:\s+)?")


def modules(declared: Declarations) -> Dict[str, str]:
    """Returns the text of each module, by name."""
    names = dict.fromkeys(declared.modules.values())
    return {name: _Module(declared, name).text() for name in names}


class _Module:
    def __init__(self, declared: Declarations, name: str) -> None:
        self.declared = declared
        self.name = name
        self.headers = [h for h, module in declared.modules.items() if module == name]
        self.calls = [c for c in calls(declared).values() if c.function.header in self.headers]
        self.public: List[str] = []

    def text(self) -> str:
        declared, here = self.declared, self.headers
        constants = [c for c in declared.constants.values() if c.header in here]
        parts = ["".join(self._constant(c.name, constant_type(c)) for c in constants)]
        parts += [self._enum(e) for e in declared.enums.values() if e.header in here and e.name not in NAMED]
        parts.append(self._written_by_hand())
        parts += [self._struct(s) for s in declared.structs.values() if s.header in here and self._has_class(s)]
        parts += [self._function(c) for c in self.calls if c.kind != "other"]
        head = HEAD.format(headers=" and ".join(f"cor/{header}" for header in here))
        return "\n\n".join([head, *(p for p in parts if p), TAIL.format(names=sorted(self.public))])

    def short(self, name: str) -> str:
        short = self.declared.short_name(name, self.headers[0])
        if short in self.public:
            raise SyntaxError(f"two names {short} in module {self.name}")
        self.public.append(short)
        return short

    def class_name(self, name: str) -> str:
        words = name if name == "cor_status" else self.declared.short_name(name, self.headers[0])
        return "".join(word.capitalize() for word in re.sub("^cor_", "", words).split("_"))

    def _has_class(self, struct: Struct) -> bool:
        taken = {input_struct(p) for c in calls(self.declared).values() for p in c.function.parameters}
        return is_plain(struct) and struct.name in taken

    def _constant(self, name: str, kind: str) -> str:
        return f"{self.short(name)}: Final[{kind}] = " + (f"string(lib.{name})\n" if kind == "str" else f"lib.{name}\n")

    def _enum(self, enum: Enum) -> str:
        prefix = os.path.commonprefix([name for name, _, _ in enum.members])
        prefix = prefix[: prefix.rindex("_") + 1]
        name = self.class_name(enum.name)
        self.public.append(name)
        text = f"class {name}(IntEnum):\n{_docstring(enum.doc)}\n"
        for member, value, comment in enum.members:
            text += "".join(f"    # {line}\n" for line in comment.split("\n") if line)
            text += f"    {member[len(prefix):]} = {value}\n"
        return text

    def _written_by_hand(self) -> str:
        """Returns an import of the names that the module _NAME must define, so that an ImportError names a missing
        one."""
        names = [self.short(c.function.name) for c in self.calls if c.kind == "other"]
        names += [self.short(o.name) for o in self.declared.objects.values() if o.header in self.headers]
        names += BESIDE.get(self.name, [])
        self.public += BESIDE.get(self.name, [])
        listed = "".join(f"    {name},\n" for name in sorted(names))
        return f"from ._{self.name} import (\n{listed})\n" if names else ""

    def _struct(self, struct: Struct) -> str:
        name = self.class_name(struct.name)
        self.public.append(name)
        kinds = [("float", "") if field.type == "double" else ("int", " = 0") for field in struct.fields]
        signature = "".join(f", {f.name}: {kind}{usual}" for f, (kind, usual) in zip(struct.fields, kinds))
        names = [field.name for field in struct.fields]
        doc = struct.doc + "\n\n" + "\n".join(f"{f.name}: {' '.join(f.doc.split())}" for f in struct.fields if f.doc)
        text = f"class {name}(Struct):\n{_docstring(doc.strip())}\n"
        text += f'    _struct = "{struct.name}"\n    _fields = {tuple(names)!r}\n    __slots__ = ()\n\n'
        text += "".join(f"    {f.name}: {kind}\n" for f, (kind, _) in zip(struct.fields, kinds))
        return text + f"\n    def __init__(self{signature}) -> None:\n        super().__init__({', '.join(names)})\n"

    def _typed(self, p: Parameter) -> str:
        if not input_struct(p):
            return f"{p.name}: ArrayLike"
        return f"{p.name}: {'DiskModes' if 'cor_disk_modes' in p.type else self.class_name(input_struct(p))}"

    def _function(self, call: Call) -> str:
        function = call.function
        short = self.short(function.name)
        given = [p for p in function.parameters if not output_struct(p)]
        names = [p.name for p in given]
        made = f'_{short} = {call.kind.capitalize()}("{function.name}", "{" ".join(names)}")\n\n\n'
        typed = [self._typed(p) for p in given]
        body, returned = f"_{short}(({', '.join(names)},)", "Any"
        if call.kind == "elementwise":
            typed += ["*", "out: Optional[Array] = None"]
            body += ", out"
        elif call.kind == "init":
            returned = self.class_name(output_struct(function.parameters[0]))
            body = f"{returned}._of({body})"
        forms = ", ".join(f.name for f in (function, call.array) if f)
        doc = f"{self._without_prototypes(function.doc)}\n\nC: {forms}"
        return f"{made}def {short}({', '.join(typed)}) -> {returned}:\n{_docstring(doc)}    return {body})\n"

    def _without_prototypes(self, doc: str) -> str:
        """Removes C prototypes, because help() has the signature. A comment on several functions keeps their names."""
        doc = re.sub("^---- (.*) ----\n", r"\1.\n", doc)
        found = list(PROTOTYPE.finditer(doc))
        if len(found) == 1 and found[0].start() == 0 and found[0][2]:
            return doc[found[0].end()].upper() + doc[found[0].end() + 1 :]
        return PROTOTYPE.sub(lambda f: re.sub(f"^{self.name}_", "", f[1]) + (": " if f[2] else ""), doc)


def _docstring(text: str) -> str:
    if not text:
        return ""
    text = text.replace("\\", "\\\\").replace('"""', "'''")
    lines = [("    " + line).rstrip() for line in ('"""' + text).split("\n")]
    return "\n".join(lines) + ('"""\n' if len(lines) == 1 else '\n    """\n')


def docs(declared: Declarations) -> str:
    """Returns the module _docs: the comments of functions with wrappers written by hand."""
    text = "# SPDX-License-Identifier: MIT\n# Written by python/bindings from the headers of cor.\n"
    text += '"""Comments of the headers."""\n\n'
    text += "DOCS = {\n"
    for name, call in calls(declared).items():
        if call.kind == "other":
            text += f"    {name!r}: {call.function.doc!r},\n"
    return text + "}\n"
