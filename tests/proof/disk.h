/* SPDX-License-Identifier: MIT */
/* The goals of the contact law of the disk: part of goals.cpp. Each goal is about one stage of
 * runtime/number/lambert_w.c or runtime/disk/quasistatic.c: the result of `log` or `log1p` is a variable, so that a
 * goal does not depend on the accuracy of these functions. tests/accuracy/test_disk_proof.c adds the errors of the
 * stages, times what the later stages make of them, over cells that cover the domain; disk_errors.h has the errors for
 * both programs. */
#include "disk_errors.h"

/* ---- parts of lists of operations ---- */

static operation what_is(int id)
{
    return nodes()[(std::size_t)id].what;
}

static void expect(bool yes, const char *what)
{
    if (!yes)
        die(std::string(what) + " has changed");
}

/* Names the exact sum hi + lo of six operations (Knuth's theorem: no rounding error remains, for any two numbers). */
static void exact_two_sum(gappa &g, const struct cor_inline_pair &pair)
{
    const int hi = pair.hi.node(), lo = pair.lo.node();
    const char *const name = "cor_pair_two_sum";
    expect(what_is(hi) == ADD && what_is(lo) == ADD, name);
    const int x = first_of(hi), y = second_of(hi), left = first_of(lo), right = second_of(lo);
    expect(what_is(left) == SUBTRACT && what_is(right) == SUBTRACT && first_of(left) == x && first_of(right) == y,
           name);
    const int part = second_of(right), other = second_of(left);
    expect(what_is(part) == SUBTRACT && first_of(part) == hi && second_of(part) == x, name);
    expect(what_is(other) == SUBTRACT && first_of(other) == hi && second_of(other) == part, name);
    g.define(hi);
    const std::string sum = constant_of(y) == 0 ? g.rounded(x) : g.rounded(x) + " + " + g.rounded(y);
    g.text << g.rounded(lo) << " = (" << sum << ") - " << g.rounded(hi) << ";\n"
           << g.exact(lo) << " = " << g.rounded(lo) << ";\n";
    g.done[lo] = true;
}

/* The same for cor_inline_sum(a, b) if |a| >= |b| (Dekker's theorem). */
static void exact_sum(gappa &g, const struct cor_inline_pair &pair)
{
    const int hi = pair.hi.node(), lo = pair.lo.node();
    const char *const name = "cor_inline_sum";
    expect(what_is(hi) == ADD && what_is(lo) == SUBTRACT, name);
    const int a = first_of(hi), b = second_of(hi), z = second_of(lo);
    expect(first_of(lo) == b && what_is(z) == SUBTRACT && first_of(z) == hi && second_of(z) == a, name);
    g.define(hi);
    g.text << g.rounded(lo) << " = (" << g.rounded(a) << " + " << g.rounded(b) << ") - " << g.rounded(hi) << ";\n"
           << g.exact(lo) << " = " << g.rounded(lo) << ";\n";
    g.done[lo] = true;
}

/* A double that the goal takes from `interval`; its exact value is the same. */
static std::string cut(gappa &g, int id, const std::string &interval)
{
    g.text << g.rounded(id) << " = rnd(cut" << id << ");\n" << g.exact(id) << " = " << g.rounded(id) << ";\n";
    if (!interval.empty())
        g.hypotheses.push_back(g.rounded(id) + " in " + interval);
    g.done[id] = true;
    return g.rounded(id);
}

static int find_operation(operation what)
{
    for (std::size_t i = 0; i < nodes().size(); i++)
        if (nodes()[i].what == what)
            return (int)i;
    die("an operation is missing: " + std::to_string(what));
}

static std::string units(number error)
{
    return " in [-" + hex(error) + ", " + hex(error) + "]";
}

/* ---- logarithms ---- */

/* cor_log_ratio_far for each exponent of x = m 2^e, twice where the code begins to scale x: hi + lo is within
 * COR_PROOF_FAR of a - e ln(2) - L, where L is the double that log(m) returns and |ln(m)| < 0.3466. The rest that the
 * last sum adds is below 2^-30, so that a result above 1/2 is an exact sum. */
static void write_log_far(void)
{
    const function f = [](Real x) { return cor_log_ratio_far({Real(1.3), Real(1e-17)}, x).hi; };
    const std::vector<piece> pieces = pieces_of(f, 0x1p-1074, 8);
    int last = -1075;
    for (const piece &p : pieces) {
        start();
        const struct cor_inline_pair a = {variable("a", 1.3), variable("a_lo", 1e-17)};
        const Real x = variable("x", p.low);
        const struct cor_inline_pair q = cor_log_ratio_far(a, x);
        const int l = find_operation(LOG), m = first_of(l);
        int e;
        std::frexp(p.low / nodes()[(std::size_t)m].value, &e);
        e--;
        expect(what_is(m) == SEED && std::ldexp(nodes()[(std::size_t)m].value, e) == p.low, "cor_log_ratio_far");
        for (const number at : {p.low, p.high}) /* within 1e-6 of sqrt(1/2) and sqrt(2) */
            expect(std::ldexp(at, -e) > 0.7071061 && std::ldexp(at, -e) < 1.4142136, "cor_log_ratio_far");
        expect(e == last || e == last + 1, "cor_log_ratio_far: an exponent");
        last = e;
        gappa g;
        const std::string ah = cut(g, a.hi.node(), "[-4, 3]"), al = cut(g, a.lo.node(), "[-1b-51, 1b-51]");
        const std::string nl = cut(g, l, "[-0.3466, 0.3466]");
        /* q is the sum of all.hi and the rest; `all` and `large` are exact sums of two numbers */
        const int rest = second_of(q.hi.node()), all_hi = first_of(q.hi.node()), all_lo = first_of(rest);
        const int inner = second_of(rest), large_lo = first_of(inner), last_part = second_of(inner);
        const int large_hi = first_of(all_hi);
        exact_two_sum(g, {Real(0, large_hi), Real(0, large_lo)});
        exact_two_sum(g, {Real(0, all_hi), Real(0, all_lo)});
        expect(second_of(all_hi) >= 0 && what_is(second_of(all_hi)) == NEGATE && first_of(large_hi) == a.hi.node() &&
                   first_of(last_part) == a.lo.node(),
               "cor_log_ratio_far");
        exact_sum(g, q);
        g.hypotheses.push_back(g.rounded(all_hi) + " in [-10, 800]");
        g.hypotheses.push_back("LN2 in [" + std::string(ln2_low) + ", " + ln2_high + "]");
        const std::string c = g.rounded(second_of(large_hi)), c2 = g.rounded(second_of(last_part));
        const std::string nr = g.rounded(rest), ni = g.rounded(inner), np = g.rounded(last_part);
        const std::string multiple = e == 0 ? "" : " - (" + std::to_string(e) + ") * LN2";
        g.text << "off = (" << g.rounded(q.hi.node()) << " + " << g.rounded(q.lo.node()) << ") - ((" << ah << " + "
               << al << ")" << multiple << " - " << nl << ");\n";
        g.hints.push_back("off -> (" + nr + " - (" + g.rounded(all_lo) + " + " + ni + ")) + (" + ni + " - (" +
                          g.rounded(large_lo) + " + " + np + "))" +
                          (e == 0 ? ";"
                                  : " + (" + np + " - (" + al + " - " + c2 + ")) + ((" + c + " - " + c2 + ") + (" +
                                        std::to_string(e) + ") * LN2);"));
        char name[64];
        snprintf(name, sizeof name, "disk_far_%04d", (int)(&p - &pieces[0]));
        g.write(name, {}, "off" + units(COR_PROOF_FAR) + " /\\ |" + nr + "| in [0, 1b-30]");
    }
    expect(last == 3 || last == 2, "cor_log_ratio_far: the last exponent");
}

/* The remainder of the quotient d of cor_log_ratio_near, before it is divided: within 2^-74 of difference - d x for d
 * and x from [1, 2]. Powers of two times d or x scale every operation. */
static void write_log_near(void)
{
    start();
    const struct cor_inline_pair a = {variable("a", 1.5), variable("a_lo", 1e-17)};
    const Real x = variable("x", 1.25);
    const struct cor_inline_pair q = cor_log_ratio_near(a, x);
    const int quotient = q.lo.node(), d = first_of(q.hi.node()), difference = first_of(d), rest = first_of(quotient);
    const int first = first_of(rest), hi = second_of(first), lo = second_of(rest);
    const char *const name = "cor_log_ratio_near";
    expect(what_is(q.hi.node()) == LOG1P && what_is(quotient) == DIVIDE && what_is(d) == DIVIDE, name);
    expect(second_of(d) == x.node() && first_of(first) == difference && what_is(second_of(quotient)) == ADD, name);
    expect(what_is(difference) == ADD && second_of(difference) == a.lo.node(), name);
    const int exact_part = first_of(difference);
    expect(what_is(exact_part) == SUBTRACT && first_of(exact_part) == a.hi.node(), name);
    expect(second_of(exact_part) == x.node(), name);
    {
        gappa g;
        const std::string nd = cut(g, difference, "[1, 4]"), nx = cut(g, x.node(), "[1, 2]");
        g.define(rest);
        g.hypotheses.push_back(g.rounded(d) + " in [1, 2]");
        const std::string product = product_error(g, hi, lo), nr = g.rounded(rest), nq = g.rounded(d);
        g.text << "exact = " << nd << " - " << nq << " * " << nx << ";\n";
        g.hints.push_back("exact -> " + nx + " * (" + nd + " / " + nx + " - " + nq + ") { " + nx + " <> 0 };");
        g.hints.push_back(nd + " - " + g.rounded(hi) + " -> exact - (" + g.rounded(hi) + " - " + nq + " * " + nx +
                          ");");
        g.hints.push_back(nr + " - exact -> (" + nr + " - (" + g.rounded(first) + " - " + g.rounded(lo) + ")) + (" +
                          g.rounded(first) + " - (" + nd + " - " + g.rounded(hi) + ")) - " + product + ";");
        g.write("disk_near_remainder", {}, "|" + nr + " - exact| in [0, " + hex(COR_PROOF_NEAR) + "]");
    }
    /* a.hi - x is exact for x <= a.hi <= 1.66 x */
    for (int k = 0; k < 2; k++) {
        gappa g;
        const std::string nx = cut(g, x.node(), "[1, 2]"), na = cut(g, a.hi.node(), k ? "[2, 4]" : "[1, 2]");
        g.define(exact_part);
        g.hypotheses.push_back(na + " - " + nx + " in [0, 1.4]");
        g.write("disk_near_difference_" + std::to_string(k), {},
                g.rounded(exact_part) + " - (" + na + " - " + nx + ") in [0, 0]");
    }
}

/* ---- t of q ---- */

/* A rounded root p of the double `twice`, and its correction (twice + twice_lo - p^2)/(2 p), where (hi, lo) is the
 * square of p: within 2^-70 for p from [1, 2]. Powers of four times `twice` scale every operation. */
static void write_root_correction(const std::string &name, int p, int correction, int twice, int twice_lo, int hi,
                                  int lo)
{
    gappa g;
    const int sum = first_of(correction), minus_lo = first_of(sum), first = first_of(minus_lo);
    const std::string np = cut(g, p, "[1, 2]"), nt = cut(g, twice, "[0.99, 4.01]");
    const std::string nl = cut(g, twice_lo, "[-1b-50, 1b-50]");
    g.define(correction);
    const std::string product = product_error(g, hi, lo), nc = g.rounded(correction), ns = g.rounded(sum);
    /* p is within 2^-53 p of the root */
    g.hypotheses.push_back(nt + " - " + np + " * " + np + " in [-1b-50, 1b-50]");
    g.text << "R = (" << nt << " - " << np << " * " << np << ") + " << nl << ";\n";
    g.hints.push_back(nt + " - " + g.rounded(hi) + " -> (" + nt + " - " + np + " * " + np + ") - (" + g.rounded(hi) +
                      " - " + np + " * " + np + ");");
    g.hints.push_back(ns + " - R -> (" + ns + " - (" + g.rounded(minus_lo) + " + " + nl + ")) + (" +
                      g.rounded(minus_lo) + " - (" + g.rounded(first) + " - " + g.rounded(lo) + ")) + (" +
                      g.rounded(first) + " - (" + nt + " - " + g.rounded(hi) + ")) - " + product + ";");
    g.hints.push_back(ns + " -> R + (" + ns + " - R);");
    const std::string twice_p = g.rounded(second_of(correction));
    g.hints.push_back(nc + " - R / (2 * " + np + ") -> (" + nc + " - " + ns + " / " + twice_p + ") + (" + ns +
                      " - R) / (2 * " + np + ") + " + ns + " * (2 * " + np + " - " + twice_p + ") / (" + twice_p +
                      " * (2 * " + np + ")) { " + np + " <> 0, " + twice_p + " <> 0 };");
    g.write(name, {}, "|" + nc + " - R / (2 * " + np + ")| in [0, 1b-70]");
}

/* The number of a constant's double */
static mpq_class rational(number x)
{
    return mpq_class(x);
}

/* A rational number: no two formulas of low degree that differ agree at such numbers, unless by a chance of 2^-16 */
static mpq_class arbitrary(void)
{
    static std::uint64_t state = 1;
    state = state * 6364136223846793005 + 1442695040888963407;
    mpq_class value((long)(state >> 46) + 1000, (long)(state >> 29 & 0xffff) + 1001);
    value.canonicalize();
    return value;
}

/* The list of operations `result`, without rounding, must be `formula` of the variable `at`, at 24 arbitrary numbers;
 * the formula gives numbers to the other variables. */
static void check_disk_formula(const char *what, int result, int at,
                               const std::function<mpq_class(const mpq_class &, assignment &)> &formula)
{
    for (int i = 1; i <= 24; i++) {
        assignment known;
        const mpq_class z = arbitrary();
        known[at] = z;
        const mpq_class value = formula(z, known);
        expect(exact_value(result, known) == value, what);
    }
}

/* cor_lambert_t_pair for q.hi < 0.1, p = sqrt(2 q.hi): the rest of the series has a relative error below
 * COR_PROOF_SERIES, and the correction of p, for p from [1, 2], an error below 2^-70. */
static void write_series(void)
{
    start();
    const struct cor_inline_pair q = {variable("q", 0.04), variable("q_lo", 1e-19)}, t = cor_lambert_t_pair(q);
    const int p = t.hi.node(), correction = first_of(t.lo.node()), rest = second_of(t.lo.node());
    const char *const name = "the series of cor_lambert_t_pair";
    expect(what_is(t.lo.node()) == ADD && what_is(p) == SQRT && what_is(correction) == DIVIDE, name);
    check_disk_formula(name, rest, p, [](const mpq_class &z, assignment &) {
        mpq_class sum = 0;
        for (std::size_t k = sizeof lambert_series / sizeof *lambert_series; k-- > 0;)
            sum = sum * z + rational(lambert_series[k].value);
        return mpq_class(sum * z * z);
    });
    {
        gappa g;
        cut(g, p, "[1b-251, " + hex(COR_PROOF_SERIES_MAX_P) + "]");
        g.define(rest);
        g.write("disk_series", {},
                "(" + g.rounded(rest) + " - " + g.exact(rest) + ") / " + g.exact(rest) + units(COR_PROOF_SERIES));
    }
    const int sum = first_of(correction), twice_lo = second_of(sum), minus_lo = first_of(sum);
    const int first = first_of(minus_lo), lo = second_of(minus_lo), twice = first_of(first), hi = second_of(first);
    expect(what_is(sum) == ADD && what_is(minus_lo) == SUBTRACT && what_is(first) == SUBTRACT && first_of(p) == twice,
           name);
    write_root_correction("disk_series_correction", p, correction, twice, twice_lo, hi, lo);
}

/* (q <= 3) the start 1 + p (1 + p (1/3 + p (1/36 - p/270))) has a relative error below 2^-48 */
static void write_start(void)
{
    start();
    const struct cor_inline_pair q = {variable("q", 1.1), variable("q_lo", 1e-19)};
    cor_lambert_t_pair(q);
    const int p = find_operation(SQRT), y = first_of(find_operation(LOG));
    check_disk_formula("the start of t", y, p, [](const mpq_class &z, assignment &) {
        return mpq_class(1 + z * (1 + z * (rational(1.0 / 3) + z * (rational(1.0 / 36) - z * rational(1.0 / 270)))));
    });
    gappa g;
    cut(g, p, "[0.44, 2.46]");
    g.define(y);
    g.write("disk_start", {}, "(" + g.rounded(y) + " - " + g.exact(y) + ") / " + g.exact(y) + units(COR_PROOF_START));
}

/* The operations of both steps for y = 1 + t: logarithms, residuals r, u = y - 1, and the pair -ln(y) = q - u */
struct steps {
    int qh, ql, y0, l0, r0, over, y1, l1, u1, r1, lo, total, low, mh, ml;
};

static steps find_steps(number at)
{
    const char *const name = "cor_lambert_t_pair";
    steps f;
    start();
    const struct cor_inline_pair q = {variable("q", at), variable("q_lo", 1e-19)}, t = cor_lambert_t_pair(q);
    f.qh = q.hi.node();
    f.ql = q.lo.node();
    f.l0 = find_operation(LOG);
    f.y0 = first_of(f.l0);
    for (std::size_t i = 0; i < nodes().size(); i++)
        if (nodes()[i].what == LOG)
            f.l1 = (int)i;
    f.y1 = first_of(f.l1);
    f.u1 = t.hi.node();
    f.lo = t.lo.node();
    expect(f.l0 != f.l1 && what_is(f.lo) == MULTIPLY && first_of(f.lo) == f.y1, name);
    expect(what_is(second_of(f.lo)) == DIVIDE && second_of(second_of(f.lo)) == f.u1, name);
    expect(what_is(f.u1) == SUBTRACT && first_of(f.u1) == f.y1 && is_constant(second_of(f.u1), 1), name);
    f.r1 = first_of(second_of(f.lo));
    expect(what_is(f.y1) == ADD && first_of(f.y1) == f.y0 && what_is(second_of(f.y1)) == MULTIPLY, name);
    const int ratio = second_of(second_of(f.y1));
    f.over = first_of(ratio);
    expect(what_is(ratio) == MULTIPLY && what_is(f.over) == DIVIDE, name);
    f.r0 = first_of(f.over);
    const int u0 = second_of(f.over);
    expect(what_is(f.r0) == ADD && second_of(f.r0) == f.l0 && what_is(u0) == SUBTRACT && first_of(u0) == f.y0, name);
    f.total = first_of(f.r1);
    f.low = second_of(f.r1);
    expect(what_is(f.r1) == ADD && what_is(f.total) == ADD && what_is(f.low) == ADD, name);
    expect(second_of(f.total) == f.l1 && second_of(f.low) == f.ql, name);
    f.mh = first_of(f.total);
    f.ml = first_of(f.low);
    return f;
}

/* y (1 + (r/u) (b + r)/(b + 2 r)) and y r/u */
static void check_steps(const steps &f)
{
    check_disk_formula("the step of fourth order", f.y1, f.y0, [&](const mpq_class &z, assignment &known) {
        const mpq_class u = z - 1, log = arbitrary(), q0 = arbitrary(), r = (q0 - u) + log;
        known[f.l0] = log;
        known[f.qh] = q0;
        const mpq_class b = 2 * u * (u + r * rational(2.0 / 3));
        return mpq_class(z + z * (r / u * ((b + r) / (b + 2 * r))));
    });
    check_disk_formula("Newton's step", f.lo, f.y1, [&](const mpq_class &z, assignment &known) {
        const mpq_class log = arbitrary(), q0 = arbitrary(), low = arbitrary();
        known[f.l1] = log;
        known[f.qh] = q0;
        known[f.ql] = low;
        return mpq_class(z * ((q0 + low - (z - 1) + log) / (z - 1)));
    });
}

/* A cell of y, and the numbers that log(y) and q.hi can then be */
struct step_cell {
    number low;
    std::string y, log, q, index;
};

/* The residual r has the double L that log(y) returns, and y (1 + ...) is within COR_PROOF_STEP, relative. */
static void write_first_step(const steps &f, const step_cell &cell)
{
    gappa g;
    cut(g, f.y0, cell.y);
    cut(g, f.l0, cell.log);
    cut(g, f.qh, cell.q);
    g.define(f.y1);
    g.hypotheses.push_back(g.exact(f.r0) + units(COR_PROOF_FIRST_RESIDUAL * cell.low));
    const std::string nr = g.rounded(f.r0), er = g.exact(f.r0), no = g.rounded(f.over);
    const std::string nu = g.rounded(second_of(f.over)), eu = g.exact(second_of(f.over));
    g.hints.push_back(no + " - " + g.exact(f.over) + " -> (" + no + " - " + nr + " / " + nu + ") + (" + nr + " - " +
                      er + ") / " + nu + " + " + er + " * (" + eu + " - " + nu + ") / (" + nu + " * " + eu + ") { " +
                      nu + " <> 0, " + eu + " <> 0 };");
    g.write("disk_step_" + cell.index, {},
            "(" + g.rounded(f.y1) + " - " + g.exact(f.y1) + ") / " + g.exact(f.y1) + units(COR_PROOF_STEP));
}

/* Newton's step is within COR_PROOF_NEWTON y of y R/u, where R is the residual with the double L that log(y) returns.
 * u >= q, so that q - u is an exact sum: disk_bounds.cpp. */
static void write_newton_step(const steps &f, const step_cell &cell)
{
    gappa g;
    const std::string y = cut(g, f.y1, cell.y), l = cut(g, f.l1, cell.log), nq = cut(g, f.qh, cell.q);
    const std::string ql = cut(g, f.ql, "[-1b-42, 1b-42]");
    exact_sum(g, {Real(0, f.mh), Real(0, f.ml)});
    g.define(f.lo);
    const std::string nr = g.rounded(f.r1), nt = g.rounded(f.total), nlow = g.rounded(f.low), mh = g.rounded(f.mh);
    const std::string nu = g.rounded(f.u1), ml = g.rounded(f.ml), no = g.rounded(second_of(f.lo));
    const std::string lost = "((" + y + " - 1) - " + nu + ")", nlo = g.rounded(f.lo);
    g.text << "R = ((" << nq << " + " << ql << ") - (" << y << " - 1)) + " << l << ";\n";
    g.hypotheses.push_back("R" + units(COR_PROOF_SECOND_RESIDUAL * cell.low));
    g.hints.push_back(mh + " + " + l + " -> R - (" + ml + " + " + ql + ") + " + lost + ";");
    g.hints.push_back(nr + " - R -> (" + nr + " - (" + nt + " + " + nlow + ")) + (" + nt + " - (" + mh + " + " + l +
                      ")) + (" + nlow + " - (" + ml + " + " + ql + ")) + " + lost + ";");
    g.hints.push_back(nr + " -> R + (" + nr + " - R);");
    g.hints.push_back(nlo + " - " + y + " * R / " + nu + " -> (" + nlo + " - " + y + " * " + no + ") + " + y + " * (" +
                      no + " - " + nr + " / " + nu + ") + " + y + " / " + nu + " * (" + nr + " - R) { " + nu +
                      " <> 0 };");
    g.write("disk_newton_" + cell.index, {},
            "|" + nlo + " - " + y + " * R / " + nu + "| in [0, " + hex(COR_PROOF_NEWTON * cell.low) + "]");
}

static void write_steps(void)
{
    for (const number at : {0.2, 3.1, 700.0}) /* with either start the steps are the same */
        check_steps(find_steps(at));
    const steps f = find_steps(1.1);
    std::vector<number> ends; /* no cell has a power of two inside, which changes the unit of y */
    for (number power = 1; power < 2048; power *= 2)
        for (int k = power == 1 ? 4 : 0; k < 8; k += power < 4 ? 1 : 4)
            ends.push_back(power * (1 + k / 8.0));
    ends.push_back(2048);
    for (std::size_t i = 0; i + 1 < ends.size(); i++) {
        const number low = ends[i], high = ends[i + 1], slack = 2 * COR_PROOF_FIRST_RESIDUAL * high;
        const number log_low = std::log(low) * (1 - 1e-9), log_high = std::log(high) * (1 + 1e-9);
        const auto text = [](number a, number b) { return "[" + hex(a) + ", " + hex(b) + "]"; };
        char index[32];
        snprintf(index, sizeof index, "%02zu", i);
        const step_cell cell = {low, text(low, high), text(log_low, log_high),
                                text(std::max(0.05, low - 1 - log_high - slack), high - 1 - log_low + slack), index};
        write_first_step(f, cell);
        write_newton_step(f, cell);
    }
}

/* ---- pairs, sharper than the sphere needs them ---- */

/* cor_inline_product(x, y) for x and y from [1, 2): |hi + lo - x y| <= 2^-102. All its sums but the last are exact,
 * because the 27 lower bits of a factor are below 2^-25 - 2^-52. Returns the text of hi + lo - x y. */
static std::string sharp_product(gappa &g, int hi, int lo)
{
    const int last = second_of(lo), c = first_of(lo), b = first_of(c), a = first_of(b);
    const char *const name = "cor_inline_product";
    expect(what_is(lo) == ADD && what_is(c) == ADD && what_is(b) == ADD && what_is(a) == SUBTRACT, name);
    const int xl = first_of(last), yl = second_of(last);
    const std::string x = g.rounded(first_of(hi)), y = g.rounded(second_of(hi)), h = g.rounded(hi);
    const std::string nxl = g.rounded(xl), nyl = g.rounded(yl), nxh = g.rounded(second_of(xl)),
                      nyh = g.rounded(second_of(yl));
    expect(what_is(xl) == SUBTRACT && what_is(yl) == SUBTRACT && what_is(second_of(xl)) == HEAD, name);
    const std::string high = std::to_string((1L << 27) - 1) + "b-52";
    g.hypotheses.push_back(x + " - " + nxh + " in [0, " + high + "]");
    g.hypotheses.push_back(y + " - " + nyh + " in [0, " + high + "]");
    const std::string nc = g.rounded(c), nl = g.rounded(lo);
    const std::string off = "(" + x + " * " + y + " - " + h + ")";
    const std::string tail_x = "(" + x + " - " + nxh + ")", tail_y = "(" + y + " - " + nyh + ")";
    /* in terms of the rounding error of hi */
    const std::string exact_a = nxh + " * " + nyh + " - " + h, exact_b = "(" + exact_a + ") + " + nxh + " * " + tail_y;
    const std::string exact_c = "(" + exact_b + ") + " + tail_x + " * " + nyh;
    g.text << "pa" << lo << " = " << exact_a << ";\npb" << lo << " = " << exact_b << ";\npc" << lo << " = " << exact_c
           << ";\npd" << lo << " = " << tail_x << " * " << tail_y << ";\n";
    const std::string id = std::to_string(lo), pa = "pa" + id, pb = "pb" + id, pc = "pc" + id, pd = "pd" + id;
    g.hints.push_back(pa + " -> " + off + " - " + tail_x + " * " + y + " - " + nxh + " * " + tail_y + ";");
    g.hints.push_back(pb + " -> " + off + " - " + tail_x + " * " + y + ";");
    g.hints.push_back(pc + " -> " + off + " - " + pd + ";");
    return "(" + nl + " - (" + nc + " + " + g.rounded(last) + ")) + (" + g.rounded(last) + " - " + pd + ") + (" + nc +
           " - " + pc + ")";
}

static void write_sharp_product(void)
{
    start();
    const Real x = variable("x", 1.3), y = variable("y", 1.7);
    const struct cor_inline_pair p = cor_inline_product(x, y);
    gappa g;
    const std::string below_2 = "[1, " + std::to_string((1L << 53) - 1) + "b-52]";
    cut(g, x.node(), below_2);
    cut(g, y.node(), below_2);
    g.define(p.lo.node());
    const std::string error = sharp_product(g, p.hi.node(), p.lo.node());
    g.text << "off = " << sum_text(g, p) << " - " << g.rounded(x.node()) << " * " << g.rounded(y.node()) << ";\n";
    g.hints.push_back("off -> " + error + ";");
    g.write("disk_product", {}, "|off| in [0, 1b-102]");
}

/* cor_inline_pair_times for x and y from [1, 2), |lo| <= 2^-53: the pair is within 2^-101 of the product. */
static void write_sharp_pair_times(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), y = pair_variable("y", 1.7);
    const struct cor_inline_pair p = cor_inline_pair_times(x, y);
    gappa g;
    const std::string below_2 = "[1, " + std::to_string((1L << 53) - 1) + "b-52]", low = "[-1b-53, 1b-53]";
    const std::string xh = cut(g, x.hi.node(), below_2), yh = cut(g, y.hi.node(), below_2);
    const std::string xl = cut(g, x.lo.node(), low), yl = cut(g, y.lo.node(), low);
    const int rest = second_of(p.hi.node()), hi = first_of(p.hi.node()), lo = first_of(rest);
    exact_sum(g, p);
    const std::string product = sharp_product(g, hi, lo), nr = g.rounded(rest);
    const std::string crossed = g.rounded(second_of(rest));
    g.text << "off = " << sum_text(g, p) << " - (" << xh << " + " << xl << ") * (" << yh << " + " << yl << ");\n"
           << "low = " << g.rounded(lo) << ";\n";
    g.hints.push_back("low -> (" + product + ") + (" + xh + " * " + yh + " - " + g.rounded(hi) + ");");
    g.hints.push_back("off -> (" + nr + " - (" + g.rounded(lo) + " + " + crossed + ")) + (" + crossed + " - (" + xh +
                      " * " + yl + " + " + xl + " * " + yh + ")) + " + product + " - " + xl + " * " + yl + ";");
    g.write("disk_pair_times", {}, "|off| in [0, " + hex(COR_PROOF_PAIR_TIMES) + "] /\\ |low| in [0, 1b-51]");
}

/* cor_pair_plus(1, t) and cor_pair_plus(1/2, q): rounding errors of the low parts. t.lo is below 0.09 after the series,
 * and below 2^-31 y after Newton's step; q is a pair. */
static void write_sums(void)
{
    static const struct {
        const char *name;
        number one, hi, low, bound;
    } sums[] = {{"disk_one_plus_series", 1, 0.448, COR_PROOF_SERIES_MAX_LOW, COR_PROOF_SUM_SERIES},
                {"disk_one_plus_newton", 1, 2048, 0x1p-20, COR_PROOF_SUM_NEWTON},
                {"disk_half_plus", 0.5, 1024, 0x1p-43, COR_PROOF_SUM_HALF}};
    for (const auto &f : sums) {
        start();
        const struct cor_inline_pair t = {variable("t", 0.3), variable("t_lo", 0.01)};
        const struct cor_inline_pair y = f.one == 1 ? one_plus(t) : cor_pair_plus(cor_pair(f.one, 0), t);
        const int sum_hi = first_of(y.hi.node()), rest = second_of(y.hi.node()), sum_lo = first_of(rest);
        gappa g;
        const std::string th = cut(g, t.hi.node(), "[0, " + hex(f.hi) + "]");
        const std::string tl = cut(g, t.lo.node(), "[-" + hex(f.low) + ", " + hex(f.low) + "]");
        exact_two_sum(g, {Real(0, sum_hi), Real(0, sum_lo)});
        exact_sum(g, y);
        g.text << "off = " << sum_text(g, y) << " - (" << hex(f.one) << " + " << th << " + " << tl << ");\n";
        g.hints.push_back("off -> (" + g.rounded(rest) + " - (" + g.rounded(sum_lo) + " + " +
                          g.rounded(second_of(rest)) + ")) + (" + g.rounded(second_of(rest)) + " - " + tl + ");");
        g.write(f.name, {}, "off" + units(f.bound) + " /\\ |" + g.rounded(rest) + "| in [0, 0.25]");
    }
}

/* ---- the last operations of the law ---- */

/* pair_sqrt: the correction of the root, as above, and the exact last sum */
static void write_pair_sqrt(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), root = pair_sqrt(x);
    const int p = first_of(root.hi.node()), correction = second_of(root.hi.node()), sum = first_of(correction);
    const int first = first_of(first_of(sum)), lo = second_of(first_of(sum)), hi = second_of(first);
    expect(what_is(p) == SQRT && second_of(sum) == x.lo.node() && first_of(p) == x.hi.node(), "pair_sqrt");
    write_root_correction("disk_pair_sqrt", p, correction, x.hi.node(), x.lo.node(), hi, lo);
}

/* times and square_times: the number that is rounded last is within 2^-68 of x f or x^2 f, x and f from [1, 2). */
static void write_times(void)
{
    for (int squared = 0; squared < 2; squared++) {
        start();
        const Real x = variable("x", 1.3);
        const struct cor_inline_pair f = pair_variable("f", 1.7);
        const Real value = squared ? square_times(x, f) : times(x, f);
        const int last = squared ? value.node() : first_of(value.node());
        expect(what_is(last) == ADD && (squared || is_constant(second_of(value.node()), 1)), "times");
        gappa g;
        cut(g, x.node(), "[1, 2]");
        pair_in(g, f);
        const std::string nx = g.rounded(x.node()), fh = g.rounded(f.hi.node()), fl = g.rounded(f.lo.node());
        if (!squared) {
            const int hi = first_of(last), rest = second_of(last), lo = first_of(rest);
            g.define(rest);
            const std::string product = product_error(g, hi, lo), nr = g.rounded(rest),
                              add = g.rounded(second_of(rest));
            g.text << "off = (" << g.rounded(hi) << " + " << nr << ") - " << nx << " * (" << fh << " + " << fl
                   << ");\n";
            g.hints.push_back("off -> (" + nr + " - (" + g.rounded(lo) + " + " + add + ")) + (" + add + " - " + nx +
                              " * " + fl + ") + " + product + ";");
            g.write("disk_times", {}, "|off| in [0, " + hex(COR_PROOF_PAIRS) + "]");
        } else {
            /* the square and its product with f, both within 2^-70 by the goals of pairs */
            const int hi = first_of(last), lo = second_of(last), square = first_of(first_of(hi));
            expect(what_is(square) == MULTIPLY && first_of(square) == x.node() && second_of(square) == x.node(),
                   "square_times");
            const struct cor_inline_pair result = {Real(0, hi), Real(0, lo)}, product = cor_inline_product(x, x),
                                         again = cor_inline_pair_times(product, f);
            expect(again.hi.node() == hi && again.lo.node() == lo, "square_times");
        }
    }
}

/* ---- the formulas of the law ---- */

/* The last logarithm and Newton's step of a trace */
struct found_t {
    int log, hi, lo;
};

static found_t find_t(void)
{
    found_t t = {-1, -1, -1};
    for (std::size_t i = 0; i < nodes().size(); i++)
        if (nodes()[i].what == LOG)
            t.log = (int)i;
    const int y = first_of(t.log);
    for (std::size_t i = 0; i < nodes().size(); i++) {
        const node &n = nodes()[i];
        if (n.what == SUBTRACT && n.a == y && is_constant(n.b, 1))
            t.hi = (int)i;
        if (n.what == MULTIPLY && n.a == y && what_is(n.b) == DIVIDE && second_of(n.b) == t.hi)
            t.lo = (int)i;
    }
    expect(t.hi >= 0 && t.lo >= 0, "the law of the disk");
    return t;
}

static mpq_class of_pair(const struct cor_inline_pair &x)
{
    return rational(x.hi.value) + rational(x.lo.value);
}

/* Newton's step from the root that the trace has, r: r + (x - r^2)/(2 r) */
static mpq_class newton_root(const mpq_class &x, const mpq_class &r)
{
    return r + (x - r * r) / (2 * r);
}

typedef mpq_class formula(const mpq_class &x, const mpq_class &t, const mpq_class &r);

/* A function of the law and its formula */
struct law_formula {
    const char *name;
    Real (*law)(Real x, Real nu, enum cor_disk_datum datum);
    enum quantity quantity;
    bool inverse; /* t of q, or t = q */
    int multiple; /* of the logarithm */
    formula *of;
    const struct cor_logarithm *constant; /* of a leading logarithm */
};

/* The function, without rounding, is its formula of t, whose q is slope nu + ln(limit at nu = 0) - ln(x), far from the
 * limit: at x = 0.75 2^exponent, with arbitrary numbers for the results of log and sqrt */
static void check_law_at(const law_formula &f, enum cor_disk_datum datum, int exponent)
{
    start();
    const Real x = variable("x", std::ldexp(0.75, exponent)), nu = variable("nu", 0.25);
    const int result = f.law(x, nu, datum).node();
    struct limit limit;
    find_limit(f.quantity, nu, datum, &limit);
    if (f.constant != nullptr)
        limit = {*f.constant, Real(0)};
    const int far = find_operation(LOG);
    const found_t t = f.inverse ? find_t() : found_t{far, -1, -1};
    assignment known;
    known[x.node()] = arbitrary();
    known[nu.node()] = arbitrary();
    mpq_class root; /* the last one is the law's */
    for (std::size_t i = 0; i < nodes().size(); i++) {
        const operation what = nodes()[i].what;
        if (what == HEAD || what == SEED || what == LOG)
            known[(int)i] = arbitrary();
        if (what == SQRT)
            known[(int)i] = root = arbitrary();
    }
    if (f.law == law_load_of_energy && exponent < -900) /* the root of 2^200 times as much */
        root /= rational(0x1p100);
    const mpq_class slope = datum == COR_DISK_DATUM_DIAMETER  ? mpq_class(0)
                            : datum == COR_DISK_DATUM_PRINTED ? mpq_class(-1)
                                                              : mpq_class(-1, 4);
    const mpq_class moved = exact_value(limit.exponent.node(), known);
    expect(f.constant != nullptr || moved == (f.quantity == ENERGY ? 2 : 1) * slope * known[nu.node()], f.name);
    mpq_class q = of_pair(limit.at_zero.log) + moved - known[far] -
                  exponent * (rational(0.69314718055989033019) + rational(5.4979230187083711747e-14));
    q *= f.multiple;
    /* Products and sums of constants are rounded in every trace; the goals of the logarithms cover them. */
    const mpq_class rounding = rational(0x1p-75);
    mpq_class value = q;
    if (f.inverse) {
        const mpq_class u = exact_value(t.hi, known), low = (u + 1) * (q - u + known[t.log]) / u;
        expect(abs(low - exact_value(t.lo, known)) <= abs(low) * rounding, f.name);
        value = u + low;
    }
    const mpq_class wanted = f.of(known[x.node()], value, root);
    expect(abs(exact_value(result, known) - wanted) <= abs(wanted) * rounding, f.name);
}

/* A leading logarithm has neither nu nor a datum. */
template <Real (*law)(Real)> static Real of_x(Real x, Real, enum cor_disk_datum)
{
    return law(x);
}

static void check_law(void)
{
    static const law_formula laws[] = {
        {"cor_disk_load_by_pairs", cor_disk_load_by_pairs, COMPRESSION, true, 1,
         [](const mpq_class &x, const mpq_class &t, const mpq_class &) {
             return mpq_class(x * of_pair(pi) / (1 + t));
         }},
        {"law_compression", law_compression, LOAD, false, 1,
         [](const mpq_class &x, const mpq_class &t, const mpq_class &) {
             return mpq_class(x * of_pair(one_over_pi) * (1 + t));
         }},
        {"law_energy", law_energy, LOAD, false, 1,
         [](const mpq_class &x, const mpq_class &t, const mpq_class &) {
             return mpq_class(x * x * of_pair(one_over_two_pi) * (mpq_class(1, 2) + t));
         }},
        {"law_load_of_energy", law_load_of_energy, ENERGY, true, 1,
         [](const mpq_class &x, const mpq_class &t, const mpq_class &r) {
             return newton_root(of_pair(four_pi) * x / (1 + t), r);
         }},
        {"law_max_load", law_max_load, SPEED, true, 2,
         [](const mpq_class &x, const mpq_class &t, const mpq_class &r) {
             return mpq_class(x * of_pair(root_2_pi) / newton_root(1 + t, r));
         }},
        {"law_max_compression", law_max_compression, SPEED, true, 2,
         [](const mpq_class &x, const mpq_class &t, const mpq_class &r) {
             return mpq_class(x * of_pair(root_2) * (1 + t / 2) / newton_root(1 + t, r));
         }},
        {"leading_compression", of_x<leading_compression>, LOAD, false, 1,
         [](const mpq_class &x, const mpq_class &q, const mpq_class &) {
             return mpq_class(x * of_pair(one_over_pi) * q);
         },
         &log_four_pi},
        {"leading_load", of_x<leading_load>, LOAD, false, 1,
         [](const mpq_class &x, const mpq_class &q, const mpq_class &) { return mpq_class(x * of_pair(pi) / q); },
         &four},
        {"leading_energy", of_x<leading_energy>, LOAD, false, 1,
         [](const mpq_class &x, const mpq_class &q, const mpq_class &) {
             return mpq_class(x * x * of_pair(half_pi) / q);
         },
         &four},
        {"leading_max_compression", of_x<leading_max_compression>, LOAD, false, 1,
         [](const mpq_class &x, const mpq_class &q, const mpq_class &r) { return mpq_class(x * newton_root(q, r)); },
         &four},
        {"leading_contact_time", of_x<leading_contact_time>, LOAD, false, 1,
         [](const mpq_class &, const mpq_class &q, const mpq_class &r) {
             return mpq_class(of_pair(pi) * newton_root(q, r));
         },
         &four},
    };
    for (const law_formula &f : laws)
        for (const enum cor_disk_datum datum :
             {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER, COR_DISK_DATUM_PRINTED})
            for (const int exponent : {-6, -949}) /* also where the functions scale their argument */
                check_law_at(f, datum, exponent);
}

/* Near the limit, log1p receives (limit - x)/x, where the limit, without rounding, is its number at nu = 0 times
 * (1 + s)^512 with ten terms of s = exp(slope nu/512) - 1. */
static void check_limit(void)
{
    start();
    const Real nu = variable("nu", 0.25), x = variable("x", 0.8);
    struct limit limit;
    find_limit(LOAD, nu, COR_DISK_DATUM_CENTRE_OF_MASS, &limit);
    const struct cor_inline_pair pair = limit_number(&limit), q = cor_log_ratio_near(pair, x);
    assignment known;
    known[nu.node()] = mpq_class(1, 2);
    known[x.node()] = mpq_class(3, 4);
    for (std::size_t i = 0; i < nodes().size(); i++)
        if (nodes()[i].what == HEAD)
            known[(int)i] = mpq_class((int)i % 3);
    const mpq_class r = mpq_class(-1, 8) / 512; /* -nu/4/512 */
    static const number factorial[] = {1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800};
    static const struct cor_inline_pair pairs[] = {{1, 0},
                                                   {0.5, 0},
                                                   {0.166666666666666657, 9.25185853854297066e-18},
                                                   {0.0416666666666666644, 2.31296463463574266e-18},
                                                   {0.00833333333333333322, 1.15648231731787138e-19},
                                                   {0.00138888888888888894, -5.30054395437357706e-20}};
    mpq_class s = 0;
    for (int i = 3; i >= 0; i--)
        s = r * (rational(factorial[i]) + s);
    for (int i = 5; i >= 0; i--) {
        int k = 1;
        for (int j = 2; j <= i + 1; j++)
            k *= j;
        expect(abs(of_pair(pairs[i]) * k - 1) < rational(0x1p-104), "a coefficient of exp");
        s = r * (of_pair(pairs[i]) + s);
    }
    mpq_class value = s + 1;
    for (int i = 0; i < 9; i++)
        value *= value;
    value *= of_pair(limit.at_zero.number);
    expect(exact_value(pair.hi.node(), known) + exact_value(pair.lo.node(), known) == value, "limit_number");
    expect(exact_value(first_of(q.hi.node()), known) == (value - mpq_class(3, 4)) / mpq_class(3, 4),
           "cor_log_ratio_near");
}

static void write_disk(void)
{
    check_law();
    check_limit();
    write_log_far();
    write_log_near();
    write_series();
    write_start();
    write_steps();
    write_sharp_product();
    write_sharp_pair_times();
    write_sums();
    write_pair_sqrt();
    write_times();
}
