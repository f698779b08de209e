//! `[bit.face]`.

mod misuse;
mod shape;
mod table;

pub(crate) use self::table::FaceTable;
