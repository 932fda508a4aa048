/* SPDX-License-Identifier: MIT */
#include "contact/sample.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/decimal.h"
#include "support/parallel.h"

/* ---- eps and duration as functions of x = speed or x = ln(speed). For quick evaluation, laws with enclosed collisions
 * are interpolated between Chebyshev points ---- */

/* Largest and smallest step of a difference quotient in ln(speed), and the number of steps on either side */
#define SLOPE_STEP 0.01
#define SLOPE_LEAST 1e-5
enum { SLOPE_REACH = 3 };

/* Number of Chebyshev points of a piece. Pieces are divided until the error of interpolation is below PIECE_ERROR. */
enum { PIECE_POINTS = 24, PIECES_MOST = 512 };
#define PIECE_ERROR 1e-13

struct piece {
    double low, high; /* range of ln(speed) */
    double value[SAMPLE_QUANTITIES][PIECE_POINTS];
    int status;
};

struct sampler {
    const struct sample_request *request;
    int quantities;      /* 1: eps; 2: eps and duration */
    struct piece *piece; /* NULL: no interpolation */
    size_t pieces;
    double low, high; /* of x */
};

static double duration_scale(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double a = (double)contact->law.elastic / (double)contact->law.denominator;
    return pow(speed_m_s, (1 - a) / (1 + a));
}

static int value_direct(double value[SAMPLE_QUANTITIES], const struct sampler *c, double speed_m_s)
{
    struct cor_scene_impact impact;
    if (c->request->own)
        return value[0] = own_law_value(c->request->own, speed_m_s), STATUS_OK;
    if (c->quantities == 1)
        return contact_status(cor_scene_eps(&value[0], c->request->contact, speed_m_s, (int)c->request->end));
    const int status = cor_scene_impact(&impact, c->request->contact, speed_m_s);
    value[0] = impact.eps[c->request->end];
    value[1] = impact.duration_s[c->request->end];
    return contact_status(status);
}

/* Returns Chebyshev point i of the second kind. */
static double piece_point(const struct piece *piece, int i)
{
    const double angle = 3.14159265358979323846 * i / (PIECE_POINTS - 1);
    return (piece->low + piece->high) / 2 - (piece->high - piece->low) / 2 * cos(angle);
}

/* Interpolates between the points of piece_point by the barycentric formula. */
static double piece_value(const struct piece *piece, int quantity, double u)
{
    double above = 0, below = 0;
    for (int i = 0; i < PIECE_POINTS; i++) {
        const double distance = u - piece_point(piece, i);
        if (distance == 0)
            return piece->value[quantity][i];
        const double end = i == 0 || i == PIECE_POINTS - 1 ? 0.5 : 1, weight = (i % 2 ? -end : end) / distance;
        above += weight * piece->value[quantity][i];
        below += weight;
    }
    return above / below;
}

/* Computes point i of a new piece. Durations are divided by their scale, so that they vary slowly. */
static void fill_point(void *context, slong i)
{
    const struct sampler *const c = context;
    struct piece *const piece = &c->piece[c->pieces];
    const double speed_m_s = exp(piece_point(piece, (int)i));
    double value[SAMPLE_QUANTITIES];
    if (value_direct(value, c, speed_m_s) != STATUS_OK)
        piece->status = STATUS_FAILED;
    piece->value[0][i] = value[0];
    if (c->quantities > 1)
        piece->value[1][i] = value[1] / duration_scale(c->request->contact, speed_m_s);
}

/* Divides the range [low, high] of ln(speed) until every piece is accurate. The relative error of a piece is measured
 * next to both ends and near the middle. */
static int fill_pieces(struct sampler *c, double low, double high)
{
    static const double place[] = {0.004, 0.31, 0.52, 0.995};
    c->piece = xmalloc(PIECES_MOST * sizeof *c->piece);
    double width = high - low;
    while (low < high) {
        if (c->pieces == PIECES_MOST)
            return fail("eps changes too fast in this range of speeds for a table; give a narrower range");
        struct piece *const piece = &c->piece[c->pieces];
        piece->low = low;
        piece->high = low + width < high * (1 - 1e-12) - 1e-12 ? low + width : high;
        piece->status = STATUS_OK;
        parallel_for(fill_point, c, PIECE_POINTS, "collisions");
        double error = 0;
        for (size_t i = 0; i < sizeof place / sizeof *place && piece->status == STATUS_OK; i++) {
            const double u = piece->low + (piece->high - piece->low) * place[i];
            double value[SAMPLE_QUANTITIES] = {0};
            piece->status = value_direct(value, c, exp(u));
            value[1] /= duration_scale(c->request->contact, exp(u));
            for (int q = 0; q < c->quantities; q++)
                error = fmax(error, fabs(piece_value(piece, q, u) / value[q] - 1));
        }
        if (piece->status != STATUS_OK)
            return STATUS_FAILED;
        if (error > PIECE_ERROR) {
            width = (piece->high - piece->low) / 2;
            if (width < 1e-3)
                return fail("eps changes too fast near %g m/s for a table; give a range without this speed", exp(low));
            continue;
        }
        c->pieces++;
        low = piece->high;
    }
    return STATUS_OK;
}

static double function_place(const struct sampler *c, double speed_m_s)
{
    return c->request->log ? log(speed_m_s) : speed_m_s;
}

static double function_speed(const struct sampler *c, double x)
{
    return c->request->log ? exp(x) : x;
}

static double function_at_speed(const struct sampler *c, int quantity, double speed_m_s)
{
    double value[SAMPLE_QUANTITIES] = {(double)NAN, (double)NAN};
    if (!c->piece) {
        value_direct(value, c, speed_m_s); /* the laws of the library never fail */
        return value[quantity];
    }
    const double u = log(speed_m_s);
    size_t i = 0;
    while (i + 1 < c->pieces && u > c->piece[i].high)
        i++;
    const double y = piece_value(&c->piece[i], quantity, u);
    return quantity == 1 ? y * duration_scale(c->request->contact, speed_m_s) : y;
}

static double function_value(const struct sampler *c, int quantity, double x)
{
    return function_at_speed(c, quantity, function_speed(c, x));
}

/* Returns d value/dx at a speed by a central difference of order 6 in ln(speed); relative error below 1e-12. The
 * difference does not cross the onset of yield, where the second derivative jumps. Next to the onset the slope is off
 * by SLOPE_LEAST times that jump. */
static double function_slope(const struct sampler *c, int quantity, double speed_m_s)
{
    static const double weight[SLOPE_REACH] = {3.0 / 4, -3.0 / 20, 1.0 / 60};
    const struct cor_scene_contact *const contact = c->request->contact;
    const double away = fabs(log(speed_m_s / (contact->yield_speed_m_s + contact->liquid_speed_m_s)));
    const double step = c->request->own    ? SLOPE_LEAST
                        : contact->plastic ? fmin(SLOPE_STEP, fmax(SLOPE_LEAST, away / (1.01 * SLOPE_REACH)))
                                           : SLOPE_STEP;
    double sum = 0;
    for (int k = 1; k <= SLOPE_REACH; k++) {
        const double factor = exp(k * step);
        sum += weight[k - 1] * (function_at_speed(c, quantity, speed_m_s * factor) -
                                function_at_speed(c, quantity, speed_m_s / factor));
    }
    return sum / step / (c->request->log ? 1 : speed_m_s);
}

/* ---- segments ---- */

enum { CHECK_PLACES = 64, SEARCH_PLACES = 16, SCAN_PLACES = 64, MANY_SEGMENTS = 1000 };

/* Values and slopes at both ends of a segment of one quantity */
struct segment {
    double x[2], value[2], slope[2];
};

/* Returns the error of the interpolant at the fraction t of the segment's length. */
static double error_at(const struct sampler *c, const struct segment *s, int quantity, double t)
{
    const double width = s->x[1] - s->x[0], rest = 1 - t, exact = function_value(c, quantity, s->x[0] + t * width);
    const double linear = s->value[0] + t * (s->value[1] - s->value[0]);
    const double cubic = rest * rest * ((1 + 2 * t) * s->value[0] + t * width * s->slope[0]) +
                         t * t * ((3 - 2 * t) * s->value[1] - rest * width * s->slope[1]);
    return fabs((c->request->cubic ? cubic : linear) / exact - 1);
}

/* Returns the largest error of a quantity between two fractions of a segment. It is measured at evenly spaced places,
 * and at the vertex of the parabola through the worst place and its neighbours. */
static double largest_error(const struct sampler *c, const struct segment *s, int quantity, double from, double to,
                            int places)
{
    double error[CHECK_PLACES + 1] = {from > 0 ? error_at(c, s, quantity, from) : 0}, most = error[0];
    int at = 1;
    error[places] = to < 1 ? error_at(c, s, quantity, to) : 0;
    for (int i = 1; i < places; i++) {
        error[i] = error_at(c, s, quantity, from + (to - from) * ((double)i / places));
        if (error[i] > error[at])
            at = i;
    }
    const double curvature = error[at - 1] - 2 * error[at] + error[at + 1];
    most = fmax(fmax(most, error[places]), error[at]);
    if (curvature < 0 && error[at] >= fmax(error[at - 1], error[at + 1]))
        most = fmax(most,
                    error_at(c, s, quantity,
                             from + (to - from) * ((at + (error[at - 1] - error[at + 1]) / (2 * curvature)) / places)));
    return most;
}

/* Returns the largest error of every quantity in a segment. For an own law each smooth part is searched separately. */
static double segment_error(const struct sampler *c, double left, double right, int places)
{
    const struct own_law *const own = c->request->own;
    double most = 0;
    for (int q = 0; q < c->quantities; q++) {
        struct segment s = {{left, right}, {function_value(c, q, left), function_value(c, q, right)}, {0, 0}};
        for (int i = 0; c->request->cubic && i < 2; i++)
            s.slope[i] = function_slope(c, q, function_speed(c, s.x[i]));
        double from = 0;
        for (slong i = 0; own && i < own->parts; i++) {
            const double to = (function_place(c, own->part[i]) - left) / (right - left);
            if (to > 0 && to < 1) {
                most = fmax(most, largest_error(c, &s, q, from, to, places));
                from = to;
            }
        }
        most = fmax(most, largest_error(c, &s, q, from, 1, places));
    }
    return most;
}

/* ---- the farthest next point ---- */

/* Returns the farthest end of a segment from `left` with at most this error. length: first guess of its length */
static double reach_right(const struct sampler *c, double left, double error, double length)
{
    if (segment_error(c, left, c->high, SEARCH_PLACES) <= error)
        return c->high;
    double good = left, bad = c->high;
    /* Near an inflection point a longer segment may have a smaller error: try the longest segments first. */
    if (length > (c->high - c->low) / (double)SCAN_PLACES)
        for (int i = 1; i < SCAN_PLACES && good == left; i++) {
            const double place = c->high - (c->high - left) * i / (double)SCAN_PLACES;
            if (segment_error(c, left, place, SEARCH_PLACES) <= error)
                good = place;
            else
                bad = place;
        }
    for (double step = length; good == left && step > 1e-15 * fabs(left); step /= 4)
        if (left + step < bad) {
            if (segment_error(c, left, left + step, SEARCH_PLACES) <= error)
                good = left + step;
            else
                bad = left + step;
        }
    /* the error is proportional to this power of the length */
    const double power = c->request->cubic ? 4 : 2;
    double guess = (good + bad) / 2;
    for (int k = 0; k < 60 && bad - good > 1e-10 * (bad - left); k++) {
        const double got = segment_error(c, left, guess, SEARCH_PLACES);
        if (got <= error)
            good = guess;
        else
            bad = guess;
        if (got <= error && got > error * (1 - 1e-7))
            break;
        /* slightly below the estimated root, where the error meets the condition above */
        guess = left + (guess - left) * pow(error / fmax(got, 1e-30), 1 / power) * (got > error ? 1 - 1e-8 : 1 - 2e-8);
        if (!(guess > good && guess < bad))
            guess = (good + bad) / 2;
    }
    return good;
}

/* ---- all points ---- */

/* Places points for segments with at most this error, up to the end of the range or up to `most` segments. Returns the
 * number of segments. *last_error: error of the last segment if it is extended to the end of the range */
static size_t place_points(const struct sampler *c, double *x, size_t most, double error, double *last_error)
{
    double length = (c->high - c->low) / 2;
    size_t n = 0;
    x[0] = c->low;
    while (x[n] < c->high && n + 1 < most) {
        x[n + 1] = reach_right(c, x[n], error, 2 * length);
        length = x[n + 1] - x[n];
        n++;
        if (n % 256 == 0)
            progress("points", (long)n, 0);
        if (!(length > 0))
            return most + 1;
    }
    *last_error = 0;
    if (x[n] < c->high) {
        *last_error = segment_error(c, x[n], c->high, SEARCH_PLACES);
        x[++n] = c->high;
    }
    return n;
}

/* Moves the points until all segments have the same error, and returns this error. As the error of the other segments
 * rises, the error of the last one falls, so exactly one choice makes them equal. */
static double equalise_errors(const struct sampler *c, double *x, size_t segments, double upper)
{
    double low = 0, high = upper, last;
    if (segments == 1)
        return x[0] = c->low, x[1] = c->high, segment_error(c, c->low, c->high, SEARCH_PLACES);
    double guess = upper / 2;
    for (int k = 0; k < 100 && high - low > (segments > MANY_SEGMENTS ? 1e-3 : 1e-6) * high; k++) {
        const size_t used = place_points(c, x, segments, guess, &last);
        const bool enough = used < segments || (used == segments && last <= guess);
        if (enough)
            high = guess;
        else
            low = guess;
        /* the error of the last segment is proportional to a power of its length */
        const double mean = used == segments && last > 0 ? guess * pow(last / guess, 1.0 / (double)segments) : 0;
        guess = mean > low && mean < high && k % 3 != 2 ? mean : (low + high) / 2;
    }
    place_points(c, x, segments, high, &last);
    return high;
}

/* ---- tables ---- */

/* Fills the points. One block of memory contains all their numbers, the speeds first. */
static void points_fill(struct sample_points *p, const struct sampler *c, const double *x, size_t count)
{
    double *next = xrealloc(p->speed_m_s, (1 + 2 * SAMPLE_QUANTITIES) * count * sizeof(double));
    *p = (struct sample_points){.count = count, .speed_m_s = next};
    /* round the inner speeds to their printed digits before the values are computed */
    for (size_t i = 1; i + 1 < count; i++) {
        char text[DECIMAL_TEXT];
        snprintf(text, sizeof text, "%.12g", function_speed(c, x[i]));
        p->speed_m_s[i] = strtod(text, NULL);
    }
    p->speed_m_s[0] = c->request->speed_min;
    p->speed_m_s[count - 1] = c->request->speed_max;
    for (int q = 0; q < c->quantities; q++) {
        p->value[q] = next += count;
        p->slope[q] = c->request->cubic ? next += count : NULL;
        for (size_t i = 0; i < count; i++) {
            p->value[q][i] = function_at_speed(c, q, p->speed_m_s[i]);
            if (p->slope[q])
                p->slope[q][i] = function_slope(c, q, p->speed_m_s[i]);
        }
    }
    for (size_t i = 0; i + 1 < count; i++)
        p->error = fmax(p->error, segment_error(c, function_place(c, p->speed_m_s[i]),
                                                function_place(c, p->speed_m_s[i + 1]), CHECK_PLACES));
}

int sample_choose(struct sample *sample, const struct sample_request *request)
{
    struct sampler c = {.request = request, .quantities = request->duration ? 2 : 1};
    *sample = (struct sample){.error_of_fewer = INFINITY};
    c.low = function_place(&c, request->speed_min);
    c.high = function_place(&c, request->speed_max);
    /* eps and duration are monotonic, so their values at both ends of the range bound them */
    for (int q = 0; q < c.quantities; q++) {
        const double low = function_value(&c, q, c.low), high = function_value(&c, q, c.high);
        if (!(fmin(low, high) > 1e-280 && fmax(low, high) < 1e280))
            return usage_error("%s is %g at %g m/s and %g at %g m/s, but a relative tolerance needs values above 0; "
                               "give a narrower range of speeds%s",
                               q == 0 ? "eps" : "the duration", low, request->speed_min, high, request->speed_max,
                               request->contact->force_n > 0 ? ", above the sticking speed that corgen contact prints"
                                                             : ", or --end zero-force");
    }
    int status = STATUS_OK;
    const double margin = 1.01 * (double)SLOPE_REACH * SLOPE_STEP;
    if (!request->own && cor_scene_needs_solver(request->contact))
        status = fill_pieces(&c, log(request->speed_min) - margin, log(request->speed_max) + margin);
    double *const x = xmalloc((SAMPLE_MOST_POINTS + 2) * sizeof *x), last;
    /* rounded speeds and measured errors must not exceed the tolerance */
    const double allowed = request->tolerance * (1 - 1e-6);
    const size_t segments = status == STATUS_OK ? place_points(&c, x, SAMPLE_MOST_POINTS, allowed, &last) : 0;
    if (segments >= SAMPLE_MOST_POINTS)
        status = usage_error("--tolerance %g needs more than %d points; use --cubic, or corgen embed for a formula",
                             request->tolerance, SAMPLE_MOST_POINTS);
    if (status == STATUS_OK) {
        if (segments > 1 && segments <= MANY_SEGMENTS)
            sample->error_of_fewer = equalise_errors(&c, x, segments - 1, 16 * allowed);
        equalise_errors(&c, x, segments, allowed);
        points_fill(&sample->best, &c, x, segments + 1);
        for (size_t i = 0; i <= segments; i++)
            x[i] = c.low + (c.high - c.low) * (double)i / (double)segments;
        points_fill(&sample->even, &c, x, segments + 1);
        /* evenly spaced points may be better if a few long segments cross an inflection point */
        if (sample->even.error < sample->best.error)
            points_fill(&sample->best, &c, x, segments + 1);
    }
    free(x);
    free(c.piece);
    progress_end();
    return status;
}

void sample_clear(struct sample *sample)
{
    free(sample->best.speed_m_s);
    free(sample->even.speed_m_s);
}
