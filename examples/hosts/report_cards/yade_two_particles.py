# SPDX-License-Identifier: MIT
"""Two spheres in an unmodified YADE, whose motion and history are set before each force computation.

    yade -n -x yade_two_particles.py FOLDER

Reads a step from the pipe FOLDER/to_yade and answers it on FOLDER/from_yade, until the first is closed; yade.cpp has the other end.
The history is what YADE's law keeps of a contact: vectors of its IPhys, and the last normal in its IGeom.
"""
import struct
import sys
from math import atan

VECTORS = ("shearForce", "shearElastic", "usElastic", "usTotal")
STEP = struct.Struct("=40d")    # law, dt, of each body: position, velocity, spin, radius, mass; touching, history
ANSWER = struct.Struct("=28d")  # forces and torques on both bodies; touching, history


def mindlin(ratcheting=True, **damping):
    return [InteractionLoop([Ig2_Sphere_Sphere_ScGeom(avoidGranularRatcheting=ratcheting)],
                            [Ip2_FrictMat_FrictMat_MindlinPhys(**damping)], [Law2_ScGeom_MindlinPhys_Mindlin()])]


LAWS = (
    lambda: mindlin(),
    lambda: mindlin(ratcheting=False),
    lambda: mindlin(ratcheting=False, en=0.8, es=0.8),
    lambda: [InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                             [Law2_ScGeom_FrictPhys_CundallStrack()])],
)


class TwoSpheres:
    def __init__(self):
        O.materials.append(FrictMat(young=29e9, poisson=0.15, frictionAngle=atan(0.4), density=2650))
        O.bodies.append([sphere((0, 0, 0), 7.5e-3), sphere((0, 0, 1), 5e-3)])
        self.law = self.radii = self.contact = None

    def place(self, number, values):
        """One body; returns its radius."""
        body = O.bodies[number]
        body.state.pos, body.state.vel, body.state.angVel = values[0:3], values[3:6], values[6:9]
        body.shape.radius, body.state.mass = values[9], values[10]
        return values[9]

    def set_history(self, touching, history):
        if not touching:  # a pair that the collider has just found
            O.interactions.clear()
            self.contact = utils.createInteraction(0, 1, virtualI=True)
            return
        if not self.contact.isReal:
            O.interactions.clear()
            self.contact = utils.createInteraction(0, 1)
        for k, name in enumerate(VECTORS):
            if hasattr(self.contact.phys, name):
                setattr(self.contact.phys, name, history[3 * k:3 * k + 3])
        self.contact.geom.normal = history[12:15]

    def history(self):
        if not self.contact.isReal:
            return [0.0] * 16
        values = [1.0]
        for name in VECTORS:
            values += getattr(self.contact.phys, name, (0, 0, 0))
        return values + list(self.contact.geom.normal)

    def step(self, law, dt, *values):
        radii = self.place(0, values[0:11]), self.place(1, values[11:22])
        if (law, radii) != (self.law, self.radii):  # what the contact knows of its spheres is computed where it begins
            if law != self.law:
                O.engines = LAWS[int(law)]()
            self.law, self.radii = law, radii
            O.interactions.clear()
            self.contact = utils.createInteraction(0, 1, virtualI=True)
        O.dt = max(dt, 1e-30)  # MindlinPhys divides by it; YADE itself never steps over no time
        self.set_history(values[22] != 0, values[23:])
        O.forces.reset()
        O.step()
        forces = O.forces
        return [*forces.f(0, True), *forces.f(1, True), *forces.t(0, True), *forces.t(1, True), *self.history()]


def main(folder):
    spheres = TwoSpheres()
    with open(folder + "/to_yade", "rb") as steps, open(folder + "/from_yade", "wb") as answers:
        while True:
            step = steps.read(STEP.size)
            if len(step) < STEP.size:
                return
            answers.write(ANSWER.pack(*spheres.step(*STEP.unpack(step))))
            answers.flush()


main(sys.argv[-1])
