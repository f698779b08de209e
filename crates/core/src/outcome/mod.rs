//! Results of the methods: scalars, profiles along string and hole, series against time. Each
//! quantity is declared once, next to the data, with its name, unit, meaning and source.

mod along_hole;
mod along_string;
mod column;
mod history;
mod method;
mod profile;
mod quantity;
mod quantity_kind;
pub mod samples;
mod scalars;
mod signal;
mod signals;
mod solution;
mod time_series;

pub use along_hole::{
    CONTACT_MAP, ContactMap, HOLE_STEP_M, HOLE_WEAR, HoleWear, WELL_PATH, WellPath,
};
pub(crate) use along_hole::{hole_depths_m, hole_steps, spread};
pub use along_string::{Buckling, ContactClass, PROFILE, Profile};
pub use column::{Column, DriftScale, Values, WindowStatistics};
pub(crate) use column::{Rows, columns};
pub use history::{EarlierRows, History, ScalarHistory};
pub(crate) use method::IN_TIME;
pub use method::{Cost, Method, ModelKind};
pub(crate) use profile::{SLACK, neutral_point_among, neutral_rows};
pub use profile::{cutoff_depth_m, cutoff_in_build_m, neutral_point_m};
pub use quantity::Quantity;
pub use quantity_kind::QuantityKind;
pub use samples::Samples;
pub use scalars::{SCALARS, Scalar, Scalars, scalars_by_row};
pub use signal::Signal;
pub(crate) use signals::signals;
pub use solution::{InTime, Solution};
pub use time_series::{TIME_SERIES, TimeSeries};
pub(crate) use time_series::{VARYING, varying_place};
