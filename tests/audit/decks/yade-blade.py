# SPDX-License-Identifier: MIT | after YADE scripts of a soil blade, GitHub | no licence named | speed=0.1
normalDamp, shearDamp, numDamp = 0.20, 0.20, 0.05
from yade import ymport
O.materials.append(FrictMat(young=7e7, poisson=0.3, density=2650, frictionAngle=radians(20), label='soil'))
O.materials.append(FrictMat(young=2e10, poisson=0.25, density=7850, frictionAngle=0.3, label='steel'))
O.bodies.append([utils.sphere((0, 0.01 * i, 0), .003, material='soil') for i in range(3)])
O.bodies.append(utils.box((0, 0, -.05), (1, 1, .05), fixed=True, material='steel'))
O.engines = [
    VTKRecorder(fileName='/tmp/never-written-', recorders=['all'], iterPeriod=5000),
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Box_Aabb(), Bo1_Facet_Aabb()], label="collider"),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(betan=normalDamp, betas=shearDamp, label='ContactModel')],
        [Law2_ScGeom_MindlinPhys_Mindlin(label='Mindlin')],
    ),
    NewtonIntegrator(damping=numDamp, gravity=(0, 0, -9.81)),
]
O.dt = 1e-7
