/* SPDX-License-Identifier: MIT */
/* The goals of the contact law of the disk: part of goals.cpp. Each goal is about one stage of
 * runtime/number/lambert_w.c or runtime/disk/quasistatic.c: the result of `log` or `log1p` is a variable, so that a
 * goal does not depend on the accuracy of these functions. tests/accuracy/test_disk_proof.c adds the errors of the
 * stages, times what the later stages make of them, over cells that cover the domain; disk_errors.h has the errors for
 * both programs. */
#include "disk_errors.h"

/* ---- parts of lists of operations ---- */

/* The exact sum hi + lo of six operations (Knuth's theorem: no rounding error remains, for any two numbers) */
static void exact_two_sum(gappa &g, term hi, term lo)
{
    const char *const name = "cor_pair_two_sum";
    const int x = at(hi, "a"), y = at(hi, "b");
    for (const int difference : {at(lo, "a"), at(lo, "b"), at(lo, "bb"), at(lo, "ab")})
        expect(what_is(difference) == SUBTRACT, name);
    expect(what_is(hi) == ADD && what_is(lo) == ADD && at(lo, "aa") == x && at(lo, "ba") == y, name);
    expect(at(lo, "bba") == hi && at(lo, "bbb") == x && at(lo, "aba") == hi && at(lo, "abb") == at(lo, "bb"), name);
    g.define(hi);
    g.call({{"hi", hi}});
    g.give(lo, constant_of(y) == 0 ? "= ($hi.a) - $hi" : "= ($hi.a + $hi.b) - $hi", "same");
}

/* The same for cor_inline_sum(a, b) if |a| >= |b| (Dekker's theorem) */
static void exact_sum(gappa &g, term hi, term lo)
{
    expect(what_is(hi) == ADD && what_is(lo) == SUBTRACT && at(lo, "a") == at(hi, "b") &&
               what_is(at(lo, "b")) == SUBTRACT && at(lo, "ba") == hi && at(lo, "bb") == at(hi, "a"),
           "cor_inline_sum");
    g.define(hi);
    g.call({{"hi", hi}});
    g.give(lo, "= ($hi.a + $hi.b) - $hi", "same");
}

/* The first operation of a kind, or the last one, which must be there */
static int find_operation(operation what, bool last = false)
{
    int found = last_where([&](const node &n) { return n.what == what; });
    for (int i = found; i >= 0 && !last; i--)
        found = what_is(i) == what ? i : found;
    expect(found >= 0, "an operation, " + std::to_string(what) + ",");
    return found;
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
        const int l = find_operation(LOG), m = at(l, "a");
        int e;
        std::frexp(p.low / of(m).value, &e);
        e--;
        expect(what_is(m) == SEED && std::ldexp(of(m).value, e) == p.low, "cor_log_ratio_far");
        for (const number end : {p.low, p.high}) /* within 1e-6 of sqrt(1/2) and sqrt(2) */
            expect(std::ldexp(end, -e) > 0.7071061 && std::ldexp(end, -e) < 1.4142136, "cor_log_ratio_far");
        expect(e == last || e == last + 1, "cor_log_ratio_far: an exponent");
        last = e;
        gappa g;
        g.cut("ah", a.hi, "[-4, 3]");
        g.cut("al", a.lo, "[-1b-51, 1b-51]");
        g.cut("l", l, "[-0.3466, 0.3466]");
        /* q is the sum of all and the rest; `all` and `large` are exact sums of two numbers */
        const int all = at(q.hi, "a"), rest = at(q.hi, "b"), large = at(all, "a");
        exact_two_sum(g, large, at(rest, "ba"));
        exact_two_sum(g, all, at(rest, "a"));
        expect(at(all, "b") >= 0 && what_is(at(all, "b")) == NEGATE && at(large, "a") == a.hi.node() &&
                   at(rest, "bba") == a.lo.node(),
               "cor_log_ratio_far");
        exact_sum(g, q.hi, q.lo);
        g.call({{"q", q.hi}, {"ql", q.lo}, {"rest", rest}, {"all", all}});
        g.assume("$all in [-10, 800]");
        g.assume(ln2);
        const std::string multiple = "(" + std::to_string(e) + ") * LN2";
        g.say("off = ($q + $ql) - (($ah + $al)" + (e == 0 ? "" : " - " + multiple) + " - $l);");
        g.hint("off -> ($rest - ($rest.a + $rest.b)) + ($rest.b - ($rest.ba + $rest.bb))" +
               (e == 0 ? "" : " + ($rest.bb - ($al - $rest.bbb)) + (($all.ab - $rest.bbb) + " + multiple + ")"));
        g.write(numbered("disk_far", (int)(&p - &pieces[0])), {},
                "off" + units(COR_PROOF_FAR) + " /\\ |$rest| in [0, 1b-30]");
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
    const int quotient = q.lo.node(), d = at(q.hi, "a"), difference = at(d, "a"), rest = at(quotient, "a");
    const int exact_part = at(difference, "a");
    const char *const name = "cor_log_ratio_near";
    expect(what_is(q.hi) == LOG1P && what_is(quotient) == DIVIDE && what_is(d) == DIVIDE, name);
    expect(at(d, "b") == x.node() && at(rest, "aa") == difference && what_is(at(quotient, "b")) == ADD, name);
    expect(what_is(difference) == ADD && at(difference, "b") == a.lo.node(), name);
    expect(what_is(exact_part) == SUBTRACT && at(exact_part, "a") == a.hi.node() && at(exact_part, "b") == x.node(),
           name);
    {
        gappa g;
        g.cut("d", difference, "[1, 4]");
        g.cut("x", x, "[1, 2]");
        g.define(rest);
        g.call({{"q", d}, {"rest", rest}});
        g.assume("$q in [1, 2]");
        const std::string product = product_error(g, at(rest, "ab"), at(rest, "b"));
        g.say("exact = $d - $q * $x;");
        g.hint("exact -> $x * ($d / $x - $q) { $x <> 0 }");
        g.hint("$d - $rest.ab -> exact - ($rest.ab - $q * $x)");
        g.hint("$rest - exact -> ($rest - ($rest.a - $rest.b)) + ($rest.a - ($d - $rest.ab)) - " + product);
        g.write("disk_near_remainder", {}, "|$rest - exact|" + at_most(COR_PROOF_NEAR));
    }
    /* a.hi - x is exact for x <= a.hi <= 1.66 x */
    for (int k = 0; k < 2; k++) {
        gappa g;
        g.cut("x", x, "[1, 2]");
        g.cut("a", a.hi, k ? "[2, 4]" : "[1, 2]");
        g.call({{"part", exact_part}});
        g.define(exact_part);
        g.assume("$a - $x in [0, 1.4]");
        g.write("disk_near_difference_" + std::to_string(k), {}, "$part - ($a - $x) in [0, 0]");
    }
}

/* ---- t of q ---- */

/* A rounded root p of the double `twice`, and its correction (twice + twice_lo - p^2)/(2 p), where (hi, lo) is the
 * square of p: within 2^-70 for p from [1, 2]. Powers of four times `twice` scale every operation. */
static void write_root_correction(const std::string &name, int p, int correction, int twice, int twice_lo, int hi,
                                  int lo)
{
    gappa g;
    g.cut("p", p, "[1, 2]");
    g.cut("t", twice, "[0.99, 4.01]");
    g.cut("tl", twice_lo, "[-1b-50, 1b-50]");
    g.define(correction);
    g.call({{"c", correction}, {"h", hi}});
    const std::string product = product_error(g, hi, lo);
    /* p is within 2^-53 p of the root */
    g.assume("$t - $p * $p in [-1b-50, 1b-50]");
    g.say("R = ($t - $p * $p) + $tl;");
    g.hint("$t - $h -> ($t - $p * $p) - ($h - $p * $p)");
    g.hint("$c.a - R -> ($c.a - ($c.aa + $tl)) + ($c.aa - ($c.aaa - $off)) + ($c.aaa - ($t - $h)) - " + product);
    g.hint("$c.a -> R + ($c.a - R)");
    g.hint("$c - R / (2 * $p) -> ($c - $c.a / $c.b) + ($c.a - R) / (2 * $p) + $c.a * (2 * $p - $c.b) / ($c.b * (2 * "
           "$p)) { $p <> 0, $c.b <> 0 }");
    g.write(name, {}, "|$c - R / (2 * $p)| in [0, 1b-70]");
}

/* The number of a constant's double */
static mpq_class rational(number x)
{
    return mpq_class(x);
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
    const int p = t.hi.node(), correction = at(t.lo, "a"), rest = at(t.lo, "b"), sum = at(correction, "a");
    const char *const name = "the series of cor_lambert_t_pair";
    expect(what_is(t.lo) == ADD && what_is(p) == SQRT && what_is(correction) == DIVIDE, name);
    check_disk_formula(name, rest, p, [](const mpq_class &z, assignment &) {
        mpq_class series = 0;
        for (std::size_t k = sizeof lambert_series / sizeof *lambert_series; k-- > 0;)
            series = series * z + rational(lambert_series[k].value);
        return mpq_class(series * z * z);
    });
    {
        gappa g;
        g.cut("p", p, "[1b-251, " + hex(COR_PROOF_SERIES_MAX_P) + "]");
        g.call({{"rest", rest}});
        g.define(rest);
        g.write("disk_series", {}, "($rest - @rest) / @rest" + units(COR_PROOF_SERIES));
    }
    expect(what_is(sum) == ADD && what_is(at(sum, "a")) == SUBTRACT && what_is(at(sum, "aa")) == SUBTRACT &&
               at(p, "a") == at(sum, "aaa"),
           name);
    write_root_correction("disk_series_correction", p, correction, at(p, "a"), at(sum, "b"), at(sum, "aab"),
                          at(sum, "ab"));
}

/* (q <= 3) the start 1 + p (1 + p (1/3 + p (1/36 - p/270))) has a relative error below 2^-48 */
static void write_start(void)
{
    start();
    const struct cor_inline_pair q = {variable("q", 1.1), variable("q_lo", 1e-19)};
    cor_lambert_t_pair(q);
    const int p = find_operation(SQRT), y = at(find_operation(LOG), "a");
    check_disk_formula("the start of t", y, p, [](const mpq_class &z, assignment &) {
        return mpq_class(1 + z * (1 + z * (rational(1.0 / 3) + z * (rational(1.0 / 36) - z * rational(1.0 / 270)))));
    });
    gappa g;
    g.cut("p", p, "[0.44, 2.46]");
    g.call({{"y", y}});
    g.define(y);
    g.write("disk_start", {}, "($y - @y) / @y" + units(COR_PROOF_START));
}

/* The operations of both steps for y = 1 + t: logarithms, residuals r, u = y - 1, and the pair -ln(y) = q - u */
struct steps {
    int qh, ql, y0, l0, r0, over, y1, l1, u1, r1, lo;
};

static steps find_steps(number place)
{
    const char *const name = "cor_lambert_t_pair";
    steps f;
    start();
    const struct cor_inline_pair q = {variable("q", place), variable("q_lo", 1e-19)}, t = cor_lambert_t_pair(q);
    f.qh = q.hi.node();
    f.ql = q.lo.node();
    f.l0 = find_operation(LOG);
    f.y0 = at(f.l0, "a");
    f.l1 = find_operation(LOG, true);
    f.y1 = at(f.l1, "a");
    f.u1 = t.hi.node();
    f.lo = t.lo.node();
    expect(f.l0 != f.l1 && what_is(f.lo) == MULTIPLY && at(f.lo, "a") == f.y1, name);
    expect(what_is(at(f.lo, "b")) == DIVIDE && at(f.lo, "bb") == f.u1, name);
    expect(what_is(f.u1) == SUBTRACT && at(f.u1, "a") == f.y1 && is_constant(at(f.u1, "b"), 1), name);
    f.r1 = at(f.lo, "ba");
    expect(what_is(f.y1) == ADD && at(f.y1, "a") == f.y0 && what_is(at(f.y1, "b")) == MULTIPLY, name);
    const int ratio = at(f.y1, "bb");
    f.over = at(ratio, "a");
    expect(what_is(ratio) == MULTIPLY && what_is(f.over) == DIVIDE, name);
    f.r0 = at(f.over, "a");
    const int u0 = at(f.over, "b");
    expect(what_is(f.r0) == ADD && at(f.r0, "b") == f.l0 && what_is(u0) == SUBTRACT && at(u0, "a") == f.y0, name);
    expect(what_is(f.r1) == ADD && what_is(at(f.r1, "a")) == ADD && what_is(at(f.r1, "b")) == ADD, name);
    expect(at(f.r1, "ab") == f.l1 && at(f.r1, "bb") == f.ql, name);
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
    g.cut("y0", f.y0, cell.y);
    g.cut("l", f.l0, cell.log);
    g.cut("q", f.qh, cell.q);
    g.define(f.y1);
    g.call({{"y", f.y1}, {"o", f.over}});
    g.assume("@o.a" + units(COR_PROOF_FIRST_RESIDUAL * cell.low));
    g.hint("$o - @o -> ($o - $o.a / $o.b) + ($o.a - @o.a) / $o.b + @o.a * (@o.b - $o.b) / ($o.b * @o.b)"
           " { $o.b <> 0, @o.b <> 0 }");
    g.write("disk_step_" + cell.index, {}, "($y - @y) / @y" + units(COR_PROOF_STEP));
}

/* Newton's step is within COR_PROOF_NEWTON y of y R/u, where R is the residual with the double L that log(y) returns.
 * u >= q, so that q - u is an exact sum: disk_bounds.cpp. */
static void write_newton_step(const steps &f, const step_cell &cell)
{
    gappa g;
    g.cut("y", f.y1, cell.y);
    g.cut("l", f.l1, cell.log);
    g.cut("q", f.qh, cell.q);
    g.cut("ql", f.ql, "[-1b-42, 1b-42]");
    exact_sum(g, at(f.r1, "aa"), at(f.r1, "ba"));
    g.define(f.lo);
    g.call({{"r", f.r1}, {"u", f.u1}, {"lo", f.lo}});
    g.say("R = (($q + $ql) - ($y - 1)) + $l;");
    g.assume("R" + units(COR_PROOF_SECOND_RESIDUAL * cell.low));
    g.hint("$r.aa + $l -> R - ($r.ba + $ql) + (($y - 1) - $u)");
    g.hint("$r - R -> ($r - ($r.a + $r.b)) + ($r.a - ($r.aa + $l)) + ($r.b - ($r.ba + $ql)) + (($y - 1) - $u)");
    g.hint("$r -> R + ($r - R)");
    g.hint("$lo - $y * R / $u -> ($lo - $y * $lo.b) + $y * ($lo.b - $r / $u) + $y / $u * ($r - R) { $u <> 0 }");
    g.write("disk_newton_" + cell.index, {}, "|$lo - $y * R / $u|" + at_most(COR_PROOF_NEWTON * cell.low));
}

static void write_steps(void)
{
    for (const number place : {0.2, 3.1, 700.0}) /* with either start the steps are the same */
        check_steps(find_steps(place));
    const steps f = find_steps(1.1);
    std::vector<number> ends; /* no cell has a power of two inside, which changes the unit of y */
    for (number power = 1; power < 2048; power *= 2)
        for (int k = power == 1 ? 4 : 0; k < 8; k += power < 4 ? 1 : 4)
            ends.push_back(power * (1 + k / 8.0));
    ends.push_back(2048);
    for (std::size_t i = 0; i + 1 < ends.size(); i++) {
        const number low = ends[i], high = ends[i + 1], slack = 2 * COR_PROOF_FIRST_RESIDUAL * high;
        const number log_low = std::log(low) * (1 - 1e-9), log_high = std::log(high) * (1 + 1e-9);
        char index[32];
        snprintf(index, sizeof index, "%02zu", i);
        const step_cell cell = {low, within(low, high), within(log_low, log_high),
                                within(std::max(0.05, low - 1 - log_high - slack), high - 1 - log_low + slack), index};
        write_first_step(f, cell);
        write_newton_step(f, cell);
    }
}

/* ---- pairs, sharper than the sphere needs them ---- */

/* cor_inline_product(x, y) for x and y from [1, 2): |hi + lo - x y| <= 2^-102. All its sums but the last are exact,
 * because the 27 lower bits of a factor are below 2^-25 - 2^-52. Returns the text of hi + lo - x y. */
static std::string sharp_product(gappa &g, term hi, term lo)
{
    const char *const name = "cor_inline_product";
    for (const char *sum : {"", "a", "aa"})
        expect(what_is(at(lo, sum)) == ADD, name);
    for (const char *difference : {"aaa", "ba", "bb"})
        expect(what_is(at(lo, difference)) == SUBTRACT, name);
    expect(what_is(at(lo, "bab")) == HEAD, name);
    g.call({{"h", hi}, {"l", lo}, {"xh", at(lo, "bab")}, {"yh", at(lo, "bbb")}});
    const std::string high = std::to_string((1L << 27) - 1) + "b-52", id = std::to_string(lo);
    g.assume("$h.a - $xh in [0, " + high + "]");
    g.assume("$h.b - $yh in [0, " + high + "]");
    /* in terms of the rounding error of hi */
    const std::string a = "$xh * $yh - $h", b = "(" + a + ") + $xh * ($h.b - $yh)";
    g.say("pa" + id + " = " + a + ";");
    g.say("pb" + id + " = " + b + ";");
    g.say("pc" + id + " = (" + b + ") + ($h.a - $xh) * $yh;");
    g.say("pd" + id + " = ($h.a - $xh) * ($h.b - $yh);");
    g.hint("pa" + id + " -> ($h.a * $h.b - $h) - ($h.a - $xh) * $h.b - $xh * ($h.b - $yh)");
    g.hint("pb" + id + " -> ($h.a * $h.b - $h) - ($h.a - $xh) * $h.b");
    g.hint("pc" + id + " -> ($h.a * $h.b - $h) - pd" + id);
    return g.filled("($l - ($l.a + $l.b)) + ($l.b - pd" + id + ") + ($l.a - pc" + id + ")");
}

static const std::string below_2 = "[1, " + std::to_string((1L << 53) - 1) + "b-52]";

static void write_sharp_product(void)
{
    start();
    const Real x = variable("x", 1.3), y = variable("y", 1.7);
    const struct cor_inline_pair p = cor_inline_product(x, y);
    gappa g;
    g.cut("x", x, below_2);
    g.cut("y", y, below_2);
    g.define(p.lo);
    const std::string error = sharp_product(g, p.hi, p.lo);
    g.say("off = ($h + $l) - $x * $y;");
    g.hint("off -> " + error);
    g.write("disk_product", {}, "|off| in [0, 1b-102]");
}

/* cor_inline_pair_times for x and y from [1, 2), |lo| <= 2^-53: the pair is within 2^-101 of the product. */
static void write_sharp_pair_times(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), y = pair_variable("y", 1.7);
    const struct cor_inline_pair p = cor_inline_pair_times(x, y);
    const int rest = at(p.hi, "b");
    gappa g;
    g.cut("xh", x.hi, below_2);
    g.cut("yh", y.hi, below_2);
    g.cut("xl", x.lo, "[-1b-53, 1b-53]");
    g.cut("yl", y.lo, "[-1b-53, 1b-53]");
    exact_sum(g, p.hi, p.lo);
    const std::string product = sharp_product(g, at(p.hi, "a"), at(rest, "a"));
    g.call({{"xh", x.hi}, {"yh", y.hi}, {"s", p.hi}, {"sl", p.lo}, {"rest", rest}});
    g.say("off = ($s + $sl) - ($xh + $xl) * ($yh + $yl);");
    g.say("low = $l;");
    g.hint("low -> (" + product + ") + ($xh * $yh - $h)");
    g.hint("off -> ($rest - ($l + $rest.b)) + ($rest.b - ($xh * $yl + $xl * $yh)) + " + product + " - $xl * $yl");
    g.write("disk_pair_times", {}, "|off|" + at_most(COR_PROOF_PAIR_TIMES) + " /\\ |low| in [0, 1b-51]");
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
        const int rest = at(y.hi, "b");
        gappa g;
        g.cut("th", t.hi, "[0, " + hex(f.hi) + "]");
        g.cut("tl", t.lo, within(-f.low, f.low));
        exact_two_sum(g, at(y.hi, "a"), at(rest, "a"));
        exact_sum(g, y.hi, y.lo);
        g.call({{"y", y.hi}, {"yl", y.lo}, {"rest", rest}});
        g.say("off = ($y + $yl) - (" + hex(f.one) + " + $th + $tl);");
        g.hint("off -> ($rest - ($rest.a + $rest.b)) + ($rest.b - $tl)");
        g.write(f.name, {}, "off" + units(f.bound) + " /\\ |$rest| in [0, 0.25]");
    }
}

/* ---- the last operations of the law ---- */

/* pair_sqrt: the correction of the root, as above, and the exact last sum */
static void write_pair_sqrt(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), root = pair_sqrt(x);
    const int p = at(root.hi, "a"), correction = at(root.hi, "b"), sum = at(correction, "a");
    expect(what_is(p) == SQRT && at(sum, "b") == x.lo.node() && at(p, "a") == x.hi.node(), "pair_sqrt");
    write_root_correction("disk_pair_sqrt", p, correction, x.hi.node(), x.lo.node(), at(sum, "aab"), at(sum, "ab"));
}

/* times: the number that is rounded last is within 2^-68 of x f, x and f from [1, 2). square_times: the square and its
 * product with f, both within 2^-70 by the goals of pairs */
static void write_times(void)
{
    start();
    const Real x = variable("x", 1.3);
    const struct cor_inline_pair f = pair_variable("f", 1.7);
    const Real value = times(x, f);
    const int last = at(value, "a");
    expect(what_is(last) == ADD && is_constant(at(value, "b"), 1), "times");
    gappa g;
    g.cut("x", x, "[1, 2]");
    pair_in(g, f, "fh", "fl");
    g.define(at(last, "b"));
    g.call({{"s", last}});
    const std::string product = product_error(g, at(last, "a"), at(last, "ba"));
    g.say("off = ($s.a + $s.b) - $x * ($fh + $fl);");
    g.hint("off -> ($s.b - ($s.ba + $s.bb)) + ($s.bb - $x * $fl) + " + product);
    g.write("disk_times", {}, "|off|" + at_most(COR_PROOF_PAIRS));
    const int square_last = square_times(x, f).node(), square = at(square_last, "aaa");
    expect(what_is(square_last) == ADD && what_is(square) == MULTIPLY && at(square, "a") == x.node() &&
               at(square, "b") == x.node(),
           "square_times");
    const struct cor_inline_pair again = cor_inline_pair_times(cor_inline_product(x, x), f);
    expect(again.hi.node() == at(square_last, "a") && again.lo.node() == at(square_last, "b"), "square_times");
}

/* ---- the formulas of the law ---- */

/* The last logarithm and Newton's step of a trace */
struct found_t {
    int log, hi, lo;
};

static found_t find_t(void)
{
    found_t t;
    t.log = find_operation(LOG, true);
    const int y = at(t.log, "a");
    t.hi = last_where([&](const node &n) { return n.what == SUBTRACT && n.a == y && is_constant(n.b, 1); });
    t.lo = last_where([&](const node &n) {
        return n.what == MULTIPLY && n.a == y && what_is(n.b) == DIVIDE && at(n.b, "b") == t.hi;
    });
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
    for (std::size_t i = 0; i < nodes.size(); i++) {
        const operation what = nodes[i].what;
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
    const mpq_class moved = exact_value(limit.exponent, known);
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
    for (std::size_t i = 0; i < nodes.size(); i++)
        if (nodes[i].what == HEAD)
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
    expect(exact_value(pair.hi, known) + exact_value(pair.lo, known) == value, "limit_number");
    expect(exact_value(at(q.hi, "a"), known) == (value - mpq_class(3, 4)) / mpq_class(3, 4), "cor_log_ratio_near");
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
