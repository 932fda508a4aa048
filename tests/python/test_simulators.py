# SPDX-License-Identifier: MIT
"""cor.simulators against corgen contact and corgen audit, and the contact of a measured restitution."""

import csv
import io
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

import cor
from cor import simulators

CORGEN = os.environ.get("CORGEN", "build/corgen")
GLASS = {"young": 7e10, "poisson": 0.22, "radius": 1e-3, "density": 2500}
BODY = cor.Body(7e10, 0.22, 1e-6, 1e-3, float(cor.contact.sphere_mass_kg(1e-3, 2500)))
WALL = cor.Body(2e11, 0.3, 1e-6, np.inf, np.inf)
DECKS = Path(__file__).parents[1] / "audit" / "decks"


def corgen(*words, **options):
    words = [CORGEN, *words]
    for name, value in options.items():
        words.append(f"--{name.replace('_', '-')}")
        words += [] if value is True else [",".join(map(str, value)) if isinstance(value, tuple) else str(value)]
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)


@pytest.mark.parametrize("simulator", simulators.names())
@pytest.mark.parametrize(
    "scene",
    [
        dict(restitution=0.9, at=1.0, end="zero-force"),
        dict(restitution=0.5, at=0.3, end="zero-overlap", wall=True, young_2=2e11, poisson_2=0.3),
        dict(restitution=0.8, at=1.0, end="zero-overlap", law="linear", radius_2=2e-3),
        dict(dissipation_time=1e-6, end="zero-force"),
    ],
)
def test_lines_are_those_of_corgen(simulator, scene):
    options = {**GLASS, **scene}
    speeds = (0.5, 1.0)
    done = corgen("contact", **options, **{"for": simulator, "speed": speeds})
    if done.returncode:
        with pytest.raises(ValueError) as error:
            simulators.lines(simulator, speeds=speeds, **options)
        assert "--" not in str(error.value)
    else:
        assert simulators.lines(simulator, speeds=speeds, **options) == done.stdout


def test_bodies_and_their_numbers_give_the_same_lines():
    given = dict(young=7e10, poisson=0.22, radius=1e-3, mass=BODY.mass_kg)
    text = simulators.lines("lammps", BODY, speeds=1.0, end="zero_force")
    assert text == simulators.lines("lammps", speeds=1.0, end="zero_force", dissipation_time=1e-6, **given)
    walled = simulators.lines("lammps", (BODY, WALL), speeds=1.0, end="zero_force", restitution=0.9, at=1.0)
    assert walled == simulators.lines(
        "lammps", speeds=1.0, end="zero_force", wall=True, young_2=2e11, poisson_2=0.3, restitution=0.9, at=1.0, **given
    )
    contact = cor.Contact(BODY, BODY)
    assert "pair_coeff" in simulators.lines("lammps", contact, speeds=1.0, end="zero_force")


def test_gravity_has_the_surface_as_its_end():
    given = {"speeds": 0.5, "wall": True, "restitution": 0.8, "at": 0.5}
    lines = simulators.lines("lammps", BODY, end="surface", gravity=9.81, **given)
    assert "# realises eps = 0.8 at 0.5 m/s under gravity" in lines
    for end, gravity in ("zero_force", {"gravity": 9.81}), ("surface", {}):
        with pytest.raises(ValueError, match="is not an end of this contact; allowed: zero_overlap"):
            simulators.lines("lammps", BODY, end=end, **gravity, **given)


def test_realised():
    model = "granular hertz, damping tsuji, releases to July 2026"
    assert simulators.realised("lammps", model, 0.5) == pytest.approx(0.616, abs=5e-4)
    many = simulators.realised("LAMMPS", model[:-5], [[0.2, 0.5], [0.9, np.nan]])
    assert many.shape == (2, 2) and many[0, 1] == simulators.realised("lammps", model, 0.5)
    assert np.isnan(many[1, 1])
    for name in simulators.names():  # each by its whole name, which may begin another
        models = simulators.models(name)
        assert models and all(simulators.realised(name, model, 2) != 2 for model in models)


@pytest.mark.parametrize(
    "deck", sorted(p for p in DECKS.iterdir() if p.is_file() and p.suffix != ".csv")[::4], ids=lambda p: p.name
)
def test_audit_is_that_of_corgen(deck):
    def included(name, of):
        path = Path(of).parent / name
        return path.read_text() if path.exists() else None

    done = corgen("audit", str(deck), format="csv", speed=1, radius=1e-3, density=2500)
    found = None
    try:
        found = simulators.audit(deck, speeds=1.0, radius=1e-3, density=2500.0, include=included)
    except ValueError:
        assert done.returncode == 2
    if found is not None:
        rows = list(csv.DictReader(io.StringIO(done.stdout)))
        assert [f.model for f in found] == [row["model"] for row in rows]
        for name in ("realised", "step_bias", "step_scatter"):
            printed = [float(row[name] or "nan") for row in rows]
            np.testing.assert_allclose([getattr(f, name) for f in found], printed, rtol=1e-3, atol=1e-9)
        assert all(f.advice in row["advice"] for f, row in zip(found, rows))
        assert done.returncode == (0 if all(f.as_asked is not False and f.model for f in found) else 3)


def test_audit_reads_what_is_included():
    text = "units si\ninclude settings\n"
    asked = []

    def include(name, of):
        asked.append((name, of))
        line = "pair_coeff * * hertz/material 7e10 0.5 0.22 tangential mindlin NULL 1 0.5 damping tsuji"
        return f"pair_style granular\n{line}\n"

    found = simulators.audit(text, simulator="lammps", include=include, speeds=1.0, radius=1e-3, density=2500.0)
    assert asked == [("settings", "text")] and found[0].asked == 0.5 and found[0].as_asked is False

    def broken(name, of):
        raise KeyError(name)

    with pytest.raises(KeyError):
        simulators.audit(text, simulator="lammps", include=broken, speeds=1.0)
    with pytest.raises(ValueError, match="^simulator: "):
        simulators.audit("nothing of that kind")
    with pytest.raises(ValueError, match="zero byte"):
        simulators.audit("pair_style granular\n\0", simulator="lammps")


def test_step_error():
    contact = cor.Contact.from_restitution(BODY, BODY, 0.9, 1.0, "zero_force")
    error = simulators.step_error(contact, [1.0, 1.0], [12, 50], end="zero_force")
    assert error.shape == (2,) and abs(error.bias[1]) < abs(error.bias[0]) < 0.05
    printed = corgen("contact", **GLASS, restitution=0.9, at=1, end="zero-force", speed=1, steps=12, format="csv")
    row = next(csv.DictReader(io.StringIO(printed.stdout)))
    elastic = cor.Contact(*2 * [cor.Body(7e10, 0.22, 0, 1e-3, BODY.mass_kg)]).duration_s_zero_force(1.0)
    found = simulators.step_error(contact, 1.0, elastic / float(row["time_step_s"]), end="zero_force")
    assert found.bias == pytest.approx(float(row["step_bias"]), rel=2e-3)
    assert found.scatter == pytest.approx(float(row["step_scatter"]), rel=2e-3)


def test_from_restitution():
    for end in ("zero_overlap", "zero_force"):
        for bodies in ((BODY, BODY), (BODY, WALL), (BODY, cor.Body(1e9, 0.4, 7.0, 3e-3, 1e-3))):
            for eps in (0.01, 0.5, 0.99):
                made = cor.Contact.from_restitution(*bodies, eps, 0.7, end)
                assert getattr(made, f"eps_{end}")(0.7) == pytest.approx(eps, rel=1e-13)
    assert cor.Contact.from_restitution(BODY, BODY, 1, 0.7, "zero-force").g_star_m_s() == np.inf


@pytest.mark.parametrize(
    "act, text",
    [
        (lambda: cor.Contact.from_restitution(BODY, BODY, 1.1, 1, "zero_force"), "^eps: "),
        (lambda: cor.Contact.from_restitution(BODY, BODY, 0.9, 0, "zero_force"), "^speed_m_s: "),
        (lambda: cor.Contact.from_restitution(BODY, BODY, 0.9, 1, "end"), "^end: "),
        (lambda: simulators.lines("lammps", BODY, speeds=-1), "^speeds: "),
        (lambda: simulators.lines("lammps", BODY, steps=0), "^steps: "),
        (lambda: simulators.lines("abaqus", BODY, speeds=1.0), "abaqus"),
        (lambda: simulators.lines("lammps", BODY, yuong=1), "yuong"),
        (lambda: simulators.lines("lammps", BODY, restitution=np.nan, at=1), "^restitution: nan"),
        (lambda: simulators.lines("lammps", BODY, restitution=-0.9, at=1), "^restitution: "),
        (lambda: simulators.lines("lammps", BODY, restitution=1.1, at=1), "^restitution: "),
        (lambda: simulators.lines("lammps", BODY, g_star="0.2"), "^g_star: "),
        (lambda: simulators.lines("lammps", (BODY, BODY, BODY)), "^contact: 3"),
        (lambda: simulators.audit(None), "^text: "),
        (lambda: simulators.audit("include a", simulator="lammps", include=lambda name, of: b""), "encode"),
        (lambda: simulators.lines("lammps", "glass"), "^contact: "),
        (lambda: simulators.lines("lammps", (WALL, BODY)), "^contact: "),
        (lambda: simulators.lines("lammps", young=1e9, poisson=0.3), "radius"),
        (lambda: simulators.lines("lammps", BODY, law="hooke"), "^law: "),
        (lambda: simulators.lines("lammps", BODY, version="new"), "^version: "),
        (lambda: simulators.lines("lammps", BODY, version="3.8.1\0x"), "^version: "),
        (lambda: simulators.lines("yade\0x", BODY), "^simulator: "),
        (lambda: simulators.models("yade\0x"), "^simulator: "),
        (lambda: simulators.step_error(BODY, 1.0, 10, integrator="rk4"), "^integrator: "),
        (lambda: simulators.step_error(BODY, 0.0, 10), "^speed: "),
        (lambda: simulators.realised("lammps", "none", 0.5), "^model: "),
        (lambda: simulators.audit("x", tolerance=-1), "^tolerance: "),
        (lambda: cor.sphere.eps_zero_force("x"), "^beta: |^x: "),
        (lambda: cor.contact.sphere_mass_kg(1, "x"), "^density_kg_m3: "),
        (lambda: cor.Contact(BODY, 1), "^body_2: "),
        (lambda: cor.disk.eps(1j, 0.1), "^speed: "),
    ],
)
def test_errors_name_the_argument(act, text):
    with pytest.raises((AttributeError, TypeError, ValueError)) as error:
        act()
    assert re.search(text, str(error.value)), error.value


def test_float32_is_the_rounded_double():
    contact = cor.Contact(BODY, BODY)
    speeds = np.random.RandomState(1).uniform(1e-3, 10, 1000).astype(np.float32)
    for function in (contact.eps_zero_force, contact.max_overlap_m):
        result = function(speeds)
        assert result.dtype == np.float32
        np.testing.assert_array_equal(result, function(speeds.astype(np.float64)).astype(np.float32))
    eps = np.full(1000, 0.5, np.float32)
    both = contact.dissipation_time_s_zero_force(speeds, eps[:1])
    np.testing.assert_array_equal(both, contact.dissipation_time_s_zero_force(speeds, eps))
    inside = speeds.copy()
    assert contact.eps_zero_force(inside, out=inside) is inside
    np.testing.assert_array_equal(inside, contact.eps_zero_force(speeds))


def test_a_tolerance_may_stand_for_the_options_of_a_rigid_wall():
    fine = cor.disk.hard_wall_nu(0.3, 1e-5, 0.1)
    assert fine == cor.disk.hard_wall_nu(0.3, cor.disk.HardWallOptions(1e-5), 0.1)
    assert fine != cor.disk.hard_wall_nu(0.3, 1e-3, 0.1)
    modes = cor.disk.modes_nu033
    assert modes.hard_wall(0.1, tolerance=0.02, n_modes=400) == cor.disk.hard_wall(modes, 400, 0.02, 0.1)


def test_dir_is_what_is_public():
    for module in (cor.sphere, cor.contact, cor.disk, cor.law, cor.simulators):
        assert set(dir(module)) == set(module.__all__)
