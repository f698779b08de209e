//! Reach of the well in its last direction, and the limit that stops it.
//!
//! The bit goes deeper along the straight line that the path ends with; the string's topmost
//! component grows with it. At each depth the soft string of an operation is compared with the
//! [`DepthLimit`](wholestring_judge::DepthLimit)s: each has a margin that is one or less and zero
//! where the limit is reached. The first
//! zero of each is searched on a grid of depths, and where components pass curved stretches, and
//! then found by Brent's method. Limits of string and rig are those of the judge.
//!
//! A limit need not exist: down to the critical inclination `atan(1/μ)` a sliding string gains more
//! by its weight than it loses by its friction, without a limit. Theory:
//! `docs/src/theory/reach.md`.

mod margin;
mod search;
mod settings;

pub use margin::{LEAST_MARGIN, Margin, Margins, margins};
pub use search::{Curve, End, OperationReach, first_stop, reach, reach_unless};
pub use settings::{ReachError, ReachSettings};
