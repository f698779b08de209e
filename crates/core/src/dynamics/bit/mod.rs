//! The bit on the rock: what every law shares, and the choice of the law.

mod bottom;
mod cutters;
mod detournay;
mod excitation;
mod front;
mod motor;
mod rate;
mod regenerative;
mod settings;
mod side;
mod table;

use serde::{Deserialize, Serialize};

pub use self::{
    cutters::{Cutters, SteadyCut},
    detournay::DetournayDefournyLaw,
    excitation::{Band, Excitation},
    motor::{Motor, MudMotor},
    rate::RateLaw,
    regenerative::RegenerativeLaw,
    settings::{BitLaw, BitSettings},
    table::{BitTable, TableFault, TableLaw, TablePoint, TableUse},
};
use self::{
    excitation::Shaker,
    front::{FrontCut, FrontLaw, Pressed},
    motor::Drive,
    rate::Rate,
    regenerative::RegenerativeCut,
    side::Side,
    table::Counter,
};
use super::chain::{Chain, node};
use crate::rod::number::Real;
use crate::{operation::Operation, rod::vector::Vector};

/// The bit: held to the hole's axis, and on bottom pressed against the rock that it cuts.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Bit {
    side: Side,
    motor: Motor,
    drive: Drive,
    /// None off bottom.
    cut: Option<Cut>,
}

/// The rock under the bit by one of the laws.
#[derive(Debug, Clone, Serialize, Deserialize)]
enum Cut {
    Front(Box<FrontCut>),
    Regenerative(RegenerativeCut),
}

/// The bit's node as the step left it, without the rock.
#[derive(Debug, Clone, Copy)]
struct Approach {
    /// Measured depth of the bit, m.
    depth_m: f64,
    /// Its velocity along the hole, m/s, positive downwards.
    velocity_m_per_s: f64,
    /// Velocity per axial force, s/kg.
    axial_mobility_s_per_kg: f64,
    /// Spin of the string before the step, rad/s.
    spin_before_rad_per_s: f64,
    /// Spin that the step gave it, rad/s.
    spin_rad_per_s: f64,
    /// Spin per torque, 1/(N·m·s).
    turning_mobility: f64,
    /// Step, s.
    dt: f64,
}

/// What the rock answers.
#[derive(Debug, Clone, Copy, Default)]
struct Answer {
    weight_N: f64,
    /// Against the string's rotation.
    torque_N_m: f64,
    /// Spin that the torque leaves the string, exactly zero of a bit without motor that it holds.
    spin_rad_per_s: f64,
    depth_of_cut_m: f64,
    /// Rock that is taken away per time, m/s.
    rate_m_per_s: f64,
}

/// What the bit did in a step.
#[derive(Debug, Clone, Copy, Default)]
pub struct BitStep {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Torque on bit, N·m.
    pub torque_N_m: f64,
    /// Rock that a revolution takes away, m.
    pub depth_of_cut_m: f64,
    /// Rock that is taken away per time, m/s.
    pub rate_of_penetration_m_per_s: f64,
    /// Speed of the motor against the string, rad/s.
    pub motor_speed_rad_per_s: f64,
    /// Work done on the string, J.
    pub work_J: f64,
}

impl Bit {
    /// The bit of `operation` at `depth_m`, pressed on the rock with the operation's weight as it is
    /// while drilling steadily. `seed` is that of the excitation.
    pub fn new(settings: &BitSettings, operation: &Operation, depth_m: f64, seed: u64) -> Self {
        let drills = operation.kind.on_bottom() && operation.weight_on_bit_now_N() > 0.0;
        let motor = settings.motor;
        let flow = operation.flow_now_m3_per_s();
        let drive = Drive::new(motor, flow, operation.bit_torque_now_N_m());
        let front = |law: FrontLaw, stiffness_N_per_m: f64, excitation: Option<Excitation>| {
            let weight_N = operation.weight_on_bit_now_N();
            let turning = operation.rotation_rad_per_s() + drive.speed_rad_per_s();
            let shaker = excitation.map(|e| Shaker::new(e, seed));
            let pressed = Pressed {
                depth_m,
                weight_N,
                turning_rad_per_s: turning,
            };
            Cut::Front(Box::new(FrontCut::new(
                law,
                stiffness_N_per_m,
                shaker,
                pressed,
            )))
        };
        let cut = drills.then(|| match &settings.law {
            BitLaw::Regenerative(law) => {
                Cut::Regenerative(RegenerativeCut::new(*law, operation, depth_m))
            }
            BitLaw::Rate(law) => front(
                FrontLaw::Rate(Rate::new(operation, &drive)),
                law.rock_stiffness_N_per_m,
                law.excitation,
            ),
            BitLaw::DetournayDefourny(law) => front(
                FrontLaw::DetournayDefourny(*law),
                law.rock_stiffness_N_per_m,
                law.excitation,
            ),
            BitLaw::Table(law) => front(
                FrontLaw::Table(law.clone(), Counter::new()),
                law.rock_stiffness_N_per_m,
                law.excitation,
            ),
        });
        let side_cut_m_per_N = if drills {
            settings.side_cut_m_per_N(operation)
        } else {
            0.0
        };
        Self {
            side: Side::new(settings.lateral_stiffness_N_per_m, side_cut_m_per_N),
            motor,
            drive,
            cut,
        }
    }

    /// Changes what flows through the motor, m³/s.
    pub fn set_flow(&mut self, flow_m3_per_s: f64) {
        self.drive.set_flow(flow_m3_per_s);
    }

    /// Pressure that the motor takes off the mud at a torque, Pa, where that is known.
    pub fn motor_pressure_Pa(&self, torque_N_m: f64) -> Option<f64> {
        self.motor.pressure_Pa(torque_N_m)
    }

    /// Whether a motor turns the bit.
    pub fn has_motor(&self) -> bool {
        self.motor != Motor::Speed(0.0)
    }

    /// How often the bit was where its table is not, if it has one.
    pub fn table_use(&self) -> Option<TableUse> {
        match &self.cut {
            Some(Cut::Front(cut)) => cut.table_use(),
            _ => None,
        }
    }

    /// From now on [`Self::table_use`] counts.
    pub fn open_window(&mut self) {
        if let Some(Cut::Front(cut)) = &mut self.cut {
            cut.restart();
        }
    }

    /// Corrects the bit's node, which the step has moved without it, and advances the rock. The rock
    /// is evaluated at the step's end: with last step's position it would feed energy in. `md_m` is the
    /// depth of the node's anchor; velocity and spin before the step are given for the work done.
    pub fn act(
        &mut self,
        chain: &mut Chain<impl Real>,
        md_m: f64,
        velocity_before: Vector<f64>,
        spin_before: f64,
        dt: f64,
    ) -> BitStep {
        let index = chain.nodes() - 1;
        let tangent = chain.tangent(index);
        let held = self.side.hold(
            chain.velocity(index),
            chain.displacement(index),
            tangent,
            dt * node!(chain, index, inv_mass_lateral),
            spin_before + self.drive.speed_rad_per_s(),
            dt,
        );
        let (mut velocity, mut displacement) = (held.velocity, held.displacement);
        let mut work = held.force_N.dot((velocity_before + velocity).scaled(0.5));

        let mut step = BitStep::default();
        if let Some(cut) = &mut self.cut {
            let approach = Approach {
                depth_m: md_m + displacement.dot(tangent),
                velocity_m_per_s: velocity.dot(tangent),
                axial_mobility_s_per_kg: dt * node!(chain, index, inv_mass_axial),
                spin_before_rad_per_s: spin_before,
                spin_rad_per_s: node!(chain, index, spin),
                turning_mobility: dt * node!(chain, index, inv_polar),
                dt,
            };
            let Answer {
                weight_N: weight,
                torque_N_m: torque,
                spin_rad_per_s: spin,
                depth_of_cut_m,
                rate_m_per_s,
            } = match cut {
                Cut::Front(cut) => cut.meet(&approach, &mut self.drive),
                Cut::Regenerative(cut) => cut.meet(&approach, &mut self.drive),
            };
            let mobility = approach.axial_mobility_s_per_kg;
            velocity = velocity.minus(tangent, mobility * weight);
            displacement = displacement.minus(tangent, dt * mobility * weight);
            node!(chain, index, spin = spin);
            work -= weight * tangent.dot((velocity_before + velocity).scaled(0.5))
                + torque * 0.5 * (spin_before + spin);
            step = BitStep {
                weight_on_bit_N: weight,
                torque_N_m: torque,
                depth_of_cut_m,
                rate_of_penetration_m_per_s: rate_m_per_s,
                ..step
            };
        } else {
            self.drive.run_free();
        }
        chain.set_velocity(index, velocity);
        chain.set_displacement(index, displacement);
        step.motor_speed_rad_per_s = self.drive.speed_rad_per_s();
        step.work_J = work * dt;
        step
    }
}
