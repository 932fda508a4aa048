# SPDX-License-Identifier: MIT
"""Tests structs, errors and warnings, modes, collisions with observers, and that no public function is missing."""

import inspect
import pickle
import re
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import cor
from conftest import MODULES, module_of

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from bindings import cffi_source, python_source  # noqa: E402
from bindings.calls import BY_HAND, calls, form_of  # noqa: E402
from bindings.declarations import Declarations  # noqa: E402

GLASS = cor.Body(70e9, 0.22, 4e-7, 5e-3, 1e-3)
MODES = cor.disk.modes_nu033


# ---- whole ----


def test_every_public_function_is_reached(compiler):
    """The names come from the compiler, not from the parser that wrote the package."""
    public = set(re.findall(r"\b(cor_\w+)\((?!\*)", compiler.preprocessed()))
    assert len(public) > 100
    functions = Declarations(ROOT / "include" / "cor").functions
    assert public == set(functions)
    for name in public:
        reached = form_of(functions, name)
        function = getattr(cor.law, BY_HAND[name]) if name in BY_HAND else getattr(*module_of(reached))
        assert callable(function)
        assert re.search(rf"\b{reached}\b", inspect.getdoc(function))


def test_every_public_constant_is_reached():
    declared = Declarations(ROOT / "include" / "cor")
    text = "".join(
        (ROOT / "include" / "cor" / f"{name}.h").read_text() for name in ("contact", "disk", "law", "sphere")
    )
    names = set(re.findall(r"#define (COR_\w*[A-Z0-9])(?!_H\b) ", text)) - {"COR_API"}
    assert {n for n in names if not n.endswith("_H")} <= set(declared.constants)
    assert cor.sphere.EPS_MAX_ULP == 1.0
    assert cor.sphere.C1 == -1.15344885809528879913
    assert cor.disk.MAX_STACK == 65536 and isinstance(cor.disk.MAX_STACK, int)
    assert f'#define COR_VERSION_STRING "{cor.__version__}"' in (ROOT / "include" / "cor" / "cor.h").read_text()
    assert cor.status.Status.ERROR_RADIUS == 5 and cor.disk.Datum.PRINTED == 2


def test_docstrings_are_the_comments_of_the_headers():
    text = (ROOT / "include" / "cor" / "contact.h").read_text()
    comment = text[
        text.index("/* Returns A of (4), s, as published") : text.index("COR_API double cor_dissipation_time_s(")
    ]
    words = re.sub(r"\n \*/?|/\*|\*/", " ", comment).split()
    assert words == inspect.getdoc(cor.contact.dissipation_time_s).split("C: ")[0].split()
    assert "Domain: 0 <= beta <= inf" in inspect.getdoc(cor.sphere.eps_zero_force)
    for module in MODULES:
        for name in module.__all__:
            if inspect.isfunction(getattr(module, name)) or inspect.isclass(getattr(module, name)):
                assert len(inspect.getdoc(getattr(module, name)) or "") > 20, name


def test_docstrings_have_no_prototypes_of_c():
    modules = (cor.contact, cor.disk, cor.law, cor.sphere)
    docs = {name: getattr(module, name).__doc__ or "" for module in modules for name in dir(module)}
    assert [name for name, doc in docs.items() if "double cor_" in doc] == []
    assert docs["eps_zero_force"].startswith("Restitution coefficient")
    assert docs["hunt_crossley_max_overlap"].startswith("Largest overlap")


# ---- the parser: a header that grows, and an unreadable one ----


def headers_with(tmp_path, text):
    for header in (ROOT / "include" / "cor").glob("*.h"):
        (tmp_path / header.name).write_text(header.read_text())
    law = tmp_path / "law.h"
    law.write_text(law.read_text().replace("#ifdef __cplusplus\n}", text + "\n\n#ifdef __cplusplus\n}"))
    return tmp_path


def test_new_functions_are_found(tmp_path):
    text = """/* Two arrays. */
COR_API double cor_spring_time(double zeta, double mass_kg);
COR_API void cor_spring_time_array(const double *zeta, const double *mass_kg, double *y, size_t n);"""
    declared = Declarations(headers_with(tmp_path, text))
    found = calls(declared)
    assert found["cor_spring_time"].array is not None and "cor_spring_time_array" not in found
    module = python_source.modules(declared)["law"]
    assert "def spring_time(zeta: ArrayLike, mass_kg: ArrayLike, *, out" in module and '"""Two arrays.' in module
    loop = cffi_source.source(declared)
    assert "if (count && (count == 1 || (zeta_step == 1 && mass_kg_step == 1)))" in loop


@pytest.mark.parametrize("text", ["COR_API union u cor_new;", "typedef int cor_int;", "#if 1", "COR_UNKNOWN_(eps)"])
def test_unknown_text_is_an_error(tmp_path, text):
    with pytest.raises(SyntaxError):
        Declarations(headers_with(tmp_path, text))


def test_a_function_without_a_wrapper_is_an_error(tmp_path):
    text = "COR_API int cor_law_new(double *in_and_out);"
    assert "from ._law import" in python_source.modules(Declarations(headers_with(tmp_path, text)))["law"]


# ---- structs ----


def test_structs():
    fields = dict(young_modulus_pa=70e9, poisson_ratio=0.22, dissipation_time_s=4e-7, radius_m=5e-3, mass_kg=1e-3)
    assert GLASS == cor.Body(**fields) and GLASS != cor.Body(70e9, 0.22, 4e-7, 5e-3, 2e-3) and GLASS != 1
    assert hash(GLASS) == hash(cor.Body(70e9, 0.22, 4e-7, 5e-3, 1e-3))
    assert repr(GLASS) == f"Body({', '.join(f'{name}={value!r}' for name, value in fields.items())})"
    with pytest.raises(AttributeError):
        GLASS.mass_kg = 1.0
    with pytest.raises(AttributeError, match="Body has no mass; it has young_modulus_pa, .*mass_kg"):
        GLASS.mass
    with pytest.raises(TypeError):
        cor.Body(70e9, 0.22)
    contact = cor.contact.sphere_contact_init(GLASS, GLASS)
    for made in (GLASS, contact):
        assert pickle.loads(pickle.dumps(made)) == made
    assert contact.effective_mass_kg == 5e-4
    assert cor.contact.eps_zero_force(contact, 0.1) == cor.sphere.eps_zero_force(cor.contact.beta(contact, 0.1))
    options = cor.disk.CollisionOptions(500, 1e-3)
    assert (options.phi_points, options.max_steps) == (0, 0)


def test_other_contacts():
    g_star = cor.contact.sphere_contact_init_g_star(0.32)
    assert cor.contact.beta(g_star, 1.0) == g_star.beta_per_root
    assert abs(cor.contact.g_star_m_s(g_star) / 0.32 - 1) < 1e-14
    plate = cor.contact.Plate(70e9, 0.3, 2700, 0.01)
    contact = cor.contact.plate_contact_init(GLASS, plate)
    assert contact.effective_mass_kg == GLASS.mass_kg
    assert cor.contact.plate_lambda(contact, 1.0) == pytest.approx(2 / 3 * cor.contact.beta(contact, 1.0), rel=1e-15)
    assert cor.contact.plate_shear_crossings(contact, plate, [0.1, 1.0]).shape == (2,)


def test_structs_are_not_mixed_up():
    contact = cor.contact.sphere_contact_init(GLASS, GLASS)
    for wrong in (GLASS, None, 1.0, MODES):
        with pytest.raises(TypeError):
            cor.contact.eps_zero_force(wrong, 0.1)
    for act in (
        lambda: cor.contact.sphere_contact_init(GLASS, contact),
        lambda: cor.contact.sphere_contact_init_g_star([0.1, 0.2]),
    ):
        with pytest.raises(TypeError):
            act()


# ---- errors ----


def test_errors_have_the_texts_of_cor():
    with pytest.raises(cor.CorError) as caught:
        cor.contact.sphere_contact_init(cor.Body(70e9, 0.22, 4e-7, -1, 1), GLASS)
    assert caught.value.status is cor.status.Status.ERROR_RADIUS
    assert str(caught.value) == cor.status.text(5)
    assert isinstance(caught.value, ValueError)
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.status == caught.value.status
    with pytest.raises(cor.CorError, match=re.escape(cor.status.text(9))):
        cor.contact.sphere_contact_init(cor.Body(np.inf, 0.2, 0, 1, 1), cor.Body(np.inf, 0.2, 0, 1, 1))
    with pytest.raises(cor.CorError) as caught:
        MODES.hard_wall([[0.1, 0.1], [0.9, 0.1]], 1e-2, 400)
    assert caught.value.index == (1, 0) and "(at index 1, 0)" in str(caught.value)
    assert cor.status.text(-1) == cor.status.text(1000) != cor.status.text(0)


def test_statuses_with_results_warn():
    with pytest.warns(cor.CorWarning, match=re.escape(cor.status.text(21))) as seen:
        result = MODES.rayleigh(0.1)
    assert result.status == cor.status.Status.BEYOND_THEORY and result.fraction > 0
    assert seen[0].filename == __file__
    with pytest.warns(cor.CorWarning, match=re.escape(cor.status.text(22))):
        result = MODES.hard_wall([0.1, 0.2], 1e-7, 400)
    assert (result.status == 22).all() and (result.error_estimate > 1e-7).all()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        MODES.rayleigh(1e-3)


# ---- disks ----


def test_modes(tmp_path):
    assert len(MODES) == MODES.count == 1800 and MODES.nu == 0.33 and cor.disk.modes_nu090.nu == 0.9
    assert (np.diff(MODES.mode["omega"]) >= 0).all()
    with pytest.raises(ValueError):
        MODES.mode["omega"][0] = 1
    computed = cor.DiskModes(0.33, 50)
    np.testing.assert_allclose(computed.mode["omega"], MODES.mode["omega"][:50], rtol=2e-14)
    again = pickle.loads(pickle.dumps(computed))
    np.testing.assert_array_equal(again.mode, computed.mode)
    assert again.rayleigh(1e-3).fraction == computed.rayleigh(1e-3).fraction
    for mode, count in ((MODES.mode[:50], 50), (MODES.mode[0], 1)):
        assert cor.DiskModes.from_table(0.33, mode).mode.shape == (count,)
    for nu, count in ((1.5, 10), (0.3, 0), (0.3, -1), (0.3, 10**7)):
        with pytest.raises(cor.CorError):
            cor.DiskModes(nu, count)


def test_mode_files(tmp_path):
    (tmp_path / "wrong").write_text("not modes\n")
    statuses = {"none": cor.status.Status.ERROR_FILE, "wrong": cor.status.Status.ERROR_FILE_VERSION}
    for name, status in statuses.items():
        with pytest.raises(cor.CorError, match=name) as caught:
            cor.DiskModes.read(tmp_path / name)
        assert caught.value.status is status


def test_collision_array():
    options = cor.disk.CollisionOptions(500, 1e-6)
    speeds = np.array([[0.1, 0.2], [0.01, 0.1]])
    results = cor.disk.collision_array(MODES, 20, options, speeds)
    assert results.shape == (2, 2) and (results.status == 0).all()
    alone = MODES.collision(speeds, 500, 1e-6, 20)
    for name in ("eps", "one_minus_eps2", "contact_time", "steps", "error_estimate"):
        np.testing.assert_array_equal(results[name], alone[name])
    with pytest.raises(cor.CorError) as caught:
        cor.disk.collision_array(MODES, 20, options, [0.1, 0.6])
    assert caught.value.status is cor.status.Status.ERROR_SPEED and caught.value.index == (1,)
    with pytest.raises(cor.CorError):
        cor.disk.collision_array(MODES, 0, options, [0.1])


def test_rayleigh():
    result, fractions = cor.disk.rayleigh(MODES, 20, cor.disk.Datum.CENTRE_OF_MASS, 1e-3, mode_fraction=True)
    assert fractions.shape == (20,) and abs(fractions.sum() - result.fraction) < 1e-15
    speeds = np.array([[1e-3, 2e-3], [1e-4, 1e-2]])
    results, fractions = cor.disk.rayleigh_array(MODES, 20, 0, speeds, mode_fraction=True)
    assert results.shape == (2, 2) and fractions.shape == (2, 2, 20)
    assert results.fraction[0, 0] == pytest.approx(result.fraction, rel=1e-9)
    np.testing.assert_allclose(fractions.sum(axis=2), results.fraction, rtol=1e-12)
    reached, n_modes = cor.disk.rayleigh_tolerance(MODES, 0, 1e-3, 1e-2)
    assert 0 < n_modes < 1800 and reached.error_estimate < 1e-2 * (reached.fraction + reached.tail)
    for wrong in (0, 1801, -1):
        with pytest.raises((cor.CorError, OverflowError)):
            cor.disk.rayleigh(MODES, wrong, 0, 1e-3, mode_fraction=True)
    with pytest.raises(cor.CorError):
        cor.disk.rayleigh_array(MODES, 20, 7, [1e-3])


def test_collision_with_observer():
    options = cor.disk.CollisionOptions(500, 1e-4)
    workspace = np.empty(cor.disk.collision_workspace(MODES, 20, options), np.uint8)
    loads, amplitudes = [], []
    detail = cor.disk.CollisionDetail(20, lambda m, q, q_dot: (loads.append(m.load), amplitudes.append(q.copy())))
    result = cor.disk.collision_in(workspace, MODES, 20, options, 0.1, detail)
    assert result.eps == cor.disk.collision(MODES, 20, options, 0.1).eps == MODES.collision(0.1, 500, 1e-4, 20).eps
    assert len(loads) >= result.steps and max(loads) > 0 and len(amplitudes[0]) == 20
    assert abs(detail.energy_after.sum() - result.one_minus_eps2) < 1e-3
    for many in (21, 30):
        with pytest.raises(ValueError, match="room for 20"):
            cor.disk.collision_in(workspace, MODES, many, options, 0.1, detail)
    with pytest.raises(cor.CorError) as caught:
        cor.disk.collision_in(np.empty(8, np.uint8), MODES, 20, options, 0.1)
    assert caught.value.status is cor.status.Status.ERROR_WORKSPACE


def test_exception_in_observer():
    def stop(moment, q, q_dot):
        raise KeyError("stop")

    options = cor.disk.HardWallOptions(0.3)
    workspace = np.empty(cor.disk.hard_wall_workspace(MODES, 400, options, 0.1), np.uint8)
    with pytest.raises(KeyError, match="stop"):
        cor.disk.hard_wall_in(workspace, MODES, 400, options, 0.1, cor.disk.HardWallDetail(400, stop))
    moments = []
    detail = cor.disk.HardWallDetail(400, lambda m, q, q_dot: moments.append((m.time, m.load)))
    result = cor.disk.hard_wall_in(workspace, MODES, 400, options, 0.1, detail)
    assert len(moments) > 10 and moments[0][0] <= moments[-1][0]
    assert abs(detail.energy_after.sum() - result.one_minus_eps2) < 0.05


def test_hard_wall_of_any_nu():
    result = cor.disk.hard_wall_nu([0.2, 0.3], cor.disk.HardWallOptions(0.02), 0.1)
    assert result.shape == (2,)
    np.testing.assert_allclose(result.eps, cor.disk.eps(0.1, [0.2, 0.3]), atol=0.02)
