# SPDX-License-Identifier: MIT
"""The Fortran module cor, fortran/cor.f90.

    python3 python/bindings/fortran_source.py [--check]        writes the file, or fails if it is another
"""

import sys
from pathlib import Path
from typing import List

if __package__ in (None, ""):
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bindings.calls import Call, argument_names, calls, is_input, is_value  # noqa: E402
from bindings.cffi_source import constant_type  # noqa: E402
from bindings.declarations import Constant, Declarations, Function, Parameter, Struct  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
WIDTH = 110
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

TEXT = """
  !> One English sentence for a status.
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
    all_calls = calls(declared)
    parts = [HEAD]
    parts += [_constant(c) for c in declared.constants.values() if not c.parameters]
    for enum in declared.enums.values():
        parts += [f"  integer(c_int), parameter, public :: {name} = {value}\n" for name, value, _ in enum.members]
    parts += [_type(struct) for struct in declared.structs.values()]
    for made in declared.objects.values():
        name = made.name
        parts.append(f'\n  type({made.type.split()[-1]}_t), protected, public, bind(c, name="{name}") :: {name}\n')
    for call in all_calls.values():
        parts.append(_interfaces(call))
    parts.append("\ncontains\n")
    for call in all_calls.values():
        if call.kind == "elementwise":
            parts.append(_elemental(call, call.function, "double"))
            if call.float_function:
                parts.append(_elemental(call, call.float_function, "float"))
    return "".join(parts) + TEXT + "\nend module\n"


def _constant(constant: Constant) -> str:
    name, text = constant.name, constant.text.strip("()")
    kind = constant_type(constant)
    if kind == "str":
        return f"  character(len=*), parameter, public :: {name} = {text}\n"
    if kind == "int":
        return f"  integer(c_int), parameter, public :: {name} = {text}\n"
    return f"  real(c_double), parameter, public :: {name} = {text}_c_double\n"


def _field_type(field: Parameter) -> str:
    if "(*)" in field.type:
        return "type(c_funptr)"
    return "type(c_ptr)" if "*" in field.type else KINDS[field.type]


def _type(struct: Struct) -> str:
    text = f"\n  type, public, bind(c) :: {struct.name}_t\n"
    text += "".join(f"    {_field_type(field)} :: {field.name}\n" for field in struct.fields)
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


def _binding(function: Function, name: str, pure: bool) -> str:
    arguments = ", ".join(p.name for p in function.parameters)
    what = "subroutine" if function.result == "void" else "function"
    result = "" if function.result == "void" else " result(result_of_c)"
    head = f'    {"pure " if pure else ""}{what} {name}({arguments}) bind(c, name="{function.name}"){result}'
    text = _wrapped(head, 4) + "      import\n"
    text += "".join(f"      {_dummy(function, p)}\n" for p in function.parameters)
    if function.result == "const char *":
        text += "      type(c_ptr) :: result_of_c\n"
    elif result:
        text += f"      {KINDS[function.result]} :: result_of_c\n"
    return text + f"    end {what}\n"


def _interfaces(call: Call) -> str:
    function = call.function
    name = function.name
    if call.kind == "other" and function.result == "const char *":
        return f"\n  interface\n{_binding(function, 'c_' + name, True)}  end interface\n  public :: {name}\n"
    if call.kind != "elementwise":
        return f"\n  interface\n{_binding(function, name, False)}  end interface\n  public :: {name}\n"
    scalars = [f for f in (function, call.float_function) if f]
    arrays = [f for f in (call.array, call.float_array) if f]
    text = "\n  interface\n" + "".join(_binding(f, f"c_{f.name}", True) for f in scalars)
    text += "  end interface\n"
    specific = ", ".join(f"{name}_{real}" for real in ("double", "float")[: len(scalars)])
    text += f"  interface {name}\n" + _wrapped(f"    module procedure {specific}", 4) + "  end interface\n"
    text += f"  public :: {name}\n"
    if arrays:
        text += f"  interface {name}_array\n" + "".join(_binding(f, f"c_{f.name}", False) for f in arrays)
        text += f"  end interface\n  public :: {name}_array\n"
    return text


def _elemental(call: Call, function: Function, real: str) -> str:
    names = argument_names(call.function)
    text = _wrapped(f"\n  elemental function {call.function.name}_{real}({', '.join(names)}) result(value)", 2)
    for p, name in zip(call.function.parameters, names):
        kind = _number(p, real) if is_value(p) else f"type({p.type.split()[2]}_t)"
        assert is_value(p) or is_input(p)
        text += f"    {kind}, intent(in) :: {name}\n"
    text += f"    {KINDS[function.result]} :: value\n"
    text += _wrapped(f"    value = c_{function.name}({', '.join(names)})", 4)
    return text + "  end function\n"


def main() -> int:
    path = ROOT / "fortran" / "cor.f90"
    text = module(Declarations(ROOT / "include" / "cor"))
    if sys.argv[1:] == ["--check"]:
        if path.read_text(encoding="utf-8") != text:
            print("fortran/cor.f90 is not what the headers give: run python3 python/bindings/fortran_source.py")
            return 1
    elif sys.argv[1:]:
        print(__doc__, file=sys.stderr)
        return 2
    else:
        path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
