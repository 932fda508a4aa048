# SPDX-License-Identifier: MIT
"""Reads the declarations of cor's public headers, with the comment that documents each.

The parser reads the subset of C in which the headers are written: comments, #define, #include "...", structs, enums,
and functions and objects marked COR_API. It stops with SyntaxError at any other text, so that no declaration is
skipped in silence.
"""

import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List, Tuple

NOT_READ = ("export.h",)  # defines only COR_API
ROOT = Path(__file__).resolve().parents[2]


def write_or_check(path: Path, text: str, arguments: List[str], usage: str) -> int:
    """Writes a generated file, or with --check fails if it differs. Returns the exit status."""
    if arguments not in ([], ["--check"]):
        print(usage, file=sys.stderr)
        return 2
    if not arguments:
        path.write_text(text, encoding="utf-8")
    elif path.read_text(encoding="utf-8") != text:
        print(f"{path.relative_to(ROOT)} is not what the headers give: run python3 {sys.argv[0]}")
        return 1
    return 0


@dataclass(frozen=True)
class Parameter:
    """A parameter, a field or a result. type is the C type without the name, pointers included."""

    type: str
    name: str
    doc: str = ""


@dataclass(frozen=True)
class Function:
    name: str
    result: str
    parameters: Tuple[Parameter, ...]
    header: str
    doc: str


@dataclass(frozen=True)
class Struct:
    name: str
    fields: Tuple[Parameter, ...]
    header: str
    doc: str


@dataclass(frozen=True)
class Enum:
    name: str
    members: Tuple[Tuple[str, int, str], ...]  # name, value, comment
    header: str
    doc: str


@dataclass(frozen=True)
class Constant:
    """A macro with a value."""

    name: str
    text: str
    header: str


@dataclass(frozen=True)
class Object:
    name: str
    type: str
    header: str


_COMMENT = re.compile(r"/\*.*?\*/", re.S)
_TEXT = re.compile(
    r"""\s*(?:(?P<comment>/\*.*?\*/)
    |\#(?:ifdef[ ]__cplusplus|if[ ]defined\(__cplusplus\))[^\n]*\n(?:[^\#]|\#if.*?\#endif|\#(?!endif))*\#endif
    |\#\s*include\s*"(?P<include>[^"]+)"[^\n]*
    |\#\s*define\s+(?P<define>\w+)[ \t]+(?P<value>(?:\\\n|/\*.*?\*/|[^\n])+)
    |\#\s*define\s+\w+(?:\\\n|[^\n])*
    |\#\s*(?:ifndef\s+COR_\w+_H|ifdef\s+COR_WITH_DISK|endif|include\s*<\w+\.h>)[^\n]*
    |COR_API\s+extern\s+(?P<object>[^;()]*?)(?P<object_name>cor_\w+);
    |COR_API\s+(?P<result>[^;()]*?)(?P<function>cor_\w+)\((?P<parameters>[^()]*)\);
    |struct\s+(?P<struct>cor_\w+)\s*\{(?P<fields>.*?)\n?\};
    |enum\s+(?P<enum>cor_\w+)\s*\{(?P<members>.*?)\};)""",
    re.S | re.X,
)


class Declarations:
    """The public declarations that cor.h includes, in the order of the headers."""

    def __init__(self, include: Path) -> None:
        self.functions: Dict[str, Function] = {}
        self.structs: Dict[str, Struct] = {}
        self.enums: Dict[str, Enum] = {}
        self.constants: Dict[str, Constant] = {}
        self.objects: Dict[str, Object] = {}
        self.types: List[str] = []  # structs and enums as C text, in order
        self.modules: Dict[str, str] = {}  # header -> stem of the header in cor.h through which it is read
        self._include = include
        self._read("cor.h", "version")

    def short_name(self, name: str, header: str) -> str:
        """Returns a C name or macro without cor_<module>_. If it does not begin so, removes only cor_."""
        prefix = "cor_" + self.modules[header] + "_"
        for start in (prefix, "cor_"):
            if name.lower().startswith(start) and not name[len(start)].isdigit():
                return name[len(start) :]
        raise SyntaxError(f"{header}: {name} does not begin with cor_")

    def _read(self, header: str, module: str) -> None:
        if header in self.modules or header in NOT_READ:
            return
        self.modules[header] = module
        text = (self._include / header).read_text(encoding="utf-8").rstrip()
        at, docs = 0, ["", ""]  # docs: the last two comments
        while at < len(text):
            found = _TEXT.match(text, at)
            if not found:
                raise SyntaxError(f"{header}: what is this? {text[at:].strip()[:80]!r}")
            at = found.end()
            if found["comment"]:
                docs = [docs[1], comment_text(found["comment"])]
            elif found["include"]:
                self._read(found["include"], Path(found["include"]).stem if header == "cor.h" else module)
            else:
                self._declare(header, found, docs)

    def _declare(self, header: str, found: "re.Match[str]", docs: List[str]) -> None:
        doc = docs[1]
        if found["define"]:
            value = squeeze(_COMMENT.sub("", found["value"]).replace("\\\n", ""))
            if value:
                self.constants[found["define"]] = Constant(found["define"], value, header)
        elif found["object"]:
            name = found["object_name"]
            self.objects[name] = Object(name, squeeze(found["object"]), header)
        elif found["function"]:
            name, words = found["function"], squeeze(found["parameters"])
            if re.search(rf"\b{name}\b", docs[0].split(".")[0]):  # the comment on several functions
                doc = docs[0] + "\n\n" + doc
            parameters = () if words == "void" else tuple(parameter(word) for word in words.split(","))
            self.functions[name] = Function(name, squeeze(found["result"]), parameters, header, doc)
        elif found["struct"]:
            fields = tuple(
                Parameter(field.type, field.name, comment)
                for text, comment in _with_comments(found["fields"], ";")
                for field in _fields(text)
            )
            body = "".join(f"    {_declared(field)};\n" for field in fields)
            self.structs[found["struct"]] = Struct(found["struct"], fields, header, doc)
            self.types.append(f"struct {found['struct']} {{\n{body}}};")
        elif found["enum"]:
            members: List[Tuple[str, int, str]] = []
            for text, comment in _with_comments(found["members"], ","):
                name, _, value = (word.strip() for word in text.partition("="))
                members.append((name, int(value, 0) if value else (members[-1][1] + 1 if members else 0), comment))
            self.enums[found["enum"]] = Enum(found["enum"], tuple(members), header, doc)
            body = "".join(f"    {name} = {value},\n" for name, value, _ in members)
            self.types.append(f"enum {found['enum']} {{\n{body}}};")


def comment_text(comment: str) -> str:
    """Returns the text of a comment without /*, * and */. Indented lines remain indented."""
    first, *lines = comment[2:-2].split("\n")
    return "\n".join([first.strip()] + [re.sub(r"^[ \t]*\*?[ ]?", "", line).rstrip() for line in lines]).strip()


def squeeze(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


def parameter(text: str) -> Parameter:
    """Parses double *y to Parameter("double *", "y"). The type of a function pointer is its whole text."""
    text = squeeze(text)
    pointer = re.fullmatch(r"(.*\(\*)(\w+)(\)\(.*\))", text)
    if pointer:
        return Parameter(pointer[1] + pointer[3], pointer[2])
    split = re.fullmatch(r"(.*?[\s*])(\w+)", text)
    if not split:
        raise SyntaxError(f"no parameter: {text}")
    return Parameter(split[1].strip(), split[2])


def _fields(text: str) -> List[Parameter]:
    """Parses fields. "int n, l" and "double *q, *q_dot" have two fields, a function pointer has one."""
    if "(" in text:
        return [parameter(text)]
    first, *others = text.split(",")
    kind = parameter(first)
    return [kind] + [parameter(kind.type.rstrip("* ") + f" {word}") for word in others]


def _declared(field: Parameter) -> str:
    return field.type.replace("(*)", f"(*{field.name})") if "(*)" in field.type else f"{field.type} {field.name}"


def _with_comments(body: str, separator: str) -> Iterator[Tuple[str, str]]:
    """Yields each part of a struct or enum body with its comment, which is before it or after it on its line."""
    part = rf"((?:/\*.*?\*/|\([^()]*\)|[^{separator}])*)(?:{separator}|$)(?:[ \t]*(/\*.*?\*/))?"
    for found in re.finditer(part, body, re.S):
        comments = _COMMENT.findall(found[1] + (found[2] or ""))
        text = squeeze(_COMMENT.sub("", found[1]))
        if text:
            yield text, comment_text(comments[-1]) if comments else ""
