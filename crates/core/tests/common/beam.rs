//! A pipe across a wide horizontal hole as a beam, supported only at its ends.

use wholestring::{
    ends::{BitEnd, Ends, TopEnd},
    prelude::*,
    string::LateralForce,
};

use super::{arcs, mud, open_hole, pipe};

/// Length of the beam, m, its weight, N/m, and the diameter of its hole, m.
pub const LENGTH_M: f64 = 12.0;
pub const WEIGHT_N_PER_M: f64 = 300.0;
const HOLE_M: f64 = 1.0;

/// Its outside radius, m; the wall is a tenth of the diameter.
const RADIUS_M: f64 = 0.1;

/// Its bending stiffness, N·m².
pub fn stiffness_N_m2() -> f64 {
    beam(Ends::default(), None).string.components()[0].bending_stiffness_N_m2()
}

/// The beam with a lateral force: where, from its lower end, m, how much, N, and to which tool
/// face, rad.
pub fn beam(ends: Ends, force: Option<[f64; 3]>) -> Model {
    let lateral_force = force.map(|[from_lower_end_m, force_N, toolface_rad]| LateralForce {
        force_N,
        from_lower_end_m,
        toolface_rad,
    });
    let part = ComponentSpec {
        lateral_force,
        ..pipe(WEIGHT_N_PER_M, RADIUS_M, ComponentLength::ToSurface)
    };
    let path = arcs(&[[0.0, 90.0, 0.0], [LENGTH_M, 90.0, 0.0]]);
    let hole = open_hole(HOLE_M, 0.0, LENGTH_M);
    Model { ends, ..super::model(path, hole, vec![part], mud(0.0), LENGTH_M) }
}

/// The ends of a beam, and the textbook effect of its own weight: the bit's share of the weight,
/// the largest deflection over `w L⁴/EI`, and the moment at the top over `w L²`.
pub struct Case {
    pub name: &'static str,
    pub ends: Ends,
    pub bit_share: f64,
    pub deflection: f64,
    pub moment_at_top: f64,
}

/// All of them (Roark's *Formulas for Stress and Strain*, table 8.1).
pub const CASES: [Case; 5] = {
    use BitEnd::{Clamped as Fixed, Free, Pinned as Hinged};
    use TopEnd::{Clamped, Pinned};
    const fn case(
        name: &'static str,
        (top, bit): (TopEnd, BitEnd),
        [bit_share, deflection, moment_at_top]: [f64; 3],
    ) -> Case {
        Case { name, ends: Ends { top, bit }, bit_share, deflection, moment_at_top }
    }
    [
        case("clamped and pinned", (Clamped, Hinged), [3.0 / 8.0, 0.005_416, 1.0 / 8.0]),
        case("pinned and pinned", (Pinned, Hinged), [0.5, 5.0 / 384.0, 0.0]),
        case("clamped and clamped", (Clamped, Fixed), [0.5, 1.0 / 384.0, 1.0 / 12.0]),
        case("pinned and clamped", (Pinned, Fixed), [5.0 / 8.0, 0.005_416, 0.0]),
        case("clamped and free", (Clamped, Free), [0.0, 1.0 / 8.0, 0.5]),
    ]
};
