/* SPDX-License-Identifier: MIT */
#include "cli/subcommand.h"
#include "support/console.h"

#define HELP_LAW                                                                                                       \
    "  --elastic A, --damping B   exponents of x'' + beta x^B x' + x^A = 0, 0 to 24, as 3/2\n"                         \
    "                             (default 3/2 and 1/2: viscoelastic spheres)\n"
#define HELP_DIGITS "  --digits D       significant digits, each one proved; 1 to 10000000 (default 20)\n"
#define HELP_END "  --end E          zero-overlap (default) or zero-force: what ends the contact\n"
#define HELP_COMMON                                                                                                    \
    "  --output FILE    instead of standard output; replaced whole or not at all\n"                                    \
    "  --profile        seconds per step and peak memory on standard error\n"

static const struct subcommand subcommands[] = {
    {"trajectory", "exact rational coefficients of x(t), any order",
     "Usage: corgen trajectory --order K --terms J [OPTION]...\n\n"
     "Prints x_0 .. x_K of x(t) = sum x_k(t) beta^k exactly; for spheres\n"
     "x_k(t) = t sum_j c[k][j] t^(3k/2 + 5j/2), j = 0 .. J.\n\n"
     "  --order K        highest power of beta, 0 to 100000\n"
     "  --terms J        highest j, 0 to 100000\n"
     "  --format F       text (default), csv, json or latex\n" HELP_LAW HELP_COMMON
     "\nColumns of csv and json: k,j,numerator,denominator.\n"
     "Example: corgen trajectory --order 3 --terms 4\n",
     "order terms format elastic damping output profile", "text csv json latex", "order terms", command_trajectory},
    {"series", "coefficients of x_max, t_max and eps in powers of beta",
     "Usage: corgen series --order K [OPTION]...\n\n"
     "Prints x_max = sum y_k beta^k, t_max = sum tau_k beta^k and eps = sum C_k beta^k; with\n"
     "--end zero-force, eps in powers of sqrt(beta), K being the highest of them.\n\n"
     "  --order K        highest power, 0 to 100000\n" HELP_DIGITS HELP_END
     "  --exact          with --end zero-force: the rational coefficients of G and T in powers of w,\n"
     "                   eps_zero_force = eps_zero_overlap G(w), w = h^(5/2), h = beta eps^(1/5);\n"
     "                   the force vanishes the time h T(w) before the overlap, in its units\n"
     "  --format F       text (default), csv or json\n" HELP_LAW HELP_COMMON
     "\nColumns: k,y_k,tau_k,C_k; with --end zero-force power_of_sqrt_beta,coefficient\n"
     "(power_of_beta_root_R, or power_of_beta, where another law has another root);\n"
     "with --exact power_of_w,G,T.\n"
     "Example: corgen series --order 5 --digits 30\n",
     "order digits end exact format elastic damping output profile", "text csv json", "order", command_series},
    {"pade", "Pade approximants of eps(beta)",
     "Usage: corgen pade --numerator M --denominator N [OPTION]...\n\n"
     "Prints the coefficients of the [M/N] Pade approximant of eps, in powers of beta at zero\n"
     "overlap and of sqrt(beta) at zero force.\n\n"
     "  --numerator M    degree, 0 to 2000\n"
     "  --denominator N  degree, 0 to 2000\n"
     "  --two-point      match also the limit of large beta (zero overlap; N = M + 5)\n"
     "  --as-published   reproduce the published [1/4] from its printed coefficients\n" HELP_DIGITS HELP_END
     "  --header FILE    write the approximant as a C header; refused if it has a pole or a zero\n"
     "                   on beta > 0\n"
     "  --force          write it all the same\n"
     "  --format F       text (default), csv or json\n" HELP_LAW HELP_COMMON
     "\nExample: corgen pade --numerator 12 --denominator 20 --digits 20\n",
     "numerator denominator two-point as-published digits end header force format elastic damping "
     "output profile",
     "text csv json", "", command_pade},
    {"collide", "one collision to any number of digits",
     "Usage: corgen collide --beta B [OPTION]...\n\n"
     "Solves x'' + beta sqrt(x) x' + x^(3/2) = 0, x(0) = 0, x'(0) = 1 and prints the largest\n"
     "overlap, its time, and restitution and duration at both ends of contact.\n\n"
     "  --beta B         0 to 1e6, as 0.1, 1.5e-3 or 2/3\n" HELP_DIGITS
     "  --format F       text (default), csv or json\n" HELP_LAW HELP_COMMON
     "\nColumns: beta,x_max,t_max,eps_zero_overlap,t_zero_overlap,eps_zero_force,t_zero_force.\n"
     "Example: corgen collide --beta 0.1 --digits 30\n",
     "beta digits format elastic damping output profile", "text csv json", "beta", command_collide},
    {"disk-modes", "the free modes of an elastic disk",
     "Usage: corgen disk-modes --poisson NU --count N [OPTION]...\n\n"
     "Prints the N lowest free modes of an elastic disk, by increasing frequency, none missing: n\n"
     "nodal diameters, l = 0, 1, ... among the modes of that n, frequency omega in sqrt(E/rho)/R, and\n"
     "the displacements C (radial, positive) and S (tangential) at the rim, normalised to the area.\n\n"
     "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, as 0.33 or 1/3\n"
     "  --count N        number of modes, 1 to 10000000\n" HELP_DIGITS
     "  --format F       text (default), csv or json\n" HELP_COMMON "\nColumns: n,l,omega,C,S.\n"
     "Example: corgen disk-modes --poisson 0.33 --count 10\n",
     "poisson count digits format output profile", "text csv json", "poisson count", command_disk_modes},
    {"disk-collide", "collisions of elastic disks, over lists of parameters",
     "Usage: corgen disk-collide --speed LIST --poisson LIST --alpha LIST --modes LIST [OPTION]...\n\n"
     "Collides an elastic disk of so many modes with a wall of potential exp(alpha x)/alpha, for\n"
     "every combination of the four lists. Units: E = rho = R = 1.\n\n"
     "  --speed LIST     impact speeds, above 0 and up to 0.5\n"
     "  --poisson LIST   Poisson's ratios in plane stress, between -1 and 1\n"
     "  --alpha LIST     hardnesses of the wall, above 0\n"
     "  --modes LIST     numbers of modes, 1 to 10000000\n"
     "  --tolerance T    error allowed in eps, 1e-13 to below 1 (default " OPTIONS_DEFAULT_COLLISION_TOLERANCE ")\n"
     "  --phi-points M   angles on the quadrant for the wall's force, 1 to 16384\n"
     "                   (default: as many as the tolerance needs)\n"
     "  --threads K      1 to 1024 (default: as many as processors; under mpirun 1 for each rank)\n"
     "  --format F       text (default), csv or json\n"
     "  --output FILE    instead of standard output. Rows are kept in FILE.part till all are\n"
     "                   there; the same command goes on where an interrupted one ended\n"
     "  --profile        seconds per step and peak memory on standard error\n"
     "\nLIST: values and ranges with commas between. 0.1, 1.5e-3 or 1/3 is a value;\n"
     "  A:B:+S     A, A + S, A + 2 S, ... up to B      (-S: down to B)\n"
     "  A:B:lin:N  N values from A to B, equally far apart\n"
     "  A:B:log:N  N values from A to B, each the same multiple of the one before\n"
     "\nColumns: speed,nu,alpha,modes,eps,one_minus_eps2,contact_time,max_compression,energy_drift,\n"
     "steps,status. The speed varies fastest, then modes, alpha, poisson. A row whose status is\n"
     "not ok is kept, and the exit status is then 1.\n"
     "Example: corgen disk-collide --speed 0.01:0.3:log:12 --poisson 0.33,0.9 --alpha 500 --modes 940\n",
     "speed poisson alpha modes tolerance phi-points threads format output profile", "text csv json",
     "speed poisson alpha modes", command_disk_collide},
    {"embed", "a C header with eps of the impact speed for one scene",
     "Usage: corgen embed --speed-min G --speed-max G --tolerance T CONTACT [OPTION]...\n\n"
     "Writes a self-contained header, C99, C++11, CUDA and HIP, with one function from the impact\n"
     "speed in m/s to eps: the cheapest form that meets the tolerance between the two speeds.\n\n"
     "  --speed-min G, --speed-max G   the range of speeds, m/s; outside, the nearer end's value\n"
     "  --tolerance T    relative error of eps allowed, 1e-15 (float: 4e-7) to 0.1\n" HELP_END
     "  --type T         double (default) or float\n"
     "  --for USE        scalar: calls one at a time; array: loops that become vectors; balanced\n"
     "                   (default): both\n"
     "  --name NAME      of the function (default cor_scene_eps); the include guard follows it\n"
     "\nCONTACT is the characteristic speed\n"
     "  --g-star G       m/s, from eps = 1 - (speed/g*)^(1/5) + ...\n"
     "or the materials of two spheres, the second like the first but for what is said of it:\n"
     "  --young Y, --poisson NU      Pa, -\n"
     "  --radius R                   m\n"
     "  --density D or --mass M      kg/m^3, kg\n"
     "  --dissipation-time A         s\n"
     "  --young-2, --poisson-2, --radius-2, --density-2, --mass-2, --dissipation-time-2\n"
     "  --wall           the second is flat and held fast\n\n" HELP_COMMON
     "\nExample: corgen embed --speed-min 0.1 --speed-max 10 --g-star 0.2 --tolerance 1e-6\n",
     "speed-min speed-max tolerance g-star end type for name young poisson radius density mass "
     "dissipation-time young-2 poisson-2 radius-2 density-2 mass-2 dissipation-time-2 wall output profile",
     "", "speed-min speed-max tolerance", command_embed},
    {"plan", "which model a scene needs, what it costs and leaves out",
     "Usage: corgen plan --speed-min G --speed-max G --tolerance T CONTACT [OPTION]...\n"
     "       corgen plan --disks --speed-min V --speed-max V --tolerance T --poisson NU [OPTION]...\n\n"
     "Compares models of restitution with collisions over a range of speeds, and names the cheapest\n"
     "that meets the tolerance, with the command or call to use.\n\n"
     "Spheres: speeds in m/s, T the relative error of eps, 1e-15 to below 1; CONTACT is --g-star, or\n"
     "--young --poisson --radius --density (or --mass) --dissipation-time, -2 of the second sphere, or\n"
     "--wall, as corgen embed --help explains.\n" HELP_END
     "  --for USE        what time means: scalar: calls one at a time; array: loops; balanced\n"
     "                   (default): both\n\n"
     "Disks: speeds in sqrt(E/rho), 0.003 to 0.3; against a hard wall, all modes counted.\n"
     "  --disks          elastic disks, which lose energy to their vibrations\n"
     "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, as 0.33 or 1/3\n"
     "  --quantity Q     eps (default; T is its error), contact-time or compression (the largest; T is\n"
     "                   the relative error)\n\n"
     "  --points N       speeds compared at, 2 to 1000 (default 33, of disks 9)\n"
     "  --format F       text (default), csv or json\n" HELP_COMMON
     "\nColumns of csv and json: model,beta (speed of disks),value,error,cost,uncertainty,verdict;\n"
     "a row for each model at each point; cost in ns; uncertainty of what it is compared with;\n"
     "verdict: chosen, meets, misses, outside (no value somewhere), shown (not to choose).\n"
     "Exit status 1 if no model meets the tolerance.\n"
     "Example: corgen plan --speed-min 0.1 --speed-max 10 --g-star 0.2 --tolerance 1e-6\n",
     "speed-min speed-max tolerance g-star end for young poisson radius density mass dissipation-time young-2 "
     "poisson-2 radius-2 density-2 mass-2 dissipation-time-2 wall disks quantity points format output profile",
     "text csv json", "speed-min speed-max tolerance", command_plan},
    {"tables", "write or check the generated C tables",
     "Usage: corgen tables [--check] [--all] [--output DIR] [OPTION]...\n"
     "       corgen tables --poisson NU [--modes N] [--check] [--output DIR] [OPTION]...\n\n"
     "Writes every file of generated/, or the modes of an elastic disk of another material as a C\n"
     "header to embed and a file to load; all of them or none.\n\n"
     "  --poisson NU     Poisson's ratio in plane stress, between -1 and 1, as 0.33 or 1/3\n"
     "  --modes N        number of modes, 1 to 10000000 (default 1800)\n"
     "  --check          write nothing; compare byte for byte and fail at a difference; collide a\n"
     "                   random sample of the rows of disk_limits.csv again\n"
     "  --all            make disk_limits.csv anew, which is else kept; with --check, collide all of\n"
     "                   its rows again: minutes\n"
     "  --seed N         of the sample, 0 to 1000000000 (default: another one each time)\n"
     "  --output DIR     the directory (default: generated; with --poisson, the current one)\n"
     "  --profile        seconds per step and peak memory on standard error\n"
     "\nExample: corgen tables --check\n",
     "poisson modes check all seed output profile", "", "", command_tables},
    {0},
};

int main(int argc, char **argv)
{
    console_start();
    return subcommand_run(subcommands, COR_VERSION, argc, argv);
}
