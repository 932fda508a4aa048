/* SPDX-License-Identifier: MIT */
/* Writes one Gappa file for every piece of the sphere functions: an interval of arguments for which the evaluator
 * executes the same list of operations. docs/theory.md, "Rounding errors, proved", explains why this is a proof.
 *
 *     goals OUTPUT-DIRECTORY TABLES.h [PART PARTS [PATTERN...]]
 *
 * writes every goal, or only those whose name fits a pattern and whose number modulo PARTS is PART. TABLES.h is
 * generated/sphere_rows.h; the proved errors of rows in beta^5 are read from its text. The exit status is 1 if the
 * evaluator does not compute the formula of a row. */
#include "trace.h"

#include <cstring>
#include <fnmatch.h>
#include <gmpxx.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "cor/contact.h"
#include "errors.h"

/* The evaluator's source, with numbers that record operations. cor/contact.h is included above, with real doubles. */
namespace trace
{
#define double Real
#define uint64_t Bits
#define memcpy(to, from, size) copy(to, from)
#define __builtin_assoc_barrier(x) (x)
#include "runtime/sphere/contact_parts.h"
#include "runtime/sphere/eval.h"
/* the contact law of the disk */
#include "runtime/disk/quasistatic.c"
#include "runtime/number/lambert_w.c"
#undef double
#undef uint64_t
#undef memcpy
#undef __builtin_assoc_barrier
} // namespace trace

using namespace trace;

[[noreturn]] static void die(const std::string &what)
{
    fprintf(stderr, "goals: %s\n", what.c_str());
    exit(1);
}

static std::string hex(number x)
{
    char text[64];
    snprintf(text, sizeof text, "%a", x);
    return text;
}

static std::string within(number low, number high)
{
    return "[" + hex(low) + ", " + hex(high) + "]";
}

/* at_most gives the interval of an error's absolute value, and `units` the interval of the error itself */
static std::string at_most(number error)
{
    return " in [0, " + hex(error) + "]";
}
static std::string units(number error)
{
    return " in [-" + hex(error) + ", " + hex(error) + "]";
}

static std::string numbered(const std::string &name, int i)
{
    char digits[16];
    snprintf(digits, sizeof digits, "_%04d", i);
    return name + digits;
}

/* ---- the contents of the tables ---- */

struct table {
    const Real *(*rows)(int i);
    int count;
    number first, step;      /* nodes first + i step, if octave_bits < 0 */
    int octave, octave_bits; /* otherwise 2^octave_bits rows in each octave, from `octave` onward */
};
#define GRID(name, NAME)                                                                                               \
    {                                                                                                                  \
        cor_rows_##name, COR_ROWS_##NAME##_ROWS, COR_ROWS_##NAME##_FIRST, COR_ROWS_##NAME##_STEP, 0, -1                \
    }
#define OCTAVES(name, NAME)                                                                                            \
    {                                                                                                                  \
        cor_rows_##name, COR_ROWS_##NAME##_ROWS, 0, 0, COR_ROWS_##NAME##_FIRST_OCTAVE, COR_ROWS_##NAME##_OCTAVE_BITS   \
    }

struct row {
    int index, octave;
    number low, high; /* range of y, or of y 2^-octave */
    const Real *c;
    number node() const
    {
        return low == 0 ? 0 : (low + high) / 2;
    }
};

static row row_of(const table &t, int i)
{
    const bool by_octaves = t.octave_bits >= 0;
    const int cells = by_octaves ? 1 << t.octave_bits : 1;
    const number width = by_octaves ? 1.0 / cells : t.step;
    const number node = by_octaves ? 1 + width * (i % cells + 0.5) : t.first + i * t.step;
    return {i, by_octaves ? t.octave + i / cells : 0, std::max(node - width / 2, 0.0), node + width / 2, t.rows(i)};
}

/* Return a coefficient, and the row c_0 + c_0' + s (c_1 + c_2 t + ...). */
static mpq_class coefficient(const Real *c, int k)
{
    return mpq_class(c[k].value);
}
static mpq_class polynomial(const Real *c, const mpq_class &s, const mpq_class &t)
{
    mpq_class sum = 0;
    for (int k = COR_INLINE_COLUMNS; k-- > 2;)
        sum = sum * t + coefficient(c, k);
    return coefficient(c, 0) + coefficient(c, 1) + s * sum;
}

/* ---- exact arithmetic with a list of operations ---- */

typedef std::map<int, mpq_class> assignment;

/* Computes one of the operations that exist for both exact numbers and intervals. */
template <class T> static T arithmetic(const node &n, const T &x, const T &y)
{
    switch (n.what) {
    case CONSTANT:
        return T(n.value);
    case ADD:
        return x + y;
    case SUBTRACT:
        return x - y;
    case MULTIPLY:
        return x * y;
    case DIVIDE:
        return x / y;
    case NEGATE:
        return -x;
    default:
        die("an operation that no arithmetic knows: " + std::to_string(n.what));
    }
}

static mpq_class exact_value(term id, assignment &known)
{
    const auto found = known.find(id);
    if (found != known.end())
        return found->second;
    const node n = of(id);
    const mpq_class x = n.a < 0 ? mpq_class(0) : exact_value(n.a, known), y = n.b < 0 ? x : exact_value(n.b, known);
    return known[id] = arithmetic(n, x, y);
}

/* Returns a rational number, a different one at each of 4096 calls. */
static mpq_class arbitrary(void)
{
    static std::uint64_t state = 1;
    state = state * 6364136223846793005 + 1442695040888963407;
    static int calls;
    mpq_class value((long)(state >> 48), 65537);
    value.canonicalize();
    return value + 1 + calls++ % 4096;
}

/* Checks that the sum of some operations, without rounding, equals a formula. Compares them at 24 arbitrary values of
 * the variables. This is a proof for polynomials of one variable and a degree below 24. */
static void check_formula(const std::string &what, std::initializer_list<term> operations,
                          const std::function<mpq_class(assignment &)> &formula)
{
    for (int i = 0; i < 24; i++) {
        assignment known;
        mpq_class off = -formula(known);
        for (const term id : operations)
            off += exact_value(id, known);
        if (off != 0)
            die(what + ": the evaluator does not compute the formula");
    }
}

/* ---- intervals, widened by 2^-45, for the binades that a result can reach ---- */

struct interval {
    number low, high;
};

typedef std::map<int, interval> ranges;

static interval range_of(term id, ranges &known)
{
    const auto found = known.find(id);
    if (found != known.end())
        return found->second;
    const node n = of(id);
    const interval x = n.a < 0 ? interval{0, 0} : range_of(n.a, known), y = n.b < 0 ? x : range_of(n.b, known);
    const auto result = [&](number u, number v) -> number {
        return n.what == SQRT ? std::sqrt(u) : n.what == HEAD ? u * (1 - 0x1p-25) : arithmetic(n, u, v);
    };
    const auto ends = std::minmax({result(x.low, y.low), result(x.low, y.high), result(x.high, y.low),
                                   n.what == HEAD ? x.high : result(x.high, y.high)});
    interval z = {ends.first, ends.second};
    if (n.what == SUBTRACT && of(n.b).what == HEAD && of(n.b).a == n.a)
        z = {0, x.high * 0x1p-25};
    else if (n.what == MULTIPLY && n.a == n.b && x.low < 0 && x.high > 0)
        z = {0, std::max(x.low * x.low, x.high * x.high)};
    return known[id] = {z.low - std::fabs(z.low) * 0x1p-45, z.high + std::fabs(z.high) * 0x1p-45};
}

/* ---- pieces ---- */

typedef std::function<Real(Real)> function;

static word path_at(const function &f, number x)
{
    start();
    recording = false;
    f(variable("x", x));
    recording = true;
    return path;
}

/* Returns the pieces of [first, end). Every decision of the evaluator is a monotone function of the argument, so the
 * arguments of a piece are neighbours, and bisection finds the last one. */
static std::vector<interval> pieces_of(const function &f, number first, number end)
{
    std::vector<interval> all;
    word low = bits_of(first);
    const word stop = bits_of(end);
    while (low < stop) {
        const word path = path_at(f, number_of(low));
        word in = low, out = stop;
        for (word step = 1; out - in > 1 && in + step < out; step *= 2) {
            if (path_at(f, number_of(in + step)) != path) {
                out = in + step;
                break;
            }
            in += step;
        }
        while (out - in > 1) {
            const word middle = in + (out - in) / 2;
            (path_at(f, number_of(middle)) == path ? in : out) = middle;
        }
        all.push_back({number_of(low), number_of(in)});
        low = out;
    }
    return all;
}

/* Returns an operand of an operation by its path: "ab" is the second operand of the first operand. */
static int at(term f, const char *operands)
{
    int id = f;
    for (; *operands; operands++)
        id = *operands == 'a' ? of(id).a : of(id).b;
    return id;
}

static operation what_is(term id)
{
    return of(id).what;
}

/* Returns the last operation that fits, or -1. */
static int last_where(const std::function<bool(const node &)> &wanted)
{
    int i = (int)nodes.size() - 1;
    while (i >= 0 && !wanted(of(i)))
        i--;
    return i;
}

static void expect(bool yes, const std::string &what)
{
    if (!yes)
        die(what + " has changed");
}

/* ---- Gappa ---- */

static const char *output_directory;

/* Only files whose number is `part` modulo `parts` are written. */
static unsigned long part, parts = 1, files, written;

/* Patterns of the selected names; empty: all */
static std::vector<std::string> patterns;

/* Returns the value of a constant, or NaN for another operation. */
static number constant_of(int id)
{
    return of(id).what == CONSTANT ? of(id).value : NAN;
}

/* True if the operations that lead to `id` fit the pattern at p. See gappa::match. */
static bool fits(int id, const char *&p, std::map<std::string, int> &names)
{
    static const std::map<char, operation> signs = {{'+', ADD}, {'-', SUBTRACT}, {'*', MULTIPLY}, {'/', DIVIDE}};
    static const std::map<std::string, operation> functions = {
        {"sqrt", SQRT}, {"log", LOG}, {"log1p", LOG1P}, {"head", HEAD}};
    if (id < 0)
        return false;
    const node n = of(id);
    if (*p == '-')
        return n.what == NEGATE && fits(n.a, ++p, names);
    if (*p == '(')
        return fits(n.a, ++p, names) && n.what == signs.at(*p++) && fits(n.b, p, names) && *p++ == ')';
    const std::string word(p, strspn(p, "abcdefghijklmnopqrstuvwxyz_0123456789."));
    p += word.size();
    if (*p == '(')
        return n.what == functions.at(word) && fits(n.a, ++p, names) && *p++ == ')';
    if (std::isdigit(word[0]))
        return constant_of(id) == std::stod(word);
    const bool same = names.emplace(word, id).first->second == id;
    return *p == ':' ? same && fits(id, ++p, names) : same;
}

/* The text of a Gappa file in progress: rounded (n..) and exact (e..) versions of every operation. Texts contain "$x"
 * for the rounded version of the operation that `names` calls x, "@x" for the exact one, and "$x.ab" for an operand as
 * in at(). */
struct gappa {
    std::string text = "@rnd = float<ieee_64, ne>;\n@head = float<26, -2000, zr>;\n";
    std::map<int, bool> done;
    std::vector<std::string> hypotheses, hints;
    std::map<std::string, int> names;

    static std::string rounded(int id)
    {
        return name_of(id, 'n');
    }
    static std::string exact(int id)
    {
        return name_of(id, 'e');
    }
    static std::string name_of(int id, char kind)
    {
        if (id < 0)
            return "";
        const node &n = of(id);
        return n.what == CONSTANT ? "(" + hex(n.value) + ")" : kind + std::to_string(id);
    }

    std::string filled(const std::string &text_with_names) const
    {
        std::string full;
        const char *const letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
        for (const char *p = text_with_names.c_str(); *p;) {
            const char kind = *p++;
            const std::string name(p, kind == '$' || kind == '@' ? strspn(p, letters) : 0);
            p += name.size();
            const std::string operands(p + 1, !name.empty() && *p == '.' ? strspn(p + 1, "ab") : 0);
            p += operands.empty() ? 0 : 1 + operands.size();
            full += name.empty() ? std::string(1, kind)
                                 : name_of(at(names.at(name), operands.c_str()), kind == '$' ? 'n' : 'e');
        }
        return full;
    }

    void say(const std::string &line)
    {
        text += filled(line) + "\n";
    }

    void assume(const std::string &hypothesis)
    {
        hypotheses.push_back(filled(hypothesis));
    }

    void hint(const std::string &rule)
    {
        hints.push_back(filled(rule) + ";");
    }

    int operator[](const std::string &name) const
    {
        return names.at(name);
    }

    void call(std::initializer_list<std::pair<std::string, term>> more)
    {
        for (const auto &f : more)
            names[f.first] = f.second;
    }

    /* Names the operations that lead to `id`. They must fit the pattern: (x+y), -x, sqrt(x), 0.5, or a name, which
     * always means the same operation. name:pattern names the operation that fits the pattern. */
    void match(term id, const char *pattern)
    {
        const char *at = pattern;
        expect(fits(id, at, names), pattern);
    }

    /* Like match(), but keeps only the `known` names. Other names may mean another operation than before. */
    void match_anew(term id, const char *pattern, std::initializer_list<std::pair<std::string, term>> known)
    {
        gappa other;
        other.call(known);
        other.match(id, pattern);
        for (const auto &f : other.names)
            names[f.first] = f.second;
    }

    /* Defines an operation by a text: the rounded version and, if different, the exact one. */
    void give(term id, const std::string &round, const std::string &precise = "")
    {
        text += rounded(id) + " " + filled(round) + ";\n";
        if (!precise.empty())
            text += exact(id) + " = " + (precise == "same" ? rounded(id) : filled(precise)) + ";\n";
        done[id] = true;
    }

    /* Replaces an operation by any double of `interval`. The exact value of the operation is the same double. */
    void cut(const char *name, const std::string &interval)
    {
        give(names.at(name), "= rnd(cut" + std::to_string(names.at(name)) + ")", "same");
        assume("$" + std::string(name) + " in " + interval);
    }
    void cut(const char *name, term id, const std::string &interval)
    {
        names[name] = id;
        cut(name, interval);
    }

    /* Replaces an operation by any double of an interval. If `real`: by any real number there, rounded to a double. */
    void variable_in(term id, interval x, bool real = false)
    {
        const std::string v = "v" + std::to_string(id);
        give(id, "= rnd(" + v + ")", real ? v : "same");
        assume((real ? v : rounded(id)) + " in " + within(x.low, x.high));
    }

    void define(term id)
    {
        static const std::map<operation, const char *> signs = {
            {ADD, " + "}, {SUBTRACT, " - "}, {MULTIPLY, " * "}, {DIVIDE, " / "}};
        const node n = of(id);
        if (n.what == CONSTANT || done[id])
            return;
        done[id] = true;
        for (const int operand : {n.a, n.b})
            if (operand >= 0)
                define(operand);
        const std::string round = rounded(id), precise = exact(id) + " = ", a = rounded(n.a), a_exact = exact(n.a);
        const bool nothing_added = n.what == ADD && constant_of(n.a) == 0;
        if (nothing_added || ((n.what == SUBTRACT || n.what == ADD) && constant_of(n.b) == 0)) {
            const int same = nothing_added ? n.b : n.a;
            text += round + " = " + rounded(same) + ";\n" + precise + exact(same) + ";\n";
        } else if (signs.count(n.what)) {
            const std::string sign = signs.at(n.what);
            text += round + " rnd= " + a + sign + rounded(n.b) + ";\n" + precise + a_exact + sign + exact(n.b) + ";\n";
        } else if (n.what == NEGATE) {
            text += round + " = -" + a + ";\n" + precise + "-" + a_exact + ";\n";
        } else if (n.what == SQRT) {
            text += round + " = rnd(sqrt(" + a + "));\n" + precise + "sqrt(" + a_exact + ");\n";
        } else if (n.what == HEAD) {
            text += round + " = head(" + a + ");\n" + precise + round + ";\n";
        } else {
            die("an operation that no goal can state: " + std::to_string(n.what) + " at " + hex(n.value));
        }
    }

    void write(const std::string &name, const std::vector<std::string> &more, const std::string &conclusion) const
    {
        if (!patterns.empty() && std::none_of(patterns.begin(), patterns.end(), [&](const std::string &pattern) {
                return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
            }))
            return;
        if (files++ % parts != part)
            return;
        written++;
        const std::string path = std::string(output_directory) + "/" + name + ".g";
        if (std::ifstream(path))
            die(name + ": two goals have this name");
        std::ofstream out(path);
        out << text << "{ ";
        std::vector<std::string> all = hypotheses;
        all.insert(all.end(), more.begin(), more.end());
        for (std::size_t i = 0; i < all.size(); i++)
            out << (i ? " /\\ " : "") << all[i];
        out << " -> " << filled(conclusion) << " }\n";
        for (const std::string &hint : hints)
            out << hint << "\n";
    }
};

static std::string power_of_two(int k)
{
    return "1b" + std::to_string(k);
}

/* Writes goals: the rounded result of the last operation, a sum, is within `ulp` ulp of the exact value. Each file
 * assumes that the exact value is in one binade, and that the sum is below, in or above this binade. */
static void write_goals(const std::string &name, gappa &g, term result, ranges &known, number ulp)
{
    const node n = of(result);
    g.define(n.a);
    g.define(n.b);
    g.text += "sum = " + g.rounded(n.a) + (n.what == SUBTRACT ? " - " : " + ") + g.rounded(n.b) + ";\n";
    g.define(result);
    const std::string exact = g.exact(result), error = "|" + g.rounded(result) + " - " + exact + "|";
    const interval range = range_of(result, known);
    if (!(range.low > 0))
        die(name + ": the exact value is not known to be positive");
    int first, last;
    std::frexp(range.low, &first);
    std::frexp(range.high, &last);
    const bool whole = first == last;
    for (int k = first - 1; k <= last - 1; k++) {
        const std::string bound = " in [0, " + hex(std::ldexp(ulp, k - 52)) + "]";
        const std::string low = power_of_two(k), high = power_of_two(k + 1);
        /* the binade, widened by one part in 2^55 */
        const std::string binade = exact + " in [" + std::to_string((1L << 55) - 1) + "b" + std::to_string(k - 55) +
                                   ", " + std::to_string((1L << 55) + 1) + "b" + std::to_string(k + 1 - 55) + "]";
        if (whole) {
            g.write(name, {}, error + bound + " /\\ " + exact + " in [" + low + ", " + high + "]");
            return;
        }
        const std::string prefix = name + "_2_" + std::to_string(k) + "_";
        g.write(prefix + "below", {binade, "sum <= " + low}, error + bound);
        g.write(prefix + "in", {binade, "sum in [" + low + ", " + high + "]"}, error + bound);
        g.write(prefix + "above", {binade, "sum >= " + high}, error + bound);
    }
    g.write(name + "_range", {}, exact + " in [" + power_of_two(first - 1) + ", " + power_of_two(last) + "]");
}

/* ---- tables of rows ---- */

enum shape { IN_BETA, IN_ROOT, BY_OCTAVES, NEAR, NEAR_ROOT };

struct evaluator {
    const char *name; /* name of the function or of its table */
    function value;
    number first, end;
    shape kind;
    bool product; /* the value is m (c_0 + row); m is a factor */
    number ulp;
    table rows;
};

/* Returns the row for a number of a piece, according to the geometry of the table. */
static row row_for(const evaluator &f, number x)
{
    for (int i = 0; i < f.rows.count; i++) {
        const row r = row_of(f.rows, i);
        const number y = f.kind == IN_ROOT     ? std::sqrt(x)
                         : f.kind == NEAR      ? 1 - x
                         : f.kind == NEAR_ROOT ? std::sqrt(1 - x)
                                               : std::ldexp(x, -r.octave);
        if (y >= r.low && y <= r.high)
            return r;
    }
    die(std::string(f.name) + ": no row for " + hex(x));
}

static bool is_constant(term id, number value)
{
    return id >= 0 && of(id).what == CONSTANT && of(id).value == value;
}

/* The nodes of a piece that the goals need by name; -1: absent */
struct landmarks {
    int x, root, significand, head, loss, place;
};

/* Returns the landmarks. place: t in row 0, which the source computes as y - 0 - 0 step or y - 0 */
static landmarks landmarks_of(int result)
{
    std::vector<bool> needed(nodes.size(), false); /* the nodes on which the result depends */
    needed[(std::size_t)result] = true;
    for (int i = result; i >= 0; i--)
        for (const int operand : {of(i).a, of(i).b})
            if (needed[(std::size_t)i] && operand >= 0)
                needed[(std::size_t)operand] = true;
    const auto find_node = [&](const std::function<bool(const node &)> &wanted) {
        for (std::size_t i = 0; i < nodes.size(); i++)
            if (needed[i] && wanted(nodes[i]))
                return (int)i;
        return -1;
    };
    landmarks l;
    l.x = find_node([](const node &n) { return n.what == VARIABLE; });
    l.root = find_node([](const node &n) { return n.what == SQRT; });
    l.significand = find_node([](const node &n) { return n.what == SIGNIFICAND; });
    l.head = find_node([](const node &n) { return n.what == HEAD; });
    l.loss = find_node([&](const node &n) { return n.what == SUBTRACT && is_constant(n.a, 1) && n.b == l.x; });
    l.place = -1;
    for (std::size_t i = 0; i < nodes.size(); i++) {
        const node &n = nodes[i];
        const int y = l.root >= 0 ? l.root : l.loss >= 0 ? l.loss : l.x;
        if (needed[i] && n.what == SUBTRACT && is_constant(n.b, 0) && (n.a == y || n.a == l.place))
            l.place = (int)i;
    }
    return l;
}

/* Checks that the evaluator, without rounding, computes exactly c_0 + c_0' + s (c_1 + c_2 t + ...), times m, for the
 * row that the table's macros assign to the piece. */
static void check_row(const evaluator &f, const row &r, const landmarks &l, int result)
{
    const bool by_square = f.kind == IN_ROOT && f.rows.count == COR_ROWS_EPS_ZERO_FORCE_ROWS &&
                           r.index >= COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS;
    check_formula(numbered(f.name, r.index), {result}, [&](assignment &known) {
        const mpq_class node(r.node()), z = arbitrary(), t = z - node;
        if (l.root >= 0)
            known[l.root] = z;
        known[l.significand >= 0 ? l.significand : l.loss >= 0 ? l.loss : l.x] = l.root >= 0 ? mpq_class(z * z) : z;
        const mpq_class sum = polynomial(r.c, by_square ? mpq_class(z * z - node * node) : t, t);
        if (!f.product)
            return sum;
        known[l.head] = arbitrary(); /* any split of m gives the same product */
        return mpq_class(known[l.loss >= 0 ? l.loss : l.x] * sum);
    });
}

static void write_row_piece(const evaluator &f, const interval &p, int index)
{
    start();
    const Real value = f.value(variable("x", p.low));
    const int result = value.node();
    const landmarks l = landmarks_of(result);
    const row r = row_for(f, p.low + (p.high - p.low) / 2);
    check_row(f, r, l, result);
    const bool first = f.product && l.place >= 0 && r.low == 0;
    gappa g;
    ranges known;
    if (l.significand >= 0) {
        const interval m = {std::ldexp(p.low, -r.octave), std::ldexp(p.high, -r.octave)};
        g.variable_in(l.significand, known[l.significand] = m);
    } else if (first) {
        /* scaling m by a power of two scales the result, so m = 1 to 2 covers all cases; t is any number of the row */
        const int m = l.loss >= 0 ? l.loss : l.x;
        g.variable_in(m, known[m] = {1, 2});
        known[l.place] = {0, r.high};
        g.variable_in(l.place, known[l.place], l.root >= 0);
    } else if (l.loss >= 0) {
        g.variable_in(l.loss, known[l.loss] = {1 - p.high, 1 - p.low});
    } else {
        g.variable_in(l.x, known[l.x] = {p.low, p.high});
    }
    write_goals(numbered(f.name, index), g, result, known, f.ulp);
}

/* ---- tails ---- */

/* Adds hints for the pair of cor_inline_sum(a, b): s = a + b, z = s - a, lo = b - z. They state that lo is the rounding
 * error of s if z is exact, which Gappa then proves. Gives hi + lo a name and returns the text of hi + lo - (a + b). */
static std::string hint_sum(gappa &g, const struct cor_inline_pair &pair, const char *name)
{
    g.match_anew(pair.lo, "left:(small-cut:(sum:(large+small)-large))", {{"sum", pair.hi}});
    g.hint("$small - $cut -> (($large + $small) - $sum) + (($sum - $large) - $cut)");
    g.say(std::string(name) + " = $sum + $left;");
    return g.filled("(($sum - $large) - $cut) + ($left - ($small - $cut))");
}

/* ln(2) to 31 digits, rounded down and up */
static const char ln2[] = "LN2 in [0.693147180559945309417232121458, 0.693147180559945309417232121459]";

/* |hi + lo - ln(beta)| <= 2^-53 if log(m) is within COR_PROOF_LOG_ULP ulp of ln(m); an ulp is at most 2^-54 there.
 * Writes one goal for each exponent e of beta = m 2^e, |ln(m)| < 0.3466. */
static void write_log(void)
{
    for (int e = 2; e <= 1024; e++) {
        start();
        const bool up = e == 1024;
        const Real beta = variable("x", std::ldexp(up ? 1.75 : 1.25, up ? e - 1 : e));
        const struct cor_inline_pair u = cor_inline_log(beta);
        const int log = last_where([](const node &n) { return n.what == LOG; });
        const std::string exponent = std::to_string(e);
        gappa g;
        g.give(log, "= rnd(v)", "LNM");
        g.call({{"l", log}, {"hi", u.hi}});
        g.define(u.lo);
        g.define(u.hi);
        const std::string off = hint_sum(g, u, "pair");
        g.say("exact = " + exponent + " * LN2 + LNM;");
        g.hint("pair - exact -> " + off + " + ($hi.b - ($hi.ba + $l)) + ($l - LNM) + (($hi.a + $hi.ba) - " + exponent +
               " * LN2)");
        g.assume("LNM in [-0.3466, 0.3466]");
        g.assume(ln2);
        g.assume("|$l - LNM| <= " + hex(std::ldexp(COR_PROOF_LOG_ULP, -54)));
        g.write(numbered("log", e), {}, "|pair - exact| in [0, 1b-53]");
    }
}

/* The functions for large beta have factors, which are pairs. A factor has rows in u = ln(beta) up to u = 10, then
 * three orders in mu = beta^(-5/3). `error` is the relative error in the goals, in units of 2^-53. */
struct tail {
    std::string name;
    number error, far_error;
    table rows;
    const Real *far_row;
    struct cor_inline_pair (*factor)(Real beta);
};
#define TAIL(name, NAME, error, far_error)                                                                             \
    {                                                                                                                  \
#name, error, far_error, GRID(tail_##name, TAIL_##NAME), cor_rows_far_##name(0),                               \
            [](Real beta) { return COR_INLINE_LOG_FACTOR(beta, name, COR_ROWS_TAIL_##NAME); }                          \
    }
static const tail tails[] = {
    TAIL(eps_zero_force, EPS_ZERO_FORCE, 0.3, 0.1),
    TAIL(duration_zero_overlap, DURATION_ZERO_OVERLAP, 0.8, 0.2),
    TAIL(duration_zero_force, DURATION_ZERO_FORCE, 0.6, 0.2),
    TAIL(max_overlap, MAX_OVERLAP, 0.3, 0.1),
    TAIL(time_of_max_overlap, TIME_OF_MAX_OVERLAP, 0.6, 0.2),
};

/* Makes u.hi and u.lo variables with |hi + lo - U| <= 2^-53, which the goals of write_log prove. U is ln(beta). */
static void cut_log(gappa &g, const struct cor_inline_pair &u, interval range)
{
    g.call({{"hi", u.hi}, {"lo", u.lo}});
    g.give(u.lo, "= rnd(low)", "same");
    g.give(u.hi, "= rnd(high)", "U - $lo");
    g.assume("|$lo| <= " + hex(std::ldexp(range.high, -52)));
    g.assume("$hi in " + within(range.low, range.high));
    g.assume("$hi - @hi in [-1b-53, 1b-53]");
}

/* |pair - E| <= error 2^-53 E for a row of a tail. The row may be used slightly beyond its cell, because log is
 * rounded. */
static void write_tail_row(const tail &f, int index)
{
    const number slack = 0x1p-40;
    start();
    const row r = row_of(f.rows, index);
    const Real beta = variable("x", std::exp(r.node()));
    const struct cor_inline_pair u = cor_inline_log(beta), pair = f.factor(beta);
    const int hi = pair.hi.node(), lo = pair.lo.node();
    check_formula("the tail of " + f.name, {hi, lo}, [&](assignment &known) {
        const mpq_class y = arbitrary(), t = y - mpq_class(r.node()), rest = arbitrary();
        known[u.hi.node()] = y - rest;
        known[u.lo.node()] = rest;
        return polynomial(r.c, t, t);
    });
    gappa g;
    cut_log(g, u, {r.low - slack, r.high + slack});
    g.define(lo);
    const std::string off = hint_sum(g, pair, "pair");
    g.hint("pair - @sum -> " + off + " + ($sum.b - @sum.b)");
    g.write(numbered("tail_" + f.name, index), {}, "|(pair - @sum) / @sum|" + at_most(std::ldexp(f.error, -53)));
}

/* Returns the text of hi + lo - x y for a pair of cor_inline_product(x, y), with rounded x and y. lo approximates x y -
 * hi. */
static std::string product_error(gappa &g, term hi, term lo)
{
    g.match_anew(lo, "off:(((((h1*h2)-product:(x1*x2))+(h1*t2))+(t1*h2))+(t1*t2))", {{"product", hi}});
    const std::string low = "low" + std::to_string(lo);
    g.say(low + " = ((($h1 * $h2 - $product) + $h1 * ($x2 - $h2)) + ($x1 - $h1) * $h2) + ($x1 - $h1) * ($x2 - $h2);");
    g.hint(low + " -> $x1 * $x2 - $product");
    g.hint("$off -> " + low + " + ($off - " + low + ")");
    return g.filled("($off - " + low + ")");
}

/* The relative error of mu = 1/beta/(root root), from two roots and three operations */
static const number mu_error = (2 * COR_PROOF_CBRT_ULP + 2) * 0x1p-52;

/* Writes the goal for a tail up to MU^2, where U is in a binade and MU = exp(-5/3 U). */
static void write_far_binade(const tail &f, interval range, int index)
{
    start();
    const Real beta = variable("x", std::exp(range.low * 1.0001));
    const struct cor_inline_pair u = cor_inline_log(beta), pair = f.factor(beta);
    const int v = u.hi.node(), ulo = u.lo.node(), hi = pair.hi.node(), rest = at(hi, "b"), sum_hi = at(hi, "a");
    const int slope_lo = at(rest, "baaa"), second = at(sum_hi, "b");
    const int slope_hi = second >= 0 && what_is(second) == MULTIPLY ? second : at(sum_hi, "a");
    const int mu = last_where([](const node &n) { return n.what == DIVIDE && what_is(n.b) == MULTIPLY; });
    check_formula("far " + f.name, {hi, pair.lo}, [&](assignment &known) {
        const mpq_class y = arbitrary(), m = arbitrary();
        known[v] = y;
        known[ulo] = 0;
        known[mu] = m;
        for (std::size_t k = 0; k < nodes.size(); k++)
            if (nodes[k].what == HEAD)
                known[(int)k] = arbitrary();
        const auto c = [&](int k) { return coefficient(f.far_row, k); };
        return mpq_class(c(0) + c(1) + (c(2) + c(3)) * y + m * (c(4) + y * (c(5) + y * c(6))) +
                         m * m * (c(7) + y * (c(8) + y * (c(9) + y * c(10)))));
    });
    const number most = std::max(std::exp(-5 * range.low / 3) * (1 + 0x1p-40), 0x1p-900); /* mu may underflow */
    gappa g;
    g.call({{"v", v}, {"u", ulo}, {"mu", mu}});
    g.give(v, "= rnd(high)", "U");
    g.give(ulo, "= rnd(low)", "0");
    g.give(mu, "= rnd(m)", "MU");
    g.assume("$v in " + within(range.low - 0x1p-40, range.high));
    g.assume("U in " + within(range.low, range.high));
    g.assume("|$u| <= " + hex(std::ldexp(range.high, -52)));
    g.assume("($v + $u) - U in [-1b-53, 1b-53]");
    g.assume("$v - U" + units(std::ldexp(range.high, -51)));
    g.assume("MU in [0, " + hex(most) + "]");
    g.assume("|$mu - MU| <= " + hex(most * mu_error));
    g.define(pair.lo);
    const std::string off_2 = hint_sum(g, pair, "pair"),
                      off_1 = hint_sum(g, {Real(0, sum_hi), Real(0, at(rest, "a"))}, "inner"),
                      slope = product_error(g, slope_hi, slope_lo);
    g.call({{"rest", rest}, {"slope_lo", slope_lo}, {"orders", at(rest, "bbb")}});
    std::string c[4];
    for (int k = 0; k < 4; k++)
        c[k] = "(" + hex(f.far_row[k].value) + ")";
    g.say("exact = " + c[0] + " + " + c[1] + " + (" + c[2] + " + " + c[3] + ") * U + @orders;");
    g.say("terms = (($slope_lo + " + c[2] + " * $u) + " + c[3] + " * $v) + (" + c[1] + " + $orders);");
    g.hint("pair - exact -> " + off_2 + " + ($rest - ($rest.a + $rest.b)) + " + off_1 + " + " + slope +
           " + ($rest.b - terms) + " + c[2] + " * (($v + $u) - U) + " + c[3] + " * ($v - U) + ($orders - @orders)");
    g.write("far_" + f.name + "_" + std::to_string(index), {},
            "|(pair - exact) / exact|" + at_most(std::ldexp(f.far_error, -53)));
}

static void write_tails(void)
{
    for (const tail &f : tails) {
        for (int i = 0; i < f.rows.count; i++)
            write_tail_row(f, i);
        for (int k = 4; k <= 10; k++)
            write_far_binade(f, {k == 4 ? 10 : std::ldexp(1, k - 1), std::min(std::ldexp(1, k), 709.8)}, k);
    }
}

/* ---- pairs, powers and roots ---- */

/* Goals about functions of pairs. Arguments in [1, 2) cover all cases: scaling an argument by a power of two scales
 * every operation, and no caller lets an operation overflow or underflow. */

static struct cor_inline_pair pair_variable(const std::string &name, number hi)
{
    return {variable(name, hi), variable(name + "_lo", hi * 0x1p-54)};
}

/* Assumes hi in [1, 2] and |lo| <= 2^-52, with the names `hi` and `lo`. */
static void pair_in(gappa &g, const struct cor_inline_pair &pair, const char *hi, const char *lo)
{
    g.call({{hi, pair.hi}, {lo, pair.lo}});
    g.variable_in(pair.hi, {1, 2});
    g.variable_in(pair.lo, {-0x1p-52, 0x1p-52});
}

/* Gives the exact sum hi + lo of cor_inline_sum(a, b) if |a| >= |b| (Dekker's theorem: no rounding error remains). */
static void exact_sum(gappa &g, term hi, term lo)
{
    g.match_anew(lo, "(s2-(sum:(s1+s2)-s1))", {{"sum", hi}});
    g.define(hi);
    g.give(lo, "= ($s1 + $s2) - $sum", "same");
}

/* Returns the text of hi + lo - x y for cor_inline_product(x, y) with x and y from [1, 2): |hi + lo - x y| <= 2^-102.
 * All its sums except the last are exact, because the 27 lower bits of a factor are below 2^-25 - 2^-52. */
static std::string sharp_product(gappa &g, term hi, term lo)
{
    g.match_anew(lo, "l:(((((xh*yh)-h:(x1*x2))+(xh*t2))+(t1*yh))+(t1:(x1-xh:head(x1))*t2:(x2-yh:head(x2))))",
                 {{"h", hi}});
    const std::string high = std::to_string((1L << 27) - 1) + "b-52", id = std::to_string(lo);
    g.assume("$h.a - $xh in [0, " + high + "]");
    g.assume("$h.b - $yh in [0, " + high + "]");
    /* the errors in terms of the rounding error of hi */
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

static void write_product(void)
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
    g.write("pair_product", {}, "|off| in [0, 1b-102]");
}

/* Writes the goal of cor_inline_pair_times, x and y from [1, 2), |lo| <= `low`: within `bound` of the product. */
static void write_pair_times(const std::string &name, number low, number bound)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), y = pair_variable("y", 1.7);
    const struct cor_inline_pair p = cor_inline_pair_times(x, y);
    const int rest = at(p.hi, "b");
    gappa g;
    g.cut("xh", x.hi, below_2);
    g.cut("yh", y.hi, below_2);
    g.cut("xl", x.lo, within(-low, low));
    g.cut("yl", y.lo, within(-low, low));
    exact_sum(g, p.hi, p.lo);
    const std::string product = sharp_product(g, at(p.hi, "a"), at(rest, "a"));
    g.call({{"xh", x.hi}, {"yh", y.hi}, {"s", p.hi}, {"sl", p.lo}, {"rest", rest}});
    g.say("off = ($s + $sl) - ($xh + $xl) * ($yh + $yl);");
    g.say("low = $l;");
    g.hint("low -> (" + product + ") + ($xh * $yh - $h)");
    g.hint("off -> ($rest - ($l + $rest.b)) + ($rest.b - ($xh * $yl + $xl * $yh)) + " + product + " - $xl * $yl");
    g.write(name, {}, "|off|" + at_most(bound) + " /\\ |low| in [0, 1b-51]");
}

/* Writes the goal of cor_pair_over: hi is a rounded sum that is within 2^-70 of (x.hi + x.lo)/(y.hi + y.lo). */
static void write_pair_over(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), y = pair_variable("y", 1.7);
    const struct cor_inline_pair p = cor_pair_over(x, y);
    gappa g;
    pair_in(g, x, "xh", "xl");
    pair_in(g, y, "yh", "yl");
    g.define(p.hi);
    g.match(p.hi, "(q:(xh*r)+c:(rest:(((xh-hi)-low)+last)*r))");
    const std::string product = product_error(g, g["hi"], g["low"]);
    g.say("exact = ($xh + $xl) / ($yh + $yl);");
    g.say("terms = (($xh - $hi) - $rest.ab) + ($xl - $q * $yl);");
    g.say("residue = ($xh - $q * $yh) + ($xl - $q * $yl);");
    g.say("off = ($q + $c) - exact;");
    g.hint("off -> ($c - $rest * $r) + $rest * ($r - 1 / $yh) + ($rest - residue) / $yh + $yl * (exact - $q) / $yh"
           " { $yh <> 0, ($yh + $yl) <> 0 }");
    g.hint("$rest - residue -> ($rest - terms) - " + product);
    g.hint("exact - $q -> ($xh / $yh - $q) + ($xl - $yl * $xh / $yh) / ($yh + $yl) { $yh <> 0, ($yh + $yl) <> 0 }");
    g.hint("$rest -> residue + ($rest - residue)");
    g.hint("residue -> $yh * ($xh / $yh - $q) + ($xl - $q * $yl) { $yh <> 0 }");
    g.hint("$xh - $hi -> $yh * ($xh / $yh - $q) - ($hi - $q * $yh) { $yh <> 0 }");
    g.hint("$xh / $yh - $q -> $xh * (1 / $yh - $r) - ($q - $xh * $r) { $yh <> 0 }");
    g.write("pair_over", {}, "|off| in [0, 1b-70]");
}

/* Writes the final step of every tail. If a real number S is within `error` 2^-53 E of E, 1 <= E <= 2, and is rounded
 * last, |rnd(S) - E| <= ulp units of E's last place. This also holds for any number within 2^-57 of E. */
static void write_rounding(const std::string &name, number error, number ulp)
{
    gappa g;
    g.say("V = rnd(S);");
    g.assume("E in [" + std::to_string((1L << 57) - 1) + "b-57, " + std::to_string((1L << 57) + 1) + "b-56]");
    g.assume("S - E" + units(std::ldexp(error, -52)));
    /* error 2^-53 E is largest at E = 2 */
    const std::string goal = "|V - E|" + at_most(std::ldexp(ulp, -52));
    g.write(name + "_below", {"S <= 1"}, goal);
    g.write(name + "_in", {"S in [1, 2]"}, goal);
    g.write(name + "_above", {"S >= 2"}, goal);
}

/* Replaces the head of a root by any double of `interval`. */
static void give_head(gappa &g, term id, const char *of, const std::string &interval)
{
    g.call({{"r", id}});
    g.give(id, std::string("= head(") + of + ")", "same");
    g.assume("$r in " + interval);
}

/* Writes the goals for beta^(2/3), where m = beta 2^-k is in [2^i, 2^(i + 1)] for i = 0, 1, 2. The pair is within 2^-70
 * m^(2/3) of r^2 (1 + (2/3) D + (5/9) D^2), where r is the head of cbrt(m) and r^3 = m (1 - D), |D| < 2^-23. */
static void write_two_thirds(void)
{
    for (int i = 0; i < 3; i++) {
        start();
        const Real m = variable("m", std::ldexp(1.3, i));
        const struct cor_inline_pair p = cor_inline_two_thirds(m);
        const int s = p.hi.node(), square = at(s, "a");
        const int d = last_where([&](const node &n) { return n.what == DIVIDE && n.b == m.node(); }), rest = at(d, "a");
        gappa g;
        g.call({{"m", m}, {"s", s}, {"square", square}, {"d", d}, {"hi", at(rest, "ab")}});
        g.variable_in(m, {std::ldexp(1, i), std::ldexp(1, i + 1)});
        give_head(g, at(square, "a"), "C", "[0.99, 2]");
        g.define(rest);
        const std::string product = product_error(g, at(rest, "ab"), at(rest, "b"));
        g.say("$d rnd= $d.a / $m;");
        g.say("D = ($m - $r * $r * $r) / $m;");
        g.say("@d = D;");
        g.done[d] = true;
        g.assume("D in [-1b-23, 1b-23]");
        g.define(p.lo);
        const std::string off = hint_sum(g, p, "pair");
        g.say("exact = $r * $r * (1 + D * (2 / 3 + D * (5 / 9)));");
        g.say("series = $r * $r * (D * (2 / 3 + D * (5 / 9)));");
        g.say("terms = ($m - $hi) - $d.ab;");
        g.hint("$m - $hi -> D * $m - ($hi - $square * $r) - ($square - $r * $r) * $r { $m <> 0 }");
        g.hint("$d - D -> ($d - $d.a / $m) + ($d.a - terms) / $m - (" + product + " + ($square - $r * $r) * $r) / $m" +
               " { $m <> 0 }");
        g.hint("pair - exact -> " + off + " + ($s.b - series) + ($square - $r * $r)");
        g.write("two_thirds_" + std::to_string(i), {}, "|pair - exact| in [0, 1b-70]");
    }
    /* the goal for r and D, where C = root (1 + off) and root^3 = m */
    gappa g;
    const number off = COR_PROOF_CBRT_ULP * 0x1p-52;
    g.say("r = head(C);\ncut = (r - C) / C;");
    g.say("D = 1 - (1 + off) * (1 + off) * (1 + off) * (1 + cut) * (1 + cut) * (1 + cut);");
    g.hypotheses = {"C in " + within(1 - off, 2 + 2 * off), "|off| <= " + hex(off)};
    g.write("two_thirds_head", {}, "r in [0.99, 2] /\\ |D| in [0, 1b-23]");
}

/* The pair r + lo, with the names r and lo, is within `error` of r (1 + P), where P is the series of (1 + D)^(1/5). */
static void write_fifth_root_pair(gappa &g, const char *name, number error)
{
    g.say("P = D * ((0.2 - 0.08 * D) + (D * D) * (0.048 - 0.0336 * D));");
    g.say("exact = $r * (1 + P);");
    g.say("pair = $r + $lo;");
    g.hint("(pair - exact) / exact -> ($lo / $r - P) / (1 + P) { $r <> 0, (1 + P) <> 0 }");
    g.hint("$lo / $r - P -> ($lo - $r * $lo.b) / $r + ($lo.b - P) { $r <> 0 }");
    g.write(name, {}, "|(pair - exact) / exact|" + at_most(error));
}

/* x^(1/5) = r (1 + D)^(1/5), r^5 (1 + D) = x, |D| <= 4e-4, which tests/proof/seeds.c proves for every x. The goals:
 * head and tail are within 0.41 2^-53 of r (1 + D/5 - ...) up to D^4. */
static void write_fifth_root(void)
{
    start();
    const Real x = variable("x", 1.3);
    const struct cor_inline_pair root = cor_inline_fifth_root_parts(x);
    const int d = last_where([](const node &n) { return n.what == DIVIDE && n.a >= 0 && what_is(n.a) == SUBTRACT; });
    gappa g;
    g.call({{"x", x}, {"d", d}, {"fifth", at(d, "b")}, {"lo", root.lo}});
    give_head(g, root.hi, "R", "[1, 2]");
    g.give(x, "= rnd(X)");
    g.define(at(d, "b"));
    g.say("@x = $x;");
    g.say("five = $r * $r * ($r * $r) * $r;");
    g.say("D = ($x - five) / five;");
    g.say("$d.a rnd= $x - $fifth;");
    g.give(d, "rnd= $d.a / $fifth", "D");
    g.define(root.lo);
    g.assume("D in [-4e-4, 4e-4]");
    g.say("delta = ($fifth - five) / five;");
    g.hint("$x -> five * (1 + D) { five <> 0 }");
    g.hint("$x - $fifth -> five * (D - delta) { five <> 0 }");
    g.hint("($x - $fifth) / $fifth -> (D - delta) / (1 + delta) { five <> 0, $fifth <> 0, (1 + delta) <> 0 }");
    g.hint("$d - D -> ($d - $d.a / $fifth) + ($d.a - ($x - $fifth)) / $fifth - delta * (1 + D) / (1 + delta)"
           " { five <> 0, $fifth <> 0, (1 + delta) <> 0 }");
    write_fifth_root_pair(g, "fifth_root_parts", std::ldexp(0.41, -53));
}

/* Writes the goal of cor_inline_fifth_root_of_pair, for beta(eps) at zero overlap and small eps. head + tail are within
 * 2^-58 of r (1 + D/5 - ...), r^5 (1 + D) = x.hi + x.lo. The pair r5 becomes two variables within 2^-68 of r^5, by the
 * goals for pairs. */
static void write_fifth_root_of_pair(void)
{
    start();
    const struct cor_inline_pair x = pair_variable("x", 1.3), root = cor_inline_fifth_root_of_pair(x);
    const int d = last_where(
        [&](const node &n) { return n.what == DIVIDE && what_is(n.a) == ADD && at(n.a, "b") == x.lo.node(); });
    expect(d >= 0, "cor_inline_fifth_root_of_pair");
    const int r5_hi = at(d, "b"), r5_lo = at(d, "aab");
    gappa g;
    g.call({{"xh", x.hi}, {"xl", x.lo}, {"ph", r5_hi}, {"pl", r5_lo}, {"d", d}, {"lo", root.lo}});
    give_head(g, root.hi, "R", "[1, 2]");
    for (const int id : {x.hi.node(), x.lo.node(), r5_hi, r5_lo})
        g.give(id, "= rnd(V" + std::to_string(id) + ")");
    g.say("$d.aaa rnd= $d.aaaa - $d.aaab;");
    g.say("$d.aa rnd= $d.aaa - $d.aab;");
    g.say("$d.a rnd= $d.aa + $d.ab;");
    g.say("$d rnd= $d.a / $d.b;");
    g.say("five = $r * $r * $r * $r * $r;");
    g.say("D = (($xh + $xl) - five) / five;");
    g.say("T = (($xh - $ph) - $pl) + $xl;");
    g.say("eta = (($ph + $pl) - five) / five;");
    g.say("lambda = $pl / five;");
    g.say("@d = D;");
    g.done[d] = true;
    g.define(root.lo);
    for (const char *known : {"D in [-4e-4, 4e-4]", "eta in [-1b-68, 1b-68]", "lambda in [-1b-52, 1b-52]"})
        g.assume(known);
    g.assume("|$xl| <= 1b-46");
    const std::string nonzero = " { five <> 0, $ph <> 0, (1 + eta - lambda) <> 0 }";
    g.hint("$ph -> five * (1 + eta - lambda) { five <> 0 }");
    g.hint("five -> $ph / (1 + eta - lambda)" + nonzero);
    g.hint("$xh -> five * (1 + D) - $xl { five <> 0 }");
    g.hint("$xh - $ph -> five * (D - eta + lambda) - $xl { five <> 0 }");
    g.hint("T -> five * (D - eta) { five <> 0 }");
    g.hint("$d - D -> ($d - $d.a / $ph) + ($d.a - T) / $ph + (D * (lambda - eta) - eta) / (1 + eta - lambda)" +
           nonzero);
    write_fifth_root_pair(g, "fifth_root_of_pair", 0x1p-58);
}

/* cor_inline_beta_force_far: the sum that is rounded last is within 2^-55 of R^3 (1 + e (r_1 + e r_2)). R = r + rest is
 * the fifth root of the goal above. e has a relative error below 2^-52, and v = -0.6 ln(e) has an error below 2^-43. */
static void write_beta_force_far(void)
{
    start();
    const Real eps = variable("x", 0x1p-30);
    gappa g;
    g.match(cor_inline_beta_force_far(eps),
            "(value:(cube:(square*head_of_root)+added:(lo:(off_cube+off_root)+(whole*orders)))*1)");
    const struct cor_inline_pair root =
        cor_inline_fifth_root_of_pair(cor_inline_over_eps(cor_rows_far_beta_zero_force(0), eps, 0));
    const int log = last_where([](const node &n) { return n.what == LOG; });
    const int v = last_where([&](const node &n) { return n.what == MULTIPLY && (n.a == log || n.b == log); });
    expect(root.hi.node() == g["head_of_root"] && v >= 0, "cor_inline_beta_force_far");
    give_head(g, root.hi, "R", "[1, 2]");
    for (const int id : {root.lo.node(), at(log, "a"), v})
        g.give(id, "= rnd(V" + std::to_string(id) + ")", "E" + std::to_string(id));
    g.define(g["cube"]);
    g.define(g["value"]);
    g.call({{"rl", root.lo}, {"e", at(log, "a")}, {"v", v}});
    const std::string product = product_error(g, g["cube"], g["off_cube"]);
    for (const char *known : {"$rl in [-1b-12, 1b-12]", "$rl - @rl in [-1b-57, 1b-57]", "@e in [0, 9.2e-8]",
                              "$e - @e in [-1b-75, 1b-75]", "@v in [9, 210]", "$v - @v in [-1b-43, 1b-43]"})
        g.assume(known);
    g.say("cubic = @rl * (3 * $r * $r + @rl * (3 * $r + @rl));");
    g.say("exact = ($r + @rl) * ($r + @rl) * ($r + @rl) * (1 + @orders);");
    g.say("tail = $lo - $lo.a;");
    g.say("whole = $r * $r * $r + cubic;");
    g.say("S = $cube + $added;");
    g.say("part = $added.b;");
    g.hint("S - exact -> ($added - ($lo + part)) + " + product + " + ($square - $r * $r) * $r + (tail - cubic) + " +
           "(part - whole * @orders)");
    g.hint("part - whole * @orders -> (part - $added.ba * $orders) + ($added.ba - whole) * $orders + " +
           std::string("whole * ($orders - @orders)"));
    g.hint("$added.ba - whole -> ($added.ba - ($cube + $lo)) + " + product +
           " + ($square - $r * $r) * $r + (tail - cubic)");
    g.hint("tail - cubic -> ($lo - ($lo.a + $lo.b)) + ($lo.b - cubic)");
    g.hint("|(S - exact) / exact| $ $r in 8");
    g.write("beta_force_far", {}, "|(S - exact) / exact| in [0, 1b-55]");
    /* the hypothesis about v: an ulp of log(e) is at most 2^-44 */
    gappa h;
    h.say("E = rnd(l);\nV rnd= " + hex(-0.6) + " * E;\nexact = -0.6 * LN;");
    h.hypotheses = {"LN in [-350, -16]", "|E - LN| <= " + hex(COR_PROOF_LOG_ULP * 0x1p-44 + 0x1p-51)};
    h.write("beta_force_log", {}, "|V - exact| in [0, 1b-43]");
}

/* s, the sum that is rounded last, is within 2^-70 of x (f.hi + f.lo). */
static void write_by_pair(const std::string &name, term s, const Real &x, const struct cor_inline_pair &f)
{
    gappa g;
    g.call({{"x", x}, {"s", s}});
    g.variable_in(x, {1, 2});
    pair_in(g, f, "fh", "fl");
    g.define(s);
    g.match(s, "(product+rest:(off+(x*fl)))");
    const std::string product = product_error(g, g["product"], g["off"]);
    g.say("off = ($s.a + $s.b) - $x * ($fh + $fl);");
    g.hint("off -> " + product + " + ($s.b - ($s.ba + $x * $fl))");
    g.write(name, {}, "|off| in [0, 1b-70]");
}

static void write_linear_tail(void)
{
    start();
    const Real b = variable("b", 1.3);
    const struct cor_inline_pair factor = pair_variable("F", 1.7);
    write_by_pair("linear_tail", cor_inline_linear_tail(b, factor), b, factor);
}

/* Writes the goals for eps = h*^5/x, computed with only the first half of h*^5, for 1 <= x <= 2. */
static void write_far_root(void)
{
    start();
    const Real x = variable("x", 1.25);
    const int value = cor_inline_eps_overlap_far_root(x).node();
    const std::string h = hex(cor_rows_h_star_5(0)[0].value), less = hex(cor_rows_h_star_5(0)[1].value);
    for (int side = 0; side < 2; side++) {
        gappa g;
        g.call({{"x", x}, {"value", value}});
        g.variable_in(x, {1, 2});
        g.define(value);
        g.say("S = $value.a / $x;");
        g.say("exact = (" + h + " + " + less + ") / $x;");
        g.hint("S - exact -> -(" + less + ") / $x");
        const int k = side + 1; /* the exact value is in [2^k, 2^(k + 1)] */
        for (const char *where : {"S <= 4", "S >= 4"})
            g.write("far_root_" + std::to_string(k) + (where[2] == '<' ? "_below" : "_above"),
                    {"exact in [" + power_of_two(k) + ", " + power_of_two(k + 1) + "]", where},
                    "|$value - exact|" + at_most(std::ldexp(0.9, k - 52)));
    }
}

/* Writes the goals for the last operations of functions beyond their tables. error: as in struct tail */
static void write_last_steps(void)
{
    const number pairs = 0x1p-12; /* 2^-65, the error of powers and quotients of pairs, in units of 2^-53 */
    for (const tail &f : tails)
        write_rounding("last_" + f.name, std::max(f.error, f.far_error) + pairs,
                       0.5 + std::max(f.error, f.far_error) + 2 * pairs);
    write_rounding("last_eps_zero_overlap", pairs, 0.5 + 2 * pairs);
    write_rounding("last_beta_zero_overlap", 0x1p-4, 0.57);
    write_rounding("last_beta_zero_force", 0.3, 0.81);
    write_rounding("last_fifth_root", 0.41 + pairs, 0.92);
    /* 1 - eps for eps <= 2^-8 */
    gappa g;
    g.say("eps = rnd(e);\nV = rnd(1 - eps);");
    g.hypotheses = {"eps in [0, 1b-8]", "eps - E in [-1b-60, 1b-60]"};
    g.write("last_loss", {}, "|V - (1 - E)|" + at_most(std::ldexp(0.51, -53)));
    /* a number within 0.8 ulp of E, rounded to a subnormal number, is within 0.91 units of 2^-1074 */
    gappa s;
    s.text += "@subnormal = fixed<-1074, ne>;\nV = subnormal(S);\n";
    s.hypotheses = {"S in [0, 1b-1022]", "S - E in [-0x1.ap-1076, 0x1.ap-1076]"};
    s.write("last_subnormal", {}, "|V - E| in [0, 0x1.dp-1075]");
}

static void write_pairs(void)
{
    write_product();
    write_pair_times("pair_times", 0x1p-52, 0x1p-72);
    write_pair_times("disk_pair_times", 0x1p-53, COR_PROOF_PAIR_TIMES);
    write_pair_over();
    write_two_thirds();
    write_fifth_root();
    write_fifth_root_of_pair();
    write_beta_force_far();
    write_linear_tail();
    write_far_root();
    write_last_steps();
}

#include "disk.h"

#define ROWS(name, NAME, value, ...)                                                                                   \
    {                                                                                                                  \
#name, cor_inline_##value, __VA_ARGS__, GRID(name, NAME)                                                       \
    }
#define ROWS_BY_OCTAVES(name, NAME, value, ...)                                                                        \
    {                                                                                                                  \
#name, cor_inline_##value, __VA_ARGS__, BY_OCTAVES, false, 0.8, OCTAVES(name, NAME)                            \
    }
static const evaluator row_tables[] = {
    ROWS(eps_zero_overlap, EPS_ZERO_OVERLAP, eps_zero_overlap, 0x1p-60, 7, IN_BETA, false, 0.8),
    ROWS(eps_zero_force, EPS_ZERO_FORCE, eps_zero_force, 0x1p-60, 16, IN_ROOT, false, 0.8),
    ROWS_BY_OCTAVES(power_eps_zero_overlap, POWER_EPS_ZERO_OVERLAP, eps_zero_overlap_root, 0x1p-40, 0x1p14),
    ROWS_BY_OCTAVES(power_eps_zero_force, POWER_EPS_ZERO_FORCE, eps_zero_force_root, 0x1p-40, 0x1p20),
    ROWS(loss_zero_overlap, LOSS_ZERO_OVERLAP, loss_zero_overlap, 0x1p-900, 7, IN_BETA, true, 0.8),
    ROWS(loss_zero_force, LOSS_ZERO_FORCE, loss_zero_force, 0x1p-900, 16, IN_ROOT, true, 0.8),
    ROWS(duration_zero_overlap, DURATION_ZERO_OVERLAP, duration_zero_overlap, 0, 8, IN_BETA, false, 0.8),
    ROWS(duration_zero_force, DURATION_ZERO_FORCE, duration_zero_force, 0, 8, IN_ROOT, false, 1.1),
    ROWS(max_overlap, MAX_OVERLAP, max_overlap, 0, 8, IN_BETA, false, 0.8),
    ROWS(time_of_max_overlap, TIME_OF_MAX_OVERLAP, time_of_max_overlap, 0, 8, IN_BETA, false, 0.8),
    ROWS(near_beta_zero_overlap, NEAR_BETA_ZERO_OVERLAP, beta_zero_overlap, 0.5, 1, NEAR, true, 0.8),
    ROWS(near_beta_zero_force, NEAR_BETA_ZERO_FORCE, beta_zero_force, 0.5, 1, NEAR_ROOT, true, 1.85),
    ROWS_BY_OCTAVES(beta_zero_overlap, BETA_ZERO_OVERLAP, beta_zero_overlap, 0x1p-12, 0.5),
    ROWS_BY_OCTAVES(beta_zero_force, BETA_ZERO_FORCE, beta_zero_force, 0x1p-23, 0.5),
};

#include "speed.h"

int main(int argc, char **argv)
{
    if (argc != 3 && argc < 5) {
        fprintf(stderr, "usage: goals OUTPUT-DIRECTORY TABLES.h [PART PARTS [PATTERN...]]\n");
        return 2;
    }
    output_directory = argv[1];
    if (argc >= 5) {
        parts = strtoul(argv[4], nullptr, 10);
        if (parts < 1)
            die("PARTS is a number above 0");
        part = strtoul(argv[3], nullptr, 10) % parts;
        patterns.assign(argv + 5, argv + argc);
    }
    for (const evaluator &f : row_tables) {
        const std::vector<interval> pieces = pieces_of(f.value, f.first, f.end);
        for (std::size_t i = 0; i < pieces.size(); i++)
            write_row_piece(f, pieces[i], (int)i);
    }
    write_log();
    write_tails();
    write_pairs();
    write_disk();
    check_speed(argv[2]);
    printf("%lu of %lu goals written\n", written, files);
    return 0;
}
