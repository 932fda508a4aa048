/* SPDX-License-Identifier: MIT */
/* Fig. 5: circles and radii of a disk that hits the wall at v = 0.2, at equal steps of time. Displacements are (37), at
 * the rim (39), the amplitudes those of the full dynamics. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collisions.h"
#include "mode_shape.h"
#include "report.h"

static const double pi = 3.14159265358979323846;
static const double alpha = 500, speed = 0.2, step = 1;
enum { MODES = 940, MOST_N = 200, FRAMES = 10, CIRCLES = 4, RADII = 16, STEPS = 12, ANGLES = 96 };

/* The last step before each moment, and the largest compression of all. Between steps motion is taken as free: that is
 * exact after the contact, and during it wrong by a hundredth of a step squared. */
struct film {
    struct cor_disk_moment moment[FRAMES];
    double q[FRAMES][MODES], q_dot[FRAMES][MODES];
    double closest, time_of_closest;
};

static void expose(void *context, const struct cor_disk_moment *moment, const double *q, const double *q_dot)
{
    struct film *film = context;
    if (moment->position > film->closest) {
        film->closest = moment->position;
        film->time_of_closest = moment->time;
    }
    for (int i = 0; i < FRAMES; i++)
        if (moment->time <= i * step) {
            film->moment[i] = *moment;
            memcpy(film->q[i], q, MODES * sizeof *q);
            memcpy(film->q_dot[i], q_dot, MODES * sizeof *q);
        }
}

static void develop(struct film *film)
{
    for (int i = 0; i < FRAMES; i++) {
        const double left = i * step - film->moment[i].time;
        film->moment[i].position += film->moment[i].velocity * left;
        for (int k = 0; k < MODES; k++) {
            const double omega = cor_disk_modes_nu033.mode[k].omega;
            film->q[i][k] = film->q[i][k] * cos(omega * left) + film->q_dot[i][k] / omega * sin(omega * left);
        }
    }
}

/* sums over l of Q u_r and Q u_phi at one radius, for each n */
struct ring {
    double radial[MOST_N], tangential[MOST_N];
    int n_max;
};

static void sum_ring(const struct mode_shape *shape, const double *q, double r, struct ring *ring)
{
    memset(ring, 0, sizeof *ring);
    for (int k = 0; k < MODES; k++) {
        double u_r, u_phi;
        mode_displacement(&shape[k], r, &u_r, &u_phi);
        ring->radial[shape[k].n] += q[k] * u_r;
        ring->tangential[shape[k].n] += q[k] * u_phi;
        ring->n_max = shape[k].n > ring->n_max ? shape[k].n : ring->n_max;
    }
}

static void point_of(const struct ring *ring, double position, double r, double phi, double *x, double *y)
{
    double u_r = 0, u_phi = 0;
    for (int n = 0; n <= ring->n_max; n++) {
        u_r += ring->radial[n] * cos(n * phi);
        u_phi += ring->tangential[n] * sin(n * phi);
    }
    *x = position + (r + u_r) * cos(phi) - u_phi * sin(phi);
    *y = (r + u_r) * sin(phi) + u_phi * cos(phi);
}

/* Breadth and half the height of the rim */
struct extent {
    double breadth, height;
};

/* A blank line after each line of the drawing, two after each picture, as gnuplot wants it */
static struct extent write_frame(FILE *csv, const struct mode_shape *shape, const struct film *film, int frame)
{
    struct ring ring[STEPS + 1];
    const double position = film->moment[frame].position, time = frame * step;
    double left = INFINITY, right = -INFINITY, top = 0;
    for (int i = 0; i <= STEPS; i++)
        sum_ring(shape, film->q[frame], i == 0 ? 1e-6 : (double)i / (double)STEPS, &ring[i]);
    for (int i = 1; i <= CIRCLES; i++) {
        for (int k = 0; k <= ANGLES; k += i < CIRCLES ? 2 : 1) {
            double x, y;
            point_of(&ring[i * STEPS / CIRCLES], position, (double)i / (double)CIRCLES, 2 * pi * k / (double)ANGLES, &x,
                     &y);
            fprintf(csv, "%g,%s,%.4f,%.4f\n", time, i < CIRCLES ? "circle" : "rim", x, y);
            left = fmin(left, x);
            right = fmax(right, x);
            top = fmax(top, y);
        }
        fputs("\n", csv);
    }
    for (int i = 0; i < RADII; i++) {
        for (int k = 0; k <= STEPS; k += 2) {
            double x, y;
            point_of(&ring[k], position, (double)k / (double)STEPS, 2 * pi * i / (double)RADII, &x, &y);
            fprintf(csv, "%g,radius,%.4f,%.4f\n", time, x, y);
        }
        fputs("\n", csv);
    }
    fputs(frame < FRAMES - 1 ? "\n" : "", csv);
    return (struct extent){right - left, top};
}

static int write_sequence(FILE *csv, char verdict[VERDICT_SIZE])
{
    struct film *film = calloc(1, sizeof *film);
    struct mode_shape *shape = malloc(MODES * sizeof *shape);
    struct cor_disk_collision out;
    int made = film != NULL && shape != NULL;
    if (!made)
        fprintf(stderr, "cor_paper: out of memory\n");
    if (made)
        film->closest = -2;
    made = made && collision_watch(MODES, alpha, speed, expose, film, &out, NULL, NULL);
    if (made) {
        struct extent extent[FRAMES];
        develop(film);
        for (int k = 0; k < MODES; k++)
            shape[k] = mode_shape_of(&cor_disk_modes_nu033.mode[k], cor_disk_modes_nu033.nu);
        fputs("time,line,x,y\n", csv);
        double narrow = INFINITY, broad = 0;
        for (int i = 0; i < FRAMES; i++) {
            extent[i] = write_frame(csv, shape, film, i);
            if (i * step > out.contact_time + step) {
                narrow = fmin(narrow, extent[i].breadth);
                broad = fmax(broad, extent[i].breadth);
            }
        }
        snprintf(
            verdict, VERDICT_SIZE,
            "Agrees: the oscillations after the collision are visible. v = %g, nu = 0.33, alpha = %g, %d modes (the "
            "caption gives v alone), true to scale; a rigid disk would touch at t = 0. The disk is closest at t = "
            "%.2f, with delta = %.4f; at t = 3 it is %.2f wide and %.2f high. The contact lasts %.2f; in the pictures "
            "after it the width is %.2f to %.2f.",
            speed, alpha, MODES, film->time_of_closest, out.max_compression, extent[3].breadth, 2 * extent[3].height,
            out.contact_time, narrow, broad);
    }
    free(film);
    free(shape);
    return made;
}

const struct figure sequence_figure = {"sequence", "Fig. 5", "shape of the disk in time", write_sequence};
