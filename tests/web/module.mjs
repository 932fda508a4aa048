// SPDX-License-Identifier: MIT
// Compares the module with native code, bit by bit: node tests/web/module.mjs ARGUMENTS HASHES, files that native.c
// wrote. Prints one line for each function that differs, and the ratio of times of eps of spheres.
import { readFileSync } from "node:fs";
import { load } from "../../build/web/package/cor.js";

const [, , argumentsFile, hashesFile] = process.argv;
const cor = await load();
const file = readFileSync(argumentsFile);
const x = new Float64Array(file.buffer.slice(file.byteOffset, file.byteOffset + file.length));

function hashOf(y) {
    const canonical = Float64Array.from(y, (v) => v), words = new Uint32Array(canonical.buffer);
    let hash = 2166136261;
    for (let i = 0; i < y.length; i++) {
        const isNaN = y[i] !== y[i];
        hash = Math.imul(hash ^ (isNaN ? 0 : words[2 * i]), 16777619);
        hash = Math.imul(hash ^ (isNaN ? 0x7ff80000 : words[2 * i + 1]), 16777619);
        hash ^= hash >>> 15;
    }
    return (hash >>> 0).toString(16).padStart(8, "0");
}

let failed = 0, functions = 0;
for (const line of readFileSync(hashesFile, "utf8").trim().split("\n")) {
    const [name, hash, native] = line.split(" "), [group, own] = name.split(".");
    const exponent = /^hunt_crossley\.(duration|max_overlap|time_of_max_overlap)/.test(name);
    const some = exponent && !/overlap/.test(own) ? x.subarray(0, Math.floor(x.length / 20)) : x;
    const start = performance.now();
    const y = cor[group][own](some, exponent ? 1.5 : undefined);
    const ns = 1e6 * (performance.now() - start) / some.length;
    functions++;
    if (process.env.COR_WEB_TIMES)
        console.log(name.padEnd(45), native, ns.toFixed(2), (ns / native).toFixed(2));
    const got = hashOf(y);
    if (got !== hash) {
        console.log(`${name}: hash ${got}, native ${hash}`);
        failed++;
    }
}
console.log(`${functions} functions, ${x.length} arguments: ${failed} differ`);
process.exit(failed > 0 ? 1 : 0);
