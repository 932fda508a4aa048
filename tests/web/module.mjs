// SPDX-License-Identifier: MIT
// Tests the package in node: node tests/web/module.mjs NATIVE COUNT FOLDER [--same-libm]
// NATIVE is tests/web/native.c as a program. Prints a line for each check, and details of failures.
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { load } from "../../build/web/package/cor.js";
import { byCorgen, check, errorOf, finish, printed, scenes } from "./scenes.mjs";

const [, , native, count, folder, sameLibm] = process.argv;
const cor = await load();
// ---- bits ----

// Returns the largest distance of corresponding results, counted in doubles.
function largestDistance(y, z) {
    const a = new BigInt64Array(y.buffer), b = new BigInt64Array(z.buffer);
    let largest = 0;
    for (let i = 0; i < y.length; i++)
        if (a[i] !== b[i] && !(y[i] !== y[i] && z[i] !== z[i])) {
            const distance = Number(a[i] > b[i] ? a[i] - b[i] : b[i] - a[i]);
            largest = y[i] !== y[i] || z[i] !== z[i] ? Infinity : Math.max(largest, distance);
        }
    return largest;
}

// These functions use cbrt, pow or similar functions of the C library, which may be off by a unit of the last place. The
// module and the native program have different C libraries.
const ofLibm = /^viscoelastic,(zero-force,duration|approach-only,damping-of-loss)|^hertz-dashpot,(zero-force,[eld]|.*,time)/;

const names = execFileSync(native, [count, folder], { encoding: "utf8" }).trim().split("\n");
const doubles = (name) => new Float64Array(Uint8Array.from(readFileSync(`${folder}/${name}`)).buffer);
const x = doubles(names.shift()), wrong = [];
let near = 0;
for (const name of names) {
    const theirs = doubles(name), given = x.subarray(0, theirs.length), law = name.split(",");
    const ours = law.length > 1 ? cor.law.value(...law, given) : cor.hunt_crossley[name](given, 1.3);
    const distance = largestDistance(ours, theirs);
    if (!sameLibm && ofLibm.test(name) && distance > 0 && distance <= 2)
        near++;
    else if (distance > 0)
        wrong.push(`${name}: off by ${distance} doubles at most`);
}
check(`WebAssembly has the bits of native code: ${names.length - near} functions at ${x.length} arguments; ${near} ` +
    "within 2 doubles by another C library", wrong.length === 0 && names.length > 80, wrong.join("\n"));

// ---- sizes that 32 bits do not hold ----

const large = 2 ** 28 + Math.floor(Math.random() * 2 ** 28), contact = cor.contact({ g_star: 0.2 });
const refusals = [() => cor.sphere.eps_zero_force({ length: large }), () => contact.impacts({ length: large / 4 })].map(errorOf);
check(`an array of ${large} numbers is refused, and the next call is right`,
    refusals.every((error) => error instanceof cor.CorError) && cor.sphere.eps_zero_force([0])[0] === 1, refusals.join("\n"));

// ---- scenes ----

let differ = [];
for (const { line, options } of scenes()) {
    const theirs = byCorgen(options), ours = {};
    cor.page.read({ ...options });
    ours.summary = cor.page.text("summary", 12);
    if (theirs.table)
        ours.table = cor.page.text("table", 12, options.steps ? 1 : 0);
    if (theirs.lines)
        ours.lines = errorOf(() => cor.page.text("lines"))?.message ?? cor.page.text("lines");
    for (const part of ["summary", "table", "lines"])
        if (ours[part] !== theirs[part])
            differ.push(`${line}\n${theirs[part]}\n${ours[part]}`);
}
check(`${scenes().length} scenes: tables, and lines for simulators, are those of corgen contact`,
    scenes().length === 40 && differ.length === 0, differ.join("\n"));

// ---- any request ----

// Right and wrong options at random: a refusal has a reason, and no eps of an accepted request is outside [0, 1].
let seed = 34, read = 0, refused = 0;
const random = (n) => {
    seed = Math.imul(seed, 1664525) + 1013904223 >>> 0;
    return Math.floor(seed / 2 ** 32 * n);
};
const pick = (list) => list[random(list.length)];
const number = () => random(9) ? pick(["1", "0.5", "1e-3", "1e5", "1e-9", String(random(1e9) / 1e9)])
    : pick(["0", "1e300", "1e-300", "-1", "", "x"]);
const odd = [];
for (let i = 0; i < 3000; i++) {
    const options = { law: pick(["viscoelastic", "viscoelastic", "viscoelastic", "linear", "tsuji", "hunt-crossley", "hertz-dashpot", "plate", "x"]) };
    if (random(2))
        Object.assign(options, { young: 7e10, poisson: 0.2, radius: 5e-3, density: 2500, wall: random(4) === 0 });
    else if (random(2))
        Object.assign(options, { stiffness: number(), "effective-mass": number() });
    const way = pick(["restitution", "g-star", "dissipation-time", "damping-coefficient", "beta", "zeta"]);
    Object.assign(options, { [way]: number() }, /restitution|beta/.test(way) ? { at: number() } : {});
    for (const name of ["end", "for", "speed", "steps", "speed-min", "speed-max", "tolerance", "radius-2", "plate-thickness"])
        if (random(/-2|plate/.test(name) ? 20 : 4) === 0)
            options[name] = name === "end" ? pick(["zero-overlap", "zero-force"])
                : name === "for" ? pick(cor.simulators()).name : number();
    const error = errorOf(() => {
        cor.page.read(options);
        read++;
        const [curves] = [["curves"], ["table", 6, 1], ["summary", 6], ["models", 6]]
            .map((call) => cor.page.text(...call).trimEnd().split("\n"));
        if (curves.some((line, k) => cor.page.curve([0.01, 1], k).some((eps) => eps < 0 || eps > 1)))
            odd.push(JSON.stringify(options), curves.join("\n"));
        if (options.for)
            cor.page.text("lines");
    });
    refused += error ? 1 : 0;
    if (error && (!(error instanceof cor.CorError) || error.message === ""))
        odd.push(`${JSON.stringify(options)} ${error.stack}`);
}
check(`3000 requests at random: ${read} read, ${refused} refused with a reason`, odd.length === 0 && read > 500 && refused > 500,
    odd.slice(0, 4).join("\n"));

// Random requests: the module inside web/calculator.html gives the same numbers as corgen.
const html = readFileSync("web/calculator.html", "utf8"), [, bytes, packed] = html.match(/id="wasm" data-bytes="(\d+)">([^\n]*)<\/script>/);
const unpack = (0, eval)(`(${html.match(/async function unpack[^]*?\n}\n/)[0]})`);
const shipped = await load(await unpack({ textContent: packed, dataset: { bytes } }));
const within = (least, most) => (least * (most / least) ** (random(1e6) / 1e6)).toPrecision(5), unlike = [];
for (let i = 0; i < 200; i++) {
    const options = { speed: [within(1e-3, 10), within(1e-3, 10)].join(","), ...pick([{ restitution: within(0.3, 0.999), at: within(0.01, 10) },
        { "g-star": within(1, 1e5) }, { "dissipation-time": within(1e-8, 1e-5) }, { law: "tsuji", restitution: within(0.3, 0.99) },
        { law: "hunt-crossley", restitution: within(0.3, 0.99), at: "1" }, { law: "linear", zeta: within(0.01, 0.9) },
        { law: "hertz-dashpot", restitution: within(0.3, 0.99), at: within(0.1, 1) }]) };
    if (options["dissipation-time"] || (random(2) && options.law !== "linear"))
        Object.assign(options, { young: within(1e6, 1e12), poisson: within(0.01, 0.49), radius: within(1e-5, 1), density: within(500, 9e3) },
            pick([{}, {}, { wall: "yes" }, { wall: "yes", gravity: "9.81" }, { "radius-2": within(1e-5, 1) }, { "adhesion-model": "dmt", adhesion: "1e-3" }]));
    shipped.page.read(options);
    const ours = shipped.page.text("table", 10, 0), theirs = printed(options, ["--format", "csv"]);
    const cells = (text) => text.split(/[,\n]/), mine = cells(ours);
    const same = cells(theirs).length === mine.length && cells(theirs).every((cell, k) => cell === mine[k] || Math.abs(cell / mine[k] - 1) < 1e-9);
    if (!same)
        unlike.push(JSON.stringify(options), ours, theirs);
}
check("web/calculator.html: numbers of 200 requests at random are those of corgen", unlike.length === 0, unlike.slice(0, 9).join("\n"));

// ---- the functions of JavaScript ----

const glass = { young: 7e10, poisson: 0.2, radius: 5e-3, density: 2500 };
const measured = cor.contact({ ...glass, restitution: 0.9, at: 1 });
check("a restitution without its end has two contacts, each 0.9 at its own end", measured.count === 2 &&
    Math.abs(measured.eps([1], "zero-overlap", 0)[0] - 0.9) < 1e-14 &&
    Math.abs(measured.eps([1], "zero-force", 1)[0] - 0.9) < 1e-14 && Math.abs(measured.impacts([1])[1].eps_zero_force[0] - 0.9) < 1e-14);
const [phases, ends] = [measured, cor.contact({ ...glass, g_star: 7e4 })].map((c) => c.stepErrors([1], 1e-6));
check("errors of a time step have the name of their end where the contact does not", Math.abs(phases[1].bias[0]) < 1e-3 &&
    phases.length === 2 && Object.keys(ends[0]).join() === "bias_zero_overlap,scatter_zero_overlap,bias_zero_force,scatter_zero_force");
check("two contacts do not disturb each other", (() => {
    const other = cor.contact({ ...glass, g_star: 3 }), eps = other.eps([1], "zero-force")[0];
    measured.impacts([1]);
    return other.eps([1], "zero-force")[0] === eps && measured.impacts([2])[1].beta.length === 1;
})());
check("an array of 10^6 numbers, twice, does not fill the memory", cor.sphere.eps_zero_force(new Float64Array(1e6))[9] === 1
    && cor.sphere.eps_zero_force(new Float64Array(1e6)).length === 1e6);
const embed = "--speed-min 0.001 --speed-max 10 --tolerance 0.00001 --end zero-force --output cor_scene_eps.h\n";
check("headers and commands", cor.contact({ g_star: 3, end: "zero-force" }).header({ tolerance: 1e-5 }) === `corgen embed --g-star 3 ${embed}` &&
    cor.contact({ law: "tsuji", restitution: 0.7, end: "zero-force" }).header().endsWith("return 0.7;\n}\n") &&
    cor.contact({ law: "tsuji", restitution: 0.7 }).header().includes("double cor_scene_eps_zero_overlap(double speed_m_s)") &&
    cor.contact({ ...glass, wall: true, g_star: 400, end: "zero-force" }).header({ tolerance: "0.00001" }) ===
        `corgen embed --young 70000000000 --poisson 0.2 --radius 0.005 --density 2500 --wall --g-star 400 ${embed}` &&
    cor.page.command({ g_star: 3, speed: "0.1, 1", steps: 9, for: "lammps" }) === "corgen contact --g-star 3 --speed 0.1,1 --steps 9");
const balls = [[7e10, 0.24, 2500, 2e-3, 0.9, 1], [2.1e11, 0.3, 7850, 1e-3, 0.85, 2], [2.1e11, 0.3, 7850, NaN, 0.8, 1]];
const cells = (row) => row.map((x) => Number.isNaN(x) ? "" : x).join();
writeFileSync(`${folder}/materials.csv`, "name,young_pa,poisson,density_kg_m3,radius_m,wall\n" +
    balls.map((row, i) => `m${i},${cells(row.slice(0, 4))},${i > 1 ? 1 : 0}\n`).join(""));
writeFileSync(`${folder}/pairs.csv`, "a,b,restitution,at_m_s\nm0,m0,0.9,1\nm1,m1,0.85,2\nm0,m2,0.8,1\nm1,m2,0.8,1\n");
cor.page.read({ restitution: 0.9, at: 1, speed: "1,2", end: "zero-force", for: "lammps" });
check("the block of two materials and a wall is that of corgen", cor.page.block("m0\nm1\nm2", balls.flat()) ===
    printed({ materials: `${folder}/materials.csv`, pairs: `${folder}/pairs.csv`, end: "zero-force", speed: "1,2", for: "lammps" }));
check("special values", Object.is(cor.sphere.eps_zero_force([0, Infinity, -1, NaN]).join(), "1,0,NaN,NaN") &&
    cor.sphere.eps_zero_force([]).length === 0);
const { law, sphere } = cor, eps = sphere.eps_zero_force([0.5]), inverse = law.function("Tsuji", "limited", "damping_of_eps");
check("laws by name", law.value("tsuji", "zero_force", "eps", [0])[0] === 1 && law.laws().includes("hunt-crossley") &&
    law.ends().length === 5 && law.quantities()[0] === "eps" && inverse.least === 0 && inverse.largest === 1 &&
    inverse.max_ulp === 2 && law.function("plate", "limited", "eps") === null &&
    Number.isNaN(law.value("viscoelastic", "limited", "eps", [0.5])[0]) &&
    Math.abs(sphere.beta_zero_force(eps)[0] - 0.5) < 1e-15 && Math.abs(sphere.loss_zero_force([0.5])[0] + eps[0] - 1) < 1e-15);
for (const [what, act, name, text] of [
    ["an end that is none", () => law.value("linear", "surface", "eps", [1]), "", /^end: 'surface'; allowed: zero-overlap, /],
    ["an unknown law", () => cor.contact({ law: "hooke" }), "law", /^--law: 'hooke' is not a law; allowed: viscoelastic, /],
    ["an unknown option", () => cor.contact({ yuong: 1 }), "yuong", /is not an option/],
    ["not a number", () => cor.contact({ g_star: "0x10" }), "g-star", /'0x10' is not a finite number above 0/],
    ["an infinite number", () => cor.contact({ g_star: Infinity }), "g-star", /'Infinity' is not a finite number/],
    ["an unknown simulator", () => measured.lines("abaqus"), "for", /'abaqus' is not a simulator that cor has lines for/],
    ["a wall that moves", () => cor.contact({ ...glass, g_star: 1, wall: true, mass_2: 1 }), "wall", /^--wall is flat/],
    ["a line break in a value", () => cor.contact({ g_star: "1\nwall=yes" }), "g-star", /is not a finite number/],
    ["too long a value", () => cor.contact({ radius: "1".repeat(5000) }), "radius", /more than 1535 characters/]]) {
    const error = errorOf(act);
    check(`refused: ${what}`, error instanceof cor.CorError && error.option === name && text.test(error.message), error ? `${error.option}: ${error.message}` : "not refused");
}
check("a number instead of an array is a TypeError", [() => cor.sphere.eps_zero_force(1), () => cor.hunt_crossley.duration([1])]
    .every((act) => errorOf(act) instanceof TypeError));

// ---- the example of the page ----

const [, example] = readFileSync("docs/languages.md", "utf8").match(/```js\n([^`]*)```/);
writeFileSync("build/web/example.mjs", example.replace('"cor-restitution"', '"./package/cor.js"'));
const said = spawnSync("node", ["build/web/example.mjs"], { encoding: "utf8" });
check("the example of docs/languages.md runs", said.status === 0 && said.stdout.includes("0.39393060322987317") &&
    said.stdout.includes("pair_style granular"), said.stdout + said.stderr);

// ---- types ----

const types = readFileSync("web/cor.d.ts", "utf8");
const missing = [...Object.keys(sphere), ...Object.keys(cor.hunt_crossley)].filter((name) => !types.includes(`"${name}"`));
check("cor.d.ts names every function", missing.length === 0, missing.join("\n"));

finish();
