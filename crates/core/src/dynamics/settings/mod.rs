//! Settings of a dynamic run in addition to the model and the operation.

pub mod mesh;
pub mod schedule;

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::{
        boundary::{
            bit::BitSettings, friction_coefficient::CustomFriction,
            top_drive_controller::CustomTopDrive,
        },
        output::probe::Probe,
        settings::{mesh::MeshSettings, schedule::Schedule},
    },
    statics::stiff::StiffSettings,
    wall::{contact::ContactLaw, friction::STRIBECK_SPEED_M_PER_S},
};

/// Default tolerance of the mean weight on bit, as a fraction of the requested weight.
pub const WEIGHT_TOLERANCE: f64 = 0.01;

/// Initial state of the string at time zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Start {
    /// Laid on its contact side with the tension and torque of the soft string, then settled.
    Prepared,
    /// On the hole's axis, untwisted and at rest, as defined by [`CentredStart`].
    Centred,
}

/// Initial tension of a centred start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CentredStart {
    /// Tension in the string at time zero.
    pub tension: StartTension,
    /// Time in which the top is brought to its speed, linearly, s; zero for at once. Raising it
    /// softens the torsional wave that the start sends down.
    pub ramp_s: f64,
}

impl Default for CentredStart {
    /// The static tension, and a ramp of 1 s.
    fn default() -> Self {
        Self { tension: StartTension::Static, ramp_s: 1.0 }
    }
}

/// Tension of a string that starts centred.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum StartTension {
    /// The tension of the string hanging in its hole without friction, with its weight on bit: it
    /// moves along the hole only through friction and the hoist.
    Static,
    /// None: all of its weight comes on at time zero.
    Cold,
}

/// Kind of number that the time loop computes with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Precision {
    /// Sixteen digits.
    #[default]
    Double,
    /// Seven digits, in six tenths of the time: for strings that turn. See [`Precision::serves`].
    Single,
}

/// Combination of the axial and circumferential parts of wall friction.
///
/// Both are compiled into the inner loop, and no other can be given: a friction of the caller's own
/// enters by its coefficients, along the hole by
/// [`Hole::with_friction_profile`](crate::well::Hole), and by speed and force as well by
/// [`FrictionCoefficient`](crate::dynamics::FrictionCoefficient).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum FrictionLaw {
    /// Coulomb's cone: the friction opposes the resultant sliding velocity.
    Vector,
    /// Full friction axially and full friction around, each by the sign of its own velocity: the
    /// law of the article *New Analysis Theory and Method for Drag and Torque Based on Full-Hole
    /// System Dynamics in Highly Deviated Well*, its (9) and (11). Up to √2 too strong in sum.
    Independent,
}

/// Control of the top of the string along the hole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum HoistControl {
    /// The block follows the bit so that the weight on bit holds its target: [`Autodriller`].
    Autodriller,
    /// The block moves at a constant speed, positive downwards, m/s.
    BlockVelocity(f64),
    /// A constant lifting force on the top of the string, N; block excluded. A negative one pushes.
    HookLoad(f64),
}

/// Control law of the autodriller for the block's velocity: `v = v₀ + K (e + ∫e dt/T_i)` within its
/// limits, `e` the target less the measured weight on bit through a filter, `v₀` the rate of
/// penetration at the target.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Autodriller {
    /// `K`: block speed per weight on bit that is missing, m/s/N.
    pub gain_m_per_s_per_N: f64,
    /// `T_i`: time in which the integral adds as much as the gain gives at once, s; infinite
    /// without one.
    pub integral_time_s: f64,
    /// Time constant of the filter on the measured weight on bit, s.
    pub filter_s: f64,
    /// Least speed of the block, m/s, positive downwards; a negative one lets it pull up.
    pub min_speed_m_per_s: f64,
    /// Greatest speed of the block, m/s.
    pub max_speed_m_per_s: f64,
}

impl Default for Autodriller {
    /// 1e-7 m/s/N (10 kN too little add 1 mm/s), no integral, a filter of 1 s, and the block goes
    /// down at any speed but never up.
    fn default() -> Self {
        Self {
            gain_m_per_s_per_N: 1e-7,
            integral_time_s: f64::INFINITY,
            filter_s: 1.0,
            min_speed_m_per_s: 0.0,
            max_speed_m_per_s: f64::INFINITY,
        }
    }
}

/// The hoisting system between the block and the top of the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HoistLine {
    /// Axial stiffness of lines and derrick, N/m.
    pub stiffness_N_per_m: f64,
    /// Damping, N·s/m. Without it a short string rings.
    pub damping_N_s_per_m: f64,
    /// Mass of travelling block and top drive, which hang on the line above the string, kg.
    pub block_mass_kg: f64,
}

/// Control of a top drive's speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum SpeedController {
    /// Proportional and integral, with gains as they are.
    Pi {
        /// Torque per speed that is missing, N·m·s.
        proportional_N_m_s: f64,
        /// Torque per angle that is missing, N·m.
        integral_N_m: f64,
    },
    /// Proportional and integral, tuned to take the energy of torsional waves of one frequency.
    SoftTorque {
        /// Proportional gain over the characteristic impedance of the uppermost pipe.
        impedance_ratio: f64,
        /// Frequency, Hz; `None` takes the lowest torsional one of the string, held at the top and
        /// free at the bit.
        frequency_Hz: Option<f64>,
    },
    /// A stiff one that gives way to the string's torque, so that the drive shows the pipe's
    /// impedance over a band.
    ZTorque {
        /// Impedance that it shows over that of the uppermost pipe.
        impedance_ratio: f64,
        /// Lower edge of the band, Hz; `None` takes a fifth of the string's lowest torsional
        /// frequency.
        frequency_Hz: Option<f64>,
        /// Gain of the stiff speed control, N·m·s: over the inertia, the upper edge of the band,
        /// rad/s.
        proportional_N_m_s: f64,
        /// Its integral gain, N·m.
        integral_N_m: f64,
    },
}

/// Drive at the top of the string.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum TopDriveSettings {
    /// The spin follows its set point, whatever torque that takes.
    Constant,
    /// A drive with inertia.
    Driven {
        /// Moment of inertia of everything that turns with the string at its speed, kg·m².
        inertia_kg_m2: f64,
        /// Controller of its speed.
        controller: SpeedController,
        /// Largest torque that it gives, N·m; `None` sets no limit.
        torque_limit_N_m: Option<f64>,
    },
    /// A drive with inertia under a controller of the caller's own. Its name alone is serialised.
    #[serde(skip_deserializing)]
    Custom(CustomTopDrive),
}

impl TopDriveSettings {
    /// Largest torque that the drive gives, N·m, where it has a limit.
    pub fn torque_limit_N_m(&self) -> Option<f64> {
        match self {
            Self::Constant => None,
            Self::Driven { torque_limit_N_m, .. } => *torque_limit_N_m,
            Self::Custom(custom) => custom.torque_limit_N_m,
        }
    }
}

/// Rayleigh damping of the rod, mesh-independent.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RodDamping {
    /// Proportional to mass, 1/s, on velocities relative to the rigid motion of the string.
    pub mass_per_s: f64,
    /// Proportional to stiffness, s: on the rates of stretch, of twist and of the bend in space, so
    /// that a bent string that spins in place loses nothing.
    pub stiffness_s: f64,
}

/// Settling that continues until the string is steady.
///
/// Every second the last stretch of the run is tested for drift: every scalar of the statistics,
/// and the magnitude of its deviation. The window begins when none of them drifts by more than
/// chance, or by no more than a tenth of a percent of its scale over the time of the window.
/// Criterion and stretches: `docs/src/theory/start.md`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct UntilSteady {
    /// Longest simulated time before the window, s; it counts from the end of the schedule where
    /// there is one. Raising it waits longer for a string that never is steady. A string so slow
    /// that its first stretch ends later has that one.
    pub max_s: f64,
}

impl Default for UntilSteady {
    /// 120 s.
    fn default() -> Self {
        Self { max_s: 120.0 }
    }
}

/// All settings of a dynamic run in addition to the model and the operation.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DynamicsSettings {
    /// Division of the string.
    pub mesh: MeshSettings,
    /// Length of the window that the statistics cover, s.
    pub duration_s: f64,
    /// Simulated time before that window, s; at least, where it is to be steady.
    pub settle_s: f64,
    /// Criteria for a window that begins only when the string is steady; with none it begins after
    /// `settle_s`.
    pub steady: Option<UntilSteady>,
    /// Initial state of the string at time zero.
    pub start: Start,
    /// Initial tension of a centred start.
    pub centred: CentredStart,
    /// Friction law.
    pub friction_law: FrictionLaw,
    /// Sliding speed at which the friction at rest has half decayed to the kinetic one, m/s.
    /// Raising it keeps more of the friction at rest in slow sliding; it matters only where the two
    /// differ.
    pub stribeck_speed_m_per_s: f64,
    /// The coefficient of friction by a law of the caller's own; `None` takes the hole's. Its name
    /// alone is serialised.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_coefficient: Option<CustomFriction>,
    /// Contact law.
    pub contact_law: ContactLaw,
    /// Rayleigh damping.
    pub damping: RodDamping,
    /// Hoist control; `None` selects the control for the operation: the autodriller on bottom, a
    /// constant block velocity otherwise.
    pub hoist_control: Option<HoistControl>,
    /// Tolerance of the mean weight on bit under a [tuned](super::tune_hook_load) lift, as a
    /// fraction of the operation's. A higher one takes fewer runs.
    pub lift_tolerance: f64,
    /// The autodriller, wherever it is in control.
    pub autodriller: Autodriller,
    /// Hoist line.
    pub hoist_line: HoistLine,
    /// Top drive.
    pub top_drive: TopDriveSettings,
    /// Changes of the set points by the driller during the run. Set points of its lines at time
    /// zero replace the operation's from the beginning.
    pub schedule: Schedule,
    /// The bit on the rock.
    pub bit: BitSettings,
    /// Time between samples of the statistics and rows of the time table, s. Contact forces are
    /// averaged over it.
    pub sample_interval_s: f64,
    /// Places whose signals are recorded against time.
    pub probes: Vec<Probe>,
    /// Seed of the microscopic lateral disturbance that breaks the symmetry of the start, and of
    /// the bit's excitation.
    pub seed: u64,
    /// Kind of number that the time loop computes with.
    pub precision: Precision,
}

impl DynamicsSettings {
    /// The same mesh, wall and hold of the bit for the stiff string.
    pub fn stiff_string(&self) -> StiffSettings {
        StiffSettings {
            element_length: self.mesh.element_length,
            refinement: self.mesh.refinement,
            contact_law: self.contact_law,
            bit_lateral_stiffness_N_per_m: self.bit.lateral_stiffness_N_per_m,
            ..StiffSettings::default()
        }
    }

    /// Part of its rotary speed that the top is given at `time_s` by its start.
    pub(super) fn start_ramp(&self, time_s: f64) -> f64 {
        let ramp_s = self.centred.ramp_s;
        if self.start == Start::Centred && time_s < ramp_s { time_s / ramp_s } else { 1.0 }
    }

    /// The longest time from the start to the end of the window, s, but for strings so slow that
    /// their first test for steadiness comes later.
    pub fn longest_s(&self) -> f64 {
        let max_s = match self.steady {
            Some(until) => self.settle_s.max(self.schedule.end_s() + until.max_s),
            None => self.settle_s,
        };
        max_s + self.duration_s
    }

    /// Whether the string starts without any tension.
    pub(super) fn starts_cold(&self) -> bool {
        self.start == Start::Centred && self.centred.tension == StartTension::Cold
    }
}

impl Default for DynamicsSettings {
    /// Elements that choose their length; 60 s after 20 s of settling, steady or not, sampled every
    /// 10 ms; a prepared start, or a centred one with its static tension and a ramp of 1 s; vector
    /// friction that loses half of its rise at rest by 0.1 m/s; Hertz contact with 0.5 s/m; damping
    /// of 0.1 1/s by mass and 10 µs by stiffness; the hoist control that the operation requires on
    /// a line of 1e7 N/m and 1e5 N·s/m that carries no block; a constant rotary speed; no schedule,
    /// no probes; rock of 1e8 N/m and 1e7 N/m across; seed 1; double precision.
    fn default() -> Self {
        Self {
            mesh: MeshSettings::default(),
            duration_s: 60.0,
            settle_s: 20.0,
            steady: None,
            start: Start::Prepared,
            centred: CentredStart::default(),
            friction_law: FrictionLaw::Vector,
            contact_law: ContactLaw::Hertz { dissipation_s_per_m: 0.5 },
            stribeck_speed_m_per_s: STRIBECK_SPEED_M_PER_S,
            friction_coefficient: None,
            damping: RodDamping { mass_per_s: 0.1, stiffness_s: 1e-5 },
            hoist_control: None,
            lift_tolerance: WEIGHT_TOLERANCE,
            autodriller: Autodriller::default(),
            hoist_line: HoistLine {
                stiffness_N_per_m: 1e7,
                damping_N_s_per_m: 1e5,
                block_mass_kg: 0.0,
            },
            top_drive: TopDriveSettings::Constant,
            schedule: Schedule::default(),
            bit: BitSettings::default(),
            sample_interval_s: 0.01,
            probes: Vec::new(),
            seed: 1,
            precision: Precision::Double,
        }
    }
}
