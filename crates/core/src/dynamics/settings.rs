//! What a dynamic run needs to know beside the model and the operation.

use serde::{Deserialize, Serialize};

use super::bit::BitSettings;
use crate::wall::friction::STRIBECK_SPEED_M_PER_S;

/// How the string lies at time zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// Laid on its contact side with the tension and torque of the soft string, then settled.
    Prepared,
    /// On the hole's axis with its static, frictionless tension, untwisted and at rest.
    Centred,
}

/// How wall friction combines its axial and circumferential parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrictionLaw {
    /// Coulomb's cone: the friction opposes the resultant sliding velocity.
    Vector,
    /// Full friction axially and full friction around, each by the sign of its own velocity: the
    /// law of the article *New Analysis Theory and Method for Drag and Torque Based on Full-Hole
    /// System Dynamics in Highly Deviated Well*, its (9) and (11). Up to √2 too strong in sum.
    Independent,
}

/// How the wall answers penetration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLaw {
    /// `N = K_h α^1.5 (1 + d α')`, `K_h` from the elastic constants and radii of pipe and hole.
    Hertz {
        /// Hunt-Crossley dissipation `d`, s/m. Raising it makes impacts rebound less.
        dissipation_s_per_m: f64,
    },
    /// `N = k α + c α'`, never in tension.
    Linear {
        /// Stiffness `k` of one contact (a node), N/m.
        stiffness_N_per_m: f64,
        /// `c` as a fraction of the critical damping of the node on `k`.
        damping_ratio: f64,
    },
}

/// How the top of the string is moved along the hole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum HoistControl {
    /// The block follows the bit so that the weight on bit holds the operation's.
    Autodriller {
        /// Block speed per weight on bit that is missing, m/s/N.
        gain_m_per_s_per_N: f64,
        /// Time constant of the filter on the measured weight on bit, s.
        filter_s: f64,
    },
    /// The block moves at a constant speed, positive downwards, m/s.
    BlockVelocity(f64),
    /// A constant lifting force on the top of the string, N; block excluded.
    HookLoad(f64),
}

impl HoistControl {
    /// The autodriller with its default gain and filter, 1e-7 m/s/N and 1 s: 10 kN too little add
    /// 1 mm/s.
    pub const AUTODRILLER: Self = Self::Autodriller {
        gain_m_per_s_per_N: 1e-7,
        filter_s: 1.0,
    };
}

/// The hoisting system between the block and the top of the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HoistLine {
    /// Axial stiffness of lines and derrick, N/m.
    pub stiffness_N_per_m: f64,
    /// Damping, N·s/m. Without it a short string rings.
    pub damping_N_s_per_m: f64,
}

/// Rayleigh damping of the rod, mesh-independent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodDamping {
    /// Proportional to mass, 1/s, on velocities relative to the rigid motion of the string.
    pub mass_per_s: f64,
    /// Proportional to stiffness, s: on the rates of stretch, of twist and of the bend in space, so that
    /// a bent string that spins in place loses nothing.
    pub stiffness_s: f64,
}

/// Everything that a dynamic run needs beside the model and the operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DynamicsSettings {
    /// Length of the elements, m. A node stands on tool joints and stabilisers; between them the
    /// elements are as near to this as whole numbers allow, rather longer than shorter.
    pub element_length_m: f64,
    /// Length of the window that the statistics cover, s.
    pub duration_s: f64,
    /// Simulated time before that window, s.
    pub settle_s: f64,
    /// How the string lies at time zero.
    pub start: Start,
    /// Friction law.
    pub friction_law: FrictionLaw,
    /// Sliding speed at which the friction at rest has half decayed to the kinetic one, m/s. Raising it
    /// keeps more of the friction at rest in slow sliding; it matters only where the two differ.
    pub stribeck_speed_m_per_s: f64,
    /// Contact law.
    pub contact_law: ContactLaw,
    /// Rayleigh damping.
    pub damping: RodDamping,
    /// Hoist control; `None` takes what the operation asks for: the autodriller on bottom, a
    /// constant block velocity otherwise.
    pub hoist_control: Option<HoistControl>,
    /// Hoist line.
    pub hoist_line: HoistLine,
    /// The bit on the rock.
    pub bit: BitSettings,
    /// Time between samples of the statistics and rows of the time table, s. Contact forces are
    /// averaged over it.
    pub sample_interval_s: f64,
    /// Seed of the microscopic lateral disturbance that breaks the symmetry of the start, and of the bit's
    /// excitation.
    pub seed: u64,
}

impl Default for DynamicsSettings {
    /// Elements of 3.2 m; 60 s after 20 s of settling, sampled every 10 ms; a prepared start; vector
    /// friction that loses half of its rise at rest by 0.1 m/s; Hertz contact with 0.5 s/m; damping of 0.1 1/s by mass and 10 µs by stiffness; the hoist control
    /// that the operation asks for on a line of 1e7 N/m and 1e5 N·s/m; rock of 1e8 N/m and 1e7 N/m across;
    /// seed 1.
    fn default() -> Self {
        Self {
            element_length_m: 3.2,
            duration_s: 60.0,
            settle_s: 20.0,
            start: Start::Prepared,
            friction_law: FrictionLaw::Vector,
            stribeck_speed_m_per_s: STRIBECK_SPEED_M_PER_S,
            contact_law: ContactLaw::Hertz {
                dissipation_s_per_m: 0.5,
            },
            damping: RodDamping {
                mass_per_s: 0.1,
                stiffness_s: 1e-5,
            },
            hoist_control: None,
            hoist_line: HoistLine {
                stiffness_N_per_m: 1e7,
                damping_N_s_per_m: 1e5,
            },
            bit: BitSettings::default(),
            sample_interval_s: 0.01,
            seed: 1,
        }
    }
}
