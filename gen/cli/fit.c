/* SPDX-License-Identifier: MIT */
/* corgen fit fits models of restitution to measured points, and ranks them. */
#include <math.h>
#include <string.h>

#include <cor/status.h>

#include "cli/commands.h"
#include "cli/scene_options.h"
#include "fit/compare.h"
#include "support/console.h"
#include "support/gnuplot.h"

/* ---- bodies ---- */

/* Fills the bodies. A wall may be a plate, if its density is known. */
static int read_bodies(struct fit_bodies *bodies, const struct embed_request *request)
{
    struct cor_scene scene;
    struct cor_scene_fault fault;
    struct cor_sphere_contact contact;
    char text[COR_SCENE_FAULT_TEXT];
    int status = embed_request_scene(&scene, request);
    if (status != STATUS_OK)
        return status;
    if (cor_scene_check_bodies(&fault, &scene, COR_SCENE_DENSE_WALL) != COR_FAULT_NONE) {
        cor_scene_fault_text(text, sizeof text, &fault, "",
                             "bodies have --young, --poisson, --radius and --density or --mass, as --young 7e10 "
                             "--poisson 0.24 --radius 0.01 --density 2500");
        return usage_error("%s", text);
    }
    bodies->body_1 = cor_scene_body(&scene, 1);
    bodies->body_2 = cor_scene_body(&scene, 2);
    bodies->density_2_kg_m3 = scene.wall && !cor_scene_mass_is_given(&scene, 2)
                                  ? cor_scene_of_body(&scene, COR_SCENE_DENSITY, 2)
                                  : (double)NAN;
    const int wrong = cor_sphere_contact_init(&contact, &bodies->body_1, &bodies->body_2);
    return wrong == COR_OK ? STATUS_OK : usage_error("the bodies make no contact: %s", cor_status_text(wrong));
}

/* ---- output ---- */

/* Writes the table and the picture: both or neither. */
static int write_results(const struct fit_arguments *o, const struct fit_report *report)
{
    const enum output_format format = (enum output_format)o->common.format;
    struct output out[2] = {{0}};
    int status = output_open(&out[0], o->common.output);
    if (status == STATUS_OK && o->plot)
        status = output_open(&out[1], o->plot);
    if (status == STATUS_OK && o->plot)
        status = fit_plot(report, file_name(o->data), out[1].file, o->plot);
    if (status != STATUS_OK) {
        output_discard(&out[0]);
        output_discard(&out[1]);
        return status;
    }
    fit_report_print(report, format, out[0].file);
    status = output_commit_all(out, o->plot ? 2 : 1);
    if (status == STATUS_OK && format != FORMAT_TEXT)
        progress_hold(), fit_report_remarks(report, stderr);
    return status;
}

static const char *const separator_names[] = {"comma", "semicolon", "tab", NULL};

static int run_fit(const void *arguments)
{
    static const char separators[] = ",;\t";
    const struct fit_arguments *const o = arguments;
    struct fit_request request = {.robust = o->robust};
    struct fit_bodies bodies;
    struct fit_form form = {.unit = (enum fit_unit)o->unit,
                            .gravity_m_s2 = options_number(&o->gravity, FIT_GRAVITY_M_S2),
                            .decimal_comma = o->decimal_comma};
    struct fit_data data;
    struct fit_report report = {.data = &data, .request = &request};
    if (o->plot && gnuplot_check(o->plot) != STATUS_OK)
        return STATUS_USAGE;
    int status = fit_request_models(&request, o->law, o->end == OPTIONS_NOT_GIVEN ? NULL : contact_end_options[o->end]);
    for (int i = 0; o->separator && separator_names[i]; i++)
        if (strcmp(o->separator, separator_names[i]) == 0 || strcmp(o->separator, (char[]){separators[i], '\0'}) == 0)
            form.separator = separators[i];
    if (status == STATUS_OK && o->separator && !form.separator)
        status = usage_error("--separator: '%s' is not a separator; allowed: comma, semicolon, tab", o->separator);
    bool given = o->scene.wall;
    for (int number = COR_SCENE_YOUNG; number <= COR_SCENE_DISSIPATION_TIME_2; number++)
        given = given || embed_given(&o->scene, number);
    if (status == STATUS_OK && given) {
        status = read_bodies(&bodies, &o->scene);
        request.bodies = &bodies;
    }
    if (status == STATUS_OK)
        status = fit_data_read(&data, o->data, &form);
    if (status != STATUS_OK)
        return status;
    profile_step("fits");
    fit_compare(&report.comparison, &data, &request);
    if (report.comparison.models == 0) {
        status = usage_error("%s has %zu points; allowed: at least one more than the parameters of the model", o->data,
                             data.points);
    } else {
        profile_step("outliers");
        fit_find_outliers(&report.outliers, &data, &request);
        if (report.outliers.count > 0)
            fit_compare(&report.without_outliers, &report.outliers.rest, &request);
        profile_step(NULL);
        status = write_results(o, &report);
        fit_data_clear(&report.outliers.rest);
    }
    fit_data_clear(&data);
    return status;
}

static const char help[] =
    "Usage: corgen fit DATA.csv [BODIES] [OPTION]...\n\n"
    "Fits models of restitution to measured points, eps over the impact speed, by weighted least squares,\n"
    "and ranks them by Akaike's information criterion (AIC; the least is best). Says which models fit.\n\n"
    "DATA.csv, or --data DATA.csv, names its columns in the first row, in any order; # begins a comment, - is\n"
    "standard input:\n"
    "  speed_m_s,eps[,eps_sigma]   points; eps_sigma is the standard deviation of eps. speed_cm_s or\n"
    "                   speed_mm_s, or speed with --unit, in other units\n"
    "  [run,]t_s        or the times at which a ball bounces: a flight of T seconds lands at the speed\n"
    "                   g T/2, and eps is the ratio of successive flights, without air drag; another\n"
    "                   text in the column run begins another drop\n"
    "  --unit U         m/s, cm/s or mm/s: the unit of the speeds\n"
    "  --separator S    comma, semicolon or tab (default: the one that the first row has most of)\n"
    "  --decimal-comma  numbers have a decimal comma, not a point\n"
    "  --gravity G      m/s^2, for bounces (default 9.80665)\n\n"
    "  --law NAMES      all (default), or several of viscoelastic, plate, constant, linear, tsuji,\n"
    "                   hunt-crossley, hertz-dashpot, power-law, elastic-plastic, adhesive,\n"
    "                   adhesive-viscoelastic, wet, wet-viscoelastic, as viscoelastic,power-law\n"
    "  --end E          zero-overlap or zero-force: only this end of contact (default: both)\n"
    "  --robust         Huber's function, linear beyond 1.345 sigma, not squares: outliers have little weight\n"
    "  --plot FILE      a picture of data, fits and residuals, .svg, .png or .pdf (needs gnuplot)\n"
    "  --format F       text (default), csv or json\n" HELP_COMMON
    "\nParameters: g_star_m_s, from eps = 1 - (speed/g*)^(1/5) + ...; zener_lambda_at_1_m_s of a thin plate;\n"
    "eps, zeta (damping ratio); dissipation_s_m, d of the force F(x) (1 + d x'); beta_at_1_m_s of a Hertzian\n"
    "contact with a dashpot; eps_at_1_m_s and exponent of min(1, eps_at_1_m_s (speed/(1 m/s))^exponent).\n"
    "yield_speed_m_s, from which spheres yield; eps_dry or g_star_m_s with adhesion_speed_m_s v_s of\n"
    "sqrt(eps^2 - (v_s/v)^2), or with liquid_speed_m_s s of (eps (v - s) - s)/v.\n"
    "With BODIES instead yield_stress_pa; dissipation_time_s, A; plate_thickness_m (with --wall); "
    "damping_coefficient_n_s_m:\n"
    "  --young Y, --poisson NU, --radius R, --density D or --mass M     SI units\n"
    "  --young-2, --poisson-2, --radius-2, --density-2, --mass-2        where the second body differs\n"
    "  --young-2 inf    the second is rigid\n"
    "  --wall           the second is flat and held fast\n\n"
    "Columns of csv and json: model,end,parameter,value,low_68,high_68,low_95,high_95,rms,chi2,aic.\n"
    "The intervals are those of the profile likelihood, 68 means 68.27 %; rms of the residuals; chi2 only with\n"
    "eps_sigma. p below 0.01 means that a model does not fit: p of chi2 or, without eps_sigma and with\n"
    "--robust, of the means of neighbouring residuals. As csv and json, these remarks go to standard error.\n"
    "\nExample: corgen fit measured.csv --law viscoelastic,constant --plot measured.svg\n";

#define ARGUMENTS struct fit_arguments
/* Single models only: a shell need not offer lists of them. */
static const char *const law_words[] = {
    "all",      "viscoelastic",          "plate",         "constant",         "linear",
    "tsuji",    "hunt-crossley",         "hertz-dashpot", "power-law",        "elastic-plastic",
    "adhesive", "adhesive-viscoelastic", "wet",           "wet-viscoelastic", NULL};

static const struct option_rule options[] = {
    OPTION("data", FILE, data, .required = true, .operand = "DATA.csv"),
    OPTION("unit", WORD, unit, .range.words = fit_unit_names, .why = "a unit"),
    OPTION("gravity", REAL, gravity, .range.number = &option_positive, .unit = "m/s^2"),
    OPTION("law", TEXT, law, .range.words = law_words),
    OPTION_END(end),
    OPTION("separator", TEXT, separator, .range.words = separator_names),
    OPTION_PLAIN("decimal-comma", FLAG, decimal_comma),
    OPTION_PLAIN("robust", FLAG, robust),
    OPTION_PLAIN("plot", FILE, plot),
    SCENE_BODY("", , NULL, NULL, NULL, NULL),
    SCENE_BODY("-2", _2, &option_positive_or_infinite, NULL, NULL, NULL),
    OPTION_PLAIN("wall", FLAG, scene.wall),
    OPTION_FORMAT(option_formats),
    OPTION_COMMON,
};

SUBCOMMAND(fit, "fit", "models of restitution fitted to measured points", .law = "all", .end = OPTIONS_NOT_GIVEN,
           .unit = FIT_UNIT_OF_COLUMN);
