# SPDX-License-Identifier: MIT
"""The bindings of other languages, written from the public headers at build time."""
