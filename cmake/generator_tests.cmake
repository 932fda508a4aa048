# SPDX-License-Identifier: MIT
# The tests of the generator: add tests/gen/test_<stem>.c, add <stem> here.
set(COR_GENERATOR_TESTS collision decimal digits disk_limits disk_modes embed emit fit hosts interpolant pade parallel pieces plan power_laws
  published series sweep taylor trajectory waves)
