//! Contents of the page of linear vibration about the static equilibrium of the string, and its
//! pictures.

mod figures;
mod page;

pub use figures::{MODES_PICTURES, modes_plots};
pub use page::modes_html;

use wholestring::operation::OperationKind;

use crate::{PageHead, StabilityPicture};

/// Linear vibration as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The operation whose static equilibrium is analysed.
    pub operation: OperationKind,
    /// Its rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Whether the static equilibrium is stable.
    pub stable: bool,
    /// Parts that turn with the string and excite it, in words, in SI, metric and field units.
    pub forcing: [String; 3],
    /// Natural modes: lateral, axial, torsional.
    pub modes: Vec<ModeRow>,
    /// In order of increasing rotary speed.
    pub critical: Vec<CriticalRow>,
    /// Shapes of the modes.
    pub shapes: Vec<ModeShape>,
    /// Natural frequencies against rotary speed.
    pub branches: Vec<ModeBranch>,
    /// Response to the excitation.
    pub answer: AnswerCurve,
    /// Results of the map of torsional stability, the verdict first, or the reason why there is
    /// none, in sentences, in the same units.
    pub stability: [Vec<String>; 3],
    /// The map.
    pub stability_map: Option<StabilityPicture>,
    /// Missing parts; `None` where nothing is missing.
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
    /// Direction of its whirl, for lateral modes.
    pub whirl: Option<String>,
    /// Parts of its kinetic energy: lateral, axial, torsional.
    pub energy: [f64; 3],
    /// Measured depth, m, and component of its largest strain.
    pub most_strained: (f64, String),
}

/// A rotary speed at which an order of the rotation coincides with a natural frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct CriticalRow {
    /// Number of excitations per turn.
    pub order: f64,
    /// Rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Natural frequency at that speed, Hz.
    pub frequency_Hz: f64,
    /// `lateral`, `axial` or `torsional`.
    pub family: String,
    /// Number within the family, from 1.
    pub number: usize,
    /// Measured depth, m, and component of the mode's largest strain.
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
    /// Axial displacement, m.
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
    /// Direction of its whirl; empty for families that are not lateral.
    pub whirl: String,
    /// Rotary speeds, rad/s.
    pub rotary_rad_per_s: Vec<f64>,
    /// Natural frequency at each, Hz.
    pub frequency_Hz: Vec<f64>,
}

/// Response of the string to its excitation, against rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub struct AnswerCurve {
    /// Rotary speeds, rad/s.
    pub rotary_rad_per_s: Vec<f64>,
    /// Largest displacement of a node, m.
    pub amplitude_m: Vec<f64>,
    /// Largest bending stress that it adds, Pa.
    pub bending_stress_Pa: Vec<f64>,
}
