//! `[bit.face]`.

use serde_json::{Value as Json, json};
use wholestring::rock::{
    BitShape,
    bit_face::{InsertBit, InsertShape, PdcBit},
};
use wholestring_units::Dimension;

use super::{Kind, place};
use crate::{
    diagnostic::Diagnostic,
    quantity::Quantity,
    range::{Count, Number, Range, number_text},
    reader::Reader,
    rule::Choice,
    source::Place,
    table::{Field, default, optional, table},
};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Cones of inserts where the case does not say: between side and axis, and the tip's radius over the insert's diameter.
const HALF_ANGLE_RAD: f64 = 35.0 * DEGREE;
const TIP: f64 = 0.25;

/// Finer cutters than this part of the bit's diameter are no bit's.
const FINEST: f64 = 0.02;

/// Tips of inserts, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tip {
    Hemisphere,
    Cone,
}

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
    /// The shape of the bit against solid rock: of the law "rock" and of a bit test. Its diameter is that of the lowest
    /// component. A bit is refused if cutters overlap or leave a ring of the bottom uncut.
    FaceTable in "[bit.face]" {
        /// PDC and core bits: number of blades. Raising it thins the cut of each. Default: 5 below 165 mm, 6, 7 from
        /// 312 mm.
        blades: u64 = optional(Count { from: 1, to: 24 });
        /// PDC and core bits: cutters on a blade. Raising it thins the cut of each and lowers the ridges between them.
        /// Default: half a cutter's width between them on average, or fewer, to have room.
        cutters_per_blade: u64 = optional(Count { from: 1, to: 200 });
        /// PDC and core bits: cutters that follow each other on a track, a divisor of the blades. With 2 or more the forces
        /// of a track balance; the tracks lie farther apart. Default: 1.
        cutters_per_track: u64 = optional(Count { from: 1, to: 24 });
        /// PDC and core bits: diameter of a cutter. Raising it lowers the ridges; fewer find room. Default: 8 mm below
        /// 120 mm, 13 mm below 165 mm, 16 mm, 19 mm from 312 mm.
        cutter_diameter: f64 = optional(wide(0.1, "16 mm"));
        /// PDC and core bits: length of a cutter, its carbide included. Default: 0.8 of its diameter.
        cutter_length: f64 = optional(wide(0.1, "13 mm"));
        /// PDC and core bits: width of the chamfer at 45 deg around a cutter's face. Raising it blunts the edge.
        /// Default: 0.4 mm.
        chamfer: f64 = optional(across(0.05, "0.4 mm"));
        /// PDC and core bits: by how much a cutter's face leans so that its edge trails; a bare number is in deg. Raising
        /// it takes more weight for the same torque. Default: 17.5 deg.
        back_rake: f64 = optional(angle(0.0, 40.0, "17.5 deg"));
        /// PDC and core bits: by how much a cutter's face is turned to push cuttings outwards; a bare number is in deg.
        /// Default: 5 deg.
        side_rake: f64 = optional(angle(-40.0, 40.0, "5 deg"));
        /// PDC and core bits: angle by which a blade's outer end trails its inner one; a bare number is in deg.
        /// Default: 20 deg.
        spiral: f64 = optional(angle(-180.0, 180.0, "20 deg"));
        /// PDC and core bits: how far the cutters' tips stand out of the blades. Lowering it lets the blades bear at a
        /// smaller depth of cut. Default: half a cutter's diameter.
        exposure: f64 = optional(wide(0.1, "8 mm"));
        /// PDC and core bits: width of a blade behind its cutters. Raising it leaves more body to bear. Default: a fifth
        /// of the diameter.
        blade_width: f64 = optional(wide(1.0, "43 mm"));
        /// PDC and core bits: spacing of the tracks at the axis over that at the gauge. Raising it gives the outer
        /// cutters less to cut. Default: 1.5, of a core bit 1.
        centre_spacing: f64 = optional(Number { unit: "", range: Range::from_to(0.2, 5.0) });
        /// Inserts: their diameter. Raising it blunts the bit and lowers the ridges. Default: 0.065 of the bit's.
        insert_diameter: f64 = optional(wide(0.2, "14 mm"));
        /// Inserts: "hemisphere", or "cone" with a round tip.
        insert_shape: Tip = default(
            Choice {
                noun: "a shape of inserts",
                words: &[("hemisphere", Tip::Hemisphere), ("cone", Tip::Cone)],
            },
            Tip::Hemisphere,
        );
        /// Cones of inserts: angle between side and axis; a bare number is in deg. Raising it blunts them. Default:
        /// 35 deg.
        half_angle: f64 = optional(angle(6.0, 80.0, "35 deg"));
        /// Cones of inserts: radius of the tip. Raising it blunts them. Default: a quarter of an insert's diameter.
        tip_radius: f64 = optional(wide(0.1, "4 mm"));
        /// Inserts: how far they stand out of the body. Lowering it lets the body bear earlier. Default: half an
        /// insert's diameter.
        protrusion: f64 = optional(wide(0.2, "7 mm"));
        /// Inserts: rows from the axis to the gauge. Raising it lowers the ridges. Default: no more than an insert's
        /// width between them.
        rows: u64 = optional(Count { from: 1, to: 200 });
        /// Inserts: distance between those of a row, about. Raising it puts more load on each. Default: 1.5 of their
        /// diameter.
        pitch: f64 = optional(wide(1.0, "21 mm"));
        /// Angle of the inner cone against the plane across the axis; a bare number is in deg. A deeper cone holds the
        /// bit on its axis. No effect on a core bit. Default: 15 deg, with inserts 10 deg.
        cone_angle: f64 = optional(angle(0.0, 70.0, "15 deg"));
        /// Radius at which the profile is lowest. Raising it moves the load outwards. Default: 0.6 of the bit's; of a
        /// core bit halfway across its face.
        nose: f64 = optional(wide(1.0, "65 mm"));
        /// Radius of the nose's arc. Default: 0.3 of the bit's, with inserts 0.4; of a core bit half the width of its
        /// face.
        nose_radius: f64 = optional(wide(10.0, "32 mm"));
        /// Radius of the shoulder's arc. Of this and the nose's one must be no smaller, one no larger than the way from the
        /// nose to the gauge. Default: 0.5 of the bit's radius, with inserts 0.4; of a core bit half the width of its face.
        shoulder_radius: f64 = optional(wide(10.0, "54 mm"));
        /// Length of the gauge above the shoulder. Raising it leaves more wall for the pads. Default: a quarter of the
        /// diameter.
        gauge_length: f64 = optional(across(5.0, "54 mm"));
        /// How far the gauge pads stay behind the gauge. Raising it lets them touch later. Default: 0.4 mm.
        gauge_relief: f64 = optional(across(0.05, "0.4 mm"));
    }
}

/// A number that the case has, in place of a default.
fn set(number: &mut f64, field: &Field<f64>) -> Option<()> {
    if let Some(at) = field.optional()? {
        *number = at.value;
    }
    Some(())
}

/// A count that the case has; whether it has one.
fn set_count(count: &mut usize, field: &Field<u64>) -> Option<bool> {
    let given = field.optional()?;
    if let Some(at) = given {
        *count = usize::try_from(at.value).ok()?;
    }
    Some(given.is_some())
}

impl FaceTable {
    /// The numbers of the bit, those that the case does not have by default.
    pub(super) fn shape(
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

    /// Finer ones than any bit has are looked for as long as they are found.
    fn check_width(&self, diameter_m: f64, reader: &mut Reader) -> Option<()> {
        let least_m = FINEST * diameter_m;
        let fine = [
            (&self.cutter_diameter, "cutters"),
            (&self.insert_diameter, "inserts"),
        ]
        .into_iter()
        .find_map(|(field, what)| Some((field.given().filter(|at| at.value < least_m)?, what)));
        let Some((given, what)) = fine else {
            return Some(());
        };
        let least = number_text((least_m * 1e4).ceil() * 1e-1);
        reader.report(
            Diagnostic::error(format!("the {what} are too fine for this bit")).at(
                given.place,
                format!("expected at least {least} mm, a fiftieth of its diameter"),
            ),
        );
        None
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
            bit.shape = InsertShape::Cone {
                half_angle_rad,
                tip_radius_m,
            };
        }
        let counted = set_count(&mut bit.rows, &self.rows)?;
        Some(if counted { bit } else { bit.filled() })
    }

    /// The keys that stand in the file.
    pub(super) fn places(&self) -> [(&'static str, Option<Place>); 25] {
        [
            ("blades", place(&self.blades)),
            ("cutters_per_blade", place(&self.cutters_per_blade)),
            ("cutters_per_track", place(&self.cutters_per_track)),
            ("cutter_diameter", place(&self.cutter_diameter)),
            ("cutter_length", place(&self.cutter_length)),
            ("chamfer", place(&self.chamfer)),
            ("back_rake", place(&self.back_rake)),
            ("side_rake", place(&self.side_rake)),
            ("spiral", place(&self.spiral)),
            ("exposure", place(&self.exposure)),
            ("blade_width", place(&self.blade_width)),
            ("centre_spacing", place(&self.centre_spacing)),
            ("insert_diameter", place(&self.insert_diameter)),
            ("insert_shape", place(&self.insert_shape)),
            ("half_angle", place(&self.half_angle)),
            ("tip_radius", place(&self.tip_radius)),
            ("protrusion", place(&self.protrusion)),
            ("rows", place(&self.rows)),
            ("pitch", place(&self.pitch)),
            ("cone_angle", place(&self.cone_angle)),
            ("nose", place(&self.nose)),
            ("nose_radius", place(&self.nose_radius)),
            ("shoulder_radius", place(&self.shoulder_radius)),
            ("gauge_length", place(&self.gauge_length)),
            ("gauge_relief", place(&self.gauge_relief)),
        ]
    }

    fn warn_of_idle_keys(&self, kind: Kind, reader: &mut Reader) {
        const OF_INSERTS: [&str; 7] = [
            "insert_diameter",
            "insert_shape",
            "half_angle",
            "tip_radius",
            "protrusion",
            "rows",
            "pitch",
        ];
        const OF_ALL: [&str; 6] = [
            "cone_angle",
            "nose",
            "nose_radius",
            "shoulder_radius",
            "gauge_length",
            "gauge_relief",
        ];
        let cones = self.insert_shape.get() == Some(&Tip::Cone);
        for (name, given) in self.places() {
            let Some(given) = given else { continue };
            let why = match name {
                "cone_angle" if kind == Kind::Core => "a core bit has no cone",
                name if OF_ALL.contains(&name) => continue,
                name if OF_INSERTS.contains(&name) && kind != Kind::Inserts => {
                    "used with kind = \"inserts\""
                }
                "half_angle" | "tip_radius" if !cones => "used with insert_shape = \"cone\"",
                name if OF_INSERTS.contains(&name) || kind != Kind::Inserts => continue,
                _ => "used with kind = \"pdc\" or \"core\"",
            };
            let message = format!("`{name}` has no effect here");
            reader.report(Diagnostic::warning(message).at(given, why));
        }
    }
}

/// The numbers of the bit, for the record of a run.
pub(crate) fn settings(shape: &BitShape) -> Json {
    match shape {
        BitShape::Pdc(bit) => json!({
            "diameter_m": bit.diameter_m,
            "core_diameter_m": bit.core_diameter_m,
            "blades": bit.blades,
            "cutters_per_blade": bit.cutters_per_blade,
            "cutters_per_track": bit.cutters_per_track,
            "cutter_diameter_m": bit.cutter_diameter_m,
            "cutter_length_m": bit.cutter_length_m,
            "chamfer_m": bit.chamfer_m,
            "back_rake_rad": bit.back_rake_rad,
            "side_rake_rad": bit.side_rake_rad,
            "spiral_rad": bit.spiral_rad,
            "exposure_m": bit.exposure_m,
            "blade_width_m": bit.blade_width_m,
            "centre_spacing": bit.centre_spacing,
            "cone_angle_rad": bit.cone_angle_rad,
            "nose_m": bit.nose_m,
            "nose_radius_m": bit.nose_radius_m,
            "shoulder_radius_m": bit.shoulder_radius_m,
            "gauge_length_m": bit.gauge_length_m,
            "gauge_relief_m": bit.gauge_relief_m,
        }),
        BitShape::Insert(bit) => {
            let (word, cone) = match bit.shape {
                InsertShape::Hemisphere => ("hemisphere", None),
                InsertShape::Cone {
                    half_angle_rad,
                    tip_radius_m,
                } => ("cone", Some((half_angle_rad, tip_radius_m))),
            };
            json!({
                "diameter_m": bit.diameter_m,
                "insert_diameter_m": bit.insert_diameter_m,
                "insert_shape": word,
                "half_angle_rad": cone.map(|(half_angle, _)| half_angle),
                "tip_radius_m": cone.map(|(_, tip)| tip),
                "protrusion_m": bit.protrusion_m,
                "rows": bit.rows,
                "pitch_m": bit.pitch_m,
                "cone_angle_rad": bit.cone_angle_rad,
                "nose_m": bit.nose_m,
                "nose_radius_m": bit.nose_radius_m,
                "shoulder_radius_m": bit.shoulder_radius_m,
                "gauge_length_m": bit.gauge_length_m,
                "gauge_relief_m": bit.gauge_relief_m,
            })
        }
    }
}
