//! A sweep: a case with all combinations of some values.

mod batch;
mod cases;
mod checked;
mod checked_points;
mod ending;
mod one_case;
mod pace;
pub(crate) mod page;
mod points;
mod prepared;
mod read;
mod remote_case;
mod request;
mod set;
mod table;

pub(crate) use self::{
    batch::Batch,
    checked_points::CheckedPoints,
    ending::Ending,
    points::{Point, points},
    set::Set,
};
pub use self::{
    ending::Ended,
    prepared::{PreparedSweep, run},
    read::read,
    remote_case::RemoteCase,
    request::Request,
    table::{FILE, SCALARS},
};
