# SPDX-License-Identifier: MIT
"""Contact forces of a contactlaws law between the spheres of a YADE scene, by the C face.

    from contactlaws import Law
    import contactlaws_engine

    contactlaws_engine.law = Law("dry_hill", young=29e9, poisson=0.15, friction=0.4)
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]), *contactlaws_engine.engines(), NewtonIntegrator(damping=0)]

YADE finds the contacts; its own law between them has no stiffness, and drops a pair at the end of touch: laws that act beyond it are
refused. Walls, facets and periodic cells are not covered.
"""
import yade
from contactlaws import Body
from yade import O
from yade.wrapper import (Ig2_Sphere_Sphere_ScGeom, InteractionLoop, Ip2_FrictMat_FrictMat_FrictPhys,
                          Law2_ScGeom_FrictPhys_CundallStrack, MatchMaker, PyRunner)

law = None
states = {}  # of the contacts that there are, by the numbers of the two bodies


def engines():
    if law.range(1.0, 1.0) > 0:
        raise ValueError("contactlaws_engine: this law acts beyond touch, where YADE has dropped the pair")
    nothing = MatchMaker(matches=((0, 0, 0.0),))
    return [InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys(kn=nothing, ks=nothing)],
                            [Law2_ScGeom_FrictPhys_CundallStrack()]),
            PyRunner(iterPeriod=1, command="import contactlaws_engine; contactlaws_engine.step()")]


def body(number):
    of = O.bodies[number]
    return Body(tuple(of.state.pos), tuple(of.state.vel), tuple(of.state.angVel), of.shape.radius,
                of.state.mass if of.dynamic else 0)


def step():
    global states
    before, states = states, {}
    for contact in O.interactions:
        key = contact.id1, contact.id2
        states[key] = before.get(key) or law.new_state()
        force, torque1, torque2 = law.step(O.dt, body(contact.id1), body(contact.id2), states[key])
        O.forces.addF(contact.id1, tuple(-f for f in force))
        O.forces.addF(contact.id2, tuple(force))
        O.forces.addT(contact.id1, tuple(torque1))
        O.forces.addT(contact.id2, tuple(torque2))
