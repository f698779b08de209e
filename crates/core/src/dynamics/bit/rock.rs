//! Solid rock under the bit: bricks that the face of the bit breaks.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Rotation3, Vector3};
use serde::{Deserialize, Serialize};

use super::{BitStep, Came, Cutters, SteadyCut, motor::Drive};
use crate::{
    GRAVITY_M_PER_S2,
    dynamics::{
        assembly::Anchor,
        chain::{Chain, element, node},
        crew::Crew,
    },
    rock::{
        BitMotion, BitShape, Drilling, DrillingError, DrillingSpec, Driver, Inertia, bit_face::Pose,
    },
    rod::{number::Real, vector::Vector},
};

/// Time over which what pushes and turns the bit is averaged, s: that average acts on the bit evenly, and a motor follows that
/// of the torque. Some dozens of steps.
const EVEN_S: f64 = 0.02;

/// Part of the nodes of the bottom that a bit touches at the most: twice what bits of 60 and 216 mm on bricks of 3 to 12 mm did.
const TOUCHED: f64 = 0.125;

/// Angle by which the bit turns on its bottom before the start, rad: each blade has met what it has left itself.
const RUN_IN_RAD: f64 = TAU;

/// How long a bit that does not turn presses before the start, s, when all weight is there, as a part of that, and what calms
/// it, 1/s.
const PRESSING_S: f64 = 0.03;
const PRESSED: f64 = 0.5;
const PRESSING_DAMPING_PER_S: f64 = 2000.0;

/// Step before the start, s.
const RUN_IN_STEP_S: f64 = 2e-4;

/// Inclination of the force on an insert that scrapes, over that around: a face raked back by 45°.
const INSERT_RAKE_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// Solid rock: the face of the bit breaks bricks, and feels what they answer in all six components.
///
/// Sideways the bit's own spring holds it besides: a wall of bricks leaves its gauge room to bang about.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RockLaw {
    /// The bit and its rock.
    pub drilling: DrillingSpec,
}

impl RockLaw {
    /// What Detournay and Defourny's law would have for it: an **estimate**, by which the string is laid and the hoist begins,
    /// and nothing more.
    ///
    /// Sharp cutters whose intrinsic specific energy is the rock's unconfined strength, as it is about (Richard, Dagrain, Poyol
    /// and Detournay, *Engineering Geology* 147, 2012); `ζ = tan(θ + ψ)` of the back rake `θ` and the friction angle `ψ`
    /// between rock and cutter.
    pub fn estimate(&self) -> Cutters {
        let (diameter_m, core_m, rake_rad) = match &self.drilling.bit {
            BitShape::Pdc(bit) => (bit.diameter_m, bit.core_diameter_m, bit.back_rake_rad),
            BitShape::Insert(bit) => (bit.diameter_m, 0.0, INSERT_RAKE_RAD),
        };
        let friction = self.drilling.contact.friction;
        Cutters {
            radius_m: 0.5 * diameter_m,
            core_radius_m: 0.5 * core_m,
            intrinsic_specific_energy_Pa: self.drilling.block.rock.ucs_Pa(),
            cutter_inclination: (rake_rad + friction.atan()).tan(),
            wear_flat_m: 0.0,
            contact_strength_Pa: 0.0,
            bit_geometry: 1.0,
            friction,
        }
    }

    /// How it may be expected to drill under a weight on bit, turning at a speed: [`Self::estimate`].
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let cutters = self.estimate();
        let depth_of_cut_m = weight_on_bit_N / cutters.cutting_N_per_m();
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: cutters.torque_N_m(weight_on_bit_N, 0.0),
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }

    /// Mass (kg) and moment of inertia about the hole (kg·m²) of the nodes of rock that the bit touches at the most, scaled as the
    /// density is. The contact is stable under a bit that has more.
    pub fn touched(&self) -> [f64; 2] {
        let block = &self.drilling.block;
        let cutters = self.estimate();
        let [outer, inner] = [cutters.radius_m, cutters.core_radius_m].map(|r| r * r);
        // A node of the bottom has half a brick below it.
        let thick_m = 0.5 * block.size_m[2];
        let density = block.rock.density_kg_per_m3 * block.numerics.density_factor;
        let mass_kg = TOUCHED * density * thick_m * std::f64::consts::PI * (outer - inner);
        [mass_kg, 0.5 * mass_kg * (outer + inner)]
    }

    /// Stiffness of the sound rock under a stamp as wide as the bit, `2 E a/(1 − ν²)`, N/m.
    pub fn stiffness_N_per_m(&self) -> f64 {
        let rock = &self.drilling.block.rock;
        let radius_m = self.estimate().radius_m;
        2.0 * rock.youngs_modulus_Pa * radius_m / (1.0 - rock.poisson_ratio.powi(2))
    }
}

/// How a bit stands on its rock at time zero.
#[derive(Debug, Clone, Copy)]
pub struct Standing {
    /// Weight on it, N.
    pub weight_N: f64,
    /// Torque that it is turned with, N·m.
    pub torque_N_m: f64,
    /// How fast it goes down, m/s.
    pub rate_m_per_s: f64,
    /// Speed of the string, rad/s.
    pub string_rad_per_s: f64,
}

/// The rock under a bit, and where it stands in the world.
///
/// The block stands along the hole as it was where the bit began, x to its high side, and stays so: the bit leaves the axis of
/// the survey where the rock lets it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct RockCut {
    drilling: Drilling,
    /// Turns the block's frame into the world's.
    frame: Matrix3<f64>,
    /// Where the block's frame has its origin, m.
    origin_m: Vector3<f64>,
    /// What the string pushes and turns the bit with, on average, in the block's frame.
    even_N: Vector3<f64>,
    even_N_m: f64,
    /// Torque of the rock against the bit, on average, N·m.
    resisting_N_m: f64,
    /// Way of the bit in about its last revolution, which fades as it turns, m.
    depth_of_cut_m: f64,
}

impl RockCut {
    /// A bit on its rock; [`Self::stand`] says where.
    pub(super) fn new(law: &RockLaw) -> Result<Self, DrillingError> {
        Ok(Self {
            drilling: Drilling::new(&law.drilling)?,
            frame: Matrix3::identity(),
            origin_m: Vector3::zeros(),
            even_N: Vector3::zeros(),
            even_N_m: 0.0,
            resisting_N_m: 0.0,
            depth_of_cut_m: 0.0,
        })
    }

    /// Runs the bit in on its bottom as the string moves at time zero, and puts the block there in the hole where the string's bit is.
    pub(super) fn stand(
        &mut self,
        chain: &Chain<impl Real>,
        anchor: &Anchor,
        first: Standing,
        motor_rad_per_s: f64,
        crew: &Crew,
    ) {
        let turning_rad_per_s = first.string_rad_per_s + motor_rad_per_s;
        let index = chain.nodes() - 1;
        let tangent = Vector3::from(chain.tangent(index));
        let hole = Pose::new(Vector3::zeros(), tangent, anchor.high_side, 0.0);
        self.frame = hole.rotation;
        let along = self.frame.tr_mul(&Vector3::from(chain.director(index)));
        let tilt = Rotation3::rotation_between(&Vector3::z(), &along).unwrap_or_default();
        let pose = *self.drilling.pose();
        self.drilling.place(Pose {
            rotation: tilt.matrix() * pose.rotation,
            ..pose
        });
        let mass_kg = 1.0 / node!(chain, index, inv_mass_axial);
        if first.weight_N > 0.0 && turning_rad_per_s > 0.0 {
            self.run_in(first, mass_kg, turning_rad_per_s, crew);
        } else if first.weight_N > 0.0 {
            self.press(first.weight_N, mass_kg, crew);
        }
        let at = anchor.position_m + Vector3::from(chain.displacement(index));
        self.origin_m = at - self.frame * self.drilling.pose().position_m;
        self.even_N = Vector3::z() * first.weight_N;
        self.even_N_m = first.torque_N_m;
        self.resisting_N_m = first.torque_N_m;
        if turning_rad_per_s > 0.0 {
            self.depth_of_cut_m = first.rate_m_per_s * TAU / turning_rad_per_s;
        }
    }

    /// Drills a revolution under the weight at a constant speed: what weighs as much as the weight, or the bit's node if that is
    /// more, goes down with the bit.
    fn run_in(&mut self, first: Standing, mass_kg: f64, rotary_rad_per_s: f64, crew: &Crew) {
        let driver = Driver::Weight {
            weight_N: first.weight_N,
            mass_kg: mass_kg.max(first.weight_N / GRAVITY_M_PER_S2),
            rotary_rad_per_s,
        };
        let mut pose = *self.drilling.pose();
        pose.velocity_m_per_s = Vector3::z() * first.rate_m_per_s;
        self.drilling.place(pose);
        let time_s = RUN_IN_RAD / rotary_rad_per_s;
        let steps = (time_s / RUN_IN_STEP_S).ceil();
        for _ in 0..steps as usize {
            driver.drive(
                &mut self.drilling,
                time_s / steps,
                &crew.stepper,
                &crew.lent,
            );
        }
    }

    /// Lets a bit that only goes along the hole sink until the rock bears it.
    fn press(&mut self, weight_N: f64, mass_kg: f64, crew: &Crew) {
        let steps = (PRESSING_S / RUN_IN_STEP_S).ceil();
        let step_s = PRESSING_S / steps;
        let left = (-PRESSING_DAMPING_PER_S * step_s).exp();
        for step in 1..=steps as usize {
            let part = (step as f64 / (PRESSED * steps)).min(1.0);
            let motion = BitMotion {
                velocity_m_per_s: Vector3::z() * (left * self.drilling.pose().velocity_m_per_s.z),
                angular_velocity_rad_per_s: Vector3::zeros(),
                force_N: Vector3::z() * (part * weight_N),
                moment_N_m: Vector3::zeros(),
                inertia: Inertia {
                    mass_kg,
                    ..Inertia::TOLD
                },
            };
            self.drilling
                .advance(step_s, &motion, &crew.stepper, &crew.lent);
        }
    }

    /// Takes the bit's node, which the step has pushed without the rock, through the step.
    ///
    /// The string's impulse is given in two parts: its average of late evenly, the rest at the step's beginning, from where the
    /// bit moves as the rock lets it. So the string's own motion stays that of central differences, and the rock feels
    /// no blow at each step of the string. What the rock does to the bit is what the bit does to the rock, in momentum to
    /// rounding, and its work is that on the way that the bit took. What the bit has turned further than its last spin says goes to the twist.
    ///
    /// A motor keeps its speed in the step; that follows the average of the torque, first order in time.
    pub(super) fn drill(
        &mut self,
        chain: &mut Chain<impl Real>,
        anchor: &Anchor,
        came: Came,
        drive: &mut Drive,
        crew: &Crew,
        dt: f64,
    ) -> BitStep {
        let index = chain.nodes() - 1;
        let inertia = Inertia {
            mass_kg: 1.0 / node!(chain, index, inv_mass_axial),
            lateral_mass_kg: 1.0 / node!(chain, index, inv_mass_lateral),
            about_axis_kg_m2: 1.0 / node!(chain, index, inv_polar),
            across_axis_kg_m2: 1.0 / node!(chain, index, inv_rotary),
        };
        let into = |v: Vector<f64>| self.frame.tr_mul(&Vector3::from(v));
        let [before, velocity, tilting] =
            [came.velocity, chain.velocity(index), chain.turning(index)].map(into);
        let mass = Vector3::new(
            inertia.lateral_mass_kg,
            inertia.lateral_mass_kg,
            inertia.mass_kg,
        );
        let part = dt / (EVEN_S + dt);
        let push_N = (velocity - before).component_mul(&mass) / dt;
        let spin = node!(chain, index, spin);
        let turn_N_m = (spin - came.spin) * inertia.about_axis_kg_m2 / dt;
        self.even_N += (push_N - self.even_N) * part;
        self.even_N_m += (turn_N_m - self.even_N_m) * part;

        drive.resist(self.resisting_N_m);
        let motor = drive.speed_rad_per_s();
        let axis = self.drilling.pose().axis();
        let kept = spin - dt * self.even_N_m / inertia.about_axis_kg_m2;
        let motion = BitMotion {
            velocity_m_per_s: velocity - self.even_N.component_div(&mass) * dt,
            angular_velocity_rad_per_s: tilting + axis * (kept + motor),
            force_N: self.even_N,
            moment_N_m: axis * self.even_N_m,
            inertia,
        };
        let advance = self
            .drilling
            .advance(dt, &motion, &crew.stepper, &crew.lent);
        let axis = self.drilling.pose().axis();
        let omega = advance.angular_velocity_rad_per_s;
        let turned = omega.dot(&axis);
        let spin_after = turned - motor;
        let torque_N_m = (spin - spin_after) * inertia.about_axis_kg_m2 / dt;
        self.resisting_N_m += (torque_N_m - self.resisting_N_m) * part;

        let out = |v: Vector3<f64>| Vector::from(self.frame * v);
        chain.set_velocity(index, out(advance.velocity_m_per_s));
        let at = self.origin_m + self.frame * self.drilling.pose().position_m;
        chain.set_displacement(index, (at - anchor.position_m).into());
        chain.set_director(index, out(axis));
        chain.set_turning(index, out(omega - axis * turned));
        node!(chain, index, spin = spin_after);
        if index > 0 {
            let further = advance.turned_rad - dt * (motor + spin_after);
            element!(chain, index - 1, twist += further);
        }
        let rate_m_per_s = advance.displacement_m.z / dt;
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
            // What the motor gives the bit does not come from the string.
            work_J: advance.work_J + torque_N_m * motor * dt,
        }
    }

    /// The bit and the rock.
    pub(super) fn drilling(&self) -> &Drilling {
        &self.drilling
    }
}
