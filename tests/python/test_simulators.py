# SPDX-License-Identifier: MIT
"""Tests cor.simulators against corgen contact, and the contact of a measured restitution."""

import csv
import io
import math
import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cor
from cor import simulators

sys.path.append(str(Path(__file__).parents[1] / "reference"))
import contacts  # noqa: E402

CORGEN = os.environ.get("CORGEN", "build/corgen")
GLASS = {"young": 7e10, "poisson": 0.22, "radius": 1e-3, "density": 2500}
BODY = cor.Body(7e10, 0.22, 1e-6, 1e-3, float(cor.contact.sphere_mass_kg(1e-3, 2500)))
WALL = cor.Body(2e11, 0.3, 1e-6, np.inf, np.inf)


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
    assert simulators.lines("lammps", cor.Contact(BODY, BODY, end="zero_force"), speeds=1.0) == text


MATERIALS = [
    {"name": "floor", "young_pa": "2e9", "poisson": "0.35", "dissipation_time_s": "1e-6", "wall": "1"},
    {"name": "glass", "young_pa": 7e9, "poisson": 0.24, "density_kg_m3": 2500, "radius_m": 1e-3, "radius_max_m": 2e-3},
    {"name": "steel", "young_pa": 2e10, "poisson": 0.3, "density_kg_m3": 7850, "radius_m": 1.5e-3, "wall": math.nan},
]
PAIRS = [
    {"a": "glass", "b": "glass", "restitution": 0.9, "at_m_s": 1.0, "end": "zero-force"},
    {"a": "steel", "b": "steel", "restitution": 0.8, "at_m_s": 2.0, "end": ""},
]
SLIDES = {"a": "glass", "b": "steel", "friction": 0.1}


def written(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, list({name: 0 for row in rows for name in row}))
        table.writeheader()
        table.writerows([{k: "" if v != v else v for k, v in row.items()} for row in rows])
    return str(path)


def test_lines_of_several_materials_are_those_of_corgen(tmp_path):
    files = dict(materials=written(tmp_path / "m.csv", MATERIALS), pairs=written(tmp_path / "p.csv", PAIRS))
    for simulator in "lammps", "yade", "chrono":
        done = corgen("contact", **files, **{"for": simulator, "speed": 0.5, "end": "zero-force", "steps": 30})
        options = dict(speeds=0.5, end="zero_force", steps=30)
        assert simulators.lines(simulator, materials=MATERIALS, pairs=PAIRS, **options) == done.stdout != ""
    made = [*MATERIALS, {"name": "side", "wall": 1, "made_of": "glass"}]
    files = dict(materials=written(tmp_path / "m.csv", made), pairs=written(tmp_path / "p.csv", [*PAIRS, SLIDES]))
    done = corgen("contact", **files, **{"for": "lammps", "speed": 0.5, "friction": 0.3})
    text = simulators.lines("lammps", materials=made, pairs=[*PAIRS, SLIDES], friction=0.3, speeds=0.5)
    assert text == done.stdout and " 0.3 damping" in text and " 0.1 damping" in text


def test_an_engine_is_that_of_corgen():
    engine = dict(erp=0.8, cfm=1e-3, time_step=0.01, effective_mass=1.0, end="zero_force")
    given = {**engine, "end": "zero-force"}
    done = corgen("contact", **given, speed=1, format="csv")
    row = next(csv.DictReader(io.StringIO(done.stdout)))
    contact = cor.Contact(**engine)
    assert contact.eps_zero_force(1.0) == pytest.approx(float(row["eps_zero_force"]), rel=1e-11)
    error = simulators.step_error(contact, 1.0)
    assert [error.bias, error.scatter] == pytest.approx([float(row["step_bias"]), float(row["step_scatter"])], rel=1e-3)
    assert contact == pickle.loads(pickle.dumps(contact)) and "erp=0.8" in repr(contact)
    assert cor.Contact(**{**engine, "erp": 1}).eps_zero_force(1.0) == 1
    for name, x in dict(erp=1.1, cfm=-1, time_step=None, law="tsuji", stiffness=3).items():
        with pytest.raises(ValueError, match="^erp, cfm, time_step: "):
            cor.Contact(**{**engine, name: x})
    with pytest.raises(TypeError, match="^steps: "):
        simulators.step_error(BODY, 1.0)


def test_a_measured_contact_gives_the_measured_eps():
    contact = cor.Contact.from_restitution(BODY, BODY, 0.8, 0.5, "zero_force")
    assert contact.eps_zero_force(0.5) == pytest.approx(0.8, rel=1e-14)
    assert contact == cor.Contact(BODY, BODY, restitution=0.8, at=0.5, end="zero_force")
    assert contact.eps_zero_overlap(0.5) == contact.eps(0.5, "zero_overlap") < 0.8


def test_gravity_has_the_surface_as_its_end():
    given = {"speeds": 0.5, "wall": True, "restitution": 0.8, "at": 0.5}
    lines = simulators.lines("lammps", BODY, end="surface", gravity=9.81, **given)
    assert "# realises eps = 0.8 at 0.5 m/s under gravity" in lines
    for end, gravity in ("zero_force", {"gravity": 9.81}), ("surface", {}):
        with pytest.raises(ValueError, match="is not an end of this contact; allowed: zero_overlap"):
            simulators.lines("lammps", BODY, end=end, **gravity, **given)


def test_realised():
    half = simulators.realised("lammps", "lammps_hertz_tsuji", 0.5)
    assert half == pytest.approx(0.616, abs=5e-4)
    many = simulators.realised("LAMMPS", "hertz-tsuji", [[0.2, 0.5], [0.9, np.nan]])
    assert many.shape == (2, 2) and many[0, 1] == half and np.isnan(many[1, 1])
    ids = [(name, model) for name in [*simulators.names(), "kratos"] for model in simulators.models(name)]
    assert len({model for _, model in ids}) == len(ids) > 50
    assert all(np.isnan(simulators.realised(name, model, 2)) for name, model in ids)
    assert simulators.models("MFiX") == {"mfix_lsd": "DEM, LSD", "mfix_hertzian": "DEM, HERTZIAN"}


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
    with pytest.raises(ValueError, match="no simulator"):
        simulators.audit("nothing of that kind")
    with pytest.raises(ValueError, match="zero byte"):
        simulators.audit("pair_style granular\n\0", simulator="lammps")


def test_oblique_impacts_next_to_the_elastic_theory():
    program = Path(__file__).resolve().parents[1] / "reference" / "mindlin.py"
    done = subprocess.run([sys.executable, program, "--quick"], stdout=subprocess.PIPE, universal_newlines=True)
    assert done.returncode == 0, done.stdout


def test_step_error():
    contact = cor.Contact(BODY, restitution=0.9, at=1.0, end="zero_force")
    error = simulators.step_error(contact, [1.0, 1.0], [12, 50])
    assert error.shape == (2,) and abs(error.bias[1]) < abs(error.bias[0]) < 0.05
    printed = corgen("contact", **GLASS, restitution=0.9, at=1, end="zero-force", speed=1, steps=12, format="csv")
    row = next(csv.DictReader(io.StringIO(printed.stdout)))
    elastic = cor.Contact(BODY, dissipation_time=0).impacts(1.0).duration_s_zero_force
    found = simulators.step_error(contact, 1.0, elastic / float(row["time_step_s"]))
    assert found.bias == pytest.approx(float(row["step_bias"]), rel=2e-3)
    assert found.scatter == pytest.approx(float(row["step_scatter"]), rel=2e-3)


# ---- cor.Contact ----

SPRING = {"stiffness": 1e7, "effective_mass": 1e-3}


def options_of(row):
    """Returns the options of a contact in Python's form, without speeds and simulator."""
    made = {}
    for name, value in row["options"].items():
        if name == "viscosity":
            made.update(zip(("viscosity", "bulk_viscosity"), map(float, value.split(","))))
        elif name not in ("speed", "steps", "for"):
            is_text = name in ("law", "end", "adhesion-model", "elastic", "damping")
            made[name.replace("-", "_")] = True if value is None else value if is_text else float(value)
    if made.get("adhesion_model") == "jkr":  # corgen prints both ends
        made["end"] = "tail"
    return made


@pytest.mark.parametrize("row", contacts.rows(), ids=lambda row: row["contact"])
def test_a_contact_of_the_list(row):
    given = contacts.answer(row)
    assert {name: row[name] for name in given} == given
    contact = cor.Contact(**options_of(row))
    speeds = np.array([float(v) for v in row["options"].get("speed", "1").split(",")])
    try:
        found = contact.impacts(speeds.reshape(-1, 1))
    except ValueError as error:  # `end`, which belongs to the measured restitution, is missing
        assert row["contacts"] != "1" and str(error).startswith("end: ")
        return
    assert (row["contacts"] != "2" or "tail" in contact.ends) and found.shape == (len(speeds), 1)
    for name in contacts.NUMBERS:
        own = name if name in found.dtype.names else name.replace("zero_force", "surface")
        if row[name]:
            np.testing.assert_allclose(found[own][0, 0], float(row[name]), rtol=2e-11, err_msg=name)
    np.testing.assert_allclose(contact.impacts(speeds, steps=20).time_step_s * 20, found.time_step_s[:, 0] * 50)
    for end in contact.ends:
        np.testing.assert_array_equal(contact.eps(speeds, end), found[f"eps_{end}"][:, 0])
    again = pickle.loads(pickle.dumps(contact))
    assert again == contact and again.quantities == contact.quantities and repr(again) == repr(contact)


def test_an_equivalent_spring():  # K by hand: (16/15 E* sqrt(R))^(4/5) (m V^2)^(1/5)
    contact = cor.Contact(
        cor.Body(2.6e8, 0.25, 0.0, 9e-3, 7.63e-3), law="linear", equivalent="energy", zeta=0.1, at=3.0
    )
    assert contact.quantities["stiffness"] == pytest.approx(201573.32305184516, rel=1e-13)


def test_what_a_contact_refuses():
    for law, elastic in (("linear", "4/3"), ("viscoelastic", "3/2")):
        with pytest.raises(ValueError, match="corgen contact --elastic A --damping B .*allowed: viscoelastic, linear"):
            cor.Contact(**SPRING, elastic=elastic, damping="2/5", beta=0.1, at=1.0).impacts(1.0)
    either = cor.Contact(BODY, restitution=0.9, at=1.0)
    for act in (either.impacts, either.eps, cor.Contact(BODY).eps, lambda v: either.quantities):
        with pytest.raises(ValueError, match="^end: .*allowed: zero_overlap, zero_force"):
            act(1.0)
    with pytest.warns(cor.CorWarning, match="yield above"):
        cor.Contact(BODY, yield_stress=1e8).impacts([1e-3, 1.0])
    with pytest.raises(TypeError, match="^gravity: "):
        simulators.step_error(cor.Contact(BODY), 1.0, 20, gravity=9.81)


def test_a_measured_restitution():
    for bodies in ((BODY, BODY), (BODY, WALL), (BODY, cor.Body(1e9, 0.4, 7.0, 3e-3, 1e-3))):
        for end in ("zero_overlap", "zero-force"):
            for eps in (0.01, 0.5, 0.99):
                assert cor.Contact(*bodies, restitution=eps, at=0.7, end=end).eps(0.7) == pytest.approx(eps, rel=1e-13)


@pytest.mark.parametrize(
    "act, text",
    [
        (lambda: cor.Contact(BODY, restitution=0.9, at=0), "^at: "),
        (lambda: cor.Contact(BODY, restitution=0.9, at=1, end="end"), "^end: "),
        (lambda: cor.Contact(BODY).impacts([1.0, 0.0]), "^speed_m_s: "),
        (lambda: cor.Contact(BODY).impacts(1.0, steps=0), "^steps: "),
        (lambda: cor.Contact(BODY, poisson=0.6), "^poisson: "),
        (lambda: cor.Contact(BODY, mass=0), "^mass: "),
        (lambda: cor.Contact(BODY, elastic="x"), "^elastic: "),
        (lambda: cor.Contact(BODY, elastic=1.5, law="tsuji"), "^law: "),
        (lambda: cor.Contact(BODY, adhesion=0.1, adhesion_model="dlvo"), "^adhesion_model: "),
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
        (lambda: simulators.audit("include a", simulator="lammps", include=lambda name, of: b""), "^include: "),
        (lambda: simulators.lines("lammps", "glass"), "^contact: "),
        (lambda: simulators.lines("lammps", (WALL, BODY)), "^contact: "),
        (lambda: simulators.lines("lammps", young=1e9, poisson=0.3), "radius"),
        (lambda: simulators.lines("lammps", BODY, law="hooke"), "^law: "),
        (lambda: simulators.lines("lammps", BODY, materials=MATERIALS, speeds=1), "^materials: give only speeds"),
        (lambda: simulators.lines("lammps", materials=MATERIALS, speeds=1, young=1e9), "^materials: give only"),
        (lambda: simulators.lines("lammps", materials=MATERIALS), "^materials: give only speeds"),
        (lambda: simulators.lines("lammps", materials=[], speeds=1), "^no material has balls"),
        (lambda: simulators.lines("lammps", materials=[{**MATERIALS[0], "wall": 0}], speeds=1), "radius is missing"),
        (lambda: simulators.lines("lammps", materials=[{"mass": 1}], speeds=1), "^materials: the column 'mass'"),
        (
            lambda: simulators.lines("lammps", materials=[{"young_pa": -1}], speeds=1),
            "^materials: young_pa: -1.0 is not ",
        ),
        (lambda: simulators.lines("lammps", materials=[{**MATERIALS[1], "wall": 1}], speeds=1), "a wall has no radius"),
        (
            lambda: simulators.lines("lammps", materials=MATERIALS, pairs=[{"friction": -1}], speeds=1),
            "^pairs: friction: ",
        ),
        (lambda: simulators.lines("lammps", materials=[{"wall": "x"}], speeds=1), "^materials: wall: could not"),
        (lambda: simulators.lines("lammps", materials=MATERIALS, pairs=PAIRS[:1], speeds=1), "^steel and steel: the "),
        (lambda: simulators.lines("lammps", materials=MATERIALS, pairs=[{"a": "x"}], speeds=1), "^pairs: x, : a and"),
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
        (lambda: cor.contact.sphere_contact_init(BODY, 1), "^body_2: "),
        (lambda: cor.disk.eps(1j, 0.1), "^speed: "),
    ],
)
def test_errors_name_the_argument(act, text):
    with pytest.raises((AttributeError, TypeError, ValueError)) as error:
        act()
    assert re.search(text, str(error.value)), error.value


def test_float32_is_the_rounded_double():
    contact = cor.contact.sphere_contact_init(BODY, BODY)
    speeds = np.random.RandomState(1).uniform(1e-3, 10, 1000).astype(np.float32)
    for function in (
        lambda g: cor.contact.max_overlap_m(contact, g),
        cor.Contact(BODY, end="zero_force").eps,
        cor.sphere.eps_zero_force,
    ):
        result = function(speeds)
        assert result.dtype == np.float32
        np.testing.assert_array_equal(result, function(speeds.astype(np.float64)).astype(np.float32))
    eps = np.full(1000, 0.5, np.float32)
    both = cor.contact.dissipation_time_s_zero_force(contact, speeds, eps[:1])
    np.testing.assert_array_equal(both, cor.contact.dissipation_time_s_zero_force(contact, speeds, eps))
    inside = speeds.copy()
    assert cor.sphere.eps_zero_force(inside, out=inside) is inside
    np.testing.assert_array_equal(inside, cor.sphere.eps_zero_force(speeds))


def test_a_tolerance_may_stand_for_the_options_of_a_rigid_wall():
    fine = cor.disk.hard_wall_nu(0.3, 1e-5, 0.1)
    assert fine == cor.disk.hard_wall_nu(0.3, cor.disk.HardWallOptions(1e-5), 0.1)
    assert fine != cor.disk.hard_wall_nu(0.3, 1e-3, 0.1)
    modes = cor.disk.modes_nu033
    assert modes.hard_wall(0.1, tolerance=0.02, n_modes=400) == cor.disk.hard_wall(modes, 400, 0.02, 0.1)


def test_dir_is_what_is_public():
    for module in (cor.sphere, cor.contact, cor.disk, cor.law, cor.simulators):
        assert set(dir(module)) == set(module.__all__)


def test_quantities_are_those_of_corgen():
    given = dict(**GLASS, dissipation_time=1e-6, adhesion=0.05, adhesion_model="dmt")
    rows = csv.reader(io.StringIO(corgen("contact", "--format", "csv", **given).stdout))
    printed = {row[0]: row[1] for row in rows}
    found = cor.Contact(**given).quantities
    assert "tabor_number" in found
    for name, value in found.items():
        assert value == pytest.approx(float(printed[name]), rel=1e-11), name


@pytest.mark.parametrize("model", ["displacement", "mindlin_rescale/force", "liggghts", "yade", "viscous"])
def test_oblique_impacts_are_those_of_corgen(model):
    given = dict(**GLASS, restitution=0.8, at=1.0, end="zero-force")
    out = corgen("contact", "--format", "csv", **given, friction=0.3, angle=(0, 20, 70), speed=(1, 2), tangential=model)
    rows = list(csv.reader(io.StringIO(out.stdout)))
    made = cor.Contact(**given).oblique([[0, 20, 70]] * 2, [[1], [2]], 0.3, model)
    assert made.dtype.names == tuple(rows[0])
    for got, row in zip(made.ravel(), rows[1:]):
        assert got.regime == row[-1]
        assert list(got)[:-1] == pytest.approx([float(cell) for cell in row[:-1]], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(
    "words, changed",
    [
        ("angle_degrees: 90", {"angle_degrees": 90}),
        ("angle_degrees: nan", {"angle_degrees": np.nan}),
        ("speed_m_s: 0", {"speed_m_s": 0}),
        ("speed_m_s: inf", {"speed_m_s": math.inf}),
        ("tangential: 'foo' is not a tangential model; allowed: displacement.* simulator", {"tangential": "foo"}),
        ("tangential_stiffness of viscel is missing", {"tangential": "viscel"}),
        ("friction -1.0 is out of range", {"friction": -1}),
    ],
)
def test_oblique_impacts_refuse(words, changed):
    contact = cor.Contact(**GLASS, restitution=0.8, at=1.0, end="zero-force")
    with pytest.raises(ValueError, match=words):
        contact.oblique(**{"angle_degrees": 10, "speed_m_s": 1, "friction": 0.3, **changed})
