# SPDX-License-Identifier: MIT | after scripts for an own version of YADE, GitHub: actuators | MIT | speed=1
# PmCohFrictMat and PmIp2_... are classes of the fork. The engine Ip2_FrictMat... serves only the wall.
O.materials.append(PmCohFrictMat(young=1e8, poisson=0.25, density=1000, cn=5e4, label='module'))
O.bodies.append([sphere((k, 0, 0), 0.5, material='module') for k in range(2)])
O.engines = [InteractionLoop([], [Ip2_FrictMat_FrictMat_FrictPhys(), PmIp2_CohFrictMat_CohFrictMat_CohFrictPhys()], [])]
