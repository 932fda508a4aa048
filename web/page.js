// SPDX-License-Identifier: MIT
// The page: reads its fields, asks the module, and draws. web/run puts web/cor.js before this file.
import { load } from "./cor.js";

const $ = (id) => document.getElementById(id);
const all = (selector, from = document) => [...from.querySelectorAll(selector)];
const MATERIALS = JSON.parse($("materials-known").textContent), TERMS = new Map(JSON.parse($("glossary").textContent));
const SHOWN = 4, TEXT_DIGITS = 6, CSV_DIGITS = 12, POINTS = 121, KEPT = 5;
const FIRST = "restitution=0.9&at=1&speed=0.1";
const OWN = ["label", "points", "materials"]; // options that the module does not have
const COLUMNS = ["young", "poisson", "density", "radius", "restitution", "at"]; // columns of a material, after its name
const PREFIXES = { n: -9, u: -6, "\u00b5": -6, "\u03bc": -6, m: -3, c: -2, k: 3, M: 6, G: 9 };

let cor, units; // the module; units by option
const fields = new Map(); // by option: { input, label, list, word }
let kept = [], past = [], settled = ""; // addresses of other curves, addresses for undo, the present address
let drawn = null, telling; // the picture's curves and scales; the timer that removes a message

// ---- from text to numbers in SI units ----

const unitOf = (option) => units.get(option) ?? "";
const plainUnit = (text) => text.replace(/\s+/g, "").replace(/\u00b2/g, "^2").replace(/\u00b3/g, "^3")
    .replace(/([a-z])([23])/g, "$1^$2");
const refusal = (text, option, choices = []) => Object.assign(new cor.CorError(text, option), { choices });

// Returns n if the suffix means 10^n of the option's unit; NaN for other suffixes.
function exponentOf(suffix, unit) {
    const given = plainUnit(suffix), base = plainUnit(unit), special = { "g/cm^3 in kg/m^3": 3, "% in ": -2 };
    if (given === base || given === "")
        return 0;
    if (unit === "kg" && given.endsWith("g"))
        return given === "g" ? -3 : (PREFIXES[given.slice(0, -1)] ?? NaN) - 3;
    return special[`${given} in ${base}`] ?? (given.slice(1) === base && base !== "" ? PREFIXES[given[0]] ?? NaN : NaN);
}

// Returns one number as text in the option's unit: "0,5 mm" is 0.5e-3. A text without digits stays as it is.
function numberOf(option, text) {
    const [, number, suffix] = text.trim()
        .match(/^([-+]?[.,]*\d[\d.,]*(?:e[-+]?\d+)?)\s*((?:[a-z%\u00b5\u03bc][^;,]*)?)$/i) ?? [];
    if (number === undefined)
        return text.trim();
    const shift = exponentOf(suffix, unitOf(option)), [digits, exponent = "0"] = number.toLowerCase().split("e");
    if (Number.isNaN(shift))
        throw refusal(`'${suffix}' is not a unit here; allowed: ${unitOf(option) || "none, %"}` +
            (unitOf(option) && ", also with the prefix n, \u00b5, m, c, k, M or G"), option);
    const e = Number(exponent) + shift, point = /^[^.,]*,[^.,]*$/.test(digits) ? digits.replace(",", ".") : digits;
    return e === 0 ? point : `${point}e${e}`;
}

// Splits a list at semicolons or spaces. "0.1,1,10" is a list, too; "1,10" may be one number or two.
function partsOf(option, text) {
    let list = text.trim().replace(/,\s+/g, ";");
    if (/^\d+,\d+$/.test(list))
        throw refusal(`'${text}' may be one number or two. Which is it?`, option,
            [list.replace(",", "."), list.replace(",", "; ")]);
    if (!/[;\s]/.test(list) && (list.split(",").length > 2 || /[.e]/i.test(list)))
        list = list.replace(/,/g, ";");
    return list.split(/\s*;\s*|\s+(?=[-+.\d])/).filter((part) => part !== "");
}

function valueOf(option, text) {
    const { list, word } = fields.get(option) ?? {};
    return word ? text : list ? partsOf(option, text).map((part) => numberOf(option, part)).join(",")
        : numberOf(option, text);
}

// Returns the options of an address as the module reads them.
const toModule = (options) => Object.fromEntries([...options].filter(([option]) => !OWN.includes(option))
    .map(([option, text]) => [option, valueOf(option, text)]));

// Returns the measured points of a text: [speed, eps, uncertainty]
const pointsOf = (text) => text.split("\n").map((line) => line.trim()).filter((line) => line !== "").map((line) => {
    const point = line.split(/[;\s]+/).map((part) => Number(part.replace(",", ".")));
    if (!(point[0] > 0 && point[1] >= 0 && point.every(Number.isFinite)))
        throw refusal(`'${line.slice(0, 40)}' is not a speed and an eps with a space between them, such as 0.1 0.9`,
            "points");
    return point;
});

// Returns the lines for several materials. A cell without a digit, such as the radius of a wall, is NaN.
function blockOf(text) {
    const rows = text.replace(/\0/g, " ").trim().split("\n").map((line) => line.split(";").map((cell) => cell.trim()));
    if (rows.length > 8)
        throw refusal("at most 8 materials and walls are allowed", "materials");
    const names = rows.map(([name], i) => name || `material ${i + 1}`).join("\n");
    return cor.page.block(names, rows.flatMap(([, ...cells]) => COLUMNS.map((column, i) =>
        /\d/.test(cells[i] ?? "") ? Number(numberOf(column, cells[i])) : NaN)));
}

// ---- fields ----

const materialNow = () => MATERIALS.find(({ name }) => name === $("bodies").value);
const kind = () => materialNow() ? "bodies" : $("bodies").value;

function element(name, text, more = {}) {
    return Object.assign(document.createElement(name), { textContent: text, ...more });
}

// Fills an element that has data-field with a label, an input and the text of converted().
function makeField(place) {
    const { field: id, list, word, lines, empty = "" } = place.dataset, label = place.textContent, unit = unitOf(id);
    const inline = place.tagName === "SPAN", full = unit === "" ? label : `${label}, ${unit}`;
    const input = element(lines === undefined ? "input" : "textarea", "",
        { id, spellcheck: false, placeholder: empty });
    if ([list, word, lines].every((other) => other === undefined))
        input.inputMode = "decimal";
    if (inline)
        input.setAttribute("aria-label", full);
    place.replaceChildren(inline ? "" : element("label", full, { htmlFor: id }), input,
        element("span", "", { className: "as", id: `${id}-as` }));
    addField(input, label, { inline, list: list !== undefined, word: word !== undefined || lines !== undefined });
}
function addField(input, label, more) {
    input.parentElement.append(element("span", "", { className: "error", id: `${input.id}-wrong` }));
    input.setAttribute("aria-describedby", `${input.id}-wrong`);
    fields.set(input.id, { input, label, ...more });
}

// Adds a button that explains terms of the glossary.
function addHelp(place) {
    const terms = place.dataset.term.split("|"), term = terms.join(" and ");
    const text = terms.map((each) => `${each}: ${TERMS.get(each)}`).join(". ");
    const button = element("button", "?", { type: "button", className: "term" });
    const help = element("span", text, { className: "help", hidden: true });
    Object.assign(button, { ariaLabel: `Meaning of ${term}`, ariaExpanded: "false", onclick() {
        help.hidden = !help.hidden;
        button.ariaExpanded = String(!help.hidden);
    } });
    if (place.tagName === "P")
        place.append(button, help);
    else
        (place.tagName === "LABEL" ? place : place.querySelector(".as")).after(button, help);
}

function showFields() {
    const now = { kind: kind(), second: kind() === "bodies" ? $("second").value : "like", way: $("way").value };
    for (const part of all("[data-when]")) {
        const [name, allowed] = part.dataset.when.split("=");
        part.hidden = !allowed.split("|").includes(now[name]);
    }
    $("simulation").hidden = $("for").value === "";
    $("about-bodies").textContent = now.kind !== "none" ? materialNow()?.about ?? "" : "eps needs no material. " +
        "Duration, force, time step and the lines of most simulators need spheres or a spring: choose them as the " +
        "first word of the question.";
    for (const fold of all("details[data-none]")) {
        const state = fold.querySelector(".state") ?? fold.querySelector("summary")
            .appendChild(element("span", "", { className: "state" }));
        state.textContent = all("input, select, textarea", fold)
            .filter((e) => !e.closest("[hidden]") && (e.value !== "" || (e.tagName === "SELECT" && !fold.dataset.none)))
            .map(stateOf).join(", ") || fold.dataset.none;
    }
    for (const name of fields.keys())
        if ($(`${name}-as`))
            $(`${name}-as`).textContent = converted(name);
    if (kept.length > 0)
        $("compare").querySelector(".state").textContent = `${kept.length} more`;
}
function stateOf(input) {
    if (input.tagName === "SELECT")
        return input.selectedOptions[0].text;
    return input.tagName === "TEXTAREA" ? `lines: ${input.value.trim().split("\n").length}`
        : `${fields.get(input.id).label} ${input.value} ${/[a-z%]$/i.test(input.value) ? "" : unitOf(input.id)}`.trim();
}

// Returns the text next to a field. An input with a unit, a percent sign or a comma is converted to SI units. Otherwise
// the text is the unit, or "" if the label contains the unit.
function converted(name) {
    const { input, word, inline } = fields.get(name);
    if (word || !/[a-z%,\u00b5\u03bc]/i.test(input.value.replace(/\de[-+]?\d/gi, "")))
        return inline ? unitOf(name) : "";
    try {
        const plain = valueOf(name, input.value).split(",").map((number) => String(Number(number))).join("; ");
        return plain.includes("NaN") ? "" : `= ${plain} ${unitOf(name)}`;
    } catch {
        return ""; // the message is next to the field
    }
}

function optionsNow() {
    const options = new URLSearchParams();
    for (const [name, { input }] of fields)
        if (input.value.trim() !== "" && !input.closest("[hidden]"))
            options.set(name, input.value.trim());
    if (kind() === "bodies" && $("second").value === "wall")
        options.set("wall", "yes");
    return options;
}

// Fills the fields from an address. The choices of bodies, second body and damping follow from the given options.
function fill(options) {
    const has = (...names) => names.some((name) => options.has(name));
    for (const [name, { input }] of fields) {
        input.value = options.get(name) ?? "";
        if (input.selectedIndex < 0) // a selection without this choice
            input.value = "";
    }
    $("bodies").value = MATERIALS.find((material) => ["young", "poisson", "density"]
        .every((name) => Number(options.get(name)) === Number(material[name])))?.name ??
        (has("young", "poisson", "radius", "density", "mass", "wall") ? "bodies"
            : has("stiffness", "effective-mass", "duration") ? "spring" : "none");
    $("second").value = has("wall") ? "wall" : has("plate-thickness") ? "plate"
        : [...options.keys()].some((name) => name.endsWith("-2")) ? "other" : "like";
    $("way").value = [...$("way").options].find(({ value }) => has(value))?.value ?? (options.get("law") === "plate" ? "none" : "restitution");
}

// ---- tables and messages ----

const csv = (text) => text.trimEnd().split("\n").map((line) => line.split(","));
const tabs = (text) => text.trimEnd().split("\n").filter((line) => line !== "").map((line) => line.split("\t"));

// Returns the name of a column in words: "duration_s_zero_overlap" becomes "duration, zero overlap, s".
function headOf(name) {
    const [, start, unit, end] = name
        .match(/^(.*?)(?:_(s|m|n|pa|m_s))?(?:_(zero_overlap|zero_force|surface|tail|largest_pull))?$/);
    const words = start.replace("step_bias", "mean_error_of_eps_by_the_step").replace("step_scatter", "its_scatter")
        .replace(/^max_/, "largest_").replace("measured_end", "eps_measured_at").replace(/^value$/, "if_measured_at");
    return [words, end, { m_s: "m/s", n: "N", pa: "Pa" }[unit] ?? unit].filter((part) => part).join(", ")
        .replace(/_/g, " ").replace("measured at,", "measured at");
}

function table(id, head, rows) {
    const made = document.createElement("table"), body = made.createTBody();
    made.createTHead().insertRow().append(...head.map((name) => element("th", headOf(name), { scope: "col" })));
    for (const row of rows)
        body.insertRow().append(...row
            .map((text) => element("td", text, { className: text.length > 24 ? "words" : "" })));
    $(id).replaceChildren(made);
}

// Returns a refusal in the words of the page: "--at" becomes the label of the field.
const inWords = (text) => text.includes("corgen") ? text : text.replace(/^--[a-z0-9-]+: /, "")
    .replace(/--([a-z][a-z0-9-]*)( [A-Z][A-Z0-9,]+\b)?/g,
        (option, name) => fields.has(name) ? `\u201c${fields.get(name).label}\u201d` : option);

function showWrong(error) {
    const shown = fields.get(error?.option)?.input, place = shown?.closest("[hidden]") ? undefined : shown;
    for (const { input } of fields.values()) {
        input.toggleAttribute("aria-invalid", false);
        $(`${input.id}-wrong`).textContent = "";
    }
    $("wrong").textContent = error && !place ? inWords(error.message) : "";
    $("form").classList.toggle("old", error !== null);
    if (!place)
        return;
    place.setAttribute("aria-invalid", "true");
    place.closest("details")?.setAttribute("open", "");
    $(`${place.id}-wrong`).append(inWords(error.message), ...(error.choices ?? []).map((choice) =>
        element("button", choice, { type: "button", onclick() {
            place.value = choice;
            change();
        } })));
}

// ---- the answer ----

const shortOf = (text, digits = SHOWN) => text === "nan" ? text : Number(text).toPrecision(digits);

// Returns a number with the prefix of its unit: 3.72e-5 s is 37.20 µs.
function withUnit(text, unit) {
    const x = Number(text), at = Math.max(-3, Math.min(3, Math.floor(Math.log10(Math.abs(x)) / 3)));
    return Number.isFinite(at) && x > 0 && x < Infinity
        ? `${(x / 1000 ** at).toPrecision(SHOWN)} ${["n", "\u00b5", "m", "", "k", "M", "G"][at + 3]}${unit}`
        : `${text} ${unit}`;
}

// Returns the results for each speed and end. If eps was measured at an unknown end, each end has its own contact.
function answers() {
    const [head, ...rows] = csv(cor.page.text("table", SHOWN, 0)), chosen = $("end").value.replace("-", "_");
    const ends = head.filter((name) => name.startsWith("eps_")).map((name) => name.slice(4)), found = new Map();
    for (const row of rows) {
        const of = (name) => row[head.indexOf(name)], here = of("measured_end")?.replace("-", "_") ?? chosen;
        for (const end of ends.filter((end) => here === "" || here === end))
            found.set(row[0], [...found.get(row[0]) ?? [], { end: end.replace("_", " "), eps: shortOf(of(`eps_${end}`)),
                duration: of(`duration_s_${end}`), force: of("max_force_n") }]);
    }
    return [...found];
}

// Shows eps for each speed, the first one in large letters. Shows both ends only if their digits differ.
function showAnswer() {
    const lines = answers().flatMap(([speed, ends], line) => {
        const known = ends.filter(({ eps }) => eps !== "nan"), same = known.every(({ eps }) => eps === known[0].eps);
        const shown = known.length === 0 ? [{ eps: "not known" }] : same ? known.slice(0, 1) : known;
        const made = element("p", "", { className: line === 0 ? "big" : "" });
        made.append(line === 0 ? "" : `At ${speed} m/s: `, "eps\u00a0=\u00a0", ...shown.flatMap(({ eps, end }, i) =>
            [i > 0 ? " " : "", eps, " ", element("small", same ? "" : `at ${end}${i > 0 ? "" : ","}`)]));
        const values = (name, unit) => [...new Set(shown.map((end) => end[name] ?? "nan"))]
            .filter((text) => text !== "nan").map((text) => withUnit(text, unit)).join(" or ");
        const duration = values("duration", "s"), force = values("force", "N");
        return line > 0 ? [made] : [made, element("p", [duration && `Duration ${duration}`,
            force && `largest force ${force}`].filter((text) => text).join(", ") ||
            "Duration and force need spheres or a spring: choose them as the first word of the question.")];
    });
    $("two-ends").hidden = !lines.some((line) => /at zero force/.test(line.textContent));
    $("answer").replaceChildren(...(lines.length > 0 ? lines : [element("p", "Enter an impact speed.")]));
}

// ---- the picture ----

// The style rules of the svg, which a saved file contains, too. Each curve has a colour for light and one for dark.
const COLOURS = [["#0060ad", "#6cb4f5"], ["#b83a14", "#ff8a5c"], ["#2f7029", "#7fc97a"], ["#7b3f99", "#c79be0"],
    ["#7d5c05", "#e0b84c"], ["#0a6b6b", "#5fd0d0"], ["#a3286b", "#ff8cc3"], ["#555555", "#bbbbbb"]];
const rules = (mode, text, page, grid, axis) => `.b,.p{fill:${page}}.t{fill:${text};font:13px system-ui,sans-serif}` +
    `.g{stroke:${grid}}.a{stroke:${axis}}.l{paint-order:stroke;stroke:${page};stroke-width:4px}` +
    COLOURS.map((pair, i) => `.c${i}{stroke:${pair[mode]}}.t${i}{fill:${pair[mode]}}`).join("");
const STYLE = "<style>path,circle{fill:none}.c,.k{stroke-width:2}.m{stroke-dasharray:2 4;stroke-linecap:round}" +
    `${rules(0, "#222", "#fff", "#ddd", "#555")}@media screen and (prefers-color-scheme:dark){` +
    `${rules(1, "#ddd", "#16181d", "#3a3d44", "#aaa")}}</style>`;
const escaped = (text) => text.replace(/[<&"]/g, (c) => `&#${c.charCodeAt(0)};`);

// Adds the curves of the last request. The last speed is the user's. Models that give the same eps share a curve.
function addCurves(curves, speeds, label, other = false) {
    const own = curves.length, ends = tabs(cor.page.text("curves"));
    const [[asked], ...models] = tabs(cor.page.text("models", 3));
    const names = [...ends.map(([name]) => name.replace("_", " ")),
        ...models.map(([number, , , , , gives]) =>
            `${$("for").selectedOptions[0].text} ${number}: asked ${asked}, gives ${shortOf(gives, 3)}`)];
    for (const [i, name] of names.entries()) {
        const eps = [...cor.page.curve(speeds, i)], here = eps.pop(), model = i >= ends.length;
        const unlike = (curve) => eps.some((e, k) => Math.abs(e - curve.eps[k]) > 2e-4);
        if (!model || (eps.some((e) => e >= 0) && curves.slice(own).every(unlike)))
            curves.push({ eps, here, main: !model && !other, model, label: label ? `${label}, ${name}` : name,
                colour: (other ? 79 - curves.length : curves.length) % COLOURS.length });
    }
}

// Returns the speed at a place of the logarithmic axis: least at 0, most at 1.
const between = (least, most, place) => Math.exp((1 - place) * Math.log(least) + place * Math.log(most));

function makeCurves(options) {
    const given = toModule(options);
    const least = Number(given["speed-min"] ?? 1e-3), most = Number(given["speed-max"] ?? 10);
    const speeds = Array.from({ length: POINTS }, (_, k) => between(least, most, k / (POINTS - 1)));
    const first = Number((given.speed ?? "").split(",")[0]), curves = [], others = [];
    const points = pointsOf(options.get("points") ?? "");
    if (given.restitution && given.at)
        points.push([Number(given.at), Number(given.restitution)]);
    for (const [i, other] of kept.map((text) => new URLSearchParams(text)).entries()) {
        cor.page.read(toModule(other));
        addCurves(others, [...speeds, first], other.get("label") ?? `curves ${i + 1}`, true);
    }
    cor.page.read(given);
    addCurves(curves, [...speeds, first], options.get("label"));
    return { speeds, least, most, first, curves: [...curves, ...others],
        points: points.filter(([speed]) => speed >= least && speed <= most) };
}

function ticks(least, most) {
    const step = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1].find((s) => (most - least) / s <= 6) ?? 0.2;
    const first = Math.ceil(least / step - 1e-9), count = Math.floor(most / step + 1e-9) - first + 1;
    return Array.from({ length: count }, (_, i) => Number(((first + i) * step).toFixed(3)));
}

function speedTicks(least, most, width) {
    const decades = Math.log10(most) - Math.log10(least), found = [];
    const stride = Math.max(Math.ceil(decades * 48 / width), 1);
    for (let e = Math.floor(Math.log10(least)); e <= Math.log10(most) + 1e-9; e++)
        if (e % stride === 0)
            found.push(...(decades < 2.5 ? [1, 2, 5] : [1]).map((digit) => Number(`${digit}e${e}`)));
    return found.filter((speed) => speed >= least * 0.999 && speed <= most * 1.001);
}

function showPicture() {
    const { speeds, least, most, curves, points } = drawn, width = Math.max($("picture").clientWidth, 280);
    const below = Math.min(Math.max(0.55 * width, 240), 400), wide = width > 640, at = (v) => v.toFixed(1);
    const box = { left: 46, right: width - (wide ? 250 : 14), top: 34, bottom: below - 42 };
    const height = below + (wide ? 0 : 18 * curves.length);
    const values = [...curves.flatMap(({ eps }) => eps), ...points.flatMap(([, eps, u = 0]) => [eps - u, eps + u])]
        .filter((eps) => !Number.isNaN(eps));
    let low = Math.min(...values), high = Math.max(...values);
    if (high - low < 0.01)
        [low, high] = [Math.max(low - 0.02, 0), Math.min(high + 0.02, Math.max(1, high))];
    const x = (speed) => box.left + (box.right - box.left) *
        (Math.log(speed) - Math.log(least)) / (Math.log(most) - Math.log(least));
    const y = (eps) => box.bottom - (box.bottom - box.top) * (eps - low) / (high - low);
    const text = (x, y, words, anchor = "middle", more = "") =>
        `<text class="t${more}" text-anchor="${anchor}" x="${at(x)}" y="${at(y)}">${escaped(String(words))}</text>`;
    const out = [`<rect class="b" width="100%" height="100%"/>`];
    for (const speed of speedTicks(least, most, box.right - box.left))
        out.push(`<path class="g" d="M${at(x(speed))} ${box.top}V${box.bottom}"/>`,
            text(x(speed), box.bottom + 18, speed));
    for (const eps of ticks(low, high))
        out.push(`<path class="g" d="M${box.left} ${at(y(eps))}H${box.right}"/>`,
            text(box.left - 6, y(eps) + 4, eps, "end"));
    out.push(`<path class="a" d="M${box.left} ${at(y(high))}V${box.bottom}H${box.right}"/>`,
        text(4, 14, "eps", "start"), text((box.left + box.right) / 2, below - 6, "impact speed, m/s"));
    const labels = [];
    for (const curve of curves) {
        const known = curve.eps.map((eps) => !Number.isNaN(eps)), last = known.lastIndexOf(true);
        const path = curve.eps.map((eps, k) =>
            known[k] ? `${known[k - 1] ? "L" : "M"}${at(x(speeds[k]))} ${at(y(eps))}` : "").join("");
        out.push(`<path class="c c${curve.colour}${curve.model ? " m" : ""}" d="${path}"/>`);
        if (last >= 0)
            labels.push({ ...curve, x: x(speeds[last]), y: y(curve.eps[last]) });
    }
    for (const [speed, eps, u = 0] of points)
        out.push(u > 0 ? `<path class="a" d="M${at(x(speed))} ${at(y(eps - u))}V${at(y(eps + u))}"/>` : "",
            `<circle class="a p" cx="${at(x(speed))}" cy="${at(y(eps))}" r="4"/>`);
    // Labels are next to the ends of the curves on a wide screen, otherwise below the picture. They do not overlap.
    labels.sort((a, b) => a.y - b.y).forEach((label, i) => {
        label.at = wide ? Math.max(label.y + 4, i > 0 ? labels[i - 1].at + 15 : 28) : below + 14 + 18 * i;
    });
    labels.reduceRight((end, label) => (label.at = Math.min(label.at, end)) - 15, wide ? box.bottom - 2 : height);
    for (const { x, at: y, label, colour, model } of labels)
        out.push(wide ? "" : `<path class="k c${colour}${model ? " m" : ""}" d="M${box.left} ${at(y - 4)}h30"/>`,
            text(wide ? x + 8 : box.left + 38, y, label, "start", ` l t${colour}`));
    const title = escaped(`eps over the impact speed: ${curves.map(({ label, eps }) =>
        `${label} from ${eps[0].toPrecision(3)} to ${eps.at(-1).toPrecision(3)}`).join("; ")}`);
    $("picture").innerHTML = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
        `viewBox="0 0 ${width} ${height}" role="group" aria-label="${title}"><title>${title}</title>${STYLE}` +
        `<g aria-hidden="true">${out.join("")}</g>${markOf(drawn, x, y, box, text)}</svg>`;
    drawn.box = box;
}

// Returns the mark at the user's speed, which a pointer or the arrow keys move.
function markOf({ first, least, most, curves }, x, y, box, text) {
    if (!(first >= least && first <= most))
        return "";
    const own = curves.filter(({ main, here }) => main && !Number.isNaN(here)), at = x(first);
    const texts = [...new Set(own.map(({ here }) => here.toPrecision(SHOWN)))];
    const value = `${first} m/s: ${texts.join(", ")}`;
    const left = at < (box.left + box.right) / 2;
    return `<g id="mark" tabindex="0" role="slider" aria-label="Impact speed" aria-valuemin="${least}" ` +
        `aria-valuemax="${most}" aria-valuenow="${first}" aria-valuetext="${value}" style="cursor:ew-resize">` +
        `<path class="a" d="M${at} ${box.top}V${box.bottom}"/><rect x="${at - 14}" y="${box.top - 14}" width="28" ` +
        `height="${box.bottom - box.top + 14}" fill="transparent"/>` +
        own.map(({ here, colour }) => `<circle class="c c${colour} p" cx="${at}" cy="${y(here)}" r="5"/>`).join("") +
        `${text(at + (left ? 4 : -4), box.top - 4, value, left ? "start" : "end", " l")}</g>`;
}
function moveTo(speed) {
    const [, ...others] = partsOf("speed", `${$("speed").value};`);
    const within = Math.min(Math.max(speed, drawn.least), drawn.most);
    $("speed").value = [Number(within.toPrecision(3)), ...others].join("; ");
    update();
}

function listenToMark() {
    const picture = $("picture"), speedAt = (x) => between(drawn.least, drawn.most,
        (x - picture.getBoundingClientRect().left - drawn.box.left) / (drawn.box.right - drawn.box.left));
    picture.addEventListener("pointerdown", (event) =>
        event.target.closest("#mark") && picture.setPointerCapture(event.pointerId));
    picture.addEventListener("pointermove", (event) =>
        picture.hasPointerCapture(event.pointerId) && moveTo(speedAt(event.clientX)));
    picture.addEventListener("lostpointercapture", settle);
    picture.addEventListener("keydown", (event) => {
        const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -20, PageUp: 20,
            Home: -Infinity, End: Infinity }[event.key];
        if (step === undefined)
            return;
        event.preventDefault();
        moveTo(drawn.first * 1.05 ** step);
        $("mark").focus();
        settle();
    });
}

// ---- everything else that is shown ----

function showSimulator() {
    const [[eps, speed, end], ...models] = tabs(cor.page.text("models", TEXT_DIGITS));
    const short = (text) => Number(Number(text).toPrecision(3)), title = $("for").selectedOptions[0].text;
    const [, model, , , , gives, set] = models[0] ?? [], same = short(gives) === short(eps) || set === "nan";
    $("gives").textContent = !model ? `No model of ${title} has an input e: the lines set the damping directly.`
        : gives === "nan" ? `${title}, ${model}, refuses e = ${short(eps)}.`
            : `${title}, ${model}: e = ${short(eps)} gives eps = ${short(gives)} at ${speed} m/s.` +
                (same ? "" : ` For eps = ${short(eps)} at ${end} set e = ${short(set)}.`);
    table("models", ["number", "model", "version", "law", "contact ends at", `eps for e = ${eps}`, "e to set"], models);
    $("models").parentElement.hidden = models.length === 0;
    let lines = "", why = "";
    try {
        lines = $("materials").value.trim() === "" ? cor.page.text("lines", 1) : blockOf($("materials").value);
    } catch (error) {
        why = error.message;
    }
    $("lines").textContent = lines;
    $("lines").hidden = document.querySelector("[data-copy=lines]").hidden = lines === "";
    $("lines-wrong").textContent = inWords(why);
}

function showResults() {
    const [head, ...rows] = csv(cor.page.text("table", TEXT_DIGITS, 1)), end = head.indexOf("measured_end");
    const order = (row) => end < 0 ? row : [row[end], ...row.filter((_, i) => i !== end)];
    const { integrator } = $("for").selectedOptions[0];
    showAnswer();
    table("impacts", order(head), rows.map(order));
    $("step-error").textContent = integrator === "" ? "cor cannot compute the error by the time step of this simulator."
        : `The error of eps by the time step is for ${integrator}: mean and standard deviation over the phases of ` +
            "the first step. nan: not known, or over 20,000 steps in the contact.";
    const [summaryHead, ...summary] = csv(cor.page.text("summary", TEXT_DIGITS));
    table("summary", summaryHead, summary);
    for (const name of ["header", "command"])
        $(name).textContent = cor.page[name](toModule(optionsNow()));
    if ($("for").value !== "")
        showSimulator();
}

function showKept() {
    $("kept").replaceChildren(...kept.map((text, i) => {
        const label = new URLSearchParams(text).get("label") ?? `curves ${i + 1}`, item = element("li", label);
        item.append(element("button", "Remove", { type: "button", ariaLabel: `Remove ${label}`, onclick() {
            kept.splice(i, 1);
            change();
        } }));
        return item;
    }));
    $("keep").disabled = kept.length >= KEPT;
}

function update() {
    showFields();
    const options = optionsNow();
    try {
        drawn = makeCurves(options);
    } catch (error) {
        if (!(error instanceof cor.CorError))
            throw error;
        showWrong(error);
        return;
    }
    showWrong(null);
    showKept();
    showResults();
    showPicture();
    history.replaceState(null, "", "#" + new URLSearchParams([...options, ...kept.map((text) => ["also", text])]));
}

// Remembers the address before a change that is complete, so that it can be undone.
function settle() {
    if (location.hash !== settled)
        past.push(settled);
    settled = location.hash;
    $("undo").disabled = past.length === 0;
}
const change = () => settle(update());

function isRight(text) {
    try {
        return cor.page.read(toModule(new URLSearchParams(text))) > 0;
    } catch {
        return false;
    }
}

function fromAddress(hash) {
    const options = new URLSearchParams(hash.length > 1 ? hash.slice(1) : FIRST), others = options.getAll("also");
    kept = others.filter(isRight).slice(0, KEPT);
    options.delete("also");
    fill(options);
    update();
    const lost = [...options].find(([name, value]) => name !== "wall" && fields.get(name)?.input.value !== value)
        ?.join("=") ?? others.find((text) => !kept.includes(text));
    if (lost !== undefined)
        $("wrong").textContent = `The address has '${lost.slice(0, 60)}', which this page cannot show and leaves out.`;
}

function keepCurves() {
    const options = optionsNow();
    for (const name of ["for", "simulator-version", "speed", "steps", "speed-min", "speed-max", "tolerance", "points"])
        options.delete(name);
    if (isRight(String(options)))
        kept.push(String(options));
    $("label").value = "";
    change();
}

function chooseBodies() {
    const material = materialNow();
    if (material)
        for (const name of ["young", "poisson", "density", "radius", "mass"])
            $(name).value = material[name] ?? (name === "radius" ? $("radius").value || "5 mm" : "");
    $("fold-bodies").open = $("fold-bodies").open || (!material && kind() !== "none");
}

// Makes law, second body and damping consistent. A plate has its own law, and waves in the plate take the energy.
function fitPlate(id) {
    const plate = $(id).value === "plate", put = (id, other) => {
        $(id).value = plate ? id === "way" ? "none" : "plate" : /plate|none/.test($(id).value) ? other : $(id).value;
    };
    if (plate && kind() !== "bodies")
        $("bodies").value = "bodies";
    put("second", "like");
    put("law", "");
    put("way", "restitution");
}

// ---- saving and copying ----

function save(name, content) {
    const link = element("a", "", { href: URL.createObjectURL(new Blob([content])), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    tell(`${name} is saved.`);
}

function savePng() {
    const svg = $("picture").firstChild, image = Object.assign(new Image(), { onload() {
        const size = { width: 2 * svg.clientWidth, height: 2 * svg.clientHeight };
        const canvas = Object.assign(document.createElement("canvas"), size);
        canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
        canvas.toBlob((blob) => save("restitution.png", blob));
    } });
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent($("picture").innerHTML)}`;
}

function curvesText() {
    const digits = (v) => Number.isNaN(v) ? "nan" : String(Number(v.toPrecision(CSV_DIGITS)));
    const head = ["speed_m_s", ...drawn.curves.map(({ label }) => `"${label.replace(/"/g, '""')}"`)];
    return [head, ...drawn.speeds.map((speed, k) => [speed, ...drawn.curves.map(({ eps }) => eps[k])].map(digits))]
        .map((row) => row.join(",") + "\n").join("");
}

// Shows a text for five seconds.
function tell(text) {
    $("said").textContent = text;
    clearTimeout(telling);
    telling = setTimeout(() => $("said").replaceChildren(), 5000);
}

async function copy(text, said) {
    try {
        await navigator.clipboard.writeText(text);
        tell(said);
    } catch {
        const area = document.body.appendChild(element("textarea", text));
        area.select();
        tell(document.execCommand("copy") ? said : "This browser cannot copy from a page; select the text yourself.");
        area.remove();
    }
}

// ---- start ----

function listen() {
    const on = (id, act, event = "click") => $(id).addEventListener(event, act);
    $("bodies").options[0].after(...MATERIALS
        .map(({ name }) => new Option(`${name[0].toUpperCase()}${name.slice(1)} spheres`, name)));
    for (const [option, name, label, integrator] of csv(cor.page.text("choices")))
        $(option).add(Object.assign(new Option(label, name === "viscoelastic" ? "" : name), { integrator }));
    $("terms").append(...[...TERMS].flatMap(([term, meaning]) => [element("dt", term), element("dd", meaning)]));
    on("form", (event) => event.preventDefault(), "submit");
    on("bodies", chooseBodies, "input");
    on("second", () => fitPlate("second"), "input");
    on("law", () => fitPlate("law"), "input");
    on("form", update, "input");
    on("form", settle, "change");
    on("keep", keepCurves);
    on("share", () => copy(location.href, "The address of this page with its input is copied."));
    on("reset", () => settle(fromAddress("")));
    on("undo", () => {
        fromAddress(past.pop());
        settle(settled = location.hash);
    });
    on("save-svg", () => save("restitution.svg", $("picture").innerHTML));
    on("save-png", savePng);
    on("save-csv", () => save("curves.csv", curvesText()));
    on("save-impacts", () => save("impacts.csv", cor.page.text("table", CSV_DIGITS, 1)));
    for (const button of all("[data-copy]"))
        button.onclick = () => copy($(button.dataset.copy).textContent, "The text is copied.");
    listenToMark();
    addEventListener("hashchange", () => settle(fromAddress(location.hash)));
    new ResizeObserver(() => drawn && showPicture()).observe($("plot"));
}

// Unpacks the module in the page: base 85 with the digits of RFC 1924, then deflate.
async function unpack({ textContent: text, dataset }) {
    const digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~";
    const of = new Map([...digits].map((digit, i) => [digit, i])), words = text.length / 5;
    const bytes = new DataView(new ArrayBuffer(4 * words));
    for (let i = 0; i < words; i++) {
        let word = 0;
        for (let k = 0; k < 5; k++)
            word = 85 * word + of.get(text[5 * i + k]);
        bytes.setUint32(4 * i, word);
    }
    const packed = new Blob([new Uint8Array(bytes.buffer, 0, Number(dataset.bytes))]);
    return new Response(packed.stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

cor = await load(await unpack($("wasm")));
units = new Map(csv(cor.page.text("options")));
all("[data-field]").forEach(makeField);
all("select[data-option]").forEach((select) => addField(select, select.labels[0].textContent, { word: true }));
all("[data-term]").forEach(addHelp);
listen();
fromAddress(location.hash);
settled = location.hash;
document.documentElement.dataset.ready = String(performance.now());
