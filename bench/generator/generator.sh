# SPDX-License-Identifier: MIT
# The cost of corgen as the order, the digits and beta grow: bench/run sources this, with one_core, quick, report and results
# set, and calls generator_costs and disk_generator_costs.

# measure LABEL CSV COMMAND...: seconds, peak megabytes and the two dearest steps of a corgen command, by its
# own --profile; the last is the step that dominates.
measure() {
    local label=$1 csv=$2
    shift 2
    "${one_core[@]}" "$@" --profile 2>&1 >/dev/null | awk -v label="$label" -v csv="$csv" '
        $1 == "profile:" && $3 == "s" {
            name = $4
            for (i = 5; i <= NF; i++) name = name " " $i
            if (name == "total") total = $2
            else if ($2 > most) { most = $2; step = name }
        }
        $1 == "profile:" && $3 == "MB" { memory = $2 }
        END {
            share = total > 0 ? 100 * most / total : 0
            printf "%-42s %9.3f s %8.1f MB   %s (%.0f %%)\n", label, total, memory, step, share
            printf "%s,%s,%s,%s,%.1f\n", label, total, memory, step, share >>csv
        }'
}

# The same on all cores
on_all_cores() {
    local one_core=()
    measure "$@"
}

# exponents CSV PATTERN: least-squares slopes of log seconds and log megabytes against log order, over the rows
# whose label ends in "order N" with N >= 25.
exponents() {
    awk -F, -v pattern="$2" '
        $1 ~ pattern {
            split($1, word, " ")
            n = word[length(word)]
            if (n < 25) next
            x = log(n); y = log($2); z = log($3)
            k++; sx += x; sy += y; sz += z; sxx += x * x; sxy += x * y; sxz += x * z
        }
        END {
            d = k * sxx - sx * sx
            if (k > 1)
                printf "%-42s time ~ order^%.1f, memory ~ order^%.1f (%d orders)\n", "growth, " pattern,
                    (k * sxy - sx * sy) / d, (k * sxz - sx * sz) / d, k
        }' "$1"
}

generator_costs() {
    local csv=$results/generator.csv order d beta
    local orders=(12 25 40 60) digits=(16 50 100)
    echo "command,seconds,peak_mb,dominating_step,percent" >"$csv"
    say "corgen (targets: series 60/40 2 s and 200 MB, 200/100 120 s and 2000 MB, trajectory 20/40 5 s)"
    measure "trajectory 40 terms order 20" "$csv" build/corgen trajectory --order 20 --terms 40
    [ "$quick" ] || orders+=(100 140)
    for order in "${orders[@]}"; do
        measure "series 40 digits order $order" "$csv" build/corgen series --order "$order" --digits 40
    done
    exponents "$csv" "series 40 digits"
    [ "$quick" ] || measure "series 100 digits order 200" "$csv" build/corgen series --order 200 --digits 100
    if [ "$report" ]; then
        local more=(20 80)
        [ "$quick" ] || more+=(160 320)
        for d in "${more[@]}"; do
            measure "series order 40 digits $d" "$csv" build/corgen series --order 40 --digits "$d"
        done
    fi
    for order in 10 20 40 80; do
        measure "trajectory 20 terms order $order" "$csv" build/corgen trajectory --order "$order" --terms 20
    done
    exponents "$csv" "trajectory 20 terms"
    [ "$quick" ] || digits+=(300 1000)
    for d in "${digits[@]}"; do
        measure "collide beta 1 digits $d" "$csv" build/corgen collide --beta 1 --digits "$d"
    done
    for beta in 0.1 5 100 1e6; do
        measure "collide 30 digits beta $beta" "$csv" build/corgen collide --beta "$beta" --digits 30
    done
}

disk_generator_costs() {
    local csv=$results/disk_generator.csv
    echo "command,seconds,peak_mb,dominating_step,percent" >"$csv"
    say "corgen disk-modes"
    measure "1800 modes 30 digits one core" "$csv" build/corgen disk-modes --poisson 0.33 --count 1800 --digits 30
    on_all_cores "1800 modes 30 digits $jobs cores" "$csv" \
        build/corgen disk-modes --poisson 0.33 --count 1800 --digits 30
    if [ "$report" ]; then
        local d
        for d in 10 100 300; do
            measure "1800 modes $d digits one core" "$csv" build/corgen disk-modes --poisson 0.33 --count 1800 --digits "$d"
        done
    fi
    [ "$quick" ] && return
    measure "20000 modes 20 digits one core" "$csv" build/corgen disk-modes --poisson 0.33 --count 20000 --digits 20
    on_all_cores "20000 modes 20 digits $jobs cores" "$csv" \
        build/corgen disk-modes --poisson 0.33 --count 20000 --digits 20
}
