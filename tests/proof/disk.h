/* SPDX-License-Identifier: MIT */
/* The goals for the contact law of the disk: part of goals.cpp. Each goal is about one stage of
 * runtime/number/lambert_w.c or runtime/disk/quasistatic.c. In a goal, the result of `log` or `log1p` may be any
 * number, so the goal does not depend on their accuracy. tests/proof/disk_bounds.cpp adds the errors of the stages,
 * amplified by the later stages, over cells that cover the domain. errors.h has the errors for both programs. */

/* ---- parts of lists of operations ---- */

/* Declares hi + lo the exact sum of six operations (Knuth's theorem: for any two numbers no error remains). */
static void exact_two_sum(gappa &g, term hi, term lo)
{
    g.match_anew(lo, "((s1-(sum:(s1+s2)-part:(sum-s1)))+(s2-part))", {{"sum", hi}});
    g.define(hi);
    g.give(lo, constant_of(g["s2"]) == 0 ? "= ($s1) - $sum" : "= ($s1 + $s2) - $sum", "same");
}

/* Returns the first or the last operation of a kind, which must exist. */
static int find_operation(operation what, bool last = false)
{
    int found = last_where([&](const node &n) { return n.what == what; });
    for (int i = found; i >= 0 && !last; i--)
        found = what_is(i) == what ? i : found;
    expect(found >= 0, "an operation, " + std::to_string(what) + ",");
    return found;
}

/* ---- logarithms ---- */

/* Writes a goal of cor_log_ratio_far for each exponent of x = m 2^e, and two where the code begins to scale x. hi + lo
 * is within COR_PROOF_FAR of a - e ln(2) - L. a is the logarithm of the limit, L the double that log(m) returns, and
 * |ln(m)| < 0.3466. The last sum is exact if the result is above 1/2, because it adds a rest below 2^-30. */
static void write_log_far(void)
{
    const function f = [](Real x) { return cor_log_ratio_far({Real(1.3), Real(1e-17)}, x).hi; };
    const std::vector<interval> pieces = pieces_of(f, 0x1p-1074, 8);
    int last = -1075;
    for (const interval &p : pieces) {
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
        /* `all` and `large` are exact sums of two numbers */
        g.match(q.hi, "q:(all:(large:(ah+e)+-l)+rest:(allo+(largelo+(al-f))))");
        exact_two_sum(g, g["large"], g["largelo"]);
        exact_two_sum(g, g["all"], g["allo"]);
        exact_sum(g, q.hi, q.lo);
        g.call({{"ql", q.lo}});
        g.assume("$all in [-10, 800]");
        g.assume(ln2);
        const std::string multiple = "(" + std::to_string(e) + ") * LN2";
        g.say("off = ($q + $ql) - (($ah + $al)" + (e == 0 ? "" : " - " + multiple) + " - $l);");
        g.hint("off -> ($rest - ($rest.a + $rest.b)) + ($rest.b - ($rest.ba + $rest.bb))" +
               (e == 0 ? "" : " + ($rest.bb - ($al - $f)) + (($e - $f) + " + multiple + ")"));
        g.write(numbered("disk_far", (int)(&p - &pieces[0])), {},
                "off" + units(COR_PROOF_FAR) + " /\\ |$rest| in [0, 1b-30]");
    }
    expect(last == 3 || last == 2, "cor_log_ratio_far: the last exponent");
}

/* Writes the goal for the remainder of the quotient d of cor_log_ratio_near, before its division. The remainder is
 * within 2^-74 of difference - d x for d and x from [1, 2]. Powers of two in d or x scale every operation. */
static void write_log_near(void)
{
    start();
    const struct cor_inline_pair a = {variable("a", 1.5), variable("a_lo", 1e-17)};
    const Real x = variable("x", 1.25);
    const struct cor_inline_pair q = cor_log_ratio_near(a, x);
    gappa shape;
    shape.call({{"a", a.hi}, {"al", a.lo}, {"x", x}});
    shape.match(q.hi, "log1p(q:(d:(part:(a-x)+al)/x))");
    shape.match(q.lo, "(rest:((d-product)-off)/(x+d))");
    {
        gappa g = shape;
        g.cut("d", "[1, 4]");
        g.cut("x", "[1, 2]");
        g.define(g["rest"]);
        g.assume("$q in [1, 2]");
        const std::string product = product_error(g, g["product"], g["off"]);
        g.say("exact = $d - $q * $x;");
        g.hint("exact -> $x * ($d / $x - $q) { $x <> 0 }");
        g.hint("$d - $product -> exact - ($product - $q * $x)");
        g.hint("$rest - exact -> ($rest - ($rest.a - $rest.b)) + ($rest.a - ($d - $product)) - " + product);
        g.write("disk_near_remainder", {}, "|$rest - exact|" + at_most(COR_PROOF_NEAR));
    }
    /* a.hi - x is exact for x <= a.hi <= 1.66 x */
    for (int k = 0; k < 2; k++) {
        gappa g = shape;
        g.cut("x", "[1, 2]");
        g.cut("a", k ? "[2, 4]" : "[1, 2]");
        g.define(g["part"]);
        g.assume("$a - $x in [0, 1.4]");
        g.write("disk_near_difference_" + std::to_string(k), {}, "$part - ($a - $x) in [0, 0]");
    }
}

/* ---- t of q ---- */

/* A rounded root p of the double t, and the correction c = (t + tl - p^2)/(2 p) of cor_pair_root; h and low are the
 * square of p. c has an error below 2^-70 for p from [1, 2]. Powers of four in t scale every operation. */
#define ROOT_CORRECTION "c:((0.5*s:(((t-h)-low)+tl))*r:(1/p))"
static void write_root_correction(const std::string &name, gappa g)
{
    g.cut("p", "[1, 2]");
    g.cut("t", "[0.99, 4.01]");
    g.cut("tl", "[-1b-50, 1b-50]");
    g.define(g["c"]);
    const std::string product = product_error(g, g["h"], g["low"]);
    /* p is within 2^-53 p of the root */
    g.assume("$t - $p * $p in [-1b-50, 1b-50]");
    g.say("R = ($t - $p * $p) + $tl;");
    g.hint("$t - $h -> ($t - $p * $p) - ($h - $p * $p)");
    g.hint("$s - R -> ($s - ($s.a + $tl)) + ($s.a - ($s.aa - $low)) + ($s.aa - ($t - $h)) - " + product);
    g.hint("$s -> R + ($s - R)");
    g.hint("$c - R / (2 * $p) -> ($c - $c.a * $r) + ($c.a - 0.5 * $s) * $r + 0.5 * ($s - R) * $r + 0.5 * R * ($r - 1 / "
           "$p) { $p <> 0 }");
    g.write(name, {}, "|$c - R / (2 * $p)| in [0, 1b-70]");
}

/* Returns a double as a rational number. */
static mpq_class rational(number x)
{
    return mpq_class(x);
}

/* Goals of cor_lambert_t_pair for q.hi < 0.1: t is p = sqrt(2 q.hi), its correction, and the rest of the series. The
 * rest has a relative error below COR_PROOF_SERIES, the correction an error below 2^-70 for p from [1, 2]. */
static void write_series(void)
{
    start();
    const struct cor_inline_pair q = {variable("q", 0.04), variable("q_lo", 1e-19)}, t = cor_lambert_t_pair(q);
    gappa shape;
    shape.match(t.hi, "p:sqrt(t)");
    shape.match(t.lo, "(" ROOT_CORRECTION "+rest)");
    check_formula("the series of cor_lambert_t_pair", {shape["rest"]}, [&](assignment &known) {
        const mpq_class z = known[shape["p"]] = arbitrary();
        mpq_class series = 0;
        for (std::size_t k = sizeof lambert_series / sizeof *lambert_series; k-- > 0;)
            series = series * z + rational(lambert_series[k].value);
        return mpq_class(series * z * z);
    });
    gappa g = shape;
    g.cut("p", "[1b-251, " + hex(COR_PROOF_SERIES_MAX_P) + "]");
    g.define(g["rest"]);
    g.write("disk_series", {}, "($rest - @rest) / @rest" + units(COR_PROOF_SERIES));
    write_root_correction("disk_series_correction", shape);
}

/* Writes the goal for the start at q <= 3: 1 + p (1 + p (1/3 + p (1/36 - p/270))) has a relative error below 2^-48. */
static void write_start(void)
{
    start();
    const struct cor_inline_pair q = {variable("q", 1.1), variable("q_lo", 1e-19)};
    cor_lambert_t_pair(q);
    const int p = find_operation(SQRT), y = at(find_operation(LOG), "a");
    check_formula("the start of t", {y}, [&](assignment &known) {
        const mpq_class z = known[p] = arbitrary();
        return mpq_class(1 + z * (1 + z * (rational(1.0 / 3) + z * (rational(1.0 / 36) - z * rational(1.0 / 270)))));
    });
    gappa g;
    g.cut("p", p, "[0.44, 2.46]");
    g.call({{"y", y}});
    g.define(y);
    g.write("disk_start", {}, "($y - @y) / @y" + units(COR_PROOF_START));
}

/* Names the operations of both steps for y = 1 + t: logarithms l, residuals r, u = y - 1. They must compute y (1 +
 * (r/u) (b + r)/(b + 2 r)) and y r/u. */
static gappa steps_at(number place)
{
    start();
    const struct cor_inline_pair q = {variable("q", place), variable("q_lo", 1e-19)}, t = cor_lambert_t_pair(q);
    gappa f;
    f.call({{"q", q.hi}, {"ql", q.lo}, {"u", t.hi}});
    f.match(t.lo, "lo:(y:(y0+(y0*(o:(((q-(y0-1))+l0:log(y0))/(y0-1))*ratio)))*(r:((high+l:log(y))+(low+ql))/u:(y-1)))");
    check_formula("the step of fourth order", {f["y"]}, [&](assignment &known) {
        const mpq_class z = known[f["y0"]] = arbitrary(), log = known[f["l0"]] = arbitrary(), u = z - 1,
                        r = ((known[f["q"]] = arbitrary()) - u) + log, b = 2 * u * (u + r * rational(2.0 / 3));
        return mpq_class(z + z * (r / u * ((b + r) / (b + 2 * r))));
    });
    check_formula("Newton's step", {f["lo"]}, [&](assignment &known) {
        const mpq_class z = known[f["y"]] = arbitrary(), log = known[f["l"]] = arbitrary(),
                        whole = known[f["q"]] = arbitrary(), less = known[f["ql"]] = arbitrary();
        return mpq_class(z * ((whole + less - (z - 1) + log) / (z - 1)));
    });
    return f;
}

/* A cell of y, and the possible numbers for log(y) and q.hi */
struct step_cell {
    number low;
    std::string y, log, q, index;
};

/* If the residual r contains the double L that log(y) returns, y (1 + ...) has a relative error below
 * COR_PROOF_STEP. */
static void write_first_step(gappa g, const step_cell &cell)
{
    g.cut("y0", cell.y);
    g.cut("l0", cell.log);
    g.cut("q", cell.q);
    g.define(g["y"]);
    g.assume("@o.a" + units(COR_PROOF_FIRST_RESIDUAL * cell.low));
    g.hint("$o - @o -> ($o - $o.a / $o.b) + ($o.a - @o.a) / $o.b + @o.a * (@o.b - $o.b) / ($o.b * @o.b)"
           " { $o.b <> 0, @o.b <> 0 }");
    g.write("disk_step_" + cell.index, {}, "($y - @y) / @y" + units(COR_PROOF_STEP));
}

/* Newton's step is within COR_PROOF_NEWTON y of y R/u, where R is the residual with the double L that log(y) returns. q
 * - u is an exact sum if u >= q, which disk_bounds.cpp proves. */
static void write_newton_step(gappa g, const step_cell &cell)
{
    g.cut("y", cell.y);
    g.cut("l", cell.log);
    g.cut("q", cell.q);
    g.cut("ql", "[-1b-42, 1b-42]");
    exact_sum(g, g["high"], g["low"]);
    g.define(g["lo"]);
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
    for (const number place : {0.2, 3.1, 700.0}) /* both starts have the same steps */
        steps_at(place);
    const gappa f = steps_at(1.1);
    std::vector<number> ends; /* no cell contains a power of two, which would change the unit of y */
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

/* ---- sums ---- */

/* Writes the goals for the rounding errors of the low parts in cor_pair_plus(1, t) and cor_pair_plus(1/2, q). t.lo is
 * below 0.09 after the series and below 2^-31 y after Newton's step. q is a pair. */
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

/* Writes the goals of pair_sqrt: the correction of the root, as above, and the exact last sum. */
static void write_pair_sqrt(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), root = pair_sqrt(x);
    gappa shape;
    shape.call({{"t", x.hi}, {"tl", x.lo}});
    shape.match(root.hi, "(p:sqrt(t)+" ROOT_CORRECTION ")");
    write_root_correction("disk_pair_sqrt", shape);
}

/* Writes the goal for times_pair, before the last rounding. Checks that square_times only multiplies pairs, whose goals
 * give an error of 2^-70. */
static void write_times(void)
{
    start();
    const Real x = variable("x", 1.3);
    const struct cor_inline_pair f = pair_variable("f", 1.7);
    const struct cor_inline_pair again = cor_inline_pair_times(cor_inline_product(x, x), f);
    gappa g;
    g.call({{"hi", again.hi}, {"lo", again.lo}});
    g.match(times_pair(x, f), "(s*1)");
    write_by_pair("disk_times", g["s"], x, f);
    g.match(square_times(x, f), "(hi+lo)");
}

/* ---- the formulas of the law ---- */

static mpq_class of_pair(const struct cor_inline_pair &x)
{
    return rational(x.hi.value) + rational(x.lo.value);
}

/* Returns Newton's step from the root r in the trace: r + (x - r^2)/(2 r). */
static mpq_class newton_root(const mpq_class &x, const mpq_class &r)
{
    return r + (x - r * r) / (2 * r);
}

typedef mpq_class formula(const mpq_class &x, const mpq_class &t, const mpq_class &r);
#define FORMULA(...) [](const mpq_class &x, const mpq_class &t, const mpq_class &r) { return mpq_class(__VA_ARGS__); }

/* A function of the law and its formula */
struct law_formula {
    const char *name;
    Real (*law)(Real x, Real nu, enum cor_disk_datum datum);
    enum quantity quantity;
    bool inverse; /* true: t is t(q); false: t is q */
    int multiple; /* q is this multiple of the logarithm */
    formula *of;
    const struct cor_logarithm *constant; /* the a of a leading logarithm ln(a/x), or NULL */
};

/* Checks that a function of the law, without rounding, is its formula in x, t and a root r. x = 0.75 2^exponent is far
 * from the limit, so q = slope nu + ln(limit at nu = 0) - ln(x). Results of log and sqrt are arbitrary. */
static void check_law_at(const law_formula &f, enum cor_disk_datum datum, int exponent)
{
    start();
    const Real x = variable("x", std::ldexp(0.75, exponent)), nu = variable("nu", 0.25);
    const int result = f.law(x, nu, datum).node();
    struct limit limit;
    find_limit(f.quantity, nu, datum, &limit);
    if (f.constant != nullptr)
        limit = {*f.constant, Real(0)};
    const int far = find_operation(LOG), last = find_operation(LOG, true), y = at(last, "a"); /* y of Newton's step */
    const int hi = last_where([&](const node &n) { return n.what == SUBTRACT && n.a == y && is_constant(n.b, 1); });
    const int lo = last_where(
        [&](const node &n) { return n.what == MULTIPLY && n.a == y && what_is(n.b) == DIVIDE && at(n.b, "b") == hi; });
    expect(!f.inverse || (hi >= 0 && lo >= 0), "the law of the disk");
    assignment known;
    known[x.node()] = arbitrary();
    known[nu.node()] = arbitrary();
    mpq_class root; /* the last root in the list is the r of the formula */
    for (std::size_t i = 0; i < nodes.size(); i++) {
        const operation what = nodes[i].what;
        if (what == HEAD || what == SEED || what == LOG)
            known[(int)i] = arbitrary();
        if (what == SQRT)
            known[(int)i] = root = arbitrary();
    }
    if (f.law == law_load_of_energy && exponent < -900) /* the source takes the root of 2^200 times the argument */
        root /= rational(0x1p100);
    const mpq_class slope = datum == COR_DISK_DATUM_DIAMETER  ? mpq_class(0)
                            : datum == COR_DISK_DATUM_PRINTED ? mpq_class(-1)
                                                              : mpq_class(-1, 4);
    const mpq_class moved = exact_value(limit.exponent, known);
    expect(f.constant != nullptr || moved == (f.quantity == ENERGY ? 2 : 1) * slope * known[nu.node()], f.name);
    mpq_class q = of_pair(limit.at_zero.log) + moved - known[far] -
                  exponent * (rational(0.69314718055989033019) + rational(5.4979230187083711747e-14));
    q *= f.multiple;
    /* products and sums of constants are rounded in every trace; the goals for logarithms cover them */
    const mpq_class rounding = rational(0x1p-75);
    mpq_class value = q;
    if (f.inverse) {
        const mpq_class u = exact_value(hi, known), low = (u + 1) * (q - u + known[last]) / u;
        expect(abs(low - exact_value(lo, known)) <= abs(low) * rounding, f.name);
        value = u + low;
    }
    const mpq_class wanted = f.of(known[x.node()], value, root);
    expect(abs(exact_value(result, known) - wanted) <= abs(wanted) * rounding, f.name);
}

/* Adapts a leading logarithm, which depends only on x, to the type of the other functions. */
template <Real (*law)(Real)> static Real of_x(Real x, Real, enum cor_disk_datum)
{
    return law(x);
}

static void check_law(void)
{
    static const law_formula laws[] = {
        {"cor_disk_load_by_pairs", cor_disk_load_by_pairs, COMPRESSION, true, 1, FORMULA(x * of_pair(pi) / (1 + t))},
        {"law_compression", law_compression, LOAD, false, 1, FORMULA(x * of_pair(one_over_pi) * (1 + t))},
        {"law_energy", law_energy, LOAD, false, 1, FORMULA(x * x * of_pair(one_over_two_pi) * (mpq_class(1, 2) + t))},
        {"law_load_of_energy", law_load_of_energy, ENERGY, true, 1,
         FORMULA(newton_root(of_pair(four_pi) * x / (1 + t), r))},
        {"law_max_load", law_max_load, SPEED, true, 2, FORMULA(x * of_pair(root_2_pi) / newton_root(1 + t, r))},
        {"law_max_compression", law_max_compression, SPEED, true, 2,
         FORMULA(x * of_pair(root_2) * (1 + t / 2) / newton_root(1 + t, r))},
        {"leading_compression", of_x<cor_disk_compression_leading_log>, LOAD, false, 1,
         FORMULA(x * of_pair(one_over_pi) * t), &log_four_pi},
        {"leading_load", of_x<cor_disk_load_leading_log>, LOAD, false, 1, FORMULA(x * of_pair(pi) / t), &four},
        {"leading_energy", of_x<cor_disk_energy_leading_log>, LOAD, false, 1, FORMULA(x * x * of_pair(half_pi) / t),
         &four},
        {"leading_max_compression", of_x<cor_disk_max_compression_leading_log>, LOAD, false, 1,
         FORMULA(x * newton_root(t, r)), &four},
        {"leading_contact_time", of_x<cor_disk_contact_time_leading_log>, LOAD, false, 1,
         FORMULA(of_pair(pi) * newton_root(t, r)), &four},
    };
    for (const law_formula &f : laws)
        for (const enum cor_disk_datum datum :
             {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER, COR_DISK_DATUM_PRINTED})
            for (const int exponent : {-6, -949}) /* at x = 0.75 2^-949 functions scale their argument */
                check_law_at(f, datum, exponent);
}

/* Checks log1p near the limit: it receives (limit - x)/x. Without rounding, the limit is its value at nu = 0 times (1 +
 * s)^512, where s has ten terms of the series of exp(slope nu/512) - 1. */
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
    static const struct cor_inline_pair coefficients[] = {{1, 0},
                                                          {0.5, 0},
                                                          {0.166666666666666657, 9.25185853854297066e-18},
                                                          {0.0416666666666666644, 2.31296463463574266e-18},
                                                          {0.00833333333333333322, 1.15648231731787138e-19},
                                                          {0.00138888888888888894, -5.30054395437357706e-20},
                                                          {1.0 / 5040, 0},
                                                          {1.0 / 40320, 0},
                                                          {1.0 / 362880, 0},
                                                          {1.0 / 3628800, 0}};
    mpq_class s = 0, factorial = 3628800;
    for (int k = 10; k > 0; factorial /= k, k--) {
        const mpq_class c = of_pair(coefficients[k - 1]);
        expect(abs(c * factorial - 1) < rational(k > 6 ? 0x1p-53 : 0x1p-104), "a coefficient of exp");
        s = r * (c + s);
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
    write_sums();
    write_pair_sqrt();
    write_times();
}
