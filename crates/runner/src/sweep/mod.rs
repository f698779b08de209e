//! A sweep: a case with all combinations of some values.

mod batch;
mod checked;
pub(crate) mod page;
mod points;
mod request;
mod set;
mod sound;
mod table;

pub(crate) use self::{
    batch::{Batch, Ending},
    points::{Point, points},
    set::Set,
    sound::Sound,
};
pub use self::{
    request::{Request, run},
    table::{FILE, SCALARS},
};
