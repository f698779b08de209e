//! What a page reports of linear vibration about the static equilibrium of the string, and its
//! pictures.

mod figures;
mod page;

pub use figures::{MODES_PICTURES, modes_plots};
pub use page::modes_html;

use crate::{PageHead, StabilityPicture};

/// Small motions as their page shows them. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// Under the name of the case.
    pub head: PageHead,
    /// The operation whose string at rest it is.
    pub operation: String,
    /// Its rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Whether the string at rest is stable.
    pub stable: bool,
    /// What turns with the string and shakes it, in words.
    pub forcing: String,
    /// Natural modes: lateral, axial, torsional.
    pub modes: Vec<ModeRow>,
    /// By rising rotary speed.
    pub critical: Vec<CriticalRow>,
    /// Shapes of the modes.
    pub shapes: Vec<ModeShape>,
    /// Natural frequencies against rotary speed.
    pub branches: Vec<ModeBranch>,
    /// The answer to what shakes it.
    pub answer: AnswerCurve,
    /// What the map of torsional stability says, or why there is none, in sentences.
    pub stability: Vec<String>,
    /// The map.
    pub stability_map: Option<StabilityPicture>,
    /// What is missing of all this; nothing where all is there.
    pub message: Option<String>,
}

/// A natural mode.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeRow {
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Natural frequency, Hz.
    pub frequency_Hz: f64,
    /// Which way it goes round, of lateral modes.
    pub whirl: Option<String>,
    /// Parts of its kinetic energy: lateral, axial, torsional.
    pub energy: [f64; 3],
    /// Measured depth, m, and component where it strains the string most.
    pub most_strained: (f64, String),
}

/// A rotary speed at which an order of the rotation meets a natural frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct CriticalRow {
    /// How often something pushes in a turn.
    pub order: f64,
    /// Rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Natural frequency there, Hz.
    pub frequency_Hz: f64,
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Measured depth, m, and component where the mode strains the string most.
    pub most_strained: (f64, String),
}

/// The shape of a mode along the string, from the top down.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeShape {
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Measured depths, m.
    pub md_m: Vec<f64>,
    /// Displacement towards the high side and to the right of it, and both a quarter of a period
    /// later, m.
    pub across_m: [Vec<f64>; 4],
    /// Displacement along the hole, m.
    pub along_m: Vec<f64>,
    /// Turn about the axis, rad.
    pub turn_rad: Vec<f64>,
}

/// A natural frequency against rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeBranch {
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Which way it goes round; empty of families that are not lateral.
    pub whirl: String,
    /// Rotary speeds, rad/s.
    pub rotary_rad_per_s: Vec<f64>,
    /// Natural frequency at each, Hz.
    pub frequency_Hz: Vec<f64>,
}

/// The answer to what shakes the string, against rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub struct AnswerCurve {
    /// Rotary speeds, rad/s.
    pub rotary_rad_per_s: Vec<f64>,
    /// Farthest that a node goes, m.
    pub amplitude_m: Vec<f64>,
    /// Largest bending stress that it adds, Pa.
    pub bending_stress_Pa: Vec<f64>,
}
