# SPDX-License-Identifier: MIT
# The tables of docs/speed: bench/run sources this, with quick and results set, and calls report_tables DIR. Every table
# is a selection of what the benchmarks wrote, one row a point of a plot. report_words DIR writes what they say.

machine_table() {
    local processor flags
    processor=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1 || true)
    flags=$(sed -n 's/^CMAKE_C_FLAGS_RELEASE:[A-Z]*=//p' build/CMakeCache.txt)
    echo 'what,value'
    echo "processor,${processor:-$(uname -m)}" | tr -s ' '
    echo "cores used,one"
    sed -n 's/^set(CMAKE_C_COMPILER_\(ID\|VERSION\) "\(.*\)")$/\2/p' build/CMakeFiles/*/CMakeCCompiler.cmake |
        head -n 2 |
        paste -s -d ' ' | sed 's/^/compiler,/'
    echo "flags,$flags; loops and arrays -O3 and for the instructions that the tables name"
    if [ "$quick" ]; then
        echo "turns,few: a quick run"
    else
        echo "turns,64 of calls and arrays; 12 of collisions of disks"
    fi
}

# sphere_table INPUT
sphere_table() {
    echo 'scene,curve,setting,instructions,end,form,ns,ns_dependent,max_relative_error'
    awk -F, -v OFS=, -v input="$1" '
        $1 == "shipped" && $7 == input && $2 != "two decades" && $6 != "" && $3 !~ /as shipped$/ || $3 ~ /float array/ && $7 == input {
            curve = $5
            setting = $16 != "" ? $16 : $10
            instructions = $3 ~ /AVX-512/ ? "AVX-512" : $3 ~ /AVX2/ ? "AVX2" : $8 == "array" && $3 !~ /float/ ? "portable" : ""
            if ($3 ~ /float array/) instructions = "as shipped"
            if (curve == "published" || $3 ~ /^pow/) {
                curve = "published"
                setting = $3 ~ /Mueller/ ? "Müller & Pöschel [1/4]" : $3 ~ /27/ ? "simple theory (27)" : "[1/4] of Table I"
            } else if (curve == "")
                curve = $3 ~ /^cor float/ ? "cor float" : $3 ~ /^cor_sphere/ ? "cor_sphere.h" : "cor"
            print $2, curve, setting, instructions, $6, $8, $11, $12, $15
        }' "$results/speed.csv" | LC_ALL=C sort -s -t, -k1,2 -k4,6
}

rayleigh_table() {
    echo 'quantity,method,setting,modes,seconds,max_relative_error'
    awk -F, -v OFS=, '$1 == "energy" || $1 == "modes" { print $1, $2, $4, $5, $6, $7 }' "$results/disk.csv"
}

collision_table() {
    echo 'question,built,method,speed,setting,modes,seconds,error'
    awk -F, -v OFS=, '
        $1 == "collision models" { print "model", "library", $2, $3, $4, $5, $6, $7; next }
        $1 ~ /^collision( native| cor.s)?$/ && $7 != "" {
            built = $1 ~ /native/ ? "for the machine" : $1 ~ /cor/ ? "with cor loops" : "library"
            print "method", built, $2, $3, $4, $5, $6, $7
        }' "$results/disk.csv"
}

# "series 40 digits order 100" varies the order; "collide beta 1 digits 300" the digits.
generator_table() {
    echo 'command,fixed,varied,value,seconds,peak_mb,dominating_step,percent'
    awk -F, -v OFS=, '
        FNR == 1 { next }
        $1 ~ /^[0-9]+ modes/ {
            split($1, w, " ")
            if ($1 ~ /one core/) print "disk-modes", w[1] " modes", "digits", w[3], $2, $3, $4, $5
            next
        }
        {
            n = split($1, w, " ")
            fixed = w[2]
            for (i = 3; i <= n - 2; i++) fixed = fixed " " w[i]
            print w[1], fixed, w[n - 1], w[n], $2, $3, $4, $5
        }' "$results/generator.csv" "$results/disk_generator.csv"
}

report_tables() {
    mkdir -p "$1"
    machine_table >"$1/machine.csv"
    sphere_table speed >"$1/spheres_speed.csv"
    sphere_table beta >"$1/spheres_beta.csv"
    rayleigh_table >"$1/rayleigh.csv"
    collision_table >"$1/collision.csv"
    generator_table >"$1/generator.csv"
}

# Lines of at most 120 bytes, but for rows of tables; lines of a list item are indented.
wrapped() {
    LC_ALL=C awk '/^\|/ || length($0) <= 120 { print; next }
        {
            indent = /^(- |  )/ ? "  " : ""
            line = /^  / ? " " : ""
            for (i = 1; i <= NF; i++) {
                if (i > 1 && length(line) + length($i) >= 120) { print line; line = indent $i }
                else line = line (i > 1 || line != "" ? " " : "") $i
            }
            print line
        }'
}

report_words() {
    awk -f bench/report_words.awk "$1"/{machine,spheres_speed,spheres_beta,rayleigh,collision,generator}.csv | wrapped
}

# readme_words DIR: README.md with the table of DIR between its two marks
readme_words() {
    awk -v page=readme -f bench/report_words.awk "$1/spheres_speed.csv" |
        sed -e '/^<!-- written by bench\/run --report/r /dev/stdin' -e '/^<!-- written by bench\/run --report/,/^<!-- end -->/{/^<!--/!d}' README.md
}
