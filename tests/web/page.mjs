// SPDX-License-Identifier: MIT
// Uses build/web/index.html in Chromium as a person does: node tests/web/page.mjs CHROMIUM WORK [--write] [--long]
// WORK is an empty folder for downloads. With --long all scenes are typed into the fields, otherwise every fourth; the
// others come by their address. puppeteer-core and axe-core are in build/web/test.
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { byCorgen, check, finish, scenes } from "./scenes.mjs";

const [, , chromium, work] = process.argv, write = process.argv.includes("--write"), long = process.argv.includes("--long");
const require = createRequire(pathToFileURL("build/web/test/package.json"));
const { default: puppeteer } = await import(pathToFileURL(require.resolve("puppeteer-core")).href);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const home = pathToFileURL("build/web/index.html").href;
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
    await page.goto(address);
    await page.waitForSelector("html[data-ready]");
    return page;
}
const textOf = (page, selector) => page.$eval(selector, (element) => element.textContent);
const table = (page, id) => page.$$eval(`#${id} tr`, (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));

// ---- load ----

const page = await open(home);
const times = [];
for (let i = 0; i < 3; i++) {
    await page.reload();
    await page.waitForSelector("html[data-ready]");
    times.push(await page.evaluate(() => Number(document.documentElement.dataset.ready) -
        performance.getEntriesByType("navigation")[0].domInteractive));
}
check(`the first picture is there ${Math.min(...times).toFixed(0)} ms after the page is read; allowed: 200`,
    Math.min(...times) < 200 && (await page.$$("#picture .cor-c")).length > 3, times);

// ---- scenes, by the fields ----

async function type(name, value) {
    await page.focus(`#${name}`);
    await page.$eval(`#${name}`, (field) => field.select());
    await (value === "" ? page.keyboard.press("Backspace") : page.keyboard.sendCharacter(value));
}

async function enter(options) {
    const has = (...names) => names.some((name) => name in options);
    await page.evaluate(() => { location.hash = "#label="; });
    await page.waitForFunction(() => document.getElementById("young").value === "");
    await page.select("#kind", has("young") ? "bodies" : has("stiffness") ? "spring" : "none");
    if (has("law"))
        await page.select("#law", options.law);
    if (has("young"))
        await page.select("#second", has("wall") ? "wall" : has("plate-thickness") ? "plate"
            : has("young-2", "radius-2", "mass-2", "density-2") ? "other" : "like");
    await page.select("#way", ["restitution", "g-star", "dissipation-time", "viscosity", "damping-coefficient", "beta", "zeta"]
        .find((name) => has(name)) ?? "none");
    for (const [name, value] of Object.entries(options))
        if (["for", "end"].includes(name))
            await page.select(`#${name}`, value);
        else if (!["wall", "law"].includes(name))
            await type(name, value);
}

// Waits until the page has read the address, which it then writes in its own way.
async function follow(options) {
    await page.evaluate((hash) => {
        location.hash = "#label=";
        location.hash = hash;
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    }, `#${new URLSearchParams(options)}`);
}

const differ = [];
for (const [i, { line, options }] of scenes().entries()) {
    const theirs = byCorgen(options);
    await (long || i % 4 === 0 ? enter : follow)(options);
    const wrong = (await textOf(page, "#wrong")) + (await page.$$eval(".error", (all) => all.map((e) => e.textContent).join("")));
    const words = (text) => text.trim().split("\n").map((row) => row.trim().split(/\s\s+/).join("|")).join("\n");
    const [, summary, impacts] = theirs.text.split("\n\n");
    const asPrinted = (rows) => rows[0][0] === "eps measured at" ? rows.map(([end, ...row]) => [...row, end]) : rows;
    const shown = async (id, columns) => asPrinted(await table(page, id)).slice(1).map((row) => row.slice(0, columns).join("|")).join("\n");
    // corgen lines its numbers up by spaces, two at least
    const rows = (text) => words(text).split("\n").slice(1).map((row) => row.split("|"));
    const expected = rows(summary).map((row) => row.join("|")).join("\n");
    if (wrong !== "" || await shown("summary") !== expected)
        differ.push(`${line}\n${wrong}${expected}\n${await shown("summary")}`);
    if (options.speed) {
        const columns = options.steps ? undefined : 9; // the errors of the step are there on the page alone
        const ours = await shown("impacts", columns), wanted = rows(impacts).map((row) => row.slice(0, columns).join("|")).join("\n");
        if (ours !== wanted)
            differ.push(`${line}\n${wanted}\n${ours}`);
    }
    const lines = (await textOf(page, "#lines")) || (await textOf(page, "#lines-wrong"));
    if (options.for && lines !== theirs.lines)
        differ.push(`${line}\n${theirs.lines}\n${lines}`);
}
check(`${scenes().length} scenes, ${long ? "all" : "a quarter"} typed into the fields: tables and lines are those that corgen contact prints`,
    scenes().length === 40 && differ.length === 0, differ.join("\n"));

// ---- links, copies, downloads ----

const glass = { young: "7e10", poisson: "0.24", radius: "5e-3", density: "2500", restitution: "0.9", at: "1",
    end: "zero-force", for: "liggghts", speed: "1" };
await enter(glass);
await page.select("#overlay", "steel");
const all = async (p) => (await Promise.all(["#picture", "#impacts", "#summary", "#lines", "#header", "#command", "#kept"]
    .map((id) => p.$eval(id, (element) => element.innerHTML)))).join();
const linked = await open(page.url());
check("a link reproduces fields, curves and results", await all(linked) === await all(page) &&
    (await textOf(linked, "#kept")).includes("steel") && /also=/.test(page.url()), page.url());
await linked.close();
check("a material laid over has curves of its own", (await page.$$("#picture path.cor-c.cor-1")).length === 2);

const client = await page.createCDPSession();
await client.send("Browser.grantPermissions", { permissions: ["clipboardReadWrite", "clipboardSanitizedWrite"] });
await page.bringToFront();
await page.click("[data-copy=lines]");
await page.waitForFunction(() => document.getElementById("said").textContent !== "");
const copied = await page.evaluate(() => navigator.clipboard.readText());
check("the button copies the lines of corgen", copied === byCorgen(glass).lines && copied.includes("pair_style"), copied);

await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: work });
async function saved(button, file) {
    await page.click(button);
    for (let i = 0; i < 100 && !existsSync(`${work}/${file}`); i++)
        await wait(20);
    return existsSync(`${work}/${file}`) ? readFileSync(`${work}/${file}`, "utf8") : "";
}
const impacts = await saved("#save-impacts", "impacts.csv");
// the page has the errors of the time step, too
const rowsOf = (csv) => csv.trim().split("\n").map((row) => row.split(","));
const [head, ...rows] = rowsOf(impacts), [wanted, ...exact] = rowsOf(byCorgen(glass).table);
check("impacts.csv has the numbers of corgen contact --format csv", rows.length === exact.length &&
    wanted.every((name, i) => exact.every((row, k) => rows[k][head.indexOf(name)] === row[i])), impacts);
const svg = await saved("#save-svg", "restitution.svg"), curves = await saved("#save-curves", "curves.csv");
check("restitution.svg is a picture of its own", svg.startsWith("<svg xmlns=") && svg.includes("<style>") &&
    await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml")
        .querySelector("parsererror") === null, svg));
check("curves.csv has 201 speeds", curves.trim().split("\n").length === 202 && curves.includes('"steel, 0.85 at 1 m/s, ends at zero force"'));

// ---- pointer and keyboard ----

await page.$eval("#picture", (element) => element.scrollIntoView());
const box = await (await page.$("#picture svg")).boundingBox();
await page.mouse.move(box.x + 50, box.y + 60);
const left = await table(page, "values");
await page.mouse.move(box.x + box.width - 14, box.y + 60);
const right = await table(page, "values");
check("the pointer reads the curves", left[0][1] === "eps at 0.001 m/s" && right[0][1] === "eps at 10 m/s" &&
    Number(left[1][1]).toPrecision(6) === Number(curves.split("\n")[1].split(",")[1]).toPrecision(6) &&
    Number(right[1][1]) < Number(left[1][1]), JSON.stringify([left, right]));
await page.focus("#cursor");
await page.keyboard.press("ArrowLeft");
const one = await table(page, "values");
check("arrow keys read them, too, and a screen reader hears the values", one[0][1] !== right[0][1] &&
    (await page.$eval("#cursor", (e) => e.getAttribute("aria-valuetext"))).includes(one[1][1]), JSON.stringify(one));
const reached = new Set();
await page.focus("#kind");
for (let i = 0; i < 60; i++) {
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.dataset?.copy || document.activeElement.getAttribute("aria-label")));
    await page.keyboard.press("Tab");
}
const controls = await page.$$eval("input, select, button", (every) => every.filter((e) => e.offsetParent !== null && !e.disabled)
    .map((e) => e.id || e.dataset.copy || e.getAttribute("aria-label")));
check("the Tab key reaches every control", controls.length > 20 && controls.every((name) => reached.has(name)),
    controls.filter((name) => !reached.has(name)));
await page.evaluate(() => document.querySelector("#kept button").click());
check("a curve that was kept can be removed", (await page.$$("#picture path.cor-c.cor-1")).length === 0 && !/also=/.test(page.url()));

// ---- wrong input ----

for (const [name, value, says] of [["radius", "-1", "--radius: '-1' is not a finite number above 0"],
    ["poisson", "0.7", "a number above -1 and up to 0.5"], ["restitution", "1.5", "a number above 0 and up to 1"],
    ["at", "", "--restitution needs --at SPEED"], ["density", "2,5", "written as 0.1, 1.5e-3"],
    ["speed", "1,x", "up to 64 of them, with commas"], ["speed-max", "1e-9", "is not below --speed-max"],
    ["young", "0x7", "is not a finite number above 0"], ["steps", "0.5", "a number from 1 to 1e9"]]) {
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
const strange = await open(`${home}#g-star=3&yuong=1`);
check("an address with an unknown option says so", (await textOf(strange, "#wrong")).includes("'yuong=1'"));
await strange.goto("about:blank");
await strange.goto(`${home}#g-star=-3`);
await strange.waitForSelector("html[data-ready]");
check("an address with a wrong number: the field says so, and there is no picture", (await textOf(strange, "#g-star-wrong"))
    .startsWith("--g-star: '-3' is not") && (await strange.$("#picture svg")) === null);
await strange.evaluate(() => { location.hash = "#g-star=3&label=" + encodeURIComponent("<b id=x>&\"") + "&also=yuong%3D1"; });
await strange.waitForFunction(() => document.querySelector("#picture svg") !== null);
check("a name is no markup, and a curve that cannot be shown is left out", (await strange.$("#x")) === null &&
    (await textOf(strange, "#picture")).includes('<b id=x>&"') && (await textOf(strange, "#wrong")).includes("yuong=1"));
await strange.close();

// ---- sizes, light and dark, accessibility, pictures ----

async function violations(p, where) {
    await p.evaluate(axe);
    const found = await p.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
    check(`axe-core finds no violation: ${where}`, found.violations.length === 0 && found.passes.length > 20,
        found.violations.map((v) => `${v.id}: ${v.help}\n${v.nodes.map((n) => n.html.slice(0, 200)).join("\n")}`).join("\n"));
}
const light = [{ name: "prefers-color-scheme", value: "light" }], dark = [{ name: "prefers-color-scheme", value: "dark" }];
const query = "#young=7e10&poisson=0.24&radius=5e-3&density=2500&restitution=0.9&at=1&speed=0.1,1,10&label=glass";
await page.emulateMediaFeatures(light);
await page.goto("about:blank");
await page.goto(`${home}${query}&for=lammps`);
await page.waitForSelector("html[data-ready]");
await violations(page, "light");
if (write)
    writeFileSync("docs/web/desk.png", await page.screenshot());
await page.emulateMediaFeatures(dark);
await page.select("#for", "");
await page.select("#overlay", "steel");
await page.select("#overlay", "aluminium oxide");
await violations(page, "dark, three materials");
check("dark has another background", await page.evaluate(() => getComputedStyle(document.body).backgroundColor) === "rgb(22, 24, 29)");
await page.emulateMediaFeatures(light);
await type("restitution", "1.9");
await violations(page, "wrong input");
await page.setViewport({ width: 360, height: 740, isMobile: true, hasTouch: true });
await enter({ ...glass, for: "lammps" });
await page.waitForFunction(() => document.querySelector("#picture svg").getAttribute("width") < 360);
check("360 pixels: nothing sticks out, and the picture is drawn for them", await page.evaluate(() =>
    document.documentElement.scrollWidth <= 360 && [...document.querySelectorAll("#picture text")]
        .every((text) => text.getBoundingClientRect().right <= 360)));
await violations(page, "360 pixels");

check("no error in the console", complaints.length === 0, complaints.join("\n"));
const outside = requests.filter((url) => !url.startsWith(home) && !/^(data:|blob:|about:)/.test(url));
check("no request leaves the file", requests.length > 3 && outside.length === 0, outside.join("\n"));
await browser.close();
finish();
