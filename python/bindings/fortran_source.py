# SPDX-License-Identifier: MIT
"""Writes the Fortran module cor, fortran/cor.f90.

    python3 python/bindings/fortran_source.py [--check]     writes the file, or fails if the file differs
"""

import sys
from itertools import groupby
from pathlib import Path
from typing import Dict, List, Tuple

if __package__ in (None, ""):
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bindings.calls import is_elementwise, is_value  # noqa: E402
from bindings.cffi_source import constant_type  # noqa: E402
from bindings.declarations import ROOT, Declarations, Function, Parameter, write_or_check  # noqa: E402

WIDTH = 118
KINDS = {"double": "real(c_double)", "float": "real(c_float)", "int": "integer(c_int)", "size_t": "integer(c_size_t)"}

HEAD = """! SPDX-License-Identifier: MIT
! The functions of cor under their names in C. Written from the headers by python/bindings/fortran_source.py.
!
! Functions that return a number are elemental and pure. Functions of type character have the length of their text.
! The names with _array are the loops of C; they are faster. struct cor_body is type(cor_body_t), and so on. An argument
! that may be NULL in C is optional. The comments of the headers in include/cor hold for all of them.
module cor
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_float, c_funptr, c_int, &
    c_null_char, c_ptr, c_size_t
  implicit none
  private
"""

TEXT = """  function text_of(address) result(text)
    type(c_ptr), intent(in) :: address
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: i
    text = ''
    if (.not. c_associated(address)) return
    call c_f_pointer(address, letters, [1000])
    do i = 1, size(letters)
      if (letters(i) == c_null_char) exit
      text = text // letters(i)
    end do
  end function
"""


def module(declared: Declarations) -> str:
    constants: Dict[str, List[str]] = {}
    for constant in declared.constants.values():
        kind = constant_type(constant)
        fortran = {"str": "character(len=*)", "int": KINDS["int"], "float": KINDS["double"]}[kind]
        value = constant.text.strip("()") + ("_c_double" if kind == "float" else "")
        constants.setdefault(fortran, []).append(f"{constant.name} = {value}")
    for enum in declared.enums.values():
        constants[KINDS["int"]] += [f"{name} = {value}" for name, value, _ in enum.members]
    parts = [HEAD] + [
        _wrapped(f"  {kind}, parameter, public :: {', '.join(names)}", 2) for kind, names in constants.items()
    ]
    for struct in declared.structs.values():
        parts.append(f"  type, public, bind(c) :: {struct.name}_t\n")
        for kind, fields in groupby(struct.fields, _field):
            parts.append(_wrapped(f"    {kind} :: {', '.join(field.name for field in fields)}", 4))
        parts.append("  end type\n")
    for made in declared.objects.values():
        name = made.name
        parts.append(f'  type({made.type.split()[-1]}_t), protected, public, bind(c, name="{name}") :: {name}\n')
    bound, contained = "", ""
    for name, function in declared.functions.items():
        inner = f"c_{name}"
        if function.result == "const char *":
            bound += _binding(function, inner)
            contained += _text(function, inner)
        elif is_elementwise(function):
            bound += _binding(function, inner, "pure ")
            contained += _elemental(function, inner)
        else:
            bound += _binding(function, name)
    public = _wrapped(f"  public :: {', '.join(declared.functions)}", 2)
    return "".join(parts) + f"  interface\n{bound}  end interface\n{public}\ncontains\n{contained}{TEXT}end module\n"


def _binding(function: Function, name: str, pure: str = "") -> str:
    """Returns the interface of a C function under a Fortran name. One interface for all functions of a kind would be
    shorter, but gfortran 12 ignores the attribute VALUE in it."""
    arguments = ", ".join(p.name for p in function.parameters)
    what = "subroutine" if function.result == "void" else "function"
    result = "" if function.result == "void" else KINDS.get(function.result, "type(c_ptr)") + " "
    bind = f'bind(c, name="{function.name}")' if name != function.name else "bind(c)"
    dummies = [(_dummy(function, p), p.name + _shape(function, p)) for p in function.parameters]
    head = f"{pure}{result}{what} {name}({arguments}) {bind}"
    return _packed([head, "import", *_grouped(dummies), f"end {what}"], 4)


def _grouped(declared: List[Tuple[str, str]]) -> List[str]:
    """Returns one declaration for each kind, with all its names. declared: pairs of kind and name."""
    kinds: Dict[str, List[str]] = {}
    for kind, name in declared:
        kinds.setdefault(kind, []).append(name)
    return [f"{kind} :: {', '.join(names)}" for kind, names in kinds.items()]


def _field(field: Parameter) -> str:
    pointer = "type(c_funptr)" if "(*)" in field.type else "type(c_ptr)"
    return pointer if "*" in field.type else KINDS[field.type]


def _shape(function: Function, p: Parameter) -> str:
    """Returns (*) for an array."""
    plain = p.type.replace("const ", "").rstrip("* ")
    if plain.startswith("struct "):
        many = plain == "struct cor_disk_mode" or function.name.endswith("_array") and p.name == "out"
        return "(*)" if many else ""
    return "(*)" if "*" in p.type and plain not in ("void", "size_t") else ""


def _dummy(function: Function, p: Parameter) -> str:
    """Returns the Fortran type of an argument of a C function."""
    plain = p.type.replace("const ", "").rstrip("* ")
    constant = p.type.startswith("const ")
    intent = "intent(in)" if constant else "intent(inout)"
    optional = ", optional" if not constant and function.result != "void" else ""
    if "*" not in p.type:
        return f"{KINDS.get(p.type, 'integer(c_int)')}, value"
    if plain == "void":
        return "type(c_ptr), value"
    if plain == "char":
        return "character(kind=c_char), intent(in)"
    if plain.startswith("struct "):
        return f"type({plain.split()[1]}_t), {intent}{', optional' if p.name == 'detail' else ''}"
    return f"{KINDS[plain]}, {intent}{optional}"


def _packed(statements: List[str], indent: int) -> str:
    """Returns statements, several on a line if they fit."""
    lines = [statements[0]]
    for statement in statements[1:]:
        fits = indent + len(lines[-1]) + len(statement) + 2 <= WIDTH
        lines[-1:] = [f"{lines[-1]}; {statement}"] if fits else [lines[-1], statement]
    return "".join(_wrapped(" " * (indent + 2 * (i > 0)) + line, indent) for i, line in enumerate(lines))


def _wrapped(text: str, indent: int) -> str:
    """Returns a statement, with continuation lines if it is long."""
    lines: List[str] = []
    while len(text) > WIDTH:
        at = text.rindex(" ", 0, WIDTH)
        lines.append(text[:at] + " &")
        text = " " * (indent + 2) + text[at + 1 :]
    return "\n".join(lines + [text]) + "\n"


def _elemental(function: Function, inner: str) -> str:
    names = [p.name for p in function.parameters]
    kinds = [
        KINDS.get(p.type, KINDS["int"]) if is_value(p) else f"type({p.type.split()[2]}_t)" for p in function.parameters
    ]
    head = f"elemental {KINDS[function.result]} function {function.name}({', '.join(names)}) result(value)"
    dummies = _grouped([(f"{kind}, intent(in)", name) for kind, name in zip(kinds, names)])
    return _packed([head, *dummies, f"value = {inner}({', '.join(names)})", "end function"], 2)


def _text(function: Function, inner: str) -> str:
    name = function.parameters[0].name
    return f"""  function {function.name}({name}) result(text)
    integer(c_int), intent(in) :: {name}
    character(len=:), allocatable :: text
    text = text_of({inner}({name}))
  end function
"""


if __name__ == "__main__":
    MADE = module(Declarations(ROOT / "include" / "cor"))
    sys.exit(write_or_check(ROOT / "fortran" / "cor.f90", MADE, sys.argv[1:], __doc__))
