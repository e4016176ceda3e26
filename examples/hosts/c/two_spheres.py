# SPDX-License-Identifier: MIT
"""Two spheres overlap by 0.1 mm and shear by 99 um along the arc of constant overlap; prints the forces and their closed forms."""
from math import cos, sin, sqrt

from contactlaws import Body, Law

R1, R2, OVERLAP, SHEAR, STEPS, DT = 7.5e-3, 5e-3, 0.1e-3, 99e-6, 9900, 1e-6
distance = R1 + R2 - OVERLAP
for friction in (10.0, 0.4):
    law = Law("dry_hill", young=29e9, poisson=0.15, friction=friction)
    state = law.new_state()
    below = Body(x=(0, 0, 0), radius=R1)
    for k in range(STEPS + 1):  # k = 0, dt = 0: set-up
        angle, speed = k * SHEAR / STEPS / distance, SHEAR / STEPS / DT
        n, t = (sin(angle), 0, cos(angle)), (cos(angle), 0, -sin(angle))
        above = Body(x=tuple(distance * c for c in n), v=tuple(speed * c for c in t), radius=R2)
        force, torque1, torque2 = law.step(DT if k > 0 else 0, below, above, state)
    normal, shear = (sum(f * c for f, c in zip(force, direction)) for direction in (n, t))
    print("friction %4g: normal %.6f N, shear %.7f N, torques %.9f %.9f N m" %
          (friction, normal, shear, torque1[1], torque2[1]))

radius, young, shear_modulus = R1 * R2 / (R1 + R2), 29e9 / 2 / (1 - 0.15**2), 29e9 / 4 / (1 + 0.15) / (2 - 0.15)
normal = 4 / 3 * young * sqrt(radius * OVERLAP**3)
print("closed forms:   normal %.6f N, shear %.7f N sticking, %.7f N sliding" %
      (normal, 8 * shear_modulus * sqrt(radius * OVERLAP) * SHEAR, 0.4 * normal))
