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

pub(crate) use self::{
    build::Around, face::settings as face_settings, given::Given, law::Law, misfit::misfit,
    table::BitTable,
};
