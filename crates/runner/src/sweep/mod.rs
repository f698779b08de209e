//! A sweep: a case with all combinations of some values.

mod apart;
mod batch;
mod cases;
mod checked;
mod checked_points;
mod ending;
mod in_hand;
mod one_case;
mod pace;
pub(crate) mod page;
mod points;
mod read;
mod request;
mod set;
mod table;

pub use self::{
    apart::Apart,
    ending::Ended,
    in_hand::InHand,
    read::read,
    request::{Request, run},
    table::{FILE, SCALARS},
};
pub(crate) use self::{
    batch::Batch,
    checked_points::CheckedPoints,
    ending::Ending,
    points::{Point, points},
    set::Set,
};
