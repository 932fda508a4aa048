# SPDX-License-Identifier: MIT
"""Provides the table of law.h: every function of a law, by names."""

from functools import lru_cache
from typing import Any, List, NamedTuple, Optional, Tuple

from numpy.typing import ArrayLike

from ._cor import ffi, lib
from ._evaluate import Array, Elementwise, one_of, string


class Function(NamedTuple):
    """A function of a law (struct cor_law_function)"""

    name: str
    least: float  # the domain: NaN outside
    largest: float
    max_ulp: float  # bound on the error, in units of the last place


def laws() -> List[str]:
    """Returns the names of the laws.

    C: cor_law_name"""
    return [string(lib.cor_law_name(law)) for law in range(lib.COR_LAWS)]


def ends() -> List[str]:
    """Returns the names of the ends of contact.

    C: cor_end_name"""
    return [string(lib.cor_end_name(end)) for end in range(lib.COR_ENDS)]


def quantities() -> List[str]:
    """Returns the names of the quantities.

    C: cor_quantity_name"""
    return [string(lib.cor_quantity_name(quantity)) for quantity in range(lib.COR_QUANTITIES)]


@lru_cache(maxsize=None)
def _indices(law: str, end: str, quantity: str) -> Tuple[int, int, int]:
    return one_of("law", law, laws()), one_of("end", end, ends()), one_of("quantity", quantity, quantities())


def function(law: str, end: str, quantity: str) -> Optional[Function]:
    """Returns name, domain and accuracy of a function; None if the law has no such function.

    C: cor_law_function"""
    found = lib.cor_law_function(*_indices(law, end, quantity))
    return None if found == ffi.NULL else Function(string(found.name), found.least, found.largest, found.max_ulp)


_value = Elementwise("cor_law_value", "law end quantity x", 3, True)


def value(law: str, end: str, quantity: str, x: ArrayLike, *, out: Optional[Array] = None) -> Any:
    """Returns a quantity of a law at an end of contact, such as value("tsuji", "zero_force", "eps", zeta).

    law, end, quantity: names of laws(), ends() and quantities(), with - or _.
    x: the damping, which is zeta for linear and tsuji and beta for the others; eps for damping-of-eps; 1 - eps for
    damping-of-loss.
    Returns NaN if the law has no such function and for x outside its domain. function(law, end, quantity) has domain
    and accuracy. float32 gives float32: eps and loss of viscoelastic at zero overlap and zero force use float
    arithmetic, within 0.75 units of the last place; the others are rounded once.

    C: cor_law_value, cor_law_array, cor_law_arrayf"""
    return _value((*_indices(law, end, quantity), x), out)
