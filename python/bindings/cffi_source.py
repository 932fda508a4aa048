# SPDX-License-Identifier: MIT
"""The C module of the Python package: declarations for cffi, and one loop over arrays for each function.

A loop takes the address and the step of each number, 0 for a number that is the same for all elements, or else 1. It
calls the array function of the library where there is one for these steps, and the scalar function otherwise; both
give the same bits.
"""

import re
from pathlib import Path
from typing import List, Sequence

from .calls import BY_HAND, Call, calls, is_value
from .declarations import Constant, Declarations, Parameter

C_OF_KIND = {"d": "double", "i": "int", "n": "size_t"}


def kind_of(p: Parameter) -> str:
    """d, i or n: how a number is passed to a loop."""
    return {"double": "d", "size_t": "n"}.get(p.type, "i")


def constant_type(constant: Constant) -> str:
    if constant.text.startswith('"'):
        return "str"
    return "int" if constant.text.lstrip("-").isdigit() else "float"


def declarations(declared: Declarations) -> str:
    """What cffi is given to read."""
    lines = list(declared.types)
    called = [c for c in calls(declared).values() if c.kind == "other" or is_a_call(c)]
    for function in [call.function for call in called] + [declared.functions[name] for name in BY_HAND]:
        parameters = ", ".join(f"{p.type} {p.name}" for p in function.parameters)
        lines.append(f"{function.result} {function.name}({parameters or 'void'});")
    lines += [f"extern {o.type} {o.name};" for o in declared.objects.values()]
    for constant in declared.constants.values():
        c_type = {"str": "char *const", "int": "const int", "float": "const double"}[constant_type(constant)]
        if not constant.parameters:
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


def scene_declarations(include: Path, names: Sequence[str] = ("scene", "audit")) -> str:
    """The text of scene.h and audit.h, which cffi reads as it is, and what audit.h calls back."""
    text = "".join((include / f"{name}.h").read_text(encoding="utf-8") for name in names)
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.S)
    text = "".join(line for line in text.splitlines(True) if not line.startswith("#"))
    return (
        text
        + """
        extern "Python" int cor_python_audit_open(void *, struct cor_audit_text *, const char *, const char *);
        extern "Python" void cor_python_audit_report(void *, const struct cor_audit_finding *);"""
    )


def source(declared: Declarations) -> str:
    """The text of the C module that cffi puts before its own."""
    parts = [
        "#define COR_WITH_DISK\n#include <math.h>\n#include <cor/cor.h>\n#include <cor/audit.h>\n#include <cor/scene.h>",
        "enum { COR_IMPACT_COLUMNS = 9 };",
        "#if defined __GNUC__ && !defined __clang__ /* at -O2 gcc does not use vectors for conversions */",
        '#pragma GCC push_options\n#pragma GCC optimize("O3")\n#endif',
        "/* A loop has a step for every number, also where the form that it calls needs none. */",
    ]
    parts += [f"{head}\n{{\n{body}}}" for head, body in HAND + _loops(declared)]
    parts += ["#if defined __GNUC__ && !defined __clang__\n#pragma GCC pop_options\n#endif"]
    return "\n\n".join(parts) + "\n"


def _observers(declared: Declarations) -> List[str]:
    """The functions of Python that C calls: one for each field of a struct that is a pointer to a function."""
    return [
        field.type.replace("(*)", f"cor_python_{field.name}_{struct.name[len('cor_'):]}")
        for struct in declared.structs.values()
        for field in struct.fields
        if "(*)" in field.type and struct.name != "cor_law_function"
    ]


def _loops(declared: Declarations) -> "list[tuple[str, str]]":
    found = []
    for call in calls(declared).values():
        if call.kind == "elementwise":
            found.append(_loop(call))
            if has_float(call):
                found.append(_rounded_loop(call))
        elif call.kind in ("record", "init"):
            found.append(_record_loop(call))
    for constant in declared.constants.values():
        if constant.parameters:
            found.append(_macro_loop(constant))
    return found


def _number(p: Parameter, real: str) -> str:
    return C_OF_KIND[kind_of(p)].replace("double", real)


def _head(name: str, call: Call, real: str, results: str) -> str:
    parameters = [f"{p.type} {p.name}" for p in call.structs]
    for p in call.values:
        parameters += [f"const {_number(p, real)} *{p.name}", f"size_t {p.name}_step"]
    return f"static void {name}({', '.join(parameters + [results, 'size_t count'])})"


def _element(p: Parameter) -> str:
    if not is_value(p):
        return p.name
    cast = f"({p.type})" if p.type.startswith("enum") else ""
    return f"{cast}{p.name}[i * {p.name}_step]"


def _loop(call: Call) -> "tuple[str, str]":
    head = _head(call.loop, call, "double", f"{call.function.result} *result")
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


def has_float(call: Call) -> bool:
    """True if a loop accepts and returns float: it rounds the double results once."""
    return call.function.result == "double" and any(map(_is_real, call.values))


def is_a_call(call: Call) -> bool:
    """Whether one number is computed by a call of the function itself, without a loop."""
    return call.kind == "elementwise" and bool(call.values) and call.function.result == "double"


def _is_real(p: Parameter) -> bool:
    return kind_of(p) == "d"


def _rounded_loop(call: Call) -> "tuple[str, str]":
    """By blocks through the loop in double, so that they stay in the cache."""
    head = _head(call.loop + "f", call, "float", "float *result")
    reals = [p.name for p in call.values if _is_real(p)]
    body = "    enum { BLOCK = 256 };\n"
    body += f"    double y[BLOCK], {', '.join(f'{name}_[BLOCK]' for name in reals)};\n"
    body += "    for (size_t i = 0, n; i < count; i += n) {\n"
    body += "        n = count - i < BLOCK ? count - i : BLOCK;\n"
    for name in reals:
        body += f"        const float *const {name}_i = {name} + i * {name}_step;\n"
        body += f"        for (size_t j = 0; j < ({name}_step ? n : 1); j++)\n            {name}_[j] = {name}_i[j];\n"
    arguments = [p.name for p in call.structs]
    for p in call.values:
        arguments += [f"{p.name}_" if _is_real(p) else f"{p.name} + i * {p.name}_step", f"{p.name}_step"]
    body += f"        {call.loop}({', '.join(arguments)}, y, n);\n"
    body += "        for (size_t j = 0; j < n; j++)\n            result[i + j] = (float)y[j];\n    }\n"
    return head, body


def _record_loop(call: Call) -> "tuple[str, str]":
    out = call.out
    head = _head(call.loop, call, "double", "char *result, size_t stride")
    arguments = [
        f"(struct {out} *)(void *)(result + i * stride)" if p.type == f"struct {out} *" else _element(p)
        for p in call.function.parameters
    ]
    body = "    for (size_t i = 0; i < count; i++) {\n"
    body += f"        int *status = (int *)(void *)(result + i * stride + sizeof(struct {out}));\n"
    body += f"        *status = {call.function.name}({', '.join(arguments)});\n    }}\n"
    return head, body


def _macro_loop(constant: Constant) -> "tuple[str, str]":
    names = constant.parameters
    values = ", ".join(f"const double *{name}, size_t {name}_step" for name in names)
    arguments = ", ".join(f"{name}[i * {name}_step]" for name in names)
    head = f"static void cor_loop_{constant.name[len('COR_'):]}({values}, double *result, size_t count)"
    body = f"    for (size_t i = 0; i < count; i++)\n        result[i] = {constant.name}({arguments});\n"
    return head, body
