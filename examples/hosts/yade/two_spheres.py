# SPDX-License-Identifier: MIT
"""Two spheres overlap by 0.1 mm and shear by 99 um along the arc of constant overlap:   yade -n -x two_spheres.py

Variables of the environment: MU, the friction (0.4); OWN=1, YADE's MindlinPhys instead; OWN=2, that without avoidGranularRatcheting.
"""
import os
import sys
from math import atan, cos, sin

here = os.path.dirname(os.path.abspath(sys.argv[0]))
sys.path += [here, os.path.join(here, "..", "c")]
friction, own = float(os.environ.get("MU", "0.4")), int(os.environ.get("OWN", "0"))

O.materials.append(FrictMat(young=29e9, poisson=0.15, frictionAngle=atan(friction), density=2650))
O.bodies.append([sphere((0, 0, 0), 7.5e-3, fixed=True), sphere((0, 0, 12.5e-3), 5e-3, fixed=True)])
if own:
    forces = [InteractionLoop([Ig2_Sphere_Sphere_ScGeom(avoidGranularRatcheting=own == 1)], [Ip2_FrictMat_FrictMat_MindlinPhys()],
                              [Law2_ScGeom_MindlinPhys_Mindlin()])]
else:
    import contactlaws_engine
    from contactlaws import Law
    contactlaws_engine.law = Law("dry_hill", young=29e9, poisson=0.15, friction=friction)
    forces = contactlaws_engine.engines()
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=1e-3), *forces, NewtonIntegrator(damping=0)]
O.dt = 1e-6

below, above = O.bodies[0].state, O.bodies[1].state


def show():
    above.vel = (0, 0, 0)
    O.step()  # forces belong to the positions before the last move
    n = (above.pos - below.pos).normalized()
    force = O.forces.f(1)
    normal = force.dot(n)
    print("normal %.10g N, shear %.10g N, torques %.10g %.10g N m" %
          (normal, (force - n * normal).norm(), O.forces.t(0).norm(), O.forces.t(1).norm()))


above.vel = (0, 0, -0.01)
for k in range(10000):
    O.step()
show()
distance = (above.pos - below.pos).norm()
for k in range(9900):
    angle = (k + 0.5) * 1e-8 / distance
    above.vel = (0.01 * cos(angle), 0, -0.01 * sin(angle))
    O.step()
show()
