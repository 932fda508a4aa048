# SPDX-License-Identifier: MIT
# Counts tests. The test scripts source this file in the root of the repository and end with summary. The files in $work
# are removed at the end.
. cmake/shell.sh

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

# needs FILE...: ends the script if a file to be tested does not exist.
needs() {
    local file
    for file in "$@"; do
        [ -e "$file" ] || {
            echo "$0: $file does not exist; build it, or name it as described at the start of this script" >&2
            exit 1
        }
    done
}

# wrong_option GIVEN ALLOWED
wrong_option() {
    echo "$0: '$1' is not an option; allowed: $2" >&2
    exit 2
}

passed=0
failed=0
skipped=0

pass() {
    passed=$((passed + 1))
    printf 'ok    %s\n' "$1"
}

# bad NAME [OUTPUT]
bad() {
    failed=$((failed + 1))
    printf 'FAIL  %s\n' "$1"
    [ -z "${2-}" ] || printf '%s\n' "$2" | tail -n 60 | sed 's/^/      /'
}

skip() {
    skipped=$((skipped + 1))
    printf 'skip  %s: %s\n' "$1" "$2"
}

# check NAME COMMAND...: passes if the command succeeds; a failure shows its output.
check() {
    local seen
    if seen=$("${@:2}" 2>&1); then
        pass "$1"
    else
        bad "$1" "$seen"
    fi
}

# check_with PROGRAM NAME COMMAND...: runs check if the program is installed
check_with() {
    if have "$1"; then
        check "${@:2}"
    else
        skip "$2" "no $1"
    fi
}

# count_of SCRIPT...: runs a script that ends with its own summary, and adds its counts.
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

# check_ctest NAME DIR OPTION...: runs and counts the tests of ctest in that directory. A failed test shows the lines
# of its assertion first, then the end of its output.
check_ctest() {
    local log line seen
    log=$(ctest --test-dir "$2" --parallel "$jobs" --output-on-failure "${@:3}" 2>&1) || true
    while IFS= read -r line; do
        if [[ $line =~ ^\ *[0-9]+/[0-9]+\ +Test\ +#[0-9]+:\ ([^ ]+)\ \.*\ *(Passed|\*\*\*[A-Za-z ]+) ]]; then
            if [ "${BASH_REMATCH[2]}" = Passed ]; then
                pass "$1 ${BASH_REMATCH[1]}"
            else
                seen=$(awk -v "name=${BASH_REMATCH[1]}" '
                    /^ *[0-9]+\/[0-9]+ +Test +#/ { on = $0 ~ "#[0-9]+: " name " "; next }
                    /^ *Start +[0-9]+: |% tests passed/ { on = 0 }
                    on { print }' <<<"$log")
                bad "$1 ${BASH_REMATCH[1]}" "$({
                    grep -E 'ERROR|FAIL  |property violated|runtime error| is false' <<<"$seen" | head -n 20
                    tail -n 40 <<<"$seen"
                })"
            fi
        fi
    done <<<"$log"
    [[ $log == *"tests passed"* ]] || bad "$1 ctest" "$log"
}

# stage NAME...: begins a stage, which ends at the next stage or summary. The summary shows the seconds of each stage,
# and the processor seconds of the processes that ended in it.
stages=()
stage_name=
stage() {
    local clock=${EPOCHREALTIME/[!0-9]/} cpu
    times >"$work/times"
    cpu=$(awk '{ for (i = 1; i < 3; i++) { split($i, t, /[ms]/); s += 60 * t[1] + t[2] } } END { printf "%d", 1e6 * s }' "$work/times")
    [ -z "$stage_name" ] || stages+=("$(awk -v w=$((clock - stage_clock)) -v c=$((cpu - stage_cpu)) -v n="$stage_name" \
        'BEGIN { printf "%7.1f s, %7.1f s of a processor: %s", w / 1e6, c / 1e6, n }')")
    stage_name=$* stage_clock=$clock stage_cpu=$cpu
}

# Prints the last line. Its status is the exit status of the script.
summary() {
    [ -z "$stage_name" ] || stage
    [ ${#stages[@]} -eq 0 ] || printf '%s\n' "${stages[@]}"
    if [ "$skipped" -gt 0 ]; then
        printf '%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
    else
        printf '%d passed, %d failed\n' "$passed" "$failed"
    fi
    [ "$failed" -eq 0 ]
}
