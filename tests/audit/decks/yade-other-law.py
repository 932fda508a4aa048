# SPDX-License-Identifier: MIT | after a deck that the audit once read wrongly | MIT | speed=1
m=O.materials.append(CohFrictMat(young=1e8,poisson=.3,density=2500,isCohesive=False))
O.engines=[InteractionLoop([],[Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()],[]),NewtonIntegrator(damping=0)]
