# SPDX-License-Identifier: MIT
# docs/speed/README.md from the tables beside it, and from nothing else:
#     awk -f bench/report_words.awk docs/speed/*.csv          (-v page=readme: the table of README.md; bench/words.sh)

BEGIN { FS = "," }
FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/\.csv$/, "", name); next }
name == "machine" { machine[++machines] = $1; machine_value[machines] = $2 }
name ~ /^spheres_/ {
    n = ++rows[name]
    scene[name, n] = $1; curve[name, n] = $2; setting[name, n] = $3; set[name, n] = $4; end[name, n] = $5
    form[name, n] = $6; ns[name, n] = $7; chained[name, n] = $8; error[name, n] = $9
}
name == "floats" && ($3 == "as shipped" || $3 == "") {
    f_ns[$1, $2] = $4; f_share[$1, $2] = $5; f_error[$1, $2] = $6
    if (!f_seen[$1]++) quantity[++quantities] = $1
}
name == "disks" {
    n = ++rows[name]
    table[n] = $1; method[n] = $2; speed[n] = $3; d_setting[n] = $4; modes[n] = $5; d_s[n] = $6; d_error[n] = $7
}
name == "generator" {
    n = ++rows[name]
    command[n] = $1; fixed[n] = $2; varied[n] = $3; value[n] = $4; g_s[n] = $5; g_mb[n] = $6; step[n] = $7
}

# ---- numbers in words ----

function short(x) { return sprintf("%.2g", x) }
function plain_ns(x) { return x < 10 ? sprintf("%.1f", x) : x < 1000 ? sprintf("%.0f", x) : sprintf("%.0f", int(x / 100 + 0.5) * 100) }
function time(s) {
    if (s < 1e-6) return sprintf("%.0f ns", s * 1e9)
    if (s < 1e-3) return sprintf("%.3g us", s * 1e6)
    if (s < 1) return sprintf("%.3g ms", s * 1e3)
    return sprintf("%.3g s", s)
}
function times(x) { return x < 10 ? sprintf("%.1f", x) : sprintf("%.0f", x) }

# A header without settings is cor itself; a set of instructions goes behind.
function call_it(t, i,    text) {
    text = curve[t, i]
    if (setting[t, i] != "" && text != "cor")
        text = text " " setting[t, i]
    if (text == "cor" && form[t, i] != "scalar") text = "cor array"
    return set[t, i] != "" ? text ", " set[t, i] : text
}

# ---- the cheapest ----

# Row of the least time of table t with error at most e; 0 for none. who: "any", "no scene" or the name of a curve
function allowed(t, i, who) {
    if (who == "any") return 1
    if (who == "no scene") return curve[t, i] !~ /^scene header/
    if (who == "integrated") return curve[t, i] ~ /^(Taylor|Runge-Kutta|Verlet)$/
    return curve[t, i] == who
}
function cheapest(t, s, where, how, who, e,    i, best) {
    best = 0
    for (i = 1; i <= rows[t]; i++)
        if (scene[t, i] == s && end[t, i] == where && form[t, i] == how && error[t, i] != "" && error[t, i] !~ /nan/ \
            && error[t, i] + 0 <= e && allowed(t, i, who) && (!best || ns[t, i] + 0 < ns[t, best] + 0))
            best = i
    return best
}
function least_error(t, s, where, how, who,    i, best) {
    for (i = 1; i <= rows[t]; i++)
        if (scene[t, i] == s && end[t, i] == where && form[t, i] == how && allowed(t, i, who) && error[t, i] !~ /nan/ \
            && (!best || error[t, i] + 0 < error[t, best] + 0))
            best = i
    return best
}

function cell(t, i) { return i ? call_it(t, i) ", " plain_ns(ns[t, i]) : "none" }

# One line for each decade, neighbours with the same answers together.
function decades(t, s, where,    k, line, last, from, headers) {
    headers = cheapest(t, s, where, "scalar", "scene header", 1) > 0
    if (headers) {
        printf "\n| error at most | one at a time, ns | without a header for the scene, ns | in loops and arrays, ns | without a header for the scene, ns |\n"
        printf "|---|---|---|---|---|\n"
    } else
        printf "\n| error at most | one at a time, ns | in loops and arrays, ns |\n|---|---|---|\n"
    last = ""
    for (k = 1; k <= 16; k++) {
        line = ""
        if (k <= 15)
            line = (headers ? cell(t, cheapest(t, s, where, "scalar", "any", 10 ^ -k)) " | " : "") \
                cell(t, cheapest(t, s, where, "scalar", "no scene", 10 ^ -k)) " | " \
                (headers ? cell(t, cheapest(t, s, where, "array", "any", 10 ^ -k)) " | " : "") \
                cell(t, cheapest(t, s, where, "array", "no scene", 10 ^ -k))
        if (line != last) {
            if (last != "")
                printf "| %s | %s |\n", (from == k - 1 ? "1e-" from : "1e-" from " to 1e-" k - 1), last
            from = k
            last = line
        }
    }
}

function row_of(t, s, where, how, c, what, instructions,    i) {
    for (i = 1; i <= rows[t]; i++)
        if (scene[t, i] == s && end[t, i] == where && form[t, i] == how && curve[t, i] == c \
            && (what == "" || setting[t, i] == what) && (instructions == "" || set[t, i] == instructions))
            return i
    return 0
}

# Time of cor at any speed against what is cheaper: which error does it have at least?
function cheaper_than_cor(t, s, where, how, who,    i, best, cor) {
    cor = cheapest(t, s, where, how, "cor", 1e-14)
    best = 0
    for (i = 1; i <= rows[t]; i++)
        if (scene[t, i] == s && end[t, i] == where && form[t, i] == how && allowed(t, i, who) && curve[t, i] !~ /^cor/ \
            && ns[t, i] + 0 < 0.95 * ns[t, cor] && error[t, i] !~ /nan/ && (!best || error[t, i] + 0 < error[t, best] + 0))
            best = i
    return best
}

function spheres(t, from, picture,    i, j, k, cor, array, s, where, scenes, ends, title) {
    printf "\n## Spheres, eps from %s\n\n![error against time, spheres](%s)\n", from, picture
    split("weak ordinary strong", scenes, " ")
    split("overlap force", ends, " ")
    title["weak"] = "weak dissipation, 0.03 <= beta <= 0.19"
    title["ordinary"] = "ordinary dissipation, 0.3 <= beta <= 1.9"
    title["strong"] = "strong dissipation, 0.95 <= beta <= 6"
    for (i = 1; i <= 3; i++)
        for (j = 1; j <= 2; j++) {
            s = scenes[i]; where = ends[j]
            printf "\nThe cheapest, %s, ends at zero %s:\n", title[s], where
            decades(t, s, where)
            k = cheaper_than_cor(t, s, where, "scalar", "no scene")
            cor = cheapest(t, s, where, "scalar", "cor", 1e-14)
            if (k)
                printf "\nOne at a time, every method that is cheaper than cor (%s ns, error %s) and holds for every scene has an error of %s or more (%s, %s ns).\n", \
                    plain_ns(ns[t, cor]), short(error[t, cor]), short(error[t, k]), call_it(t, k), plain_ns(ns[t, k])
            else
                printf "\nOne at a time, no method that holds for every scene is cheaper than cor (%s ns, error %s).\n", \
                    plain_ns(ns[t, cor]), short(error[t, cor])
        }
}

function floats(    i, q) {
    if (!quantities)
        return
    print "\n## Spheres, float against double\n"
    print "Functions of beta, 0.3 <= beta <= 1.9, one at a time and in arrays: ns, and the share of the time in double. A function that ends in f rounds the double result once, and one in fastf computes in float. Errors are in units of the last place of a float; `floats.csv` also has the instruction sets.\n"
    print "| function | double | `..f` | `..fastf` | array | `.._arrayf` | `.._fast_arrayf` | error of `..f` | of `..fastf` |"
    print "|---|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= quantities; i++) {
        q = quantity[i]
        printf "| %s | %.2f | %.2f, %.2f | %.2f, %.2f | %.2f | %.2f, %.2f | %.2f, %.2f | %s | %s |\n", q, f_ns[q, "double"], f_ns[q, "float"], \
            f_share[q, "float"], f_ns[q, "fast float"], f_share[q, "fast float"], f_ns[q, "double array"], f_ns[q, "float array"], \
            f_share[q, "float array"], f_ns[q, "fast float array"], f_share[q, "fast float array"], f_error[q, "float"], f_error[q, "fast float array"]
    }
}
function large_arrays(    t, i, text) {
    t = "spheres_speed"
    text = ""
    for (i = 1; i <= rows[t]; i++)
        if (form[t, i] == "large" && end[t, i] != "force") text = text (text != "" ? ", " : "") (curve[t, i] == "copy" ? "a copy by " setting[t, i] : call_it(t, i)) " " plain_ns(ns[t, i])
    if (text != "") printf "\nArrays larger than the last-level cache, ns for each number: %s.\n", text
}

function use_spheres(    t, c, a, h, i, best, text, n, least, most, worst, k, j, ends, tie, x) {
    t = "spheres_speed"
    c = row_of(t, "ordinary", "overlap", "scalar", "cor", "")
    a = cheapest(t, "ordinary", "overlap", "array", "cor", 1e-14)
    i = row_of(t, "ordinary", "overlap", "scalar", "published", "[1/4] of Table I")
    printf "- **Spheres, any speed: cor.** One at a time %s ns from a speed, in arrays %s ns (%s), error %s. The published formula takes %s ns; its error is %s there, and a factor of %s where dissipation is strong. Do not use it.\n", \
        plain_ns(ns[t, c]), plain_ns(ns[t, a]), set[t, a], short(error[t, a]), plain_ns(ns[t, i]), short(error[t, i]), \
        times(1 + error[t, row_of(t, "strong", "overlap", "scalar", "published", "[1/4] of Table I")])
    printf "  Where dissipation is weak, 0.03 <= beta <= 0.19, cor takes %s ns at zero overlap and %s ns at zero force; below beta = 1/256, where eps > 0.995, it also takes a fifth root.\n", \
        plain_ns(ns[t, row_of(t, "weak", "overlap", "scalar", "cor", "")]), plain_ns(ns[t, row_of(t, "weak", "force", "scalar", "cor", "")])
    split("overlap force", ends, " ")
    least = 1e9; most = 0; tie = ""
    for (j = 1; j <= 2; j++)
        for (k = 1; k <= rows[t]; k++)
            if (curve[t, k] == "scene header" && end[t, k] == ends[j] && form[t, k] == "scalar") {
                c = row_of(t, "ordinary", ends[j], "scalar", "cor", "")
                if (ns[t, k] < 0.95 * ns[t, c]) {
                    if (ns[t, k] + 0 < least) least = ns[t, k] + 0
                    if (ns[t, k] + 0 > most) most = ns[t, k] + 0
                } else if (tie == "" || setting[t, k] + 0 > tie + 0) tie = setting[t, k]
            }
    printf "- **Spheres in a known range of speeds, with a known tolerance: a header by `corgen embed`**, %s to %s ns one at a time for four decades of speed", plain_ns(least), plain_ns(most)
    if (tie != "") printf "; from a tolerance of %s on it is no cheaper than cor, which holds at every speed", tie
    printf ". In loops for AVX2:"
    n = 0
    for (k = 1; k <= rows[t]; k++)
        if (curve[t, k] == "scene header" && end[t, k] == "overlap" && set[t, k] == "AVX2")
            printf "%s %s in %s ns", n++ ? "," : "", setting[t, k], plain_ns(ns[t, k])
    printf ".\n"
    t = "spheres_beta"
    i = least_error(t, "weak", "overlap", "scalar", "series")
    k = least_error(t, "ordinary", "overlap", "scalar", "series")
    x = cheaper_than_cor(t, "weak", "overlap", "scalar", "series")
    printf "- **Series: only where dissipation is weak.** For beta up to 0.19, %s has an error of %s in %s ns%s. Up to 1.9 the error of the best order, %s, is a factor of %s, because the series diverges.\n", \
        setting[t, i], short(error[t, i]), plain_ns(ns[t, i]), \
        (x && x != i ? " (" setting[t, x] ", " short(error[t, x]) " in " plain_ns(ns[t, x]) " ns)" : ""), setting[t, k], times(1 + error[t, k])
    i = cheaper_than_cor(t, "ordinary", "overlap", "scalar", "Padé")
    k = cheaper_than_cor(t, "ordinary", "force", "scalar", "Padé")
    if (i && k)
        printf "- **A Padé approximant with correct coefficients, from beta:** up to beta = 1.9 the best ones cheaper than cor are %s at zero overlap, error %s in %s ns, and %s at zero force, %s in %s ns. The tables below have larger beta.\n", \
            setting[t, i], short(error[t, i]), plain_ns(ns[t, i]), setting[t, k], short(error[t, k]), plain_ns(ns[t, k])
    i = row_of(t, "strong", "overlap", "scalar", "Padé", "[12/20]")
    k = row_of(t, "strong", "overlap", "scalar", "two-point Padé", "[12/17]")
    printf "- **Two-point Padé approximants** hold for every beta, but converge slowly at medium beta: up to beta = 6 the error of [12/17] is %s, that of the ordinary [12/20] %s.\n", \
        short(error[t, k]), (error[t, i] > 1 ? "a factor of " times(1 + error[t, i]) : short(error[t, i]))
    i = row_of(t, "ordinary", "overlap", "scalar", "cor float", "")
    c = row_of(t, "ordinary", "overlap", "scalar", "cor", "")
    a = row_of(t, "ordinary", "overlap", "array", "cor float", "")
    printf "- **float, correctly rounded**: error %s (for the float argument), %s ns against %s ns in double, arrays %s ns. It saves memory%s. Functions in fast float save time: see \"float against double\" below.\n", short(error[t, i]), \
        plain_ns(ns[t, i]), plain_ns(ns[t, c]), plain_ns(ns[t, a]), (ns[t, i] > 0.9 * ns[t, c] ? ", not time" : "")
    t = "spheres_speed"
    i = cheapest(t, "ordinary", "overlap", "scalar", "Taylor", 2e-9)
    k = cheapest(t, "ordinary", "overlap", "scalar", "Runge-Kutta", 2e-9)
    x = row_of(t, "ordinary", "overlap", "scalar", "Verlet", "100 steps")
    c = row_of(t, "ordinary", "overlap", "scalar", "cor", "")
    printf "- **Integrating the collision** costs %s times cor's time by a Taylor method with an error of %s", times(ns[t, i] / ns[t, c]), short(error[t, i])
    if (k) printf ", and %s times by a Runge-Kutta method with %s", times(ns[t, k] / ns[t, c]), short(error[t, k])
    printf ". Velocity Verlet with 100 steps in a contact, as in a simulator, has an error of %s, with 1000 steps %s.\n", short(error[t, x]), \
        short(error[t, row_of(t, "ordinary", "overlap", "scalar", "Verlet", "1000 steps")])
}

# ---- disks ----

function row_of_disks(t, m, v, what,    i) {
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == t && method[i] == m && (v == "" || speed[i] == v) && (what == "" || d_setting[i] == what)) return i
    return 0
}

# Fewest modes: in their order time grows, but for what the clock adds.
function best_rayleigh(m, e,    i, best) {
    best = 0
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == "energy" && method[i] == m && d_error[i] + 0 <= e && (!best || modes[i] + 0 < modes[best] + 0))
            best = i
    return best
}
function least_disk_error(t, m,    i, best) {
    best = 0
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == t && method[i] == m && (!best || d_error[i] + 0 < d_error[best] + 0)) best = i
    return best
}
function timed(i) { return i ? time(d_s[i]) ", " short(d_error[i]) : "" }

function rayleigh(    k, i, m, names, best, first) {
    printf "\n## Disks: Rayleigh's energy\n\n![error against time, Rayleigh](rayleigh.svg)\n\nEnergy in all modes, Poisson's ratio nu = 0.33, impact speed v = 1e-3, the fastest run of each method:\n\n"
    printf "| error at most | cor to a tolerance | cor, a plain sum | cosine integrals | Runge-Kutta |\n|---|---|---|---|---|\n"
    split("cor truncation cosines Runge-Kutta", names, " ")
    for (k = 1; k <= 7; k++) {
        printf "| 1e-%d |", k
        for (m = 1; m <= 4; m++) {
            best = best_rayleigh(names[m], 10 ^ -k)
            printf " %s |", best ? time(d_s[best]) ", " modes[best] " modes" : "none"
        }
        printf "\n"
    }
    first = 1
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == "rayleigh" && method[i] == "cor") {
            if (first) printf "\nEach of 1800 modes, nu = 0.33: time, and the largest error of a mode whose cosine does not cancel:\n\n| v | cor | cosine integrals | Runge-Kutta 5(4) |\n|---|---|---|---|\n"
            first = 0
            printf "| %s | %s | %s | %s |\n", short(speed[i]), timed(i), timed(row_of_disks("rayleigh", "cosines", speed[i])), timed(row_of_disks("rayleigh", "Runge-Kutta", speed[i]))
        }
    first = 1
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == "tolerance" && method[i] == "all") {
            if (first) printf "\nTolerances of the sum over all modes, nu = 0.33, from a table of 20000 modes:\n\n| v | tolerance | modes taken | time | true error | modes without the tail |\n|---|---|---|---|---|---|\n"
            first = 0
            k = row_of_disks("tolerance", "sum alone", speed[i], d_setting[i])
            printf "| %s | %s | %d | %s | %s | %s |\n", short(speed[i]), short(d_setting[i]), modes[i], time(d_s[i]), d_error[i] != "" ? short(d_error[i]) : "", k ? (modes[k] < 1e6 ? modes[k] : short(modes[k])) : ""
        }
    i = row_of_disks("loading", "cor_disk_modes_read"); k = row_of_disks("loading", "fgets and sscanf")
    if (i && k) printf "\n`cor_disk_modes_read` reads and checks a file of 1800 modes in %s; `sscanf`, without checks, takes %s times as long.\n", time(d_s[i]), times(d_s[k] / d_s[i])
}

function use_rayleigh(    i, k, own) {
    i = best_rayleigh("cor", 1e-3)
    k = best_rayleigh("truncation", 1e-4)
    own = best_rayleigh("cor", 1e-5)
    printf "- **Disks, slow (Rayleigh's energy): `cor_disk_rayleigh_tolerance`.** %s for an error of %s with %d modes%s; ", time(d_s[i]), short(d_error[i]), modes[i], \
        own ? ", " time(d_s[own]) " for " short(d_error[own]) : ""
    printf "a sum without its tail needs %d modes for %s. ", modes[k], short(d_error[k])
    i = row_of_disks("modes", "cor")
    printf "Each of 1800 modes: cor %s, error %s; cosine integrals %s; Runge-Kutta %s.\n", time(d_s[i]), short(d_error[i]), \
        timed(least_disk_error("modes", "cosines")), timed(least_disk_error("modes", "Runge-Kutta"))
}

# Not by luck: the error stays below for every smaller step or tolerance, for every larger number of modes.
function stays(i, e,    k) {
    for (k = 1; k <= rows["disks"]; k++)
        if (table[k] == table[i] && method[k] == method[i] && speed[k] == speed[i] && d_error[k] + 0 > e \
            && (table[i] != "collision models" ? d_setting[k] + 0 <= d_setting[i] + 0 \
                                               : d_setting[k] + 0 == d_setting[i] + 0 && modes[k] + 0 >= modes[i] + 0))
            return 0
    return 1
}
function best_collision(m, e,    i, best) {
    best = 0
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == "collision" && method[i] == m && (!best || d_s[i] + 0 < d_s[best] + 0) && stays(i, e))
            best = i
    return best
}
function best_model(v, e,    i, best) {
    best = 0
    for (i = 1; i <= rows["disks"]; i++)
        if (table[i] == "collision models" && method[i] == "cor" && speed[i] == v && (!best || d_s[i] + 0 < d_s[best] + 0) && stays(i, e))
            best = i
    return best
}

function collisions(    k, m, best, errors) {
    printf "\n## Disks: collisions in full\n\n![error against time, collisions](collision.svg)\n\n"
    printf "A collision of 940 modes, Poisson's ratio nu = 0.33, hardness of the wall alpha = 500, impact speed v = 0.1: the fastest run within an error of eps, from which every smaller tolerance keeps the error:\n\n"
    printf "| error at most | cor |\n|---|---|\n"
    for (k = 3; k <= 12; k++) {
        best = best_collision("cor", 10 ^ -k)
        printf "| 1e-%d | %s |\n", k, best ? time(d_s[best]) : "none"
    }
    printf "\nDistance to eps of all modes at a hard wall (`cor_disk_eps`, within its uncertainty), not exceeded with more modes:\n\n"
    printf "| error at most | v = 0.1: modes, alpha, time | v = 0.01: modes, alpha, time |\n|---|---|---|\n"
    split("0.02 0.01 0.005 0.002 0.001", errors, " ")
    for (k = 1; k <= 5; k++) {
        printf "| %s |", errors[k]
        for (m = 1; m <= 2; m++) {
            best = best_model(m == 1 ? "0.1" : "0.01", errors[k])
            printf " %s |", best ? modes[best] ", " d_setting[best] + 0 ", " time(d_s[best]) : "none"
        }
        printf "\n"
    }
}

function use_collisions(    i, k, m) {
    i = best_collision("cor", 1e-4); m = best_collision("cor", 1e-8)
    printf "- **Disks, one collision with a given wall: `cor_disk_collision` with the tolerance that you need.** 940 modes at alpha = 500: error 1e-4 in %s, 1e-8 in %s (tolerance %s).\n", \
        time(d_s[i]), time(d_s[m]), d_setting[m]
    i = row_of_disks("collision models", "cor_disk_eps", "0.1"); k = row_of_disks("collision models", "Rayleigh", "0.01")
    m = best_model("0.1", 0.005)
    printf "- **Disks, eps at a hard wall: `cor_disk_eps`**, %s, uncertain by %s at v = 0.1. The error of a single collision in its place comes from its soft wall and its missing modes, not from its tolerance: an error of 0.005 takes %s (%d modes, alpha = %d).", \
        time(d_s[i]), short(d_error[i]), time(d_s[m]), modes[m], d_setting[m]
    printf " Rayleigh's energy, first-order perturbation, gives eps with an error of %s at v = 0.01 and %s at 0.1.\n", short(d_error[k]), short(d_error[row_of_disks("collision models", "Rayleigh", "0.1")])
}

# ---- the generator ----

# Slope of ln y against ln x by least squares, from three points on
function exponent(x, y, n,    i, sx, sy, sxx, sxy, p) {
    sx = sy = sxx = sxy = 0
    for (i = 1; i <= n; i++) {
        sx += log(x[i]); sy += log(y[i]); sxx += log(x[i]) ^ 2; sxy += log(x[i]) * log(y[i])
    }
    if (n < 3) return "?"
    p = (n * sxy - sx * sy) / (n * sxx - sx * sx)
    return sprintf("%.1f", p)
}
function slope(c, f, v, column,    i, n, x, y) {
    n = 0
    for (i = 1; i <= rows["generator"]; i++)
        if (command[i] == c && fixed[i] == f && varied[i] == v && value[i] >= 20) { x[++n] = value[i]; y[n] = column == "s" ? g_s[i] : g_mb[i] }
    return exponent(x, y, n)
}
# "memory like order^1.4", or that it does not grow
function memory(c, f, v,    p) {
    p = slope(c, f, v, "mb")
    return p + 0 < 0.15 ? "memory that hardly grows with the " v : "memory like " v "^" p
}

function generator(    i) {
    printf "\n## The generator\n\n![order and digits against time and memory](generator.svg)\n\n"
    printf "| corgen | fixed | | time | memory | most expensive step |\n|---|---|---|---|---|---|\n"
    for (i = 1; i <= rows["generator"]; i++)
        printf "| %s | %s | %s %s | %s | %.0f MB | %s |\n", command[i], fixed[i], varied[i], value[i], time(g_s[i]), g_mb[i], step[i]
    printf "\nFrom order 20 on, `series` to 40 digits takes time like order^%s and %s. `trajectory` of 20 terms takes time like order^%s and %s. A collision at beta = 1 takes time like digits^%s from 20 digits on.\n", \
        slope("series", "40 digits", "order", "s"), memory("series", "40 digits", "order"), \
        slope("trajectory", "20 terms", "order", "s"), memory("trajectory", "20 terms", "order"), slope("collide", "beta 1", "digits", "s")
}

# The table of README.md: the ordinary scene, contacts that end at zero overlap
function readme_row(name, i, loop) {
    printf "| %s | %s | %s | %s |\n", name, short(error["spheres_speed", i]), plain_ns(ns["spheres_speed", i]), \
        loop ? plain_ns(ns["spheres_speed", loop]) " (" set["spheres_speed", loop] ")" : ""
}

function readme(    t, s, e) {
    t = "spheres_speed"; s = "ordinary"; e = "overlap"
    printf "| eps from a speed, 0.3 <= beta <= 1.9 | largest relative error | ns, one call | ns, in a loop |\n|---|---|---|---|\n"
    readme_row("published Padé of 1999, with `pow`", row_of(t, s, e, "scalar", "published", "[1/4] of Table I"))
    readme_row("velocity Verlet, 100 steps in a contact", row_of(t, s, e, "scalar", "Verlet", "100 steps"))
    readme_row("Taylor series of the motion, tolerance 1e-9", row_of(t, s, e, "scalar", "Taylor", "1e-09"))
    readme_row("header by `corgen embed`, tolerance 1e-6", row_of(t, s, e, "scalar", "scene header", "1e-6"), \
        row_of(t, s, e, "array", "scene header", "1e-6", "AVX2"))
    readme_row("**cor**, any speed", row_of(t, s, e, "scalar", "cor", ""), row_of(t, s, e, "array", "cor", "", "AVX2"))
}

END {
    if (page == "readme") {
        readme()
        exit
    }
    print "<!-- SPDX-License-Identifier: MIT -->\n# Speed against error\n"
    print "`bench/run` writes this page from the csv tables beside it, which come from one run on one machine. eps is the coefficient of restitution, g the impact speed, and beta the number, proportional to g^(1/5), on which eps of viscoelastic spheres depends ([derivation](../derivation.md), 1). A contact ends at zero overlap or at zero force. A time is the least of many turns on one core; compare ratios. An error is the largest found. Errors are relative; for collisions of disks they are errors of eps.\n"
    print "| | |\n|---|---|"
    for (i = 1; i <= machines; i++) printf "| %s | %s |\n", machine[i], machine_value[i]
    print "\n## Which to use\n"
    use_spheres()
    use_rayleigh()
    use_collisions()
    i = 0
    for (k = 1; k <= rows["generator"]; k++)
        if (command[k] == "series" && varied[k] == "order" && value[k] == 60) i = k
    if (i) printf "- **The generator**: `corgen series --order 60 --digits 40` takes %s and %.0f MB. Time grows like order^%s, and at order 40 like digits^%s; %s.\n", time(g_s[i]), g_mb[i], \
        slope("series", "40 digits", "order", "s"), slope("series", "order 40", "digits", "s"), memory("series", "40 digits", "order")
    spheres("spheres_speed", "a speed", "spheres_speed.svg")
    large_arrays()
    spheres("spheres_beta", "beta", "spheres_beta.svg")
    floats()
    rayleigh()
    collisions()
    generator()
}
