# SPDX-License-Identifier: MIT
# Functions for missing packages and for build directories. The bash scripts gen/run, tests/run, tests/*/run and
# bench/run source this file in the root of the repository.

jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
missing=()

say() {
    printf '== %s\n' "$*"
}

have() {
    command -v "$1" >/dev/null 2>&1
}

has_header() {
    printf '#include <%s>\n' "$1" | cc -E - >/dev/null 2>&1
}

# want PACKAGE CHECK...: adds the Debian package to the missing ones if the command CHECK fails.
want() {
    local package=$1
    shift
    "$@" >/dev/null 2>&1 || missing+=("$package")
}

want_compiler() {
    want build-essential eval 'have cc && have c++ && have make'
    want cmake have cmake
    want pkg-config have pkg-config
}

want_generator() {
    want_compiler
    want libgmp-dev has_header gmp.h
    want libmpfr-dev has_header mpfr.h
    want libflint-dev has_header flint/fmpq_poly.h
}

# FLINT 3 contains Arb, and distributions with FLINT 3 have no package for Arb. Call this only after FLINT was found.
want_arb() {
    has_header flint/arb.h || want libflint-arb-dev has_header arb.h
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif ! have sudo; then
        return 1
    elif [ -t 0 ]; then
        sudo "$@"
    else
        sudo -n "$@"
    fi
}

# Installs the packages that want() found missing. If some must be installed by hand, names them and fails.
install_missing() {
    [ ${#missing[@]} -eq 0 ] && return 0
    local packages=("${missing[@]}")
    missing=()
    if have apt-get; then
        say "installing ${packages[*]}"
        local get=(env DEBIAN_FRONTEND=noninteractive apt-get -y -qq)
        as_root "${get[@]}" install --no-install-recommends "${packages[@]}" </dev/null >/dev/null 2>&1 && return 0
        as_root "${get[@]}" update </dev/null >/dev/null 2>&1 || true
        as_root "${get[@]}" install --no-install-recommends "${packages[@]}" </dev/null >/dev/null && return 0
    fi
    say "please install what Debian calls ${packages[*]}" >&2
    return 1
}

# Prints the compilers gcc-N and clang-N newer than gcc and clang: the installed ones, and the newest that apt has.
newer_compilers() {
    local kind
    for kind in gcc clang; do
        {
            compgen -c "$kind-"
            ! have apt-cache || apt-cache search --names-only "^$kind-[0-9]+\$" | cut -d ' ' -f 1 | sort -V | tail -n 1
        } | grep -xE "$kind-[0-9]+" | sort -uV | awk -F - -v now="$("$kind" -dumpversion 2>/dev/null)" '$2 > now + 0'
    done
}

# Installs the packages that corgen is built from. Ends the script if they are not available.
install_generator() {
    want_generator
    install_missing >&2 || exit 1
    want_arb
    install_missing >&2 || exit 1
}

# Prints the version of FLINT that a build finds, for scripts that depend on it.
say_flint() {
    say "FLINT $(printf '#include <flint/flint.h>\nFLINT_VERSION\n' | cc -E -P - | sed -n '$s/.*"\(.*\)"/\1/p')"
}

# The options for tests/: everything is built, and warnings are errors.
build_options=(-DCOR_BUILD_GENERATOR=ON -DCOR_BUILD_TESTS=ON -DCOR_BUILD_EXAMPLES=ON -DCOR_BUILD_PAPER=ON
    -DCOR_WERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)

# configure DIR OPTION...: runs cmake; first removes a build directory of other sources.
configure() {
    local dir=$1
    shift
    if [ -e "$dir/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$dir/CMakeCache.txt"; then
        rm -rf "$dir"
    fi
    cmake -S . -B "$dir" "$@"
}

# configure_tested CC DIR OPTION...: for the tests. Warnings are not errors for compilers newer than the tested ones.
configure_tested() {
    local warnings_pass=()
    [ "$(cmake/werror "$1")" ] || warnings_pass=(-DCOR_WERROR=OFF)
    configure "$2" -DCMAKE_C_COMPILER="$1" "${build_options[@]}" "${warnings_pass[@]}" "${@:3}"
}

build() {
    cmake --build "$1" --parallel "$jobs" "${@:2}"
}

# msvc_reads FILE LANGUAGE: true if clang accepts FILE in MSVC's mode, with the headers of mingw-w64 instead of MSVC's.
msvc_reads() {
    clang --target=x86_64-pc-windows-msvc -fms-compatibility-version=19.30 -fsyntax-only -x "$2" -Wall -Wextra -Wpedantic \
        -Wno-pragma-once-outside-header -Wno-unused-function $(cmake/werror clang) -nostdinc -Iinclude -Igenerated \
        -isystem "$(clang -print-resource-dir)/include" -isystem /usr/share/mingw-w64/include "$1"
}

# turn_of N: prints K modulo N for tests/run --turn K. Of a long test with N parts, a short run does this part.
turn_of() {
    echo $((${COR_TEST_TURN:-0} % $1))
}

# some_in_turn N TURN: prints the last column, separated by tabs, of the input lines whose number is TURN modulo N.
some_in_turn() {
    awk -F '\t' -v n="$1" -v turn="$2" 'NR % n == turn { print $NF }'
}

# builds_whole CC [--long]: true if a test run builds everything with this compiler. gcc always does. Others do in long
# runs and in every fifth turn. In that turn tests/hygiene/run runs only valgrind.
builds_whole() {
    [ "$1" = gcc ] || [ "${2-}" = --long ] || [ "$(turn_of 5)" -eq 2 ]
}

# parse_rest DIR: parses, with all warnings, one fifth of the sources that the target unit_tests does not need.
# Skips generated sources.
parse_rest() {
    sed -n 's/^ *"command": "\(.*\)",\{0,1\}$/\1/p' "$1/compile_commands.json" | sed 's/\\"/"/g; s/\\\\/\\/g' |
        grep -vE " [^ ]*/(runtime|tests/unit|$1)/[^ ]*\$" |
        sed "s|^\(.*\) -o [^ ]* -c $PWD/\(.*\)|\2\t\1 -fsyntax-only $PWD/\2|" | some_in_turn 5 "$(turn_of 5)" |
        (cd "$1" && xargs -r -P "$jobs" -d '\n' -n 1 sh -c)
}

# build_tested CC DIR [--long]: builds all if builds_whole. Otherwise builds library and tests, and parses the rest.
build_tested() {
    if builds_whole "$1" "${3-}"; then
        build "$2"
    else
        build "$2" --target unit_tests && parse_rest "$2"
    fi
}

# quietly COMMAND...: shows the output only if the command fails.
quietly() {
    local log status=0
    log=$("$@" 2>&1) || status=$?
    [ "$status" -eq 0 ] || printf '%s\n' "$log" >&2
    return "$status"
}
