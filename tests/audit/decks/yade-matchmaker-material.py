# SPDX-License-Identifier: MIT | after a deck that the audit once read wrongly | MIT | speed=1
m=O.materials.append(ViscElMat(tc=1e-3,en=0.3,et=1,density=2500,label='a'))
O.bodies.append(sphere((0,0,0),radius=0.01,material=m))
O.engines=[InteractionLoop([],[Ip2_ViscElMat_ViscElMat_ViscElPhys(tc=MatchMaker(matches=((0,0,1e-3),)),en=MatchMaker(matches=((0,0,0.9),)))],[]),NewtonIntegrator(damping=0)]
