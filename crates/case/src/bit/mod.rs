//! `[bit]`.

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

pub(crate) use self::{build::Around, given::Given, law::Law, misfit::misfit, table::BitTable};
