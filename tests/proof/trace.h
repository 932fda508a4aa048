/* SPDX-License-Identifier: MIT */
/* Numbers that record their computation. tests/proof/goals.cpp compiles the evaluator's own source with Real in place
 * of double and Bits in place of uint64_t. A run at one argument gives the result and the list of its operations. So
 * the proofs are about the shipped source, and nothing is typed twice.
 *
 * A decision (a comparison, a conversion to an integer, bits that select) depends on the argument but is not part of
 * the list. `path` records decisions and constants, which distinguish two lists of operations. */
#ifndef COR_TESTS_PROOF_TRACE_H
#define COR_TESTS_PROOF_TRACE_H

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace trace
{

typedef double number;
typedef std::uint64_t word;

enum operation {
    CONSTANT,
    VARIABLE,
    ADD,
    SUBTRACT,
    MULTIPLY,
    DIVIDE,
    NEGATE,
    ABSOLUTE,
    SQRT,
    CBRT,
    LOG,
    LOG1P,
    EXP,
    EXPM1,
    HEAD,
    SIGNIFICAND,
    SEED
};

struct node {
    operation what;
    int a, b;
    number value;
    std::string name; /* of a variable */
};

static std::vector<node> nodes;
static word path;
static bool recording = true; /* false: records only decisions, because the search for pieces needs no operations */

inline const node &of(int id)
{
    return nodes[(std::size_t)id];
}

inline void decide(word decision)
{
    path = (path ^ decision) * UINT64_C(0x9e3779b97f4a7c15);
    path ^= path >> 29;
}

inline void start()
{
    nodes.clear();
    path = 1;
}

inline word bits_of(number x)
{
    word bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

inline number number_of(word bits)
{
    number x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

/* Returns the index of a node. Operations on the same operands share one node. */
inline int node_of(operation what, int a, int b, number value, const std::string &name = "")
{
    for (int i = (int)nodes.size(); i-- > 0;) {
        const node &n = of(i);
        if (n.what == what && n.a == a && n.b == b && bits_of(n.value) == bits_of(value) && n.name == name)
            return i;
    }
    nodes.push_back({what, a, b, value, name});
    return (int)nodes.size() - 1;
}

struct Real {
    number value;
    int id; /* -1: a constant without a node; an operation that uses it makes one */

    Real() = default;
    constexpr Real(number x) : value(x), id(-1)
    {
    }
    constexpr Real(int x) : value(x), id(-1)
    {
    }
    constexpr Real(number x, int node) : value(x), id(node)
    {
    }
    explicit operator int() const
    {
        decide((word)(long)value);
        return (int)value;
    }
    explicit operator float() const
    {
        return (float)value;
    }
    int node() const
    {
        return id >= 0 ? id : node_of(CONSTANT, -1, -1, value);
    }
    bool constant() const
    {
        return id < 0 || of(id).what == CONSTANT;
    }
};

/* A node, by its index or by the number that it computes */
struct term {
    int id;
    term(int index) : id(index)
    {
    }
    term(Real x) : id(x.node())
    {
    }
    operator int() const
    {
        return id;
    }
};

inline Real variable(const std::string &name, number value)
{
    return Real(value, node_of(VARIABLE, -1, -1, value, name));
}

/* Returns the result of an operation with one operand or two. */
inline Real result_of(operation what, Real x, number value, const Real *y = nullptr)
{
    if (x.constant() && (!y || y->constant())) /* a compiler may compute it, with or without rounding */
        return Real(value);
    return recording ? Real(value, node_of(what, x.node(), y ? y->node() : -1, value)) : Real(value, 0);
}

#define REAL_OPERATOR(sign, what)                                                                                      \
    inline Real operator sign(Real x, Real y)                                                                          \
    {                                                                                                                  \
        return result_of(what, x, x.value sign y.value, &y);                                                           \
    }
REAL_OPERATOR(+, ADD)
REAL_OPERATOR(-, SUBTRACT)
REAL_OPERATOR(*, MULTIPLY)
REAL_OPERATOR(/, DIVIDE)
inline Real operator-(Real x)
{
    return result_of(NEGATE, x, -x.value);
}
inline Real &operator*=(Real &x, Real y)
{
    return x = x * y;
}
inline Real &operator+=(Real &x, Real y)
{
    return x = x + y;
}
inline bool decision(bool yes)
{
    decide(yes ? 3 : 2);
    return yes;
}
#define COMPARISON(type, sign)                                                                                         \
    inline bool operator sign(type x, type y)                                                                          \
    {                                                                                                                  \
        return decision(x.value sign y.value);                                                                         \
    }
#define COMPARISONS(type)                                                                                              \
    COMPARISON(type, <)                                                                                                \
    COMPARISON(type, >) COMPARISON(type, <=) COMPARISON(type, >=) COMPARISON(type, ==) COMPARISON(type, !=)
COMPARISONS(Real)
#define REAL_FUNCTION(function, what)                                                                                  \
    inline Real function(Real x)                                                                                       \
    {                                                                                                                  \
        return result_of(what, x, std::function(x.value));                                                             \
    }
REAL_FUNCTION(sqrt, SQRT)
REAL_FUNCTION(cbrt, CBRT)
REAL_FUNCTION(log, LOG)
REAL_FUNCTION(log1p, LOG1P)
REAL_FUNCTION(exp, EXP)
REAL_FUNCTION(expm1, EXPM1)
REAL_FUNCTION(fabs, ABSOLUTE)

/* ---- the bits of a Real, by their meaning ---- */

struct Bits {
    enum meaning { NOTHING, ALL, TOP_26, FRACTION, ONE_TO_TWO, OTHER };
    word value;
    meaning what;
    Real of;

    Bits() = default;
    constexpr Bits(word x) : value(x), what(NOTHING), of(0)
    {
    }
    constexpr Bits(int x) : value((word)(long)x), what(NOTHING), of(0)
    {
    }
    Bits(word x, meaning m, Real r) : value(x), what(m), of(r)
    {
    }
    /* The bits of a subnormal number, read as an integer, are the number in units of 2^-1074. */
    explicit operator Real() const
    {
        return what == NOTHING ? Real((number)value) : of * Real(0x1p574) * Real(0x1p500);
    }
    explicit operator int() const
    {
        decide(value);
        return (int)value;
    }
};

/* Returns the result of an operation. It is constant if both operands are, otherwise its bits have no named meaning. */
inline Bits mixed(word value, Bits x, Bits y)
{
    const Bits &one = x.what == Bits::NOTHING ? y : x;
    return one.what == Bits::NOTHING ? Bits(value) : Bits(value, Bits::OTHER, one.of);
}
#define BITS_OPERATOR(sign)                                                                                            \
    inline Bits operator sign(Bits x, Bits y)                                                                          \
    {                                                                                                                  \
        return mixed(x.value sign y.value, x, y);                                                                      \
    }
BITS_OPERATOR(+)
BITS_OPERATOR(-)
BITS_OPERATOR(*)
BITS_OPERATOR(<<)
BITS_OPERATOR(>>)

inline Bits operator&(Bits x, Bits y)
{
    static const std::map<word, Bits::meaning> masks = {{UINT64_C(0xfffffffff8000000), Bits::TOP_26},
                                                        {UINT64_C(0xfffffffffffff), Bits::FRACTION},
                                                        {~UINT64_C(0x8000000000000000), Bits::OTHER}};
    const word value = x.value & y.value;
    if (y.what != Bits::NOTHING)
        return y & x;
    if (x.what == Bits::NOTHING || y.value == 0)
        return Bits(value);
    if (y.value == ~(word)0)
        return x;
    if (x.what == Bits::ALL && masks.count(y.value))
        return Bits(value, masks.at(y.value), x.of);
    decide(value); /* bits that select the cell of an octave */
    return Bits(value);
}

inline Bits operator|(Bits x, Bits y)
{
    if (y.what != Bits::NOTHING && x.what == Bits::NOTHING)
        return y | x;
    if (x.what != Bits::NOTHING && y.what == Bits::NOTHING && y.value == 0)
        return x;
    if (x.what == Bits::FRACTION && y.value == UINT64_C(0x3ff0000000000000))
        return Bits(x.value | y.value, Bits::ONE_TO_TWO, x.of);
    return mixed(x.value | y.value, x, y);
}

inline Bits operator~(Bits x)
{
    return Bits(~x.value);
}
COMPARISONS(Bits)

inline void copy(Bits *to, const Real *from)
{
    *to = from->constant() ? Bits(bits_of(from->value)) : Bits(bits_of(from->value), Bits::ALL, *from);
}

inline void copy(Real *to, const Bits *from)
{
    static const std::map<Bits::meaning, operation> what = {
        {Bits::TOP_26, HEAD}, {Bits::ONE_TO_TWO, SIGNIFICAND}, {Bits::FRACTION, SEED}, {Bits::OTHER, SEED}};
    const number value = number_of(from->value);
    *to = from->what == Bits::NOTHING ? Real(value)
          : from->what == Bits::ALL   ? from->of
                                      : result_of(what.at(from->what), from->of, value);
}

} // namespace trace

#endif
