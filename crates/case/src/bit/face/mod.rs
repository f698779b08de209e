//! `[bit.face]`.

mod misuse;
mod record;
mod shape;
mod table;

pub(crate) use self::{record::settings, table::FaceTable};
