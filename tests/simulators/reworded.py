#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests that rewording labels, sentences and templates of runtime/scene changes no number. A test build replaces their
letters by other letters. Apart from letters it must print the same lines and the same maps of every model. If a
label decided a number, the output would differ.

    tests/simulators/reworded.py    CORGEN names the program, next to libcor_scene.a
"""
import codecs
import itertools
import os
import re
import sys
import tempfile

sys.dont_write_bytecode = True
from common import CORGEN, ROOT, output_of, run, summary, verdict  # noqa: E402

FILES = ["simulators.c", "lines.c"]
# Reads a line of options for each scene, NAME=VALUE with tabs between them.
DRIVER = r"""
#include <stdio.h>
#include "cor/scene.h"
int web_read(const char *options);
const char *web_lines(void), *web_models(int digits), *web_why(int part);
int main(void)
{
    char options[2048];
    for (int id = 0; id < COR_SIMULATOR_MODELS; id++)
        for (double e = 0.1; e < 1; e += 0.2) {
            const struct cor_simulator_model *m = cor_simulator_model((enum cor_simulator_model_id)id);
            const struct cor_scene_contact contact = {.mass_kg = 2e-3, .stiffness = 1e5, .radius_m = 3e-3};
            enum cor_simulator_status status;
            printf("%d %.17g %.17g ", id, cor_simulator_realised(m, e), cor_simulator_e(m, e, &status));
            printf("%.17g\n", m->number_of_damping ? m->number_of_damping(m, e, &contact, 0.3) : 0);
        }
    while (fgets(options, sizeof options, stdin)) {
        for (char *c = options; *c; c++)
            *c = *c == '\t' ? '\n' : *c;
        const char *const text = web_read(options) ? web_lines() : NULL;
        printf("%s", text ? text : web_why(1));
        printf("%s", text ? web_models(12) : "\n");
    }
}
"""


def reword(source):
    """Returns the source with other letters in every literal, except in words of templates, formats, escapes, names
    of simulators, includes, tables of words and arguments of the functions of string.h."""
    def literal(found):
        before = source[source.rfind(";", 0, found.start()) + 1:found.start()]
        if re.search(r"(\b(str|mem)\w+\([^()]*|SIMULATOR\(\w+, |#include |\{)$|static const char\b", before):
            return found[0]
        parts = re.split(r"(\\.|\{[^{}\n ]*\}|%[-.*\d]*[a-z])", found[0])
        return "".join(codecs.encode(part, "rot13") if i % 2 == 0 else part for i, part in enumerate(parts))

    return re.sub(r'"(\\.|[^"\\\n])*"', literal, source)


def scenes(simulators):
    """Returns options of contacts of every law, of both kinds of bodies, at both ends, with and without a wall."""
    spring = ["stiffness=1e5", "effective-mass=2e-3"]
    bodies = ["young=1e8", "poisson=0.3", "radius=5e-3", "density=2500"]
    for simulator, law, wall, end, measured in itertools.product(
            simulators, ["linear", "tsuji", "viscoelastic", "hertz-dashpot", "hunt-crossley"], ["", "wall=1"],
            ["", "end=zero-overlap", "end=zero-force"], [True, False]):
        second = [] if wall or measured else ["radius-2=8e-3", "young-2=3e8"]
        at = ["at=0.7", "speed=0.7"] if measured or law not in ("linear", "tsuji") else []
        yield ["for=" + simulator, "law=" + law, wall, end, "restitution=0.6", *at,
               *(spring if law == "linear" else bodies + second)]


def printed(work, name, change, given):
    """Returns the output of the driver after `change` rewrote the files of runtime/scene. Replaces all letters by x."""
    scene, program = os.path.join(ROOT, "runtime", "scene"), os.path.join(work, name)
    sources = [program + "_driver.c"]
    with open(sources[0], "w", encoding="utf-8") as file:
        file.write(DRIVER)
    for source in FILES:
        with open(os.path.join(scene, source), encoding="utf-8") as file:
            text = change(file.read())
        sources.append(program + "_" + source)
        with open(sources[-1], "w", encoding="utf-8") as file:
            file.write(text)
    libraries = [os.path.join(os.path.dirname(CORGEN), "libcor%s.a" % part) for part in ("_scene", "")]
    web = [os.path.join(ROOT, "web", source + ".c") for source in ("exports", "functions", "request")]
    print(output_of(["cc", "-O0", "-I" + ROOT, "-I" + os.path.join(ROOT, "include"), "-o", program, *sources, *web,
                     *libraries, "-lm"]), end="")
    return re.sub("[A-Za-z]", "x", run([program], input=given).stdout)


def main():
    listed = output_of([CORGEN, "contact", "--for", "list"])
    given = "".join("\t".join(filter(None, scene)) + "\n" for scene in scenes(re.findall(r"^\S+", listed, re.M)))
    with tempfile.TemporaryDirectory() as work:
        plain = printed(work, "plain", lambda text: text, given)
        verdict(plain == printed(work, "reworded", reword, given) and len(plain) > 500000,
                "other letters in labels, sentences and templates: the same %d characters" % len(plain))
        by_label = ["model->any_spring", 'model->law == COR_LAW_TSUJI && strstr(model->model, "ooke")']
        verdict(plain == printed(work, "by_label", lambda text: text.replace(*by_label), given) != printed(
            work, "reworded_by_label", lambda text: reword(text.replace(*by_label)), given),
                "a label that decides a number is found")
    return summary()


sys.exit(main())
