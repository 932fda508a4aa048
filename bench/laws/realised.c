/* SPDX-License-Identifier: MIT */
/* The restitution that each simulator realises if a user requests e, and the number to enter instead, from the table of
 * cor/scene.h.
 *     cor_realised table      csv, at the values of e of docs/simulators.md
 *     cor_realised curve      csv, at 0.01 to 0.99, for the picture
 *     cor_realised markdown   a table of docs/simulators.md; models with the same end and the same numbers share a row
 *     cor_realised models     csv: all models, with law, end, and a sentence for the user
 *     cor_realised speeds     eps at several speeds, of viscoelastic spheres with eps = 0.5 at 1 m/s, and the results
 *                             of simulators for e = 0.5
 * An empty cell: the model refuses this e, or no input gives this e. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cor/cor.h"
#include "cor/scene.h"

static const double asked[] = {0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99};
enum { ASKED = sizeof asked / sizeof *asked };

static const struct cor_simulator_model *model_at(int i)
{
    return cor_simulator_model((enum cor_simulator_model_id)i);
}

static double cure(const struct cor_simulator_model *m, double e)
{
    enum cor_simulator_status status;
    return cor_simulator_e(m, e, &status);
}

/* ---- csv ---- */

/* Prints a name without commas: gnuplot splits a line at every comma, even in quotation marks. */
static void print_name(const char *text)
{
    for (; *text; text++)
        putchar(*text == ',' ? ';' : *text);
}

static void print_number(const char *before, double x)
{
    printf("%s", before);
    if (!isnan(x))
        printf("%.6f", x);
}

static void print_row(const struct cor_simulator_model *m, double e)
{
    printf("%s: ", cor_simulator_of(m->id)->name);
    print_name(m->model);
    printf(",%s,%g", cor_end_names[m->end], e);
    print_number(",", cor_simulator_realised(m, e));
    print_number(",", cure(m, e));
    printf("\n");
}

static void print_csv(int curve)
{
    printf("model,end,asked,realised,cure\n");
    for (int i = 0; i < COR_SIMULATOR_MODELS; i++)
        if (model_at(i)->damping_of_e)
            for (int k = 0; k < (curve ? 99 : ASKED); k++)
                print_row(model_at(i), curve ? (k + 1) / 100.0 : asked[k]);
}

/* ---- markdown ---- */

static int same_number(double a, double b)
{
    return isnan(a) ? isnan(b) : fabs(a - b) < 5e-7;
}

static int same_row(const struct cor_simulator_model *a, const struct cor_simulator_model *b)
{
    int same = b->damping_of_e && a->end == b->end;
    for (int k = 0; same && k < ASKED; k++)
        same = same_number(cor_simulator_realised(a, asked[k]), cor_simulator_realised(b, asked[k])) &&
               same_number(cure(a, asked[k]), cure(b, asked[k]));
    return same;
}

static int is_first_of_its_row(int i)
{
    for (int k = 0; k < i; k++)
        if (same_row(model_at(k), model_at(i)))
            return 0;
    return model_at(i)->damping_of_e != NULL;
}

static void print_table(const char *title, double (*quantity)(const struct cor_simulator_model *m, double e))
{
    printf("| %s |", title);
    for (int k = 0; k < ASKED; k++)
        printf(" %g |", asked[k]);
    printf("\n|---|");
    for (int k = 0; k < ASKED; k++)
        printf("---|");
    printf("\n");
    for (int i = 0; i < COR_SIMULATOR_MODELS; i++) {
        if (!is_first_of_its_row(i))
            continue;
        printf("| ");
        for (int k = i; k < COR_SIMULATOR_MODELS; k++)
            if (same_row(model_at(i), model_at(k)))
                printf("%s%s (%s): %s", k > i ? "<br>" : "", cor_simulator_of(model_at(k)->id)->name,
                       model_at(k)->version, model_at(k)->model);
        printf(" |");
        for (int k = 0; k < ASKED; k++) {
            print_number(" ", quantity(model_at(i), asked[k]));
            printf(" |");
        }
        printf("\n");
    }
}

/* Prints a cell of csv in quotes. */
static void print_cell(const char *separator, const char *text)
{
    printf("%s\"", separator);
    for (; *text; text++)
        printf(*text == '"' ? "\"\"" : "%c", *text);
    printf("\"");
}

/* Writes the ratio of the model's number to the damping, as a product of powers of mass, stiffness, radius, speed. */
static void write_factor(char *text, size_t size, const struct cor_simulator_model *m)
{
    const struct cor_scene_contact one = {.mass_kg = 1, .stiffness = 1, .radius_m = 1};
    const double number = m->number_of_damping(m, 1, &one, 1);
    int length = snprintf(text, size, "%.6g", number);
    for (int i = 0; i < 4; i++) {
        struct cor_scene_contact two = one;
        *(i == 0 ? &two.mass_kg : i == 1 ? &two.stiffness : &two.radius_m) = i == 3 ? 1 : 2;
        const double power = log2(m->number_of_damping(m, 1, &two, i == 3 ? 2 : 1) / number);
        if (fabs(power) > 1e-9)
            length += snprintf(text + length, size - (size_t)length, " %c^%.6g", "MKRG"[i], power);
    }
}

static void print_models(void)
{
    printf("simulator,version,model,number,over_the_damping,law,end,remark,file,known\n");
    for (int i = 0; i < COR_SIMULATOR_MODELS; i++) {
        const struct cor_simulator_model *const m = model_at(i);
        char factor[80] = "";
        if (m->id == COR_YADE_EN_VN)
            snprintf(factor, sizeof factor, "P(v)/v^2, v^2 = beta/G^0.2");
        else if (m->number_of_damping)
            write_factor(factor, sizeof factor, m);
        const char *const cell[] = {
            cor_simulator_of(m->id)->name, m->version, m->model, m->parameter, factor, cor_law_name(m->law),
            cor_end_names[m->end],         m->advice,  m->file,  m->known};
        for (size_t k = 0; k < sizeof cell / sizeof *cell; k++)
            print_cell(k ? "," : "", cell[k]);
        printf("\n");
    }
}

/* ---- eps as a function of the speed ---- */

static void print_speeds(void)
{
    const double g_star = pow(-COR_SPHERE_C1 * cor_sphere_beta_zero_force(0.5), -5);
    const double lammps = cor_simulator_realised(cor_simulator_model(COR_LAMMPS_HERTZ_TSUJI), 0.5);
    const double chrono = cor_simulator_realised(cor_simulator_model(COR_CHRONO_MATERIAL), 0.5);
    struct cor_sphere_contact contact;
    if (cor_sphere_contact_init_g_star(&contact, g_star) != COR_OK)
        return;
    printf("speed_m_s,eps_zero_overlap,eps_zero_force,constant,lammps,chrono\n");
    for (int k = 0; k <= 80; k++) {
        const double speed = pow(10, -3 + k / 20.0);
        printf("%.6g,%.6f,%.6f,0.5,%.6f,%.6f\n", speed, cor_contact_eps_zero_overlap(&contact, speed),
               cor_contact_eps_zero_force(&contact, speed), lammps, chrono);
    }
}

int main(int argc, char **argv)
{
    const char *form = argc == 2 ? argv[1] : "";
    if (strcmp(form, "table") == 0 || strcmp(form, "curve") == 0) {
        print_csv(*form == 'c');
    } else if (strcmp(form, "markdown") == 0) {
        print_table("realised e for the requested e =", cor_simulator_realised);
    } else if (strcmp(form, "models") == 0) {
        print_models();
    } else if (strcmp(form, "speeds") == 0) {
        print_speeds();
    } else {
        fprintf(stderr, "cor_realised takes one argument: table, curve, markdown, models or speeds\n");
        return 2;
    }
    return 0;
}
