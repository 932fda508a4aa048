// SPDX-License-Identifier: MIT
// Uses build/web/calculator.html in Chromium like a user: node tests/web/page.mjs CHROMIUM WORK [--write] [--long]
// WORK is an empty folder for downloads. With --long all scenes are typed into the fields, otherwise every fourth; the
// others are opened by their address. puppeteer-core and axe-core are in build/web/test.
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { load } from "../../build/web/package/cor.js";
import { byCorgen, check, errorOf, finish, scenes } from "./scenes.mjs";

const [, , chromium, work] = process.argv, write = process.argv.includes("--write"), long = process.argv.includes("--long");
const require = createRequire(pathToFileURL("build/web/test/package.json"));
const { default: puppeteer } = await import(pathToFileURL(require.resolve("puppeteer-core")).href);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const home = pathToFileURL("build/web/calculator.html").href;
const wait = (ms) => new Promise((done) => setTimeout(done, ms));

const browser = await puppeteer.launch({ executablePath: chromium, headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--font-render-hinting=none"] });
const complaints = [], requests = [];

async function open(address, width = 900, height = 720) {
    const page = await browser.newPage();
    page.on("console", (message) => ["error", "warn"].includes(message.type()) && complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(error.message));
    page.on("request", (request) => requests.push(request.url()));
    await page.setViewport({ width, height });
    return visit(page, address);
}
async function visit(page, address) {
    await page.goto("about:blank");
    await page.goto(address);
    await page.waitForSelector("html[data-ready]");
    return page;
}
const textOf = (page, selector) => page.$eval(selector, (element) => element.textContent);
const table = (page, id) => page.$$eval(`#${id} tr`, (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));

// ---- load ----

const page = await open(home);
await page.evaluate(() => document.querySelectorAll("details").forEach((fold) => { fold.open = true; }));
check("the page begins with an answer and a picture", (await textOf(page, "#answer")).startsWith("eps\u00a0=\u00a00.9355 at zero overlap, 0.9353 at zero force") &&
    (await page.$$("#picture path.c")).length === 2, await textOf(page, "#answer"));

// ---- scenes, by the fields ----

async function type(name, value) {
    await page.focus(`#${name}`);
    await page.$eval(`#${name}`, (field) => field.select());
    await (value === "" ? page.keyboard.press("Backspace") : page.keyboard.sendCharacter(value));
}

const asTyped = (options) => Object.entries(options).map(([name, value]) =>
    [name, name === "speed" || name.startsWith("viscosity") ? value.replace(/,/g, "; ") : value]);

// Types every number into its field; the selections come from the address.
async function enter(options) {
    const typed = asTyped(options).filter(([name]) => !["wall", "law", "for", "end", "adhesion-model"].includes(name));
    await follow({ ...options, ...Object.fromEntries(typed.map(([name]) => [name, "x"])) });
    for (const [name, value] of typed)
        await type(name, value);
}

// Opens an address of the page, and waits until the page has read it.
async function follow(options) {
    await page.evaluate((hash) => {
        location.hash = "#label=";
        location.hash = hash;
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    }, `#${new URLSearchParams(asTyped(options))}`);
}

// tests/web/module.mjs compares the module with corgen, so this file compares the page only with the module.
const module = await load(), differ = [];
const moduleText = (...call) => errorOf(() => module.page.text(...call))?.message ?? module.page.text(...call);
for (const [i, { line, options }] of scenes().entries()) {
    await (long || i % 4 === 0 ? enter : follow)(options);
    module.page.read(options);
    const wrong = await textOf(page, "#wrong") + await page.$$eval(".error:not(#lines-wrong)", (all) => all.map((e) => e.textContent).join(""));
    const shown = [await table(page, "summary"), await table(page, "impacts")].map((rows) => rows.slice(1).map((row) => row.join()).join("\n"));
    const expected = [moduleText("summary", 6), moduleText("table", 6, 1)].map((text) => text.trim().split("\n").slice(1)
        .map((row) => row.replace(/^(.*),(zero-overlap|zero-force|surface|tail|largest-pull)(,.*|)$/, "$2,$1$3")).join("\n"));
    const lines = (await textOf(page, "#lines")) || (await textOf(page, "#lines-wrong")), whole = moduleText("lines", 1);
    if (wrong !== "" || String(shown) !== String(expected) || (options.for && lines !== whole && (lines.startsWith("#") || lines.slice(0, 40) !== whole.slice(0, 40))))
        differ.push(`${line}\n${wrong}\n${shown}\n${expected}\n${lines}`);
}
check(`${scenes().length} scenes, ${long ? "all" : "a quarter"} typed into the fields: tables and lines are those of the module`,
    scenes().length === 40 && differ.length === 0, differ.join("\n"));

await follow({ restitution: "0.9", at: "1", speed: "0.1" });
for (const [name, choice, seen, field, value] of [["bodies", "glass", "--young 70e9"], ["law", "tsuji", "--law tsuji"],
    ["way", "zeta", "--zeta 0.1", "zeta", "0.1"], ["second", "plate", "--law plate", "plate-thickness", "1 cm"], ["second", "like", "--restitution 0.9"]]) {
    await page.select(`#${name}`, choice);
    if (field)
        await type(field, value);
    check(`${name}: ${choice} is chosen`, (await textOf(page, "#command")).includes(seen), await textOf(page, "#command"));
}

// ---- links, copies, downloads ----

const glass = { young: "7e10", poisson: "0.24", radius: "5e-3", density: "2500", restitution: "0.9", at: "1",
    end: "zero-force", for: "liggghts", speed: "1" };
await enter(glass);
await type("label", "glass");
await page.click("#keep");
await type("restitution", "0.8");
const shown = { ...glass, restitution: "0.8" };
const all = async (p) => (await Promise.all(["#picture", "#impacts", "#summary", "#lines", "#header", "#command", "#kept"]
    .map((id) => p.$eval(id, (element) => element.innerHTML)))).join();
const address = await page.evaluate(() => location.href), linked = await open(address);
check("a link reproduces fields, curves and results", await all(linked) === await all(page) &&
    (await textOf(linked, "#kept")).includes("glass") && /also=/.test(address), address);
await linked.close();
check("curves that were kept have a colour of their own", (await page.$$("#picture path.c.c7")).length === 1);

const client = await page.createCDPSession();
await client.send("Browser.grantPermissions", { permissions: ["clipboardReadWrite", "clipboardSanitizedWrite"] });
await page.bringToFront();
await page.click("[data-copy=lines]");
await page.waitForFunction(() => document.getElementById("said").textContent !== "");
const copied = await page.evaluate(() => navigator.clipboard.readText());
check("the button copies the lines of corgen", copied === byCorgen({ ...shown, steps: "50" }).lines && copied.includes("pair_style"), copied);

await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: work });
async function saved(button, file) {
    await page.click(button);
    for (let i = 0; i < 100 && !existsSync(`${work}/${file}`); i++)
        await wait(20);
    return existsSync(`${work}/${file}`) ? readFileSync(`${work}/${file}`, "utf8") : "";
}
const impacts = await saved("#save-impacts", "impacts.csv");
// the page also shows the errors of the time step
const rowsOf = (csv) => csv.trim().split("\n").map((row) => row.split(","));
const [head, ...rows] = rowsOf(impacts), [wanted, ...exact] = rowsOf(byCorgen(shown).table);
check("impacts.csv has the numbers of corgen contact --format csv", rows.length === exact.length &&
    wanted.every((name, i) => exact.every((row, k) => rows[k][head.indexOf(name)] === row[i])), impacts);
const svg = await saved("#save-svg", "restitution.svg"), curves = await saved("#save-csv", "curves.csv");
check("restitution.svg is a picture of its own", svg.startsWith("<svg xmlns=") && svg.includes("<style>") &&
    await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml")
        .querySelector("parsererror") === null, svg));
check("restitution.png is a picture", (await saved("#save-png", "restitution.png")).includes("PNG"));
check("curves.csv has the curves at 121 speeds", curves.trim().split("\n").length === 122 && /"zero force",.*"glass, zero force"/.test(curves.split("\n")[0]), curves.slice(0, 300));

// ---- the mark, keyboard, undo, reset ----

await page.$eval("#picture", (element) => element.scrollIntoView());
const box = await (await page.$("#mark path")).boundingBox(), frame = await (await page.$("#picture svg")).boundingBox();
const speedNow = () => page.$eval("#speed", (field) => Number(field.value));
await page.mouse.move(box.x, box.y + 60);
await page.mouse.down();
await page.mouse.move(frame.x + 46, box.y + 60, { steps: 5 });
await page.mouse.up();
check("the mark follows the pointer, and the answer follows the mark", await speedNow() === 0.001 &&
    Number((await textOf(page, "#answer")).match(/0\.\d+/)[0]).toPrecision(4) === Number(curves.split("\n")[1].split(",")[1]).toPrecision(4), await textOf(page, "#answer"));
await page.$eval("#mark", (mark) => mark.focus());
await page.keyboard.press("ArrowRight");
check("arrow keys move it, too, and a screen reader hears the value", await speedNow() === 0.00105 &&
    (await page.$eval("#mark", (e) => e.getAttribute("aria-valuetext"))).startsWith("0.00105 m/s: 0.9"), await speedNow());
await page.click("#undo");
check("undo takes one change back", await speedNow() === 0.001);
await page.click("#undo");
check("and the one before", await speedNow() === 1, await speedNow());
const reached = new Set();
await page.focus("#share");
const nameOf = (e) => e.id || e.dataset?.copy || e.getAttribute("aria-label") || e.textContent;
for (let i = 0; i < 110; i++) {
    reached.add(await page.evaluate(`(${nameOf})(document.activeElement)`));
    await page.keyboard.press("Tab");
}
const controls = await page.$$eval("input, select, button, textarea", (every, name) => every.filter((e) => e.offsetParent !== null && !e.disabled)
    .map((e) => eval(name)(e)), `(${nameOf})`);
check("the Tab key reaches every control", controls.length > 30 && controls.every((name) => reached.has(name)),
    controls.filter((name) => !reached.has(name)));
await page.evaluate(() => document.querySelector("#kept button").click());
check("a curve that was kept can be removed", (await page.$$("#picture path.c.c7")).length === 0 && !/also=/.test(page.url()));
await page.click("#reset");
check("reset gives the first question", await speedNow() === 0.1 && await page.$eval("#young", (e) => e.value) === "");

// ---- units, commas, lists ----

for (const [name, value, module, seen] of [["restitution", "0,8", "restitution=0.8", "= 0.8"], ["restitution", "80 %", "restitution=80e-2", "= 0.8"],
    ["at", "50 cm/s", "at=50e-2", "= 0.5 m/s"], ["speed", "0,1; 20mm/s", "speed=0.1,20e-3", "= 0.1; 0.02 m/s"], ["speed", "1;10", "speed=1,10", "m/s"],
    ["speed", "1,2,3", "speed=1,2,3", "= 1; 2; 3 m/s"], ["speed", "0.1,1,10", "speed=0.1,1,10", "= 0.1; 1; 10 m/s"], ["young", "70 GPa", "young=70e9", "= 70000000000 Pa"],
    ["density", "2.5 g/cm3", "density=2.5e3", "= 2500 kg/m^3"], ["radius", "5e2 \u00b5m", "radius=5e-4", "= 0.0005 m"]]) {
    await enter({ young: "7e10", poisson: "0.24", radius: "5e-3", density: "2500", restitution: "0.9", at: "1", speed: "0.1" });
    await type(name, value);
    const command = await textOf(page, "#command"), [option, number] = module.split("=");
    check(`${name} = ${value} is read as ${module}`, command.split(` --${option} `)[1]?.split(" ")[0] === number &&
        (await textOf(page, `#${name}-as`)).trim() === seen, `${command} ${await textOf(page, `#${name}-as`)}`);
}
await enter({ restitution: "0.9", at: "1", speed: "0.1" });
await type("speed", "1,10");
check("1,10 asks which is meant", /may be one number or two/.test(await textOf(page, "#speed-wrong")));
await page.click("#speed-wrong button:last-child");
check("and a click answers", await page.$eval("#speed", (e) => e.value) === "1; 10" && (await textOf(page, "#answer")).includes("At 10 m/s"));
await enter({ restitution: "0.9", at: "1", speed: "1", end: "zero-force", for: "lammps" });
await type("materials", "glass; 70 GPa; 0,24; 2500; 2 mm; 0.9; 1\nsteel; 210 GPa; 0.3; 7.85 g/cm3; 1 mm; 0.85; 1\nfloor; 210 GPa; 0.3; 7850; wall; 0.8; 1");
check("several materials and a wall have one block", /glass, radius 0.002 m[^]*steel, radius 0.001 m[^]*floor, a wall[^]*pair_coeff 2 2/.test(await textOf(page, "#lines")),
    await textOf(page, "#lines") + await textOf(page, "#lines-wrong"));
await page.click("#ask .term");
check("a term is explained", (await textOf(page, ".help:not([hidden])")).includes("rebound speed"));

// ---- wrong input ----

for (const [name, value, says] of [["radius", "-1", "'-1' is not a finite number above 0"],
    ["poisson", "0.7", "a number above -1 and up to 0.5"], ["restitution", "1.5", "a number above 0 and up to 1"],
    ["at", "", "needs \u201cSpeed of the measurement\u201d"], ["density", "2.5.1", "write it as 0.1 or 1.5e-3"],
    ["speed", "1;x", "up to 64 numbers"], ["speed-max", "1e-9", "is not below"], ["radius", "5 inch", "allowed: m, also with"],
    ["young", "0x7", "'x7' is not a unit here"], ["steps", "0.5", "is not a number, 1 or more"], ["radius", "1;2", "'1;2' is not a finite"], ["points", "0.1,0.9", "'0.1,0.9' is not a speed and an eps"],
    ["points", "-1 0.9", "'-1 0.9' is not"], ["poisson", "9".repeat(5000), "more than 1535 characters"], ["tolerance", "0", "above 0 and up to 1"]]) {
    await follow(glass);
    const before = await page.$eval("#picture", (e) => e.innerHTML), address = page.url();
    await type(name, value);
    const error = await textOf(page, `#${name}-wrong`);
    check(`wrong input: ${name} = '${value}' says what is allowed, and the last picture stays`, error.includes(says) &&
        await page.$eval(`#${name}`, (e) => e.getAttribute("aria-invalid")) === "true" && page.url() === address &&
        await page.$eval("#picture", (e) => e.innerHTML) === before, error);
}
await enter(glass);
check("right input again: the error is gone", await textOf(page, "#radius-wrong") === "" && await textOf(page, "#wrong") === "");
const strange = await open(home);
for (const [hash, place, says] of [["#g-star=3&law=x", "wrong", "'law=x'"], ["#g-star=3&yuong=1", "wrong", "'yuong=1'"], ["#g-star=-3", "g-star-wrong", "'-3' is not"]]) {
    await visit(strange, home + hash);
    check(`the address ${hash} says what is wrong`, (await textOf(strange, `#${place}`)).includes(says), await textOf(strange, `#${place}`));
}
check("without a right number there is no picture", (await strange.$("#picture svg")) === null);
await strange.evaluate(() => { location.hash = "#g-star=3&label=" + encodeURIComponent("<b id=x>&\"") + "&also=yuong%3D1"; });
await strange.waitForFunction(() => document.querySelector("#picture svg") !== null);
check("a name is no markup, and a curve that cannot be shown is left out", (await strange.$("#x")) === null &&
    (await textOf(strange, "#picture")).includes('<b id=x>&"') && (await textOf(strange, "#wrong")).includes("yuong=1"));
await strange.close();

// ---- sizes, light and dark, accessibility, pictures ----

const light = [{ name: "prefers-color-scheme", value: "light" }], dark = [{ name: "prefers-color-scheme", value: "dark" }];
const query = "#young=7e10&poisson=0.24&radius=5+mm&density=2500&restitution=0.9&at=1&speed=0.1&for=lammps";
for (const [width, scheme, hash] of [[1280, light, query], [390, light, "#"], [390, dark, `${query}&law=tsuji`], [390, light, "#restitution=1,9&at=1&speed=1,10"],
    [768, light, `${query}&points=0.1+0.9+0.01`], [768, dark, "#"], [1280, dark, query]]) {
    await page.emulateMediaFeatures(scheme);
    await page.setViewport({ width, height: 844 });
    await visit(page, home + hash);
    if (hash === "#")
        check(`${width} x 844: the answer is on the first screen`, await page.$eval("#answer", (e) => e.getBoundingClientRect().bottom) < 844);
    if (write && width === 1280 && scheme === light)
        writeFileSync("docs/web/desk.png", await page.screenshot());
    if (hash.startsWith(query))
        await page.evaluate(() => document.querySelectorAll("details, .term").forEach((e) => e.tagName === "DETAILS" ? e.open = true : e.click()));
    await page.evaluate(axe);
    const { violations, passes } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
    check(`axe-core finds no violation: ${width} pixels, ${scheme[0].value}, ${hash}`, violations.length === 0 && passes.length > 20,
        violations.map((v) => `${v.id}: ${v.help}\n${v.nodes.map((n) => n.html.slice(0, 200)).join("\n")}`).join("\n"));
    check("nothing sticks out", await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
}
check("dark has another background", await page.evaluate(() => getComputedStyle(document.body).backgroundColor) === "rgb(22, 24, 29)");

check("no error in the console", complaints.length === 0, complaints.join("\n"));
const outside = requests.filter((url) => !url.startsWith(home) && !/^(data:|blob:|about:)/.test(url));
check("no request leaves the file", requests.length > 3 && outside.length === 0, outside.join("\n"));
await browser.close();
finish();
