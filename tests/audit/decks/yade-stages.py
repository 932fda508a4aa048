# SPDX-License-Identifier: MIT | after YADE examples/simple-scene/save-then-reload.py | GPL-2.0 | no option
O.materials.append(FrictMat(young=1e7, poisson=0.3, density=2600, label='grain'))
O.bodies.append([sphere((k, 0, 0), 0.4, material='grain') for k in range(2)])
O.engines = [
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(damping=0.2, label='newton'),
]
newton.gravity = (0, 0, -9.81)
O.dt = 1e-4
while 1:
    O.run(1000, True)
    if unbalancedForce() < 0.01:
        break
newton.damping = 0.1
O.run(1000)
