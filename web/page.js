// SPDX-License-Identifier: MIT
// The page: reads fields, shows the module's texts. It computes nothing; web/cor.js stands before it in the page.
import { load } from "./cor.js";

const MATERIALS = JSON.parse(document.getElementById("materials").textContent);
const module_ = Uint8Array.from(atob(document.getElementById("wasm").textContent.trim()), (c) => c.charCodeAt(0));
const TEXT_DIGITS = 6, CSV_DIGITS = 12; // those of corgen contact
const HEADS = {
    speed_m_s: "speed, m/s", eps_zero_overlap: "eps, zero overlap", eps_zero_force: "eps, zero force",
    duration_s_zero_overlap: "duration, zero overlap, s", duration_s_zero_force: "duration, zero force, s",
    eps_surface: "eps, at the surface", duration_s_surface: "duration, back at the surface, s",
    max_overlap_m: "largest overlap, m", max_force_n: "largest force, N", time_step_s: "time step, s",
    contact_radius_m: "contact radius, m", max_pressure_pa: "largest pressure, Pa",
    step_bias: "mean error of eps by the step", step_scatter: "its scatter",
    step_bias_zero_overlap: "mean error by the step, zero overlap", step_scatter_zero_overlap: "its scatter",
    step_bias_zero_force: "mean error by the step, zero force", step_scatter_zero_force: "its scatter", measured_end: "eps measured at",
    step_bias_surface: "mean error by the step, at the surface", step_scatter_surface: "its scatter",
    value_zero_overlap: "if measured at zero overlap", value_zero_force: "if measured at zero force",
    value_surface: "if measured at the surface",
};
const FIRST = "young=7e10&poisson=0.24&radius=5e-3&density=2500&restitution=0.9&at=1&speed=0.1,1,10&for=lammps";

const $ = (id) => document.getElementById(id);
const fields = [...document.querySelectorAll("[data-option]")];
let cor, right = false; // whether some input was right, so that there are results
let kept = []; // texts as that of the address

// ---- fields and address ----

function showFields() {
    for (const part of document.querySelectorAll("[data-when]")) {
        const [name, values] = part.dataset.when.split("=");
        part.hidden = !values.split("|").includes($(name).value);
    }
    $("simulation").hidden = $("for").value === "";
}

function optionsNow() {
    const options = new URLSearchParams();
    for (const field of fields)
        if (field.value.trim() !== "" && !field.closest("[hidden]"))
            options.set(field.dataset.option, field.value.trim());
    if ($("kind").value === "bodies" && $("second").value === "wall")
        options.set("wall", "yes");
    return options;
}

// Fills the fields from an address; the selections that are no options follow from what is given.
function fill(options) {
    const has = (...names) => names.some((name) => options.has(name));
    for (const field of fields)
        field.value = options.get(field.dataset.option) ?? "";
    $("kind").value = has("young", "poisson", "radius", "density", "mass", "wall") ? "bodies"
        : has("stiffness", "effective-mass") ? "spring" : "none";
    $("second").value = has("wall") ? "wall" : has("plate-thickness") ? "plate"
        : has("young-2", "poisson-2", "radius-2", "density-2", "mass-2", "dissipation-time-2", "viscosity-2") ? "other"
            : "like";
    $("way").value = [...$("way").options].map((option) => option.value).find((name) => options.has(name)) ??
        (options.get("law") === "plate" ? "none" : "restitution");
    $("material").value = "";
}

// What an address has that no field shows
function unknown(options) {
    const shown = new Map(fields.map((field) => [field.dataset.option, field]));
    const [lost] = [...options].filter(([name, value]) => name !== "wall" && shown.get(name)?.value !== value);
    return lost?.join("=");
}

function toAddress(options) {
    const all = new URLSearchParams(options);
    for (const text of kept)
        all.append("also", text);
    const hash = "#" + all;
    if (hash !== location.hash)
        history.replaceState(null, "", hash);
}

// ---- texts and tables ----

function table(id, head, rows) {
    const cell = (name, text) => {
        const made = document.createElement(name);
        made.textContent = text;
        return made;
    };
    const made = document.createElement("table"), top = made.createTHead().insertRow(), body = made.createTBody();
    for (const name of head) {
        const th = cell("th", HEADS[name] ?? name.replace(/_/g, " "));
        th.scope = "col";
        top.append(th);
    }
    for (const row of rows)
        body.insertRow().append(...row.map((text) => {
            const td = cell("td", text);
            td.classList.toggle("words", text.length > 24);
            return td;
        }));
    $(id).replaceChildren(made);
}
const csv = (text) => text.trimEnd().split("\n").map((line) => line.split(","));
const tabs = (text) => text.trimEnd().split("\n").map((line) => line.split("\t"));

function showWrong(error) {
    for (const field of fields) {
        const says = $(`${field.id}-wrong`), mine = error !== null && field.dataset.option === error.option &&
            !field.closest("[hidden]");
        field.toggleAttribute("aria-invalid", mine);
        if (mine)
            field.setAttribute("aria-invalid", "true");
        says.textContent = mine ? error.message : "";
    }
    const shown = error === null || document.querySelector("[aria-invalid=true]");
    $("wrong").textContent = error === null ? "" : shown ? "The results are those of the last right input."
        : `${error.message}. The results are those of the last right input.`;
    $("results").classList.toggle("old", error !== null);
}

// ---- results ----

// Whatever was read last is the request of all that follows.
function readAll(options) {
    cor.page.read(Object.fromEntries(options));
    cor.page.call("keep_none");
    for (const text of kept) {
        cor.page.read(Object.fromEntries(new URLSearchParams(text)));
        cor.page.call("keep");
    }
    cor.page.read(Object.fromEntries(options));
}

function showPicture() {
    if (!right)
        return;
    const width = Math.max($("picture").clientWidth, 280);
    $("picture").innerHTML = cor.page.text("picture", width);
    showValues("read_step", Number($("cursor").value));
}

function showValues(how, at) {
    if (!right)
        return;
    const [[x, speed, step], ...rows] = tabs(cor.page.text(how, at, TEXT_DIGITS));
    const line = $("cor-line");
    line.setAttribute("transform", `translate(${x} 0)`);
    line.removeAttribute("visibility");
    $("cursor").value = step;
    $("cursor").setAttribute("aria-valuetext", `${speed} m/s: ${rows.map((row) => row.join(" ")).join("; ")}`);
    table("values", ["curve", `eps at ${speed} m/s`], rows);
}

function showResults() {
    const [head, ...rows] = csv(cor.page.text("table", TEXT_DIGITS, 1));
    // which end the eps was measured at stands in front, where two rows of a speed differ in it
    const order = (row) => head.at(-1) === "measured_end" ? [row.at(-1), ...row.slice(0, -1)] : row;
    table("impacts", order(head), rows.map(order));
    const integrator = cor.page.text("integrator");
    $("step-says").textContent = integrator === ""
        ? "This simulator chooses its steps, or moves its bodies in a way whose error cor does not know."
        : `The error of eps by the time step is that of ${integrator}: mean and standard deviation over the phases of ` +
            "the first step, eps realised less eps of the contact. nan: not known, or " +
            "over 20000 steps in the contact.";
    const [summaryHead, ...summary] = csv(cor.page.text("summary", TEXT_DIGITS));
    table("summary", summaryHead, summary);
    $("header").textContent = cor.page.text("header");
    $("command").textContent = cor.page.text("command");
    if ($("for").value !== "")
        showSimulator();
}

function showSimulator() {
    const [[eps, speed, end], ...models] = tabs(cor.page.text("models", TEXT_DIGITS));
    $("asked").textContent = models.length === 0 ? "No model of this simulator takes a restitution coefficient e." :
        `Asked: eps = ${eps} at ${speed} m/s, ${end}. What each model makes of it:`;
    $("models").hidden = models.length === 0;
    table("models", ["model", "version", "law", "contact ends at", `realised with e = ${eps}`, "e to be set"], models);
    let lines = "", why = "";
    try {
        lines = cor.page.text("lines");
    } catch (error) {
        why = error.message;
    }
    $("lines").textContent = lines;
    $("lines").hidden = lines === "";
    document.querySelector("[data-copy=lines]").hidden = lines === "";
    $("lines-wrong").textContent = why;
}

function update() {
    showFields();
    const options = optionsNow();
    try {
        readAll(options);
    } catch (error) {
        if (!(error instanceof cor.CorError))
            throw error;
        showWrong(error);
        return;
    }
    right = true;
    showWrong(null);
    showKept();
    showResults();
    showPicture();
    toAddress(options);
}

function isRight(text) {
    try {
        cor.page.read(Object.fromEntries(new URLSearchParams(text)));
        return true;
    } catch {
        return false;
    }
}

function fromAddress() {
    const options = new URLSearchParams(location.hash.length > 1 ? location.hash.slice(1) : FIRST);
    const all = options.getAll("also");
    kept = all.filter(isRight).slice(0, 5);
    options.delete("also");
    fill(options);
    update();
    const lost = unknown(options) ?? all.find((text) => !kept.includes(text));
    if (lost !== undefined)
        $("wrong").textContent = `The address has '${lost}', which this page cannot show; it is left out.`;
}

// ---- curves that are kept ----

function showKept() {
    $("kept").replaceChildren(...kept.map((text, i) => {
        const item = document.createElement("li"), button = document.createElement("button");
        const label = new URLSearchParams(text).get("label") ?? `curves ${i + 1}`;
        button.type = "button";
        button.textContent = "Remove";
        button.setAttribute("aria-label", `Remove ${label}`);
        button.addEventListener("click", () => {
            kept.splice(i, 1);
            update();
        });
        item.append(label, button);
        return item;
    }));
    $("keep").disabled = $("overlay").disabled = kept.length >= 5;
}

// Keeps the curves of the fields, or of spheres of another material, with the eps that was measured of it
function keep(other) {
    const options = optionsNow();
    for (const name of ["for", "simulator-version", "speed", "steps", "speed-min", "speed-max", "tolerance"])
        options.delete(name);
    if (other) {
        for (const name of [...options.keys()])
            if (name !== "radius" && name !== "end")
                options.delete(name);
        if (!options.has("radius"))
            options.set("radius", "5e-3");
        for (const [name, value] of Object.entries(constantsOf(other)))
            options.set(name, value);
        options.set("label", `${other.name}, ${other.restitution} at ${other.at} m/s`);
    }
    kept.push(String(options));
    try {
        readAll(optionsNow());
    } catch (error) {
        kept.pop();
        showWrong(error);
        return;
    }
    update();
}

const constantsOf = ({ young, poisson, density, restitution, at }) => ({ young, poisson, density, restitution, at });
const saysOf = ({ measured, restitution, at }) => `Measured eps: ${measured}. Taken here: ${restitution} at ${at} m/s.`;

// ---- saving and copying ----

function save(name, type, text) {
    if (!right)
        return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    $("said").textContent = `${name} is saved.`;
}

async function copy(id) {
    try {
        await navigator.clipboard.writeText($(id).textContent);
        $("said").textContent = "Copied.";
    } catch {
        getSelection().selectAllChildren($(id));
        $("said").textContent = document.execCommand("copy") ? "Copied." : "Selected; copy it by the keyboard.";
    }
}

// ---- start ----

function listen() {
    for (const { name } of MATERIALS) {
        $("material").add(new Option(name, name));
        $("overlay").add(new Option(name, name));
    }
    for (const { name, label } of cor.contactLaws())
        $("law").add(new Option(label, name === "viscoelastic" ? "" : name));
    for (const { name, title } of cor.simulators())
        $("for").add(new Option(title, name));
    const material = (id) => MATERIALS.find(({ name }) => name === $(id).value);
    $("form").addEventListener("submit", (event) => event.preventDefault());
    $("material").addEventListener("input", () => {
        const chosen = material("material");
        $("material-says").textContent = chosen ? saysOf(chosen) : "";
        if (chosen) {
            $("way").value = "restitution";
            for (const [name, value] of Object.entries({ ...constantsOf(chosen), mass: "", label: chosen.name }))
                $(name).value = value;
        }
    });
    $("second").addEventListener("input", () => {
        if ($("second").value === "plate")
            $("law").value = "plate";
        else if ($("law").value === "plate")
            $("law").value = "";
        $("way").value = $("law").value === "plate" ? "none" : $("way").value === "none" ? "restitution" : $("way").value;
    });
    $("law").addEventListener("input", () => {
        if ($("law").value === "plate") {
            $("kind").value = "bodies";
            $("second").value = "plate";
            $("way").value = "none";
        } else if ($("second").value === "plate") {
            $("second").value = "like";
            $("way").value = "restitution";
        }
    });
    $("form").addEventListener("input", (event) => event.target.id === "overlay" || update());
    $("overlay").addEventListener("input", () => {
        const chosen = material("overlay");
        $("overlay").value = "";
        if (chosen)
            keep(chosen);
    });
    $("keep").addEventListener("click", () => keep());
    $("cursor").addEventListener("input", () => showValues("read_step", Number($("cursor").value)));
    $("picture").addEventListener("pointermove", (event) =>
        showValues("read_x", event.clientX - $("picture").getBoundingClientRect().left));
    $("save-svg").addEventListener("click", () =>
        save("restitution.svg", "image/svg+xml", cor.page.text("picture", Math.max($("picture").clientWidth, 280))));
    $("save-curves").addEventListener("click", () => save("curves.csv", "text/csv", cor.page.text("curves", CSV_DIGITS)));
    $("save-impacts").addEventListener("click", () =>
        save("impacts.csv", "text/csv", cor.page.text("table", CSV_DIGITS, 1)));
    for (const button of document.querySelectorAll("[data-copy]"))
        button.addEventListener("click", () => copy(button.dataset.copy));
    addEventListener("hashchange", fromAddress);
    new ResizeObserver(showPicture).observe($("results"));
}

cor = await load(module_);
listen();
fromAddress();
document.documentElement.dataset.ready = String(performance.now());
