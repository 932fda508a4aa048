# SPDX-License-Identifier: MIT
"""The audit of simulators' inputs: readers make contacts (deck), physics makes rows, measure runs the simulator."""
