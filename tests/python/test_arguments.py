# SPDX-License-Identifier: MIT
"""Tests that each optional argument has an effect, and arguments of other kinds than numbers and arrays."""

import _thread
import inspect
import random
import signal
import threading
import time

import numpy as np
import pytest

import cor
from cor import disk, simulators

BODY = cor.Body(70e9, 0.22, 4e-7, 5e-3, 1e-3)
SOFT = cor.Body(1e9, 0.3, 1e-6, 5e-3, 1e-3)
TABLE, COLLISION = disk.modes_nu033, disk.CollisionOptions(500, 1e-3)
ROOM = np.empty(1 << 22, np.uint8)
LINE = "pair_coeff * * hertz/material 7e10 0.5 0.22 tangential mindlin NULL 1 0.5 damping tsuji"
DECK = f"pair_style granular\n{LINE}\n"
MEASURED = {"restitution": 0.8, "at": 1.0}
LAMMPS, AT_ONE = ("lammps", BODY), {"speeds": 1.0}
AUDITED = {"radius": 2e-3, "density": 1.0, "time_step": 1e-7, "tolerance": 0.9, "version": "2 Aug 2023"}
CONTACT = cor.Contact(BODY, end="zero_force")
MATERIALS = [dict(name="steel", young_pa=2e11, poisson=0.3, density_kg_m3=7850, radius_m=1e-3, dissipation_time_s=1e-8)]
STEPS, ENGINE = dict(end="zero_force", steps=9), dict(erp=0.8, cfm=1.0, time_step=1.0)
STEEL = dict(a="steel", b="steel", restitution=0.8, at_m_s=1)

# A function, the arguments of its call, and another value for each of its optional arguments
OPTIONAL = [
    (simulators.lines, LAMMPS, {**MEASURED, **AT_ONE}, {"contact": SOFT, "speeds": 0.5, "version": "1 Jan 2020"}),
    (simulators.lines, LAMMPS, {**AT_ONE, "steps": 12}, {"steps": 30, "time_step": 1e-8, "step_corrected": True}),
    (simulators.lines, LAMMPS, AT_ONE, {"step_tolerance": 1e-3}),
    (simulators.lines, LAMMPS[:1], {**AT_ONE, "materials": MATERIALS}, {"materials": [], "pairs": [STEEL]}),
    (simulators.lines, LAMMPS[:1], {**AT_ONE, "materials": MATERIALS}, {"friction": 0.2}),
    (simulators.step_error, (BODY, 0.1), STEPS, {"integrator": "verlet-full-step", "steps": 12}),
    (cor.Contact, (), {"effective_mass": 1.0, **ENGINE}, {"erp": 0.5, "cfm": 2.0, "time_step": 2.0}),
    (cor.Contact, (BODY,), MEASURED, {"end": "zero_force", "wall": True, "law": "tsuji", "elastic": 1, "damping": 1}),
    (cor.Contact, (BODY,), {"adhesion": 1.0, "adhesion_model": "dmt"}, {"adhesion_model": "jkr"}),
    (cor.Contact, (BODY,), {"law": "linear", "restitution": 0.8, "at": 3.0}, {"equivalent": "energy"}),
    (CONTACT.eps, (1.0,), {}, {"end": "zero_overlap"}),
    (CONTACT.impacts, (1.0,), {}, {"steps": 20}),
    (simulators.audit, (DECK,), {"simulator": "lammps", **AT_ONE}, {"speeds": 2.0, "simulator": "yade"}),
    (simulators.audit, (DECK,), {**AT_ONE, "radius": 1e-3, "density": 2500}, AUDITED),
    (simulators.audit, ("include more\n",), {"simulator": "lammps", **AT_ONE}, {"include": lambda name, of: DECK}),
    (disk.rayleigh, (TABLE, TABLE.count, 0, 0.01), {}, {"mode_fraction": True}),
    (disk.rayleigh_array, (TABLE, TABLE.count, 0, [0.01]), {}, {"mode_fraction": True}),
    (TABLE.rayleigh, (0.01,), {}, {"n_modes": 30, "datum": 1}),
    (TABLE.collision, (0.1, 500, 1e-3), {"n_modes": 20}, {"n_modes": 30}),
    (TABLE.hard_wall, (0.1, 0.1), {}, {"n_modes": 100}),
    (disk.CollisionOptions, (500, 1e-3), {}, {"phi_points": 7, "max_steps": 3}),
    (disk.HardWallOptions, (0.1,), {}, {"max_steps": 3}),
]


def outcome(function, *given, **more):
    try:
        return repr(function(*given, **more))
    except ValueError as error:
        return str(error)


@pytest.mark.parametrize("row", range(len(OPTIONAL)), ids=lambda row: f"{row}-{OPTIONAL[row][0].__name__}")
def test_every_optional_argument_matters(row):
    function, given, more, others = OPTIONAL[row]
    before = outcome(function, *given, **more)
    for name, value in others.items():
        place = (given[0], value) if name == "contact" else given
        assert outcome(function, *place, **(more if name == "contact" else {**more, name: value})) != before, name


def test_details_are_filled_and_observe():
    for detail, call, options in (
        (disk.CollisionDetail, disk.collision_in, COLLISION),
        (disk.HardWallDetail, disk.hard_wall_in, disk.HardWallOptions(0.1)),
    ):
        n_modes, seen = (5 if detail is disk.CollisionDetail else TABLE.count), []
        made = detail(n_modes, observe=lambda *moment: seen.append(moment))
        call(ROOM, TABLE, n_modes, options, 0.1, detail=made)
        assert seen and np.isfinite(made.energy_after).all() and np.isfinite(made.energy_average).all()
        assert set(optional_of(call)) == {"detail"} and set(optional_of(detail)) == {"observe"}


def optional_of(function):
    parameters = inspect.signature(function).parameters
    return [name for name, p in parameters.items() if p.default is not p.empty and name != "out"]


def test_no_optional_argument_is_left_out():
    tested = {}
    for function, _, _, others in OPTIONAL:
        tested.setdefault(function.__name__, set()).update(others)
    public = [
        getattr(m, n)
        for m in (simulators, disk, cor.contact, cor.law, cor.sphere)
        for n in dir(m)
        if n[0].islower() or n.endswith("Options")
    ]
    methods = [cor.Contact, CONTACT.eps, CONTACT.impacts, TABLE.rayleigh, TABLE.collision, TABLE.hard_wall]
    for function in [f for f in public if inspect.isroutine(f) or inspect.isclass(f)] + methods:
        if optional_of(function) != ["detail"]:
            assert set(optional_of(function)) <= tested.get(function.__name__, set()), function


def test_all_fractions():
    record, fractions = disk.rayleigh(TABLE, TABLE.count, 0, 0.01, mode_fraction=True)
    assert fractions.shape == (TABLE.count,) and fractions.sum() == pytest.approx(record.fraction, rel=1e-12)
    _, many = disk.rayleigh_array(TABLE, TABLE.count, 0, [0.01, 0.02], mode_fraction=True)
    np.testing.assert_allclose(many[0], fractions, rtol=1e-9)


# ---- other kinds ----


def test_masks_stay():
    draw = np.random.RandomState(random.randrange(1000))
    x = np.ma.array(draw.uniform(0, 3, (4, 5)), mask=draw.randint(0, 2, (4, 5)))
    for function in (cor.sphere.eps_zero_force, CONTACT.eps, lambda y: disk.load(y / 20, 0.3, 0)):
        result = function(x)
        np.testing.assert_array_equal(result.mask, x.mask)
        np.testing.assert_array_equal(result.compressed(), function(x.compressed()))
    both = cor.law.hunt_crossley_duration(x, np.ma.array([1.0, 1.1, 1.2, 1.3, 1.4], mask=[0, 0, 0, 0, 1]))
    np.testing.assert_array_equal(both.mask, x.mask | [False, False, False, False, True])
    out = np.ma.zeros((4, 5))
    np.testing.assert_array_equal(cor.sphere.eps_zero_force(x, out=out).mask, x.mask)
    speeds = np.ma.array([0.1, -1.0, 0.2], mask=[0, 1, 0])  # a masked speed is not an error
    for records in (disk.collision(TABLE, 10, COLLISION, speeds), disk.collision_array(TABLE, 10, COLLISION, speeds)):
        np.testing.assert_array_equal(records["eps"].mask, speeds.mask)
    np.testing.assert_array_equal(simulators.realised("lammps", "hertz-tsuji", speeds).mask, speeds.mask)


def test_a_series_stays_a_series():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"v": [0.1, 0.2, 0.4], "eps": [0.9, 0.8, 0.7]}, index=["a", "b", "c"])
    contact = cor.contact.sphere_contact_init(BODY, BODY)
    result = cor.contact.eps_zero_force(contact, frame["v"])
    assert list(result.index) == ["a", "b", "c"] and result.name == "v"
    assert result["b"] == cor.contact.eps_zero_force(contact, 0.2)
    time = cor.contact.dissipation_time_s_zero_force
    assert list(time(contact, frame.v, frame.eps).index) == ["a", "b", "c"]
    assert cor.sphere.eps_zero_force(frame).loc["c", "eps"] == cor.sphere.eps_zero_force(0.7)
    with pytest.raises(ValueError, match="different indexes"):
        time(contact, frame.v, frame.eps[::-1])


@pytest.mark.parametrize(
    "act",
    [
        cor.sphere.eps_zero_force,
        lambda x: cor.sphere.eps_zero_force([1, x]),
        lambda x: disk.load(0.1, x, 0),
        lambda x: cor.Body(7e10, 0.2, 1e-7, x, 1e-3),
        lambda x: cor.Contact(BODY, restitution=x, at=1.0, end="zero_force"),
        lambda x: disk.rayleigh(TABLE, 10, 0, x),
        lambda x: disk.modes_compute(x, 10),
        lambda x: simulators.lines("lammps", young=7e10, poisson=0.2, radius=x, density=1, restitution=0.5, at=1),
        lambda x: simulators.lines("lammps", BODY, steps=x),
    ],
)
def test_what_is_no_number_is_named(act):
    for wrong, error in ((10 ** random.randint(309, 500), OverflowError), ("x", (TypeError, ValueError))):
        with pytest.raises(error, match=r"^\w+: .*(too large for a double; allowed|number is needed)"):
            act(wrong)


def test_ctrl_c_ends_an_array_of_collisions():
    options = disk.CollisionOptions(500, 1e-8)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background ignores SIGINT
    for function in (disk.collision_array, disk.collision):
        threading.Timer(0.3, _thread.interrupt_main).start()
        start = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            function(TABLE, 100, options, np.full(100000, 0.1))
        assert time.monotonic() - start < 3
    signal.signal(signal.SIGINT, before)
