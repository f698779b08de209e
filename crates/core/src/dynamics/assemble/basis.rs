//! Preparation of a run before its string is initialised: checks of the settings, the hoist, the
//! mesh and the step.

use super::{
    SetupError,
    chain::{self, hoisting},
    check_numbers, foreseen,
};
use crate::{
    dynamics::{
        body::Body,
        boundary::{
            bit::{BitLaw, BitSettings, Motor, MudMotor},
            hole::Borehole,
        },
        initial_state,
        kernel::{
            places::Border,
            step::{Abilities, Laws, Stepper},
        },
        settings::{
            DynamicsSettings, FrictionLaw, SpeedController, Start, TopDriveSettings, mesh::Regions,
        },
        simulation::settling::Settling,
    },
    ends::BitEnd,
    model::Model,
    operation::Operation,
    rod::{
        mesh::Mesh,
        regions,
        stability::{self, StepPlan, Subcycling},
    },
    simd::{number::Real, wide::Registers},
    sizing::{ElementLength, Sizing},
    statics::soft::SoftError,
    wall::contact::ContactLaw,
};

/// Refuses settings that no run can use.
pub(in crate::dynamics) fn check(settings: &DynamicsSettings) -> Result<(), SetupError> {
    if let ElementLength::Uniform(length_m) = settings.mesh.element_length {
        check_numbers(&[("element_length_m", length_m)], &[])?;
    }
    let positive = [
        ("mesh.refinement", f64::from(settings.mesh.refinement)),
        ("duration_s", settings.duration_s),
        ("sample_interval_s", settings.sample_interval_s),
        ("stribeck_speed_m_per_s", settings.stribeck_speed_m_per_s),
        ("hoist_line.stiffness_N_per_m", settings.hoist_line.stiffness_N_per_m),
    ];
    let not_negative = [
        ("hoist_line.block_mass_kg", settings.hoist_line.block_mass_kg),
        ("settle_s", settings.settle_s),
        ("centred.ramp_s", settings.centred.ramp_s),
        ("damping.mass_per_s", settings.damping.mass_per_s),
        ("damping.stiffness_s", settings.damping.stiffness_s),
        ("hoist_line.damping_N_s_per_m", settings.hoist_line.damping_N_s_per_m),
        ("bit.lateral_stiffness_N_per_m", settings.bit.lateral_stiffness_N_per_m),
        ("bit.steerability", settings.bit.steerability),
    ];
    check_numbers(&positive, &not_negative)?;
    if let Some(until) = settings.steady {
        check_numbers(&[("steady.most_s", until.max_s)], &[])?;
    }
    check_numbers(&drive_numbers(&settings.top_drive), &[])?;
    check_bit(&settings.bit)?;
    check_shaken(&settings.bit)?;
    match settings.schedule.fault() {
        Some((index, fault)) => Err(SetupError::Schedule { line: index + 1, fault }),
        None => Ok(()),
    }
}

fn check_bit(bit: &BitSettings) -> Result<(), SetupError> {
    match bit.motor {
        Motor::Speed(speed) => check_numbers(&[], &[("bit.motor_speed_rad_per_s", speed)])?,
        Motor::Displacement(motor) => check_motor(&motor)?,
    }
    bit.law.check()
}

fn check_motor(motor: &MudMotor) -> Result<(), SetupError> {
    let positive = [
        ("bit.motor.displacement_m3", motor.displacement_m3),
        ("bit.motor.rated_flow_m3_per_s", motor.rated_flow_m3_per_s),
        ("bit.motor.max_pressure_Pa", motor.max_pressure_Pa),
        ("bit.motor.efficiency", motor.efficiency),
        ("bit.motor.slip below 1", 1.0 - motor.slip),
        (
            "bit.motor.stall_torque_N_m above the torque at max_pressure_Pa",
            motor.stall_torque_N_m - motor.max_torque_N_m(),
        ),
    ];
    check_numbers(&positive, &[("bit.motor.slip", motor.slip)])
}

/// The numbers of a top drive that must be positive, with their names.
fn drive_numbers(drive: &TopDriveSettings) -> Vec<(&'static str, f64)> {
    let (inertia_kg_m2, torque_limit_N_m, controller) = match *drive {
        TopDriveSettings::Constant => return Vec::new(),
        TopDriveSettings::Driven { inertia_kg_m2, controller, torque_limit_N_m } => {
            (inertia_kg_m2, torque_limit_N_m, Some(controller))
        }
        TopDriveSettings::Custom(ref custom) => {
            (custom.inertia_kg_m2, custom.torque_limit_N_m, None)
        }
    };
    let mut numbers = vec![("top_drive.inertia_kg_m2", inertia_kg_m2)];
    numbers.extend(torque_limit_N_m.map(|limit| ("top_drive.torque_limit_N_m", limit)));
    let Some(controller) = controller else {
        return numbers;
    };
    match controller {
        SpeedController::Pi { proportional_N_m_s, .. } => {
            numbers.push(("top_drive.proportional_N_m_s", proportional_N_m_s))
        }
        SpeedController::SoftTorque { impedance_ratio, frequency_Hz } => {
            numbers.push(("top_drive.impedance_ratio", impedance_ratio));
            numbers.extend(frequency_Hz.map(|hz| ("top_drive.frequency_Hz", hz)));
        }
        SpeedController::ZTorque { impedance_ratio, frequency_Hz, proportional_N_m_s, .. } => {
            numbers.push(("top_drive.impedance_ratio", impedance_ratio));
            numbers.push(("top_drive.proportional_N_m_s", proportional_N_m_s));
            numbers.extend(frequency_Hz.map(|hz| ("top_drive.frequency_Hz", hz)));
        }
    }
    numbers
}

/// Measured depth of the bit at time zero, m: half the run above or below the operation's depth, or
/// at that depth where a schedule moves the hoist. Where settling ends by itself, its shortest
/// duration counts.
pub(in crate::dynamics) fn first_bit_md_m(
    operation: &Operation,
    settings: &DynamicsSettings,
    settling: &Settling,
) -> f64 {
    if settings.schedule.moves_the_hoist() {
        return operation.bit_depth_m;
    }
    let middle_s = settling.min_s() + 0.5 * settings.duration_s;
    operation.bit_depth_m - hoisting(operation, settings).1 * middle_s
}

/// Returns an error for a user-defined excitation under a law without a rock front.
fn check_shaken(bit: &BitSettings) -> Result<(), SetupError> {
    let reason = match &bit.law {
        BitLaw::Regenerative(_) => {
            "the bottom is the surface that the bit's previous passage has left"
        }
        BitLaw::Rock(_) => "the bottom is solid rock, as the bit has left it",
        // All others cut a rock front.
        _ => return Ok(()),
    };
    bit.excitation.as_ref().map_or(Ok(()), |_| Err(SetupError::Excitation(reason)))
}

/// Sizing of the elements whose length is chosen automatically, from the effect of the operation on
/// the string and from the extremes that its schedule and its hoist may reach.
fn sizing(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
) -> Result<Sizing, SoftError> {
    let accuracy = match settings.mesh.element_length {
        ElementLength::Uniform(length_m) => return Ok(Sizing::uniform(length_m)),
        ElementLength::Auto(accuracy) => accuracy,
    };
    Sizing::auto(model, &foreseen::operations(model, operation, settings)?, accuracy)
}

/// The string in elements, how it settles, and the step.
fn mesh_and_plan(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
) -> Result<(Mesh, Settling, StepPlan), SoftError> {
    let sizing = sizing(model, operation, settings)?.refined(settings.mesh.refinement);
    let mesh = Mesh::new(&model.string, &sizing);
    let settling = Settling::of(model, operation, settings, &mesh);
    let bit_md_m = first_bit_md_m(operation, settings, &settling);
    let lateral = chain::lateral_mass_kg_per_m(model, &mesh, bit_md_m);
    let beta = settings.damping.stiffness_s;
    let plan = match settings.mesh.regions {
        Regions::One => stability::plan(&mesh, &lateral, beta),
        Regions::Auto => regions::plan(&mesh, &lateral, beta, Body::new(model, &mesh).highest()),
    };
    Ok((mesh, settling, plan.dividing(settings.sample_interval_s)))
}

/// Everything that follows from the model, the operation and the settings of a run. It is the same
/// at the start and wherever the run is resumed.
pub(in crate::dynamics) struct Basis<R: Real> {
    pub(in crate::dynamics) mesh: Mesh,
    pub(in crate::dynamics) settling: Settling,
    pub(in crate::dynamics) plan: StepPlan,
    pub(in crate::dynamics) borehole: Borehole,
    pub(in crate::dynamics) abilities: Abilities,
    pub(in crate::dynamics) stepper: Stepper<R>,
    pub(in crate::dynamics) steps_per_sample: u64,
}

impl<R: Real> Basis<R> {
    /// Border at which the chain is divided.
    pub(in crate::dynamics) fn border(&self) -> Option<Border> {
        let border = |s: Subcycling| Border { node: s.border_node, parts: s.parts };
        self.plan.subcycling.map(border)
    }
}

impl<R: Registers> Basis<R> {
    pub(in crate::dynamics) fn new(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<Self, SetupError> {
        check(settings)?;
        check_bit_end(model, operation, settings)?;
        let served = settings.precision.serves(operation, settings);
        served.map_err(SetupError::Precision)?;
        let (mesh, settling, plan) = mesh_and_plan(model, operation, settings)?;
        Self::on(model, settings, mesh, settling, plan)
    }

    /// The same with a ready mesh and a ready plan.
    pub(in crate::dynamics) fn on(
        model: &Model,
        settings: &DynamicsSettings,
        mesh: Mesh,
        settling: Settling,
        plan: StepPlan,
    ) -> Result<Self, SetupError> {
        check_weight_of_bit(settings, &plan)?;
        let borehole = Borehole::new(model, &mesh, settings.contact_law);
        let abilities = Abilities {
            laws: Laws {
                hertz: matches!(settings.contact_law, ContactLaw::Hertz { .. }),
                vector: settings.friction_law == FrictionLaw::Vector,
            },
            full: borehole.intricate || model.has_rheology(),
        };
        let steps_per_sample = (settings.sample_interval_s / plan.dt_s).round().max(1.0) as u64;
        Ok(Self {
            mesh,
            settling,
            plan,
            borehole,
            abilities,
            stepper: Stepper::new(abilities),
            steps_per_sample,
        })
    }
}

/// Refuses a bit that is held on the hole's axis by solid rock and by its end of the string.
fn check_bit_end(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
) -> Result<(), SetupError> {
    let on_rock = matches!(settings.bit.law, BitLaw::Rock(_)) && operation.kind.on_bottom();
    match model.ends.bit {
        BitEnd::Pinned | BitEnd::Clamped if on_rock => Err(SetupError::BitEnd),
        _ => Ok(()),
    }
}

/// Refuses a bit on solid rock that is lighter than the rock nodes that it touches: its contact
/// would not be stable.
fn check_weight_of_bit(settings: &DynamicsSettings, plan: &StepPlan) -> Result<(), SetupError> {
    let (BitLaw::Rock(law), Some(lowest)) = (&settings.bit.law, plan.inertia.last()) else {
        return Ok(());
    };
    let [touched_kg, touched_kg_m2] = law.touched();
    for (direction, unit, bit, rock) in [
        ("along the hole", "kg", lowest.axial_kg, touched_kg),
        ("across the hole", "kg", lowest.lateral_kg, touched_kg),
        ("about its axis", "kg·m²", lowest.polar_kg_m2, touched_kg_m2),
    ] {
        // The lowest node has half of the lowest element.
        let bit = 0.5 * bit;
        if bit <= rock {
            return Err(SetupError::LightBit { direction, unit, bit, rock });
        }
    }
    Ok(())
}

/// Cost of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Effort {
    /// The string cut into elements.
    pub mesh: Mesh,
    /// The step, and the limit that determines it.
    pub plan: StepPlan,
    /// Simulated time from the start to the end of the window, s, at most.
    pub end_s: f64,
    /// Steps from the initialisation of the string to the end of the window, at most.
    pub steps: f64,
}

impl Effort {
    /// Elements times the steps that each takes: those of the assembly more, where it has steps of
    /// its own.
    pub fn element_steps(&self) -> f64 {
        self.plan.element_steps() * self.steps
    }

    /// Computes the cost of the run without initialising the string.
    ///
    /// # Errors
    /// A setting out of range, or a bit on solid rock that is lighter than the rock nodes that it
    /// touches.
    pub fn of(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<Self, SetupError> {
        check(settings)?;
        check_bit_end(model, operation, settings)?;
        let (mesh, settling, plan) = mesh_and_plan(model, operation, settings)?;
        check_weight_of_bit(settings, &plan)?;
        let laying_s = match settings.start {
            Start::Prepared => initial_state::SETTLING_S,
            Start::Centred => 0.0,
        };
        Ok(Self {
            end_s: settling.max_s() + settings.duration_s,
            steps: (laying_s + settling.max_s() + settings.duration_s) / plan.dt_s,
            mesh,
            plan,
        })
    }
}
