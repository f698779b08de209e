//! Files of other programs that are dropped on the page, and the case that they make.

mod question;
mod reading;
mod upload;

pub(crate) use reading::{Reading, Said, read};
pub(crate) use upload::Uploads;
