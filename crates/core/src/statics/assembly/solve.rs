//! From a model and an operation to static BHA analysis.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::{
    axis::{self, AssemblyNode, Largest},
    contact::{self, Contact},
    extent::{self, AssemblySettings, Reach},
    sag::{Sag, sag},
};
use crate::{
    model::Model,
    operation::Operation,
    statics::{
        soft::{self, SoftProfile, SoftSettings},
        stiff::{self, Convergence, StiffError, StiffProfile},
    },
    well::{Hole, HoleSection, Interpolation, Path, PathError, Station, TieIn, Well},
};

/// Static BHA analysis. Each pair is the part towards the high side and that to the right of it as
/// one looks down the hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    /// Side force of the bit on the rock, N: towards the high side it builds, to the right it turns
    /// right.
    pub bit_side_force_N: [f64; 2],
    /// Tilt of the bit against the hole's axis, rad.
    pub bit_tilt_rad: [f64; 2],
    /// Contacts, from the bit up; the bit first.
    pub contacts: Vec<Contact>,
    /// Sag at the survey sensors.
    pub sag: Vec<Sag>,
    /// Largest bending moment of the assembly, N·m.
    pub largest_moment_N_m: Largest,
    /// Largest bending stress of the assembly, Pa.
    pub largest_bending_stress_Pa: Largest,
    /// Largest von Mises stress of the assembly, Pa.
    pub largest_von_mises_Pa: Largest,
    /// Nodes of all that was solved, from the bit up.
    pub nodes: Vec<AssemblyNode>,
    /// Upper end of the assembly from the bit, m: where ordinary pipe begins.
    pub length_m: f64,
    /// Convergence of the equilibrium.
    pub convergence: Convergence,
    /// Changes with elements of half the length; none where that was not computed.
    pub errors: Option<AssemblyErrors>,
}

/// Changes with elements of half the length: an estimate of the remaining error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct AssemblyErrors {
    /// Of the side force, N.
    pub side_force_N: f64,
    /// Of the bit's tilt, rad.
    pub tilt_rad: f64,
    /// Of the largest bending moment, N·m.
    pub largest_moment_N_m: f64,
    /// Of the largest von Mises stress, Pa.
    pub largest_von_mises_Pa: f64,
    /// Of the first sensor's inclination, rad; zero without a sensor.
    pub sag_rad: f64,
}

/// The assembly of a string at rest in one operation: in elements that are shorter where contacts
/// begin or end, and once more with every element halved, which gives an estimate of the error.
///
/// # Errors
/// Those of the [stiff string](stiff::solve).
pub fn solve(
    model: &Model,
    operation: &Operation,
    settings: &AssemblySettings,
) -> Result<Assembly, StiffError> {
    let soft = soft::solve(model, operation, &SoftSettings::default())?;
    let first = once(model, operation, settings, &soft, &[], 1)?;
    let ends_m = contact::ends_m(&model.string, &first.nodes, first.length_m);
    let coarse = once(model, operation, settings, &soft, &ends_m, 1)?;
    let fine = once(model, operation, settings, &soft, &ends_m, 2)?;
    let errors = AssemblyErrors::between(&coarse, &fine);
    Ok(Assembly { errors: Some(errors), ..fine })
}

/// The same without shorter elements and without the second solution: for one of many points.
///
/// # Errors
/// Those of the [stiff string](stiff::solve).
pub fn solve_once(
    model: &Model,
    operation: &Operation,
    settings: &AssemblySettings,
) -> Result<Assembly, StiffError> {
    let soft = soft::solve(model, operation, &SoftSettings::default())?;
    once(model, operation, settings, &soft, &[], 1)
}

fn once(
    model: &Model,
    operation: &Operation,
    settings: &AssemblySettings,
    soft: &SoftProfile,
    ends_m: &[f64],
    refinement: u32,
) -> Result<Assembly, StiffError> {
    let mesh = extent::mesh(model, operation, settings, ends_m, refinement)?;
    let place =
        |node: usize| (mesh.nodes[node].from_bit_m, mesh.touching_component(&model.string, node));
    let places: Vec<(f64, usize)> = (0..mesh.nodes.len()).map(place).collect();
    let found = stiff::solve_on(model, operation, &settings.stiff, soft, mesh)?;
    Ok(Assembly::new(model, settings, &found, &places))
}

impl Assembly {
    fn new(
        model: &Model,
        settings: &AssemblySettings,
        found: &StiffProfile,
        places: &[(f64, usize)],
    ) -> Self {
        let reach = Reach::of(model, settings);
        let nodes = axis::nodes(model, found, places);
        let within = nodes.partition_point(|node| node.from_bit_m <= reach.assembly_m);
        let assembly = &nodes[..within];
        Self {
            bit_side_force_N: found.bit_side_force_N,
            bit_tilt_rad: found.bit_tilt_rad,
            contacts: contact::contacts(&model.string, &nodes),
            sag: sag(model, &nodes),
            largest_moment_N_m: Largest::of(assembly, AssemblyNode::bending_moment_N_m),
            largest_bending_stress_Pa: Largest::of(assembly, |node| node.bending_stress_Pa),
            largest_von_mises_Pa: Largest::of(assembly, |node| node.von_mises_stress_Pa),
            length_m: reach.assembly_m,
            convergence: found.convergence,
            errors: None,
            nodes,
        }
    }
}

impl AssemblyErrors {
    fn between(a: &Assembly, b: &Assembly) -> Self {
        let apart = |value: fn(&Assembly) -> [f64; 2]| {
            let ([x, y], [u, v]) = (value(a), value(b));
            libm::hypot(x - u, y - v)
        };
        let sag = |assembly: &Assembly| assembly.sag.first().map_or(0.0, |sag| sag.inclination_rad);
        Self {
            side_force_N: apart(|assembly| assembly.bit_side_force_N),
            tilt_rad: apart(|assembly| assembly.bit_tilt_rad),
            largest_moment_N_m: (a.largest_moment_N_m.value - b.largest_moment_N_m.value).abs(),
            largest_von_mises_Pa: (a.largest_von_mises_Pa.value - b.largest_von_mises_Pa.value)
                .abs(),
            sag_rad: (sag(a) - sag(b)).abs(),
        }
    }
}

// The same assembly in a hole of another inclination.

/// Part of the hole that may build, and the shortest stretch that does, m.
const MOST: f64 = 0.9;
const LEAST_M: f64 = 1e-3;

/// The same string in a hole that has one inclination at the bit, rad, and builds at a constant
/// rate to there over a length, rad/m and m, or from the vertical; straight above. It is as wide
/// and as slippery as the hole at the bit is, and goes the same way.
///
/// # Errors
/// Numbers that are not finite, or an inclination outside 0 to π.
pub fn in_straight_hole(
    model: &Model,
    operation: &Operation,
    inclination_rad: f64,
    (build_rad_per_m, over_m): (f64, f64),
) -> Result<Model, PathError> {
    let bit_m = operation.bit_depth_m;
    let azimuth_rad = model.well.path.at(bit_m).azimuth_rad();
    // No farther up than where the hole is vertical.
    let vertical_rad = if build_rad_per_m > 0.0 { 0.0 } else { PI };
    let room_m = match build_rad_per_m {
        0.0 => f64::INFINITY,
        rate => (inclination_rad - vertical_rad) / rate,
    };
    let over_m = over_m.min(room_m).min(MOST * bit_m);
    let above_rad = (inclination_rad - build_rad_per_m * over_m).clamp(0.0, PI);
    let station = |md_m: f64, inclination_rad: f64| Station { md_m, inclination_rad, azimuth_rad };
    let mut stations = vec![station(0.0, above_rad)];
    if over_m > LEAST_M {
        stations.push(station(bit_m - over_m, above_rad));
    }
    stations.push(station(bit_m, inclination_rad));
    let path = Path::new(&stations, Interpolation::MinimumCurvature, TieIn::default())?;
    let at_bit = *model.well.hole.at(bit_m);
    let section = HoleSection { from_md_m: 0.0, to_md_m: bit_m, ..at_bit };
    // Already checked with the case.
    let hole = Hole::new(vec![section]).unwrap_or_else(|_| model.well.hole.clone());
    Ok(Model { well: Well { path, hole }, ..model.clone() })
}
