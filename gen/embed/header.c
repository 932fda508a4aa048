/* SPDX-License-Identifier: MIT */
#include "embed/header.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/emit_c.h"
#include "support/evaluator_text.h"

enum { TEXT_MAX = 16384, NAME_MAX_HERE = 128 };

static const char default_name[] = "cor_scene_eps";

struct text {
    char text[TEXT_MAX];
    size_t length;
};

static void text_append(struct text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void text_append(struct text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int n = vsnprintf(t->text + t->length, TEXT_MAX - t->length, format, arguments);
    va_end(arguments);
    t->length = n < 0 ? t->length : FLINT_MIN(t->length + (size_t)n, (size_t)TEXT_MAX - 1);
}

static void append_command(struct text *t, const struct embed_request *request)
{
    int column = 15;
    text_append(t, "Written by:  corgen embed");
    for (int i = 0; i < EMBED_NUMBERS; i++) {
        const char *const text = embed_text(request, embed_number_in_order(i));
        if (!text)
            continue;
        const char *name = embed_number_name(embed_number_in_order(i));
        const int width = (int)(strlen(name) + strlen(text)) + 4;
        if ((column += width) > 85) {
            text_append(t, " \\\n                ");
            column = width;
        }
        text_append(t, " --%s %s", name, text);
    }
    char law[EMBED_LAW_OPTIONS];
    text_append(t, "%s%s%s%s \\\n                 --end %s --type %s --for %s", request->wall ? " --wall" : "",
                request->adhesion_model ? " --adhesion-model " : "",
                request->adhesion_model ? embed_adhesion_names[request->adhesion_model] : "",
                embed_law_options(law, request), request->end == END_ZERO_FORCE ? "zero-force" : "zero-overlap",
                embed_type_names[request->type], embed_purpose_names[request->purpose]);
    if (request->name)
        text_append(t, " --name %s", request->name);
    text_append(t, "\nChecked by:  the same command, whose output is the same to the byte\n");
}

static void append_operations(struct text *t, const struct embed_form *f)
{
    const char *before = "";
    for (int op = 0; op < OPERATIONS; op++)
        if (f->operations[op] > 0) {
            text_append(t, "%s%d %s", before, f->operations[op], embed_operation_names[op]);
            before = ", ";
        }
}

static void append_alternatives(struct text *t, const struct embed_scene *s, const struct embed_form *form,
                                enum embed_family chosen)
{
    text_append(t, "                                                            ns each\n"
                   "  form                    size                   error    scalar vector  operations\n");
    for (int i = 0; i < FAMILIES; i++) {
        const struct embed_form *f = &form[i];
        text_append(t, "%c %-23s ", i == (int)chosen ? '>' : ' ', embed_family_name((enum embed_family)i, s));
        if (f->found) {
            char size[64];
            embed_form_size(size, sizeof size, f);
            text_append(t, "%-22s %s  %6.2f %6.2f  ", size, emit_bound(f->error).text, f->cost[USE_SCALAR],
                        f->cost[USE_ARRAY]);
            append_operations(t, f);
            text_append(t, "\n");
        } else {
            text_append(t, "%s\n", f->why);
        }
    }
}

/* The meaning of a purpose, as text */
static const char *rule_of_purpose(enum embed_purpose purpose)
{
    switch (purpose) {
    case PURPOSE_SCALAR:
        return "the least time for calls of their own, column scalar";
    case PURPOSE_ARRAY:
        return "the least time in loops that become vectors, column vector";
    default:
        return "the least time, a call of its own counting\nas much as four numbers of a loop that becomes vectors, "
               "scalar + 4 vector";
    }
}

static void append_title(struct text *t, const struct embed_scene *s, const char *name)
{
    const char *type = s->single ? "float" : "double";
    if (s->plastic)
        text_append(t, "Restitution coefficient of elastic-plastic spheres that collide at an impact speed, for one "
                       "scene:\n");
    else if (law_is_sphere(&s->named))
        text_append(
            t, "Restitution coefficient of viscoelastic spheres that collide at an impact speed, for one scene:\n");
    else
        text_append(t,
                    "Restitution coefficient of bodies that collide at an impact speed by the contact law\n"
                    "%s, x(0) = 0, x'(0) = 1, for one scene:\n",
                    law_equation(&s->named).text);
    text_append(t, "    %s %s(%s speed);\n\n", type, name, type);
}

enum { EVIDENCE = 96 };

static bool proved_everywhere(const struct embed_proof *proof, const struct embed_scene *s)
{
    return proof->proved && !(proof->from > s->speed_min + s->origin);
}

/* How the tolerance is known */
static const char *evidence(char text[EVIDENCE], const struct embed_scene *s, const struct embed_proof *proof)
{
    if (!(proof->error <= s->tolerance) && isfinite(proof->error))
        snprintf(text, EVIDENCE, "sampled, below; proved: %s", emit_bound(proof->error).text);
    else if (proof->proved && !proved_everywhere(proof, s))
        snprintf(text, EVIDENCE, "proved from %.6g m/s on, sampled below that", proof->from);
    else
        snprintf(text, EVIDENCE, "%s, below", proof->proved ? "proved" : "sampled");
    return text;
}

static void append_sticking(struct text *t, const struct embed_request *request, const struct embed_scene *s)
{
    if (!s->pressed)
        return;
    char *sticking = arb_get_str(s->sticking_speed, 20, ARB_STR_NO_RADIUS);
    text_append(t,
                "A constant force presses the bodies together, and up to v_s = %s m/s (enclosed)\n"
                "they stay so: eps = 0.",
                sticking);
    if (embed_number(request, EMBED_SPEED_MIN) <= s->onset)
        text_append(t, " The function is 0 up to %.17g m/s, where eps is %.2g.", s->onset, s->samples.eps[0]);
    text_append(t, "\n");
    flint_free(sticking);
}

static void append_scene(struct text *t, const struct embed_request *request, const struct embed_scene *s,
                         const struct embed_proof *proof)
{
    char known[EVIDENCE];
    char *beta = arb_get_str(s->plastic ? s->yield_speed : s->beta_per_root, 20, ARB_STR_NO_RADIUS);
    char *liquid = arb_get_str(s->liquid_speed, 20, ARB_STR_NO_RADIUS);
    text_append(t, "Scene: %s m/s <= speed <= %s m/s; the contact ends at %s;\n", request->number[EMBED_SPEED_MIN].text,
                request->number[EMBED_SPEED_MAX].text,
                request->end == END_ZERO_FORCE ? "zero force (x'' = 0)" : "zero overlap (x = 0)");
    if (s->plastic)
        text_append(t, "v_y = %s m/s, the impact speed from which they yield%s.\n", beta,
                    s->onset > 0 || s->constant ? "; eps = 1 up to it" : "");
    else if (!s->by_speed)
        text_append(t, "beta = %s (speed/(m/s))^%s, from %.4g to %.4g.\n", beta,
                    ratio_power(law_speed_exponent(&s->law)).text, s->beta_min, s->beta_max);
    if (!arb_is_zero(s->liquid_speed))
        text_append(t,
                    "A liquid takes s = %s m/s on the way in and on the way out: with dry eps(v - s)\n"
                    "at the speed v - s, eps = (eps(v - s) (v - s) - s)/v.\n",
                    liquid);
    append_sticking(t, request, s);
    text_append(t,
                "Accuracy: relative error of eps at most %s, approximation and rounding together (%s).\n"
                "Outside: %s; negative or NaN -> NaN.\n\n",
                request->number[EMBED_TOLERANCE].text, evidence(known, s, proof),
                s->pressed ? "0 as above, otherwise the value at the nearer end, of +inf too"
                           : "the value at the nearer end, of speed 0 and +inf too");
    flint_free(liquid);
    flint_free(beta);
}

static void append_proof(struct text *t, const struct embed_scene *s, const struct embed_proof *proof)
{
    if (!isfinite(proof->rounding))
        return;
    const struct bound_text rounding = emit_bound(proof->rounding);
    if (!proof->proved)
        text_append(t, "Proved: rounding errors of %s at most, ", rounding.text);
    else if (proved_everywhere(proof, s))
        text_append(t, "Proved at every speed of the range: %s at most, of which rounding %s,\n",
                    emit_bound(proof->error).text, rounding.text);
    else
        text_append(t, "Proved from %.6g m/s on: %s at most, of which rounding %s,\n", proof->from,
                    emit_bound(proof->error).text, rounding.text);
    text_append(t, "with + - * / and sqrt rounded to nearest, products fused or not.\n");
}

static void append_choice(struct text *t, const struct embed_request *request, const struct embed_scene *s,
                          const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof)
{
    const struct embed_form *f = &form[chosen];
    char size[64];
    embed_form_size(size, sizeof size, f);
    text_append(t,
                "Chosen: %s, %s. Of what meets the tolerance it takes\n%s (--for %s).\n"
                "Largest error found %s, at %.6g m/s, of %d speeds even in their logarithm, sums of products rounded\n"
                "once and twice: sampled. %s\n",
                embed_family_name(chosen, s), size, rule_of_purpose(request->purpose),
                embed_purpose_names[request->purpose], emit_bound(f->error).text, f->error_at + f->origin,
                EMBED_SAMPLES, f->rows > 0 ? "No branch; one table." : "No branch, no table.");
    append_proof(t, s, proof);
    text_append(
        t, "\nThe cheapest of each kind. error: the largest found. ns are made from the operations and what they cost\n"
           "in a loop where that was measured (docs/embed.md): right as ratios. Division and square root run beside\n"
           "the others.\n\n");
    append_alternatives(t, s, form, chosen);
}

static void append_provenance(struct text *t, const struct embed_scene *s, const struct embed_proof *proof)
{
    if (s->by_speed) {
        text_append(t,
                    "\nFitted to and compared with a closed form in interval arithmetic; coefficients rounded once to "
                    "the type.\nC99, C++11, CUDA and HIP; needs math.h, stdint.h and string.h. docs/embed.md.\n\n");
        return;
    }
    if (s->constant) {
        text_append(t,
                    "\neps is that of one collision %s, enclosed (proved), or is given.\n"
                    "C99, C++11, CUDA and HIP; needs math.h, stdint.h and string.h. docs/embed.md.\n\n",
                    law_equation(&s->law).text);
        return;
    }
    text_append(
        t,
        "\nFitted to and compared with collisions %s%s enclosed to 76 bits or\n"
        "more (proved), which are interpolated to 1e-17 (%s); coefficients\n"
        "rounded once to the type. C99, C++11, CUDA and HIP; needs math.h, stdint.h and string.h. docs/embed.md.\n\n",
        law_equation(&s->law).text, s->pressed ? " + f" : "",
        proof->proved ? "sampled; the proof includes their proved error" : "sampled");
}

/* ---- the function ---- */

static const struct emit_fifth_root *root_of(struct emit_fifth_root *root, const struct embed_form *f)
{
    root->fifth = EMBED_ROOT_FIFTH;
    root->constant = EMBED_ROOT_CONSTANT;
    root->single_constant = EMBED_ROOT_SINGLE;
    root->seed = embed_root_seed;
    root->step = embed_root_step;
    root->degree = f->refinement;
    return root;
}

/* Defines the variable of the polynomials; returns its name. */
static const char *emit_variable(struct emit *e, const struct embed_form *f)
{
    struct emit_fifth_root root;
    switch (f->variable) {
    case SQRT_OF_SPEED:
        emit_let_sqrt(e, "x", "g");
        return "x";
    case FOURTH_ROOT_OF_SPEED:
        emit_let_sqrt(e, "half", "g");
        emit_let_sqrt(e, "x", "half");
        return "x";
    case FIFTH_ROOT_OF_SPEED:
        emit_let_fifth_root(e, "x", "g", root_of(&root, f));
        return "x";
    case TENTH_ROOT_OF_SPEED:
        emit_let_fifth_root(e, "y", "g", root_of(&root, f));
        emit_let_sqrt(e, "x", "y");
        return "x";
    default:
        return "g";
    }
}

static void emit_long_polynomial(struct emit *e, const char *name, const char *x, const double *c, slong degree)
{
    if (degree < EMBED_SPLIT)
        emit_let_polynomial(e, name, x, c, degree);
    else
        emit_let_split_polynomial(e, name, x, "xx", c, degree);
}

/* Up to the onset eps is 1, where spheres begin to yield, or 0, where bodies no longer stay together. */
static void emit_close_at_onset(struct emit *e, const struct embed_form *f, const char *numerator,
                                const char *denominator, bool vector)
{
    if (f->onset > 0)
        emit_let_above(e, "above_onset", "speed", f->onset, f->before, numerator, denominator);
    emit_function_close(e, "speed", f->onset > 0 ? "above_onset" : numerator, f->onset > 0 ? NULL : denominator,
                        vector);
}

static void emit_form(struct emit *e, const char *name, const struct embed_form *f, bool vector)
{
    emit_function_open(e, name, "speed");
    if (f->rows > 0)
        emit_table(e, "row", f->number, f->rows, f->numerator + 1);
    const bool constant = f->rows == 0 && f->numerator + f->denominator == 0;
    if (f->origin > 0)
        emit_let_less(e, "more", "speed", f->origin);
    if (!constant)
        emit_let_clamped(e, "g", f->origin > 0 ? "more" : "speed", f->speed_min, f->speed_max, vector);
    const char *x = constant ? "g" : emit_variable(e, f);
    if (f->rows > 0) {
        if (f->family == FAMILY_PIECES_SPEED)
            emit_let_row_of_bits(e, "i", "t", x, f->low_bits, f->first);
        else
            emit_let_row_of_grid(e, "i", "t", x, f->slope, f->shift);
        emit_let_row_polynomial(e, "eps", "row", "i", "t", f->numerator);
        emit_close_at_onset(e, f, "eps", NULL, vector);
    } else {
        const bool quotient = f->denominator > 0;
        if (FLINT_MAX(f->numerator, f->denominator) >= EMBED_SPLIT)
            emit_let_product(e, "xx", x, x);
        emit_long_polynomial(e, quotient ? "p" : "eps", x, f->number, f->numerator);
        if (quotient)
            emit_long_polynomial(e, "q", x, f->number + f->numerator + 1, f->denominator);
        emit_close_at_onset(e, f, quotient ? "p" : "eps", quotient ? "q" : NULL, vector);
    }
}

static void emit_macros(struct emit *e, const char *name, const struct embed_request *request)
{
    static const struct {
        const char *suffix;
        int which;
    } macros[] = {{"SPEED_MIN", EMBED_SPEED_MIN}, {"SPEED_MAX", EMBED_SPEED_MAX}, {"TOLERANCE", EMBED_TOLERANCE}};
    for (size_t i = 0; i < sizeof macros / sizeof *macros; i++) {
        char macro[NAME_MAX_HERE], value[NAME_MAX_HERE];
        snprintf(macro, sizeof macro, "%s_%s", name, macros[i].suffix);
        emit_capitals(macro);
        const int length = snprintf(value, sizeof value, "%.17g", embed_number(request, macros[i].which));
        if (!strpbrk(value, ".e"))
            snprintf(value + length, sizeof value - (size_t)length, ".0");
        emit_define(e, macro, value);
    }
}

void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof)
{
    const char *name = request->name ? request->name : default_name;
    char guard[NAME_MAX_HERE];
    snprintf(guard, sizeof guard, "%s_h", name);
    emit_capitals(guard);
    struct text *banner = xmalloc(sizeof *banner);
    banner->length = 0;
    append_title(banner, s, name);
    append_scene(banner, request, s, proof);
    append_choice(banner, request, s, form, chosen, proof);
    append_provenance(banner, s, proof);
    append_command(banner, request);

    struct emit e;
    emit_open(&e, file, guard, banner->text);
    e.single = s->single;
    fprintf(file, "\n%s\n", evaluator_inline);
    emit_macros(&e, name, request);
    emit_comment(&e, "eps at an impact speed in m/s");
    emit_form(&e, name, &form[chosen], request->purpose != PURPOSE_SCALAR);
    emit_close(&e);
    free(banner);
}

char *embed_failures(const struct embed_scene *s, const struct embed_form *form)
{
    struct text *t = xmalloc(sizeof *t);
    t->length = 0;
    t->text[0] = '\0';
    for (int i = 0; i < FAMILIES; i++)
        text_append(t, "%s%s: %s", i ? "; " : "", embed_family_name((enum embed_family)i, s), form[i].why);
    char *copy = xstrdup(t->text);
    free(t);
    return copy;
}
