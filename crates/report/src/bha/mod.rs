//! Contents of the page of a static BHA analysis, and its pictures.

mod bending;
mod figures;
mod shared;
mod sweeps;
mod views;

pub use figures::bha_plots;

use crate::{PageHead, PageTable};

/// A static BHA analysis as its page shows it. Numbers are SI; nodes are ordered from the bit up;
/// each pair is the part towards the high side and that to the right of it as one looks down the
/// hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Bha {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// Tendency of the inclination with this assembly, in sentences, in SI, metric and field units.
    pub tendency: [Vec<String>; 3],
    /// Warnings.
    pub message: Option<String>,
    /// Components, from the bit up.
    pub parts: Vec<BhaPart>,
    /// Upper end of the assembly from the bit, m.
    pub length_m: f64,
    /// Distances of the nodes from the bit, m.
    pub from_bit_m: Vec<f64>,
    /// Radius of the hole at the nodes, m.
    pub hole_radius_m: Vec<f64>,
    /// Offset of the string's axis from the hole's, m.
    pub offset_m: [Vec<f64>; 2],
    /// Bending moment, N·m.
    pub moment_N_m: [Vec<f64>; 2],
    /// Bending stress, Pa.
    pub bending_stress_Pa: Vec<f64>,
    /// Von Mises stress, Pa.
    pub von_mises_stress_Pa: Vec<f64>,
    /// Contacts with the wall.
    pub contacts: Vec<BhaContact>,
    /// Distances of the survey sensors from the bit, m.
    pub sensors_m: Vec<f64>,
    /// Varied quantities.
    pub sweeps: Vec<BhaSweep>,
    /// Tables of results and inputs.
    pub page_tables: Vec<PageTable>,
}

/// A component.
#[derive(Debug, Clone, PartialEq)]
pub struct BhaPart {
    /// Its name.
    pub name: String,
    /// Its lower end, from the bit, m.
    pub from_bit_m: f64,
    /// Its upper end, from the bit, m.
    pub to_bit_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Diameter over its blades, m, and their length, m.
    pub blades_m: Option<[f64; 2]>,
    /// Whether it has tool joints.
    pub is_jointed: bool,
    /// Distance of its bend from the bit, m.
    pub bend_m: Option<f64>,
}

/// A contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BhaContact {
    /// Its middle, from the bit, m.
    pub at_m: f64,
    /// Force on the wall, N.
    pub force_N: [f64; 2],
}

/// The bit against a varied quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct BhaSweep {
    /// Name of its picture.
    pub name: String,
    /// The varied quantity, as shown to users.
    pub title: String,
    /// Its dimension.
    pub dimension: String,
    /// The bit at each value.
    pub points: Vec<BhaSweepPoint>,
    /// The value that the case has.
    pub now: Option<f64>,
    /// Values at which the side force towards the high side is zero.
    pub zeros: Vec<f64>,
}

/// The bit at a value of a varied quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BhaSweepPoint {
    /// The value.
    pub value: f64,
    /// Side force of the bit, N.
    pub side_force_N: [f64; 2],
    /// Tilt of the bit, rad.
    pub tilt_rad: [f64; 2],
}

#[cfg(test)]
mod tests;
