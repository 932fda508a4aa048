# SPDX-License-Identifier: MIT
"""Fits of restitution to measured bounces: cor.fit and the command cor fit."""
