/* SPDX-License-Identifier: MIT */
/* The text of the runtime's evaluator, runtime/number/{inline,pair,fifth_root}.h, runtime/table/row.h and
 * runtime/sphere/eval.h or runtime/table/law.h, in this order. The library and the headers to embed thus share one
 * source. The build copies the text into corgen (cmake/EvaluatorText.cmake), without the lines that include one another
 * and without licence lines. */
#ifndef COR_GEN_SUPPORT_EVALUATOR_TEXT_H
#define COR_GEN_SUPPORT_EVALUATOR_TEXT_H

extern const char evaluator_inline[], evaluator_pair[], evaluator_fifth_root[], evaluator_row[], evaluator_sphere[],
    evaluator_law[];

#endif
