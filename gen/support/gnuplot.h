/* SPDX-License-Identifier: MIT */
/* Pictures by the program gnuplot, in the style of the project's figures (docs/style.gp). */
#ifndef COR_GEN_SUPPORT_GNUPLOT_H
#define COR_GEN_SUPPORT_GNUPLOT_H

#include <stdio.h>

/* Begins a script: terminal, colours (black, grey, light, blue, red, green, violet, amber), axes. */
void gnuplot_style(FILE *script, int width, int height);

/* Runs the script, which holds its data, and copies the svg text that it prints to `svg`, without the lines that name
 * the version of gnuplot. Returns STATUS_OK, or STATUS_FAILED after a message. */
int gnuplot_run(FILE *script, FILE *svg);

/* Writes any text as a string of gnuplot, "...", which prints as the text without its control characters. */
void gnuplot_quote(FILE *script, const char *text);

#endif
