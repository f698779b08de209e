"""The turning string in Exudyn: geometrically exact beams, an implicit step, a wall of our own.

The package's contact is between spheres, triangles and cables; a hole around a beam would be
thousands of triangles. The wall here is a connector from each node to the hole's axis beside it,
with a symbolic user function, which the package evaluates in C++: a linear spring and dashpot,
Coulomb friction on a cone that is linear below a slip of 1 cm/s. Nodes slide along the hole by
millimetres, so that the hole is straight for each. Coordinates: x down, y along the departure, z
across the plane.
"""

from __future__ import annotations

import argparse
import math
import time
from importlib.metadata import version
from typing import Any

import exudyn as exu
import numpy as np
from exudyn import utilities as eu

from measured import Means, Measured
from problem import Array, Laid, Problem, laid

SLIP_m_per_s = 0.01
# The cheapest of those tried; the answers are the same with all of them.
STEP_s = 40e-3
DOWN_FIRST = [2, 0, 1]


def section(problem: Problem) -> Any:
    """Stiffness and inertia of the pipe; the axis is the first direction."""
    p, made = problem, exu.BeamSection()
    second_moment = p.second_moment_m4
    shear_N = p.shear_coefficient * p.shear_modulus_Pa * p.area_m2
    bend_N_m2 = p.youngs_modulus_Pa * second_moment
    twist_N_m2 = 2 * p.shear_modulus_Pa * second_moment
    axial_N = p.youngs_modulus_Pa * p.area_m2
    made.stiffnessMatrix = np.diag([axial_N, shear_N, shear_N, twist_N_m2, bend_N_m2, bend_N_m2])
    made.inertia = p.density_kg_per_m3 * second_moment * np.diag([2.0, 1.0, 1.0])
    made.massPerLength = p.density_kg_per_m3 * p.area_m2
    return made


def rotation_vectors(start: Laid) -> Array:
    """Of the nodes' frames against that of a straight string down, rad."""
    tangent = np.gradient(start.position_m[:, DOWN_FIRST], axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    across = np.tile([0.0, 0.0, 1.0], (len(tangent), 1))
    in_plane = np.cross(across, tangent)
    cos, sin = np.cos(start.twist_rad)[:, None], np.sin(start.twist_rad)[:, None]
    first = cos * in_plane - sin * across
    frames = np.stack([tangent, first, np.cross(tangent, first)], axis=2)
    return np.array([eu.RotationMatrix2RotationVector(frame) for frame in frames])


def beside(problem: Problem, position_m: Array) -> Array:
    """The measured depths in m at which the hole's axis is nearest to the nodes."""
    depth = np.linspace(0, problem.length_m, len(position_m))
    for _ in range(20):
        away = position_m - problem.position_at(depth)
        depth = depth + np.einsum("ij,ij->i", away, problem.tangent_at(depth))
    return depth


def wall(problem: Problem, mbs: Any) -> Any:
    """Force and moment of the wall, and of the damping in proportion to mass, on a node."""
    p, sym = problem, exu.symbolic
    node_kg = p.density_kg_per_m3 * p.area_m2 * p.length_m / p.elements
    dashpot = 2 * p.contact_damping_ratio * math.sqrt(p.contact_stiffness_N_per_m * node_kg)
    drag = p.damping_mass_per_s * node_kg

    def force(  # type: ignore[no-untyped-def]
        mbs, t, itemIndex, displacement, rotation, velocity, angularVelocity,
        stiffness, damping, rotJ0, rotJ1, offset,
    ):  # fmt: skip
        high, right = displacement[1], displacement[2]
        away = sym.sqrt(high * high + right * right + 1e-12)
        n_high, n_right = high / away, right / away
        into = velocity[1] * n_high + velocity[2] * n_right
        press = p.contact_stiffness_N_per_m * (away - p.clearance_m) + dashpot * into
        none = sym.Real(0.0)
        press = sym.IfThenElse(away > p.clearance_m, sym.max(press, none), none)
        around = velocity[2] * n_high - velocity[1] * n_right + p.radius_m * angularVelocity[0]
        sliding = sym.sqrt(around * around + velocity[0] * velocity[0] + 1e-16)
        per_speed = p.friction * press / sym.max(sliding, sym.Real(SLIP_m_per_s))
        rub = per_speed * around
        return [
            (per_speed + drag) * velocity[0],
            press * n_high - rub * n_right + drag * velocity[1],
            press * n_right + rub * n_high + drag * velocity[2],
            rub * p.radius_m,
            none,
            none,
        ]

    return eu.CreateSymbolicUserFunction(
        mbs,
        function=force,
        userFunctionName="springForceTorqueUserFunction",
        itemTypeName="ObjectConnectorRigidBodySpringDamper",
    )


def assemble(problem: Problem, mbs: Any) -> tuple[int, Any]:
    """The string on the wall, turning; the number of its uppermost element, and the wall's law."""
    p, n, start = problem, problem.elements, laid(problem)
    length, speed = p.length_m / n, p.rotary_speed_rad_per_s
    position = start.position_m[:, DOWN_FIRST]
    nodes = [
        mbs.AddNode(
            eu.NodeRigidBodyRotVecLG(
                referenceCoordinates=[i * length, 0, 0, 0, 0, 0],
                initialCoordinates=[*(position[i] - [i * length, 0, 0]), *turned],
                initialVelocities=[0, 0, 0, speed, 0, 0],
            )
        )
        for i, turned in enumerate(rotation_vectors(start))
    ]
    beams = [
        mbs.AddObject(
            eu.ObjectBeamGeometricallyExact(
                nodeNumbers=[nodes[i], nodes[i + 1]], length=length, sectionData=section(p)
            )
        )
        for i in range(n)
    ]
    for beam in beams:
        mass = mbs.AddMarker(eu.MarkerBodyMass(bodyNumber=beam))
        gravity = [p.gravity_m_per_s2, 0, 0]
        mbs.AddLoad(eu.LoadMassProportional(markerNumber=mass, loadVector=gravity))
    ground, law = mbs.AddObject(eu.ObjectGround()), wall(p, mbs)
    depth = beside(p, start.position_m)
    axis, down = p.position_at(depth)[:, DOWN_FIRST], p.tangent_at(depth)[:, DOWN_FIRST]
    high = p.high_side_at(depth)[:, DOWN_FIRST]
    ends = [mbs.AddMarker(eu.MarkerNodeRigid(nodeNumber=node)) for node in nodes]
    for i in range(1, n + 1):
        frame = np.column_stack([down[i], high[i], np.cross(down[i], high[i])])
        place = exu.HT(rotation=frame, translation=axis[i])
        here = mbs.AddMarker(eu.MarkerBodyRigid(bodyNumber=ground, localHT=place))
        mbs.AddObject(
            eu.RigidBodySpringDamper(
                markerNumbers=[here, ends[i]], springForceTorqueUserFunction=law
            )
        )
    top = mbs.AddMarker(eu.MarkerBodyRigid(bodyNumber=ground, localPosition=list(position[0])))
    mbs.AddObject(eu.GenericJoint(markerNumbers=[top, ends[0]], constrainedAxes=[1, 1, 1, 0, 1, 1]))
    still = mbs.AddMarker(
        eu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(eu.NodePointGround()), coordinate=0)
    )
    turn = mbs.AddMarker(eu.MarkerNodeRotationCoordinate(nodeNumber=nodes[0], rotationCoordinate=0))
    mbs.AddObject(
        eu.CoordinateConstraint(markerNumbers=[still, turn], velocityLevel=True, offset=speed)
    )
    mbs.Assemble()
    return beams[0], law


def run(problem: Problem, step_s: float, simulated_s: float) -> Measured:
    """Settles for half of the time, takes means over the other half."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    # The law is kept alive: the package holds no reference to it.
    uppermost, law = assemble(problem, mbs)
    settings, means = exu.SimulationSettings(), Means()
    settings.timeIntegration.numberOfSteps = round(simulated_s / step_s)
    settings.timeIntegration.endTime = simulated_s
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.timeIntegration.newton.relativeTolerance = 1e-5
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
    settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = False
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    settings.parallel.numberOfThreads = 1

    def sample(mbs: Any, time_s: float) -> bool:
        if time_s >= simulated_s / 2:
            at = [0, 0, 0]
            tension = mbs.GetObjectOutputBody(uppermost, exu.OutputVariableType.ForceLocal, at)
            torque = mbs.GetObjectOutputBody(uppermost, exu.OutputVariableType.TorqueLocal, at)
            means.add(tension[0], -torque[0])
        return True

    mbs.SetPreStepUserFunction(sample)
    begin = time.process_time()
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    cpu_s = time.process_time() - begin
    del law
    hook_load_N, torque_N_m = means.of()
    return Measured(
        program="Exudyn",
        version=version("exudyn"),
        variant="",
        elements=problem.elements,
        step_s=step_s,
        simulated_s=simulated_s,
        cpu_s=cpu_s,
        hook_load_N=hook_load_N,
        torque_N_m=torque_N_m,
        tuned="implicit: the cheapest of 5, 10, 15, 20 and 40 ms",
        leaves_out="a hole (written here), what is faster than its step, statistics, results on disk",
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--step", type=float, default=STEP_s, help="s")
    parser.add_argument("--seconds", type=float, default=2.0, help="simulated")
    given = parser.parse_args()
    run(Problem.read(), given.step, given.seconds).write()
