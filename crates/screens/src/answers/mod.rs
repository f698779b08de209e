//! Results of a case that are fast enough while it is edited: soft and stiff string, limits,
//! broomstick, and static BHA analysis.

mod answer;
mod asked;
mod assembly;
mod broomstick;
mod column;
mod limits;
mod set_points;
mod solved;
mod tracks;
mod well;

pub use answer::Answer;
pub use asked::{Asked, AskedOfModels, AskedOfOperation};
pub use assembly::{AssemblyView, Axis, Part, Touch};
pub use broomstick::{Broomstick, BroomstickCurve, FrictionOfLevel};
pub use column::Column;
pub use limits::{Limit, OperationLimits, Unchecked};
pub use set_points::{SectionFriction, SetPoint, SetPoints};
pub use solved::{Solved, SolvedScalars, SolvedStatus};
pub use tracks::{DRAWN, Track, TrackColumns};
pub use well::{Component, PathView, Section, WellView};
