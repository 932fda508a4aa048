# SPDX-License-Identifier: MIT | after a YADE script of sticky beads with CohFrictMat | MIT | speed=0.1,0.5
glue = {'normalCohesion': 3e5, 'shearCohesion': 3e5}
bead = O.materials.append(CohFrictMat(young=1e7, poisson=0.3, density=2600, frictionAngle=0.5, label='bead', **glue))
tape = O.materials.append(
    CohFrictMat(young=2e7, poisson=0.3, density=2600, normalCohesion=1e5, shearCohesion=1e5, label='tape')
)
clean = O.materials.append(
    CohFrictMat(young=1e7, poisson=0.3, density=2600, normalCohesion=0, shearCohesion=0, label='clean')
)
O.bodies.append([sphere((0, 0, 0), 0.004, material=bead), sphere((0, 0, 1), 0.003, material=tape)])
O.bodies.append(facet([(0, 0, -9), (1, 0, -9), (0, 1, -9)], material=tape))
O.bodies.append(box((0, 0, -10), (1, 1, 1), material=clean, fixed=True))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb(), Bo1_Box_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom6D(), Ig2_Facet_Sphere_ScGeom6D(), Ig2_Box_Sphere_ScGeom6D()],
        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True, setCohesionOnNewContacts=True)],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()],
    ),
    NewtonIntegrator(damping=0.1),
]
O.dt = 1e-6
O.run(1)
