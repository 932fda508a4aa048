# SPDX-License-Identifier: MIT
"""Reads the declarations of cor's public headers, with the comment that documents each.

The parser reads the subset of C in which the headers are written: comments, #define, #include "...", functions and
objects marked COR_API, structs, enums, and macros whose names end in _ and which expand to declarations. It stops with
SyntaxError at any other text, so that no declaration is skipped in silence.
"""

import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Tuple

NOT_READ = ("export.h",)  # defines COR_API alone
ROOT = Path(__file__).resolve().parents[2]


def write_or_check(path: Path, text: str, arguments: List[str], usage: str) -> int:
    """Writes a file made from the headers, or with --check fails if it is another; the exit status."""
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
    text: str


@dataclass(frozen=True)
class Enum:
    name: str
    members: Tuple[Tuple[str, int, str], ...]  # name, value, comment
    header: str
    doc: str


@dataclass(frozen=True)
class Constant:
    """A macro with a value, or with parameters and an expression."""

    name: str
    parameters: Tuple[str, ...]
    text: str
    header: str
    doc: str


@dataclass(frozen=True)
class Object:
    name: str
    type: str
    header: str
    doc: str


class Declarations:
    """Every public declaration that cor.h includes, in the order of the headers."""

    def __init__(self, include: Path) -> None:
        self.functions: Dict[str, Function] = {}
        self.structs: Dict[str, Struct] = {}
        self.enums: Dict[str, Enum] = {}
        self.constants: Dict[str, Constant] = {}
        self.objects: Dict[str, Object] = {}
        self.types: List[str] = []  # structs and enums as C text, in order
        self._include = include
        self._module: Dict[str, str] = {}
        self._read("cor.h", "version")

    def module(self, header: str) -> str:
        """The subject of a header: its name, or that of the header that includes it; version for cor.h."""
        return self._module[header]

    def short_name(self, name: str, header: str) -> str:
        """A C name without the prefix cor_<module>_, or else without cor_; macros likewise."""
        prefix = "cor_" + self.module(header) + "_"
        for start in (prefix, "cor_"):
            if name.lower().startswith(start) and not name[len(start)].isdigit():
                return name[len(start) :]
        raise SyntaxError(f"{header}: {name} does not begin with cor_")

    def _read(self, header: str, module: str) -> None:
        if header in self._module or header in NOT_READ:
            return
        self._module[header] = module
        _Reader(self, header, (self._include / header).read_text(encoding="utf-8")).run()

    def include(self, header: str, of: str) -> None:
        self._read(header, Path(header).stem if of == "cor.h" else self._module[of])


_SPACE = re.compile(r"\s+")
_COMMENT = re.compile(r"/\*.*?\*/", re.S)
_MACRO_CALL = re.compile(r"(COR_\w+_)\(([^()]*)\)\s*(?!\w*;)")
_FUNCTION = re.compile(r"COR_API\s+(?!extern)(.*?)(cor_\w+)\(([^()]*)\);", re.S)
_OBJECT = re.compile(r"COR_API\s+extern\s+(.*?)(cor_\w+);", re.S)
_STRUCT = re.compile(r"struct\s+(cor_\w+)\s*\{(.*?)\n?\};", re.S)
_ENUM = re.compile(r"enum\s+(cor_\w+)\s*\{(.*?)\};", re.S)
_DIRECTIVE = re.compile(r"#(?:\\\n|/\*.*?\*/|[^\n])*", re.S)
_CONDITIONAL = re.compile(r"#ifdef __cplusplus\n([^#]|#if.*?#endif|#(?!endif))*#endif\n", re.S)
_DEFINE = re.compile(r"#\s*define\s+(\w+)(\([^)]*\))?[ \t]*(.*)", re.S)


def comment_text(comment: str) -> str:
    """The words of a comment, without its marks. Indented lines keep their indentation."""
    lines = [re.sub(r"^[ \t]*\*?[ ]?", "", line).rstrip() for line in comment[2:-2].split("\n")[1:]]
    first = comment[2:-2].split("\n")[0].strip()
    return "\n".join([first] + lines).strip()


def squeeze(text: str) -> str:
    return _SPACE.sub(" ", text).strip()


def parameter(text: str) -> Parameter:
    """double *y -> Parameter("double *", "y"); a function pointer keeps its whole text as its type."""
    text = squeeze(text)
    pointer = re.fullmatch(r"(.*\(\*)(\w+)(\)\(.*\))", text)
    if pointer:
        return Parameter(pointer[1] + pointer[3], pointer[2])
    split = re.fullmatch(r"(.*?[\s*])(\w+)", text)
    if not split:
        raise SyntaxError(f"no parameter: {text}")
    return Parameter(split[1].strip(), split[2])


class _Reader:
    """One header, read from top to bottom."""

    def __init__(self, into: Declarations, header: str, text: str) -> None:
        self.into = into
        self.header = header
        self.text = text
        self.at = 0
        self.doc = ""
        self.previous_doc = ""
        self.macros: Dict[str, Tuple[List[str], str]] = {}

    def run(self) -> None:
        while self.text[self.at :].strip():
            self.at += len(self.text[self.at :]) - len(self.text[self.at :].lstrip())
            self._step()

    def _step(self) -> None:
        if self.text.startswith("/*", self.at):
            end = self.text.index("*/", self.at) + 2
            self.previous_doc, self.doc = self.doc, comment_text(self.text[self.at : end])
            self.at = end
        elif self.text[self.at] == "#":
            self._directive()
        else:
            self.at += self._declaration(self.text[self.at :])

    def _directive(self) -> None:
        found = _DIRECTIVE.match(self.text, self.at)
        assert found
        comments = _COMMENT.findall(found[0])
        line = re.sub(r"/\*.*?\*/|\\\n", "", found[0], flags=re.S).strip()
        include = re.fullmatch(r'#\s*include\s*"([^"]+)"', line)
        define = _DEFINE.fullmatch(line)
        conditional = _CONDITIONAL.match(self.text, self.at)
        self.at = (conditional or found).end()
        if include:
            self.into.include(include[1], self.header)
        elif define:
            self._define(define[1], define[2], squeeze(define[3]), comment_text(comments[-1]) if comments else "")
        elif not conditional and not re.match(
            r"#\s*(ifndef\s+COR_\w+_H$|ifdef\s+COR_WITH_DISK$|endif$|undef\s|include\s*<)", line
        ):
            raise SyntaxError(f"{self.header}: {line}")

    def _define(self, name: str, parameters: Optional[str], value: str, comment: str) -> None:
        names = [word.strip() for word in parameters[1:-1].split(",")] if parameters else []
        if name.endswith("_"):
            self.macros[name] = (names, value)
        elif value:
            doc = comment or self.doc
            self.into.constants[name] = Constant(name, tuple(names), value, self.header, doc)

    def _declaration(self, text: str) -> int:
        """Reads the declaration at the start of the text; returns how many characters it has."""
        for pattern, read in (
            (_FUNCTION, self._function),
            (_OBJECT, self._object),
            (_STRUCT, self._struct),
            (_ENUM, self._enum),
            (_MACRO_CALL, self._expand),
        ):
            found = pattern.match(text)
            if found:
                read(found)
                return found.end()
        raise SyntaxError(f"{self.header}: what is this? {text[:80]!r}")

    def _function(self, found: "re.Match[str]") -> None:
        name = found[2]
        words = squeeze(found[3])
        parameters = () if words == "void" else tuple(parameter(word) for word in words.split(","))
        doc = self.doc
        if re.search(rf"\b{name}\b", self.previous_doc.split(".")[0]):
            doc = self.previous_doc + "\n\n" + doc
        self.into.functions[name] = Function(name, squeeze(found[1]), parameters, self.header, doc)

    def _object(self, found: "re.Match[str]") -> None:
        self.into.objects[found[2]] = Object(found[2], squeeze(found[1]), self.header, self.doc)

    def _struct(self, found: "re.Match[str]") -> None:
        fields: List[Parameter] = []
        for text, comment in _with_comments(found[2], ";"):
            kind, *names = _fields(text)
            fields += [Parameter(kind.type, name, comment) for name in [kind.name] + [n.name for n in names]]
        body = "".join(f"    {_declare(field)};\n" for field in fields)
        text = f"struct {found[1]} {{\n{body}}};"
        self.into.structs[found[1]] = Struct(found[1], tuple(fields), self.header, self.doc, text)
        self.into.types.append(text)

    def _enum(self, found: "re.Match[str]") -> None:
        members: List[Tuple[str, int, str]] = []
        for text, comment in _with_comments(found[2], ","):
            name, _, value = (word.strip() for word in text.partition("="))
            members.append((name, int(value, 0) if value else (members[-1][1] + 1 if members else 0), comment))
        self.into.enums[found[1]] = Enum(found[1], tuple(members), self.header, self.doc)
        body = "".join(f"    {name} = {value},\n" for name, value, _ in members)
        self.into.types.append(f"enum {found[1]} {{\n{body}}};")

    def _expand(self, found: "re.Match[str]") -> None:
        if found[1] not in self.macros:
            raise SyntaxError(f"{self.header}: macro {found[1]} is not defined before its use")
        names, body = self.macros[found[1]]
        for name, value in zip(names, found[2].split(",")):
            body = re.sub(rf"(##)?\b{name}\b(##)?", value.strip(), body)
        rest = body.strip()
        while rest:
            rest = rest[self._declaration(rest) :].strip()


def _fields(text: str) -> List[Parameter]:
    """int n, l -> two fields; double *q, *q_dot -> two; a function pointer -> one."""
    if "(" in text:
        return [parameter(text)]
    first, *others = text.split(",")
    kind = parameter(first)
    base = kind.type.rstrip("* ")
    return [kind] + [parameter(f"{base} {word}") for word in others]


def _declare(field: Parameter) -> str:
    return field.type.replace("(*)", f"(*{field.name})") if "(*)" in field.type else f"{field.type} {field.name}"


def _with_comments(body: str, separator: str) -> Iterator[Tuple[str, str]]:
    """The parts of a body of a struct or an enum, each with the comment behind it on its line, or else before it."""
    part = rf"((?:/\*.*?\*/|\([^()]*\)|[^{separator}])*)(?:{separator}|$)(?:[ \t]*(/\*.*?\*/))?"
    for found in re.finditer(part, body, re.S):
        comments = _COMMENT.findall(found[1] + (found[2] or ""))
        text = squeeze(_COMMENT.sub("", found[1]))
        if text:
            yield text, comment_text(comments[-1]) if comments else ""
