//! `[bit]`.

mod around;
mod build;
mod excitation;
mod face;
mod file;
mod given;
mod kind;
mod law;
mod misfit;
mod motor;
mod points;
mod table;

pub(crate) use self::{around::Around, given::Given, law::Law, misfit::misfit, table::BitTable};
