/* SPDX-License-Identifier: MIT */
#include "contact/sample_function.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/parallel.h"

/* Step of the difference in ln(speed), and how many steps it reaches on either side */
#define SLOPE_STEP 0.01
enum { SLOPE_REACH = 3 };

/* Chebyshev points of a piece, and the error of the interpolation that ends its division */
enum { PIECE_POINTS = 24, PIECES_MOST = 512 };
#define PIECE_ERROR 1e-13

struct sample_piece {
    double low, high; /* of ln(speed) */
    double value[SAMPLE_QUANTITIES][PIECE_POINTS];
    int status;
};

static double duration_scale(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double a = (double)contact->law.elastic / (double)contact->law.denominator;
    return pow(speed_m_s, (1 - a) / (1 + a));
}

static int value_direct(double value[SAMPLE_QUANTITIES], const struct sample_function *f, double speed_m_s)
{
    struct cor_scene_impact impact;
    if (f->quantities == 1)
        return contact_status(cor_scene_eps(&value[0], f->contact, speed_m_s, (int)f->end));
    const int status = cor_scene_impact(&impact, f->contact, speed_m_s);
    value[0] = impact.eps[f->end];
    value[1] = impact.duration_s[f->end];
    return contact_status(status);
}

/* ---- pieces ---- */

static double chebyshev_angle(int i)
{
    return 3.14159265358979323846 * i / (PIECE_POINTS - 1);
}

static double piece_point(const struct sample_piece *piece, int i)
{
    return (piece->low + piece->high) / 2 - (piece->high - piece->low) / 2 * cos(chebyshev_angle(i));
}

/* The barycentric formula for Chebyshev points of the second kind */
static double piece_value(const struct sample_piece *piece, int quantity, double u)
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

struct piece_work {
    const struct sample_function *f;
    struct sample_piece *piece;
};

/* Point i of a list of pieces. Durations are divided by their scale, so that they vary slowly. */
static void fill_point(void *context, slong i)
{
    struct piece_work *const work = context;
    struct sample_piece *const piece = &work->piece[i / PIECE_POINTS];
    const int k = (int)(i % PIECE_POINTS);
    const double speed_m_s = exp(piece_point(piece, k));
    double value[SAMPLE_QUANTITIES];
    if (value_direct(value, work->f, speed_m_s) != STATUS_OK)
        piece->status = STATUS_FAILED;
    piece->value[0][k] = value[0];
    if (work->f->quantities > 1)
        piece->value[1][k] = value[1] / duration_scale(work->f->contact, speed_m_s);
}

/* The largest error relative to the value, between the points next to both ends and in the middle */
static int piece_error(double *error, const struct sample_function *f, const struct sample_piece *piece)
{
    static const double place[] = {0.004, 0.31, 0.52, 0.995};
    *error = 0;
    for (size_t i = 0; i < sizeof place / sizeof *place; i++) {
        const double u = piece->low + (piece->high - piece->low) * place[i];
        double value[SAMPLE_QUANTITIES];
        if (value_direct(value, f, exp(u)) != STATUS_OK)
            return STATUS_FAILED;
        for (int q = 0; q < f->quantities; q++) {
            const double exact = q == 1 ? value[q] / duration_scale(f->contact, exp(u)) : value[q];
            *error = fmax(*error, fabs(piece_value(piece, q, u) / exact - 1));
        }
    }
    return STATUS_OK;
}

static int fill_piece(struct sample_function *f, struct sample_piece *piece, double *error)
{
    struct piece_work work = {f, piece};
    piece->status = STATUS_OK;
    parallel_for(fill_point, &work, PIECE_POINTS, "collisions");
    return piece->status == STATUS_OK ? piece_error(error, f, piece) : piece->status;
}

/* Divides [low, high] of ln(speed) until every piece is accurate. */
static int fill_pieces(struct sample_function *f, double low, double high)
{
    f->piece = xmalloc(PIECES_MOST * sizeof *f->piece);
    double width = high - low, error;
    while (low < high) {
        if (f->pieces == PIECES_MOST)
            return fail("eps changes too fast in this range of speeds to be sampled");
        struct sample_piece *const piece = &f->piece[f->pieces];
        piece->low = low;
        piece->high = low + width < high * (1 - 1e-12) - 1e-12 ? low + width : high;
        if (fill_piece(f, piece, &error) != STATUS_OK)
            return STATUS_FAILED;
        if (error > PIECE_ERROR) {
            width = (piece->high - piece->low) / 2;
            if (width < 1e-3)
                return fail("eps changes too fast near %g m/s to be sampled", exp(low));
            continue;
        }
        f->pieces++;
        low = piece->high;
    }
    return STATUS_OK;
}

/* ---- the function ---- */

void sample_function_direct(struct sample_function *f, const struct sample_request *request)
{
    *f = (struct sample_function){
        .contact = request->contact, .end = request->end, .log = request->log, .quantities = request->duration ? 2 : 1};
}

int sample_function_init(struct sample_function *f, const struct sample_request *request)
{
    sample_function_direct(f, request);
    if (!cor_scene_needs_solver(request->contact))
        return STATUS_OK;
    const double margin = 1.01 * (double)SLOPE_REACH * SLOPE_STEP;
    return fill_pieces(f, log(request->speed_min) - margin, log(request->speed_max) + margin);
}

void sample_function_clear(struct sample_function *f)
{
    free(f->piece);
    f->piece = NULL;
}

double sample_function_place(const struct sample_function *f, double speed_m_s)
{
    return f->log ? log(speed_m_s) : speed_m_s;
}

double sample_function_speed(const struct sample_function *f, double x)
{
    return f->log ? exp(x) : x;
}

double sample_function_at_speed(const struct sample_function *f, int quantity, double speed_m_s)
{
    double value[SAMPLE_QUANTITIES] = {(double)NAN, (double)NAN};
    if (!f->piece) {
        value_direct(value, f, speed_m_s); /* the laws of the library never fail */
        return value[quantity];
    }
    const double u = log(speed_m_s);
    size_t i = 0;
    while (i + 1 < f->pieces && u > f->piece[i].high)
        i++;
    const double y = piece_value(&f->piece[i], quantity, u);
    return quantity == 1 ? y * duration_scale(f->contact, speed_m_s) : y;
}

double sample_function_value(const struct sample_function *f, int quantity, double x)
{
    return sample_function_at_speed(f, quantity, sample_function_speed(f, x));
}

double sample_function_slope(const struct sample_function *f, int quantity, double speed_m_s)
{
    static const double weight[SLOPE_REACH] = {3.0 / 4, -3.0 / 20, 1.0 / 60};
    double sum = 0;
    for (int k = 1; k <= SLOPE_REACH; k++) {
        const double factor = exp(k * SLOPE_STEP);
        sum += weight[k - 1] * (sample_function_at_speed(f, quantity, speed_m_s * factor) -
                                sample_function_at_speed(f, quantity, speed_m_s / factor));
    }
    return sum / SLOPE_STEP / (f->log ? 1 : speed_m_s);
}
