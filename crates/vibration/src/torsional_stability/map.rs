//! Stability over rotary speed and weight on bit.

use std::f64::consts::TAU;

use wholestring::{
    dynamics::{DynamicsSettings, Effort, SpeedController, TorsionalString, hoisting},
    model::Model,
    operation::{Operation, OperationKind},
    rod::{mesh::Mesh, stability::StepPlan},
};

use super::{
    StabilityError, StabilitySettings,
    bit::{LinearBit, LinearRock},
    chain::LumpedChain,
    characteristic::SteadyRotation,
    drive::LinearDrive,
    hoist::LinearHoist,
    pressing::{LiesBy, Pressing},
    roots::{Band, Stability},
    wall::Drag,
};

/// Motions slower than this fraction of the string's lowest torsional frequency belong to the
/// hoist.
const SLOWEST: f64 = 0.2;

/// Nodes are merged as long as the fastest motion that is looked at turns by no more than this from
/// one to the next, rad: its frequency is then off by a part of `0.4²/24`, 0.7 %, and that of a
/// motion five times slower by 0.03 %.
const MERGED_RAD: f64 = 0.4;

/// Friction at rest over kinetic friction that is offered where a case has none: a round number to
/// look at first, of no measurement. Whoever knows the ratio of the own hole gives it in the case.
pub const USUAL_STATIC_OVER_KINETIC: f64 = 1.2;

/// A threshold is found to this part of itself.
const THRESHOLD: f64 = 1e-3;

/// A string that drills, before speed and weight are chosen.
#[derive(Debug, Clone)]
pub struct TorsionalStability<'a> {
    model: &'a Model,
    operation: Operation,
    settings: &'a DynamicsSettings,
    mesh: Mesh,
    torsion: LumpedChain,
    axial: LumpedChain,
    drive: LinearDrive,
    string: TorsionalString,
}

/// A weight, with the position of the string in its hole under it.
#[derive(Debug, Clone)]
pub struct StabilityAtWeight<'a> {
    stability: &'a TorsionalStability<'a>,
    weight_on_bit_N: f64,
    pressing: Pressing,
    drive: LinearDrive,
}

impl<'a> TorsionalStability<'a> {
    /// The string of a case, cut into the elements of the dynamics and with their inertia.
    ///
    /// # Errors
    /// An operation that is not drilling, a law without slopes, and settings that no run can use.
    pub fn new(
        model: &'a Model,
        operation: &Operation,
        settings: &'a DynamicsSettings,
    ) -> Result<Self, StabilityError> {
        if operation.kind != OperationKind::Drill || operation.weight_on_bit_N <= 0.0 {
            return Err(StabilityError::NotDrilling);
        }
        if settings.friction_coefficient.is_some() {
            return Err(StabilityError::Custom("a friction law"));
        }
        let operation = settings.bit.drilling_steadily(*operation);
        let Effort { mesh, plan, .. } = Effort::of(model, &operation, settings)?;
        let string = TorsionalString::of(&mesh);
        let [torsion, axial] = chains(&mesh, &plan, settings);
        let drive = LinearDrive::new(&settings.top_drive, string, torsion.inertia[0])
            .ok_or(StabilityError::Custom("a controller of the top drive"))?;
        // Returns the error of a law without slopes at once.
        LinearBit::new(&settings.bit, &operation, &operation)?;
        Ok(Self { model, operation, settings, mesh, torsion, axial, drive, string })
    }

    /// Whether something in the string's surroundings falls with speed, and so can drive
    /// stick-slip: the friction of a section of the hole, the torque of the bit, or the weight of a
    /// bit that cuts the surface left by its own previous passage.
    ///
    /// Without that only the rate of penetration drives it, under much weight: a bit that slows
    /// down drills less than the string follows, which adds weight and torque (by `T/Ω` where the
    /// string does not give way along the hole).
    ///
    /// # Errors
    /// A bit without slopes.
    pub fn anything_falls(&self) -> Result<bool, StabilityError> {
        let sections = self.model.well.hole.sections();
        let friction = sections.iter().map(|section| section.friction);
        if friction.into_iter().any(|friction| friction.at_rest > friction.kinetic) {
            return Ok(true);
        }
        let bit = LinearBit::new(&self.settings.bit, &self.operation, &self.operation)?;
        Ok(bit.torque_per_speed_N_m_s < 0.0 || matches!(bit.rock, LinearRock::Delay { .. }))
    }

    /// The error of a map that is meaningless because every point is stable: it names the missing
    /// input of the case.
    pub fn nothing_falls(&self) -> StabilityError {
        let kinetic = self.model.well.hole.sections().last().map_or(0.0, |at| at.friction.kinetic);
        let ratio = USUAL_STATIC_OVER_KINETIC;
        let at_rest = (1e3 * ratio * kinetic).round() * 1e-3;
        StabilityError::NothingFalls { kinetic, at_rest, ratio }
    }

    /// The case's own operation, with the torque and rate of its bit.
    pub fn operation(&self) -> &Operation {
        &self.operation
    }

    /// The string as its top drive is tuned to it.
    pub fn string(&self) -> TorsionalString {
        self.string
    }

    /// The top drive.
    pub fn drive(&self) -> LinearDrive {
        self.drive
    }

    /// Band of the search for roots.
    pub fn band(&self, settings: &StabilitySettings) -> Band {
        Band {
            lowest_rad_per_s: SLOWEST * TAU * self.string.frequency_Hz,
            highest_rad_per_s: settings.highest_rad_per_s(),
        }
    }

    /// The operation at another speed and weight; the torque by which the rate law's motor turns is
    /// in proportion to the weight.
    fn at(&self, rotary_speed_rad_per_s: f64, weight_on_bit_N: f64) -> Operation {
        let own = &self.operation;
        let bit_torque_N_m = own.bit_torque_N_m * weight_on_bit_N / own.weight_on_bit_N;
        Operation { rotary_speed_rad_per_s, weight_on_bit_N, bit_torque_N_m, ..*own }
    }

    /// Lays the string in its hole under a weight on bit, turning at the operation's speed.
    ///
    /// # Errors
    /// A string that cannot be laid, or a bit without slopes there.
    pub fn at_weight(&self, weight_on_bit_N: f64) -> Result<StabilityAtWeight<'_>, StabilityError> {
        let mut operation = self.at(self.operation.rotary_speed_rad_per_s, weight_on_bit_N);
        let bit = LinearBit::new(&self.settings.bit, &self.operation, &operation)?;
        operation.bit_torque_N_m = bit.torque_N_m;
        operation.rate_of_penetration_m_per_s = bit.rate_m_per_s;
        let pressing = Pressing::new(self.model, &self.mesh, self.settings, &operation)?;
        Ok(StabilityAtWeight { stability: self, weight_on_bit_N, pressing, drive: self.drive })
    }

    /// A weight on bit at all speeds of the settings.
    ///
    /// # Errors
    /// Those of [`Self::at_weight`], and a range that holds nothing.
    pub fn line(
        &self,
        weight_on_bit_N: f64,
        settings: &StabilitySettings,
    ) -> Result<StabilityLine, StabilityError> {
        self.at_weight(weight_on_bit_N)?.line(settings)
    }
}

impl StabilityAtWeight<'_> {
    /// The same with the drive under another controller.
    #[must_use]
    pub fn under(&self, controller: SpeedController) -> Self {
        Self { drive: self.drive.under(controller, self.stability.string), ..self.clone() }
    }

    /// The string as its top drive is tuned to it.
    pub(super) fn string(&self) -> TorsionalString {
        self.stability.string
    }

    /// Its top drive.
    pub fn drive(&self) -> LinearDrive {
        self.drive
    }

    /// The string turning steadily at a speed.
    ///
    /// # Errors
    /// A bit that stalls its motor.
    pub fn turning(&self, rotary_speed_rad_per_s: f64) -> Result<SteadyRotation, StabilityError> {
        let TorsionalStability { model, settings, mesh, torsion, axial, .. } = self.stability;
        let operation = self.stability.at(rotary_speed_rad_per_s, self.weight_on_bit_N);
        let bit = LinearBit::new(&settings.bit, &self.stability.operation, &operation)?;
        let rate = bit.rate_m_per_s;
        let drag = Drag::new(model, mesh, settings, &operation, &self.pressing, rate);
        let (control, _) = hoisting(&operation, settings);
        Ok(SteadyRotation {
            torsion: torsion.with_drag(&drag.about_N_m_s),
            axial: axial.with_drag(&drag.along_N_s_per_m),
            drive: self.drive,
            hoist: LinearHoist::new(control, settings, rate),
            bit,
        })
    }

    /// Stability of small vibrations at a speed.
    ///
    /// # Errors
    /// A bit that stalls its motor.
    pub fn point(&self, speed: f64, band: Band) -> Result<StabilityPoint, StabilityError> {
        Ok(StabilityPoint {
            rotary_speed_rad_per_s: speed,
            weight_on_bit_N: self.weight_on_bit_N,
            stability: self
                .turning(speed)?
                .merged(MERGED_RAD / band.highest_rad_per_s)
                .stability(band),
        })
    }

    /// All speeds of the settings.
    ///
    /// # Errors
    /// A bit that stalls its motor, and a range that holds nothing.
    pub fn line(&self, settings: &StabilitySettings) -> Result<StabilityLine, StabilityError> {
        settings.check()?;
        let band = self.stability.band(settings);
        let speeds = settings.speeds_rad_per_s.values();
        let points: Result<Vec<_>, _> = speeds.iter().map(|s| self.point(*s, band)).collect();
        let points = points?;
        let limit_N_m =
            self.stability.settings.top_drive.torque_limit_N_m().unwrap_or(f64::INFINITY);
        Ok(StabilityLine {
            weight_on_bit_N: self.weight_on_bit_N,
            threshold: self.threshold(&points, band)?,
            points,
            surface_torque_N_m: self.pressing.surface_torque_N_m,
            stalls: self.pressing.surface_torque_N_m > limit_N_m,
            lies_by: self.pressing.by,
        })
    }

    /// The speed from which on all points are stable, halved between the last that is not and the
    /// next.
    fn threshold(
        &self,
        points: &[StabilityPoint],
        band: Band,
    ) -> Result<Threshold, StabilityError> {
        let Some(last) = points.iter().rposition(|point| !point.stability.is_stable()) else {
            return Ok(Threshold::Everywhere);
        };
        let Some(above) = points.get(last + 1) else {
            return Ok(Threshold::Nowhere);
        };
        let (mut low, mut high) =
            (points[last].rotary_speed_rad_per_s, above.rotary_speed_rad_per_s);
        while high - low > THRESHOLD * high {
            let middle = 0.5 * (low + high);
            if self.point(middle, band)?.stability.is_stable() {
                high = middle;
            } else {
                low = middle;
            }
        }
        Ok(Threshold::From(0.5 * (low + high)))
    }
}

/// The string in torsion and along the hole, with the inertia, stiffness and damping of the
/// dynamics.
fn chains(mesh: &Mesh, plan: &StepPlan, settings: &DynamicsSettings) -> [LumpedChain; 2] {
    let nodes = mesh.nodes.len();
    let (mut polar, mut mass) = (vec![0.0; nodes], vec![0.0; nodes]);
    for (index, inertia) in plan.inertia.iter().enumerate() {
        for end in [index, index + 1] {
            polar[end] += 0.5 * inertia.polar_kg_m2;
            mass[end] += 0.5 * inertia.axial_kg;
        }
    }
    if let Some(subcycling) = &plan.subcycling {
        polar[subcycling.border_node + 1] += subcycling.polar_kg_m2;
        mass[subcycling.border_node + 1] += subcycling.axial_kg;
    }
    let damped = |inertia: &[f64]| -> Vec<f64> {
        inertia.iter().map(|inertia| inertia * settings.damping.mass_per_s).collect()
    };
    let (mut about, along) = (damped(&polar), damped(&mass));
    // The drive has the top node to itself.
    about[0] = 0.0;
    let per_length = |section: fn(&wholestring::rod::section::Section) -> f64| -> Vec<f64> {
        mesh.elements.iter().map(|e| section(&e.section) / e.length_m).collect()
    };
    let stiffness_damping_s = settings.damping.stiffness_s;
    [
        LumpedChain {
            inertia: polar,
            stiffness: per_length(|section| section.torsional_stiffness_N_m2),
            drag: about,
            stiffness_damping_s,
        },
        LumpedChain {
            inertia: mass,
            stiffness: per_length(|section| section.axial_stiffness_N),
            drag: along,
            stiffness_damping_s,
        },
    ]
}

// A row of the map: a weight on bit at all speeds.

/// A speed and a weight, and the stability of small vibrations there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StabilityPoint {
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Stability of small vibrations.
    pub stability: Stability,
}

/// From which rotary speed on steady rotation is stable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Threshold {
    /// From the slowest of the range.
    Everywhere,
    /// From this one, rad/s.
    From(f64),
    /// Not even at the fastest of the range.
    Nowhere,
}

/// A weight on bit at all speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityLine {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// By speed.
    pub points: Vec<StabilityPoint>,
    /// From which speed on it is stable.
    pub threshold: Threshold,
    /// Torque at the top while it turns steadily, N·m.
    pub surface_torque_N_m: f64,
    /// Whether that is more than the top drive gives.
    pub stalls: bool,
    /// Method that provided the contact of the string.
    pub lies_by: LiesBy,
}
