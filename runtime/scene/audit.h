/* SPDX-License-Identifier: MIT */
/* What the readers of inputs share: memory, lines and numbers (audit_text.c), and contacts (audit.c). */
#ifndef COR_RUNTIME_SCENE_AUDIT_H
#define COR_RUNTIME_SCENE_AUDIT_H

#include "cor/audit.h"

enum {
    AUDIT_TYPES = 64,
    AUDIT_CONTACTS = 128,
    AUDIT_VARIABLES = 256,
    AUDIT_PROPERTIES = 24,
    AUDIT_VALUES = 100, /* of a property: ten types */
    AUDIT_SPEEDS = 8,
    AUDIT_POOL = 1 << 16,
    AUDIT_LINE = 1 << 13,
    AUDIT_WORDS = 1 << 9,
    AUDIT_ADVICE = 1 << 10,
    AUDIT_INCLUDES = 16,         /* nested */
    AUDIT_INCLUDES_IN_ALL = 100, /* a file may include itself twice */
    AUDIT_DEPTH = 40,            /* of parentheses, and of variables in variables */
    AUDIT_EVALUATIONS = 1 << 20  /* numbers and names in all: variables may double at each level */
};

/* How the stiffness of a contact is given */
enum audit_spring {
    AUDIT_NO_SPRING,
    AUDIT_HOOKE,          /* K, N/m */
    AUDIT_HERTZ,          /* k_n = K/sqrt(R), Pa */
    AUDIT_MATERIAL,       /* Hertz, by Young's modulus and Poisson's ratio of both types */
    AUDIT_CHARACTERISTIC, /* linear, by the materials and a characteristic speed */
    AUDIT_CONTACT_TIME,   /* linear, with the duration of a contact that ends at zero overlap */
    AUDIT_PER_MASS        /* linear, K/m */
};

struct audit_type {
    const char *name;
    double radius[2]; /* least and largest; NaN: not known */
    double density, young, poisson;
};

struct audit_contact {
    const char *file, *text; /* the line with its variables replaced */
    long line;
    int word[2];           /* of `text`, those that hold e; -1: none */
    const char *model;     /* of cor_simulators */
    int limited;           /* the same model, but it ends at zero force */
    const char *pair;      /* NULL: named by its types */
    int first[2], last[2]; /* types of both bodies, from 0 */
    int wall;              /* body 2 is one; AUDIT_MATERIAL takes its material from its type */
    double number;         /* e, or the number that the model takes */
    enum audit_spring spring;
    double stiffness, speed; /* of the spring */
    int harmonic;            /* stiffnesses of two types mix by their harmonic mean, otherwise the geometric one */
    double impedance[3];     /* MuJoCo's dmin, dmax and width; 0, 0, 0: none, or all the same */
    int condim;              /* MuJoCo's; 0: not MuJoCo */
    const char *fault;       /* a sentence, or NULL */
    int unknown;             /* eps cannot be computed; `fault` says why */
};

struct audit_variable {
    const char *name, *text;
    int formula; /* LAMMPS evaluates `text` when the variable is used */
};

struct audit_property {
    const char *name, *file, *text;
    long line;
    int word, count; /* of its first value in `text` */
    int types;       /* rows of a matrix */
    double value[AUDIT_VALUES];
};

struct audit {
    const struct cor_audit_options *options;
    const char *simulator;
    struct cor_audit_text text; /* the one that is read */
    long line, next_line;       /* the first of the one that is read, and the one after it */
    size_t at;                  /* where the next one starts */
    int depth, includes, evaluations;
    int integrator;       /* of the simulator, or COR_NO_INTEGRATOR */
    double steps_left;    /* that the errors of time steps may still take */
    int is_full;          /* there are more contacts than memory for them */
    int found, unsettled; /* contacts reported; contacts or lines that are not known to be as asked */

    struct audit_type type[AUDIT_TYPES];
    struct audit_contact contact[AUDIT_CONTACTS];
    struct audit_variable variable[AUDIT_VARIABLES];
    struct audit_property property[AUDIT_PROPERTIES];
    int types, contacts, variables, properties;
    double speed[AUDIT_SPEEDS]; /* SI, like the two below */
    int speeds;
    double time_step;
    double length, mass, time; /* units of the text in SI */

    char pool[AUDIT_POOL];
    size_t used;
    char raw[AUDIT_LINE], split[AUDIT_LINE];
    const char *word[AUDIT_WORDS]; /* of a script's line, in `split` */
    int words;
    char advice[AUDIT_ADVICE], instead[AUDIT_LINE], pair[64], model[160], printed[AUDIT_LINE];
};

/* ---- audit_text.c ---- */

int audit_is(const char *text, const char *other); /* equal */
int audit_starts(const char *text, const char *start);
int audit_is_space(char c);
int audit_is_of_name(char c);
/* A number that is the whole text; NaN otherwise. Exponents by e or d. */
double audit_number(const char *text);
/* A copy that lasts; "" once the pool is full. */
const char *audit_keep(struct audit *a, const char *text, size_t size);
/* Appends to a text of `size` bytes what fits; % stands for a double, @ for one with 15 digits, $ for a text. */
void audit_append(char *text, size_t size, const char *format, ...);
/* The same as a text that lasts until the next call, as one that lasts, and as a sentence of the advice */
const char *audit_print(struct audit *a, const char *format, ...);
const char *audit_kept(struct audit *a, const char *format, ...);
void audit_say(struct audit *a, const char *format, ...);

/* Reads the next line into a->raw, without its comment, with its continuations; those of Python keep their line ends.
 * 0: there is none. */
enum audit_language { AUDIT_SCRIPT, AUDIT_PYTHON, AUDIT_NAMELIST };
int audit_next_line(struct audit *a, enum audit_language language);

/* Reads into a->raw the text up to one of the characters `ends`, behind the character `start` where there is one, and
 * without comments of XML. Commas in brackets end nothing. 0: there is none. */
int audit_next_part(struct audit *a, const char *ends, const char *start);

/* The value of an expression of numbers, names, functions and operators; NaN if it has none. */
double audit_value(struct audit *a, const char *text);
double audit_value_of(struct audit *a, const char *text, size_t size); /* up to 255 characters; NaN: more */
struct audit_variable *audit_variable_named(struct audit *a, const char *name, size_t size);
void audit_set_variable(struct audit *a, const char *name, const char *text, int formula);

/* ---- audit.c ---- */

/* Names a line that cannot be read; `word` may be NULL. */
void audit_remark(struct audit *a, const char *sentence, const char *word);
/* The same where the contacts can be judged nevertheless */
void audit_note(struct audit *a, const char *sentence, const char *word);
/* A new contact of the present line, with no number known; never NULL. */
struct audit_contact *audit_add(struct audit *a, const char *text);
void audit_between(struct audit_contact *contact, int i, int j); /* of the types i and j alone */
int audit_covers(const struct audit_contact *contact, int i, int j);
void audit_unknown(struct audit_contact *contact, const char *reason);
void audit_clear_types(struct audit *a);
void audit_set_time_step(struct audit *a, double step_s); /* unless the options say one */
/* Reports all contacts since the last call. */
void audit_flush(struct audit *a);
void audit_add_speed(struct audit *a, double speed);

/* ---- readers ---- */

/* Reads another text, and goes on with this one. */
void audit_include(struct audit *a, const char *name, void (*read)(struct audit *a, void *context), void *context);
void audit_script(struct audit *a); /* LAMMPS and LIGGGHTS: audit_script.c */
void audit_yade(struct audit *a);   /* the others: audit_keys.c */
void audit_kratos(struct audit *a);
void audit_mfix(struct audit *a);
void audit_mujoco(struct audit *a);

#endif
