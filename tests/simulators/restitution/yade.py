# SPDX-License-Identifier: MIT
# Head-on collisions of two spheres in YADE with lines of corgen contact --for yade.
#     yade -x -n -j1 yade.py PASTE DURATION N,N,N [PASTE DURATION N,N,N]...
# prints for each N, with DURATION/(N + 1/2) as the time step in s,
#     eps PASTE N VALUE CHANGE
# CHANGE of the velocity after the contact must be 0. SI units; the bodies are those of run.
import atexit
import os
import shutil
import sys

# YADE leaves an empty folder behind
atexit.register(shutil.rmtree, os.path.dirname(O.tmpFilename()), ignore_errors=True)


def engines(line):
    """The material of the bodies and the functors of the contact, from one line of corgen"""
    pasted = eval(line)
    if isinstance(pasted, Material):
        return pasted, [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]
    return FrictMat(young=1e7, poisson=0.3, frictionAngle=0), [pasted], [Law2_ScGeom_MindlinPhys_Mindlin()]


def collide(line, step, steps):
    O.reset()
    material, physics, law = engines(line)
    linear = isinstance(material, ViscElMat)
    # the numbers of ViscElMat hold for two equal bodies
    radius, mass = ((0.008, 0.008), (0.0032, 0.0032)) if linear else ((0.005, 0.02), (0.002, 0.008))
    O.materials.append(material)
    for i, side in enumerate((-1, 1)):
        O.bodies.append(sphere((side * radius[i], 0, 0), radius[i], material=material))
        O.bodies[i].state.mass = mass[i]
    O.bodies[0].state.vel = (1, 0, 0)
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], physics, law),
        NewtonIntegrator(damping=0)
    ]
    O.dt = step
    speeds = []
    for length in (int(1.3 * steps), int(0.1 * steps)):
        O.run(length, True)
        speeds.append(O.bodies[1].state.vel[0] - O.bodies[0].state.vel[0])
    return speeds


arguments = sys.argv[1:]
while arguments:
    paste, duration, counts = arguments[:3]
    arguments = arguments[3:]
    for count in counts.split(","):
        before, after = collide(open(paste).read(), float(duration) / (int(count) + 0.5), int(count))
        print("eps %s %s %.17g %.3g" % (paste, count, after, after - before))
