# SPDX-License-Identifier: MIT
# The cost of corgen for growing order, digits and beta. bench/run sources this, with one_core, quick and results set,
# and calls generator.

# measure FIXED VARIED VALUE SUBCOMMAND OPTION...: prints a row with seconds, peak megabytes and the most expensive
# step of a corgen command, by its own --profile.
measure() {
    local label="$4,$1,$2,$3"
    shift 3
    "${one_core[@]}" build/corgen "$@" --profile 2>&1 >/dev/null | awk -v label="$label" '
        $1 == "profile:" && $3 == "s" {
            name = $4
            for (i = 5; i <= NF; i++) name = name " " $i
            if (name == "total") total = $2
            else if ($2 > most) { most = $2; step = name }
        }
        $1 == "profile:" && $3 == "MB" { memory = $2 }
        END { printf "%s,%s,%s,%s,%.1f\n", label, total, memory, step, (total > 0 ? 100 * most / total : 0) }' |
        tee -a "$results/generator.csv"
}

generator() {
    local orders=(12 25 40 60) series_digits=(20 80) digits=(16 50 100) value
    echo "command,fixed,varied,value,seconds,peak_mb,dominating_step,percent" >"$results/generator.csv"
    say "corgen"
    [ "$quick" ] || orders+=(100 140) series_digits+=(160 320) digits+=(300 1000)
    measure "40 terms" order 20 trajectory --order 20 --terms 40
    for value in "${orders[@]}"; do
        measure "40 digits" order "$value" series --order "$value" --digits 40
    done
    [ "$quick" ] || measure "100 digits" order 200 series --order 200 --digits 100
    for value in "${series_digits[@]}"; do
        measure "order 40" digits "$value" series --order 40 --digits "$value"
    done
    for value in 10 20 40 80; do
        measure "20 terms" order "$value" trajectory --order "$value" --terms 20
    done
    for value in "${digits[@]}"; do
        measure "beta 1" digits "$value" collide --beta 1 --digits "$value"
    done
    for value in 0.1 5 100 1e6; do
        measure "30 digits" beta "$value" collide --beta "$value" --digits 30
    done
    for value in 10 30 100 300; do
        measure "1800 modes" digits "$value" disk-modes --poisson 0.33 --count 1800 --digits "$value"
    done
    [ "$quick" ] || measure "20000 modes" digits 20 disk-modes --poisson 0.33 --count 20000 --digits 20
}
