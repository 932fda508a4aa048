// SPDX-License-Identifier: MIT
// The contacts of tests/reference/contacts.csv, and the answers of corgen; how checks are printed.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";

const corgen = process.env.CORGEN ?? "build/gcc/corgen";

// Returns the contacts for which the page has fields: options of the module, and the line of arguments.
export function scenes() {
    return readFileSync("tests/reference/contacts.csv", "utf8").split("\n").slice(1)
        .map((row) => row.match(/^(?:"([^"]*)"|([^,"]*)),yes,/)).filter((cells) => cells)
        .map(([, quoted, plain]) => quoted ?? plain).map((line) => ({ line, options: optionsOf(line.split(" ")) }));
}

function optionsOf(words) {
    const options = {};
    for (let i = 0; i < words.length; i++) {
        const name = words[i].slice(2);
        options[name] = words[i + 1]?.startsWith("--") || i + 1 === words.length ? "yes" : words[++i];
    }
    return options;
}

// Returns the output of corgen contact for options, except those named in `without`, and more arguments.
export function printed(options, more = [], without = []) {
    const given = Object.entries(options).filter(([name]) => !without.includes(name))
        .flatMap(([name, value]) => name === "wall" ? ["--wall"] : [`--${name}`, value]);
    const { status, stdout, stderr } = spawnSync(corgen, ["contact", ...given, ...more], { encoding: "utf8" });
    return status === 0 ? stdout : stderr.replace(/^corgen: /, "").trimEnd();
}

// Returns the table of impacts, the summary, and the lines for the simulator or the reason for their absence.
export function byCorgen(options) {
    const result = { summary: printed(options, ["--format", "csv"], ["for", "speed", "steps"]) };
    if (options.speed)
        result.table = printed(options, ["--format", "csv"], ["for"]);
    if (options.for)
        result.lines = printed(options);
    return result;
}

let failed = 0;

export function check(what, ok, why = "") {
    console.log(`${ok ? "ok  " : "FAIL"}  ${what}`);
    if (!ok)
        console.log(String(why).replace(/^/gm, "      "));
    failed += ok ? 0 : 1;
}

// Returns the error that a function throws.
export function errorOf(act) {
    try {
        act();
    } catch (error) {
        return error;
    }
    return undefined;
}

export function finish() {
    process.exit(failed > 0 ? 1 : 0);
}
