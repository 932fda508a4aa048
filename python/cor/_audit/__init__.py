# SPDX-License-Identifier: MIT
"""Audits inputs of simulators: readers make contacts (deck), physics makes rows, measure runs the simulator."""
