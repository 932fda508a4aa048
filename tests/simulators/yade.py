# SPDX-License-Identifier: MIT
# Head-on collisions of two viscoelastic spheres of unequal size in YADE, and their eps.
#     yade -x -n -j1 tests/simulators/yade.py LAW [VALUE [SPEED]]
# for one of the LAWs
#     vn        en and vn of Ip2_FrictMat_FrictMat_MindlinPhys: VALUE is en at the impact speed SPEED
#     step      c_n = A k_n, by setting betan before every step: VALUE is the dissipation time A in s
#     betan     betan constant, VALUE: damping like x^(1/4), another law than the spheres'
#     table     a linear spring and dashpot whose coefficient is set at each first contact so that the pair rebounds
#               with the eps that a table has at this impact speed; VALUE is a file of corgen sample --format python,
#               made with --log and --end zero-force
#     gravity   a linear spring K and dashpot C that never pulls, VALUE is K,C: a ball of 4 g on a fixed one, under
#               gravity. It prints "gravity VALUE SPEED EPS", EPS where the surfaces part
# prints, for three time steps,
#     eps LAW VALUE SPEED STEP VALUE FORCE
# SI units; the step in units of (rho/m)^(-2/5) g^(-1/5); FORCE, at last, must be zero.
# LAW may be "version": has this YADE got vn?
import atexit
import os
import shutil
import sys
from bisect import bisect
from math import acos, log, pi, sqrt

radius, mass = (0.005, 0.02), (0.002, 0.008)
kn = 1e6  # (4/3) E_eff, Pa
reff = radius[0] * radius[1] / sum(radius)
meff = mass[0] * mass[1] / sum(mass)
rho = kn * sqrt(reff)
root = (rho / meff)**0.4


# YADE leaves an empty folder behind
atexit.register(shutil.rmtree, os.path.dirname(O.tmpFilename()), ignore_errors=True)


def betan_of(A, overlap):
    """c_n = 2 betan sqrt(m k_n) = A k_n with the tangent stiffness k_n = (3/2) rho sqrt(overlap)"""
    return 0.5 * A * sqrt(1.5 * rho * sqrt(max(overlap, 0.0)) / meff)


def set_betan():
    if O.interactions.countReal():
        overlap = sum(radius) - (O.bodies[1].state.pos[0] - O.bodies[0].state.pos[0])
        O.interactions[0, 1].phys.betan = betan_of(dissipation_time, overlap)


def collide(material, functor, law, speed, step, count, before_step=()):
    """(eps, last force) of a collision of so many steps, in s"""
    O.reset()
    O.materials.append(material)
    for i, side in enumerate((-1, 1)):
        O.bodies.append(sphere((side * radius[i], 0, 0), radius[i], material=material))
        O.bodies[i].state.mass = mass[i]
    O.bodies[0].state.vel = (speed, 0, 0)
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()])] + [
        PyRunner(command=command, iterPeriod=1) for command in before_step] + [
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [functor], [law]), NewtonIntegrator(damping=0)]
    O.dt = step
    O.run(count, True)
    return (O.bodies[1].state.vel[0] - O.bodies[0].state.vel[0]) / speed, O.forces.f(0).norm()


# ---- a table of eps over the impact speed ----


def read_table(name):
    columns = {}
    with open(name) as file:
        exec(file.read(), columns)
    return columns["speed_m_s"], columns["eps"]


def eps_at(table, speed):
    """Linear interpolation in the logarithm of the speed; beyond the table its first or last eps"""
    speeds, eps = table
    if not speeds[0] < speed < speeds[-1]:
        return eps[0 if speed <= speeds[0] else -1]
    i = bisect(speeds, speed)
    part = log(speed / speeds[i - 1]) / log(speeds[i] / speeds[i - 1])
    return eps[i - 1] + part * (eps[i] - eps[i - 1])


def zeta_of(eps):
    """Damping ratio of a linear dashpot from eps at zero force: -ln eps = 2 zeta acos(zeta)/sqrt(1 - zeta^2). It is
    below 1 for eps above exp(-2)."""
    low, high = 0.0, 1.0
    for _ in range(60):
        zeta = (low + high) / 2
        if 2 * zeta * acos(zeta) / sqrt(1 - zeta * zeta) < -log(eps):
            low = zeta
        else:
            high = zeta
    return low


def set_dashpots():
    """cn of the contacts that began in the last step: they have none yet"""
    for i in O.interactions:
        if i.isReal and i.phys.cn == 0:
            first, second = O.bodies[i.id1].state, O.bodies[i.id2].state
            speed = (first.vel - second.vel).dot(i.geom.normal)
            m = first.mass * second.mass / (first.mass + second.mass)
            i.phys.cn = 2 * zeta_of(eps_at(table, speed)) * sqrt(m * i.phys.kn)


def report_table(name, speed):
    global table
    table = read_table(name)
    for count in (400, 800, 1600):  # steps in the contact of an elastic spring
        rubber = ViscElMat(kn=2e5, cn=0, ks=0, cs=0, density=1000)
        eps, force = collide(rubber, Ip2_ViscElMat_ViscElMat_ViscElPhys(), Law2_ScGeom_ViscElPhys_Basic(), speed,
                             pi / count * sqrt(meff / 1e5), 2 * count, ["set_dashpots()"])
        print("eps table %s %s %d %.17g %g" % (name, speed, count, eps, force))


def report_gravity(value, speed):
    K, C = (float(number) for number in value.split(","))
    O.reset()
    O.materials.append(ViscElMat(kn=2 * K, cn=2 * C, ks=0, cs=0, density=1000))
    O.bodies.append([sphere((0, 0, 0), 0.01, fixed=True), sphere((0.02, 0, 0), 0.01)])
    ball, g = O.bodies[1].state, 9.81
    ball.mass, ball.vel, O.dt = 4e-3, (-speed, 0, 0), 1e-6
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
                 InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                                 [Law2_ScGeom_ViscElPhys_Basic()]), NewtonIntegrator(damping=0, gravity=(-g, 0, 0))]
    while O.iter < 2 or ball.pos[0] < 0.02 and O.iter < 40000:
        O.step()
    up = ball.vel[0] - g * O.dt / 2  # YADE has the velocity of half a step ago
    print("gravity %s %g %.9g" % (value, speed, sqrt(max(0, up * up + 2 * g * (ball.pos[0] - 0.02))) / speed))


def report(law, value, speed):
    global dissipation_time
    for step in (8e-4, 4e-4, 2e-4) if law == "step" else (16e-5, 8e-5, 4e-5):
        seconds = step / (root * speed**0.2)
        numbers = {"vn": dict(en=value, vn=speed), "betan": dict(betan=value, betas=0)}
        if law == "step":
            dissipation_time = value
            numbers["step"] = dict(betan=betan_of(value, speed * seconds), betas=0)
        # Two half spaces of Young's modulus Y and Poisson's ratio 0 have E_eff = Y/2.
        rubber = FrictMat(young=1.5 * kn, poisson=0, frictionAngle=0, density=1000)
        eps, force = collide(rubber, Ip2_FrictMat_FrictMat_MindlinPhys(**numbers[law]),
                             Law2_ScGeom_MindlinPhys_Mindlin(), speed, seconds, int(3.3 / step),
                             ["set_betan()"] * (law == "step"))
        print("eps %s %.17g %s %g %.17g %g" % (law, value, speed, step, eps, force))


arguments = sys.argv[1:]
if arguments == ["version"]:
    print("vn", "yes" if hasattr(Ip2_FrictMat_FrictMat_MindlinPhys, "vn") else "no")
while arguments and arguments != ["version"]:
    if arguments[0] == "table":
        report_table(arguments[1], float(arguments[2]))
    elif arguments[0] == "gravity":
        report_gravity(arguments[1], float(arguments[2]))
    else:
        report(arguments[0], float(arguments[1]), float(arguments[2]))
    arguments = arguments[3:]
