//! Verification of the rod's elements, of its mesh and of the wall against closed forms, published
//! numbers and independent solutions.

#[path = "../common/mod.rs"]
mod common;

mod article;
mod bent;
mod bore;
mod contact;
mod element;
mod friction;
mod mesh;
mod plane;
mod random;
mod shear;
mod space;
mod stability;
mod statics;
mod tangent;
