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

pub(crate) use self::{given::Given, law::Law, misfit::misfit};
pub(crate) use build::BitTable;
pub(crate) use given::Around;
