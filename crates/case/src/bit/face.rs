//! `[bit.face]`.

use wholestring::rock::{
    BitShape,
    bit_face::{InsertBit, InsertShape, PdcBit},
};
use wholestring_config::{
    diagnostic::Diagnostic, names::any_of, prelude::*, reader::Reader, rule::Table, table::Field,
};
use wholestring_units::Dimension;

use crate::bit::kind::{CORE, INSERTS, Kind, PDC};

// The keys of `[bit.face]`.

const DEGREE: f64 = std::f64::consts::PI / 180.0;

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

// The numbers of a bit, from the keys and the defaults.

/// Defaults of cones of inserts: angle between side and axis, and the tip's radius over the
/// insert's diameter.
const HALF_ANGLE_RAD: f64 = 35.0 * DEGREE;
const TIP: f64 = 0.25;

/// Sets a number from the case in place of a default.
fn set(number: &mut f64, field: &Field<f64>) -> Option<()> {
    if let Some(at) = field.optional()? {
        *number = at.value;
    }
    Some(())
}

/// Sets a count from the case and returns whether the case has it.
fn set_count(count: &mut usize, field: &Field<u64>) -> Option<bool> {
    let entry = field.optional()?;
    if let Some(at) = entry {
        *count = usize::try_from(at.value).ok()?;
    }
    Some(entry.is_some())
}

impl FaceTable {
    /// Returns the numbers of the bit, with defaults for those that the case does not have.
    pub(crate) fn shape(
        &self,
        kind: Kind,
        diameter_m: f64,
        core_diameter_m: f64,
        reader: &mut Reader,
    ) -> Option<BitShape> {
        self.warn_of_idle_keys(kind, reader);
        self.check_width(diameter_m, reader)?;
        if kind == Kind::Inserts {
            self.inserts(diameter_m).map(BitShape::Insert)
        } else {
            self.blades(diameter_m, core_diameter_m).map(BitShape::Pdc)
        }
    }

    fn blades(&self, diameter_m: f64, core_diameter_m: f64) -> Option<PdcBit> {
        let mut bit = if core_diameter_m > 0.0 {
            PdcBit::core(diameter_m, core_diameter_m)
        } else {
            PdcBit::for_diameter(diameter_m)
        };
        set_count(&mut bit.blades, &self.blades)?;
        set_count(&mut bit.cutters_per_track, &self.cutters_per_track)?;
        set(&mut bit.cutter_diameter_m, &self.cutter_diameter)?;
        bit.cutter_length_m = 0.8 * bit.cutter_diameter_m;
        bit.exposure_m = 0.5 * bit.cutter_diameter_m;
        for (number, field) in [
            (&mut bit.cutter_length_m, &self.cutter_length),
            (&mut bit.exposure_m, &self.exposure),
            (&mut bit.chamfer_m, &self.chamfer),
            (&mut bit.back_rake_rad, &self.back_rake),
            (&mut bit.side_rake_rad, &self.side_rake),
            (&mut bit.spiral_rad, &self.spiral),
            (&mut bit.blade_width_m, &self.blade_width),
            (&mut bit.centre_spacing, &self.centre_spacing),
            (&mut bit.cone_angle_rad, &self.cone_angle),
            (&mut bit.nose_m, &self.nose),
            (&mut bit.nose_radius_m, &self.nose_radius),
            (&mut bit.shoulder_radius_m, &self.shoulder_radius),
            (&mut bit.gauge_length_m, &self.gauge_length),
            (&mut bit.gauge_relief_m, &self.gauge_relief),
        ] {
            set(number, field)?;
        }
        bit.cutters_per_blade = 1;
        let counted = set_count(&mut bit.cutters_per_blade, &self.cutters_per_blade)?;
        Some(if counted { bit } else { bit.filled() })
    }

    fn inserts(&self, diameter_m: f64) -> Option<InsertBit> {
        let mut bit = InsertBit::for_diameter(diameter_m);
        set(&mut bit.insert_diameter_m, &self.insert_diameter)?;
        bit.protrusion_m = 0.5 * bit.insert_diameter_m;
        bit.pitch_m = 1.5 * bit.insert_diameter_m;
        for (number, field) in [
            (&mut bit.protrusion_m, &self.protrusion),
            (&mut bit.pitch_m, &self.pitch),
            (&mut bit.cone_angle_rad, &self.cone_angle),
            (&mut bit.nose_m, &self.nose),
            (&mut bit.nose_radius_m, &self.nose_radius),
            (&mut bit.shoulder_radius_m, &self.shoulder_radius),
            (&mut bit.gauge_length_m, &self.gauge_length),
            (&mut bit.gauge_relief_m, &self.gauge_relief),
        ] {
            set(number, field)?;
        }
        if *self.insert_shape.get()? == Tip::Cone {
            let (mut half_angle_rad, mut tip_radius_m) =
                (HALF_ANGLE_RAD, TIP * bit.insert_diameter_m);
            set(&mut half_angle_rad, &self.half_angle)?;
            set(&mut tip_radius_m, &self.tip_radius)?;
            bit.shape = InsertShape::Cone { half_angle_rad, tip_radius_m };
        }
        let counted = set_count(&mut bit.rows, &self.rows)?;
        Some(if counted { bit } else { bit.filled() })
    }
}

// Keys that do not suit the kind of bit, and cutters that do not suit any bit.

/// Smallest width of a cutter, as a part of the bit's diameter.
const FINEST: f64 = 0.02;

impl FaceTable {
    /// Refuses cutters that are finer than those of any bit, because the search for a layout grows
    /// with their number.
    fn check_width(&self, diameter_m: f64, reader: &mut Reader) -> Option<()> {
        let min_m = FINEST * diameter_m;
        let fine = [(&self.cutter_diameter, "cutters"), (&self.insert_diameter, "inserts")]
            .into_iter()
            .find_map(|(field, what)| Some((field.given().filter(|at| at.value < min_m)?, what)));
        let Some((entry, what)) = fine else {
            return Some(());
        };
        let least = reader.at_least(Dimension::Diameter, min_m);
        Diagnostic::error(format!("the {what} are too fine for this bit"))
            .at(entry.place, format!("expected at least {least}, a fiftieth of its diameter"))
            .refuse(reader)
    }

    fn warn_of_idle_keys(&self, kind: Kind, reader: &mut Reader) {
        let cones = self.insert_shape.get() == Some(&Tip::Cone);
        for key in self.written() {
            let why = match key.name {
                "cone_angle" if kind == Kind::Core => "a core bit has no cone".to_owned(),
                _ if !key.is_used_with(kind.word()) => {
                    format!("used with kind = {}", any_of(&key.used_with))
                }
                "half_angle" | "tip_radius" if !cones => {
                    "used with insert_shape = \"cone\"".to_owned()
                }
                _ => continue,
            };
            reader.report(Diagnostic::idle(key.name, key.place, why));
        }
    }
}
