# SPDX-License-Identifier: MIT
"""Tests shapes, dtypes, layouts and out=, which work as in NumPy's own functions."""

import numpy as np
import pytest

import cor
from cor._evaluate import prepared_array

X = np.linspace(0.1, 3.0, 24)
GLASS = cor.Body(70e9, 0.22, 4e-7, 5e-3, 1e-3)


def eps(beta):
    """Computes eps of one element at a time."""
    return np.vectorize(lambda b: float(cor.sphere.eps_zero_force(float(b))), otypes=[float])(beta)


def test_shapes():
    assert np.shape(cor.sphere.eps_zero_force(0.5)) == ()
    assert isinstance(cor.sphere.eps_zero_force(0.5), np.float64)
    assert isinstance(cor.sphere.eps_zero_force(np.array(0.5)), np.float64)
    for shape in ((24,), (2, 12), (2, 3, 4), (1, 24), (24, 1)):
        result = cor.sphere.eps_zero_force(X.reshape(shape))
        assert result.shape == shape
        np.testing.assert_array_equal(result.ravel(), eps(X))


def test_empty_arrays():
    for shape in ((0,), (3, 0), (0, 2)):
        assert cor.sphere.eps_zero_force(np.empty(shape)).shape == shape
        assert cor.sphere.eps_zero_force(np.empty(shape, np.float32)).dtype == np.float32
    assert cor.disk.eps(np.empty(0), 0.3).shape == (0,)
    assert cor.disk.eps(np.empty((0, 1)), [0.1, 0.2]).shape == (0, 2)
    assert cor.Contact(GLASS).impacts([]).shape == (0,)
    assert cor.disk.hard_wall_nu(np.empty(0), cor.disk.HardWallOptions(1e-3), 0.1).shape == (0,)
    assert cor.disk.rayleigh_array(cor.disk.modes_nu033, 10, 0, []).shape == (0,)


def test_layouts():
    table = X.reshape(4, 6)
    fixed, unaligned = X.copy(), np.zeros(8 * 24 + 1, np.uint8)[1:].view(np.float64)
    fixed.flags.writeable, unaligned[:] = False, X
    assert not unaligned.flags.aligned
    for array in (X[::2], X[::-1], table.T, np.asfortranarray(table), table[:, 1:4], X.astype(">f8"), fixed, unaligned):
        result = cor.sphere.eps_zero_force(array)
        assert result.shape == array.shape and result.dtype == np.float64
        np.testing.assert_array_equal(result, eps(array))
    # C must not read a double at an odd address, although many processors allow it
    assert prepared_array(unaligned, np.dtype(np.float64)).flags.aligned
    assert prepared_array(X, np.dtype(np.float64)) is X


def test_dtypes():
    for given in (np.float32, np.float16, np.uint16, bool, np.float64, np.longdouble, np.int64):
        wanted = np.float64 if given in (np.float64, np.longdouble, np.int64) else np.float32
        assert cor.sphere.eps_zero_force(np.ones(3, given)).dtype == wanted, given
        assert cor.disk.eps(np.full(3, 0, given), 0.3).dtype == wanted, given
    narrow = X.astype(np.float32)
    assert cor.law.hunt_crossley_duration(narrow, 1.5).dtype == np.float32
    assert cor.law.hunt_crossley_duration(narrow, np.float64(1.5)).dtype == np.float64
    # without a float function the double result is rounded once
    np.testing.assert_array_equal(
        cor.sphere.eps_simple(narrow), cor.sphere.eps_simple(narrow.astype(float)).astype("f4")
    )
    assert cor.sphere.eps_zero_force(1).dtype == np.float64
    assert cor.disk.modes_below(0.33, [10.0, 20.0]).dtype == np.uintp


def test_numbers_alone():
    """Numbers reach C without arrays; test_bits.py tests them for all functions of one or two numbers."""
    contact = cor.contact.sphere_contact_init(GLASS, GLASS)
    for function, count in (
        (lambda g: cor.contact.duration_s_zero_overlap(contact, g), 1),
        (cor.contact.tangential_kappa, 4),
    ):
        for value in (0.3, 1, np.float64(0.25), -1.0, 0.0, np.nan, np.inf):
            number = function(*[value] * count)
            assert type(number) is np.float64
            np.testing.assert_array_equal(number, function(*[np.array([float(value)])] * count)[0])
    assert type(cor.sphere.eps_zero_force(np.float32(0.5))) is np.float32
    datum = cor.disk.Datum.DIAMETER
    assert cor.disk.load(0.01, 0.33, datum) == cor.disk.load([0.01], 0.33, datum)[0]
    assert cor.disk.load(0.01, 0.33, datum) != cor.disk.load(0.01, 0.33, cor.disk.Datum.CENTRE_OF_MASS)
    assert type(cor.disk.load(0.01, 0.33, datum)) is np.float64
    with pytest.raises(TypeError, match="datum: an integer is needed, not float64"):
        cor.disk.load(0.01, 0.33, 0.5)
    with pytest.raises(TypeError, match="is not a struct cor_sphere_contact"):
        cor.contact.eps_zero_force(0.3, 1.0)


def test_broadcasting():
    speed, nu = np.array([[0.01], [0.02], [0.1]]), np.array([0.1, 0.2, 0.3, 0.33])
    result = cor.disk.eps(speed, nu)
    assert result.shape == (3, 4)
    for i in range(3):
        for k in range(4):
            assert result[i, k] == cor.disk.eps(speed[i, 0], nu[k])
    contact = cor.contact.sphere_contact_init(GLASS, GLASS)
    times = cor.contact.dissipation_time_s_zero_force(contact, [[0.5], [1.0]], [0.9, 0.8, 0.7])
    assert times.shape == (2, 3)
    assert times[1, 2] == cor.contact.dissipation_time_s_zero_force(contact, 1.0, 0.7)
    exponents = cor.law.hunt_crossley_max_overlap(X[:, np.newaxis], [1.0, 1.5])
    np.testing.assert_array_equal(exponents[:, 1], cor.law.hunt_crossley_max_overlap(X, 1.5))
    load = cor.disk.load(0.1, 0.33, [0, 1, 2])
    assert [load[d] for d in cor.disk.Datum] == [cor.disk.load(0.1, 0.33, d) for d in cor.disk.Datum]
    assert len(set(load)) == 3
    with pytest.raises(ValueError):
        cor.disk.eps(np.ones(3), np.ones(4))


def test_out():
    result = np.empty_like(X)
    assert cor.sphere.eps_zero_force(X, out=result) is result
    np.testing.assert_array_equal(result, eps(X))
    wide = np.full((3, 24), -1.0)
    cor.sphere.eps_zero_force(X, out=wide[1])
    np.testing.assert_array_equal(wide[1], eps(X))
    assert (wide[0] == -1).all() and (wide[2] == -1).all()
    every_second = np.zeros(48)
    cor.sphere.eps_zero_force(X, out=every_second[::2])
    np.testing.assert_array_equal(every_second[::2], eps(X))
    narrow = np.empty(24, np.float32)
    cor.sphere.eps_zero_force(X, out=narrow)
    np.testing.assert_array_equal(narrow, eps(X).astype(np.float32))


def test_out_may_be_the_argument_or_overlap_it():
    same = X.copy()
    cor.sphere.eps_zero_force(same, out=same)
    np.testing.assert_array_equal(same, eps(X))
    many = np.linspace(0.1, 3.0, 5000)  # more numbers than the loop in C reads at a time
    for x, y in ((slice(0, -1), slice(1, None)), (slice(1, None), slice(0, -1))):
        shifted = np.append(many, 0.0)
        wanted = cor.sphere.eps_zero_force(shifted[x])
        cor.sphere.eps_zero_force(shifted[x], out=shifted[y])
        np.testing.assert_array_equal(shifted[y], wanted)


def test_wrong_out():
    fixed = np.zeros(24)
    fixed.flags.writeable = False
    texts = {"shape": np.empty(23), "stored": np.empty(24, int), "an array": [0.0] * 24, "read-only": fixed}
    for text, out in texts.items():
        with pytest.raises((TypeError, ValueError), match=text):
            cor.sphere.eps_zero_force(X, out=out)


def test_special_values():
    result = cor.sphere.eps_zero_force([0.0, np.inf, np.nan, -1.0])
    np.testing.assert_array_equal(result, [1.0, 0.0, np.nan, np.nan])
    with np.errstate(all="raise"):
        cor.sphere.eps_zero_force([np.nan, np.inf, -1.0])


def test_no_real_number():
    for wrong in (1j, "0.5", None, [[1, 2], [3]], 10**400, object()):
        with pytest.raises((TypeError, ValueError, OverflowError)):
            cor.sphere.eps_zero_force(wrong)


def test_integers():
    depth = cor.sphere.eps_simple_fraction(0.5, [0, 1, 2, 50])
    assert depth[0] == 1 and (np.diff(depth) < 0).all()
    assert np.isnan(cor.sphere.eps_simple_fraction(0.5, -1))
    for wrong, error in ((1.5, TypeError), (2**31, OverflowError), (-(2**31) - 1, OverflowError)):
        with pytest.raises(error):
            cor.sphere.eps_simple_fraction(0.5, wrong)
    with pytest.raises(OverflowError):
        cor.disk.collision(cor.disk.modes_nu033, -1, cor.disk.CollisionOptions(500, 1e-3), 0.1)
