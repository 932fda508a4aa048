# SPDX-License-Identifier: MIT
"""Compares every function of one or two real numbers, and every function of a law, with a program in C, bit for bit."""

import itertools
import re
import subprocess

import numpy as np
import pytest

import cor
from conftest import module_of

VALUES = [0.0, -0.0, 5e-324, 1e-300, 1e-9, 0.3, 0.5, 0.9, 1.0, 1.5, 7.0, 17.25, 1e30, np.inf, -0.5, np.nan]
SECOND = [0.33, 1.5]


def function_of(c_name):
    return getattr(*module_of(c_name))


@pytest.fixture(scope="session")
def prototypes(compiler):
    text = compiler.preprocessed()
    unary = re.findall(r"double (cor_\w+)\(double \w+\);", text)
    binary = re.findall(r"double (cor_\w+)\(double \w+, double \w+\);", text)
    assert len(unary) > 20 and len(binary) > 8
    return unary, binary


@pytest.fixture(scope="session")
def c_values(prototypes, compiler):
    """Returns the output of a program in C: name -> bits."""
    unary, binary = prototypes
    lines = [f'row("{name}", {name}(x[i]));' for name in unary]
    lines += [f'for (int k = 0; k < 2; k++) row("{name}", {name}(x[i], y[k]));' for name in binary]
    hexes = ", ".join("NAN" if v != v else "INFINITY" if v == np.inf else float(v).hex() for v in VALUES)
    program = f"""
#include <cor/cor.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
static const double x[] = {{{hexes}}}, y[] = {{{', '.join(map(str, SECOND))}}};
static void row(const char *name, double value) {{ printf("%s %a\\n", name, value); }}
int main(void)
{{
    for (int i = 0; i < {len(VALUES)}; i++) {{
        {' '.join(lines)}
        for (int f = 0; f < COR_LAWS * COR_ENDS * COR_QUANTITIES; f++) {{
            const int of[] = {{f % COR_LAWS, f / COR_LAWS % COR_ENDS, f / COR_LAWS / COR_ENDS}};
            char name[99];
            float in = (float)x[i], out;
            snprintf(name, sizeof name, "%s,%s,%s", cor_law_name(of[0]), cor_end_name(of[1]), cor_quantity_name(of[2]));
            for (char *c = name; *c; c++)
                *c = *c == ' ' ? '_' : *c;
            row(name, cor_law_value(of[0], of[1], of[2], x[i]));
            cor_law_arrayf(of[0], of[1], of[2], &in, &out, 1);
            strcat(name, ",f");
            row(name, out);
        }}
    }}
}}
"""
    found = {}
    for line in subprocess.run([compiler.program(program)], stdout=subprocess.PIPE, text=True).stdout.splitlines():
        name, value = line.split()
        found.setdefault(name, []).append(float.fromhex(value))
    return found


def same_bits(seen, wanted):
    seen = np.asarray(seen)
    np.testing.assert_array_equal(np.isnan(seen), np.isnan(wanted))
    np.testing.assert_array_equal(seen.astype(float), wanted)
    np.testing.assert_array_equal(np.signbit(seen[~np.isnan(wanted)]), np.signbit(wanted[~np.isnan(wanted)]))


def test_unary_functions_have_the_bits_of_c(prototypes, c_values):
    for name in prototypes[0]:
        function = function_of(name)
        same_bits(function(VALUES), np.array(c_values[name]))
        same_bits([function(v) for v in VALUES], np.array(c_values[name]))


def test_float32_is_the_rounded_double(prototypes):
    single = np.array(VALUES, np.float32)
    for name in prototypes[0]:
        seen = function_of(name)(single)
        assert seen.dtype == np.float32
        with np.errstate(over="ignore"):
            same_bits(seen, function_of(name)(single.astype(float)).astype(np.float32))


def test_laws_have_the_bits_of_c(c_values):
    law, seen = cor.law, 0
    for names in itertools.product(law.laws(), law.ends(), law.quantities()):
        key, given = ",".join(names).replace(" ", "_"), [name.replace("-", "_") for name in names]
        same_bits(law.value(*given, VALUES), np.array(c_values[key]))
        same_bits([law.value(*names, v) for v in VALUES], np.array(c_values[key]))
        single = law.value(*given, np.array(VALUES, np.float32))
        assert single.dtype == np.float32
        same_bits(single, np.array(c_values[key + ",f"]))
        found = law.function(*given)
        assert (found is None) == np.isnan(c_values[key]).all()
        if found:
            assert found.max_ulp > 0 and not np.isnan(law.value(*names, [found.least, 0.5, found.largest])).any()
            assert np.isnan(law.value(*names, np.nextafter(found.least, -np.inf)))
            seen += 1
    assert seen > 70 and law.value("Tsuji", "zero_force", "eps", 0.0) == 1
    for wrong in (("hertz", "limited", "eps"), ("linear", "end", "eps"), ("linear", "limited", "e")):
        with pytest.raises(ValueError, match="; allowed: (viscoelastic, linear|zero-overlap|eps, loss)"):
            law.value(*wrong, 1.0)


def test_binary_functions_have_the_bits_of_c(prototypes, c_values):
    for name in prototypes[1]:
        function = function_of(name)
        wanted = np.array(c_values[name]).reshape(len(VALUES), len(SECOND))
        same_bits(function(np.array(VALUES)[:, np.newaxis], SECOND), wanted)
        for k, second in enumerate(SECOND):
            same_bits(function(VALUES, second), wanted[:, k])


def test_contact_has_the_bits_of_c(compiler):
    program = compiler.program(
        """
#include <cor/cor.h>
#include <stdio.h>
int main(void)
{
    const struct cor_body a = {70e9, 0.22, 4e-7, 5e-3, 1e-3}, b = {5e9, 0.4, 1e-6, 1e-2, 2e-3};
    struct cor_sphere_contact contact;
    if (cor_sphere_contact_init(&contact, &a, &b) != COR_OK)
        return 1;
    printf("%a %a %a %a %a %a\\n", contact.beta_per_root, contact.scale, cor_contact_eps_zero_force(&contact, 0.3),
           cor_contact_eps_zero_overlap(&contact, 0.3), cor_contact_dissipation_time_s_zero_force(&contact, 0.5, 0.9),
           cor_contact_g_star_m_s(&contact));
}
"""
    )
    wanted = [float.fromhex(v) for v in subprocess.run([program], stdout=subprocess.PIPE, text=True).stdout.split()]
    c = cor.contact.sphere_contact_init(cor.Body(70e9, 0.22, 4e-7, 5e-3, 1e-3), cor.Body(5e9, 0.4, 1e-6, 1e-2, 2e-3))
    of = cor.contact
    given = [c.beta_per_root, c.scale, of.eps_zero_force(c, 0.3), of.eps_zero_overlap(c, 0.3)]
    assert wanted == given + [of.dissipation_time_s_zero_force(c, 0.5, 0.9), of.g_star_m_s(c)]
