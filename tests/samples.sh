# SPDX-License-Identifier: MIT
# Runs the examples of a page and compares the output with the page. Needs tests/count.sh, and the variables corgen,
# work (a directory) and, for C, library (libcor.a).
#
#         $ corgen ...         a command of corgen, cor or cc; \ continues it; its output is indented below it
#     ```c                     after a line <!-- NAME.c -->: a program, or lines that replace the loop in the first
#     ```                      program of the page; its output, if shown, is the next indented block
#
# samples_of PAGE [NEW-PAGE]: gives one verdict for each example; writes the page with the current outputs to NEW-PAGE.

# sample_output COMMAND: runs it in the shell, in a folder like the reader's, and prints the output.
sample_output() {
    (cd "$work/samples" && PATH="$work/bin:$PATH" bash -c "$1" 2>&1 </dev/null)
}

samples_prepare() {
    mkdir -p "$work/bin" "$work/samples"
    ln -sf "$corgen" "$work/bin/corgen"
    ln -sf "$PWD"/docs/data/*.csv "$PWD"/tests/audit/decks/* "$work/samples"
    # paths without a space, because the shell splits the output of pkg-config
    ln -sfn "$PWD/include" "$work/include"
    [ -z "${library-}" ] || ln -sf "$library" "$work/libcor.a"
    printf '#!/bin/sh\necho "-I%s %s -lm"\n' "$work/include" "${library:+$work/libcor.a}" >"$work/bin/pkg-config"
    chmod +x "$work/bin/pkg-config"
}

# sample_program TEXT NAME: writes NAME.c, a whole program, or the page's first one with these lines in place of its
# loop.
sample_program() {
    local body
    if [[ $1 == *"int main("* ]]; then
        printf '%s' "$1" >"$work/samples/$2.c"
        [ -e "$work/samples/first.c" ] || cp "$work/samples/$2.c" "$work/samples/first.c"
        return
    fi
    body=$(grep -v '^#include' <<<"$1")
    {
        grep '^#include' <<<"$1"
        sed '/^    for /,$d' "$work/samples/first.c"
        printf '%s\n    return 0;\n}\n' "$body"
    } >"$work/samples/$2.c"
}

# sample_verdict: judges the current example, and appends its current output to new.
sample_verdict() {
    local seen shown=$expected
    while [[ $shown == *$'\n' ]]; do shown=${shown%$'\n'}; done
    if [[ $command == 'corgen '*' --plot '* ]] && ! command -v gnuplot >/dev/null; then
        seen=$shown
        skip "$page: ${title:0:50}" "no gnuplot (gnuplot-nox)"
    elif [[ $command == 'cor '* ]] && [ ! -e "$work/bin/cor" ]; then
        seen=$shown
        skip "$page: ${title:0:50}" "no Python with SciPy and Matplotlib"
    else
        seen=$(sample_output "$command") || seen+=$'\n'"(exit status $?)"
        if [ "$seen" = "$shown" ]; then
            pass "$page: ${title:0:50}"
        else
            bad "$page: $title" "$(diff <(printf '%s\n' "$shown") <(printf '%s\n' "$seen"))"
        fi
    fi
    [ -z "$seen" ] || new+=$(sed 's/^\(.\)/    \1/' <<<"$seen")$'\n'
    expected=${expected#"$shown"}
    [ -z "$shown" ] || expected=${expected#$'\n'}
    new+=$expected
    command='' expected=''
}

samples_of() {
    local page=$1 new='' line command='' expected='' title='' name='' code='' in_code='' last='' count=0
    samples_prepare
    rm -f "$work/samples/first.c"
    while IFS= read -r line; do
        if [ "$in_code" ]; then
            new+=$line$'\n'
            if [ "$line" = '```' ]; then
                in_code=''
                count=$((count + 1))
                : "${name:=sample_$count}"
                sample_program "$code" "$name"
            else
                code+=$line$'\n'
            fi
            continue
        fi
        # an example ends at the first line that is not indented, or at the next command
        if [ "$command" ] && [[ $line != '' && $line != '    '* || $line == '    $ '* ]]; then
            sample_verdict
        fi
        if [ "$command" ]; then
            expected+=${line#    }$'\n'
            continue
        fi
        case $line in
        '```c')
            in_code=1 code=''
            [[ $last =~ ^'<!-- '(.*/)?([a-z_]+)\.c' -->'$ ]] && name=${BASH_REMATCH[2]} || name=''
            ;;
        '    $ corgen '* | '    $ cor '* | '    $ cc '*)
            new+=$line$'\n'
            command=${line#*\$ } code=''
            while [[ $command == *\\ ]] && IFS= read -r line; do
                new+=$line$'\n'
                command="${command%\\}${line#    }"
            done
            title=$command
            continue
            ;;
        '    '*)
            if [ "$code" ]; then
                command="cc -std=c99 -Wall -Wextra $(cmake/werror cc) $name.c \$(pkg-config --cflags --libs cor) && ./a.out"
                title="lines of C, $name" code=''
                expected=${line#    }$'\n'
                continue
            fi
            ;;
        '' | '```'*) ;;
        *) code='' ;;
        esac
        new+=$line$'\n'
        last=$line
    done < <(cat "$page" && echo '<end of the page>')
    [ -z "${2-}" ] || printf '%s' "${new%'<end of the page>'$'\n'}" >"$2"
}
