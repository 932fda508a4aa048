/* SPDX-License-Identifier: MIT */
/* The closed forms of Hunt and Crossley's law; hunt_crossley_times.c computes its times. */
#include "cor/law.h"
#include "runtime/law/define.h"

LAW_DEFINE(hunt_crossley_eps, hc_eps)
LAW_DEFINE(hunt_crossley_loss, hc_loss)
LAW_DEFINE(hunt_crossley_beta, hc_beta)
LAW_DEFINE(hunt_crossley_beta_of_loss, hc_beta_of_loss)
LAW_DEFINE(hunt_crossley_eps_approach_only, hc_eps_approach_only)
LAW_DEFINE(hunt_crossley_loss_approach_only, hc_loss_approach_only)
LAW_DEFINE_ONE_BY_ONE(hunt_crossley_beta_approach_only, hc_beta_approach_only)
LAW_DEFINE_ONE_BY_ONE(hunt_crossley_beta_of_loss_approach_only, hc_beta_of_loss_approach_only)
LAW_DEFINE_WITH_EXPONENT(hunt_crossley_max_overlap, hc_max_overlap)
