# SPDX-License-Identifier: MIT | after YADE scripts in several files, GitHub: the file of the engines | MIT | no option
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(damping=0.4, gravity=(0, 0, -gravitational_acceleration)),
    PyRunner(command='push()', iterPeriod=1),
]
O.dt = 0.2 * PWaveTimeStep()
def push():
    O.forces.addF(0, (0, 0, 1))
