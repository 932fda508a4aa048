# SPDX-License-Identifier: MIT
"""Writes the C module of the Python package: declarations for cffi, and one loop over arrays for each function.

A loop accepts the address and the step of each argument. The step is 0 if all elements share the number, otherwise
1. The loop calls the library's array function if one exists for these steps, and the scalar function otherwise. Both
give the same bits.
"""

import re
from pathlib import Path
from typing import List

from .calls import BY_HAND, Call, calls, is_value
from .declarations import Constant, Declarations, Parameter

C_OF_KIND = {"d": "double", "i": "int", "n": "size_t"}


def kind_of(p: Parameter) -> str:
    """Returns the letter of a number's type in a loop: d, i or n."""
    return {"double": "d", "size_t": "n"}.get(p.type, "i")


def constant_type(constant: Constant) -> str:
    if constant.text.startswith('"'):
        return "str"
    return "int" if constant.text.lstrip("-").isdigit() else "float"


def declarations(declared: Declarations) -> str:
    """Returns the declarations for cffi."""
    lines = list(declared.types)
    for function in [c.function for c in calls(declared).values()] + [declared.functions[name] for name in BY_HAND]:
        parameters = ", ".join(f"{p.type} {p.name}" for p in function.parameters)
        lines.append(f"{function.result} {function.name}({parameters or 'void'});")
    lines += [f"extern {o.type} {o.name};" for o in declared.objects.values()]
    for constant in declared.constants.values():
        c_type = {"str": "char *const", "int": "const int", "float": "const double"}[constant_type(constant)]
        lines.append(f"static {c_type} {constant.name};")
    lines += ["enum { COR_IMPACT_COLUMNS = 9 };"] + [f"{head};" for head, _ in HAND + _loops(declared)]
    lines += [f'extern "Python" {head};' for head in _observers(declared)]
    return "\n".join(lines)


# Loops that are written by hand
HAND = [
    (
        "static int cor_loop_impacts(const struct cor_scene_contact *contact, const double *speed_m_s, double *rows, "
        "size_t count, int end)",
        """    for (size_t i = 0; i < count; i++) {
        struct cor_scene_impact y;
        const int status = end == COR_BOTH_ENDS ? cor_scene_impact(&y, contact, speed_m_s[i])
                                                : cor_scene_eps(rows + i, contact, speed_m_s[i], end);
        if (status != COR_OK)
            return status;
        if (end != COR_BOTH_ENDS)
            continue;
        const int hertz = !(contact->adhesion_j_m2 > 0);
        const double row[COR_IMPACT_COLUMNS] = {
            y.beta, y.eps[0], y.eps[1], y.duration_s[0], y.duration_s[1], y.max_overlap_m,
            cor_scene_force_max_n(contact, speed_m_s[i]),
            hertz ? cor_scene_contact_radius(contact, y.max_overlap_m) : NAN,
            hertz ? cor_scene_pressure(contact, y.max_overlap_m) : NAN};
        for (size_t k = 0; k < COR_IMPACT_COLUMNS; k++)
            rows[i * COR_IMPACT_COLUMNS + k] = row[k];
    }
    return COR_OK;
""",
    ),
    *[
        (
            f"static void cor_loop_law_value{f}(enum cor_law law, enum cor_end end, enum cor_quantity quantity, "
            f"const {real} *x, size_t x_step, {real} *result, size_t count)",
            f"    (void)x_step; /* one argument has the shape of the result */\n"
            f"    cor_law_array{f}(law, end, quantity, x, result, count);\n",
        )
        for f, real in (("", "double"), ("f", "float"))
    ],
]


def scene_declarations(include: Path) -> str:
    """Returns the declarations of scene.h, which cffi reads unchanged."""
    text = (include / "scene.h").read_text(encoding="utf-8")
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.S)
    text = "".join(line for line in text.splitlines(True) if not line.startswith("#"))
    return text


def source(declared: Declarations) -> str:
    """Returns the C text that cffi puts before its own text of the module."""
    parts = [
        "#define COR_WITH_DISK\n#include <math.h>",
        "#include <cor/cor.h>\n#include <cor/scene.h>",
        "enum { COR_IMPACT_COLUMNS = 9 };",
        "/* A loop has a step for every number, also where the form that it calls needs none. */",
    ]
    parts += [f"{head}\n{{\n{body}}}" for head, body in HAND + _loops(declared)]
    return "\n\n".join(parts) + "\n"


def _observers(declared: Declarations) -> List[str]:
    """Returns declarations of the Python functions that C calls, one for each struct field that is a function
    pointer."""
    return [
        field.type.replace("(*)", f"cor_python_{field.name}_{struct.name[len('cor_'):]}")
        for struct in declared.structs.values()
        for field in struct.fields
        if "(*)" in field.type and struct.name != "cor_law_function"
    ]


def _loops(declared: Declarations) -> "list[tuple[str, str]]":
    return [_loop(call) for call in calls(declared).values() if call.kind == "elementwise"]


def _element(p: Parameter) -> str:
    if not is_value(p):
        return p.name
    cast = f"({p.type})" if p.type.startswith("enum") else ""
    return f"{cast}{p.name}[i * {p.name}_step]"


def _loop(call: Call) -> "tuple[str, str]":
    parameters = [f"{p.type} {p.name}" for p in call.structs]
    for p in call.values:
        parameters += [f"const {C_OF_KIND[kind_of(p)]} *{p.name}", f"size_t {p.name}_step"]
    head = f"static void {call.loop}({', '.join(parameters)}, {call.function.result} *result, size_t count)"
    body = ""
    if call.array:
        tests, arguments = [], []
        for p, form in zip(call.function.parameters, call.array.parameters):
            pointer = is_value(p) and "*" in form.type
            if is_value(p):
                tests.append(f"{p.name}_step == {int(pointer)}")
            arguments.append(f"*{p.name}" if is_value(p) and not pointer else p.name)
        body += f"    if (count && (count == 1 || ({' && '.join(tests)}))) {{\n"
        body += f"        {call.array.name}({', '.join(arguments)}, result, count);\n        return;\n    }}\n"
    arguments = [_element(p) for p in call.function.parameters]
    body += "    for (size_t i = 0; i < count; i++)\n"
    body += f"        result[i] = {call.function.name}({', '.join(arguments)});\n"
    return head, body
