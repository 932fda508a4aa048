/* SPDX-License-Identifier: MIT */
/* corgen contact: one contact in SI units, its impacts, and the lines that a simulator needs for it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SCENE_ENDS contact_end_options_all
#include "cli/commands.h"
#include "cli/scene_options.h"
#include "contact/oblique.h"
#include "support/console.h"
#include "support/gnuplot.h"

_Static_assert(OPTIONS_NOT_GIVEN == COR_BOTH_ENDS, "no --end is the same as both ends");
_Static_assert(OPTIONS_NOT_GIVEN == COR_NO_INTEGRATOR, "no --integrator is the same as the simulator's own");

#define DEFAULT_STEPS "50"

/* Returns the request for a simulator. Without a simulator only speeds and time step matter. contacts: NULL for a
 * list */
static struct cor_simulator_request request_of(const struct contact_arguments *o, const struct contacts *contacts)
{
    const bool default_integrator = o->integrator == OPTIONS_NOT_GIVEN && !o->simulator;
    return (struct cor_simulator_request){.simulator = o->simulator,
                                          .version = o->version,
                                          .scene = contacts ? &contacts->scene : NULL,
                                          .contacts = contacts ? contacts->contact : NULL,
                                          .count = contacts ? contacts->count : 0,
                                          .speed_m_s = o->speed.nearest,
                                          .speeds = o->speed.count,
                                          .time_step_s = options_number(&o->time_step, 0),
                                          .steps = options_number(&o->steps, strtod(DEFAULT_STEPS, NULL)),
                                          .step_tolerance = options_number(&o->step_tolerance, 0),
                                          .step_errors = o->steps.text || o->time_step.text || o->step_tolerance.text ||
                                                         o->step_corrected || o->integrator != OPTIONS_NOT_GIVEN,
                                          .step_corrected = o->step_corrected,
                                          .integrator = default_integrator ? COR_VERLET_HALF_STEP : o->integrator};
}

/* Refuses options that contradict each other or lack a number that they need, such as friction without bodies. */
static int check_options(const struct contact_arguments *o, const struct contacts *contacts)
{
    const struct cor_scene_contact *const c = &contacts->contact[0];
    const char *const option = o->time_step.text ? "time-step" : o->step_tolerance.text ? "step-tolerance" : NULL;
    if (option && isnan(c->mass_kg))
        return usage_error("--%s needs mass and stiffness: give bodies, or --stiffness and --effective-mass", option);
    const bool oblique = o->angle.count + o->tangential_speed.count > 0;
    const bool slides = oblique || (o->friction.text && o->simulator);
    if (o->friction.text && !slides && o->speed.count > 0)
        return usage_error("--friction with --speed needs --angle LIST or --tangential-speed LIST, for "
                           "example --angle 10,30,60");
    if (oblique && o->speed.count == 0)
        return usage_error("--angle and --tangential-speed need --speed LIST, the normal component of the velocity");
    const struct values *const given = o->angle.count > 0 ? &o->angle : &o->tangential_speed;
    if (o->walton && (given->count < 3 || given->least == given->largest))
        return usage_error("--walton needs at least three different angles, for example --angle 1:89:lin:89");
    if (o->walton && o->simulator)
        return usage_error("--walton and --for exclude each other; leave out --for");
    if (slides && (isnan(c->mass_kg) || contacts->scene.plate || c->adhesion_j_m2 > 0))
        return usage_error("oblique impacts need two bodies, or --stiffness and --effective-mass; leave out "
                           "--plate-thickness and --adhesion-model jkr");
    if (o->friction.text && !slides && (contacts->scene.plate || isnan(c->radius_m)))
        return usage_error("--friction needs two spheres, or a sphere and a wall, with --poisson NU for Mindlin's "
                           "tangential stiffness, for example --young 7e10 --poisson 0.2 --radius 1e-3 --density 2500");
    if (o->friction.text && (c->plastic || c->liquid_speed_m_s > 0))
        return usage_error(
            "--friction is not possible with --law elastic-plastic or in a liquid; leave out --friction");
    double spring, dashpot;
    const int end = contact_end(contacts, 0);
    if (o->tangential.text && !slides && (o->speed.count > 0 || o->simulator))
        return usage_error("--tangential-restitution needs --friction MU, and with --speed also --angle LIST");
    if (o->tangential.text && end == COR_BOTH_ENDS)
        return usage_error(
            "--tangential-restitution needs --end zero-overlap or zero-force, because the duration depends on the end");
    if (o->tangential.text &&
        cor_scene_tangential(&spring, &dashpot, c, options_number(&o->tangential, NAN), end) != STATUS_OK)
        return usage_error(
            "--tangential-restitution needs --law linear with --effective-mass and --stiffness or "
            "--duration, a damping at which the bodies part, and no --gravity, for example --law linear --stiffness "
            "1e5 --effective-mass 1e-3 --restitution 0.9");
    if (o->step_corrected && !o->simulator && contact_end(contacts, 0) == COR_BOTH_ENDS)
        return usage_error("--step-corrected needs --end zero-overlap or %s, because the damping depends on the end",
                           c->force_n > 0 ? "surface" : "zero-force");
    if (c->adhesion_j_m2 > 0 && o->scene.end != OPTIONS_NOT_GIVEN)
        return usage_error("--end does not apply to --adhesion-model jkr, which prints two ends, the tail and the "
                           "largest pull; leave out --end");
    if (o->integrator == COR_IMPLICIT_EULER && !(c->law.elastic == c->law.denominator && c->law.damping == 0))
        return usage_error("--integrator implicit-euler needs --law linear, the spring and dashpot of physics engines");
    if (contacts->scene.end == COR_END_APPROACH_ONLY && (!cor_scene_has_end(c, COR_END_APPROACH_ONLY) || o->plot))
        return usage_error("--end approach-only needs --law viscoelastic, linear, tsuji, hertz-dashpot or "
                           "hunt-crossley; leave out --gravity, --adhesion, --viscosity-liquid and --plot");
    const bool refused = c->adhesion_j_m2 > 0 || c->liquid_speed_m_s > 0;
    if ((c->plastic || (!o->simulator && (refused || contacts->scene.end == COR_END_APPROACH_ONLY))) &&
        request_of(o, NULL).step_errors)
        return usage_error("the error of a time step is not known for --end approach-only, --adhesion-model jkr, "
                           "--viscosity-liquid and --law elastic-plastic; leave out these options, or leave out "
                           "--steps, --time-step, --step-tolerance, --step-corrected and --integrator");
    return STATUS_OK;
}

static struct oblique_request oblique_of(const struct contact_arguments *o)
{
    const bool angles = o->angle.count > 0;
    const struct values *const given = angles ? &o->angle : &o->tangential_speed;
    return (struct oblique_request){.model = o->model,
                                    .friction = options_number(&o->friction, NAN),
                                    .stiffness = options_number(&o->tangential_stiffness, NAN),
                                    .damping_ratio = options_number(&o->tangential_damping, NAN),
                                    .restitution = options_number(&o->tangential, NAN),
                                    .given = given->nearest,
                                    .count = given->count,
                                    .speed_m_s = o->speed.nearest,
                                    .speeds = o->speed.count,
                                    .angles = angles,
                                    .walton = o->walton};
}

/* ---- the tables ---- */

static int print_tables(const struct contact_arguments *o, const struct contacts *contacts)
{
    const enum output_format format = (enum output_format)o->common.format;
    const bool in_text = format == FORMAT_TEXT, rows = o->speed.count > 0;
    const int digits = in_text ? CONTACT_DIGITS_TEXT : CONTACT_DIGITS;
    const struct cor_simulator_request request = request_of(o, contacts);
    struct table table = {0}, summary;
    struct output out;
    char text[CONTACT_LAW_TEXT];
    struct oblique_request oblique = oblique_of(o);
    int status = oblique.count > 0 ? contact_oblique(&table, contacts, &oblique, digits)
                 : rows            ? contact_rows(&table, contacts, &request, digits)
                                   : STATUS_OK;
    if (status == STATUS_OK)
        status = output_open(&out, o->common.output);
    if (status == STATUS_OK) {
        if (in_text)
            fprintf(out.file, "%s%s\n\n", contact_law_text(text, &contacts->contact[0]),
                    contacts->scene.plate ? ", a plate" : "");
        if (in_text || !rows) {
            const bool spheres = !isnan(contacts->contact[0].radius_m);
            contact_summary(&summary, contacts, spheres ? options_number(&o->friction, NAN) : (double)NAN,
                            options_number(&o->tangential, NAN), digits);
            table_print(&summary, format, out.file);
            table_clear(&summary);
        }
        if (in_text && rows)
            fputs("\n", out.file);
        if (rows)
            table_print(&table, format, out.file);
        if (oblique.remark[0])
            fprintf(in_text ? out.file : stderr, in_text ? "\n%s\n" : "corgen: %s\n", oblique.remark);
        if (in_text)
            contact_print_ranges(out.file, contacts, rows);
        status = output_commit(&out);
    }
    table_clear(&table);
    return status;
}

/* ---- the picture ---- */

enum { CURVE_POINTS = 201 };

/* Draws eps at speeds that are equally spaced in their logarithm. For a single speed, draws two decades around it. */
static int draw_eps(const struct contact_arguments *o, const struct contacts *contacts)
{
    char title[COR_SCENE_ENDS][64];
    static double speed_m_s[CURVE_POINTS], eps[COR_SCENE_ENDS][CURVE_POINTS];
    const double margin = o->speed.least < o->speed.largest ? 1 : 10;
    const double low = o->speed.least / margin, high = o->speed.largest * margin;
    struct eps_curve curve[COR_SCENE_ENDS];
    size_t curves = 0;
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        const struct cor_scene_contact *const contact = &contacts->contact[contacts->count > 1 ? end : 0];
        const bool wanted = contacts->scene.end == COR_BOTH_ENDS || contacts->scene.end == end;
        if (!wanted || !cor_scene_has_end(contact, end) || (curves > 0 && !cor_scene_ends_differ(contact)))
            continue;
        for (int i = 0; i < CURVE_POINTS; i++) {
            progress("picture", i, CURVE_POINTS);
            speed_m_s[i] = low * pow(high / low, (double)i / (CURVE_POINTS - 1));
            const int status = contact_status(cor_scene_eps(&eps[curves][i], contact, speed_m_s[i], end));
            if (status != STATUS_OK)
                return status;
        }
        progress_end();
        snprintf(title[end], sizeof title[end], "contact ends at %s", contact_end_text(contact, end));
        curve[curves] = (struct eps_curve){title[end], speed_m_s, eps[curves], CURVE_POINTS};
        curves++;
    }
    char heading[CONTACT_LAW_TEXT + 32], law[CONTACT_LAW_TEXT];
    snprintf(heading, sizeof heading, "restitution of a contact, %s", contact_law_text(law, &contacts->contact[0]));
    return eps_plot(o->plot, heading, "impact speed (m/s)", 0, curve, curves);
}

/* ---- an own law ---- */

/* Prints eps at the speeds and draws a picture of it, or prints lines for a simulator. */
static int print_own(const struct contact_arguments *o, const struct own_law *law)
{
    const enum output_format format = (enum output_format)o->common.format;
    const struct values *const speed = &o->speed;
    struct table table;
    struct output out;
    if (speed->count == 0)
        return usage_error("--law %s needs --speed, for example --speed 0.1,1,10", embed_law_names[law->law]);
    int status = own_law_check(law, speed->least, speed->largest);
    if (o->simulator && status == STATUS_OK) {
        char *const text = contact_own_lines(law, &o->scene, o->simulator, speed->nearest, speed->count);
        status = text ? output_text(o->common.output, text) : STATUS_USAGE;
        free(text);
        return status;
    }
    double *const eps = xmalloc(speed->count * sizeof *eps);
    table_init(&table, "speed_m_s,eps", "nn");
    for (size_t i = 0; i < speed->count; i++) {
        char text[DECIMAL_TEXT];
        eps[i] = own_law_value(law, speed->nearest[i]);
        table_add_text(&table, decimal_text(text, speed->nearest[i]));
        table_add_number(&table, eps[i], format == FORMAT_TEXT ? CONTACT_DIGITS_TEXT : CONTACT_DIGITS);
    }
    const struct eps_curve curve = {embed_law_names[law->law], speed->nearest, eps, speed->count};
    if (o->plot && status == STATUS_OK)
        status = eps_plot(o->plot, law->text, "impact speed (m/s)", 0, &curve, 1);
    if (status == STATUS_OK)
        status = output_open(&out, o->common.output);
    if (status == STATUS_OK) {
        if (format == FORMAT_TEXT)
            fprintf(out.file, "%s\n\n", law->text);
        table_print(&table, format, out.file);
        status = output_commit(&out);
    }
    table_clear(&table);
    free(eps);
    return status;
}

/* ---- the command ---- */

/* Prints the lines of a simulator for one contact or several materials, or a list of simulators. */
static int print_for_simulator(const struct contact_arguments *o, const struct contacts *contacts)
{
    struct cor_simulator_request request = request_of(o, contacts);
    struct cor_scene scene;
    if (o->materials && embed_request_scene(&scene, &o->scene) != STATUS_OK)
        return STATUS_USAGE;
    scene.solver = contact_enclosed;
    request.scene = o->materials ? &scene : request.scene;
    const struct oblique_request oblique = oblique_of(o);
    if (o->friction.text && request.scene && contact_oblique_lines(&request, contacts, &oblique) != STATUS_OK)
        return STATUS_USAGE;
    char *const text =
        o->materials ? contact_materials_text(request, o->materials, o->pairs) : contact_simulator_text(&request);
    if (!text)
        return STATUS_USAGE;
    const int status = output_text(o->common.output, text);
    free(text);
    return status;
}

/* Sets stiffness and damping of a contact from ERP and CFM: K = ERP/(h CFM), C = (1 - ERP)/CFM */
static void set_engine(struct contact_arguments *o, struct decimal *stiffness, struct decimal *damping)
{
    const fmpq *const erp = o->erp.value, *const cfm = o->cfm.value, *const h = o->time_step.value;
    decimal_set(stiffness, "1");
    decimal_set(damping, "0");
    EXACT(stiffness->value, "erp/(h*cfm)", erp, h, cfm);
    EXACT(damping->value, "(1 - erp)/cfm", erp, cfm);
    o->scene.number[COR_SCENE_STIFFNESS] = *stiffness;
    o->scene.number[fmpq_is_one(erp) ? COR_SCENE_ZETA : COR_SCENE_DAMPING_COEFFICIENT] = *damping;
    o->scene.law = COR_LAW_LINEAR;
    o->integrator = COR_IMPLICIT_EULER;
}

static int run_contact(const void *arguments)
{
    struct contact_arguments copy = *(const struct contact_arguments *)arguments;
    const struct contact_arguments *const o = &copy;
    __attribute__((cleanup(decimal_clear))) struct decimal stiffness = {0}, damping = {0};
    struct contacts contacts;
    if (o->plot && gnuplot_check(o->plot) != STATUS_OK)
        return STATUS_USAGE;
    if (o->erp.text && !(o->time_step.text && embed_given(&o->scene, COR_SCENE_EFFECTIVE_MASS)))
        return usage_error("--erp and --cfm need --time-step and --effective-mass, for example --erp 0.8 --cfm 1e-3 "
                           "--time-step 0.01 --effective-mass 1 --speed 1");
    if (o->erp.text)
        set_engine(&copy, &stiffness, &damping);
    if (o->materials && !o->simulator)
        return usage_error(
            "--materials needs --for SIMULATOR, for example --for lammps; --for list prints all simulators");
    /* no contact is needed to print a list, refuse an unknown simulator, or read materials from a file */
    if (o->simulator && (o->materials || (o->version && strcmp(o->version, CONTACT_SIMULATOR_LIST) == 0) ||
                         !cor_simulator_named(o->simulator)))
        return print_for_simulator(o, NULL);
    OWN_LAW(own);
    int status = own_law_init(&own, &o->scene);
    if (own.law || status != STATUS_OK)
        return status == STATUS_OK ? print_own(o, &own) : status;
    status = contacts_of_request(&contacts, &o->scene);
    if (status == STATUS_OK)
        status = check_options(o, &contacts);
    if (status != STATUS_OK)
        return status;
    if (o->speed.count > 0)
        contact_warn(&contacts, o->speed.largest);
    else if (embed_given(&o->scene, COR_SCENE_AT))
        contact_warn(&contacts, embed_number(&o->scene, COR_SCENE_AT));
    if (o->simulator)
        return print_for_simulator(o, &contacts);
    if (o->plot)
        status = draw_eps(o, &contacts);
    return status == STATUS_OK ? print_tables(o, &contacts) : status;
}

const char help_contact[] = HELP_CONTACT_TEXT;

static const char help[] =
    "Usage: corgen contact BODIES DISSIPATION [--law L] [--speed LIST] [OPTION]...\n\n"
    "Prints the dissipation time A, g*, beta or zeta of one contact of two bodies, and for each impact speed\n"
    "eps, durations, largest overlap and force, and a time step. A contact ends at zero overlap, or at\n"
    "zero force, where the force would become attractive.\n" HELP_CONTACT "\n"
    "Output:\n"
    "  --speed LIST     impact speeds, m/s, as values and ranges such as 0.1,1,10 or 0.01:10:log:7, or\n"
    "                   @FILE to read them from a file\n"
    "  --end E          end of contact of a measured eps and of --plot: zero-overlap, zero-force or\n"
    "                   approach-only; under a constant force zero-overlap or surface (default both)\n"
    "  --steps N        time steps in the shortest duration, 1 to 1e9, for time_step_s (default " DEFAULT_STEPS ")\n"
    "  --time-step DT   time step, s, instead of --steps\n"
    "  --step-tolerance T   largest step_bias and step_scatter, 1e-5 to 1, instead of --steps\n"
    "                   These three options add step_bias and step_scatter, the mean and standard\n"
    "                   deviation of the error of eps over phases of the first step\n"
    "  --step-corrected   also print the damping that makes step_bias 0, and the ratio\n"
    "  --integrator I   integrator: verlet-half-step (used by LAMMPS), leapfrog or symplectic-euler, which\n"
    "                   give the same eps; verlet-full-step; or with --law linear implicit-euler\n"
    "                   (default verlet-half-step; with --for the simulator's)\n"
    "  --erp E --cfm C  ERP and CFM of an engine with implicit steps, such as ODE; need --time-step and\n"
    "                   --effective-mass\n"
    "  --for HOST       simulator whose input lines are printed, such as lammps; list prints all names\n"
    "  --simulator-version V   its version, such as '29 Sep 2021' or 3.8.1\n"
    "  --materials FILE, --pairs FILE   csv files of several materials for --for (docs/contact.md)\n"
    "  --friction MU    friction coefficient of spheres, 0 or more; prints kappa, the ratio of tangential\n"
    "                   velocities of an elastic impact without slip, and the largest angle of sticking\n"
    "  --angle LIST | --tangential-speed LIST   oblique impacts with --friction and --speed (the normal\n"
    "                   component): angles to the normal, degrees, or tangential speeds, m/s\n"
    "  --tangential MODEL   model of the tangential force: displacement, force, rescaled, viscous, or a\n"
    "                   simulator's name, such as mindlin_rescale or history (default displacement)\n"
    "  --tangential-stiffness KT, --tangential-damping X   tangential stiffness (default Mindlin's), and\n"
    "                   ratio of tangential to normal damping (default 0; viscous 1)\n"
    "  --walton         print friction and beta_0 of Walton's model that fit the angles best\n"
    "  --tangential-restitution E   tangential e of --law linear; sets its tangential spring and dashpot\n"
    "  --equivalent Q   energy or duration, in which a linear spring equals Hertz's contact at the speed\n"
    "                   --at; adds columns hertz_ of Hertz's contact at each --speed\n"
    "  --plot FILE      picture of eps over the speed, .svg, .png or .pdf, by gnuplot\n"
    "  --format F       output format, text, csv or json (default text)\n" HELP_COMMON "\n"
    "Columns: speed_m_s,beta,eps_zero_overlap,eps_zero_force,duration_s_zero_overlap,\n"
    "duration_s_zero_force,max_overlap_m,max_force_n,time_step_s (if a force acts, surface\n"
    "replaces zero_force); step_bias,step_scatter for each end; damping_correction and the corrected damping;\n"
    "measured_end without --end; contact_radius_m,max_pressure_pa. Without --speed quantity,value,unit.\n"
    "With angles speed_m_s,angle_degrees,tangential_speed_m_s,tangential_restitution (-u'/u),\n"
    "rebound_angle_degrees,spin_rad_s (of body 1),regime (stick, slip, both); with --walton\n"
    "speed_m_s,eps,friction,beta_0,largest_error; also end, if needed and not given.\n\n"
    "Example: corgen contact --young 7e10 --poisson 0.2 --radius 5e-3 --density 2500 --restitution 0.9 \\\n"
    "             --at 1 --end zero-force --speed 0.1,1,10\n";

static const struct option_numbers steps_numbers = {{"1", "1e9", true, true, true, "a number from 1 to 1e9"},
                                                    DECIMAL_PLAIN};
static const struct option_numbers tolerance_numbers = {
    {"1e-5", "1", true, true, true, "a number from 1e-5 to 1, the error of eps"}, DECIMAL_PLAIN};

static const struct option_numbers erp_numbers = {{"0", "1", false, true, true, "a number above 0 and up to 1"},
                                                  DECIMAL_PLAIN};
#define ENGINE_APART                                                                                                   \
    "law elastic damping young equivalent stiffness duration restitution damping-coefficient zeta beta g-star "        \
    "dissipation-time "                                                                                                \
    "steps step-tolerance integrator for coefficient eps-inf table"
static const struct values_rule angles = {
    "angle", {"0", "90", true, false, true, "an angle from 0 to below 90 degrees"}, false};
static const struct values_rule tangential_speeds = {
    "tangential-speed", {"0", NULL, true, false, true, "a finite number of m/s, 0 or more"}, false};

#define ARGUMENTS struct contact_arguments
static const struct option_rule options[] = {
    SCENE_OPTIONS(NULL, NULL, ""),
    OPTION("equivalent", WORD, scene.equivalent, .range.words = contact_equivalent_names, .why = "an equivalence",
           .needs = "at"),
    OPTION("speed", LIST, speed, .range.values = &option_speeds, .unit = "m/s"),
    OPTION("steps", REAL, steps, .range.number = &steps_numbers, .needs = "speed",
           .excludes = "time-step step-tolerance"),
    OPTION("time-step", REAL, time_step, .range.number = &option_positive, .needs = "speed",
           .excludes = "step-tolerance"),
    OPTION("step-tolerance", REAL, step_tolerance, .range.number = &tolerance_numbers, .needs = "speed"),
    OPTION("step-corrected", FLAG, step_corrected, .needs = "speed"),
    OPTION("integrator", WORD, integrator, .range.words = cor_integrator_names, .why = "an integrator",
           .needs = "speed"),
    OPTION("erp", REAL, erp, .range.number = &erp_numbers, .needs = "cfm", .excludes = ENGINE_APART),
    OPTION("cfm", REAL, cfm, .range.number = &option_positive, .needs = "erp", .unit = "m/(N s)"),
    OPTION("for", TEXT, simulator, .range.words = contact_simulator_names, .excludes = "format plot"),
    OPTION("simulator-version", TEXT, version, .needs = "for"),
    OPTION("materials", TEXT, materials, .needs = "speed",
           .excludes =
               "plot format tangential-stiffness tangential-damping tangential-restitution walton" SCENE_NUMBERS_APART),
    OPTION("pairs", TEXT, pairs, .needs = "materials"),
    OPTION("friction", REAL, friction, .range.number = &option_not_negative),
    OPTION("angle", LIST, angle, .range.values = &angles, .needs = "friction", .excludes = "tangential-speed"),
    OPTION("tangential-speed", LIST, tangential_speed, .range.values = &tangential_speeds, .unit = "m/s",
           .needs = "friction"),
    OPTION("tangential", TEXT, model, .needs = "friction"),
    OPTION("tangential-stiffness", REAL, tangential_stiffness, .range.number = &option_not_negative,
           .needs = "friction", .excludes = "tangential-restitution"),
    OPTION("tangential-damping", REAL, tangential_damping, .range.number = &option_not_negative, .needs = "friction",
           .excludes = "tangential-restitution"),
    OPTION("walton", FLAG, walton, .needs = "friction"),
    OPTION("tangential-restitution", REAL, tangential, .scene = &cor_scene_options[COR_SCENE_RESTITUTION]),
    OPTION("plot", FILE, plot, .needs = "speed"),
    OPTION_FORMAT(option_formats),
    OPTION_COMMON,
};

SUBCOMMAND(contact, "contact", "one contact in SI units: eps, durations, forces, input of simulators",
           .scene.end = OPTIONS_NOT_GIVEN, .integrator = OPTIONS_NOT_GIVEN);
