//! The keys of `[bit.face]`.

use wholestring_config::prelude::*;

use crate::bit::kind::{CORE, INSERTS, PDC};

pub(super) const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Tip shapes of inserts, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tip {
    Hemisphere,
    Cone,
}

/// Kinds of bits whose blades carry cutters.
const BLADED: &[&str] = &[PDC, CORE];

fn across(to: f64, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.0, to), example)
}

fn wide(to: f64, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::positive_to(to), example)
}

fn angle(from: f64, to: f64, example: &'static str) -> Quantity {
    let range = Range::from_to(from * DEGREE, to * DEGREE);
    Quantity::si(Dimension::Angle, range, example).bare("deg", DEGREE)
}

table! {
    /// The shape of the bit against solid rock: of the law "rock" and of a bit test. Its diameter
    /// is that of the lowest component. A bit is refused if cutters overlap or leave a ring of the
    /// bottom uncut.
    FaceTable in "[bit.face]" {
        /// PDC and core bits: number of blades. Raising it thins the cut of each. Default: 5 below
        /// 165 mm, 6, 7 from 312 mm.
        blades: u64 = optional(Count { from: 1, to: 24 }).used_with(BLADED);
        /// PDC and core bits: cutters on a blade. Raising it thins the cut of each and lowers the
        /// ridges between them. Default: a gap of half a cutter's width on average, or fewer
        /// cutters where there is not enough space.
        cutters_per_blade: u64 = optional(Count { from: 1, to: 200 }).used_with(BLADED);
        /// PDC and core bits: cutters that follow each other on a track, a divisor of the blades.
        /// With 2 or more the forces of a track balance, but the tracks are farther apart. Default:
        /// 1.
        cutters_per_track: u64 = optional(Count { from: 1, to: 24 }).used_with(BLADED);
        /// PDC and core bits: diameter of a cutter. Raising it lowers the ridges, but fewer cutters
        /// fit. Default: 8 mm below 120 mm, 13 mm below 165 mm, 16 mm, 19 mm from 312 mm.
        cutter_diameter: f64 = optional(wide(0.1, "16 mm")).used_with(BLADED);
        /// PDC and core bits: length of a cutter, its carbide included. Default: 0.8 of its
        /// diameter.
        cutter_length: f64 = optional(wide(0.1, "13 mm")).used_with(BLADED);
        /// PDC and core bits: width of the chamfer at 45 deg around a cutter's face. Raising it
        /// blunts the edge. Default: 0.4 mm.
        chamfer: f64 = optional(across(0.05, "0.4 mm")).used_with(BLADED);
        /// PDC and core bits: angle by which a cutter's face leans so that its edge trails; a bare
        /// number is in deg. Raising it requires more weight for the same torque. Default: 17.5
        /// deg.
        back_rake: f64 = optional(angle(0.0, 40.0, "17.5 deg")).used_with(BLADED);
        /// PDC and core bits: angle by which a cutter's face is turned to push cuttings outwards; a
        /// bare number is in deg. Default: 5 deg.
        side_rake: f64 = optional(angle(-40.0, 40.0, "5 deg")).used_with(BLADED);
        /// PDC and core bits: angle by which a blade's outer end trails its inner one; a bare
        /// number is in deg. Default: 20 deg.
        spiral: f64 = optional(angle(-180.0, 180.0, "20 deg")).used_with(BLADED);
        /// PDC and core bits: height of the cutters' tips above the blades. Lowering it lets the
        /// blades touch the rock at a smaller depth of cut. Default: half a cutter's diameter.
        exposure: f64 = optional(wide(0.1, "8 mm")).used_with(BLADED);
        /// PDC and core bits: width of a blade behind its cutters. Raising it enlarges the area of
        /// the body that can rest on the rock. Default: a fifth of the diameter.
        blade_width: f64 = optional(wide(1.0, "43 mm")).used_with(BLADED);
        /// PDC and core bits: spacing of the tracks at the axis over that at the gauge. Raising it
        /// gives the outer cutters less to cut. Default: 1.5, of a core bit 1.
        centre_spacing: f64 = optional(Number { unit: "", range: Range::from_to(0.2, 5.0) })
            .used_with(BLADED);
        /// Inserts: their diameter. Raising it blunts the bit and lowers the ridges. Default: 0.065
        /// of the bit's diameter.
        insert_diameter: f64 = optional(wide(0.2, "14 mm")).used_with(&[INSERTS]);
        /// Inserts: "hemisphere", or "cone" with a round tip.
        insert_shape: Tip = default(
            Choice {
                noun: "a shape of inserts",
                words: &[("hemisphere", Tip::Hemisphere), ("cone", Tip::Cone)],
            },
            Tip::Hemisphere,
        ).used_with(&[INSERTS]);
        /// Cones of inserts: angle between side and axis; a bare number is in deg. Raising it
        /// blunts them. Default: 35 deg.
        half_angle: f64 = optional(angle(6.0, 80.0, "35 deg")).used_with(&[INSERTS]);
        /// Cones of inserts: radius of the tip. Raising it blunts them. Default: a quarter of an
        /// insert's diameter.
        tip_radius: f64 = optional(wide(0.1, "4 mm")).used_with(&[INSERTS]);
        /// Inserts: their height above the body. Lowering it lets the body touch the rock earlier.
        /// Default: half an insert's diameter.
        protrusion: f64 = optional(wide(0.2, "7 mm")).used_with(&[INSERTS]);
        /// Inserts: rows from the axis to the gauge. Raising it lowers the ridges. Default: as many
        /// as leave at most an insert's width between them.
        rows: u64 = optional(Count { from: 1, to: 200 }).used_with(&[INSERTS]);
        /// Inserts: approximate distance between the inserts of a row. Raising it puts more load on
        /// each. Default: 1.5 of their diameter.
        pitch: f64 = optional(wide(1.0, "21 mm")).used_with(&[INSERTS]);
        /// Angle of the inner cone against the plane across the axis; a bare number is in deg. A
        /// deeper cone holds the bit on its axis. No effect on a core bit. Default: 15 deg, with
        /// inserts 10 deg.
        cone_angle: f64 = optional(angle(0.0, 70.0, "15 deg"));
        /// Radius at which the profile is lowest. Raising it moves the load outwards. Default: 0.6
        /// of the bit's; of a core bit halfway across its face.
        nose: f64 = optional(wide(1.0, "65 mm"));
        /// Radius of the nose's arc. Default: 0.3 of the bit's, with inserts 0.4; of a core bit
        /// half the width of its face.
        nose_radius: f64 = optional(wide(10.0, "32 mm"));
        /// Radius of the shoulder's arc. Of the radii of nose and shoulder one must be no smaller
        /// and the other no larger than the distance from the nose to the gauge. Default: 0.5 of
        /// the bit's radius, with inserts 0.4; of a core bit half the width of its face.
        shoulder_radius: f64 = optional(wide(10.0, "54 mm"));
        /// Length of the gauge above the shoulder. Raising it leaves more wall for the pads.
        /// Default: a quarter of the diameter.
        gauge_length: f64 = optional(across(5.0, "54 mm"));
        /// Radial distance of the gauge pads inside the gauge. Raising it lets them touch later.
        /// Default: 0.4 mm.
        gauge_relief: f64 = optional(across(0.05, "0.4 mm"));
    }
}
