# SPDX-License-Identifier: MIT
# The sources of corgen but for main.c, in alphabetical order: add a file to gen/, add a line here.
set(COR_GENERATOR_SOURCES
  gen/collision.c
  gen/command_collide.c
  gen/command_pade.c
  gen/command_series.c
  gen/command_trajectory.c
  gen/console.c
  gen/digits.c
  gen/emit_c.c
  gen/jet.c
  gen/law.c
  gen/options.c
  gen/output.c
  gen/pade.c
  gen/pade_header.c
  gen/pade_rounded.c
  gen/published.c
  gen/restitution.c
  gen/series.c
  gen/slow_manifold.c
  gen/subcommand.c
  gen/tables.c
  gen/taylor.c
  gen/trajectory.c
  gen/trajectory_tail.c
  gen/turning_point.c)
