/* SPDX-License-Identifier: MIT */
#include "contact/contact.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"

const char *const contact_equivalent_names[] = {"none", "energy", "duration", NULL}; /* enum cor_equivalence */

/* ---- enclosed collisions ---- */

enum { CONTACT_BITS = 64 };
#define ENCLOSED_BETA_MAX 1e12 /* more damping would need many bits and much time */

int contact_enclosed(struct cor_scaled_impact *impact, const struct cor_exponents *law, double beta, int end)
{
    if (!(beta <= ENCLOSED_BETA_MAX))
        return -usage_error("beta is %g at an impact; allowed for x'' + beta x^(%ld/%ld) x' + x^(%ld/%ld) = 0: up to "
                            "%g; use less damping",
                            beta, (long)law_damping(law).num, (long)law_damping(law).den, (long)law_elastic(law).num,
                            (long)law_elastic(law).den, ENCLOSED_BETA_MAX);
    LOCAL_INIT(collision, c, (&c));
    LOCAL(arb, x, force);
    arb_set_d(x, beta);
    const int status = collision_solve_pressed(&c, x, force, law, end, CONTACT_BITS);
    *impact = (struct cor_scaled_impact){{ball_middle(c.eps_zero_overlap), ball_middle(c.eps_zero_force)},
                                         {ball_middle(c.t_zero_overlap), ball_middle(c.t_zero_force)},
                                         ball_middle(c.x_max)};
    return status == 0 ? STATUS_OK : -STATUS_FAILED;
}

int contact_status(int status)
{
    if (status == COR_FAULT_PRESSED)
        return fail("the damping is too strong to integrate an impact under gravity or adhesion; use less damping");
    return status < 0 ? -status : status == COR_FAULT_NONE ? STATUS_OK : STATUS_FAILED;
}

/* ---- a request ---- */

int contacts_of_request(struct contacts *contacts, const struct embed_request *request)
{
    char text[COR_SCENE_FAULT_TEXT];
    struct cor_scene_fault fault;
    struct own_law own; /* only to refuse options of own laws */
    int status = own_law_init(&own, request);
    if (status == STATUS_OK)
        status = embed_request_scene(&contacts->scene, request);
    if (status != STATUS_OK)
        return status;
    const struct cor_scene sphere = contacts->scene;
    contacts->scene.solver = contact_enclosed;
    contacts->at_m_s = sphere.number[COR_SCENE_AT];
    contacts->hertz = (struct cor_scene_contact){.stiffness = 0};
    if (request->equivalent)
        status = cor_scene_equivalent(&contacts->scene, &contacts->hertz, &fault, &sphere, request->equivalent);
    if (status == STATUS_OK)
        status = cor_scene_contacts(contacts->contact, &contacts->count, &fault, &contacts->scene);
    if (status <= 0)
        return status == COR_FAULT_NONE ? STATUS_OK : STATUS_FAILED;
    if (fault.fault == COR_FAULT_NO_DAMPING && contacts->scene.end == COR_END_APPROACH_ONLY)
        return usage_error("--end approach-only with --restitution needs --law viscoelastic, linear, tsuji, "
                           "hertz-dashpot or hunt-crossley; leave out --gravity, --adhesion and --viscosity-liquid");
    const struct cor_scene_contact *const c = &contacts->contact[0];
    const double at_m_s = isnan(contacts->at_m_s) ? 1 : contacts->at_m_s,
                 elastic_s = cor_scene_elastic_duration_s(c, at_m_s), duration_s = sphere.number[COR_SCENE_DURATION];
    if (fault.fault == COR_FAULT_NO_DURATION && !isnan(elastic_s)) {
        const bool longer = duration_s > elastic_s;
        return usage_error("--duration %g: without damping this contact lasts for %.6g s. Damping prolongs a contact "
                           "that ends at zero overlap and shortens a contact that ends at zero force; give --end %s, "
                           "or a %s --duration",
                           duration_s, elastic_s, longer ? "zero-overlap" : "zero-force",
                           longer ? "shorter" : "longer");
    }
    if (fault.fault == COR_FAULT_NO_DAMPING)
        return fail("found no damping that gives eps = %g; give another --restitution or --end",
                    embed_number(request, COR_SCENE_RESTITUTION));
    if (fault.fault == COR_FAULT_VISCOSITY)
        return usage_error("--%s: '%s' is not two numbers, 0 or more, with a comma between them: ETA1,ETA2 in Pa s, "
                           "for example 1e3,2e3",
                           cor_scene_options[fault.number].name,
                           request->viscosity[fault.number == COR_SCENE_VISCOSITY_2]);
    cor_scene_fault_text(text, sizeof text, &fault, law_equation(&contacts->scene.law).text, NULL);
    return usage_error("%s", text);
}

int contacts_without_jkr(struct contacts *contacts, const struct embed_request *request)
{
    const int status = contacts_of_request(contacts, request);
    return status == STATUS_OK && contacts->contact[0].adhesion_j_m2 > 0
               ? usage_error(
                     "--adhesion-model jkr works only in corgen contact, for the speeds of --speed; allowed here: dmt")
               : status;
}

const char *contact_law_text(char text[CONTACT_LAW_TEXT], const struct cor_scene_contact *contact)
{
    int length = contact->plastic ? snprintf(text, CONTACT_LAW_TEXT, "elastic-plastic spheres, v_y = %.6g m/s",
                                             contact->yield_speed_m_s)
                                  : snprintf(text, CONTACT_LAW_TEXT, "%s", law_equation(&contact->law).text);
    if (contact->liquid_speed_m_s > 0)
        snprintf(text + length, (size_t)(CONTACT_LAW_TEXT - length),
                 ", in a liquid that removes %.6g m/s on the way in and on the way out", contact->liquid_speed_m_s);
    return text;
}

void contact_warn(const struct contacts *contacts, double speed_m_s)
{
    const struct cor_scene_contact *const c = &contacts->contact[0];
    const double speed = speed_m_s - c->liquid_speed_m_s, overlap = cor_scene_elastic_overlap(c, speed);
    if (isgreater(overlap, c->radius_m))
        fail("warning: at %g m/s the overlap would be %.4g m, above the effective radius, %.4g m. Hertz's force does "
             "not "
             "hold. Check the units: Young's modulus in Pa, lengths in m, speeds in m/s.",
             speed_m_s, overlap, c->radius_m);
    if (c->plastic || !(c->yield_speed_m_s > 0) || !(speed > c->yield_speed_m_s))
        return;
    fail("warning: at %g m/s the largest Hertzian pressure would be %.4g Pa. The bodies yield at %.4g Pa, 1.6 times "
         "the yield stress. Impacts above %.4g m/s reach this pressure. This law does not describe yield; use --law "
         "elastic-plastic.",
         speed_m_s, cor_scene_pressure(c, cor_scene_elastic_overlap(c, speed)),
         cor_scene_pressure(c, cor_scene_elastic_overlap(c, c->yield_speed_m_s)),
         c->yield_speed_m_s + c->liquid_speed_m_s);
}

/* ---- lines of simulators ---- */

/* Words for the completion of shells; tests/gen/test_contact.c compares them with cor_simulators. */
const char *const contact_simulator_names[] = {
    "lammps",     "liggghts", "yade",   "mercurydpm", "chrono",   "mfix",    "openfoam", "esys-particle",
    "dem-engine", "exadem",   "mujoco", "newton",     "drake",    "simbody", "bullet",   "gazebo",
    "physx",      "isaac",    "pfc",    "edem",       "simscape", "rebound", "modelica", CONTACT_SIMULATOR_LIST,
    NULL};

static long write_text(char *text, size_t size, const struct cor_simulator_request *request)
{
    return request->contacts || request->materials
               ? cor_simulator_lines(text, size, request)
               : cor_simulator_list(text, size, cor_simulator_named(request->simulator));
}

char *contact_simulator_text(const struct cor_simulator_request *request)
{
    char reason[COR_SIMULATOR_REASON];
    if (strcmp(request->simulator, CONTACT_SIMULATOR_LIST) != 0 && !cor_simulator_named(request->simulator)) {
        cor_simulator_lines(reason, sizeof reason, request);
        usage_error("--for: %s, " CONTACT_SIMULATOR_LIST, reason);
        return NULL;
    }
    const long length = write_text(reason, sizeof reason, request);
    if (length < 0)
        return usage_error("%s", reason), NULL;
    char *const text = xmalloc((size_t)length + 1);
    write_text(text, (size_t)length + 1, request);
    return text;
}

char *contact_own_lines(const struct own_law *law, const struct embed_request *request, const char *simulator,
                        const double *speed_m_s, size_t speeds)
{
    static const char word[] = "{embed}";
    const struct cor_simulator *const known = cor_simulator_named(simulator);
    const struct cor_simulator_model *model = NULL;
    double least = speed_m_s[0], largest = least;
    char min[DECIMAL_TEXT], max[DECIMAL_TEXT];
    for (int k = 0; k < known->model_count; k++)
        if (known->models[k].has_function && known->models[k].law == COR_LAW_IMPULSE)
            model = &known->models[k];
    if (!model)
        return usage_error("--for %s: %s has a spring and a dashpot, but --law %s gives only eps; allowed: rebound or "
                           "bullet, which call a function of the speed",
                           simulator, known->title, embed_law_names[law->law]),
               NULL;
    char *text = NULL, *const options = embed_options(request, INT_MAX);
    size_t size;
    FILE *const file = open_memstream(&text, &size);
    fprintf(file, "%s%s, %s%s\n", known->comment, known->title, model->model, known->comment_end);
    for (size_t i = 0; i < speeds; i++) {
        least = fmin(least, speed_m_s[i]);
        largest = fmax(largest, speed_m_s[i]);
        fprintf(file, "%srealises eps = %.6g at %g m/s%s\n", known->comment, own_law_value(law, speed_m_s[i]),
                speed_m_s[i], known->comment_end);
    }
    const double margin = least < largest || law->rows > 0 ? 1 : 10;
    const char *const at = strstr(model->lines, word);
    fprintf(file,
            "%.*scorgen embed --speed-min %s --speed-max %s --tolerance 1e-6%s --name cor_eps --output cor_eps.h%s"
            "%sOutside these speeds cor_eps returns the value at the nearer end of their range.%s\n",
            (int)(at - model->lines), model->lines, decimal_text(min, least / margin),
            decimal_text(max, largest * margin), options, at + strlen(word), known->comment, known->comment_end);
    fclose(file);
    free(options);
    return text;
}

/* ---- several materials ---- */

enum { CONTACT_MOST_MATERIALS = 64 };
enum { NAME, YOUNG, POISSON, DENSITY, RADIUS, RADIUS_MAX, TIME, WALL, MADE_OF, LINE, MATERIAL_COLUMNS };
static const char material_columns[] =
    "name,young_pa,poisson,density_kg_m3,radius_m,radius_max_m,dissipation_time_s,wall,made_of";
enum { A, B, RESTITUTION, AT, END, FRICTION, PAIR_LINE, PAIR_COLUMNS };

/* Reads a number of a row and checks its range. An empty cell gives NaN. Returns an exit status. */
static int read_cell(double *value, const char *option, const struct table *t, char *const *row, int column,
                     enum cor_scene_number number)
{
    const struct cor_scene_option *const range = &cor_scene_options[number];
    struct decimal d = {0};
    *value = NAN;
    if (*row[column] == '\0')
        return STATUS_OK;
    if (decimal_parse(&d, row[column], DECIMAL_EXPONENT_DIGITS) && d.forms == DECIMAL_PLAIN)
        *value = decimal_value(&d);
    decimal_clear(&d);
    return cor_option_allows(range, *value)
               ? STATUS_OK
               : usage_error("--%s, line %s, %s: '%s' is not %s%s%s", option, row[t->columns - 1], t->column[column],
                             row[column], range->allowed, *range->unit ? ", without its unit " : "", range->unit);
}

static int read_material(struct cor_material *m, const struct table *t, char *const *row)
{
    double density;
    const struct {
        double *value;
        int column;
        enum cor_scene_number number;
    } cells[] = {{&m->body.young_modulus_pa, YOUNG, COR_SCENE_YOUNG},
                 {&m->body.poisson_ratio, POISSON, COR_SCENE_POISSON},
                 {&density, DENSITY, COR_SCENE_DENSITY},
                 {&m->body.radius_m, RADIUS, COR_SCENE_RADIUS},
                 {&m->radius_max_m, RADIUS_MAX, COR_SCENE_RADIUS},
                 {&m->body.dissipation_time_s, TIME, COR_SCENE_DISSIPATION_TIME}};
    const bool wall = strcmp(row[WALL], "1") == 0;
    int status = STATUS_OK;
    m->name = row[NAME];
    m->made_of = *row[MADE_OF] ? row[MADE_OF] : NULL;
    for (size_t i = 0; i < sizeof cells / sizeof *cells && status == STATUS_OK; i++)
        status = read_cell(cells[i].value, "materials", t, row, cells[i].column, cells[i].number);
    if (status == STATUS_OK && !wall && *row[WALL] && strcmp(row[WALL], "0") != 0)
        status = usage_error("--materials, line %s, wall: '%s' is not 0, 1 or empty", row[LINE], row[WALL]);
    m->body.mass_kg = wall ? INFINITY : cor_sphere_mass_kg(m->body.radius_m, density);
    m->body.radius_m = wall && isnan(m->body.radius_m) ? INFINITY : m->body.radius_m;
    return status;
}

static int read_pair(struct cor_material_pair *p, const struct table *t, char *const *row,
                     const struct table *materials)
{
    size_t *const place[] = {&p->a, &p->b};
    for (int k = A; k <= B; k++) {
        const size_t count = (size_t)(materials->cells / MATERIAL_COLUMNS);
        for (*place[k] = 0; *place[k] < count; ++*place[k])
            if (strcmp(row[k], materials->cell[*place[k] * MATERIAL_COLUMNS + NAME]) == 0)
                break;
        if (*place[k] == count)
            return usage_error("--pairs, line %s, %s: '%s' is not a name in the file of --materials", row[PAIR_LINE],
                               t->column[k], row[k]);
    }
    for (p->end = 0; contact_end_options[p->end] && strcmp(row[END], contact_end_options[p->end]) != 0;)
        p->end++;
    if (*row[END] && !contact_end_options[p->end])
        return usage_error("--pairs, line %s, end: '%s' is not zero-overlap, zero-force or empty", row[PAIR_LINE],
                           row[END]);
    p->end = *row[END] ? p->end : COR_BOTH_ENDS;
    if (!*row[RESTITUTION] && !*row[FRICTION])
        return usage_error("--pairs, line %s: restitution and friction are empty; give one, or leave out the row",
                           row[PAIR_LINE]);
    int status = read_cell(&p->restitution, "pairs", t, row, RESTITUTION, COR_SCENE_RESTITUTION);
    if (status == STATUS_OK)
        status = read_cell(&p->at_m_s, "pairs", t, row, AT, COR_SCENE_AT);
    return status == STATUS_OK ? read_cell(&p->friction, "pairs", t, row, FRICTION, COR_SCENE_ZETA) : status;
}

char *contact_materials_text(struct cor_simulator_request request, const char *materials, const char *pairs)
{
    struct table m = {0}, p = {0};
    int status = table_read(&m, "materials", materials, material_columns, 5, false);
    if (status == STATUS_OK && pairs)
        status = table_read(&p, "pairs", pairs, "a,b,restitution,at_m_s,end,friction", 2, false);
    const size_t count = (size_t)(m.cells / MATERIAL_COLUMNS), measured = (size_t)(p.cells / PAIR_COLUMNS);
    struct cor_material *const material = xmalloc((count + 1) * sizeof *material);
    struct cor_material_pair *const pair = xmalloc((measured + 1) * sizeof *pair);
    if (count > CONTACT_MOST_MATERIALS)
        status = usage_error("--materials: %zu materials; allowed: up to %d", count, CONTACT_MOST_MATERIALS);
    for (size_t k = 0; k < count && status == STATUS_OK; k++)
        status = read_material(&material[k], &m, &m.cell[k * MATERIAL_COLUMNS]);
    for (size_t k = 0; k < measured && status == STATUS_OK; k++)
        status = read_pair(&pair[k], &p, &p.cell[k * PAIR_COLUMNS], &m);
    request.materials = material;
    request.material_count = count;
    request.pairs = pair;
    request.pair_count = measured;
    request.memory = status == STATUS_OK ? xmalloc(count * count * sizeof *request.memory) : NULL;
    char *const text = status == STATUS_OK ? contact_simulator_text(&request) : NULL;
    free(request.memory);
    free(material);
    free(pair);
    table_clear(&m);
    table_clear(&p);
    return text;
}
