/* SPDX-License-Identifier: MIT */
/* The text of the runtime's evaluator, runtime/{inline,exact,fifth_root,sphere_eval}.h in this order, which the build
 * puts into corgen (cmake/EvaluatorText.cmake): one source for the library and for headers to embed. Lines that
 * include one another and licence lines are left out. */
#ifndef COR_GEN_SUPPORT_EVALUATOR_TEXT_H
#define COR_GEN_SUPPORT_EVALUATOR_TEXT_H

extern const char evaluator_inline[], evaluator_exact[], evaluator_fifth_root[], evaluator_sphere[];

#endif
