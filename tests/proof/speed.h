/* SPDX-License-Identifier: MIT */
/* Checks the functions of an impact speed (cor/contact.h); part of goals.cpp. They combine functions that have their
 * own goals. This file adds the errors; no sum may exceed the public bound. docs/theory.md, 4, bounds the derivatives
 * that multiply the error of beta. The numbers in a contact count as exact. */

/* Errors are relative, in units of 2^-53, half the distance between the doubles just above 1. n ulp are at most 2 n
 * units. */
static const number units_per_ulp = 2;

/* The proved errors in docs/accuracy.md, rounding and formula together, in ulp */
static const number eps_ulp = 0.96, far_root_ulp = 0.9 + 4.1e-17 * 0x1p52, duration_overlap_ulp = 1.35,
                    duration_force_ulp = 1.14, max_overlap_ulp = 0.84, inverse_ulp = 1.93;

/* Errors of the rounded x^(1/5), and of its pair before this rounding */
static const number fifth_root = 1.42, root_pair = 0.41;

/* Bounds products of errors, errors of pairs (2^-70), and the change of kappa between neighbours (below 2e-9) */
static const number small = 0.001;

/* kappa = |d ln(eps)/d ln(beta)| >= 1/2 for beta >= 2, x = beta^5 */
static number least_kappa(number x)
{
    return x >= 32 ? 0.5 : 0;
}

static void expect_at_most(const std::string &what, number error, number bound)
{
    if (!(error <= bound))
        die(what + ": " + std::to_string(error) + " is above the bound " + std::to_string(bound));
}

/* Reads the proved bits of a table's rows, -log2 of their errors, from the comment above the table. */
static std::vector<number> bits_of_rows(const char *file, const std::string &name)
{
    std::ifstream in(file);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const char *const label = "Bits of the rows:";
    std::istringstream words(text.substr(text.rfind(label, text.find("cor_rows_" + name)) + strlen(label)));
    std::vector<number> bits;
    for (std::string word; words >> word && word != "*/";)
        if (word != "*")
            bits.push_back(std::stod(word));
    return bits;
}

/* Checks eps from a row in x = beta^5. The two rounding errors of x change beta by 2/5 of a unit. The bound grows
 * faster with kappa than the error, so the least kappa of the row is tested. */
static void check_rows_at_speed(const evaluator &f, const char *file)
{
    const std::vector<number> bits = bits_of_rows(file, f.name);
    expect(bits.size() == (std::size_t)f.rows.count, f.name);
    for (int i = 0; i < f.rows.count; i++) {
        const row r = row_of(f.rows, i);
        const number x = std::ldexp(r.low, r.octave), kappa = least_kappa(x);
        const number error = f.ulp * units_per_ulp + std::exp2(53 - bits[(std::size_t)i]) + 0.4 * kappa + small;
        const number bound = COR_CONTACT_EPS_MAX_ERROR(kappa) * 0x1p53;
        expect_at_most("eps at a speed, " + std::string(f.name) + " from x = " + hex(x), error, bound);
    }
}

/* Checks the other ways to compute eps. Each is used if beta^5 >= x. */
static void check_eps_sums(void)
{
    const struct {
        const char *what;
        number ulp, by_kappa, x;
    } sums[] = {
        {"eps of the fifth root of x", eps_ulp, 0.4 + fifth_root, 0},
        {"eps of beta", eps_ulp, fifth_root, 0},
        {"h*^5/x", far_root_ulp, 0.4, COR_ROWS_POWER_EPS_ZERO_OVERLAP_END},
    };
    for (const auto &s : sums) {
        const number kappa = least_kappa(s.x), bound = COR_CONTACT_EPS_MAX_ERROR(kappa) * 0x1p53;
        const number slope = COR_CONTACT_EPS_MAX_ERROR(kappa + 1) * 0x1p53 - bound;
        expect_at_most(s.what, s.ulp * units_per_ulp + s.by_kappa * kappa + small, bound);
        expect_at_most(s.what, s.by_kappa + small, slope);
    }
}

/* Returns the error of the product scale y root^4, the largest overlap, in ulp. `product` is an interval of the
 * significands of the product so far, `error` its error before it is rounded, and `factors` counts the missing roots. A
 * rounding error is at most 1/m units if the result has the significand m. n units of such a number are n m/2 ulp. */
static number products_ulp(interval product, interval root, int factors, number error)
{
    if (product.low >= 2)
        product = {product.low / 2, product.high / 2};
    if (product.high > 2)
        return std::max(products_ulp({product.low, 2}, root, factors, error),
                        products_ulp({1, product.high / 2}, root, factors, error));
    error += 1 / product.low;
    if (factors == 0)
        return error * product.high / 2;
    const interval next = {product.low * root.low * (1 - 0x1p-50), product.high * root.high * (1 + 0x1p-50)};
    return products_ulp({std::max<number>(next.low, 1), next.high}, root, factors - 1,
                        error + root_pair + 1 / root.low);
}

/* Returns the largest products_ulp() over all significands of scale y and of root. `error`: of scale y, before it is
 * rounded. */
static number overlap_ulp(number error)
{
    enum { CELLS = 256 };
    number most = 0;
    for (int i = 0; i < CELLS; i++)
        for (int j = 0; j < CELLS; j++) {
            const interval product = {1 + (number)i / CELLS, 1 + (number)(i + 1) / CELLS};
            const interval root = {1 + (number)j / CELLS, 1 + (number)(j + 1) / CELLS};
            most = std::max(most, products_ulp(product, root, 4, error));
        }
    return most;
}

/* Checks the order of the operations whose errors are added here. */
static void check_operations(void)
{
    start();
    const Real scale = variable("scale", 0.75), root = variable("root", 1.25), y = variable("y", 1.5);
    gappa shape;
    shape.call({{"scale", scale}, {"root", root}, {"y", y}});
    shape.match(cor_contact_duration_of(scale, root, y), "((scale/root)*y)");
    shape.match(cor_contact_dissipation_of(scale, root, y), "((y*scale)/(1.5*root))");
    shape.match(cor_contact_overlap_of(scale, root, y), "(((((scale*y)*root)*root)*root)*root)");
}

/* Checks durations, the largest overlap and A at a speed, in ulp. Bounds of |d ln(y)/d ln(beta)|: 3/2 for the duration
 * at zero force, 1 + 5/1.74 for the duration at zero overlap, 2/3 for the largest overlap. */
static void check_seconds(void)
{
    const number overlap = max_overlap_ulp * units_per_ulp + fifth_root * 2 / 3;
    const struct {
        const char *what;
        number ulp;
    } sums[] = {
        {"duration at zero force", duration_force_ulp * units_per_ulp + fifth_root * (1 + 1.5) + 2},
        {"duration at zero overlap", duration_overlap_ulp * units_per_ulp + fifth_root * (2 + 5 / 1.74) + 2},
        {"largest overlap", overlap_ulp(overlap)},
        {"A of eps", inverse_ulp * units_per_ulp + fifth_root + 3},
    };
    for (const auto &s : sums)
        expect_at_most(s.what, s.ulp + small, COR_CONTACT_MAX_ULP);
}

/* cor_contact_beta_of_root: within 1.001 units of factor (hi + lo), where hi has 26 bits and lo is small. */
static void write_contact_beta(void)
{
    start();
    const Real factor = variable("factor", 1.3);
    const struct cor_inline_pair root = {variable("root", 1.25), variable("root_lo", 1e-5)};
    const int value = cor_contact_beta_of_root(factor, root).node();
    gappa g;
    g.call({{"f", factor}, {"lo", root.lo}, {"value", value}});
    g.variable_in(factor, {1, 2});
    give_head(g, root.hi, "R", "[1, 2]");
    g.variable_in(root.lo, {-0x1p-12, 0x1p-12});
    g.define(value);
    g.say("exact = $f * ($r + $lo);");
    g.say("S = $value.a + $value.b;");
    g.say("terms = $r * $value.bab + $lo * $f;");
    g.hint("S - exact -> ($value.a - $r * $value.ab) + ($value.b - terms) + $r * ($value.bab - ($f - $value.ab))");
    g.write("contact_beta", {}, "|$value -/ exact| <= " + hex(std::ldexp(1.001, -53)));
}

static void check_speed(const char *tables)
{
    for (const evaluator &f : row_tables)
        if (strncmp(f.name, "power_eps_", 10) == 0)
            check_rows_at_speed(f, tables);
    check_eps_sums();
    check_operations();
    check_seconds();
    write_contact_beta();
}
