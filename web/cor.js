// SPDX-License-Identifier: MIT
// libcor and libcor_scene, compiled for WebAssembly, as functions of JavaScript. All arithmetic is in the module; this
// file passes text and arrays. cor.d.ts describes the types and the functions.

export class CorError extends Error {
    constructor(text, option) {
        super(text);
        this.name = "CorError";
        this.option = option;
    }
}

// Returns the bytes of the module, a file next to this one. Works in node and in a page.
async function bytes() {
    const place = new URL("./cor.wasm", import.meta.url);
    if (place.protocol === "file:")
        return (await import("node:fs/promises")).readFile(place);
    return (await fetch(place)).arrayBuffer();
}

export async function load(source) {
    const nothing = () => 52; // ENOSYS: the module has no files
    const { instance } = await WebAssembly.instantiate(source ?? await bytes(), {
        wasi_snapshot_preview1: { fd_close: nothing, fd_seek: nothing, fd_write: nothing },
    });
    return wrap(instance.exports);
}

function wrap(c) {
    // ---- memory of the module; it moves when it grows ----

    // An address is a number of 32 bits, which JavaScript reads with a sign.
    const text = (signed) => {
        const memory = new Uint8Array(c.memory.buffer), at = signed >>> 0;
        return new TextDecoder().decode(memory.slice(at, memory.indexOf(0, at)));
    };
    const allocate = (size) => {
        const at = size < 2 ** 32 ? c.malloc(Math.max(size, 8)) >>> 0 : 0;
        if (at === 0)
            throw new CorError("There is no memory for so large an array.", "");
        return at;
    };
    const withText = (value, use) => {
        const coded = new TextEncoder().encode(value), at = allocate(coded.length + 1);
        new Uint8Array(c.memory.buffer).set([...coded, 0], at);
        try {
            return use(at);
        } finally {
            c.free(at);
        }
    };
    // use(x, y, n) reads n numbers at x and writes `columns` numbers at y for each of them
    const withArray = (array, columns, use) => {
        if (typeof array !== "object" || array === null || typeof array.length !== "number")
            throw new TypeError("cor takes an array of numbers");
        const n = Math.trunc(array.length), x = allocate(8 * n * (1 + columns)), y = x + 8 * n;
        try {
            new Float64Array(c.memory.buffer, x, n).set(array instanceof Float64Array ? array : Float64Array.from(array));
            use(x, y, n);
            return new Float64Array(c.memory.buffer, y, n * columns).slice();
        } finally {
            c.free(x);
        }
    };

    // ---- functions of laws ----

    const named = (list) => {
        const names = [];
        for (let at; (at = c.web_name?.(list, names.length) ?? 0) !== 0;) // the page's module has no such function
            names.push(text(at));
        return names;
    };
    const [laws, ends, quantities, crossley] = [0, 1, 2, 3].map(named);
    const indices = (...names) => names.map((name, i) => {
        const known = [laws, ends, quantities][i], at = known.indexOf(String(name).toLowerCase().replace(/_/g, "-"));
        if (at < 0)
            throw new CorError(`${["law", "end", "quantity"][i]}: '${name}'; allowed: ${known.join(", ")}`, "");
        return at;
    });
    const law = {
        laws: () => [...laws],
        ends: () => [...ends],
        quantities: () => [...quantities],
        value: (law, end, quantity, array) => {
            const at = indices(law, end, quantity);
            return withArray(array, 1, (x, y, n) => c.web_law(...at, x, y, n));
        },
        function: (law, end, quantity) => {
            let found = 0;
            const at = indices(law, end, quantity), [least, largest, max_ulp] = withArray([0, 0, 0], 1, (x, y) => {
                found = c.web_law_function(...at, y);
            });
            return found ? { least, largest, max_ulp } : null;
        },
    };
    const cor = { CorError, law, sphere: {}, hunt_crossley: {} };
    // as in sphere.h: beta_... and beta_of_loss_... are the inverses, and the overlap is the same at every end
    for (const end of ends)
        for (const quantity of quantities.filter((quantity) => law.function("viscoelastic", end, quantity))) {
            const name = quantity.replace("damping-of-eps", "beta").replace("damping", "beta");
            const whole = quantity.includes("overlap") ? name : `${name}-${end}`;
            cor.sphere[whole.replace(/-/g, "_")] = (array) => law.value("viscoelastic", end, quantity, array);
        }
    crossley.forEach((name, i) => {
        cor.hunt_crossley[name] = (array, exponent) => {
            if (typeof exponent !== "number")
                throw new TypeError(`${name} takes an array and the elastic exponent`);
            return withArray(array, 1, (x, y, n) => c.web_hunt_crossley(i, x, y, n, exponent));
        };
    });

    // ---- a contact ----

    // Returns options as text, one in a line. JavaScript's name of an option has _ for each hyphen.
    const lines = (options) => Object.entries(options)
        .filter(([, value]) => value !== undefined && value !== null && value !== false)
        .map(([name, value]) => `${name.replace(/_/g, "-")}=${String(value === true ? "yes" : value).replace(/\n/g, " ")}\n`)
        .join("");
    const wrong = () => new CorError(text(c.web_why(1)), text(c.web_why(0)));
    const checked = (at) => {
        if (at === 0)
            throw wrong();
        return text(at);
    };
    const read = (options) => {
        const contacts = withText(lines(options), c.web_read);
        if (contacts === 0)
            throw wrong();
        return contacts;
    };
    const table = (at) => text(at).trimEnd().split("\n").map((line) => line.split(","));

    const head = () => table(c.web_table(1, 1))[0]; // beta to time_step_s are the columns that web_impacts fills

    // Returns the command of corgen with all options except those named in `without`.
    const command = (name, options, without) => `corgen ${name}` + lines(options).trimEnd().split("\n")
        .map((line) => [line.slice(0, line.indexOf("=")), line.slice(line.indexOf("=") + 1).replace(/ /g, "")])
        .filter(([option, value]) => value !== "" && !without.includes(option))
        .map(([option, value]) => option === "wall" ? " --wall" : ` --${option} ${value}`).join("");
    const range = ["for", "simulator-version", "speed-min", "speed-max", "tolerance"];
    // Returns the command that writes a C header of eps, or, if eps is the same at every speed, the header itself.
    const header = (options) => {
        read(options);
        const law = options.law ?? laws[0] ?? "viscoelastic", curves = text(c.web_curves()).trimEnd().split("\n");
        const [least, most, tolerance] = ["speed-min", "speed-max", "tolerance"]
            .map((name, i) => Number(options[name] ?? options[name.replace("-", "_")] ?? [1e-3, 10, 1e-6][i]));
        return curves.map((line) => line.split("\t")).map(([, end, eps]) => eps
            ? `/* eps of the law ${law}, contact ends at ${end.replace("-", " ")} */\nstatic inline double cor_scene_eps` +
                `${curves.length > 1 ? `_${end.replace("-", "_")}` : ""}(double speed_m_s)\n{\n    (void)speed_m_s; ` +
                `/* the same at every speed */\n    return ${eps};\n}\n`
            : `${command("embed", options, [...range, "speed", "steps", "end"])} --speed-min ${least} ` +
                `--speed-max ${most} --tolerance ${tolerance} --end ${end} --output cor_scene_eps.h\n`).join("\n");
    };

    class Contact {
        constructor(options) {
            this.options = { ...options };
            this.count = read(this.options);
            const [head, ...rows] = table(c.web_summary(17));
            this.summary = Object.fromEntries(rows.map((row) => [row[0], row.slice(1, head.length - 1).map(Number)]));
        }

        // Returns an object of columns for each end at which the restitution may have been measured.
        #each(columns, names) {
            const n = columns.length / this.count / names.length;
            return Array.from({ length: this.count }, (_, k) => Object.fromEntries(names.map((name, i) =>
                [name, columns.slice((k * names.length + i) * n, (k * names.length + i + 1) * n)])));
        }

        impacts(speeds) {
            read(this.options);
            const names = head().slice(1, 9);
            return this.#each(withArray(speeds, this.count * names.length, c.web_impacts), names);
        }

        eps(speeds, end, measured = 0) {
            read(this.options);
            const ends = [0, 1].map((i) => text(c.web_end(i)).replace("_", "-")), index = ends.indexOf(end);
            if (index < 0)
                throw new CorError(`--end: '${end}' is not an end of this contact; allowed: ${ends.join(", ")}`, "end");
            if (!(measured >= 0 && measured < this.count))
                throw new RangeError(`this contact has ${this.count} of them`);
            return withArray(speeds, 1, (x, y, n) => c.web_eps(x, y, n, measured, index));
        }

        stepErrors(speeds, timeStep) {
            read(this.options);
            const names = head().filter((name) => name.startsWith("step_")).map((name) => name.slice(5));
            return this.#each(withArray(speeds, names.length * this.count,
                (x, y, n) => c.web_step_errors(x, y, n, timeStep)), names);
        }

        lines(simulator, { speed, version, steps } = {}) {
            read({ ...this.options, for: simulator, "simulator-version": version, speed: speed && [...speed].join(","),
                steps });
            return checked(c.web_lines());
        }

        header({ speed_min, speed_max, tolerance } = {}) {
            return header({ ...this.options, speed_min, speed_max, tolerance });
        }
    }
    cor.contact = (options) => new Contact(options);
    const choices = (of) => table(c.web_choices()).filter(([option]) => option === of);
    cor.contactLaws = () => choices("law").map(([, name, label]) => ({ name, label }));
    cor.simulators = () => choices("for").slice(1).map(([, name, title]) => ({ name, title }));

    // For the page: texts about the last valid request, and eps of one of its curves
    cor.page = {
        read, header, command: (options) => command("contact", options, range),
        text: (name, ...given) => checked(c[`web_${name}`](...given)),
        block: (names, numbers) => {
            let at = 0;
            withText(names, (name) => withArray(numbers, 0, (x, y, n) => { at = c.web_block(name, x, n); }));
            return checked(at);
        },
        curve: (speeds, i) => withArray(speeds, 1, (x, y, n) => c.web_curve(x, y, n, i)),
    };
    return cor;
}
