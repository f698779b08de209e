//! The bit on the rock: the parts common to all laws.

mod bottom;
mod custom_excitation;
mod cutters;
mod excitation;
mod front;
pub mod law;
mod motor;
mod rate_segment;
mod rock;
mod settings;
mod side;
mod step;
mod table;

use serde::{Deserialize, Serialize};

use self::{
    custom_excitation::CustomShaker,
    law::{Cut, rules::CutStart},
    motor::Drive,
    rock::RockCut,
    side::Side,
    step::{Approach, RockReaction},
};
pub use self::{
    custom_excitation::{BitExcitation, CustomExcitation},
    cutters::{Cutters, SteadyCut},
    excitation::{Band, Excitation, Shake},
    law::*,
    motor::{Motor, MudMotor},
    rock::{RunIn, Standing},
    settings::BitSettings,
    step::{BitRockStep, BitStep, StepStart},
    table::{BitTable, TableFault, TablePoint, TableUse},
};
use super::{anchor::Anchor, executor::RockExecutor, extension::AnotherExtension};
use crate::{
    damage::Damaged,
    dynamics::kernel::chain::{Chain, node},
    ends::BitEnd,
    operation::Operation,
    rock::Drilling,
    simd::{number::Real, vector::Vector},
};

/// The bit: held to the hole's axis, and on bottom pressed against the rock that it cuts.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Bit {
    side: Side,
    motor: Motor,
    drive: Drive,
    /// None off bottom.
    cut: Option<Cut>,
    /// Force that pulls the bit down the hole off bottom, N.
    pull_N: f64,
    /// Excitation in addition to that of the law.
    shaker: Option<CustomShaker>,
}

impl Bit {
    /// Gives a bit that has been read back law and excitation of these settings, where they are
    /// the caller's.
    pub(in crate::dynamics) fn attach(
        &mut self,
        settings: &BitSettings,
    ) -> Result<(), AnotherExtension> {
        if let (Some(shaker), Some(custom)) = (&mut self.shaker, &settings.excitation) {
            shaker.attach(custom)?;
        }
        self.cut.as_mut().map_or(Ok(()), |cut| cut.attach(&settings.law))
    }

    /// Whether a stored bit is one of these settings.
    pub(in crate::dynamics) fn check(&self, settings: &BitSettings) -> Result<(), Damaged> {
        let excitation = settings.excitation.as_ref().filter(|_| self.cut.is_some());
        CustomShaker::check(self.shaker.as_ref(), excitation)?;
        self.cut.as_ref().map_or(Ok(()), |cut| cut.check(&settings.law))
    }

    /// The bit of `operation` at `depth_m`, pressed on the rock with the operation's weight as it
    /// is while drilling steadily. `seed` is that of the excitation. Solid rock comes under it with
    /// [`Self::stand`].
    pub fn new(settings: &BitSettings, operation: &Operation, depth_m: f64, seed: u64) -> Self {
        let drills = operation.weight_on_bit_now_N() > 0.0;
        let motor = settings.motor;
        let flow = operation.flow_now_m3_per_s();
        let drive = Drive::new(motor, flow, operation.bit_torque_now_N_m());
        let start = CutStart { operation, drive: &drive, depth_m, seed };
        let cut = if drills { settings.law.begin(&start) } else { None };
        let side_cut_m_per_N = if drills { settings.side_cut_m_per_N(operation) } else { 0.0 };
        Self {
            side: Side::new(settings.lateral_stiffness_N_per_m, side_cut_m_per_N),
            motor,
            drive,
            cut,
            pull_N: operation.bit_pull_now_N(),
            shaker: settings.excitation.as_ref().filter(|_| drills).map(CustomShaker::new),
        }
    }

    /// The same where the string's end is held so.
    pub fn ending(self, end: BitEnd) -> Self {
        Self { side: self.side.ending(end), ..self }
    }

    /// Stands the string's bit on the rock that it was run in on.
    pub fn stand(&mut self, run_in: RunIn, chain: &Chain<impl Real>, anchor: &Anchor) {
        self.drive.resist(run_in.torque_N_m());
        let cut = RockCut::new(run_in, chain, anchor);
        self.cut = Some(Cut::Rock(Box::new(cut)));
    }

    /// The solid rock under the bit, if it is that.
    pub fn drilling(&self) -> Option<&Drilling> {
        match &self.cut {
            Some(Cut::Rock(cut)) => Some(cut.drilling()),
            _ => None,
        }
    }

    /// Sets the flow through the motor, m³/s.
    pub fn set_flow(&mut self, flow_m3_per_s: f64) {
        self.drive.set_flow(flow_m3_per_s);
    }

    /// Pressure that the motor takes off the mud at a torque, Pa, where that is known.
    pub fn motor_pressure_Pa(&self, torque_N_m: f64) -> Option<f64> {
        self.motor.pressure_Pa(torque_N_m)
    }

    /// Lateral displacement of the cut hole from the axis at the bit, m.
    pub fn side_cut_m(&self) -> Vector<f64> {
        self.side.cut_m()
    }

    /// Whether a motor turns the bit.
    pub fn has_motor(&self) -> bool {
        self.motor != Motor::Speed(0.0)
    }

    /// Count of the bit's excursions outside its table, if it has one.
    pub fn table_use(&self) -> Option<TableUse> {
        self.cut.as_ref().and_then(Cut::table_use)
    }

    /// From now on [`Self::table_use`] counts.
    pub fn open_window(&mut self) {
        if let Some(cut) = &mut self.cut {
            cut.restart();
        }
    }

    /// Corrects the bit's node, which the step has moved without it, and advances the rock. The
    /// rock is evaluated at the step's end: with last step's position it would feed energy in.
    /// `anchor` is that of the bit's node.
    pub fn act(
        &mut self,
        chain: &mut Chain<impl Real>,
        anchor: &Anchor,
        step_start: StepStart,
        executor: &RockExecutor,
        dt: f64,
    ) -> BitStep {
        let index = chain.nodes() - 1;
        let tangent = chain.tangent(index);
        // Lateral motion first: the rock ahead meets the bit at the position that the side rock has
        // left.
        let held = self.side.hold(
            chain.velocity(index),
            chain.displacement(index),
            tangent,
            dt * node!(chain, index, inv_mass_lateral),
            step_start.spin + self.drive.speed_rad_per_s(),
            dt,
        );
        if let Some(Cut::Rock(cut)) = &mut self.cut {
            chain.set_velocity(index, held.velocity);
            let mut step = cut.drill(chain, anchor, step_start, &mut self.drive, executor, dt);
            // The lateral spring does its work on the mean of the velocities, like every force.
            let mean = (step_start.velocity + chain.velocity(index)).scaled(0.5);
            step.work_J += held.force_N.dot(mean) * dt;
            step.force_N = step.force_N + held.force_N;
            return step;
        }
        let (mut velocity, mut displacement) = (held.velocity, held.displacement);
        let mut work = held.force_N.dot((step_start.velocity + velocity).scaled(0.5));

        let mut step = BitStep { force_N: held.force_N, ..BitStep::default() };
        let turning = step_start.spin + self.drive.speed_rad_per_s();
        let shaker = self.shaker.as_ref();
        let approach = Approach {
            depth_m: anchor.md_m + displacement.dot(tangent),
            velocity_m_per_s: velocity.dot(tangent),
            axial_mobility_s_per_kg: dt * node!(chain, index, inv_mass_axial),
            spin_before_rad_per_s: step_start.spin,
            spin_rad_per_s: node!(chain, index, spin),
            turning_mobility: dt * node!(chain, index, inv_polar),
            shake: shaker.map_or_else(Shake::default, |shaker| shaker.next(turning * dt, dt)),
            dt,
        };
        let reaction = self.cut.as_mut().and_then(|cut| cut.meet(&approach, &mut self.drive));
        if let Some(RockReaction {
            weight_N: weight,
            torque_N_m: torque,
            spin_rad_per_s: spin,
            depth_of_cut_m,
            rate_m_per_s,
        }) = reaction
        {
            if let Some(shaker) = &mut self.shaker {
                shaker.advance(&BitRockStep {
                    dt_s: dt,
                    weight_on_bit_N: weight,
                    torque_N_m: torque,
                    bit_speed_rad_per_s: spin + self.drive.speed_rad_per_s(),
                    advance_m: rate_m_per_s * dt,
                });
            }
            let mobility = approach.axial_mobility_s_per_kg;
            velocity = velocity.minus(tangent, mobility * weight);
            displacement = displacement.minus(tangent, dt * mobility * weight);
            node!(chain, index, spin = spin);
            // Force times the mean of the velocities before and after: exact for the leapfrog.
            work -= weight * tangent.dot((step_start.velocity + velocity).scaled(0.5))
                + torque * 0.5 * (step_start.spin + spin);
            step = BitStep {
                weight_on_bit_N: weight,
                torque_N_m: torque,
                depth_of_cut_m,
                rate_of_penetration_m_per_s: rate_m_per_s,
                force_N: step.force_N.minus(tangent, weight),
                ..step
            };
        } else {
            self.drive.run_free();
            if self.pull_N != 0.0 {
                let gained = approach.axial_mobility_s_per_kg * self.pull_N;
                velocity = velocity.plus(tangent, gained);
                displacement = displacement.plus(tangent, dt * gained);
                work += self.pull_N * tangent.dot((step_start.velocity + velocity).scaled(0.5));
                step.force_N = step.force_N.plus(tangent, self.pull_N);
            }
        }
        chain.set_velocity(index, velocity);
        chain.set_displacement(index, displacement);
        step.motor_speed_rad_per_s = self.drive.speed_rad_per_s();
        step.work_J = work * dt;
        step
    }
}
