/* SPDX-License-Identifier: MIT */
/* Tests enclosed collisions of any power law against direct integrations by other programs. Tests the series, the
 * closed forms and the slow manifold against the motion. Tests thresholds and the asymptotics of docs/theory.md, 9. */
#include "ball.h"

#include <unistd.h>

#include "../reference/ode.h"
#include "enclosure/closed_form.h"
#include "enclosure/collision.h"
#include "enclosure/motion.h"
#include "enclosure/slow_manifold.h"
#include "series/restitution.h"

static const slong PREC = 600;

static void set_number(arb_t x, const char *text)
{
    LOCAL(fmpq, q);
    if (strchr(text, '/') && fmpq_set_str(q, text, 10) == 0)
        arb_set_fmpq(x, q, PREC);
    else
        assert_int_equal(arb_set_str(x, text, PREC), 0);
}

static void collision_of(struct collision *c, const char *beta, const struct cor_exponents *law, slong bits)
{
    LOCAL(arb, x);
    set_number(x, beta);
    assert_int_equal(collision_solve(c, x, law, bits), 0);
}

/* ---- values ---- */

/* Final speeds, thresholds and largest forces (over all peaks) agree with a Taylor method of mpmath in 30 digits. */
TEST(test_known_values)
{
    static const char *const known[][4] = {
        {"3/2", "1/2", NULL, "5.158381704267685216414306"},
        {"1", "1/2", NULL, "1.164851686794881988247080"},
        {"1", "1/4", NULL, "2.200399437627255818774633"},
        {"3/2", "3/4", NULL, "1.565682010609567453723451"},
        {"3/2", "1", NULL, "1.171163520514752061878210"},
        {"3/2", "1/3", NULL, "2773.778352292957387496648"},
        {"2", "1", NULL, "2.312529479726488376853578"},
        {"1", "2", NULL, "1.003082882448614883279965"},
        {"3/2", "2", NULL, "0.962408308157971724827216"},
        {"5/2", "1", NULL, "43.93446711299146524909560"},
        {"1/2", "0", NULL, "1.156264739863244188426789"},
        {"2", "3/4", NULL, "14.14471851749285544858152"},
        {"3/2", "3/2", NULL, "1.000000000000000000000000"},
        {"0", "0", NULL, "1.000000000000000000000000"},
        {"2", "0", NULL, "0.893418920406822391217901"},
        {"2", "1/4", NULL, "1.373179906839651113496148"},
        {"3", "0", NULL, "0.703904969011338841807913"},
        {"5/2", "0", NULL, "0.774823419665093189770702"},
        {"3", "1/2", NULL, "1.324417837320823384052893"},
        {"1", "0", "0.4", "0.820918521755729634032"},
        {"1", "0", "1.00000000000000000000000000000000000000000000000001", "1.00000000000000000"}, /* needs 166 bits */
        {"1", "0", "3", "3.00000000000000000"},
        {"3/2", "1/2", "0.5", "0.916480541415681004443"},
        {"3/2", "1/2", "2", "1.02525803288663656746"},
        {"3/2", "0", "0.7", "0.740467087348158470513"},
        {"3/2", "0", "0.8", "0.800000000000000000"},
        {"3/2", "0", "1.3", "1.30000000000000000"},
        {"3/2", "1/4", "1", "0.828995201887272359413"},
        {"3/2", "3/2", "2", "1.10425499427189254098"},
        {"2", "1/2", "0.6", "0.918533331227900162579"},
        {"1", "1/2", "1.5", "1.01785453302894993159"},
        {"1", "2", "1", "1.03227986139330523459"},
        {"3/2", "1/2", "0", "1.14326262981831586601"},
    };
    enum { SPEEDS = 14, THRESHOLDS = 5 };
    const struct cor_exponents tsuji = law_of("3/2", "1/4"), hertz = law_of("3/2", "0"), several = law_of("2", "1/8");
    LOCAL(arb, beta, value, c_star);
    for (size_t i = left_to_turn(1, 3) ? SPEEDS : 0; i < COUNT_OF(known); i++) {
        const struct cor_exponents law = law_of(known[i][0], known[i][1]);
        const bool force = i >= SPEEDS + THRESHOLDS, speed = i < SPEEDS;
        if (force)
            set_number(beta, known[i][2]);
        assert_int_equal(force   ? collision_force_max(value, beta, &law, 90)
                         : speed ? collision_final_speed(value, &law, 90)
                                 : collision_threshold(value, c_star, &law, 85),
                         0);
        assert_digits(value, known[i][3]);
        assert_bits(value, force || speed ? 90 : 85);
    }
    assert_int_equal(collision_h_star(value, 90), 0);
    assert_digits(value, "1.388361925615829410");
    assert_int_equal(collision_threshold(value, c_star, &hertz, 140), 0);
    assert_bits(value, 140);
    assert_bits(c_star, 140);
    assert_digits(value, "1.127988135520169216213166580023238450374");
    assert_digits(c_star, "0.352545567978675826201665210787138910");
    assert_true(collision_final_speed(value, &tsuji, 60) == 1 && collision_final_speed(value, &hertz, 60) == 1 &&
                collision_threshold(value, c_star, &law_sphere, 60) == 1 &&
                collision_force_max(value, beta, &several, 90) == 1);
}

/* a, b, beta and the six fields; NULL: no other program gave a value */
static const char *const collisions[][3 + COLLISION_FIELDS] = {
    {"1", "0", "1/2", "0.444344225088488753", "0.506276552518630332", "3.244622940778889517", "2.722688850069176642",
     "0.711531132501333586", "1.361344425034588321"},
    {"1", "0", "4", "0", "0.047768732505620189", "inf", "1.520691992601892695", NULL, NULL},
    {"1", "1", "1", "0.593624260040040092", "0.593624260040040092", "3.222399315523942771", "3.222399315523942771",
     "0.783393667883593108", "1.34537872174229236"},
    {"3/2", "3/2", "1", "0.593624260040040092", "0.593624260040040092", "3.475683527067974480", "3.475683527067974480",
     "0.899389992119600589", NULL},
    {"2", "2", "10", "0.099981624752943886", "0.099981624752943886", NULL, NULL, NULL, NULL},
    {"3/2", "0", "1/2", "0.356912974176213893", "0.468038544824803370", "3.674312264397680617", "2.782528143330340519",
     "0.791261564952323956", NULL},
    {"3/2", "0", "1", "0.041320343494337112", "0.251843353467950750", NULL, NULL, NULL, NULL},
    {"3/2", "0", "5", "0", "0.015357698164110697", "inf", NULL, NULL, NULL},
    {"3/2", "0", "1.127988135520169216213166580023238450374", NULL, "0.218449655319366605", NULL, NULL,
     "0.570733527712282338", NULL},
    {"3/2", "0", "30", "0", NULL, "inf", NULL, NULL, NULL},
    {"3/2", "1/4", "2.5", "0", NULL, "inf", NULL, NULL, NULL},
    /* Tsuji's law at zeta = 1/4 and 2, with beta = sqrt(5) zeta */
    {"3/2", "1/4", "0.559016994374947424102293417182819058860154589902881431", "0.444344225088488753",
     "0.506276552518630332", "3.585839815827821764", "2.828408309179784348", "0.832758608536924381",
     "1.468372332360592689"},
    {"3/2", "1/4", "4.472135954999579392818347337462552470881236719223051448", NULL, "0.047768732505620189", NULL,
     "1.903214870431890414", NULL, NULL},
    {"3/2", "1/2", "0.1", "0.892147587290229345", NULL, NULL, NULL, NULL, NULL},
    {"3/2", "1/2", "0.5", "0.573824628664948983", "0.595251501135126961", NULL, NULL, NULL, NULL},
    {"3/2", "1/2", "1", "0.331164810466640935", "0.393930603229873193", NULL, NULL, NULL, NULL},
    {"3/2", "1/2", "2", "0.095330365354151543", "0.211646054603642811", NULL, NULL, NULL, NULL},
    {"3/2", "1/2", "5", "0.001650682071773317", NULL, NULL, NULL, NULL, NULL},
    {"3/2", "1/2", "10", NULL, "0.02509570443151839", NULL, NULL, NULL, NULL},
};

TEST(test_collisions)
{
    LOCAL(collision, c);
    for (size_t i = 0; i < COUNT_OF(collisions); i++) {
        const char *const *const text = collisions[i] + 3;
        const struct cor_exponents law = law_of(collisions[i][0], collisions[i][1]);
        LOCAL(arb, beta);
        set_number(beta, collisions[i][2]);
        assert_int_equal((text[0] ? collision_solve : collision_solve_force)(c, beta, &law, 90), 0);
        for (int k = 0; k < COLLISION_FIELDS; k++) {
            if (text[k] && strcmp(text[k], "inf") == 0)
                assert_true(arf_is_pos_inf(arb_midref(c->field[k])));
            else if (text[k] && strcmp(text[k], "0") == 0)
                assert_true(arb_is_zero(c->field[k]));
            else if (text[k])
                assert_digits(c->field[k], text[k]);
        }
    }
    const struct cor_exponents dashpot = law_of("3/2", "0"), tsuji = law_of("3/2", "1/4");
    collision_of(c, "1.127988", &dashpot, 90); /* near the threshold a second attempt with more bits is needed */
    assert_bits(c->eps_zero_overlap, 90);
    /* Here |zeta - 1| < 1e-3, and eps = exp(-pi zeta/sqrt(1 - zeta^2)) is 3e-61. */
    collision_of(c, "2.2355", &tsuji, 90);
    assert_true(arb_is_positive(c->eps_zero_overlap));
    assert_bits(c->eps_zero_overlap, 90);
    assert_bits(c->t_zero_overlap, 90);
}

/* ---- two routes ---- */

/* eps_zero_force = eps_zero_overlap G(w) and t_zero_force = t_zero_overlap - eps^(-1/5) h T(w), where w = h^(5/2). */
TEST(test_backward_series)
{
    enum { ORDER = 24 };
    static const char *const betas[] = {"1e-12", "0.02", "0.1"};
    LOCAL(fmpq_poly, G, T);
    LOCAL(arb_poly, f);
    LOCAL(collision, c);
    LOCAL(arb, w, x, beta);
    restitution_zero_force_exact(G, T, ORDER, &law_sphere);
    for (size_t i = 0; i < COUNT_OF(betas); i++) {
        collision_of(c, betas[i], &law_sphere, 90);
        arb_set_str(beta, betas[i], PREC);
        LET(w, PREC, "beta^(5/2)*sqrt(c->eps_zero_overlap)", beta, c->eps_zero_overlap);
        arb_poly_set_fmpq_poly(f, G, PREC);
        arb_poly_evaluate(x, f, w, PREC);
        arb_add_error_2exp_si(x, -80);
        assert_is(c->eps_zero_force, "eps", (slong)i, "x*c->eps_zero_overlap", x, c->eps_zero_overlap);
        arb_poly_set_fmpq_poly(f, T, PREC);
        arb_poly_evaluate(x, f, w, PREC);
        arb_add_error_2exp_si(x, -80); /* eps^(-1/5) h = beta */
        assert_is(c->t_zero_force, "time", (slong)i, "c->t_zero_overlap - x*beta", c->t_zero_overlap, x, beta);
    }
}

/* The integrated motion agrees with closed forms. For an overdamped contact the overlap decays without reaching
 * zero. */
TEST(test_closed_forms)
{
    static const char *const laws[][2] = {{"1", "0"}, {"3/2", "1/4"}, {"3", "1"},
                                          {"2", "2"}, {"1/2", "1/2"}, {"0", "0"}};
    static const char *const betas[] = {"1e-9", "0.3", "1.2", "1.99", "2.3", "4", "9"};
    LOCAL(collision, motion, closed);
    LOCAL(arb, beta);
    for (size_t i = 0; i < COUNT_OF(laws); i++)
        for (size_t k = 0; k < COUNT_OF(betas); k++) {
            const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
            const slong index = (slong)(10 * i + k);
            set_number(beta, betas[k]);
            assert_int_equal(motion_solve(motion, beta, &law, MOTION_ZERO_OVERLAP, 200), MOTION_DONE);
            if (law_is_linear(&law))
                closed_form_linear(closed, beta, &law, 200);
            else
                closed_form_hunt_crossley(closed, beta, &law, 200);
            assert_bits(closed->eps_zero_force, 80);
            assert_bits(motion->eps_zero_force, 80);
            assert_overlap(motion->x_max, closed->x_max, "x_max", index);
            assert_overlap(motion->eps_zero_force, closed->eps_zero_force, "eps at zero force", index);
            assert_overlap(motion->eps_zero_overlap, closed->eps_zero_overlap, "eps at zero overlap", index);
            if (law_is_linear(&law) && !arb_is_finite(closed->t_zero_overlap))
                assert_true(arf_is_pos_inf(arb_midref(motion->t_zero_overlap)));
            else if (law_is_linear(&law))
                assert_overlap(motion->t_zero_overlap, closed->t_zero_overlap, "duration", index);
            if (law.elastic == 0) { /* a = b = 0, a constant force */
                assert_is(motion->t_max, "t_max", index, "log1p(beta)/beta", beta);
                assert_is(motion->t_zero_overlap, "duration", index,
                          "(log1p(beta) - log1p(-beta*closed->eps_zero_overlap))/beta", beta, closed->eps_zero_overlap);
            }
            if (i == 0) {
                assert_overlap(motion->t_max, closed->t_max, "t_max", index);
                assert_overlap(motion->t_zero_force, closed->t_zero_force, "duration to zero force", index);
            }
        }
}

/* At beta = 0 the two ends of contact coincide. For an interval of beta that begins there, the enclosure must contain
 * the results of every beta in the interval. */
TEST(test_wide_beta)
{
    static const char *const laws[][2] = {{"2", "0"}, {"3", "0"}, {"3", "1"}, {"3/2", "1/2"}};
    LOCAL(collision, wide, one);
    LOCAL(arb, beta, zero);
    size_t enclosed = 0;
    for (size_t i = 0; i < 40; i++) {
        const struct cor_exponents law = law_of(laws[i % COUNT_OF(laws)][0], laws[i % COUNT_OF(laws)][1]);
        arb_set_d(beta, random_log(&draw, 1e-7, 1e-2));
        assert_int_equal(motion_solve(one, beta, &law, MOTION_ZERO_OVERLAP, 60), MOTION_DONE);
        arb_union(beta, beta, zero, 60);
        if (motion_solve(wide, beta, &law, MOTION_ZERO_OVERLAP, 60) != MOTION_DONE)
            continue;
        for (int k = 0; k < COLLISION_FIELDS; k++)
            assert_overlap(wide->field[k], one->field[k], "field", k);
        enclosed++;
    }
    assert_true(enclosed > 8);
}

/* A(1 + d) = 1 - d/3 + 2 d^2/15 - 2 d^3/35 + O(d^4). Elsewhere A is compared with its two formulas, also on both sides
 * of 3/4 and 5/4, where the code switches to the hypergeometric function. */
TEST(test_angle)
{
    static const double places[] = {0, 0.749, 0.75, 0.751, 1.249, 1.25, 1.251, 1e300};
    LOCAL(arb, zeta, d, x, y);
    for (int sign = -1; sign <= 1; sign++) {
        LET(d, PREC, "sign/2^40", sign);
        LET(zeta, PREC, "1 + d", d);
        closed_form_angle(x, zeta, 200);
        LET(y, PREC, "1 - d/3 + 2*d^2/15 - 2*d^3/35", d);
        arb_add_error_2exp_si(y, -160);
        assert_overlap(x, y, "A near 1", sign);
    }
    for (size_t i = 0; i < COUNT_OF(places); i++) {
        arb_set_d(zeta, places[i]);
        closed_form_angle(x, zeta, 200);
        assert_bits(x, 180);
        if (places[i] < 1)
            assert_is(x, "A", (slong)i, "acos(zeta)/sqrt(1 - zeta^2)", zeta);
        else
            assert_is(x, "A", (slong)i, "acosh(zeta)/sqrt(zeta^2 - 1)", zeta);
    }
}

/* The slow manifold agrees with the full motion in hundreds of bits, for laws with a - b below 1, equal to 1 and above
 * 1, a < b and a = b. */
TEST(test_slow_manifold)
{
    leave_to_turn(0, 3);
    static const char *const cases[][3] = {
        {"1", "1/2", "22"}, {"2", "1", "16"},   {"5/2", "1", "12"}, {"3/2", "1", "32"},   {"3/2", "1/2", "12"},
        {"1", "2", "700"},  {"1/2", "0", "12"}, {"1", "1", "85"},   {"0", "1/2", "1000"},
    };
    LOCAL(collision, slow, direct);
    LOCAL(arb, beta, p, slope);
    for (size_t i = 0; i < COUNT_OF(cases); i++) {
        const struct cor_exponents law = law_of(cases[i][0], cases[i][1]);
        const struct slow_manifold *const m = slow_manifold_of(&law, 24, 250);
        arb_poly_evaluate2(p, slope, m->p, m->last, 250);
        assert_false(HOLDS(250, "abs(1 - p + (law.a - law.b)*m->last*p^2 - m->n*m->last^2*p*slope) > m->nu", p, &law,
                           m->last, m->n, slope, m->nu));
        LET(beta, 250, "m->last*(1 - 1/2^100)", m->last);
        arb_poly_evaluate(p, m->p, beta, 250);
        assert_true(slow_manifold_time(slope, m, beta, p, 24)); /* zero up to its error */
        arf_set_mag(arb_midref(slope), arb_radref(slope));
        mag_zero(arb_radref(slope));
        assert_true(HOLDS(250, "2*slope > m->time_error", slope, m->time_error));
        set_number(beta, cases[i][2]);
        assert_int_equal(motion_solve_slow(slow, beta, &law, 24, 250), MOTION_DONE);
        assert_int_equal(motion_solve(direct, beta, &law, MOTION_ZERO_OVERLAP, 450), MOTION_DONE);
        assert_bits(slow->eps_zero_overlap, 18);
        assert_bits(slow->t_zero_overlap, 18);
        assert_bits(direct->eps_zero_overlap, 100);
        assert_bits(direct->t_zero_overlap, 100);
        for (int k = 0; k < COLLISION_FIELDS; k++)
            assert_overlap(slow->field[k], direct->field[k], "field", 10 * (slong)i + k);
    }
}

/* The c of eps = v_f beta^(-1/q) (1 - c beta^P exp(-k/mu)) is nearly the same at three beta (docs/theory.md, 9). */
TEST(test_forgetting)
{
    leave_to_turn(4, 3);
    static const struct {
        const char *a, *b;
        double beta, step;
    } cases[] = {{"3/2", "1/2", 4, 0.5}, {"1", "1/2", 8, 1}, {"2", "1", 6, 1},
                 {"3/2", "1", 10, 1},    {"2", "2", 20, 2},  {"3/2", "1/3", 4, 0.5}};
    LOCAL(arb, v, beta, x);
    LOCAL(collision, c);
    /* the last case, P = 41, takes a second, so only long runs test it */
    const size_t count = COUNT_OF(cases) - (points(1) > 1 ? 0 : 1);
    for (size_t i = 0; i < count; i++) {
        const struct cor_exponents law = law_of(cases[i].a, cases[i].b);
        const struct ratio speed_power = law_speed_exponent(&law);
        const double a = ratio_double(law_elastic(&law)), b1 = ratio_double(law_damping(&law)) + 1;
        const double n = ratio_double(law_fall_power(&law)), q = n / (a + 1);
        const double P = 1 / q + 2 * (a - b1 + 1) * (2 / n - 1 / b1), k = law_forgetting(&law);
        double constant[3];
        assert_int_equal(collision_final_speed(v, &law, 120), 0);
        for (int j = 0; j < 3; j++) {
            const double at = cases[i].beta + j * cases[i].step;
            arb_set_d(beta, at);
            assert_int_equal(collision_solve_overlap(c, beta, &law, 110), 0);
            LET(x, PREC, "1 - beta^(1/speed_power)*c->eps_zero_overlap/v", beta, speed_power, c->eps_zero_overlap, v);
            assert_true(arb_is_positive(x));
            arb_log(x, x, PREC);
            constant[j] = middle(x) - P * log(at) + k * pow(at, (a + 1) / b1);
        }
        /* an error of 1 % in k or of 0.1 in P would change c by more */
        assert_true(fabs(constant[1] - constant[0]) < 0.1);
        assert_true(fabs(constant[2] - constant[1]) < fabs(constant[1] - constant[0]) + 1e-12);
    }
}

/* For the law (3/2, 1/3) at beta = 4.1 and 12 bits, the estimate of the contraction lacks a factor beta^41. So the
 * motion misses the manifold at every precision, and the unloading is integrated instead. */
TEST(test_missed_manifold)
{
    leave_to_turn(1, 3);
    const struct cor_exponents law = law_of("3/2", "1/3");
    LOCAL(collision, one, other);
    LOCAL(arb, beta);
    set_number(beta, "4.1");
    assert_int_equal(motion_solve_slow(one, beta, &law, 24, 230), MOTION_MISSED);
    assert_int_equal(collision_solve_overlap(one, beta, &law, 12), 0);
    assert_int_equal(collision_solve_overlap(other, beta, &law, 24), 0);
    assert_bits(one->eps_zero_overlap, 12);
    assert_overlap(one->eps_zero_overlap, other->eps_zero_overlap, "eps", 0);
    assert_overlap(one->t_zero_overlap, other->t_zero_overlap, "duration", 0);
    set_number(beta, "4.3");
    assert_int_equal(motion_solve_slow(one, beta, &law, 24, 230), MOTION_DONE);
    assert_int_equal(motion_solve(other, beta, &law, MOTION_ZERO_OVERLAP, 230), MOTION_DONE);
    assert_overlap(one->eps_zero_overlap, other->eps_zero_overlap, "eps", 1);
}

/* At the distance d below the threshold beta_c of the law (3/2, 0), eps = s d (1 + pi sqrt(s d/beta_c^5) + O(d ln d)),
 * and beta t + ln(eps) approaches 3.06410. Just above it eps is exactly 0. */
TEST(test_below_threshold)
{
    leave_to_turn(2, 3);
    const struct cor_exponents law = law_of("3/2", "0");
    LOCAL(collision, c);
    LOCAL(arb, beta_c, d, s, x, y);
    assert_int_equal(collision_threshold(beta_c, s, &law, 200), 0);
    arb_set_str(s, "0.206987698804278902", PREC);
    for (slong bits = 20; bits <= 60; bits += 20) {
        LET(x, PREC, "beta_c - 1/2^bits", beta_c, bits);
        arb_get_mid_arb(x, x);
        LET(d, PREC, "s*(beta_c - x)", s, beta_c, x);
        assert_int_equal(collision_solve_overlap(c, x, &law, 80), 0);
        const arb_srcptr eps = c->eps_zero_overlap, t = c->t_zero_overlap;
        LET(y, PREC, "log(eps) + x*t", eps, x, t);
        assert_true(fabs(middle(y) - 3.06410) < 6e-6 + 10 * pow(2, -(double)bits / 2));
        LET(y, PREC, "eps/d - pi*sqrt(d/beta_c^5) - 1", eps, d, beta_c);
        assert_true(fabs(middle(y)) < 3 * (double)bits * pow(2, -(double)bits) + 1e-17);
        /* now above the threshold, at the same distance */
        LET(x, PREC, "beta_c + 1/2^bits", beta_c, bits);
        assert_int_equal(collision_solve(c, x, &law, 60), 0);
        assert_true(arb_is_zero(c->eps_zero_overlap));
        assert_true(arf_is_pos_inf(arb_midref(c->t_zero_overlap)));
    }
}

/* ---- asymptotics ---- */

/* Let Xinf be the limit of the scaled largest overlap for large beta. At zero force
 *     eps = mu Xinf^(a-b) (1 - 2 (a-b) Xinf^(a-2b-1) mu ln(1/mu) + O(mu)),
 *     duration = beta^(-1/(b+1)) (2 Xinf^-b ln(1/mu) + O(1)).
 * The remainders O(mu)/mu and O(1) vary little with beta. */
TEST(test_strong_force)
{
    static const char *const laws[][2] = {{"3/2", "0"},   {"1", "0"}, {"3/2", "1/4"},
                                          {"3/2", "1/2"}, {"2", "1"}, {"1", "1/2"}};
    LOCAL(collision, c);
    LOCAL(arb, beta);
    for (size_t i = 0; i < COUNT_OF(laws); i++) {
        const struct cor_exponents law = law_of(laws[i][0], laws[i][1]);
        const double a = ratio_double(law_elastic(&law)), b = ratio_double(law_damping(&law));
        const double X = pow(b + 1, 1 / (b + 1));
        double eps_rest[2], time_rest[2];
        for (int k = 0; k < 2; k++) {
            const double at = k ? 4e3 : 1e3, mu = pow(at, -(a + 1) / (b + 1));
            LOCAL(arb, x);
            arb_set_d(beta, at);
            assert_int_equal(collision_solve_force(c, beta, &law, 90), 0);
            const struct ratio mu_power = law_mu_power(&law);
            LET(x, PREC, "c->eps_zero_force*beta^mu_power*(law.b + 1)^((law.b - law.a)/(law.b + 1)) - 1",
                c->eps_zero_force, beta, mu_power, &law);
            eps_rest[k] = middle(x) / mu + 2 * (a - b) * pow(X, a - 2 * b - 1) * -log(mu);
            time_rest[k] = middle(c->t_zero_force) * pow(at, 1 / (b + 1)) + 2 * pow(X, -b) * log(mu);
            if (i == 0) { /* J = psi(5/2) + gamma */
                const double J = 1.280372305546776;
                assert_true(fabs(eps_rest[k] - 1.5 * (log(1.5) + J + 1)) < 300 * mu * log(mu) * log(mu));
                assert_true(fabs(time_rest[k] + log(1.5)) < 100 * mu * log(mu) * log(mu));
            }
        }
        assert_true(fabs(eps_rest[1] - eps_rest[0]) < 0.05);
        assert_true(fabs(time_rest[1] - time_rest[0]) < 0.01);
    }
}

/* For the law (1, 0) with beta = 5/2 under the force 9/20, the overlap rises beyond its value at rest and turns once,
 * at t = 2 ln(31)/3. */
TEST(test_turns_beyond_rest)
{
    const struct cor_exponents law = law_of("1", "0");
    LOCAL(collision, c);
    LOCAL(arb, beta, force);
    set_number(beta, "5/2");
    set_number(force, "9/20");
    assert_int_equal(collision_solve_pressed(c, beta, force, &law, 0, 60), 0);
    assert_is(c->x_max, "x_max", 0, "(9 + 31^(-1/3))/20");
    assert_is(c->t_max, "t_max", 0, "2*log(31)/3");
}

/* ---- the surface under a constant force ---- */

/* x'' + beta x^b x' + x^a = force, x = w^d, y = {w, x', t, loss}; loss: energy that the damping dissipated */
struct pressed_law {
    struct cor_exponents law;
    long double beta, force;
};

static void pressed_slopes(long double *slope, const long double *y, const void *of)
{
    const struct pressed_law *const p = of;
    const long double damping = p->beta * motion_power(y[0], (int)p->law.damping) * y[1];
    slope[0] = y[1];
    slope[2] = (long double)p->law.denominator * motion_power(y[0], (int)p->law.denominator - 1);
    slope[1] = slope[2] * (p->force - damping - motion_power(y[0], (int)p->law.elastic));
    slope[3] = slope[2] * damping * y[1];
}

/* Returns a value that falls to 0 with the contact force or the overlap, whichever vanishes first. */
static long double pressed_contact(const long double *y, const void *of)
{
    const struct pressed_law *const p = of;
    const int power = (int)(p->law.elastic - p->law.damping);
    return power > 0 ? fminl(y[0], p->beta * y[1] + motion_power(y[0], power)) : y[0];
}

static long double pressed_turn(const long double *y, const void *of)
{
    (void)of;
    return -y[1];
}

/* Returns eps^2 at the surface, which is not positive if the bodies stay together. y becomes the state where the
 * contact ends. The following flight loses its initial elastic energy. The motion turns twice if the damping dissipates
 * all energy, or if rounding hides the end of contact under a large force. */
static long double surface_by_loss(long double y[4], const struct pressed_law *p)
{
    const long double a = ratio_double(law_elastic(&p->law)), size = powl(fmaxl(1, p->force), 1 / a);
    const long double h = 0.1L * powl(size, 1 / (long double)p->law.denominator) / fmaxl(1, sqrtl(p->force * size));
    static ode_value *const values[] = {pressed_contact, pressed_turn};
    struct ode o = {.slopes = pressed_slopes, .of = p, .n = 4, .longest = h};
    int ends = -1;
    memcpy(y, (const long double[4]){0, 1, 0, 0}, 4 * sizeof *y);
    while (ends < 0)
        ends = ode_until(&o, y, values, 2);
    const long double x = ends == 0 ? motion_power(fmaxl(y[0], 0), (int)p->law.denominator) : 0;
    const long double rest = 1 - 2 * y[3] - 2 * powl(x, a + 1) / (a + 1);
    y[2] += 2 * x / (sqrtl(fmaxl(rest, 0)) - y[1]);
    return rest;
}

/* Laws with a - b from -1 to 3, forces up to 1e12, and damping that dissipates any part of the energy */
TEST(test_surface)
{
    LOCAL(collision, c);
    LOCAL(arb, beta, force);
    for (size_t i = 0; i < points(24); i++) {
        char a[16], b[16];
        long double y[4];
        const size_t d = 1 + random_below(&draw, i % 2 ? 3 : 2);
        snprintf(a, sizeof a, "%zu/%zu", d + random_below(&draw, 2 * d + 1), d);
        snprintf(b, sizeof b, "%zu/%zu", random_below(&draw, 2 * d + 1), d);
        const double f = i % 2 ? random_log(&draw, 1e-3, 10) : random_log(&draw, 1, 1e12);
        struct pressed_law p = {law_of(a, b), 1e-40L, f};
        surface_by_loss(y, &p);
        const double strength = (double)(p.beta * 0.5L / y[3] * random_uniform(&draw, 0.1, 1.3));
        arb_set_d(beta, fmin(strength, 1.5));
        arb_set_d(force, f);
        p.beta = middle(beta);
        const long double rest = surface_by_loss(y, &p);
        if (fabsl(rest) < 1e-3L)
            continue; /* too close to the threshold */
        assert_int_equal(collision_solve_pressed(c, beta, force, &p.law, i % 3 ? 1 : -1, 60), 0);
        const double eps = middle(c->eps_zero_force);
        check(rest < 0 ? eps == 0 : fabsl(eps * (long double)eps - rest) < 1e-7L,
              "%s, %s, beta %.17g, force %.17g: eps %.17g, not %.17Lg", a, b, middle(beta), f, eps, sqrtl(rest));
        if (f <= 10)
            check(rest < 0 ? !arb_is_finite(c->t_zero_force) : fabsl(middle(c->t_zero_force) / y[2] - 1) < 1e-7L / rest,
                  "%s, %s, beta %.17g, force %.17g: %.17g, not %.17Lg", a, b, middle(beta), f, middle(c->t_zero_force),
                  y[2]);
    }
}

/* Tests the enclosure of the least force at which the bodies stay together: they part at its lower end, but not at its
 * upper end. The first case, beta = 6, is next to the damping above which no motion turns. */
TEST(test_sticking_force)
{
    static const char *const laws[][2] = {{"3/2", "1/2"}, {"1", "0"},   {"3/2", "0"}, {"2", "1"},
                                          {"1", "1/2"},   {"5/4", "1"}, {"3", "1"},   {"3/2", "3/2"}};
    LOCAL(collision, c);
    LOCAL(arb, beta, force, end);
    for (size_t i = 0; i < points(10); i++) {
        const struct cor_exponents law = law_of(laws[i % 8][0], laws[i % 8][1]);
        if (left_to_turn(i, 4))
            continue;
        const int at = i == 0 ? 0 : (int)random_below(&draw, 2);
        arb_set_d(beta, i == 0 ? 6 : random_log(&draw, 1e-6, law_force_ends(&law) ? 0.5 : 3));
        assert_int_equal(collision_sticking_force(force, beta, &law, at, 30), 0);
        assert_bits(force, 30);
        for (int above = 0; above < 2; above++) {
            (above ? arb_get_ubound_arf : arb_get_lbound_arf)(arb_midref(end), force, PREC);
            assert_int_equal(collision_solve_pressed(c, beta, end, &law, at, 20), 0);
            assert_true(above ? arb_is_zero(c->field[at]) : arb_is_positive(c->field[at]));
        }
    }
    /* The elastic force is 1 at every overlap, so only the force 1 balances it, whatever the speed. */
    const struct cor_exponents constant = law_of("0", "1");
    assert_int_equal(collision_sticking_force(force, beta, &constant, 0, 30), 0);
    assert_true(arb_is_one(force));
    assert_int_equal(collision_sticking_speed(force, beta, &constant, 0, 30), 1);
    for (int k = 0; k < 2; k++) { /* the motion never turns; under a force of 1 it ends at beta x^2/2 = 1 */
        arb_set_si(force, 1 + k);
        assert_int_equal(collision_solve_pressed(c, beta, force, &constant, -1, 30), 0);
        assert_true(arb_is_zero(c->eps_zero_overlap) && arb_is_zero(c->eps_zero_force) && !arb_is_finite(c->t_max));
        if (k == 0)
            LET(force, 100, "beta*c->x_max^2/2", beta, c->x_max);
        assert_true(k ? !arb_is_finite(c->x_max) : arb_contains_si(force, 1));
    }
}

/* ---- hard cases ---- */

/* zeta = 1, the doubles next to it, and values up to extremes. For tiny beta, only 1 - eps is a meaningful number. */
TEST(test_critical)
{
    const struct cor_exponents law = law_of("1", "0");
    LOCAL(collision, c);
    LOCAL(arb, beta, x);
    for (int side = -1; side <= 1; side++) {
        arb_set_d(beta, 2 + side * 0x1p-51);
        assert_int_equal(collision_solve(c, beta, &law, 90), 0);
        if (side < 0) {
            assert_true(arb_is_positive(c->eps_zero_overlap));
            assert_true(arb_is_finite(c->t_zero_overlap));
        } else {
            assert_true(arb_is_zero(c->eps_zero_overlap));
            assert_true(arf_is_pos_inf(arb_midref(c->t_zero_overlap)));
        }
        LET(x, PREC, "exp(-2)");
        arb_add_error_2exp_si(x, -50);
        assert_overlap(x, c->eps_zero_force, "exp(-2)", side);
    }
    collision_of(c, "1e300", &law, 60);
    LET(x, PREC, "10^600*c->eps_zero_force", c->eps_zero_force); /* 1/(4 zeta^2) = beta^-2 */
    assert_digits(x, "1.00000000000");
    collision_of(c, "1e-300", &law, 1100);
    LET(x, 1200, "(1 - c->eps_zero_overlap)*10^300", c->eps_zero_overlap);
    assert_digits(x, "1.570796326795"); /* pi zeta = pi beta/2 */
}

/* A solution for one end agrees with the solution for both, even if one step contains turning and zero force. */
TEST(test_one_end)
{
    static const char *const cases[][3] = {
        {"3/2", "1/2", "1"},  {"1", "2", "0.5"},    {"3/2", "1/4", "1"},  {"2", "2", "3"},         {"3/2", "0", "0.7"},
        {"0", "1", "1e-10"},  {"0", "2", "1e-10"},  {"2", "1", "1e3"},    {"3/2", "1/2", "1e-20"}, {"3/2", "1/2", "7"},
        {"3/2", "1/2", "12"}, {"3/2", "1/2", "40"}, {"3/2", "1/2", "1e6"}};
    LOCAL(collision, both, one);
    LOCAL(arb, beta, none);
    for (size_t i = 0; i < COUNT_OF(cases); i++) {
        const struct cor_exponents law = law_of(cases[i][0], cases[i][1]);
        set_number(beta, cases[i][2]);
        assert_int_equal(collision_solve(both, beta, &law, 70), 0);
        for (int end = 0; end < 2; end++) {
            assert_int_equal(collision_solve_pressed(one, beta, none, &law, end, 70), 0);
            for (int k = 0; k < COLLISION_FIELDS; k++)
                if (k > 3 || k % 2 == end)
                    assert_overlap(one->field[k], both->field[k], "field", (slong)(10 * i) + k);
            assert_bits(one->field[end ? 1 : 2], 70);
        }
    }
    static const double refused[] = {-1, INFINITY, NAN, 0}; /* at beta = 0 zero force is not a separate end */
    for (int i = 0; i < 4; i++) {
        arb_set_d(beta, refused[i]);
        assert_int_equal(collision_solve(both, beta, &law_sphere, 60), i < 3);
        assert_int_equal(collision_solve_overlap(both, beta, &law_sphere, 60), i < 3);
        assert_int_equal(collision_solve_force(both, beta, &law_sphere, 60), 1);
        assert_int_equal(collision_solve_pressed(both, beta, none, &law_sphere, 1, 60), i < 3);
    }
}

/* At 114 bits, these beta are too small for the slow manifold and too large for the full motion. The alarm ends a
 * solver that retries forever. The result must agree with the loading, and with eps = h*^5 beta^-5. */
TEST(test_between_methods)
{
    LOCAL(collision, c, loading);
    LOCAL(arb, beta, h);
    alarm(120);
    for (int k = 0; k < 2; k++) {
        arb_set_d(beta, k == 0 ? 13.155 : 12.5);
        assert_int_equal(collision_solve(c, beta, &law_sphere, 114), 0);
        assert_bits(c->eps_zero_overlap, 114);
        assert_bits(c->t_zero_overlap, 114);
        assert_int_equal(collision_solve_force(loading, beta, &law_sphere, 114), 0);
        assert_overlap(c->eps_zero_force, loading->eps_zero_force, "eps at zero force", k);
        assert_int_equal(collision_h_star(h, 114), 0);
        LET(h, PREC, "(h/beta)^5", h, beta);
        assert_true(HOLDS(PREC, "abs(c->eps_zero_overlap/h - 1) < 1/2^112", c->eps_zero_overlap, h));
    }
    alarm(0);
}

TEST(test_edges)
{
    LOCAL(collision, c);
    LOCAL(arb, x, y0, t0);
    turning_point_elastic(y0, t0, &law_sphere, PREC);
    collision_of(c, "0", &law_sphere, 200);
    assert_true(arb_is_one(c->eps_zero_overlap) && arb_is_one(c->eps_zero_force));
    assert_overlap(c->x_max, y0, "x_max", 0);
    arb_mul_2exp_si(t0, t0, 1);
    assert_overlap(c->t_zero_overlap, t0, "duration", 0);
    assert_overlap(c->t_zero_force, t0, "duration", 1);
    /* just below and above beta = 1, where the scales change */
    for (int side = -1; side <= 1; side++) {
        LET(x, PREC, "1 + side/2^60", side);
        assert_int_equal(collision_solve(c, x, &law_sphere, 100), 0);
        arb_add_error_2exp_si(c->eps_zero_overlap, -58);
        assert_digits(c->eps_zero_overlap, "0.3311648104666409");
    }
}
