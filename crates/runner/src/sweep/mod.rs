//! A sweep: a case with all combinations of some values.

mod batch;
mod checked;
mod checked_points;
pub(crate) mod page;
mod points;
mod request;
mod set;
mod table;

pub(crate) use self::{
    batch::{Batch, Ending},
    checked_points::CheckedPoints,
    points::{Point, points},
    set::Set,
};
pub use self::{
    request::{Request, run},
    table::{FILE, SCALARS},
};
