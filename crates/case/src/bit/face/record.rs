//! The face of a bit in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::rock::{BitShape, bit_face::InsertShape};

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
