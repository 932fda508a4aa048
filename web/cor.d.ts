// SPDX-License-Identifier: MIT
// The coefficient of restitution, eps, of colliding viscoelastic bodies, computed by libcor in WebAssembly. Functions
// take arrays and return new ones; a number outside a function's domain gives NaN, as in C. All numbers are in SI units.
// Formulas, domains and errors are in include/cor/sphere.h and law.h.

export type Numbers = ArrayLike<number>;
export type Elementwise = (x: Numbers) => Float64Array;
/** of beta, and of the exponent a of the elastic force K x^a */
export type OfBetaAndExponent = (beta: Numbers, elasticExponent: number) => Float64Array;

/** beta is the dimensionless damping; `beta...` are the inverses of eps, `loss` is 1 - eps. */
type SphereName = "eps_zero_overlap" | "eps_zero_force" | "eps_approach_only" | "loss_zero_overlap" | "loss_zero_force"
    | "loss_approach_only" | "beta_zero_overlap" | "beta_zero_force" | "beta_approach_only"
    | "beta_of_loss_approach_only" | "duration_zero_overlap" | "duration_zero_force" | "duration_approach_only"
    | "max_overlap" | "time_of_max_overlap";
type CrossleyTime = "duration" | "duration_approach_only" | "max_overlap" | "time_of_max_overlap";

/** Every function of a law by names, which may have _ for each hyphen: law.value("tsuji", "zero-force", "eps", zeta).
 * x is the damping, zeta for linear and tsuji and beta for the others; eps for damping-of-eps; 1 - eps for
 * damping-of-loss. NaN where the law has no such function.
 * @throws CorError for another name */
export interface Laws {
    laws(): string[];
    ends(): string[];
    quantities(): string[];
    value(law: string, end: string, quantity: string, x: Numbers): Float64Array;
    /** the domain, and the bound on the error in units of the last place; null: the law has no such function */
    function(law: string, end: string, quantity: string): { least: number; largest: number; max_ulp: number } | null;
}

/** a name of Cor.contactLaws(), such as "tsuji" */
export type Law = string;
/** under a constant force "surface" replaces "zero-force" */
export type End = "zero-overlap" | "zero-force" | "surface";
/** a name of Cor.simulators(), as "lammps" */
export type Simulator = string;

/** The options of `corgen contact`, with _ for each hyphen: bodies or a spring, one way to give the damping, a law.
 * gravity presses body 1 to a wall or a plate. restitution is eps measured at the speed `at`, and at the end
 * `end` of contact or, without `end`, at either. time_step_s is the shortest duration/steps (default: 50). */
export type ContactOptions = Partial<Record<"young" | "poisson" | "radius" | "density" | "mass" | "young_2" | "poisson_2"
    | "radius_2" | "density_2" | "mass_2" | "plate_thickness" | "gravity" | "duration" | "stiffness" | "effective_mass"
    | "dissipation_time" | "dissipation_time_2" | "g_star" | "restitution" | "at" | "damping_coefficient" | "beta"
    | "zeta" | "adhesion" | "steps", number>> & {
    /** body 2 is flat and held fast */
    wall?: boolean;
    /** "ETA1,ETA2", Pa s */
    viscosity?: string; viscosity_2?: string;
    adhesion_model?: "dmt" | "jkr";
    end?: End; law?: Law;
    /** stepErrors uses its integrator */
    for?: Simulator;
};

/** Columns of numbers. Under a constant force "surface" replaces "zero_force" in their names. */
type EndName = "zero_overlap" | "zero_force" | "surface";
export type Impacts = Record<"beta" | `eps_${EndName}` | `duration_s_${EndName}` | "max_overlap_m" | "max_force_n"
    | "time_step_s", Float64Array>;

/** Results are lists of one element. If a restitution is given without an end of contact, they have two: for eps
 * measured at zero overlap and at zero force. */
export interface Contact {
    readonly options: ContactOptions;
    readonly count: number;
    /** the known numbers: effective_mass, dissipation_time, g_star, ... */
    readonly summary: Record<string, number[]>;
    impacts(speeds: Numbers): Impacts[];
    eps(speeds: Numbers, end: End, measured?: number): Float64Array;
    /** bias and scatter: mean and standard deviation, over phases of the first step, of the realised eps minus the
     * exact eps. If the end of contact matters and is not given: bias_zero_overlap, ... for each end */
    stepErrors(speeds: Numbers, timeStep: number): Record<string, Float64Array>[];
    /** the lines to paste into a simulator's input */
    lines(simulator: Simulator, more?: { speed?: Numbers; version?: string; steps?: number }): string;
    /** the corgen command that writes a C header, or, if eps is the same at every speed, the header itself */
    header(more?: { speed_min?: number; speed_max?: number; tolerance?: number }): string;
}

/** A refusal: the sentence of corgen, and the option that caused it */
export declare class CorError extends Error {
    readonly option: string;
}

export interface Cor {
    CorError: typeof CorError;
    sphere: Record<SphereName, Elementwise>;
    law: Laws;
    /** Hunt and Crossley's law with any elastic exponent */
    hunt_crossley: Record<CrossleyTime, OfBetaAndExponent>;
    /** @throws CorError */
    contact(options: ContactOptions): Contact;
    contactLaws(): { name: Law; label: string }[];
    simulators(): { name: Simulator; title: string }[];
}

/** source: the bytes of cor.wasm; if absent, the file next to this module is read. */
export declare function load(source?: BufferSource): Promise<Cor>;
