# SPDX-License-Identifier: MIT | after a deck that the audit once read wrongly | MIT | speed=1
rho=2500; tc=1e-3; en=0.5
m=O.materials.append(ViscElMat(tc=tc,en=en,et=1,density=rho))
O.bodies.append(sphere((0,0,0),radius=0.01,material=m))
O.engines=[NewtonIntegrator(damping=0)]
