/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/emit_c.h"

enum { NAME_MAX_HERE = 128 };

static const char default_name[] = "cor_scene_eps";

static void append_command(FILE *t, const struct embed_request *request)
{
    char *const options = embed_options(request, 85);
    fprintf(t, "Written by:  corgen embed%s \\\n                %s --type %s --for %s%s%s\n", options,
            embed_end_option(request), embed_type_names[request->type], embed_purpose_names[request->purpose],
            request->name ? " --name " : "", request->name ? request->name : "");
    fprintf(t, "Checked by:  the same command, whose output is the same to the byte\n");
    free(options);
}

static void append_alternatives(FILE *t, const struct embed_scene *s, const struct embed_form *form,
                                enum embed_family chosen)
{
    fprintf(t, "                                                            ns each\n"
               "  form                    size                   error    scalar vector  operations\n");
    for (int i = 0; i < FAMILIES; i++) {
        const struct embed_form *f = &form[i];
        fprintf(t, "%c %-23s ", i == (int)chosen ? '>' : ' ', embed_family_name((enum embed_family)i, s));
        if (f->found) {
            char size[64];
            embed_form_size(size, sizeof size, f);
            fprintf(t, "%-22s %s  %6.2f %6.2f  ", size, emit_bound(f->error).text, f->cost[USE_SCALAR],
                    f->cost[USE_ARRAY]);
            const char *before = "";
            for (int op = 0; op < OPERATIONS; op++)
                if (f->operations[op] > 0) {
                    fprintf(t, "%s%d %s", before, f->operations[op], embed_operation_names[op]);
                    before = ", ";
                }
            fprintf(t, "\n");
        } else {
            fprintf(t, "%s\n", f->why);
        }
    }
}

static void append_title(FILE *t, const struct embed_scene *s, const char *name)
{
    const char *type = s->single ? "float" : "double";
    if (s->own.law)
        fprintf(t, "Restitution coefficient of a given law at an impact speed, for one scene:\n");
    else if (s->plastic || law_is_sphere(&s->named))
        fprintf(t, "Restitution coefficient of %s spheres that collide at an impact speed, for one scene:\n",
                s->plastic ? "elastic-plastic" : "viscoelastic");
    else
        fprintf(t,
                "Restitution coefficient of bodies that collide at an impact speed by the contact law\n"
                "%s, x(0) = 0, x'(0) = 1, for one scene:\n",
                law_equation(&s->named).text);
    fprintf(t, "    %s %s(%s speed);\n\n", type, name, type);
}

static bool proved_everywhere(const struct embed_proof *proof, const struct embed_scene *s)
{
    return proof->proved && !(proof->from > s->speed_min + s->origin);
}

/* Returns the middle of a ball to 20 digits */
static struct bound_text middle_text(const arb_t x)
{
    struct bound_text text;
    char *const digits = arb_get_str(x, 20, ARB_STR_NO_RADIUS);
    snprintf(text.text, sizeof text.text, "%s", digits);
    flint_free(digits);
    return text;
}

static void append_scene(FILE *t, const struct embed_request *request, const struct embed_scene *s,
                         const struct embed_proof *proof)
{
    static const char *const end[] = {"zero overlap (x = 0);", "zero force (x'' = 0);",
                                      "the surface (x = 0, by free flight);"};
    fprintf(t, "Scene: %s m/s <= speed <= %s m/s; %s%s\n", request->number[EMBED_SPEED_MIN].text,
            request->number[EMBED_SPEED_MAX].text, s->own.law ? "" : "the contact ends at ",
            s->own.law ? s->own.text : end[request->end]);
    if (s->own.law && s->onset > 0)
        fprintf(t, "eps = 1 up to %.17g m/s.\n", s->onset);
    else if (s->plastic)
        fprintf(t, "v_y = %s m/s: the bodies yield above this impact speed%s.\n", middle_text(s->yield_speed).text,
                s->onset > 0 || s->constant ? "; eps = 1 up to v_y" : "");
    else if (!s->by_speed)
        fprintf(t, "beta = %s (speed/(m/s))^%s, from %.4g to %.4g.\n", middle_text(s->beta_per_root).text,
                ratio_power(law_speed_exponent(&s->law)).text, s->beta_min, s->beta_max);
    if (!arb_is_zero(s->liquid_speed))
        fprintf(t,
                "A liquid removes s = %s m/s on the way in and on the way out: with dry eps(v - s)\n"
                "at the speed v - s, eps = (eps(v - s) (v - s) - s)/v.\n",
                middle_text(s->liquid_speed).text);
    if (s->pressed)
        fprintf(t, "A constant force holds the bodies together up to v_s = %s m/s (enclosed):\neps is 0 there.",
                middle_text(s->sticking_speed).text);
    if (s->pressed && embed_number(request, EMBED_SPEED_MIN) <= s->onset)
        fprintf(t, "\nThe function returns 0 up to %.17g m/s. The exact eps at this speed is %.2g.", s->onset,
                s->samples.eps[0]);
    fprintf(t, "%sAccuracy: relative error of eps at most %s, approximation and rounding together (",
            s->pressed ? "\n" : "", request->number[EMBED_TOLERANCE].text);
    if (!(proof->error <= s->tolerance) && isfinite(proof->error))
        fprintf(t, "sampled, below; proved: %s", emit_bound(proof->error).text);
    else if (proof->proved && !proved_everywhere(proof, s))
        fprintf(t, "proved for %.6g m/s and above, sampled below", proof->from);
    else
        fprintf(t, "%s, below", proof->proved ? "proved" : "sampled");
    fprintf(t, ").\nOutside: %s; negative or NaN -> NaN.\n\n",
            s->pressed ? "0 as above, otherwise the value at the nearer end, also for +inf"
                       : "the value at the nearer end, also for speed 0 and +inf");
}

static void append_choice(FILE *t, const struct embed_request *request, const struct embed_scene *s,
                          const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof)
{
    static const char balanced[] =
        "the least time for one separate call and four numbers of a vectorised loop,\nscalar + 4 vector";
    static const char *const rule[] = {[PURPOSE_BALANCED] = balanced,
                                       [PURPOSE_SCALAR] = "the least time for separate calls, column scalar",
                                       [PURPOSE_ARRAY] = "the least time in vectorised loops, column vector",
                                       [PURPOSE_REBOUND] = "the least time for separate calls, column scalar"};
    const struct embed_form *f = &form[chosen];
    char size[64];
    embed_form_size(size, sizeof size, f);
    fprintf(t,
            "Chosen: %s, %s. Of the forms that meet the tolerance, it needs\n%s (--for %s).\n"
            "Largest error found %s, at %.6g m/s, at %d speeds with equal ratios, sums of products rounded\n"
            "once and twice: sampled. %s\n",
            embed_family_name(chosen, s), size, rule[request->purpose], embed_purpose_names[request->purpose],
            emit_bound(f->error).text, f->error_at + f->origin, EMBED_SAMPLES,
            f->knot       ? "A search in a table."
            : f->rows > 0 ? "No branch; one table."
                          : "No branch, no table.");
    if (isfinite(proof->rounding)) {
        if (!proof->proved)
            fprintf(t, "Proved: rounding errors of ");
        else if (proved_everywhere(proof, s))
            fprintf(t, "Proved at every speed of the range: %s at most, of which rounding ",
                    emit_bound(proof->error).text);
        else
            fprintf(t, "Proved for %.6g m/s and above: %s at most, of which rounding ", proof->from,
                    emit_bound(proof->error).text);
        fprintf(t, "%s%s,%cwith + - * / and sqrt rounded to nearest, products fused or not.\n",
                emit_bound(proof->rounding).text, proof->proved ? "" : " at most", proof->proved ? '\n' : ' ');
    }
    fprintf(t, "\nThe cheapest of each kind. error: the largest found. ns follow from the operations and their cost,\n"
               "measured in a loop (docs/embed.md); only their ratios are right on other processors. Division and\n"
               "square root run in parallel with the others.\n\n");
    append_alternatives(t, s, form, chosen);
}

static void append_provenance(FILE *t, const struct embed_scene *s, const struct embed_proof *proof)
{
    const char *const dialects = "C99, C++11, CUDA and HIP; needs math.h, stdint.h and string.h. docs/embed.md.\n\n";
    if (s->by_speed)
        fprintf(t, "\nFitted to and compared with a closed form in interval arithmetic; coefficients rounded once to "
                   "the type.\n");
    else if (s->constant)
        fprintf(t, "\neps is a given number, or comes from one enclosed collision %s (proved).\n",
                law_equation(&s->law).text);
    else
        fprintf(t,
                "\nFitted to and compared with collisions %s%s, enclosed to 76 bits or\n"
                "more (proved) and interpolated to 1e-17 (%s). Coefficients are\n"
                "rounded once to the type. ",
                law_equation(&s->law).text, s->pressed ? " + f" : "",
                proof->proved ? "sampled; the proof includes a proved error" : "sampled");
    fputs(dialects, t);
}

/* ---- the function ---- */

/* Writes a variable with the bits of another one. type: a text for emit_lines */
static void emit_copy(struct emit *e, const char *type, const char *name, const char *from)
{
    emit_lines(e, "    ");
    emit_lines(e, type);
    emit_lines(e, " $s;\n    memcpy(&$s, &$s, sizeof $s);\n", name, name, from, name);
}

/* Writes lines that limit x to the range and turn a NaN into a number in the range. For a single x they compare real
 * numbers, which is fastest. If `vector` is true, they compare the bits as integers, which compilers vectorise. In a
 * loop, a comparison of real numbers may trap and would become a branch. */
static void emit_clamped(struct emit *e, const struct embed_form *f, const char *x, bool vector)
{
    if (!vector) {
        emit_lines(e, "    const $T above = $s > $x ? $s : $x;\n    const $T g = above < $x ? above : $x;\n", x,
                   f->speed_min, x, f->speed_min, f->speed_max, f->speed_max);
        return;
    }
    emit_lines(e,
               "    /* as whole numbers, so that loops over it become vector code */\n"
               "    const int$B_t low = INT$B_C($b), high = INT$B_C($b);\n",
               f->speed_min, f->speed_max);
    emit_copy(e, "int$B_t", "whole_speed", x);
    emit_lines(e, "    const int$B_t above = whole_speed > low ? whole_speed : low;\n"
                  "    const int$B_t inside = above < high ? above : high;\n");
    emit_copy(e, "$T", "g", "inside");
}

static void emit_start(struct emit *e, const char *name)
{
    emit_lines(e, "    /* g^(-1/5), 3 % off: minus a fifth of the bits */\n");
    emit_copy(e, "uint$B_t", "bits", "g");
    if (e->single) {
        fprintf(e->file, "    const uint32_t fifth = %uu - bits / 5u;\n", EMBED_ROOT_SINGLE);
        emit_copy(e, "float", name, "fifth");
    } else {
        /* the double 2^52 + n holds the integer n in its low bits */
        emit_lines(e, "    const uint64_t upper = (bits >> 32) | UINT64_C(0x4330000000000000);\n");
        emit_copy(e, "double", "number", "upper");
        emit_lines(e, "    const double fifth = $x - $x * number;\n", EMBED_ROOT_CONSTANT, EMBED_ROOT_FIFTH);
        emit_copy(e, "uint64_t", "shifted", "fifth");
        emit_lines(e, "    shifted <<= 32;\n");
        emit_copy(e, "double", name, "shifted");
    }
    emit_lines(e, "    /* with off = 1 - g guess^5: g^(-1/5) = guess (1 - off)^(-1/5) */\n");
}

static void emit_step(struct emit *e, const struct embed_form *f, const struct embed_program *p,
                      const struct embed_step *s)
{
    static const char *const texts[] = {[STEP_SQRT] = "    const $T $s = sqrt$F($s);\n",
                                        [STEP_MUL] = "    const $T $s = $s * $s;\n",
                                        [STEP_MUL_ADD] = "    const $T $s = $s + $s * $s;\n",
                                        [STEP_OFF] = "    const $T $s = 1.0$F - $s * $s;\n"};
    const char *const x = p->step[s->x].name, *const y = p->step[s->y].name;
    int half = 1;                                      /* the first step of a search */
    if (strchr(s->name, ' ') || s->code == STEP_CLAMP) /* this step has no line, or emit_clamped wrote it */
        return;
    switch (s->code) {
    case STEP_START:
        emit_start(e, s->name);
        break;
    case STEP_ROW_OF_BITS:
        emit_copy(e, "uint$B_t", "bits", x);
        emit_lines(e, "    const uint$B_t upper = bits >> $d;\n    const uint$B_t start_bits = upper << $d;\n",
                   f->low_bits, f->low_bits);
        emit_copy(e, "$T", "start", "start_bits");
        emit_lines(
            e, f->single ? "    const uint32_t i = upper - $bu;\n" : "    const uint64_t i = upper - UINT64_C($b);\n",
            embed_from_bits(f, f->first));
        emit_lines(e, "    const $T $s = $s - start;\n", s->name, x);
        break;
    case STEP_ROW_OF_SEARCH:
        while (2 * half < f->rows)
            half *= 2;
        emit_lines(e,
                   "    int i = 0;\n    for (int step = $d; step > 0; step /= 2)\n"
                   "        if (i + step < $d && $s >= knot[i + step][0])\n            i += step;\n"
                   "    const $T $s = $s - knot[i][0];\n",
                   half, (int)f->rows, x, s->name, x);
        break;
    case STEP_ROW_OF_PLACE:
        emit_lines(e,
                   "    const $T place = $s * $x + $x;\n    const int i = (int)place;\n"
                   "    const $T $s = place - $si;\n",
                   x, f->slope, f->shift, s->name, f->single ? "(float)" : "");
        break;
    case STEP_HORNER:
        if (s->c)
            emit_let_polynomial(e, s->name, x, s->c, s->degree, s->stride);
        else
            emit_let_row_polynomial(e, s->name, "row", "i", x, s->degree);
        break;
    case STEP_MUL_ADD:
        emit_lines(e, texts[s->code], s->name, p->step[s->z].name, x, y);
        break;
    default:
        emit_lines(e, texts[s->code], s->name, x, y);
    }
}

/* Writes the return of the result, or of NaN if the speed is negative or NaN. Up to the onset eps is 1 (spheres that
 * yield above it) or 0 (bodies that stay together). */
static void emit_return(struct emit *e, const struct embed_form *f, const char *result, bool vector)
{
    if (f->onset > 0) {
        emit_lines(e, "    const $T above_onset = speed <= $x ? $x : $s;\n", f->onset, f->before, result);
        result = "above_onset";
    }
    if (!vector) {
        emit_lines(e, "    return speed >= 0 ? $s : $sNAN;\n}\n", result, f->single ? "" : "(double)");
        return;
    }
    emit_lines(e, "    $T value = $s;\n    /* all bits set is NaN */\n    const int$B_t good = speed >= 0;\n", result);
    emit_copy(e, "int$B_t", "whole", "value");
    emit_lines(e, "    whole |= good - 1;\n    memcpy(&value, &whole, sizeof value);\n    return value;\n}\n");
}

static void emit_form(struct emit *e, const char *name, const struct embed_form *f, bool vector)
{
    const struct embed_program p = embed_program_of(f);
    emit_lines(e, "COR_INLINE $T $s($T speed)\n{\n", name);
    if (f->rows > 0)
        emit_table(e, "row", f->number, f->rows, f->numerator + 1);
    if (f->knot)
        emit_table(e, "knot", f->knot, f->rows, 1);
    if (f->origin > 0)
        emit_lines(e, "    const $T more = speed - $x;\n", f->origin);
    if (f->rows > 0 || f->numerator + f->denominator > 0)
        emit_clamped(e, f, f->origin > 0 ? "more" : "speed", vector);
    for (int i = 0; i < p.count; i++)
        emit_step(e, f, &p, &p.step[i]);
    emit_return(e, f, p.step[p.count - 1].name, vector);
}

void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof)
{
    const char *name = request->name ? request->name : default_name;
    char guard[NAME_MAX_HERE];
    snprintf(guard, sizeof guard, "%s_h", name);
    char *text = NULL;
    size_t size;
    FILE *const banner = open_memstream(&text, &size);
    append_title(banner, s, name);
    append_scene(banner, request, s, proof);
    append_choice(banner, request, s, form, chosen, proof);
    append_provenance(banner, s, proof);
    append_command(banner, request);
    fclose(banner);

    struct emit e;
    emit_open(&e, file, guard, text);
    e.single = s->single;
    if (!request->name)
        fprintf(file,
                "#ifdef COR_SCENE_H\n#error \"cor/scene.h has another %s: choose another name for this function by "
                "corgen embed --name\"\n#endif\n",
                name);
    fprintf(file, "\n%s\n", evaluator_inline);
    for (int i = 0; i < 3; i++) {
        static const char *const suffix[] = {"SPEED_MIN", "SPEED_MAX", "TOLERANCE"};
        char value[NAME_MAX_HERE];
        snprintf(value, sizeof value, "%.17g", embed_number(request, EMBED_SPEED_MIN + i));
        emit_lines(&e, "#define $S_$s $s$s\n", name, suffix[i], value, strpbrk(value, ".e") ? "" : ".0");
    }
    emit_comment(&e, "eps at an impact speed in m/s");
    emit_form(&e, name, &form[chosen], request->purpose == PURPOSE_BALANCED || request->purpose == PURPOSE_ARRAY);
    if (request->purpose == PURPOSE_REBOUND)
        emit_lines(&e,
                   "\n/* Of REBOUND: r->coefficient_of_restitution = $s_callback, with v in m/s */\n"
                   "struct reb_simulation;\n"
                   "COR_INLINE double $s_callback(const struct reb_simulation *r, double v)\n{\n"
                   "    (void)r;\n    return (double)$s(($T)(v < 0 ? -v : v));\n}\n",
                   name, name, name);
    emit_close(&e);
    free(text);
}

char *embed_failures(const struct embed_scene *s, const struct embed_form *form)
{
    char *text = NULL;
    size_t size;
    FILE *const t = open_memstream(&text, &size);
    for (int i = 0; i < FAMILIES; i++)
        fprintf(t, "%s%s: %s", i ? "; " : "", embed_family_name((enum embed_family)i, s), form[i].why);
    fclose(t);
    return text;
}
