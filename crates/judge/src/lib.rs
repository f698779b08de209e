//! Verdicts on a solved operation: exceeded limits, causes of a stop, and the reliability of a
//! result.
//!
//! A [`Judge`] compares the result of a solver with the strength of the string, the ratings of the
//! rig and the critical loads at each depth. Each comparison is a [`Check`]: kind, severity, place,
//! value, limit, factor, required factor and one sentence in the user's units. A limit that is met
//! and a state that forbids the operation have the same type, so that a run, a plan, a reach and
//! every front show one verdict in one wording. A limit that could not be compared is an
//! [`Unchecked`] with the number that is missing.
//!
//! Theory and sources: `docs/src/findings.md`, `docs/src/theory/strength.md`.
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod along;
mod bit_test;
mod buckling;
mod check;
mod checks;
mod depth_limit;
mod descent;
mod drift;
mod hydraulics;
mod interval;
mod judge;
mod kind;
mod live;
mod loads;
mod motion;
mod numerics;
mod overall;
pub mod quantities;
mod reading_check;
mod recent;
mod rig;
mod root;
mod sentence;
mod settings;
mod steadiness;
pub mod strength;
mod strengths;
mod surface;
mod unchecked;
mod unsolved;
mod weight_on_bit;
mod window;
mod wording;

pub use bit_test::{TriedPoint, bit_test_checks};
pub use check::{Check, Severity, Verdict};
pub use checks::Checks;
pub use depth_limit::DepthLimit;
pub use descent::Descent;
pub use judge::{Disturbed, Judge, Reached};
pub use kind::CheckKind;
pub use motion::top_drive_severity;
pub use overall::Overall;
pub use reading_check::ReadingCheck;
pub use recent::Recent;
pub use root::root;
pub use sentence::shorter_element;
pub use settings::{DesignFactors, LimitSettings};
pub use strengths::torque_capacity_N_m;
pub use surface::{SurfaceLimit, surface_limits};
pub use unchecked::{Missing, Unchecked};
pub use unsolved::NoAnswer;
pub use wording::{Quantity, Rounding, Wording};
