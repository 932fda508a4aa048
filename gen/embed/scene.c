/* SPDX-License-Identifier: MIT */
#include "embed/scene.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approximation/interpolant.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"
#include "support/parallel.h"

/* For beta >= 7, eps at zero overlap is h*^5 beta^-5 with relative error EMBED_FAR_ERROR (form.h). At zero force the
 * interpolant in sqrt(beta) is used for beta < 16.9, the interpolant in ln(beta) for ln(beta) < 9.99, and three orders
 * in beta^(-5/3) above. */
#define OVERLAP_FAR 7.0
#define FORCE_FAR 16.9
#define LOG_FAR 9.99
/* Smallest useful eps of a double and of a float */
#define EPS_LEAST 1e-250
#define EPS_LEAST_FLOAT 1e-30

double embed_rounded(const struct embed_scene *s, double x)
{
    return s->single ? (double)(float)x : x;
}

/* ---- eps ---- */

/* Computes eps of spheres. At zero force, for u = ln(beta) >= LOG_FAR and mu = beta^(-5/3), eps is mu (((a_8 u + ...)
 * mu + (a_4 u + ...)) mu + a_1 u + a_0). The interpolant's samples count as exact, so the radius covers only rounding
 * errors of this function. */
static void eps_of_beta(arb_t eps, const struct embed_scene *s, const arb_t beta)
{
    static const int first[] = {0, 2, 5, INTERPOLANT_FAR}; /* indices of the first coefficients: a_0, ... */
    const double b = ball_middle(beta);
    const bool overlap = s->end == COR_END_ZERO_OVERLAP;
    LOCAL(arb, z, mu, order, y);
    if (overlap && b >= OVERLAP_FAR) {
        LET(eps, EMBED_BITS, "s->h_star_5/beta^5", s->h_star_5, beta);
    } else if (b < FORCE_FAR) {
        arb_sqrt(z, beta, EMBED_BITS);
        interpolant_at(eps, s->interpolant, overlap ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE, INTERVAL_ROOT, z, EMBED_BITS);
    } else {
        arb_log(z, beta, EMBED_BITS);
        LET(mu, EMBED_BITS, "beta^(-5/3)", beta);
        if (log(b) < LOG_FAR)
            interpolant_tail(y, s->interpolant, EPS_ZERO_FORCE, INTERVAL_LOG, z, EMBED_BITS);
        for (int i = 2; i >= 0 && !(log(b) < LOG_FAR); i--) {
            _arb_poly_evaluate(order, interpolant_far(s->interpolant, EPS_ZERO_FORCE) + first[i],
                               first[i + 1] - first[i], z, EMBED_BITS);
            LET(y, EMBED_BITS, "y*mu + order", y, mu, order);
        }
        arb_mul(eps, y, mu, EMBED_BITS);
    }
}

/* Refuses a range of speeds that begins or ends too low. fact: the behaviour of the bodies up to the speed `limit` */
static int refuse_speed(const char *option, const char *fact, double limit)
{
    return usage_error("--%s: %s up to %.6g m/s; give a speed above it", option, fact, limit);
}

static bool is_wet(const struct embed_scene *s)
{
    return !arb_is_zero(s->liquid_speed);
}

void embed_scene_beta(arb_t beta, const struct embed_scene *s, const arb_t speed, bool enclosed)
{
    const struct ratio q = law_speed_exponent(&s->law);
    const arb_srcptr beta_per_root = enclosed ? s->beta_enclosed : s->beta_per_root;
    LET(beta, EMBED_BITS, "(s->origin + speed - s->liquid_speed)^q*beta_per_root", s->origin, speed, s->liquid_speed, q,
        beta_per_root);
}

static enum quantity quantity_of(const struct embed_scene *s)
{
    return s->end == COR_END_ZERO_OVERLAP ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE;
}

void embed_scene_eps(arb_t eps, const struct embed_scene *s, const arb_t speed)
{
    LOCAL(arb, beta);
    embed_scene_beta(beta, s, speed, false);
    if (s->own.law)
        own_law_eps(eps, &s->own, speed, EMBED_BITS);
    else if (s->by_speed && s->plastic && !arb_le(beta, s->yield_speed))
        embed_elastic_plastic_eps(eps, beta, s->yield_speed, EMBED_BITS);
    else if (s->constant || s->by_speed)
        arb_set(eps, s->eps);
    else if (law_is_sphere(&s->law) && !s->pressed)
        eps_of_beta(eps, s, beta);
    else
        interpolant_at_beta(eps, s->interpolant, quantity_of(s), beta, EMBED_BITS);
    if (is_wet(s))
        LET(eps, EMBED_BITS, "(eps*(speed - s->liquid_speed) - s->liquid_speed)/speed", eps, speed, s->liquid_speed);
}

/* ---- the scene ---- */

/* Computes sample i: eps as a double, and the rest of eps */
static void take_sample(void *context, slong i)
{
    struct embed_scene *const s = context;
    struct embed_samples *const samples = &s->samples;
    const double place = (double)i / (EMBED_SAMPLES - 1);
    const double speed =
        i + 1 < EMBED_SAMPLES ? embed_rounded(s, s->speed_min * pow(s->speed_max / s->speed_min, place)) : s->speed_max;
    LOCAL(arb, g, eps);
    samples->speed[i] = fmin(fmax(speed, s->speed_min), s->speed_max);
    arb_set_d(g, samples->speed[i]);
    embed_scene_eps(eps, s, g);
    samples->eps[i] = ball_middle(eps);
    arb_set_d(g, samples->eps[i]);
    arb_sub(eps, eps, g, EMBED_BITS);
    samples->rest[i] = ball_middle(eps);
}

static void take_samples(struct embed_scene *s)
{
    struct embed_samples *const samples = &s->samples;
    samples->speed = xmalloc(3 * EMBED_SAMPLES * sizeof *samples->speed);
    samples->eps = samples->speed + EMBED_SAMPLES;
    samples->rest = samples->eps + EMBED_SAMPLES;
    parallel_for(take_sample, s, EMBED_SAMPLES, "samples");
    s->slope = 0;
    const slong step = EMBED_SAMPLES / 64;
    for (slong i = step; i < EMBED_SAMPLES; i += step)
        s->slope = fmax(s->slope, fabs(5 * log(samples->eps[i - step] / samples->eps[i]) /
                                       log(samples->speed[i] / samples->speed[i - step])));
}

/* Prepares spheres without a constant force. */
static int scene_collide(struct embed_scene *s)
{
    const bool overlap = s->end == COR_END_ZERO_OVERLAP;
    if (!overlap || s->beta_min < OVERLAP_FAR) {
        s->interpolant = interpolant_new(&interpolant_sphere_proof, s->beta_min * (1 - 1e-9),
                                         overlap ? fmin(s->beta_max, OVERLAP_FAR) : s->beta_max * (1 + 1e-9));
        if (!s->interpolant)
            return STATUS_FAILED;
    }
    if (series_eps(s->series, &s->series_root, s->end, EMBED_SERIES, &s->law, EMBED_BITS) ||
        (overlap && collision_h_star(s->h_star_5, EMBED_BITS / 2)))
        return STATUS_FAILED;
    arb_pow_ui(s->h_star_5, s->h_star_5, 5, EMBED_BITS);
    return STATUS_OK;
}

/* ---- a constant force ---- */

/* The interpolant begins where the speed exceeds the sticking speed by this fraction. There, ln(beta) differs from its
 * value at the sticking speed by q times this fraction. */
#define STICKING_MARGIN 1e-10
/* Distances d in ln(beta) are from the sticking speed, where eps has a branch point. An interval that begins at d has
 * length d, but at most LONGEST_PRESSED. For d < NEAR_STICKING it has length 3 d and more points, because few proofs
 * reach these intervals (STICKING_PROVED). */
#define LONGEST_PRESSED 0.5
#define NEAR_STICKING 1e-3
enum { PRESSED_POINTS = 30, NEAR_POINTS = 38, PRESSED_BITS = 76, STICKING_BITS = 100, MOST_PRESSED = 200 };

/* Returns the neighbour of x >= 0 in the scene's type, in the direction of `towards`. */
static double neighbour_of(const struct embed_scene *s, double x, double towards)
{
    return s->single ? (double)nextafterf((float)x, (float)towards) : nextafter(x, towards);
}

/* Returns the largest number of the scene's type that is not above x */
static double rounded_down(const struct embed_scene *s, double x)
{
    const double y = embed_rounded(s, x);
    return y > x ? neighbour_of(s, y, 0) : y;
}

/* Sets press, the c of the force f = c beta^(-2a/n), and the sticking speed, from the force f_1 and the beta_1 at 1
 * m/s. In units in which the force is 1, the damping is beta_1 f_1^(n/(2a)) at every speed, and the unit of speed is
 * f_1^((a+1)/(2a)) m/s. Also sets origin, onset and speed_min. The origin is a multiple of the last place of speed_max,
 * so v - origin is exact for v <= speed_max. */
static int set_pressing(struct embed_scene *s, const arb_t force)
{
    const struct ratio a = law_elastic(&s->law), n = law_fall_power(&s->law), q = law_speed_exponent(&s->law);
    LOCAL(arb, damping, x);
    LET(s->press, EMBED_BITS, "s->beta_enclosed^(2*a/n)*force", s->beta_enclosed, a, n, force);
    LET(damping, EMBED_BITS, "force^(n/(2*a))*s->beta_enclosed", force, n, a, s->beta_enclosed);
    if (collision_sticking_speed(s->sticking_speed, damping, &s->law, (int)s->end, STICKING_BITS))
        return STATUS_FAILED;
    LET(s->sticking_speed, EMBED_BITS, "s->sticking_speed*force^((a + 1)/(2*a))", s->sticking_speed, force, a);
    LET(x, EMBED_BITS, "log(s->sticking_speed^q*s->beta_enclosed)", s->sticking_speed, q, s->beta_enclosed);
    s->sticking_log = ball_middle(x);
    const double sticking = arf_get_d(arb_midref(s->sticking_speed), ARF_RND_FLOOR);
    const double below = rounded_down(s, sticking), unit = s->speed_max - neighbour_of(s, s->speed_max, 0);
    double first = embed_rounded(s, sticking * (1 + STICKING_MARGIN));
    while (first < sticking * (1 + STICKING_MARGIN))
        first = neighbour_of(s, first, HUGE_VAL);
    if (!(s->speed_max > first))
        return refuse_speed("speed-max", "the bodies stay together, and eps is 0,", sticking);
    s->onset = s->speed_min > first ? below : neighbour_of(s, first, 0);
    s->origin = floor(below / unit) * unit;
    s->speed_min = fmax(s->speed_min, first) - s->origin;
    s->speed_max -= s->origin;
    return STATUS_OK;
}

/* Sets the intervals in u = ln(beta), in ascending order. They begin or end next to u_s, the sticking speed's u. */
static void pressed_layout(struct embed_scene *s)
{
    const bool force = s->end == COR_END_ZERO_FORCE && law_force_ends(&s->law),
               rises = law_speed_exponent(&s->law).num > 0;
    const double u_s = s->sticking_log, beyond = 1e-9;
    const double begin = rises ? log(s->beta_min) : log(s->beta_max), end = rises ? log(s->beta_max) : log(s->beta_min);
    struct interval *const list = xmalloc(MOST_PRESSED * sizeof *list);
    int count = 0;
    /* the intervals reach slightly beyond the first and the last speed */
    double distance = fabs(begin - u_s) * (1 - 1e-4);
    const double last = fabs(end - u_s) + beyond;
    while (distance < last && count < MOST_PRESSED) {
        const bool near = distance < NEAR_STICKING;
        const double next = fmin(distance + fmin((near ? 3 : 1) * distance, LONGEST_PRESSED), last * (1 + beyond));
        list[count++] = (struct interval){INTERVAL_LOG,
                                          rises ? u_s + distance : u_s - next,
                                          rises ? u_s + next : u_s - distance,
                                          near ? NEAR_POINTS : PRESSED_POINTS,
                                          PRESSED_BITS,
                                          FORM_LOG,
                                          1u << (force ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP)};
        distance = next;
    }
    for (int i = 0; !rises && i < count / 2; i++) {
        const struct interval swapped = list[i];
        list[i] = list[count - 1 - i];
        list[count - 1 - i] = swapped;
    }
    s->layout = (struct law_layout){
        .interpolant =
            {.law = s->law, .root = 1, .interval = list, .intervals = count, .press = s->press, .press_log = u_s},
        .threshold = HUGE_VAL};
}

/* ---- another law ---- */

/* Largest relative error of the interpolant between its samples */
#define INTERPOLANT_LIMIT 1e-17
enum { CHECK_POINTS = 4, ATTEMPTS = 3 };

static int scene_collide_law(struct embed_scene *s)
{
    const struct ratio q = law_speed_exponent(&s->law);
    double error = INFINITY;
    if (s->pressed)
        pressed_layout(s);
    else if (law_layout_init(&s->layout, &s->law))
        return STATUS_FAILED;
    else if (s->end == COR_END_ZERO_OVERLAP && s->beta_max >= s->layout.threshold)
        return refuse_speed("speed-min", "the bodies stay together at zero overlap, and eps is 0,",
                            s->speed_min * pow(s->layout.threshold / s->beta_max, 1 / ratio_double(q)));
    else
        law_layout_restrict(&s->layout, quantity_of(s), s->beta_min);
    for (int attempt = 0; attempt < ATTEMPTS && error > INTERPOLANT_LIMIT; attempt++) {
        interpolant_free(s->interpolant); /* free the interpolant before the layout changes */
        if (attempt > 0)
            law_layout_refine(&s->layout);
        s->interpolant = interpolant_new(&s->layout.interpolant, s->beta_min * (1 - 1e-9), s->beta_max * (1 + 1e-9));
        if (!s->interpolant || interpolant_check(&error, s->interpolant, CHECK_POINTS) != STATUS_OK)
            return STATUS_FAILED;
    }
    return error <= INTERPOLANT_LIMIT ? STATUS_OK
                                      : fail("the interpolant of the collision has an error of %.1e", error);
}

/* Sets an eps that does not depend on the speed: the number of --restitution as written, or a computed one. */
static int scene_collide_once(struct embed_scene *s, const struct embed_request *request)
{
    if (!embed_given(request, COR_SCENE_RESTITUTION))
        return embed_contact_eps(s->eps, s->beta_per_root, s->press, &s->law, (int)s->end, EMBED_BITS / 2);
    arb_set_fmpq(s->eps, request->number[COR_SCENE_RESTITUTION].value, EMBED_BITS);
    return STATUS_OK;
}

static int scene_prepare(struct embed_scene *s, const struct embed_request *request)
{
    const double per_root = ball_middle(s->beta_per_root);
    const double q = ratio_double(law_speed_exponent(&s->law));
    const double lost = ball_middle(s->liquid_speed) - s->origin;
    const double slow = per_root * pow(s->speed_min - lost, q), fast = per_root * pow(s->speed_max - lost, q);
    s->beta_min = fmin(slow, fast);
    s->beta_max = fmax(slow, fast);
    if (!s->constant && !s->own.law && !(s->beta_min > 1e-60 && s->beta_max < 1e60))
        return fail("beta is %.3g to %.3g at these speeds; allowed: 1e-60 to 1e60", s->beta_min, s->beta_max);
    const int status = s->by_speed                             ? STATUS_OK
                       : s->constant                           ? scene_collide_once(s, request)
                       : law_is_sphere(&s->law) && !s->pressed ? scene_collide(s)
                                                               : scene_collide_law(s);
    if (status != STATUS_OK)
        return status;
    take_samples(s);
    const bool falls = s->samples.eps[0] > s->samples.eps[EMBED_SAMPLES - 1];
    const double least = s->samples.eps[falls ? EMBED_SAMPLES - 1 : 0];
    if (!(least > (s->single ? EPS_LEAST_FLOAT : EPS_LEAST)))
        return fail("eps falls to %.3g at --speed-%s, %s%.3g%s: too small for a %s; use a narrower range of speeds",
                    least, falls ? "max" : "min", s->by_speed ? "" : "beta = ", s->beta_max, s->by_speed ? " m/s" : "",
                    s->single ? "float" : "double");
    return STATUS_OK;
}

static void set_by_speed(struct embed_scene *s)
{
    s->by_speed = true;
    s->constant = false;
    s->law = law_sphere;
    s->law.damping = s->law.elastic; /* q = 1 */
    arb_one(s->eps);
    arb_one(s->beta_per_root);
    arb_one(s->beta_enclosed);
}

/* Sets the onset and the first speed of a scene in which eps is 1 up to the speed `below`. */
static int set_onset(struct embed_scene *s, double below)
{
    s->constant = s->speed_max <= below;
    if (s->speed_min > below || s->constant)
        return STATUS_OK;
    s->onset = rounded_down(s, below);
    s->speed_min = neighbour_of(s, s->onset, HUGE_VAL);
    return s->speed_min < s->speed_max ? STATUS_OK : refuse_speed("speed-max", "eps is 1", below);
}

/* Prepares elastic-plastic spheres, or a constant eps in a liquid. Without a liquid, eps is a closed form of the
 * speed. */
static int scene_by_speed(struct embed_scene *s, const struct embed_request *request)
{
    set_by_speed(s);
    const int status = s->plastic ? STATUS_OK : scene_collide_once(s, request);
    if (status != STATUS_OK || !s->plastic)
        return status;
    LOCAL(arb, onset);
    arb_add(onset, s->yield_speed, s->liquid_speed, EMBED_BITS);
    const double below = ball_end(onset, false);
    if (is_wet(s) && !(s->speed_min > below * (1 + 1e-15)))
        return refuse_speed("speed-min", "bodies of --law elastic-plastic in a liquid do not yield", below);
    return set_onset(s, below);
}

static int scene_own(struct embed_scene *s, const struct embed_request *request)
{
    int status = own_law_check(&s->own, embed_number(request, EMBED_SPEED_MIN), embed_number(request, EMBED_SPEED_MAX));
    const fmpq *const b = s->own.number + 1;
    LOCAL(arb, onset);
    set_by_speed(s);
    own_law_onset(onset, &s->own, EMBED_BITS);
    const double below = ball_end(onset, false);
    if (s->own.law == EMBED_LAW_POWER && fmpq_is_zero(b)) {
        s->constant = true;
        own_law_eps(s->eps, &s->own, s->eps, EMBED_BITS);
    } else if (s->own.law == EMBED_LAW_POWER && fmpq_sgn(b) < 0 && !(s->speed_max < below)) {
        status = usage_error(
            "--speed-max: eps reaches 1 at %.6g m/s, because --exponent is negative; give a speed below it", below);
    } else if (s->own.law == EMBED_LAW_POWER && fmpq_sgn(b) > 0 && status == STATUS_OK) {
        status = set_onset(s, below);
    }
    if (s->own.rows == 0 || status != STATUS_OK)
        return status;
    double end = 0;
    slong row = own_law_row(&end, &s->own, log(s->speed_min));
    s->knot = xmalloc((size_t)(s->own.rows - row) * sizeof *s->knot);
    while (row < s->own.rows && (s->knots < 2 || s->knot[s->knots - 1] < s->speed_max))
        s->knot[s->knots++] = embed_rounded(s, s->own.speed[row++]);
    return status;
}

int embed_scene_init(struct embed_scene *s, const struct embed_request *request,
                     const struct cor_scene_contact *contact)
{
    static const struct cor_scene_contact none = {.law = {3, 3, 2}};
    const bool own = request->law >= EMBED_LAW_POWER;
    const struct cor_exponents *const law = own ? &none.law : &contact->law;
    LOCAL(arb, force);
    *s = (struct embed_scene){.end = request->end == COR_END_ZERO_OVERLAP ? COR_END_ZERO_OVERLAP : COR_END_ZERO_FORCE,
                              .single = request->type == EMBED_FLOAT,
                              .tolerance = embed_number(request, EMBED_TOLERANCE),
                              .law = *law,
                              .named = *law,
                              .plastic = !own && contact->plastic,
                              .constant = !own && (law_is_linear(law) || contact->damping == 0) && !contact->plastic};
    FOR_ALL(arb, init, s->beta_per_root, s->beta_enclosed, s->eps, s->h_star_5, s->yield_speed, s->liquid_speed,
            s->press, s->sticking_speed);
    arb_poly_init(s->series);
    s->speed_min = embed_rounded(s, embed_number(request, EMBED_SPEED_MIN));
    s->speed_max = embed_rounded(s, embed_number(request, EMBED_SPEED_MAX));
    if (own) {
        const int status = own_law_init(&s->own, request);
        const int set = status == STATUS_OK ? scene_own(s, request) : status;
        return set == STATUS_OK ? scene_prepare(s, request) : set;
    }
    s->pressed = contact->force_n > 0 && !s->constant;
    int status =
        embed_contact_numbers(s->beta_enclosed, force, s->yield_speed, s->liquid_speed, request, contact, EMBED_BITS);
    const double held = is_wet(s) ? cor_scene_sticking_speed(contact, (int)s->end) : 0;
    if (!(s->speed_min > held))
        return refuse_speed("speed-min", "the liquid holds the bodies together, and eps is 0,", held);
    arb_set(s->beta_per_root, s->beta_enclosed);
    if (embed_given(request, COR_SCENE_RESTITUTION))
        arb_get_mid_arb(s->beta_per_root, s->beta_enclosed);
    if (status == STATUS_OK && s->pressed)
        status = set_pressing(s, force);
    if (status == STATUS_OK && (s->plastic || (s->constant && is_wet(s))))
        status = scene_by_speed(s, request);
    return status == STATUS_OK ? scene_prepare(s, request) : status;
}

void embed_scene_clear(struct embed_scene *s)
{
    FOR_ALL(arb, clear, s->beta_per_root, s->beta_enclosed, s->eps, s->h_star_5, s->yield_speed, s->liquid_speed,
            s->press, s->sticking_speed);
    arb_poly_clear(s->series);
    own_law_clear(&s->own);
    free(s->knot);
    free(s->samples.speed);
    interpolant_free(s->interpolant);
    law_layout_clear(&s->layout);
}
