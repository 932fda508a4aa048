#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a header with the truncated series, Padés and two-point Padés of growing order that the report compares. Each
# is a function of z, with z = beta at zero overlap and sqrt(beta) at zero force. Also prints their list.
#     bench/spheres/approximants.sh CORGEN >HEADER
# Omits Padés with a pole on beta > 0.
set -eu
corgen=$1

# approximant KIND CURVE END NUMERATOR DENOMINATOR [OPTION...]
approximant() {
    kind=$1 curve=$2 end=$3 numerator=$4 denominator=$5
    shift 5
    "$corgen" pade --numerator "$numerator" --denominator "$denominator" --end "zero-$end" --digits 20 --format csv "$@" |
        awk -F, -v name="${kind}_${end}_${numerator}_$denominator" '
            NR > 1 { c[$1, $2] = $3; if ($2 > degree[$1]) degree[$1] = $2 }
            function horner(p,    text, i) {
                text = c[p, degree[p] + 0]
                for (i = degree[p] - 1; i >= 0; i--) text = c[p, i] " + z * (" text ")"
                return text
            }
            END {
                quotient = degree["denominator"] > 0
                printf "static inline double %s(double z)\n{\n    return %s%s;\n}\n\n", name,
                    (quotient ? "(" : "") horner("numerator") (quotient ? ")" : ""),
                    quotient ? " / (" horner("denominator") ")" : ""
            }'
    [ "$denominator" = 0 ] && setting="order $numerator" || setting="[$numerator/$denominator]"
    rows="$rows \\
    X_$end(${kind}_${end}_${numerator}_$denominator, \"$curve\", \"$setting\")"
}

rows=
printf '/* Written by bench/spheres/approximants.sh from corgen pade. */\n\n'
for order in 2 4 8 16 32; do
    approximant series series overlap $order 0
    approximant series series force $order 0
done
for degrees in '1 2' '1 4' '2 5' '3 6' '5 8' '8 12' '12 20' '16 24'; do
    approximant pade 'Padé' overlap $degrees
done
for degrees in '1 4' '2 5' '3 6' '5 8' '6 10' '8 12' '12 16' '16 24'; do
    approximant pade 'Padé' force $degrees
done
for numerator in 1 2 3 4 6 8 10 12 16; do
    approximant two_point 'two-point Padé' overlap $numerator $((numerator + 5)) --two-point
done
printf '/* X_overlap or X_force(function, curve, setting) for each */\n#define APPROXIMANTS%s\n' "$rows"
