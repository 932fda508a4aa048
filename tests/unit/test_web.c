/* SPDX-License-Identifier: MIT */
/* Tests the sources of the browser's module as native code: numbers and curves against cor/contact.h and cor/scene.h,
 * and refusals. tests/web tests the module itself. */
#include "check.h"

#include "cor/contact.h"
#include "cor/sphere.h"
#include "web/web.h"

int web_read(const char *options);
void web_impacts(const double *speed_m_s, double *y, size_t n);
const char *web_table(int digits, int errors);
const char *web_models(int digits);
const char *web_summary(int digits);
const char *web_lines(int step_errors);
const char *web_curves(void);
void web_curve(const double *speed_m_s, double *y, size_t n, int i);
const char *web_options(void);
const char *web_choices(void);
const char *web_block(char *names, const double *number, size_t n);
void web_step_errors(const double *speed_m_s, double *y, size_t n, double time_step_s);

#define GLASS "young=7e10\npoisson=0.25\nradius=5e-3\ndensity=2500\n"

static void assert_near(double x, double y, double most)
{
    if (!(fabs(x - y) <= most))
        fail_msg("%.17g is not %.17g", x, y);
}

static struct cor_sphere_contact glass(double dissipation_time_s)
{
    const double radius = 5e-3;
    const struct cor_body body = {7e10, 0.25, dissipation_time_s, radius, cor_sphere_mass_kg(radius, 2500)};
    struct cor_sphere_contact contact;
    assert_int_equal(cor_sphere_contact_init(&contact, &body, &body), 0);
    return contact;
}

/* Under gravity the second end is the surface. Tests the name and the numbers of this end, and the header. */
TEST(test_gravity)
{
    double y[8], eps;
    static const char ball[] = "young=1e6\npoisson=0.3\nradius=0.01\ndensity=1000\nwall=yes\ngravity=9.81\n";
    char options[WEB_VALUE * 4];
    snprintf(options, sizeof options, "%srestitution=0.9\nat=1\nend=surface\nspeed=1,0.001", ball);
    assert_int_equal(web_read(options), 1);
    web_impacts(&(double){1}, y, 1);
    assert_near(y[2], 0.9, 1e-12);
    assert_int_equal(cor_scene_eps(&eps, &web_now.contact[0], 0.5, COR_END_ZERO_FORCE), 0);
    web_impacts(&(double){0.5}, y, 1);
    assert_true(y[2] == eps && y[1] < y[2]);
    assert_non_null(strstr(web_table(6, 0),
                           "speed_m_s,beta,eps_zero_overlap,eps_surface,duration_s_zero_overlap,duration_"
                           "s_surface,"));
    assert_non_null(strstr(web_summary(6), "\nsticking_speed_surface,"));
    assert_string_equal(web_curves(), "surface\tsurface\t\n");
    snprintf(options, sizeof options, "%szeta=0.1\nlaw=tsuji", ball);
    assert_int_equal(web_read(options), 1);
    assert_non_null(strstr(web_curves(), "\t\n"));
    snprintf(options, sizeof options, "%sg-star=400\nend=zero-force", ball);
    assert_true(!web_read(options) && strstr(web_wrong.text, "--end surface"));
    assert_true(!web_read(GLASS "g-star=400\nend=surface") && strcmp(web_wrong.option, "end") == 0);
}

/* Returns the next cell of a row of csv, which has no quotes within cells. Moves *row behind this cell. */
static char *cell_of(char **row)
{
    const int quoted = **row == '"';
    char *const cell = *row + quoted, *const end = cell + strcspn(cell, quoted ? "\"" : ",\n");
    *row = end + quoted + 1;
    *end = '\0';
    return cell;
}

/* Converts arguments of corgen to options of the module. */
static void options_of(char *options, char *arguments)
{
    *options = '\0';
    for (char *word = strtok(arguments, " "); word; word = strtok(NULL, " "))
        if (strncmp(word, "--", 2) == 0)
            sprintf(options + strlen(options), "%s%s=%s", *options ? "\n" : "", word + 2,
                    strcmp(word, "--wall") == 0 ? "yes" : "");
        else
            strcat(options, word);
}

/* For every contact of tests/reference/contacts.csv for which the page has fields, the module gives the numbers of this
 * file at the first speed. It also gives the first line for a simulator, or the reason for its absence. */
TEST(test_contacts_of_the_list)
{
    enum { NUMBERS = 7, COLUMNS = 8 };
    char row[4000], options[2000];
    int rows = 0;
    FILE *const file = fopen("tests/reference/contacts.csv", "r");
    assert_true(file && fgets(row, sizeof row, file));
    for (; fgets(row, sizeof row, file); rows++) {
        char *at = row, *const arguments = cell_of(&at);
        double y[4 * COLUMNS], z[4 * COLUMNS]; /* the numbers of two contacts at two speeds */
        options_of(options, arguments);
        if (strcmp(cell_of(&at), "no") == 0)
            continue;
        check(web_read(options), "%s: %s", options, web_wrong.text);
        const int contacts = atoi(cell_of(&at));
        const char *const speed = strstr(options, "\nspeed=");
        const double first = speed ? atof(speed + strlen("\nspeed=")) : 1;
        web_impacts((const double[]){first, 10 * first}, y, 2);
        web_impacts((const double[]){10 * first, first}, z, 2);
        check(same_number(y[2 * NUMBERS], z[2 * NUMBERS]), "%s: the time step is for all speeds", options);
        check(!contacts || contacts == web_now.count, "%s: %d contacts", options, web_now.count);
        for (int i = 0; i < NUMBERS; i++) {
            const char *const cell = cell_of(&at);
            check(!*cell || same_number(y[2 * i], atof(cell)) || fabs(y[2 * i] / atof(cell) - 1) < 1e-11,
                  "%s: number %d: %.13g", options, i, y[2 * i]);
        }
        const char *const line = cell_of(&at), *const lines = *line ? web_lines(0) : "";
        check(!*line || (lines ? strstr(lines, line) : strstr(web_wrong.text, line)), "%s: no line %s", options, line);
    }
    fclose(file);
    assert_true(rows > 70);
}

TEST(test_a_wrong_request_leaves_the_last_one)
{
    static const char *const wrong[][2] = {{GLASS "g-star=-1", "g-star"},
                                           {GLASS "restitution=0.9", "at"},
                                           {GLASS "g-star=1\nspeed=1,,2", "speed"},
                                           {GLASS "g-star=1\nfor=abaqus", "for"},
                                           {GLASS "g-star=1\nviscosity=1", "viscosity"},
                                           {GLASS "g-star=1\nspeed-min=20", "speed-max"},
                                           {GLASS "g-star=1\nspeed-max=1e-4", "speed-max"},
                                           {GLASS "g-star=1\nsteps=0.5", "steps"},
                                           {GLASS "g-star=1\nadhesion-model=x", "adhesion-model"},
                                           {"poisson=0.25\ng-star=1", "young"},
                                           {GLASS "g-star=1e9e9", "g-star"},
                                           {"nonsense", "nonsense"},
                                           {GLASS, "restitution"}};
    assert_true(web_read("g-star=3"));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(web_read(wrong[i][0]));
        assert_string_equal(web_wrong.option, wrong[i][1]);
        assert_true(strlen(web_wrong.text) > 20);
        assert_near(web_now.scene.number[COR_SCENE_G_STAR], 3, 0);
    }
    char longest[2 * WEB_VALUE];
    snprintf(longest, sizeof longest, "g-star=%0*d", WEB_VALUE - 1, 4);
    assert_true(web_read(longest));
    snprintf(longest, sizeof longest, "g-star=%0*d", WEB_VALUE, 4);
    assert_true(!web_read(longest) && strstr(web_wrong.text, "more than 1535 characters"));
}

/* Returns the number after a text; NaN: the text is absent. */
static double number_after(const char *text, const char *before)
{
    const char *const at = strstr(text, before);
    return at ? strtod(at + strlen(before), NULL) : (double)NAN;
}

/* Returns the realised eps, which follows number, name, version, law and end in a line of web_models. */
static double realised(const char *line)
{
    for (int k = 0; k < 5; k++)
        line = strchr(line, '\t') + 1;
    return strtod(line, NULL);
}

TEST(test_curves)
{
    static const double speed[] = {0.01, 1};
    double y[2], eps;
    assert_true(web_read("law=hunt-crossley\nrestitution=0.8\nat=1"));
    assert_string_equal(web_curves(), "eps\tzero-overlap\t\n");
    assert_non_null(strstr(web_summary(6), "\nq,1,1\n"));
    assert_int_equal(web_read(GLASS "restitution=0.9\nat=1\nfor=lammps"), 2);
    assert_string_equal(web_curves(), "zero_overlap\tzero-overlap\t\nzero_force\tzero-force\t\n");
    const char *line = web_models(6);
    for (int i = 0; i < 9; i++) {
        web_curve(speed, y, 2, i);
        for (int k = 0; i < 2 && k < 2; k++) {
            cor_scene_eps(&eps, &web_now.contact[i], speed[k], i);
            assert_true(y[k] == eps);
        }
        if (i < 2)
            continue;
        line = strchr(line, '\n') + 1;
        assert_near(realised(line), y[1], 1e-6);
    }
    web_curve(speed, y, 1, 9);
    assert_true(isnan(y[0]));
}

TEST(test_lines_and_own_maps_of_a_simulator)
{
    assert_true(web_read(GLASS "restitution=0.9\nat=1\nend=zero-overlap\nfor=lammps\nspeed=1"));
    assert_non_null(strstr(web_lines(0), "pair_style granular\n"));
    const char *text = web_models(6);
    assert_non_null(strstr(text, "0.9\t1\tzero overlap\n"));
    const struct cor_simulator *const lammps = cor_simulator_named("lammps");
    int models = 0;
    for (int i = 0; i < lammps->model_count; i++)
        if (lammps->models[i].damping_of_e && !lammps->models[i].has_function) {
            text = strchr(text, '\n') + 1;
            assert_near(realised(text), cor_simulator_realised(&lammps->models[i], 0.9), 1e-6);
            models++;
        }
    assert_int_equal(models, 7);
    /* with one speed and no --at, the requested eps is eps at this speed */
    char request[200];
    const double speed = random_log(&draw, 0.1, 10);
    const struct cor_sphere_contact contact = glass(4e-7);
    snprintf(request, sizeof request, GLASS "dissipation-time=4e-7\nend=zero-force\nfor=lammps\nspeed=%.17g", speed);
    assert_true(web_read(request));
    assert_near(strtod(web_models(15), NULL), cor_contact_eps_zero_force(&contact, speed), 1e-14);
    assert_true(web_read("law=hertz-dashpot\ng-star=3\nend=zero-force\nfor=mfix"));
    assert_null(web_lines(0));
    assert_string_equal(web_wrong.option, "for");
}

TEST(test_headers)
{
    assert_true(web_read("law=tsuji\nrestitution=0.7\nend=zero-force"));
    assert_near(number_after(web_curves(), "zero-force\t"), 0.7, 1e-14);
    assert_true(web_read("g-star=3"));
    assert_string_equal(web_curves(), "zero_overlap\tzero-overlap\t\nzero_force\tzero-force\t\n");
    assert_true(web_read(GLASS "restitution=1\nat=1\nend=zero-force"));
    assert_string_equal(web_curves(), "zero_force\tzero-force\t1\n");
}

/* One line for each number, law and simulator, and no more */
TEST(test_lists)
{
    const char *text = web_options();
    for (int i = 0; i < COR_SCENE_NUMBERS; i++, text = strchr(text, '\n') + 1)
        assert_memory_equal(text, cor_scene_options[i].name, strlen(cor_scene_options[i].name));
    assert_string_equal(text, "speed,m/s\nspeed-min,m/s\nspeed-max,m/s\n");
    assert_non_null(strstr(web_choices(), "\nfor,yade,YADE,leapfrog\n"));
    assert_non_null(strstr(web_choices(), "\nfor,drake,Drake,\n"));
}

/* An end that the bodies never reach: with a given step the error is computed, at the step of the request it is NaN. */
TEST(test_errors_of_infinite_duration)
{
    double y[2];
    assert_true(web_read("law=linear\nzeta=1.5\nstiffness=1e4\neffective-mass=1e-3\nend=zero-overlap"));
    web_step_errors(&(double){1}, y, 1, 1e-5);
    assert_true(y[0] == 0 && y[1] == 0);
    web_step_errors(&(double){1}, y, 1, (double)NAN);
    assert_true(isnan(y[0]) && isnan(y[1]));
}

/* A block of a ball and a wall */
TEST(test_block)
{
    static const double number[] = {1e7, 0.3, 2500, 0.01, 0.5, 1, 1e8, 0.3, 2500, NAN, 0.6, 1};
    char names[] = "ball\nwall";
    assert_true(web_read("law=tsuji\nrestitution=0.5\nfor=yade\nspeed=1"));
    const char *const block = web_block(names, number, 12);
    assert_true(block && strstr(block, "\n# 1 2, ball and wall: measured at this end, eps = 0.6 at 1 m/s\n"));
}
