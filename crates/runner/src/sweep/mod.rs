//! A sweep: a case with all combinations of some values.

mod batch;
mod cases;
mod checked;
mod checked_points;
mod ending;
mod in_memory;
mod indicators;
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
    in_memory::{Many, operations_table, solve_many},
    prepared::{PreparedSweep, run},
    read::read,
    remote_case::{RemoteCase, RemoteOptions},
    request::Request,
    table::{FILE, SCALARS},
};
