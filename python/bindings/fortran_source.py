# SPDX-License-Identifier: MIT
"""The Fortran module cor, fortran/cor.f90.

    python3 python/bindings/fortran_source.py [--check]        writes the file, or fails if it is another
"""

import sys
from pathlib import Path
from typing import Dict, List

if __package__ in (None, ""):
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bindings.calls import Call, argument_names, calls, is_input, is_value  # noqa: E402
from bindings.cffi_source import constant_type  # noqa: E402
from bindings.declarations import (  # noqa: E402
    ROOT,
    Constant,
    Declarations,
    Function,
    Parameter,
    Struct,
    write_or_check,
)

WIDTH = 118
KINDS = {"double": "real(c_double)", "float": "real(c_float)", "int": "integer(c_int)", "size_t": "integer(c_size_t)"}

HEAD = """! SPDX-License-Identifier: MIT
! The functions of cor under their names in C. Written from the headers by python/bindings/fortran_source.py.
!
! Functions that return a number are elemental and pure, and generic where C has them in float, too. The names with
! _array are the loops of C; they are faster. struct cor_body is type(cor_body_t), and so on. An argument that may be
! NULL in C is optional. The comments of the headers in include/cor hold for all of them.
module cor
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_float, c_funptr, c_int, c_null_char, &
    c_ptr, c_size_t
  implicit none
  private
"""

TEXT = """  !> One English sentence for a status.
  function cor_status_text(status) result(text)
    integer(c_int), intent(in) :: status
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: i
    call c_f_pointer(c_cor_status_text(status), letters, [1000])
    text = ''
    do i = 1, size(letters)
      if (letters(i) == c_null_char) exit
      text = text // letters(i)
    end do
  end function
"""


def module(declared: Declarations) -> str:
    parts = [HEAD]
    parts += [_constant(c) for c in declared.constants.values() if not c.parameters]
    for enum in declared.enums.values():
        parts += [f"  integer(c_int), parameter, public :: {name} = {value}\n" for name, value, _ in enum.members]
    parts += [_type(struct) for struct in declared.structs.values()]
    for made in declared.objects.values():
        name = made.name
        parts.append(f'  type({made.type.split()[-1]}_t), protected, public, bind(c, name="{name}") :: {name}\n')
    public: List[str] = []
    bound, generic, elementals = "", "", ""
    for call in calls(declared).values():
        name, function = call.function.name, call.function
        public.append(name)
        if call.kind != "elementwise":
            bound += _binding(function, f"c_{name}" if function.result == "const char *" else name)
            continue
        for form, real in ((function, "double"), (call.float_function, "float")):
            if form:
                binding = f"c_{name}" if form is function else form.name
                bound += _binding(form, binding, "pure ")
                elementals += _elemental(call, form, f"{name}_{real}" if call.float_function else name, binding, real)
        if call.float_function:
            generic += f"  interface {name}\n"
            generic += _wrapped(f"    module procedure {name}_double, {name}_float", 4) + "  end interface\n"
        arrays = [form for form in (call.array, call.float_array) if form]
        if len(arrays) > 1:
            generic += f"  interface {name}_array\n"
            generic += "".join(_binding(form, f"c_{form.name}") for form in arrays) + "  end interface\n"
        else:
            bound += "".join(_binding(form, form.name) for form in arrays)
        public += [f"{name}_array"] if arrays else []
    parts += ["  interface\n", bound, "  end interface\n", generic, _wrapped(f"  public :: {', '.join(public)}", 2)]
    return "".join(parts) + "\ncontains\n" + elementals + TEXT + "end module\n"


def _binding(function: Function, name: str, pure: str = "") -> str:
    """A function of C, under a name of Fortran. One interface for all functions of a kind would be shorter, but
    gfortran 12 forgets the attribute value there."""
    arguments = ", ".join(p.name for p in function.parameters)
    what = "subroutine" if function.result == "void" else "function"
    result = "" if function.result == "void" else KINDS.get(function.result, "type(c_ptr)") + " "
    bind = f'bind(c, name="{function.name}")' if name != function.name else "bind(c)"
    return (
        _wrapped(f"    {pure}{result}{what} {name}({arguments}) {bind}", 4)
        + _packed(["import"] + [_dummy(function, p) for p in function.parameters], 6)
        + f"    end {what}\n"
    )


def _packed(statements: List[str], indent: int) -> str:
    """Statements, as many on a line as it holds."""
    lines = [" " * indent + statements[0]]
    for statement in statements[1:]:
        if len(lines[-1]) + len(statement) + 2 <= WIDTH + 2:
            lines[-1] += "; " + statement
        else:
            lines.append(" " * indent + statement)
    return "\n".join(lines) + "\n"


def _constant(constant: Constant) -> str:
    kind = constant_type(constant)
    fortran = {"str": "character(len=*)", "int": KINDS["int"], "float": KINDS["double"]}[kind]
    value = constant.text.strip("()") + ("_c_double" if kind == "float" else "")
    return f"  {fortran}, parameter, public :: {constant.name} = {value}\n"


def _type(struct: Struct) -> str:
    text = f"  type, public, bind(c) :: {struct.name}_t\n"
    for field in struct.fields:
        pointer = "type(c_funptr)" if "(*)" in field.type else "type(c_ptr)"
        text += f"    {pointer if '*' in field.type else KINDS[field.type]} :: {field.name}\n"
    return text + "  end type\n"


def _number(p: Parameter, real: str) -> str:
    return KINDS.get(p.type.replace("double", real), "integer(c_int)")


def _dummy(function: Function, p: Parameter) -> str:
    """The declaration of an argument of a function of C."""
    if is_value(p):
        return f"{KINDS.get(p.type, 'integer(c_int)')}, value :: {p.name}"
    plain = p.type.replace("const ", "").rstrip("* ")
    intent = "intent(in)" if p.type.startswith("const ") else "intent(inout)"
    if plain == "void":
        return f"type(c_ptr), value :: {p.name}"
    if plain == "char":
        return f"character(kind=c_char), intent(in) :: {p.name}(*)"
    if plain.startswith("struct "):
        many = "(*)" if plain == "struct cor_disk_mode" or function.name.endswith("_array") and p.name == "out" else ""
        optional = ", optional" if p.name == "detail" else ""
        return f"type({plain.split()[1]}_t), {intent}{optional} :: {p.name}{many}"
    if plain == "size_t":
        return f"{KINDS[plain]}, {intent}, optional :: {p.name}"
    optional = "" if p.type.startswith("const ") or function.result == "void" else ", optional"
    return f"{KINDS[plain]}, {intent}{optional} :: {p.name}(*)"


def _wrapped(text: str, indent: int) -> str:
    """A statement, continued where it is long."""
    lines: List[str] = []
    while len(text) > WIDTH:
        at = text.rindex(" ", 0, WIDTH)
        lines.append(text[:at] + " &")
        text = " " * (indent + 2) + text[at + 1 :]
    return "\n".join(lines + [text]) + "\n"


def _elemental(call: Call, function: Function, name: str, binding: str, real: str) -> str:
    names = argument_names(call.function)
    kinds: Dict[str, List[str]] = {}
    for p, argument in zip(call.function.parameters, names):
        assert is_value(p) or is_input(p)
        kind = _number(p, real) if is_value(p) else f"type({p.type.split()[2]}_t)"
        kinds.setdefault(kind, []).append(argument)
    return (
        _wrapped(f"  elemental {KINDS[function.result]} function {name}({', '.join(names)}) result(value)", 2)
        + _packed([f"{kind}, intent(in) :: {', '.join(arguments)}" for kind, arguments in kinds.items()], 4)
        + _wrapped(f"    value = {binding}({', '.join(names)})", 4)
        + "  end function\n"
    )


if __name__ == "__main__":
    MADE = module(Declarations(ROOT / "include" / "cor"))
    sys.exit(write_or_check(ROOT / "fortran" / "cor.f90", MADE, sys.argv[1:], __doc__))
