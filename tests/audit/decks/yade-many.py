# SPDX-License-Identifier: MIT | after YADE scripts of oedometers with thousands of random grains, GitHub | MIT | speed=0.1
import random
O.materials.append(FrictMat(young=1e7, poisson=0.3, density=2500, frictionAngle=0.5, label='grain'))
for i in range(9000):
    x, y, z = (random.uniform(0.1 * (i % 7), 1 - 0.1 * (i % 5)) for k in range(3))
    radius = 0.01 if i < 8000 else 0.02
    O.bodies.append(sphere(center=[x / 1.1, y / 1.2, z / 1.3], radius=radius, material='grain'))
O.engines = [
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-5
