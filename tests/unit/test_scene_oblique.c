/* SPDX-License-Identifier: MIT */
/* Oblique impacts with friction, against docs/theory.md, 20, limits, and an integration by another method */
#include "../reference/ode.h"
#include "scene.h"

/* ---- another method: y = {u, x', w, z}, x = u^d; w: tangential speed; z: displacement, force or memory ---- */

struct reference {
    struct cor_exponents law; /* d = law.denominator, which is even */
    long double beta, press, kappa, gamma, cap, side, sign;
    int memory, in_cap, returns, p, least; /* p: d times the stiffness exponent. least: least power of u in excess() */
    enum { STICKS, SLIPS, CREEPS } mode;
};

static long double power(long double u, int n)
{
    return n < 0 ? 1 / motion_power(u, -n) : motion_power(u, n);
}

static long double normal_force(const long double *y, const struct reference *r)
{
    return power(y[0], r->law.elastic) + r->beta * power(y[0], r->law.damping) * y[1];
}

static int remembers_force(const struct reference *r)
{
    return r->memory == COR_REMEMBERS_FORCE || r->memory == COR_REMEMBERS_FORCE_RESCALED;
}

/* A rescaled memory shrinks like x^(1/2) = u^(d/2) during unloading. Returns d/2, or 0 if it does not shrink. */
static int shrinks(const struct reference *r)
{
    const int rescaled = r->memory == COR_REMEMBERS_DISPLACEMENT_RESCALED || r->memory == COR_REMEMBERS_FORCE_RESCALED;
    return rescaled && r->returns ? r->law.denominator / 2 : 0;
}

static long double spring_per_z(const long double *y, const struct reference *r)
{
    return (remembers_force(r) ? 1 : r->kappa * power(y[0], r->p)) * power(y[0], shrinks(r));
}

static long double damper(const long double *y, const struct reference *r)
{
    return r->gamma * power(y[0], r->law.damping) * y[2];
}

static long double capped(const long double *y, const struct reference *r)
{
    return spring_per_z(y, r) * y[3] + (r->in_cap ? damper(y, r) : 0);
}

/* Returns the spring force at the friction limit during slip, in the direction of the slip. */
static long double held(const long double *y, const struct reference *r)
{
    return r->cap * r->sign * normal_force(y, r) - (r->in_cap ? r->side * damper(y, r) : 0);
}

/* Returns the growth of the spring force minus the growth of `held`, divided by u^(least - d). */
static long double excess(const long double *y, const struct reference *r)
{
    const int d = r->law.denominator, a = r->law.elastic, b = r->law.damping, m = r->least;
    const long double v = y[1], f = normal_force(y, r), cap = r->cap * r->sign;
    const long double rise =
        cap * (power(y[0], a - m) * v * a / d +
               r->beta * (power(y[0], b - m) * v * v * b / d + power(y[0], b + d - m) * (r->press - f)));
    const long double of_damper =
        r->in_cap && r->gamma > 0
            ? r->gamma * (power(y[0], b - m) * v * y[2] * b / d - power(y[0], b + d - m) * r->side * cap * f)
            : 0;
    const long double share = (remembers_force(r) ? 0 : r->p) + shrinks(r); /* exponent of u in spring_per_z */
    if (r->memory == COR_REMEMBERS_NOTHING)
        return -held(y, r);
    return r->side * r->kappa * power(y[0], r->p + d - m) * y[2] - rise + r->side * of_damper +
           share / d * v *
               (cap * (power(y[0], a - m) + r->beta * power(y[0], b - m) * v) -
                (r->in_cap && r->gamma > 0 ? r->side * r->gamma * power(y[0], b - m) * y[2] : 0));
}

/* Returns the slip speed w at which `excess` is 0, without a damper in the cap. */
static long double threshold(const long double *y, const struct reference *r)
{
    const long double still[] = {y[0], y[1], 0, 0};
    return -r->side * excess(still, r) / (r->kappa * power(y[0], r->p + r->law.denominator - r->least));
}

static void reference_slopes(long double *slope, const long double *y, const void *of)
{
    const struct reference *const r = of;
    const long double time = r->law.denominator * power(y[0], r->law.denominator - 1);
    slope[0] = y[1];
    slope[1] = time * (r->press - normal_force(y, r));
    slope[2] = r->mode == STICKS ? -time * (spring_per_z(y, r) * y[3] + damper(y, r))
                                 : -time * r->side * r->sign * r->cap * normal_force(y, r);
    slope[3] = r->law.denominator * y[2] * (remembers_force(r) ? r->kappa * power(y[0], r->p) : 1) *
               power(y[0], r->law.denominator - 1 - shrinks(r));
}

static long double room_above(const long double *y, const void *of)
{
    const struct reference *const r = of;
    return r->mode == STICKS ? r->sign * r->cap * normal_force(y, r) - capped(y, r) : 1;
}

static long double room_below(const long double *y, const void *of)
{
    const struct reference *const r = of;
    return r->mode == STICKS ? r->sign * r->cap * normal_force(y, r) + capped(y, r) : 1;
}

static long double slip_goes_on(const long double *y, const void *of)
{
    const struct reference *const r = of;
    return r->mode == SLIPS ? excess(y, r) : 1;
}

static long double force_left(const long double *y, const void *of)
{
    const struct reference *const r = of;
    return r->sign * normal_force(y, r);
}

static long double speed_left(const long double *y, const void *of)
{
    return ((const struct reference *)of)->returns ? 1 : y[1];
}

/* Returns the acceleration of the slip minus the acceleration of the threshold, in the direction of the slip. damped:
 * adds the force of the damper */
static long double over_threshold(const long double *y, const struct reference *r, int damped)
{
    const long double f = normal_force(y, r), step = 1e-6L;
    const long double w[] = {y[0], y[1], threshold(y, r), 0};
    long double side[2];
    for (int k = 0; k < 2; k++) { /* derivative by a difference along the motion */
        long double slope[4], at[4] = {y[0], y[1], w[2], 0};
        reference_slopes(slope, y, r);
        for (int j = 0; j < 2; j++)
            at[j] += (k == 0 ? -1 : 1) * step * slope[j];
        side[k] = threshold(at, r);
    }
    const long double time = r->law.denominator * power(y[0], r->law.denominator - 1);
    return -time * (r->cap * r->sign * f + (damped ? r->side * damper(w, r) : 0)) -
           r->side * (side[1] - side[0]) / (2 * step);
}

static long double creep_below(const long double *y, const void *of)
{
    const struct reference *const r = of;
    return r->mode == CREEPS ? -over_threshold(y, r, 0) : 1;
}

static long double creep_above(const long double *y, const void *of)
{
    const struct reference *const r = of;
    return r->mode == CREEPS ? over_threshold(y, r, 1) : 1;
}

static void stick(long double *y, struct reference *r)
{
    y[3] = r->kappa > 0 ? r->side * held(y, r) / spring_per_z(y, r) : 0;
    r->mode = STICKS;
}

/* Sets the mode after a slip that no longer grows. */
static void end_slip(long double *y, struct reference *r)
{
    r->mode = CREEPS;
    if (r->in_cap || r->gamma == 0 || creep_above(y, r) <= 0)
        stick(y, r);
}

/* Returns u'/u. longest: the longest step. restart: the first step after a change of the mode */
static long double reference_restitution(struct reference *r, long double tangent, int end, long double longest,
                                         long double restart)
{
    enum { OVERLAP, ABOVE, BELOW, SLIP, FORCE, SPEED, CREEP_BELOW, CREEP_ABOVE, VALUES, STEPS = 200000 };
    static ode_value *const value[VALUES] = {motion_overlap, room_above, room_below,  slip_goes_on,
                                             force_left,     speed_left, creep_below, creep_above};
    struct ode o = {.slopes = reference_slopes, .of = r, .n = 4, .h = 1e-4L};
    const int d = r->law.denominator, a = r->law.elastic, b = r->law.damping;
    const long double u = 1e-8L, early[] = {u, 1, tangent, 0}; /* just after the touch, to find the first mode */
    const long double first = r->kappa * power(u, r->p + d) * tangent / (remembers_force(r) ? 1 + r->p / (double)d : 1);
    long double y[4] = {0, 1, tangent, 0};
    r->side = r->sign = 1;
    r->returns = 0;
    r->least = r->p + d < a ? r->p + d : a;
    r->least = (r->beta > 0 || r->gamma > 0) && b < r->least ? b : r->least;
    r->mode = first + (r->in_cap ? damper(early, r) : 0) > r->cap * normal_force(early, r) ? SLIPS : STICKS;
    if (r->mode == SLIPS && excess(early, r) <= 0) { /* the damper reaches the friction limit without the spring */
        if (!remembers_force(r) && b < r->p) {
            r->side = -1;
        } else {
            y[3] = held(early, r) / spring_per_z(early, r);
            r->mode = STICKS;
        }
    }
    for (int k = 0; k < STEPS; k++) {
        o.longest = y[1] < 0 ? fminl(longest, 0.1L * y[0] + 1e-4L) : longest; /* the last slip may be short */
        int found = ode_until(&o, y, value, VALUES);
        const long double rounding = 1e-15L * r->cap * fabsl(normal_force(y, r));
        for (int i = ABOVE; i <= SLIP && found < 0; i++) /* also finds an event whose value was 0 at the start of the
                                                          * step */
            found = value[i](y, r) < -rounding ? i : found;
        o.h = found < 0 ? o.h : restart;
        if (r->mode == CREEPS && y[0] > 0)
            y[2] = threshold(y, r);
        if (found == OVERLAP || (found == FORCE && end == COR_END_ZERO_FORCE))
            return y[2] / tangent;
        if (found == ABOVE || found == BELOW || found == CREEP_BELOW) {
            r->side = found == CREEP_BELOW ? r->side : found == ABOVE ? 1 : -1;
            r->mode = SLIPS;
        } else if (found == SLIP) {
            end_slip(y, r);
        } else if (found == CREEP_ABOVE) {
            stick(y, r);
        } else if (found == FORCE) {
            const int creeps = r->mode == CREEPS; /* a creeping contact may stick or slip; small steps stick */
            r->sign = -1;
            r->mode = SLIPS;
            r->side = 1;
            if (excess(y, r) <= 0)
                r->side = -1;
            if (creeps || excess(y, r) <= 0)
                stick(y, r);
        } else if (found == SPEED) {
            y[3] /= power(y[0], (r->returns = 1, shrinks(r)));
        }
    }
    return NAN;
}

/* ---- the tests ---- */

static double restitution(const struct cor_scene_contact *c, const struct cor_tangential *t, double mu, double tangent,
                          int end)
{
    struct cor_oblique_impact oblique;
    assert_int_equal(cor_scene_oblique(&oblique, c, t, mu, 1, tangent, end), COR_OK);
    return oblique.restitution;
}

/* An impact at 1 m/s */
struct impact {
    int law, end, memory, constant_stiffness, damper_in_cap;
    double beta, press, kappa, damping, mu, tangent;
};

static void compare(const struct impact *i)
{
    const struct cor_tangential t = {i->memory, i->constant_stiffness, i->damper_in_cap, i->kappa, i->damping};
    const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[i->law], i->beta, i->press);
    const struct cor_exponents *const e = &c.law;
    const int twice = e->denominator == 1 ? 2 : 1, nothing = t.memory == COR_REMEMBERS_NOTHING;
    struct reference r = {.law = {twice * e->elastic, twice * e->damping, twice * e->denominator},
                          .beta = i->beta,
                          .press = i->press,
                          .kappa = nothing ? 0 : t.kappa,
                          .gamma = t.damping,
                          .cap = 3.5 * (long double)i->mu,
                          .memory = t.memory,
                          .in_cap = t.damper_in_cap || nothing,
                          .p = t.constant_stiffness ? 0 : twice * (e->elastic - e->denominator)};
    struct cor_oblique_impact oblique;
    const int status = cor_scene_oblique(&oblique, &c, &t, i->mu, 1, i->tangent, i->end);
    if (status == COR_OK && !(oblique.eps >= 1e-3)) /* COR_OBLIQUE_ERROR does not hold for such eps */
        return;
    /* One of these steps must agree. The others may miss a short slip, or begin a wrong mode because of rounding. */
    static const long double steps[][2] = {{0.02L, 1e-9L}, {0.02L, 1e-7L}, {2e-4L, 1e-8L}};
    double other = NAN;
    for (size_t k = 0; k < COUNT_OF(steps) && !(fabs(oblique.restitution - other) < COR_OBLIQUE_ERROR); k++)
        other = (double)reference_restitution(&r, i->tangent, i->end, steps[k][0], steps[k][1]);
    check(status == COR_OK && fabs(oblique.restitution - other) < COR_OBLIQUE_ERROR,
          "law %d end %d beta %.17g press %.17g memory %d constant %d in cap %d kappa %.17g damping %.17g mu %.17g "
          "tangent %.17g: %.15g, not %.15g",
          i->law, i->end, i->beta, i->press, t.memory, t.constant_stiffness, t.damper_in_cap, t.kappa, t.damping, i->mu,
          i->tangent, oblique.restitution, other);
}

/* Impacts of every model, law and end, many of them next to a boundary between stick and slip */
TEST(against_another_method)
{
    static const struct impact rare[] = {
        /* a damper outside the limit keeps w between slip and stick; in row 2 the friction limit becomes negative */
        {COR_LAW_HERTZ_DASHPOT, 1, COR_REMEMBERS_FORCE, 0, 0, 0.05, 0, 4, 0.7, 0.32, 1.8},
        {2, 0, 3, 0, 0, 0.031626973606115716, 0, 1.3718264680914363, 0.083633820266818537, 0.11072672221065727,
         1.2509808058731937},
        /* a damper reaches the friction limit at the first touch */
        {COR_LAW_TSUJI, 0, COR_REMEMBERS_DISPLACEMENT, 0, 1, 0.1, 0, 4, 0.9, 0.1, 0.5},
        {COR_LAW_TSUJI, 0, COR_REMEMBERS_DISPLACEMENT, 0, 1, 0, 0, 4, 0.1, 0.3, 0.5},
        {COR_LAW_VISCOELASTIC, 1, COR_REMEMBERS_DISPLACEMENT, 0, 1, 0.1, 0, 4, 0.9, 0.1, 0.5},
        /* a slip just before the end */
        {0, 0, 2, 0, 1, 0, 0, 3.8548582385997756, 0.002635731388418452, 0.13398053370494065, 0.12164633450952819},
        /* the end of the slip at the first touch is found from a small difference */
        {4, 0, 2, 0, 0, 0, 0, 4.4999838595495572, 0.17872088338921652, 9.6589975343512187, 7.5125806633527672},
        /* large terms cancel in the friction limit, and in the force */
        {4, 1, 1, 0, 1, 0.0062034858863136708, 0.028739970361874426, 0.10733338472459437, 1.261359801085598,
         3.1748697912593107, 155.29246324779749},
        {2, 0, 3, 0, 0, 0.38798922528341845, 0.0012013704328785741, 4.500012073555145, 0, 0.80058213341295226,
         51.390642047990163}};
    for (size_t k = 0; k < COUNT_OF(rare); k++)
        compare(&rare[k]);
    for (size_t k = points(few_or_all(60, 500)); k > 0; k--) {
        struct impact i = {.law = (int)random_below(&draw, SCENE_LAWS),
                           .end = (int)random_below(&draw, 2),
                           .memory = (int)random_below(&draw, COR_TANGENTIAL_MEMORIES),
                           .damper_in_cap = (int)random_below(&draw, 2),
                           .beta = random_below(&draw, 3) ? random_log(&draw, 1e-3, 4) : 0,
                           .press = random_below(&draw, 4) ? 0 : random_log(&draw, 1e-3, 10),
                           .kappa = random_log(&draw, 0.1, 100),
                           .mu = random_log(&draw, 1e-3, 10)};
        const int force = i.memory == COR_REMEMBERS_FORCE || i.memory == COR_REMEMBERS_FORCE_RESCALED,
                  rescaled =
                      i.memory == COR_REMEMBERS_DISPLACEMENT_RESCALED || i.memory == COR_REMEMBERS_FORCE_RESCALED;
        i.constant_stiffness = !rescaled && random_below(&draw, 4) == 0;
        i.law = rescaled && i.law == COR_LAW_LINEAR ? COR_LAW_VISCOELASTIC : i.law; /* linear has no contact radius */
        i.damping = random_below(&draw, 2) || i.memory == COR_REMEMBERS_NOTHING ? random_log(&draw, 1e-3, 10) : 0;
        if (random_below(&draw, 4) == 0) /* kappa near 4.5: elastic spheres slip just before the end */
            i.kappa = 4.5 + random_uniform(&draw, -1, 1) * random_log(&draw, 1e-6, 0.3);
        i.tangent = 3.5 * i.mu / i.kappa; /* the tangent at which stick begins if the displacement is remembered */
        if (random_below(&draw, 4) == 0)
            i.tangent *= (force ? 1.5 : 1) * (1 + random_uniform(&draw, -1, 1) * random_log(&draw, 1e-8, 0.1));
        else
            i.tangent *= random_log(&draw, 1e-2, 100);
        compare(&i);
    }
}

/* u'/u of elastic spheres that remember the displacement, at u/v = w L with L = 7 mu/(2 kappa) (docs/theory.md, 20) */
TEST(table_of_the_theory)
{
    static const double nus[] = {0, 0.3, 0.5}, ws[] = {0.1, 0.25, 0.5, 1, 2, 4, 8};
    static const double table[][7] = {{1.0395523, 1.0440268, 1.0513419, 1.0625110, 0.5654061, -0.1626901, -0.2275090},
                                      {0.9547583, 0.9543906, 0.9525804, 0.8970736, 0.0501002, -0.3476886, -0.0808824},
                                      {0.5471572, 0.5264477, 0.4601048, 0.2238834, -0.3517573, -0.4249138, 0.1250000}};
    const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[COR_LAW_VISCOELASTIC], 0, 0);
    for (size_t i = 0; i < COUNT_OF(nus); i++)
        for (size_t k = 0; k < COUNT_OF(ws); k++) {
            const struct cor_tangential t = {.kappa = 10.5 * (1 - nus[i]) / (2 - nus[i])};
            for (double mu = 0.01; mu < 20; mu *= 30)
                check(fabs(restitution(&c, &t, mu, ws[k] * 3.5 * mu / t.kappa, COR_END_ZERO_FORCE) - table[i][k]) <
                          6e-8,
                      "nu = %g, w_0 = %g", nus[i], ws[k]);
        }
}

/* No slip, gross slip, no friction, friction that sticks at once, no tangential speed */
TEST(limits)
{
    for (int memory = 0; memory < COR_TANGENTIAL_MEMORIES; memory++)
        EACH (kappa, 0.3, 2, 4.5, 9) {
            const struct cor_tangential t = {.memory = memory, .kappa = *kappa};
            const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[COR_LAW_VISCOELASTIC], 0, 0),
                                           l = scaled_contact(&cor_law_exponents[COR_LAW_LINEAR], 0.2, 0);
            struct cor_oblique_impact o, still;
            assert_int_equal(cor_scene_oblique(&o, &c, &t, INFINITY, 1, 2, 0), COR_OK);
            assert_int_equal(cor_scene_oblique(&still, &c, &t, 0.3, 1, 0, 0), COR_OK);
            assert_true(o.regime == COR_OBLIQUE_STICKS && still.regime == COR_OBLIQUE_STICKS);
            assert_true(fabs(o.restitution - still.restitution) < 1e-13 && still.rebound_tangent == 0);
            assert_true(fabs(o.eps - 1) < 1e-12 && fabs(o.impulse - 2 * (1 - o.restitution) / 3.5) < 1e-14);
            if (memory == COR_REMEMBERS_DISPLACEMENT || memory == COR_REMEMBERS_FORCE)
                check(fabs(o.restitution - cor_tangential_no_slip(*kappa, 1.5)) < 1e-11, "%d %g", memory, *kappa);
            assert_true(restitution(&c, &t, 0, 2, 0) == 1);
            if (memory == COR_REMEMBERS_NOTHING)
                continue;
            assert_int_equal(cor_scene_oblique(&o, &c, &t, 0.1, 1, 30, 1), COR_OK);
            assert_true(o.regime == COR_OBLIQUE_SLIPS && fabs(o.rebound_tangent - 30 + 0.7) < 1e-11);
            /* at this tangential speed, a damped contact sticks at first only for a short time, with little loss */
            const double damped = restitution(&l, &t, 0.01, 1e4, 1), eps = scene_eps(&l, 1, 1);
            check(fabs(1e4 * (1 - damped) - 0.035 * (1 + eps)) < 1e-6, "%.12g", damped);
        }
    /* without slip, a weak spring and a strong damper stop the tangential motion */
    const struct cor_scene_contact d = scaled_contact(&cor_law_exponents[COR_LAW_LINEAR], 0.5, 0);
    const struct cor_tangential stiff = {.kappa = 1e-3, .damping = 60, .damper_in_cap = 1};
    assert_true(fabs(restitution(&d, &stiff, 1e6, 1, 0)) < 1e-3);
}

/* Returns u'/u by velocity Verlet in the units of the collision, as LAMMPS computes mindlin (or mindlin_rescale). */
static double simulated(const struct cor_scene_contact *c, const struct cor_tangential *t, double mu, double tangent,
                        double step, double phase)
{
    const double b = (double)c->law.damping / c->law.denominator;
    double x = -phase * step, v = 1, w = tangent, s = 0, force = 0, side = 0, before = 0;
    do {
        v -= step / 2 * force;
        w -= step / 2 * side;
        x += step * v;
        force = side = 0;
        if (x > 0) {
            s *= t->memory == COR_REMEMBERS_DISPLACEMENT_RESCALED && x < before ? sqrt(x / before) : 1;
            s += step * w;
            force = pow(x, 1.5) + cor_scene_beta(c, 1) * pow(x, b) * v;
            const double damped = t->damping * pow(x, b) * w, cap = 3.5 * mu * fabs(force);
            side = fmax(-cap, fmin(cap, t->kappa * sqrt(x) * s + damped));
            s = (side - damped) / (t->kappa * sqrt(x));
        }
        before = x;
        v -= step / 2 * force;
        w -= step / 2 * side;
    } while (x > 0 || v > 0);
    return w / tangent;
}

/* The time step for a damper that reaches the friction limit at the first touch */
TEST(needed_step)
{
    struct cor_oblique_impact o;
    for (size_t k = points(few_or_all(20, 200)); k > 0;) {
        const int law = random_below(&draw, 3) ? COR_LAW_TSUJI : COR_LAW_HERTZ_DASHPOT;
        const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[law], random_log(&draw, 1e-2, 1), 0);
        const double mu = random_log(&draw, 0.03, 1.5), tangent = mu * random_log(&draw, 0.1, 30);
        const struct cor_tangential t = {.memory = random_below(&draw, 2) ? COR_REMEMBERS_DISPLACEMENT_RESCALED : 0,
                                         .kappa = random_log(&draw, 1, 10),
                                         .damper_in_cap = 1,
                                         .damping = 3.5 * random_log(&draw, 0.1, 3) * cor_scene_beta(&c, 1)};
        const int fills = t.damping * tangent > 3.5 * mu * cor_scene_beta(&c, 1);
        assert_int_equal(cor_scene_oblique(&o, &c, &t, mu, 1, tangent, 0), COR_OK);
        assert_true(isnan(o.restitution) || fills == (isless(o.time_step_s, 1) != 0));
        if (isnan(o.restitution) || !fills || o.time_step_s < 3e-4)
            continue;
        const double seen = simulated(&c, &t, mu, tangent, fmin(o.time_step_s, 0.01), random_uniform(&draw, 0, 1));
        check(fabs(seen - o.restitution) < COR_OBLIQUE_STEP_ERROR,
              "law %d beta %.17g memory %d kappa %.17g damping %.17g mu %.17g tangent %.17g: %g, not %g", law,
              cor_scene_beta(&c, 1), t.memory, t.kappa, t.damping, mu, tangent, seen, o.restitution);
        k--;
    }
    const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[COR_LAW_TSUJI], 0.2, 0);
    struct cor_tangential t = {.kappa = 4.3, .damping = 0.35, .damper_in_cap = 1};
    assert_int_equal(cor_scene_oblique(&o, &c, &t, 0.3, 1, 1, 0), COR_OK);
    assert_true(fabs(o.time_step_s - 5.0456e-5) < 1e-8); /* 0.0645844/5/256, by hand */
    assert_true(fabs(simulated(&c, &t, 0.3, 1, 50 * o.time_step_s, 0.5) - o.restitution) > COR_OBLIQUE_STEP_ERROR);
    t.damper_in_cap = 0;
    assert_int_equal(cor_scene_oblique(&o, &c, &t, 0.3, 1, 1, 0), COR_OK);
    assert_true(isinf(o.time_step_s));
}

TEST(refused_numbers)
{
    const struct cor_scene_contact c = scaled_contact(&cor_law_exponents[COR_LAW_VISCOELASTIC], 0.1, 0);
    const struct cor_scene_contact held = scaled_contact(&cor_law_exponents[COR_LAW_VISCOELASTIC], 1, 0.3);
    struct cor_scene_contact other[] = {c, c, c};
    const struct cor_tangential good = {.kappa = 4};
    struct cor_tangential bad[] = {{.kappa = -1}, {.kappa = NAN}, {.kappa = 1, .damping = -1}, {.memory = 5}};
    struct cor_oblique_impact o;
    other[0].plate = 1;
    other[1].liquid_speed_m_s = 0.1;
    other[2].adhesion_j_m2 = 0.1;
    for (size_t i = 0; i < COUNT_OF(other); i++)
        assert_int_equal(cor_scene_oblique(&o, &other[i], &good, 0.3, 1, 1, 0), COR_FAULT_RANGE);
    for (size_t i = 0; i < COUNT_OF(bad); i++)
        assert_int_equal(cor_scene_oblique(&o, &c, &bad[i], 0.3, 1, 1, 0), COR_FAULT_RANGE);
    EACH (x, -1, NAN)
        assert_true(cor_scene_oblique(&o, &c, &good, *x, 1, 1, 0) == COR_FAULT_RANGE &&
                    cor_scene_oblique(&o, &c, &good, 0.3, *x, 1, 0) == COR_FAULT_RANGE &&
                    cor_scene_oblique(&o, &c, &good, 0.3, 1, *x, 0) == COR_FAULT_RANGE && isnan(o.restitution));
    assert_true(cor_scene_oblique(&o, &held, &good, 0.3, 1, 1, 0) == COR_OK && isnan(o.restitution) && o.regime == 0);
    /* damped so strongly that the bodies never part at zero overlap */
    EACH (law, COR_LAW_LINEAR, COR_LAW_HERTZ_DASHPOT) {
        const struct cor_scene_contact stays = scaled_contact(&cor_law_exponents[(int)*law], 5, 0);
        assert_true(cor_scene_oblique(&o, &stays, &good, 0.3, 1, 1, 0) == COR_OK && isnan(o.restitution));
        assert_true(cor_scene_oblique(&o, &stays, &good, 0.3, 1, 1, 1) == COR_OK && o.eps > 0 && o.eps < 0.1);
    }
}
