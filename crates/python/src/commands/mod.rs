//! The commands that write a folder, each as the runner executes it, and the broomstick.

pub(crate) mod bha;
pub(crate) mod bit_test;
pub(crate) mod broomstick;
pub(crate) mod calibrate;
mod carry_out;
mod common;
pub(crate) mod modes;
pub(crate) mod option;
pub(crate) mod plan;
pub(crate) mod reach;
pub(crate) mod study;
