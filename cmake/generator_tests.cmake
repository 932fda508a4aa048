# SPDX-License-Identifier: MIT
# The tests of the generator: add tests/gen/test_<stem>.c, add <stem> here.
set(COR_GENERATOR_TESTS collision digits emit pade published series taylor trajectory)
