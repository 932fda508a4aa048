# SPDX-License-Identifier: MIT | after YADE scripts that build the scene in functions, GitHub: SAG mill | MIT | speed=0.5
contact_model = 'hertz_mindlin'
parameters = {'young': 5e7, 'poisson': 0.25, 'restitution': 0.45}


def add_materials(density, **other):
    return O.materials.append(FrictMat(density=density, frictionAngle=0.5, **other))


steel = add_materials(7850.0, young=parameters['young'], poisson=parameters['poisson'], label='steel')
O.bodies.append([sphere((0, 0, 0.1 * k), 0.03, material=steel) for k in range(2)])
if contact_model == 'hertz_mindlin':
    physics = [Ip2_FrictMat_FrictMat_MindlinPhys(en=parameters['restitution'])]
    law = [Law2_ScGeom_MindlinPhys_Mindlin()]
else:
    physics = [Ip2_FrictMat_FrictMat_FrictPhys()]
    law = [Law2_ScGeom_FrictPhys_CundallStrack()]
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], verletDist=.02),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()], physics, law),
    NewtonIntegrator(damping=0, gravity=(0, -9.81, 0), label='newton_integrator'),
]
O.dt = 2e-6
while O.time < 1:
    O.run(100, True)
