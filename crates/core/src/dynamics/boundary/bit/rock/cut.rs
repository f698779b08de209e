//! The rock under the string's bit.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use crate::{
    damage::Damaged,
    dynamics::{
        boundary::{
            anchor::Anchor,
            bit::{
                motor::Drive,
                step::{BitStep, StepStart},
            },
            executor::RockExecutor,
        },
        kernel::chain::{Chain, element, node},
    },
    rock::{BitMotion, Drilling, DrillingSpec, Inertia, bit_face::Pose},
    simd::{number::Real, vector::Vector},
};

/// Time over which the forces and torques on the bit are averaged, s: the average acts on the bit
/// evenly, and a motor follows that of the torque. It spans some dozens of steps.
const EVEN_S: f64 = 0.02;

/// A bit on its bottom, run in as the string moves at time zero.
#[derive(Debug, Clone)]
pub struct RunIn {
    pub(super) drilling: Drilling,
    pub(super) weight_N: f64,
    pub(super) torque_N_m: f64,
    pub(super) depth_of_cut_m: f64,
}

impl RunIn {
    /// Torque that it took in its last revolution, N·m; none where it did not turn.
    pub fn torque_N_m(&self) -> f64 {
        self.torque_N_m
    }
}

/// The rock under a bit, and its position in space.
///
/// The block is aligned with the bit as placed, x to the hole's high side, and keeps this
/// orientation: a bit that leans in its hole has cut it leaning, and leaves that axis where the
/// rock lets it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct RockCut {
    drilling: Drilling,
    /// Turns the block's frame into the world's.
    frame: Matrix3<f64>,
    /// Origin of the block's frame, m.
    origin_m: Vector3<f64>,
    /// Average force of the string on the bit, in the block's frame, N.
    even_N: Vector3<f64>,
    even_N_m: f64,
    /// Torque of the rock against the bit, on average, N·m.
    resisting_N_m: f64,
    /// Way of the bit in about its last revolution, which fades as it turns, m.
    depth_of_cut_m: f64,
}

impl RockCut {
    /// Whether stored rock is that of this bit and block.
    pub(super) fn check_drilling(&self, spec: &DrillingSpec) -> Result<(), Damaged> {
        self.drilling.check(spec)
    }

    /// Puts the block on which the bit was run in in the hole where the string's bit is.
    pub(in crate::dynamics) fn new(
        run_in: RunIn,
        chain: &Chain<impl Real>,
        anchor: &Anchor,
    ) -> Self {
        let index = chain.nodes() - 1;
        let along = Vector3::from(chain.director(index));
        let frame = Pose::new(Vector3::zeros(), along, anchor.high_side, 0.0).rotation;
        let at = anchor.position_m + Vector3::from(chain.displacement(index));
        Self {
            origin_m: at - frame * run_in.drilling.pose().position_m,
            drilling: run_in.drilling,
            frame,
            even_N: Vector3::z() * run_in.weight_N,
            even_N_m: run_in.torque_N_m,
            resisting_N_m: run_in.torque_N_m,
            depth_of_cut_m: run_in.depth_of_cut_m,
        }
    }

    /// Takes the bit's node, which the step has pushed without the rock, through the step.
    ///
    /// The string's impulse is applied in two parts: its recent average evenly over the step, the
    /// rest at the step's beginning. So the string's own motion stays that of central differences,
    /// and the rock receives no impact at each step of the string. The bit's rotation in excess of
    /// its last spin is added to the twist. A motor keeps its speed in the step. Theory:
    /// `docs/src/theory/rock.md`.
    pub(in crate::dynamics) fn drill(
        &mut self,
        chain: &mut Chain<impl Real>,
        anchor: &Anchor,
        step_start: StepStart,
        drive: &mut Drive,
        executor: &RockExecutor,
        dt: f64,
    ) -> BitStep {
        let index = chain.nodes() - 1;
        let into = |v: Vector<f64>| self.frame.tr_mul(&Vector3::from(v));
        let inertia = Inertia {
            mass_kg: 1.0 / node!(chain, index, inv_mass_axial),
            lateral_mass_kg: 1.0 / node!(chain, index, inv_mass_lateral),
            along: into(chain.tangent(index)),
            about_axis_kg_m2: 1.0 / node!(chain, index, inv_polar),
            across_axis_kg_m2: 1.0 / node!(chain, index, inv_rotary),
        };
        let [before, velocity, tilting] =
            [step_start.velocity, chain.velocity(index), chain.turning(index)].map(into);
        let part = dt / (EVEN_S + dt);
        // The string's impulse in this step, and its running average.
        let push_N = inertia.impulse_N_s(velocity - before) / dt;
        let spin = node!(chain, index, spin);
        let turn_N_m = (spin - step_start.spin) * inertia.about_axis_kg_m2 / dt;
        self.even_N += (push_N - self.even_N) * part;
        self.even_N_m += (turn_N_m - self.even_N_m) * part;

        // The motor turns at the speed that it has under the average torque of the rock.
        drive.resist(self.resisting_N_m);
        let motor = drive.speed_rad_per_s();
        let axis = self.drilling.pose().axis();
        // The average acts in the rock's own steps: the kick that the node has had is less by it.
        let string_spin = spin - dt * self.even_N_m / inertia.about_axis_kg_m2;
        let motion = BitMotion {
            velocity_m_per_s: velocity - inertia.velocity_change_m_per_s(self.even_N * dt),
            angular_velocity_rad_per_s: tilting + axis * (string_spin + motor),
            force_N: self.even_N,
            moment_N_m: axis * self.even_N_m,
            inertia,
        };
        let advance = self.drilling.advance(dt, &motion, &executor.stepper, &executor.shared);
        let axis = self.drilling.pose().axis();
        let omega = advance.angular_velocity_rad_per_s;
        let turned = omega.dot(&axis);
        let spin_after = turned - motor;
        // Whatever the spin has lost, the rock has taken.
        let torque_N_m = (spin - spin_after) * inertia.about_axis_kg_m2 / dt;
        self.resisting_N_m += (torque_N_m - self.resisting_N_m) * part;

        // The bit's motion, from the block's frame back to the world's.
        let out = |v: Vector3<f64>| Vector::from(self.frame * v);
        chain.set_velocity(index, out(advance.velocity_m_per_s));
        let at = self.origin_m + self.frame * self.drilling.pose().position_m;
        chain.set_displacement(index, (at - anchor.position_m).into());
        chain.set_director(index, out(axis));
        chain.set_turning(index, out(omega - axis * turned));
        node!(chain, index, spin = spin_after);
        if index > 0 {
            // The leapfrog turns the bit by its last spin; the rock turned it through the whole
            // step.
            let further = advance.turned_rad - dt * (motor + spin_after);
            element!(chain, index - 1, twist += further);
        }
        let rate_m_per_s = advance.displacement_m.z / dt;
        // Fades over about one revolution.
        let turned_part = (advance.turned_rad.abs() / TAU).min(1.0);
        self.depth_of_cut_m += advance.displacement_m.z - turned_part * self.depth_of_cut_m;
        let moment = advance.moment_N_m;
        BitStep {
            weight_on_bit_N: -advance.force_N.z,
            torque_N_m,
            depth_of_cut_m: self.depth_of_cut_m,
            rate_of_penetration_m_per_s: rate_m_per_s,
            force_N: out(advance.force_N),
            moment_N_m: (moment - axis * moment.dot(&axis)).norm(),
            motor_speed_rad_per_s: motor,
            // The work of the motor on the bit does not come from the string.
            work_J: advance.work_J + torque_N_m * motor * dt,
        }
    }

    /// The bit and the rock.
    pub(in crate::dynamics) fn drilling(&self) -> &Drilling {
        &self.drilling
    }
}
