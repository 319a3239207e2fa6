"""M and V by Kane's method from vectors and frames, against Lagrange from coordinates."""

import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from derivations import lagrangian
from derivations import symbols as s


def kane():
    """M and V from rigid bodies hung in the frames of links A and D, independent of geometry.py."""
    q1, q2, u1, u2 = dynamicsymbols("q1 q2 u1 u2")
    ground = ReferenceFrame("ground")
    frame_a = ground.orientnew("frame_a", "Axis", (q1, ground.z))  # x axis along link A
    frame_d = ground.orientnew("frame_d", "Axis", (q2, ground.z))  # y axis along link D
    frame_a.set_ang_vel(ground, u1 * ground.z)
    frame_d.set_ang_vel(ground, u2 * ground.z)
    origin = Point("origin")
    origin.set_vel(ground, 0)
    joint_ad = origin.locatenew("joint_ad", s.L_A * frame_a.x)
    joint_bc = origin.locatenew("joint_bc", -s.L_B * frame_d.y)
    joint_cd = joint_bc.locatenew("joint_cd", s.L_A * frame_a.x)
    centres = {
        "A": (origin.locatenew("ca", s.R_A * frame_a.x), frame_a, s.M_A, s.I_A),
        "B": (origin.locatenew("cb", -s.R_B * frame_d.y), frame_d, s.M_B, s.I_B),
        "C": (joint_bc.locatenew("cc", s.R_C * frame_a.x), frame_a, s.M_C, s.I_C),
        "D": (joint_cd.locatenew("cd", s.R_D * frame_d.y), frame_d, s.M_D, s.I_D),
    }
    # the linkage closes: the joint of C and D lies l_B behind the joint of A and D
    closure = joint_ad.pos_from(origin) - s.L_B * frame_d.y - joint_cd.pos_from(origin)
    assert closure.to_matrix(ground).applyfunc(sp.simplify) == sp.zeros(3, 1)
    bodies = []
    for name, (centre, frame, mass, moment) in centres.items():
        velocity = centre.pos_from(origin).dt(ground).subs({q1.diff(): u1, q2.diff(): u2})
        centre.set_vel(ground, velocity)
        bodies.append(RigidBody(name, centre, frame, mass, (inertia(frame, 0, 0, moment), centre)))
    method = KanesMethod(ground, [q1, q2], [u1, u2], kd_eqs=[q1.diff() - u1, q2.diff() - u2])
    method.kanes_equations(bodies, [])
    plain = {u1: s.W1, u2: s.W2, q1: s.TH1, q2: s.TH2}
    # Kane: mass_matrix ud = forcing, and forcing = -V when nothing acts from outside
    return method.mass_matrix.subs(plain), -method.forcing.subs(plain)


def test_kane_and_lagrange_agree():
    mass, velocity_terms = kane()
    motion = lagrangian.from_links()
    zero = sp.zeros(2, 2), sp.zeros(2, 1)
    assert (mass - motion.mass_matrix).applyfunc(sp.simplify) == zero[0]
    assert (velocity_terms - motion.velocity_terms).applyfunc(sp.simplify) == zero[1]


def test_the_lumped_form_is_the_link_form():
    links, lumped = lagrangian.from_links(), lagrangian.from_lumped()
    values = lagrangian.lumped_inertia(links.mass_matrix)
    for full, short in (
        (links.mass_matrix, lumped.mass_matrix),
        (links.velocity_terms, lumped.velocity_terms),
    ):
        assert (full - short.subs(values)).applyfunc(sp.simplify) == sp.zeros(*full.shape)
