//! Stresses at the surfaces of a body, on both sides of its bend.

use wholestring::string::Component;

/// A surface of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    /// The surface of the bore.
    Inner,
    /// The outer surface.
    Outer,
}

impl Surface {
    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Inner => "inner",
            Self::Outer => "outer",
        }
    }
}

/// A side of a bent body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BendSide {
    /// Outside of the bend, which it pulls.
    Tension,
    /// Inside of the bend, which it presses.
    Compression,
}

impl BendSide {
    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tension => "tension",
            Self::Compression => "compression",
        }
    }
}

/// Loads of a body at a place.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyLoads {
    /// Effective tension, N.
    pub effective_tension_N: f64,
    /// Bending moment, N·m.
    pub bending_N_m: f64,
    /// Torque, N·m.
    pub torque_N_m: f64,
    /// Pressure inside, Pa.
    pub inside_Pa: f64,
    /// Pressure outside, Pa.
    pub outside_Pa: f64,
}

/// The stresses at a point of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceStress {
    /// Which surface.
    pub surface: Surface,
    /// Which side of the bend.
    pub side: BendSide,
    /// Axial stress, Pa: of the real force in the metal and of bending.
    pub axial_Pa: f64,
    /// Radial stress, Pa (Lamé).
    pub radial_Pa: f64,
    /// Hoop stress, Pa (Lamé).
    pub hoop_Pa: f64,
    /// Shear stress of the torque, Pa.
    pub shear_Pa: f64,
    /// Von Mises stress, Pa.
    pub von_mises_Pa: f64,
}

/// Computes the stresses at both surfaces and on both sides of the bend of a component's body, with
/// `A_i` and `A_o` the areas within the inner and the outer diameter and `A` the metal's:
///
#[doc = include_str!("../../equations/surface-stresses.html")]
///
/// The largest von Mises stress of them equals the single formula of
/// [`BodySection::von_mises_Pa`](wholestring::string::BodySection::von_mises_Pa).
pub fn surface_stresses(body: &Component, loads: &BodyLoads) -> [SurfaceStress; 4] {
    let BodyLoads { effective_tension_N, bending_N_m, torque_N_m, inside_Pa, outside_Pa } = *loads;
    let true_tension_N = body.true_tension_N(effective_tension_N, outside_Pa, inside_Pa, 0.0);
    let pulled_Pa = true_tension_N / body.area_m2();
    let (outer_m, inner_m) = (0.5 * body.od_m, 0.5 * body.id_m);
    let (outer2, inner2) = (outer_m * outer_m, inner_m * inner_m);
    let wall2 = outer2 - inner2;
    let mean_Pa = (inside_Pa * inner2 - outside_Pa * outer2) / wall2;
    let at = |surface, side| {
        let (radius_m, pressure_Pa) = match surface {
            Surface::Inner => (inner_m, inside_Pa),
            Surface::Outer => (outer_m, outside_Pa),
        };
        let bent_Pa = bending_N_m * radius_m / body.second_moment_m4();
        let axial_Pa = match side {
            BendSide::Tension => pulled_Pa + bent_Pa,
            BendSide::Compression => pulled_Pa - bent_Pa,
        };
        // The axis of a solid body is not a surface: hoop and radial stress are the pressure
        // outside.
        let radial_Pa = if radius_m > 0.0 { -pressure_Pa } else { -outside_Pa };
        let hoop_Pa = 2.0 * mean_Pa - radial_Pa;
        let shear_Pa = torque_N_m * radius_m / body.polar_moment_m4();
        let apart = (axial_Pa - radial_Pa).powi(2)
            + (radial_Pa - hoop_Pa).powi(2)
            + (hoop_Pa - axial_Pa).powi(2);
        let von_mises_Pa = (0.5 * apart + 3.0 * shear_Pa * shear_Pa).sqrt();
        SurfaceStress { surface, side, axial_Pa, radial_Pa, hoop_Pa, shear_Pa, von_mises_Pa }
    };
    [
        at(Surface::Inner, BendSide::Tension),
        at(Surface::Inner, BendSide::Compression),
        at(Surface::Outer, BendSide::Tension),
        at(Surface::Outer, BendSide::Compression),
    ]
}

/// The most highly stressed point of a body: among equals the inner one, on the side in tension.
pub fn worst_stress(body: &Component, loads: &BodyLoads) -> SurfaceStress {
    let [first, rest @ ..] = surface_stresses(body, loads);
    rest.into_iter().fold(
        first,
        |worst, next| {
            if next.von_mises_Pa > worst.von_mises_Pa { next } else { worst }
        },
    )
}
