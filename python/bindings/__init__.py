# SPDX-License-Identifier: MIT
"""Generates the bindings of other languages from the public headers, at build time."""
