# SPDX-License-Identifier: MIT
# Counting for the test scripts, which source it and end with summary.

passed=0
failed=0
skipped=0

pass() {
    passed=$((passed + 1))
    printf 'ok    %s\n' "$1"
}

# bad NAME [WHAT WAS SEEN]
bad() {
    failed=$((failed + 1))
    printf 'FAIL  %s\n' "$1"
    [ -z "${2-}" ] || printf '%s\n' "$2" | tail -n 60 | sed 's/^/      /'
}

skip() {
    skipped=$((skipped + 1))
    printf 'skip  %s: %s\n' "$1" "$2"
}

# check NAME COMMAND...: passes if the command succeeds; a failure shows what it printed.
check() {
    local seen
    if seen=$("${@:2}" 2>&1); then
        pass "$1"
    else
        bad "$1" "$seen"
    fi
}

# count_of SCRIPT...: runs a script that ends with a summary of its own, and adds its counts.
count_of() {
    local seen last
    seen=$("$@" 2>&1) || true
    last=${seen##*$'\n'}
    if [[ $last =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed(,\ ([0-9]+)\ skipped)?$ ]]; then
        passed=$((passed + BASH_REMATCH[1]))
        failed=$((failed + BASH_REMATCH[2]))
        skipped=$((skipped + ${BASH_REMATCH[4]:-0}))
        printf '%s\n' "$seen" | sed '$d'
    else
        bad "$*" "$seen"
    fi
}

# The last line, and the exit status of the script.
summary() {
    if [ "$skipped" -gt 0 ]; then
        printf '%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
    else
        printf '%d passed, %d failed\n' "$passed" "$failed"
    fi
    [ "$failed" -eq 0 ]
}
