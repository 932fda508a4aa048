# SPDX-License-Identifier: MIT | after a deck that the audit once read wrongly | MIT | radius=1e-2 speed=1
en, es = 0.5, 0.4
damp=0.0
m=O.materials.append(FrictMat(young=1e8,poisson=.3,density=2500))
O.engines=[InteractionLoop([],[Ip2_FrictMat_FrictMat_MindlinPhys(en=en,es=es)],[]),NewtonIntegrator(damping=damp)]
