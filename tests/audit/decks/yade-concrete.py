# SPDX-License-Identifier: MIT | after YADE examples/concrete/uniax.py | GPL-2.0 | speed=0.5
mat = O.materials.append(
    CpmMat(young=3e10, poisson=0.2, density=4800, frictionAngle=0.8, sigmaT=3e6, epsCrackOnset=1e-4, relDuctility=30)
)
tool = O.materials.append(FrictMat(young=2e11, poisson=0.3, density=7800, frictionAngle=0.5, label='tool'))
O.bodies.append([sphere((0, 0, 0), 0.004, material=mat), sphere((0, 0, 0.007), 0.003, material=mat)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=1.5)]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(interactionDetectionFactor=1.5)],
        [Ip2_CpmMat_CpmMat_CpmPhys(cohesiveThresholdIter=1)],
        [Law2_ScGeom_CpmPhys_Cpm()],
    ),
    NewtonIntegrator(damping=0.4),
]
O.dt = 1e-8
O.run(1)
