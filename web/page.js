// SPDX-License-Identifier: MIT
// The page: reads its fields, asks the module, and draws. web/run puts web/cor.js before this file.
import { load } from "./cor.js";

const $ = (id) => document.getElementById(id), all = (selector, from = document) => [...from.querySelectorAll(selector)];
const stored = (id) => JSON.parse($(id).textContent);
const MATERIALS = stored("materials"), TERMS = new Map(stored("glossary"));
const SHOWN = 4, TEXT_DIGITS = 6, CSV_DIGITS = 12, POINTS = 121, KEPT = 5;
const FIRST = "restitution=0.9&at=1&speed=0.1";
const WAYS = ["restitution", "g-star", "dissipation-time", "viscosity", "damping-coefficient", "beta", "zeta"];
const OWN = ["label", "points"]; // options of the page only
const UNITS = { steps: "", "speed-min": "m/s", "speed-max": "m/s", tolerance: "", speed: "m/s" }; // others: the module's
const PREFIXES = { n: -9, u: -6, "\u00b5": -6, "\u03bc": -6, m: -3, c: -2, k: 3, M: 6, G: 9 };

let cor, fields, units, right = false;
let kept = [], past = [], settled = ""; // curves as addresses; addresses to go back to; the last one that was complete
let drawn = null; // the curves of the picture and its scales

// ---- from text to numbers in SI units ----

const unitOf = (option) => units.get(option) ?? "";
const plainUnit = (text) => text.replace(/\s+/g, "").replace(/\u00b2/g, "^2").replace(/\u00b3/g, "^3").replace(/([a-z])([23])/g, "$1^$2");

// Returns the decimal exponent of a unit in the option's unit, or NaN.
function exponentOf(suffix, unit) {
    const given = plainUnit(suffix), base = plainUnit(unit);
    if (given === base || given === "")
        return 0;
    if (unit === "kg" && given.endsWith("g"))
        return given === "g" ? -3 : (PREFIXES[given.slice(0, -1)] ?? NaN) - 3;
    if (unit === "kg/m^3" && given === "g/cm^3")
        return 3;
    if (unit === "" && given === "%")
        return -2;
    return given.slice(1) === base && unit !== "" ? PREFIXES[given[0]] ?? NaN : NaN;
}

// Returns one number as text in the option's unit: "0,5 mm" is 0.5e-3. A text without digits stays as it is.
function numberOf(option, text) {
    const [, number, suffix] = text.trim().match(/^([-+]?[\d.,]+(?:e[-+]?\d+)?)\s*(.*)$/i) ?? [];
    if (number === undefined)
        return text.trim();
    const shift = exponentOf(suffix, unitOf(option)), [digits, exponent = "0"] = number.toLowerCase().split("e");
    if (Number.isNaN(shift))
        throw new cor.CorError(`'${suffix}' is not a unit here; allowed: ${unitsOf(unitOf(option))}`, option);
    const point = digits.split(/[.,]/).length === 2 ? digits.replace(",", ".") : digits, e = Number(exponent) + shift;
    return e === 0 ? point : `${point}e${e}`;
}

function unitsOf(unit) {
    const common = { "": "none, or %", m: "m, mm, \u00b5m", "m/s": "m/s, cm/s, mm/s", Pa: "Pa, MPa, GPa", kg: "kg, g, mg", s: "s, ms, \u00b5s",
        "kg/m^3": "kg/m^3, g/cm^3" };
    return common[unit] ?? `${unit}, and with k or m in front of it`;
}

// Splits a list at semicolons or spaces. "0.1,1,10" is a list, too; "1,10" may be one number or two.
function listOf(option, text) {
    let list = text.trim().replace(/,\s+/g, ";");
    if (/^\d+,\d+$/.test(list)) {
        const error = new cor.CorError(`'${text}' may be one number or two. Which is it?`, option);
        error.choices = [list.replace(",", "."), list.replace(",", "; ")];
        throw error;
    }
    if (!/[;\s]/.test(list) && /,/.test(list) && (list.split(",").length > 2 || /[.e]/i.test(list)))
        list = list.replace(/,/g, ";");
    return list.split(/\s*;\s*|\s+(?=[-+.\d])/).filter((part) => part !== "").map((part) => numberOf(option, part)).join(",");
}

// Returns the options of an address as the module reads them.
function toModule(options) {
    const given = {};
    for (const [option, text] of options) {
        const field = fields.get(option);
        if (!OWN.includes(option))
            given[option] = field?.list ? listOf(option, text) : field?.word || field?.select ? text : numberOf(option, text);
    }
    return given;
}

function pointsOf(text) {
    return text.split("\n").map((line) => line.trim().split(/[;\s]+/).map((part) => Number(part.replace(",", "."))))
        .filter(([speed, eps]) => speed > 0 && eps >= 0);
}

// ---- fields ----

const kind = () => MATERIALS.some(({ name }) => name === $("bodies").value) ? "bodies" : $("bodies").value;

// Makes label, input, unit, help and place for a message of an element with data-field.
function makeField(place) {
    const { field: name, list, word, lines } = place.dataset, label = place.textContent, inline = place.tagName === "SPAN";
    const input = document.createElement(lines === undefined ? "input" : "textarea"), unit = unitOf(name);
    Object.assign(input, { id: name, spellcheck: false, autocomplete: "off" });
    if (lines === undefined && word === undefined && list === undefined)
        input.inputMode = "decimal";
    const texts = [label + (inline ? "" : unit === "" ? "" : `, ${unit}`)];
    place.replaceChildren(...(inline ? [] : [element("label", texts[0], { htmlFor: name })]), input,
        ...(inline && unit !== "" ? [" ", element("span", unit, { className: "unit" })] : []),
        element("span", "", { className: "as", id: `${name}-as` }), element("span", "", { className: "error", id: `${name}-wrong` }));
    if (inline)
        input.setAttribute("aria-label", unit === "" ? label : `${label}, ${unit}`);
    fields.set(name, { input, label, list: list !== undefined, word: word !== undefined || lines !== undefined });
}

function element(name, text, more = {}) {
    const made = document.createElement(name);
    made.textContent = text;
    return Object.assign(made, more);
}

// Adds a button that explains a term of the glossary.
function addHelp(place) {
    const term = place.dataset.term, text = `${term}: ${TERMS.get(term)}`;
    const button = element("button", "?", { type: "button", className: "term" }), help = element("span", text, { className: "help", hidden: true });
    button.setAttribute("aria-label", `What is ${term}?`);
    button.setAttribute("aria-expanded", "false");
    button.addEventListener("click", () => {
        help.hidden = !help.hidden;
        button.setAttribute("aria-expanded", String(!help.hidden));
    });
    if (place.tagName === "LABEL")
        place.after(button, help);
    else
        place.querySelector(".as").after(button, help);
}

function showFields() {
    const values = { kind: kind(), second: kind() === "bodies" ? $("second").value : "like", way: $("way").value };
    for (const part of all("[data-when]")) {
        const [name, allowed] = part.dataset.when.split("=");
        part.hidden = !allowed.split("|").includes(values[name]);
    }
    $("simulation").hidden = $("for").value === "";
    $("about-bodies").textContent = kind() === "none" ? "eps at a speed needs no material. Duration, force, time step and the lines of " +
        "most simulators do: choose spheres or a spring as the first word of the question." : MATERIALS.find(({ name }) => name === $("bodies").value)?.about ?? "";
}

// Shows the state of each fold next to its name, and numbers that were converted next to their fields.
function showStates() {
    const state = (fold) => all("input, select, textarea", fold).filter((e) => !e.closest("[hidden]") && e.id !== "overlay" &&
        (e.value !== "" || (e.tagName === "SELECT" && fold.dataset.none === undefined)))
        .map((e) => e.tagName === "SELECT" ? e.selectedOptions[0].text : e.tagName === "TEXTAREA" ? `${pointsOf(e.value).length} points`
            : `${fields.get(e.id).label.replace(/^Its /, "")} ${e.value}${/[a-z%]$/i.test(e.value) ? "" : ` ${unitOf(e.id)}`}`.trim()).join(", ");
    for (const fold of all("#settings details, #simulation details[data-none]")) {
        const says = fold.querySelector(".state") ?? fold.querySelector("summary").appendChild(element("span", "", { className: "state" }));
        says.textContent = (fold.id === "compare" && kept.length > 0 ? `${kept.length} kept` : state(fold)) || (fold.dataset.none ?? "");
    }
    for (const [name, { input, list, word, select }] of fields) {
        if (select)
            continue;
        let seen = "";
        try {
            seen = word || !/[a-z%,\u00b5\u03bc]/i.test(input.value.replace(/\de[-+]?\d/gi, "")) ? "" : list ? listOf(name, input.value).replace(/,/g, "; ") : numberOf(name, input.value);
        } catch { /* the message is next to the field */ }
        const plain = seen.split("; ").map((number) => String(Number(number))).join("; ");
        $(`${name}-as`).textContent = seen === "" || plain.includes("NaN") ? "" : `= ${plain} ${unitOf(name)}`;
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

// Fills the fields from an address. The selections that are no options follow from the numbers that are given.
function fill(options) {
    const has = (...names) => names.some((name) => options.has(name)), of = (name) => Number(options.get(name));
    for (const [name, { input }] of fields)
        input.value = options.get(name) ?? "";
    $("bodies").value = MATERIALS.find((m) => ["young", "poisson", "density"].every((name) => of(name) === Number(m[name])))?.name ??
        (has("young", "poisson", "radius", "density", "mass", "wall") ? "bodies"
            : has("stiffness", "effective-mass", "duration") ? "spring" : "none");
    $("second").value = has("wall") ? "wall" : has("plate-thickness") ? "plate"
        : has("young-2", "poisson-2", "radius-2", "density-2", "mass-2", "dissipation-time-2", "viscosity-2") ? "other" : "like";
    $("way").value = WAYS.find((name) => options.has(name)) ?? (options.get("law") === "plate" ? "none" : "restitution");
}

// Returns the first option of an address that no field shows.
function unknown(options) {
    return [...options].find(([name, value]) => name !== "wall" && fields.get(name)?.input.value !== value)?.join("=");
}

const addressOf = (options) => "#" + new URLSearchParams([...options, ...kept.map((text) => ["also", text])]);

// ---- tables and messages ----

const csv = (text) => text.trimEnd().split("\n").map((line) => line.split(","));
const tabs = (text) => text.trimEnd().split("\n").filter((line) => line !== "").map((line) => line.split("\t"));

// The name of a column in words: "duration_s_zero_overlap" becomes "duration, zero overlap, s"
function headOf(name) {
    const [, start, unit, end] = name.match(/^(.*?)(?:_(s|m|n|pa|m_s))?(?:_(zero_overlap|zero_force|surface|tail|largest_pull))?$/);
    const words = start.replace("step_bias", "mean_error_of_eps_by_the_step").replace("step_scatter", "its_scatter").replace(/^max_/, "largest_")
        .replace("measured_end", "eps_measured_at").replace(/^value$/, "if_measured_at");
    return [words, end, { m_s: "m/s", n: "N", pa: "Pa" }[unit] ?? unit].filter((part) => part).join(", ").replace(/_/g, " ").replace("measured at,", "measured at");
}

function table(id, head, rows) {
    const made = document.createElement("table"), top = made.createTHead().insertRow(), body = made.createTBody();
    top.append(...head.map((name) => element("th", headOf(name), { scope: "col" })));
    for (const row of rows)
        body.insertRow().append(...row.map((text) => element("td", text, { className: text.length > 24 ? "words" : "" })));
    $(id).replaceChildren(made);
}

// A refusal in the words of the page: "--at" becomes the label of the field.
const inWords = (text) => text.replace(/^--[a-z0-9-]+: /, "").replace(/--([a-z][a-z0-9-]*)( [A-Z][A-Z0-9,]+\b)?/g,
    (option, name) => fields.has(name) ? `\u201c${fields.get(name).label}\u201d` : option);

function showWrong(error) {
    let shown = error === null;
    for (const [name, { input }] of fields) {
        const mine = error !== null && name === error.option && !input.closest("[hidden]"), says = $(`${name}-wrong`);
        input.toggleAttribute("aria-invalid", mine);
        says.textContent = mine ? inWords(error.message) : "";
        if (!mine)
            continue;
        shown = true;
        input.setAttribute("aria-invalid", "true");
        input.closest("details")?.setAttribute("open", "");
        says.append(...(error.choices ?? []).flatMap((choice) => [" ", element("button", choice, { type: "button", onclick: () => {
            input.value = choice;
            update();
            settle();
        } })]));
    }
    $("wrong").textContent = shown ? "" : inWords(error.message);
    $("form").classList.toggle("old", error !== null);
}

// ---- the answer ----

// A number with the prefix of its unit: 3.72e-5 s is 37.2 µs
function withUnit(text, unit) {
    const x = Number(text), at = Math.max(-3, Math.min(3, Math.floor(Math.log10(Math.abs(x)) / 3)));
    const short = Number.isFinite(at) ? Number((x / 1000 ** at).toPrecision(SHOWN)) : x;
    return Number.isNaN(x) || unit === "" ? text : `${short} ${["n", "\u00b5", "m", "", "k", "M", "G"][(Number.isFinite(at) ? at : 0) + 3]}${unit}`;
}

// The rows of the table of impacts as objects, for each speed: those of the end at which eps was measured
function answers() {
    const [head, ...rows] = csv(cor.page.text("table", SHOWN, 0)), chosen = $("end").value.replace("-", "_");
    const ends = head.filter((name) => name.startsWith("eps_")).map((name) => name.slice(4)), found = new Map();
    for (const row of rows) {
        const of = Object.fromEntries(head.map((name, i) => [name, row[i]])), here = of.measured_end?.replace("-", "_");
        for (const end of ends.filter((end) => (here ?? (chosen || end)) === end))
            found.set(of.speed_m_s, [...found.get(of.speed_m_s) ?? [], { end: end.replace("_", " "), eps: of[`eps_${end}`],
                duration: of[`duration_s_${end}`], force: of.max_force_n, step: of.time_step_s }]);
    }
    return found;
}

function showAnswer() {
    const found = answers(), parts = [];
    for (const [speed, ends] of found) {
        const known = ends.filter(({ eps }) => eps !== "nan"), same = known.every(({ eps }) => eps === known[0].eps);
        const line = element("p", "", { className: parts.length === 0 ? "big" : "also" });
        line.append(...(parts.length === 0 ? [] : [`At ${speed} m/s: `]), ...(same ? known.slice(0, 1) : known)
            .flatMap(({ eps, end }, i) => [i > 0 ? " " : "", `${i > 0 ? "" : "eps\u00a0=\u00a0"}${eps}`, element("small", same ? "" : ` at ${end}${i > 0 ? "" : ","}`)]));
        parts.push(line);
        if (parts.length > 1)
            continue;
        const values = (name, unit) => [...new Set((same ? known.slice(0, 1) : known).map((end) => withUnit(end[name], unit)))].filter((text) => !/nan/.test(text)).join(" or ");
        const duration = values("duration", "s"), force = values("force", "N");
        parts.push(element("p", [duration && `Duration ${duration}`, force && `largest force ${force}`].filter((text) => text).join(", ") ||
            "Duration and force need spheres or a spring: choose them as the first word of the question."));
    }
    $("answer").replaceChildren(...(parts.length > 0 ? parts : [element("p", "Enter an impact speed.")]));
}

// ---- the picture ----

// Text of the svg: what the file needs to look the same on its own
const STYLE = [["#0060ad", "#6cb4f5"], ["#b83a14", "#ff8a5c"], ["#2f7029", "#7fc97a"], ["#7b3f99", "#c79be0"], ["#7d5c05", "#e0b84c"],
    ["#0a6b6b", "#5fd0d0"], ["#a3286b", "#ff8cc3"], ["#555555", "#bbbbbb"]];
const rules = (mode, text, page, grid, axis) => `.b{fill:${page}}.t{fill:${text};font:13px system-ui,sans-serif;stroke:none}.g{stroke:${grid}}.a{stroke:${axis}}` +
    STYLE.map((pair, i) => `.c${i}{stroke:${pair[mode]}}.t${i}{fill:${pair[mode]}}`).join("") + `.l{paint-order:stroke;stroke:${page};stroke-width:4px}.p{fill:${page}}`;
const SVG_STYLE = `<style>path,circle{fill:none}.c{stroke-width:2}.m{stroke-dasharray:2 4;stroke-linecap:round}${rules(0, "#222", "#fff", "#ddd", "#555")}` +
    `@media screen and (prefers-color-scheme:dark){${rules(1, "#ddd", "#16181d", "#3a3d44", "#aaa")}}</style>`;
const escaped = (text) => text.replace(/[<&"]/g, (c) => `&#${c.charCodeAt(0)};`);

// Adds the curves of the request that the module has. Models that give the same eps share a curve.
function addCurves(curves, speeds, label, colour) {
    const own = curves.length;
    for (const [i, [end, simulator, , asked, gives]] of tabs(cor.page.text("curves", 3)).entries()) {
        const eps = [...cor.page.curve(speeds, i)], near = (c) => c.eps.every((e, k) => !(Math.abs(e - eps[k]) > 2e-4));
        if (simulator && curves.slice(own).some(near))
            continue;
        const text = simulator ? `${simulator}: asked ${asked}, gives ${gives}` : end === "both_ends" ? "eps" : end.replace("_", " ");
        curves.push({ eps, i, model: Boolean(simulator), label: label ? `${label}, ${text}` : text, colour: (colour ?? curves.length) % STYLE.length });
    }
}

function makeCurves(options) {
    const given = toModule(options), least = Number(given["speed-min"] ?? 1e-3), most = Number(given["speed-max"] ?? 10);
    const speeds = Array.from({ length: POINTS }, (_, k) => least * (most / least) ** (k / (POINTS - 1))), curves = [];
    const points = options.has("points") ? pointsOf(options.get("points")) : [];
    if (options.has("restitution") && options.has("at"))
        points.push([Number(given.at), Number(given.restitution)]);
    for (const [i, text] of kept.entries()) {
        const other = new URLSearchParams(text);
        cor.page.read(toModule(other));
        addCurves(curves, speeds, other.get("label") ?? `curves ${i + 1}`, STYLE.length - 1 - i);
    }
    const others = curves.splice(0);
    cor.page.read(given);
    addCurves(curves, speeds, options.get("label") ?? "");
    return { speeds, least, most, points: points.filter(([speed]) => speed >= least && speed <= most), curves: [...curves, ...others],
        first: Number((given.speed ?? "").split(",")[0]) };
}

function ticks(least, most) {
    const step = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2].find((s) => (most - least) / s <= 6) ?? 0.2;
    return Array.from({ length: Math.floor(most / step + 1e-9) - Math.ceil(least / step - 1e-9) + 1 }, (_, i) => (Math.ceil(least / step - 1e-9) + i) * step);
}

function showPicture() {
    if (!right || drawn === null)
        return;
    const { speeds, least, most, curves, points } = drawn, width = Math.max($("picture").clientWidth, 280), height = Math.min(Math.max(0.55 * width, 240), 400);
    const values = [...curves.flatMap(({ eps }) => eps), ...points.flatMap(([, eps, u = 0]) => [eps - u, eps + u])].filter((eps) => !Number.isNaN(eps));
    let low = Math.min(...values), high = Math.max(...values);
    if (high - low < 0.01)
        [low, high] = [Math.max(low - 0.02, 0), Math.min(high + 0.02, Math.max(1, high))];
    const wide = width > 640, box = { left: 46, right: width - (wide ? 250 : 14), top: 34, bottom: height - 42 };
    const x = (speed) => box.left + (box.right - box.left) * Math.log(speed / least) / Math.log(most / least);
    const y = (eps) => box.bottom - (box.bottom - box.top) * (eps - low) / (high - low), at = (v) => v.toFixed(1);
    const out = [`<rect class="b" width="100%" height="100%"/>`], decades = Math.log10(most / least);
    const stride = Math.max(Math.ceil(decades * 48 / (box.right - box.left)), 1);
    for (let e = Math.floor(Math.log10(least)); e <= Math.ceil(Math.log10(most)); e++)
        for (const digit of decades < 2.5 ? [1, 2, 5] : [1]) {
            const speed = Number(`${digit}e${e}`);
            if (e % stride === 0 && speed >= least * 0.999 && speed <= most * 1.001)
                out.push(`<path class="g" d="M${at(x(speed))} ${box.top}V${box.bottom}"/><text class="t" text-anchor="middle" x="${at(x(speed))}" y="${box.bottom + 18}">${speed}</text>`);
        }
    for (const eps of ticks(low, high))
        out.push(`<path class="g" d="M${box.left} ${at(y(eps))}H${box.right}"/><text class="t" text-anchor="end" x="${box.left - 6}" y="${at(y(eps) + 4)}">${Number(eps.toFixed(3))}</text>`);
    out.push(`<path class="a" d="M${box.left} ${at(y(high))}V${box.bottom}H${box.right}"/><text class="t" x="4" y="14">eps</text>`,
        `<text class="t" text-anchor="middle" x="${at((box.left + box.right) / 2)}" y="${height - 6}">impact speed, m/s</text>`);
    const labels = [];
    for (const curve of curves) {
        let down = false, last = -1;
        const path = curve.eps.map((eps, k) => {
            const command = Number.isNaN(eps) ? "" : `${down ? "L" : "M"}${at(x(speeds[k]))} ${at(y(eps))}`;
            down = !Number.isNaN(eps);
            last = down ? k : last;
            return command;
        }).join("");
        out.push(`<path class="c c${curve.colour}${curve.model ? " m" : ""}" d="${path}"/>`);
        if (last >= 0)
            labels.push({ ...curve, x: x(speeds[last]), y: y(curve.eps[last]) });
    }
    // on a wide screen the labels are to the right of the curves, otherwise above them; none covers another
    labels.sort((a, b) => a.y - b.y);
    labels.forEach((label, i) => { label.at = Math.max(wide ? label.y + 4 : label.y - 6, i > 0 ? labels[i - 1].at + 15 : 28); });
    for (let i = labels.length - 1, end = box.bottom - 2; i >= 0; end = labels[i--].at - 15)
        labels[i].at = Math.min(labels[i].at, end);
    for (const [speed, eps, u = 0] of points)
        out.push(u > 0 ? `<path class="a" d="M${at(x(speed))} ${at(y(eps - u))}V${at(y(eps + u))}"/>` : "", `<circle class="a p" cx="${at(x(speed))}" cy="${at(y(eps))}" r="4"/>`);
    out.push(...labels.map((label) => `<text class="t l t${label.colour}" ${wide ? `x="${at(label.x + 8)}"` : `text-anchor="end" x="${at(label.x)}"`} y="${at(label.at)}">${escaped(label.label)}</text>`));
    const title = `eps over the impact speed: ${curves.map(({ label, eps }) => `${label} from ${eps[0].toPrecision(3)} to ${eps.at(-1).toPrecision(3)}`).join("; ")}`;
    $("picture").innerHTML = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="group" aria-label="${escaped(title)}">` +
        `<title>${escaped(title)}</title>${SVG_STYLE}<g aria-hidden="true">${out.join("")}</g><g id="mark" tabindex="0" role="slider" aria-label="Impact speed" style="cursor:ew-resize"></g></svg>`;
    Object.assign(drawn, { x, y, box });
    showMark();
}

// The user's speed, which a pointer or the arrow keys move
function showMark() {
    const { x, y, box, first, least, most, curves } = drawn, mark = $("mark");
    mark.toggleAttribute("hidden", !(first >= least && first <= most));
    if (!(first >= least && first <= most))
        return mark.replaceChildren();
    const values = curves.filter(({ model }) => !model).map((curve) => ({ ...curve, eps: epsAt(curve, first) })).filter(({ eps }) => !Number.isNaN(eps));
    const text = `${first} m/s: ${[...new Set(values.slice(0, 2).map(({ eps }) => eps.toPrecision(SHOWN)))].join(", ")}`, end = x(first) > (box.left + box.right) / 2;
    mark.innerHTML = `<path class="a" d="M${x(first)} ${box.top}V${box.bottom}"/><rect x="${x(first) - 14}" y="${box.top - 14}" width="28" height="${box.bottom - box.top + 14}" fill="transparent"/>` +
        values.map(({ eps, colour }) => `<circle class="c c${colour} p" cx="${x(first)}" cy="${y(eps)}" r="5"/>`).join("") +
        `<text class="t l" text-anchor="${end ? "end" : "start"}" x="${x(first) + (end ? -4 : 4)}" y="${box.top - 4}">${text}</text>`;
    for (const [name, value] of Object.entries({ valuemin: least, valuemax: most, valuenow: first, valuetext: text }))
        mark.setAttribute(`aria-${name}`, value);
}

// eps of a curve at a speed between its points, as it is drawn
function epsAt({ eps }, speed) {
    const at = Math.log(speed / drawn.least) / Math.log(drawn.most / drawn.least) * (POINTS - 1), k = Math.min(Math.floor(at), POINTS - 2);
    return eps[k] + (at - k) * (eps[k + 1] - eps[k]);
}

function moveTo(speed) {
    const list = $("speed").value.trim().split(/\s*;\s*|\s+(?=[-+.\d])/), within = Math.min(Math.max(speed, drawn.least), drawn.most);
    $("speed").value = [Number(within.toPrecision(3)), ...list.slice(1)].join("; ");
    update();
}

function listenToMark() {
    const picture = $("picture"), speedAt = (event) => drawn.least * (drawn.most / drawn.least) **
        ((event.clientX - picture.getBoundingClientRect().left - drawn.box.left) / (drawn.box.right - drawn.box.left));
    let held = false;
    picture.addEventListener("pointerdown", (event) => {
        if (event.target.closest("#mark")) {
            held = true;
            picture.setPointerCapture(event.pointerId);
            event.preventDefault();
        }
    });
    picture.addEventListener("pointermove", (event) => held && moveTo(speedAt(event)));
    picture.addEventListener("pointerup", () => {
        if (held)
            settle();
        held = false;
    });
    picture.addEventListener("keydown", (event) => {
        const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -20, PageUp: 20 }[event.key];
        if (!steps && event.key !== "Home" && event.key !== "End")
            return;
        event.preventDefault();
        moveTo(steps ? drawn.first * 1.05 ** steps : event.key === "Home" ? drawn.least : drawn.most);
        $("mark").focus();
        settle();
    });
}

// ---- everything else that is shown ----

function showSimulator() {
    const [[eps, speed, end], ...models] = tabs(cor.page.text("models", TEXT_DIGITS));
    const short = (text) => Number(Number(text).toPrecision(3)), [first] = models, title = $("for").selectedOptions[0].text;
    $("gives").textContent = models.length === 0 ? `No model of ${title} takes a restitution e: the lines set the damping itself.`
        : first[4] === "nan" ? `${title}, ${first[0]}, refuses e = ${short(eps)}.`
            : `${title}, ${first[0]}: asked e = ${short(eps)}, gives ${short(first[4])} at ${speed} m/s` +
            (first[5] === "nan" ? "." : short(first[4]) === short(eps) ? "." : `; for ${short(eps)} at ${end} set e = ${short(first[5])}.`);
    table("models", ["model", "version", "law", "contact ends at", `gives, asked ${eps}`, "e to set"], models);
    let lines = "", why = "";
    try {
        lines = cor.page.text("lines");
    } catch (error) {
        why = error.message;
    }
    $("lines").textContent = lines;
    $("lines").hidden = lines === "";
    document.querySelector("[data-copy=lines]").hidden = lines === "";
    $("lines-wrong").textContent = why.includes("corgen") ? why : inWords(why);
}

function showResults() {
    showAnswer();
    const [head, ...rows] = csv(cor.page.text("table", TEXT_DIGITS, 1)), order = (row) => head.at(-1) === "measured_end" ? [row.at(-1), ...row.slice(0, -1)] : row;
    table("impacts", order(head), rows.map(order));
    const of = (name) => rows[0]?.[head.indexOf(name)], step = of("time_step_s"), integrator = cor.page.text("integrator");
    const bias = head.find((name) => name.startsWith("step_bias")), scatter = head.find((name) => name.startsWith("step_scatter"));
    $("step").textContent = step === undefined || step === "nan" ? "The time step needs spheres or a spring."
        : `Time step ${withUnit(step, "s")}` + (of(bias) === "nan" ? "." : `: it changes eps by ${of(bias)} on average, with a scatter of ${of(scatter)}.`);
    $("step-error").textContent = integrator === "" ? "cor does not know the error of this simulator's time step."
        : `The error of eps by the time step is for ${integrator}: mean and standard deviation over the phases of the first step. ` +
            "nan: not known, or over 20,000 steps in the contact.";
    const [summaryHead, ...summary] = csv(cor.page.text("summary", TEXT_DIGITS));
    table("summary", summaryHead, summary);
    $("header").textContent = cor.page.text("header");
    $("command").textContent = cor.page.text("command");
    if ($("for").value !== "")
        showSimulator();
}

function showKept() {
    $("kept").replaceChildren(...kept.map((text, i) => {
        const label = new URLSearchParams(text).get("label") ?? `curves ${i + 1}`, item = element("li", label);
        const button = element("button", "Remove", { type: "button", onclick: () => {
            kept.splice(i, 1);
            update();
            settle();
        } });
        button.setAttribute("aria-label", `Remove ${label}`);
        item.append(button);
        return item;
    }));
    $("keep").disabled = $("overlay").disabled = kept.length >= KEPT;
}

function update() {
    showFields();
    showStates();
    const options = optionsNow();
    try {
        drawn = makeCurves(options);
    } catch (error) {
        if (!(error instanceof cor.CorError))
            throw error;
        showWrong(error);
        return false;
    }
    right = true;
    showWrong(null);
    showKept();
    showResults();
    showPicture();
    history.replaceState(null, "", addressOf(options));
    return true;
}

// Remembers the address before a change that is complete, so that it can be undone.
function settle() {
    if (location.hash !== settled)
        past.push(settled);
    settled = location.hash;
    $("undo").disabled = past.length === 0;
}

const isRight = (text) => {
    try {
        cor.page.read(toModule(new URLSearchParams(text)));
        return true;
    } catch {
        return false;
    }
};

function fromAddress(hash) {
    const options = new URLSearchParams(hash.length > 1 ? hash.slice(1) : FIRST), others = options.getAll("also");
    kept = others.filter(isRight).slice(0, KEPT);
    options.delete("also");
    fill(options);
    update();
    const lost = unknown(options) ?? others.find((text) => !kept.includes(text));
    if (lost !== undefined)
        $("wrong").textContent = `The address has '${lost}', which this page cannot show; it is left out.`;
}

// Keeps the curves of the fields, or of equal spheres of another material with its measured eps.
function keep(other) {
    const options = optionsNow();
    for (const name of ["for", "simulator-version", "speed", "steps", "speed-min", "speed-max", "tolerance", "points"])
        options.delete(name);
    if (other) {
        for (const name of [...options.keys()].filter((name) => name !== "radius" && name !== "end"))
            options.delete(name);
        for (const [name, value] of Object.entries({ radius: options.get("radius") ?? "5e-3", ...constantsOf(other) }))
            options.set(name, value);
        options.set("label", other.name);
    }
    kept.push(String(options));
    if (!update())
        kept.pop();
    settle();
}

const constantsOf = ({ young, poisson, density, restitution, at }) => ({ young, poisson, density, restitution, at });

function chooseBodies() {
    const chosen = MATERIALS.find(({ name }) => name === $("bodies").value);
    if (chosen)
        for (const [name, value] of Object.entries({ radius: $("radius").value || "5 mm", mass: "", ...constantsOf(chosen) }))
            $(name).value = value;
    if (chosen && $("law").value !== "plate")
        $("way").value = "restitution";
    $("fold-bodies").open = $("fold-bodies").open || (!chosen && $("bodies").value !== "none");
}

// A plate has its own law, whose loss is the waves in the plate.
function fitPlate(changed) {
    const plate = changed === "law" ? $("law").value === "plate" : $("second").value === "plate";
    if (plate && kind() !== "bodies")
        $("bodies").value = "bodies";
    $("second").value = plate ? "plate" : $("second").value === "plate" ? "like" : $("second").value;
    $("law").value = plate ? "plate" : $("law").value === "plate" ? "" : $("law").value;
    $("way").value = plate ? "none" : $("way").value === "none" ? "restitution" : $("way").value;
}

// ---- saving and copying ----

function save(name, blob) {
    const link = element("a", "", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    $("said").textContent = `${name} is saved.`;
}

const svgText = () => $("picture").innerHTML.replace("&nbsp;", " ");

function savePng() {
    const image = new Image(), svg = $("picture").firstChild;
    image.onload = () => {
        const canvas = Object.assign(document.createElement("canvas"), { width: 2 * svg.clientWidth, height: 2 * svg.clientHeight });
        canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
        canvas.toBlob((blob) => save("restitution.png", blob));
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText())}`;
}

function curvesText() {
    const { speeds, curves } = drawn, digits = (v) => Number.isNaN(v) ? "nan" : String(Number(v.toPrecision(CSV_DIGITS)));
    return [["speed_m_s", ...curves.map(({ label }) => `"${label.replace(/"/g, '""')}"`)],
        ...speeds.map((speed, k) => [digits(speed), ...curves.map(({ eps }) => digits(eps[k]))])].map((row) => row.join(",") + "\n").join("");
}

async function copy(text, what, place) {
    try {
        await navigator.clipboard.writeText(text);
        $("said").textContent = `${what} copied.`;
    } catch {
        getSelection().selectAllChildren(place);
        $("said").textContent = document.execCommand("copy") ? `${what} copied.` : "Selected; copy by the keyboard.";
    }
}

// ---- start ----

function listen() {
    const on = (id, act, event = "click") => $(id).addEventListener(event, act);
    for (const { name } of MATERIALS) {
        $("bodies").add(new Option(`${name[0].toUpperCase()}${name.slice(1)} spheres`, name), $("bodies").options[$("bodies").length - 2]);
        $("overlay").add(new Option(name, name));
    }
    for (const { name, label } of cor.contactLaws())
        $("law").add(new Option(label, name === "viscoelastic" ? "" : name));
    for (const { name, title } of cor.simulators())
        $("for").add(new Option(title, name));
    $("terms").append(...[...TERMS].flatMap(([term, meaning]) => [element("dt", term), element("dd", meaning)]));
    on("form", (event) => event.preventDefault(), "submit");
    on("bodies", chooseBodies, "input");
    on("second", () => fitPlate("second"), "input");
    on("law", () => fitPlate("law"), "input");
    on("form", (event) => event.target.id === "overlay" || update(), "input");
    on("form", settle, "change");
    on("overlay", () => {
        const chosen = MATERIALS.find(({ name }) => name === $("overlay").value);
        $("overlay").value = "";
        if (chosen)
            keep(chosen);
    }, "input");
    on("keep", () => keep());
    on("share", () => copy(location.href, "The address of this page with its input is", $("command")));
    on("reset", () => {
        fromAddress("");
        settle();
    });
    on("undo", () => {
        settled = past.pop();
        fromAddress(settled);
        $("undo").disabled = past.length === 0;
    });
    on("save-svg", () => save("restitution.svg", new Blob([svgText()], { type: "image/svg+xml" })));
    on("save-png", savePng);
    on("save-csv", () => save("curves.csv", new Blob([curvesText()], { type: "text/csv" })));
    on("save-impacts", () => save("impacts.csv", new Blob([cor.page.text("table", CSV_DIGITS, 1)], { type: "text/csv" })));
    for (const button of all("[data-copy]"))
        button.addEventListener("click", () => copy($(button.dataset.copy).textContent, button.textContent.replace("Copy ", "The ") + ":", $(button.dataset.copy)));
    listenToMark();
    addEventListener("hashchange", () => {
        fromAddress(location.hash);
        settle();
    });
    new ResizeObserver(showPicture).observe($("plot"));
}

// The module in the page: deflate, then base 85 with the digits of RFC 1924
async function unpack({ textContent: text, dataset }) {
    const digits = new Uint8Array(128), n = Math.ceil(text.length / 5), bytes = new DataView(new ArrayBuffer(4 * n));
    [..."0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~"].forEach((c, i) => { digits[c.charCodeAt(0)] = i; });
    for (let i = 0; i < n; i++) {
        let word = 0;
        for (let k = 0; k < 5; k++)
            word = 85 * word + digits[text.charCodeAt(5 * i + k)];
        bytes.setUint32(4 * i, word);
    }
    const stream = new Blob([new Uint8Array(bytes.buffer, 0, Number(dataset.bytes))]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).arrayBuffer();
}

cor = await load(await unpack($("wasm")));
units = new Map([...Object.entries(UNITS), ...csv(cor.page.text("options"))]);
fields = new Map();
all("[data-field]").forEach(makeField);
for (const select of all("select[data-option]")) {
    select.after(element("span", "", { className: "error", id: `${select.id}-wrong` }));
    fields.set(select.id, { input: select, label: select.previousElementSibling.textContent, select: true });
}
for (const { input } of fields.values())
    input.setAttribute("aria-describedby", `${input.id}-wrong`);
all("[data-term]").forEach(addHelp);
listen();
fromAddress(location.hash);
settled = location.hash;
document.documentElement.dataset.ready = String(performance.now());
