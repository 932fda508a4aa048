// SPDX-License-Identifier: MIT
// The contacts of tests/reference/contacts.csv, and the answers of corgen; how checks are printed.
import { execFileSync, spawnSync } from "node:child_process";
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

function argumentsOf(options, without) {
    return Object.entries(options).filter(([name]) => !without.includes(name))
        .flatMap(([name, value]) => name === "wall" ? ["--wall"] : [`--${name}`, value]);
}

// Returns the table of impacts, the summary, and the lines for the simulator or the reason for their absence.
export function byCorgen(options) {
    const run = (more, without) => execFileSync(corgen, ["contact", ...argumentsOf(options, without), ...more],
        { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
    const result = { summary: run(["--format", "csv"], ["for", "speed", "steps"]) };
    if (options.speed)
        result.table = run(["--format", "csv"], ["for"]);
    if (options.for) {
        const lines = spawnSync(corgen, ["contact", ...argumentsOf(options, [])], { encoding: "utf8" });
        result.lines = lines.status === 0 ? lines.stdout : lines.stderr.replace(/^corgen: /, "").trimEnd();
    }
    return result;
}

let failed = 0;

export function check(what, ok, why = "") {
    console.log(`${ok ? "ok  " : "FAIL"}  ${what}`);
    if (!ok)
        console.log(String(why).replace(/^/gm, "      "));
    failed += ok ? 0 : 1;
}

export function finish() {
    process.exit(failed > 0 ? 1 : 0);
}
