# SPDX-License-Identifier: MIT
# The tests of the generator: add tests/gen/test_<stem>.c, add <stem> here.
set(COR_GENERATOR_TESTS collision contact decimal digits disk_limits disk_modes embed embed_proof emit
  far_motion fit interpolant law_proof pade parallel pieces plan power_bounds published row_proof
  sample series sweep taylor trajectory waves)
if(COR_BOOTSTRAP)
  list(REMOVE_ITEM COR_GENERATOR_TESTS contact disk_modes fit plan sample)
endif()
