//! Verification of the bit's face: its geometry, its cuts, and its contact with nodes of rock.

mod contact;
mod geometry;
mod tracks;

use wholestring_rock::bit_face::{BitFace, InsertBit, InsertShape, PdcBit};

/// The default 8-1/2 in drag bit.
fn pdc() -> PdcBit {
    PdcBit::for_diameter(0.2159)
}

/// A drag bit whose cutters face each other: turned by half a turn it is the same.
fn opposed() -> PdcBit {
    PdcBit { cutters_per_track: 2, ..pdc() }
}

/// Conical inserts, which need narrower rows.
fn cones() -> InsertBit {
    InsertBit {
        shape: InsertShape::Cone { half_angle_rad: 0.6, tip_radius_m: 3e-3 },
        rows: 13,
        ..InsertBit::for_diameter(0.2159)
    }
}

/// One of each kind.
fn faces() -> Vec<(&'static str, BitFace)> {
    vec![
        ("drag bit", pdc().face().unwrap()),
        ("opposed cutters", opposed().face().unwrap()),
        ("core bit", PdcBit::core(0.2159, 0.1016).face().unwrap()),
        ("hemispheres", InsertBit::for_diameter(0.2159).face().unwrap()),
        ("cones", cones().face().unwrap()),
    ]
}
