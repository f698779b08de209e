//! The numbers of a bit, from the keys and the defaults.

use wholestring::rock::{
    BitShape,
    bit_face::{InsertBit, InsertShape, PdcBit},
};

use wholestring_config::{reader::Reader, table::Field};

use super::table::{DEGREE, FaceTable, Tip};
use crate::bit::kind::Kind;

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
