# SPDX-License-Identifier: MIT
# What the tables of docs/speed say: bench/run and tests/hygiene source this.

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

# report_words DIR: docs/speed/README.md from the tables of DIR
report_words() {
    awk -f bench/report_words.awk "$1"/*.csv | wrapped
}

# readme_words DIR: README.md with the table of DIR between its two marks
readme_words() {
    awk -v page=readme -f bench/report_words.awk "$1/spheres_speed.csv" |
        sed -e '/^<!-- written by bench\/run/r /dev/stdin' -e '/^<!-- written by bench\/run/,/^<!-- end -->/{/^<!--/!d}' README.md
}
