# SPDX-License-Identifier: MIT | after a deck that the audit once read wrongly | MIT | speed=1
m=O.materials.append(PolyhedraMat(young=1e8,poisson=.3,density=2500))
O.engines=[InteractionLoop([],[Ip2_PolyhedraMat_PolyhedraMat_PolyhedraPhys()],[]),NewtonIntegrator(damping=0)]
