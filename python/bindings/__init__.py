# SPDX-License-Identifier: MIT
"""Generators of the bindings of other languages, run at build time on the public headers."""
