# SPDX-License-Identifier: MIT
# Prints a page with its tables renewed from the csv files of docs/speed. A table is between
# <!-- NAME of docs/speed, by bench/run --> and <!-- end -->.
#     awk -f bench/tables.awk docs/speed/*.csv docs/speed/README.md

BEGIN { FS = "," }
FNR == 1 { file = FILENAME; sub(/.*\//, "", file); csv = sub(/\.csv$/, "", file) }
csv && FNR > 1 { n = ++rows[file]; for (i = 1; i <= NF; i++) cell[file, n, i] = $i }
csv { next }
/^<!-- end -->$/ { inside = 0 }
!inside
/^<!-- .* of docs\/speed, by bench\/run -->$/ {
    inside = 1
    split($0, argument, " ")
    write(argument[2])
}

function write(name) {
    if (name == "machine") machine()
    else if (name == "summary") summary()
    else if (name == "short") readme()
    else if (name == "large") large()
    else if (name == "energy") energy()
    else if (name == "collision") collision()
    else if (name == "models") models()
    else if (name == "rigid") rigid()
    else { print "bench/tables.awk: no table " name > "/dev/stderr"; exit 1 }
}

# ---- cells ----

function short(x) { return x == "" ? "" : sprintf("%.2g", x) }
function plain(x) { return x == "" ? "" : x < 10 ? sprintf("%.1f", x) : x < 1000 ? sprintf("%.0f", x) : sprintf("%.0f00", x / 100) }
function time(s) {
    return s < 1e-6 ? sprintf("%.0f ns", s * 1e9) : s < 1e-3 ? sprintf("%.3g us", s * 1e6) : s < 1 ? sprintf("%.3g ms", s * 1e3) \
        : sprintf("%.3g s", s)
}
# The header of a table, from its names: | a | b |
function head(names) {
    print names
    gsub(/[^|]+/, "---", names)
    print names
}

function machine(    i) {
    head("| | |")
    for (i = 1; i <= rows["machine"]; i++) printf "| %s | %s |\n", cell["machine", i, 1], cell["machine", i, 2]
}

# ---- spheres: 1 scene, 2 curve, 3 setting, 4 instructions, 5 end, 6 form, 7 ns, 8 dependent, 9 error ----

function is_row(t, i, s, where, how) { return cell[t, i, 1] == s && cell[t, i, 5] == where && cell[t, i, 6] == how }
function row_of(t, s, where, how, curve, what, set,    i) {
    for (i = 1; i <= rows[t]; i++)
        if (is_row(t, i, s, where, how) && cell[t, i, 2] == curve && cell[t, i, 3] == what && (set == "" || cell[t, i, 4] == set)) return i
    return 0
}
# Returns the name of the method of a row, with its settings and its instruction set. cor itself has no settings.
function call_it(t, i,    text) {
    text = cell[t, i, 2] == "copy" ? "a copy by" : cell[t, i, 2]
    if (cell[t, i, 3] != "" && text != "cor") text = text " " cell[t, i, 3]
    if (text == "cor" && cell[t, i, 6] != "scalar") text = "cor array"
    return text (cell[t, i, 4] != "" ? ", " cell[t, i, 4] : "")
}
# Prints a method that starts from a speed: its errors in the scenes, its times in "ordinary". end: default zero overlap
function method(scenes, title, curve, what, end,    t, s, n, line, i, k) {
    t = "spheres_speed"
    if (end == "") end = "overlap"
    n = split(scenes, s, " ")
    for (k = 1; k <= n; k++) {
        i = row_of(t, s[k], end, "scalar", curve, what)
        line = line " | " (!i ? "" : cell[t, i, 9] > 1e4 ? "diverges" : short(cell[t, i, 9]))
    }
    i = row_of(t, "ordinary", end, "scalar", curve, what)
    if (!i) return # not measured yet
    k = row_of(t, "ordinary", end, "array", curve, what, "AVX2")
    printf "| %s%s | %s | %s |\n", title, line, plain(cell[t, i, 7]), plain(k ? cell[t, k, 7] : "")
}
function summary(    i, s) {
    s = "weak ordinary strong"
    head("| eps from a speed | error: weak | ordinary | strong dissipation | ns, one call | ns, AVX2 loop |")
    method(s, "published Padé of 1999, with `pow`", "published", "[1/4] of Table I")
    method(s, "YADE's Padé [3/6], zero force, with `pow`", "published", "Müller & Pöschel [3/6]", "force")
    for (i = 8; i <= 32; i *= 4) method(s, "series, order " i, "series", "order " i)
    method(s, "Padé [5/8], correct coefficients", "Padé", "[5/8]")
    method(s, "two-point Padé [12/17]", "two-point Padé", "[12/17]")
    for (i = 100; i <= 1000; i *= 10) method(s, "velocity Verlet, " i " steps in a contact", "Verlet", i " steps")
    for (i = 2; i <= 14; i += 4) method(s, "header by `corgen embed`, tolerance 1e-" i, "scene header", "1e-" i)
    method(s, "cor_sphere.h", "cor_sphere.h", "")
    method(s, "**cor**", "cor", "")
}
function readme() {
    head("| eps from a speed, 0.3 <= beta <= 1.9 | largest relative error | ns, one call | ns, AVX2 loop |")
    method("ordinary", "published Padé of 1999, with `pow`", "published", "[1/4] of Table I")
    method("ordinary", "YADE's Padé [3/6], zero force, with `pow`", "published", "Müller & Pöschel [3/6]", "force")
    method("ordinary", "velocity Verlet, 100 steps in a contact", "Verlet", "100 steps")
    method("ordinary", "header by `corgen embed`, tolerance 1e-6", "scene header", "1e-6")
    method("ordinary", "**cor**, any speed", "cor", "")
}
function large(    t, i) {
    t = "spheres_speed"
    head("| arrays larger than the last-level cache | ns for each number |")
    for (i = 1; i <= rows[t]; i++)
        if (cell[t, i, 6] == "large" && cell[t, i, 5] != "force") printf "| %s | %s |\n", call_it(t, i), plain(cell[t, i, 7])
}

# ---- disks: 1 table, 2 method, 3 speed, 4 setting, 5 modes, 6 seconds, 7 error ----

function disk(i, column) { return cell["disks", i, column] }
function is_disk(i, t, m) { return disk(i, 1) == t && disk(i, 2) == m }
# Chooses the fewest modes, because the time grows with their number, except for noise of the clock.
function energy(    e, i, k, m, names, best) {
    head("| error at most | cor to a tolerance | cor, a plain sum |")
    m = split("cor truncation", names, " ")
    for (e = 1; e <= 7; e++) {
        printf "| 1e-%d |", e
        for (k = 1; k <= m; k++) {
            best = 0
            for (i = 1; i <= rows["disks"]; i++)
                if (is_disk(i, "energy", names[k]) && disk(i, 7) + 0 <= 10 ^ -e && (!best || disk(i, 5) + 0 < disk(best, 5) + 0)) best = i
            printf " %s |", best ? time(disk(best, 6)) ", " disk(best, 5) " modes" : "none"
        }
        printf "\n"
    }
}
# True if run i is within the error e, and so are all runs with a smaller tolerance, or with more modes. Otherwise the
# small error of run i is luck.
function stays(i, e,    k) {
    for (k = 1; k <= rows["disks"]; k++)
        if (is_disk(k, disk(i, 1), disk(i, 2)) && disk(k, 3) == disk(i, 3) && disk(k, 7) + 0 > e \
            && (disk(i, 1) == "collision" ? disk(k, 4) + 0 <= disk(i, 4) + 0 : disk(k, 4) == disk(i, 4) && disk(k, 5) + 0 >= disk(i, 5) + 0)) return 0
    return 1
}
function fastest(t, v, e,    i, best) {
    for (i = 1; i <= rows["disks"]; i++)
        if (is_disk(i, t, "cor") && disk(i, 3) + 0 == v && (!best || disk(i, 6) + 0 < disk(best, 6) + 0) && stays(i, e)) best = i
    return best
}
function collision(    k, best) {
    head("| error at most | cor |")
    for (k = 3; k <= 12; k++) {
        best = fastest("collision", 0.1, 10 ^ -k)
        printf "| 1e-%d | %s |\n", k, best ? time(disk(best, 6)) ", tolerance " disk(best, 4) : "none"
    }
}
function model(v, e,    i) {
    i = fastest("collision models", v, e)
    return i ? disk(i, 5) ", " disk(i, 4) + 0 ", " time(disk(i, 6)) : "none"
}
function rigid(    i) {
    head("| tolerance | median | slowest | estimate, at most | scenes | reached | within 2 s |")
    for (i = 1; i <= rows["disks"]; i++)
        if (disk(i, 1) == "rigid wall" && disk(i, 2) == "median")
            printf "| %s | %s | %s | %s | %d | %d | %d |\n", short(disk(i, 4)), time(disk(i, 6)), time(disk(i + 1, 6)), short(disk(i + 1, 7)), \
                disk(i, 5), disk(i + 2, 5), disk(i + 3, 5)
}
function models(    i, k, errors) {
    head("| error at most | v = 0.1: modes, alpha, time | v = 0.01: modes, alpha, time |")
    k = split("0.02 0.01 0.005 0.002 0.001", errors, " ")
    for (i = 1; i <= k; i++) printf "| %s | %s | %s |\n", errors[i], model(0.1, errors[i]), model(0.01, errors[i])
    print ""
    head("| in place of a collision | v | error of eps | time |")
    for (i = 1; i <= rows["disks"]; i++)
        if (disk(i, 1) == "collision models" && disk(i, 2) != "cor")
            printf "| %s | %s | %s | %s |\n", (disk(i, 2) == "Rayleigh" ? "Rayleigh's energy" : "`cor_disk_eps`"), short(disk(i, 3)), short(disk(i, 7)), time(disk(i, 6))
}
