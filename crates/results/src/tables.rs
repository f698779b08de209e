//! Every table.

use crate::{
    BHA, BHA_CONTACTS, BHA_SWEEP, BIT_TEST, BOTTOM_HOLE, CALIBRATION, CALIBRATION_BANDS,
    CALIBRATION_DYNAMIC, CALIBRATION_PROFILES, CAMPBELL, CONTACT, CRITICAL_SPEEDS, ColumnSpec,
    FRAMES, MODE_SHAPES, MODES, NODES, PLAN_ALONG, PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_FATIGUE,
    PLAN_FRICTION, PLAN_HYDRAULICS, PLAN_LIMITS, PLAN_MEASURED, PLAN_OVERLAY, PLAN_PEAKS,
    PLAN_PEAKS_TIME, PLAN_SURFACE_LIMITS, PLAN_WEAR, REACH, REACH_LIMITS, RESPONSE, SPECTRA,
    STABILITY, TIME, UNCERTAIN, UNCERTAIN_INDICES, UNCERTAIN_SAMPLES, UNCERTAIN_STOPS, WEAR,
};

/// Every table, by the name of its file, and its columns.
pub const TABLES: &[(&str, &[ColumnSpec])] = &[
    ("nodes", NODES),
    ("time", TIME),
    ("frames", FRAMES),
    ("spectra", SPECTRA),
    ("wear", WEAR),
    ("contact", CONTACT),
    ("bit-test", BIT_TEST),
    ("bottom_hole", BOTTOM_HOLE),
    ("bha", BHA),
    ("bha_contacts", BHA_CONTACTS),
    ("bha_sweep", BHA_SWEEP),
    ("stability", STABILITY),
    ("modes", MODES),
    ("mode_shapes", MODE_SHAPES),
    ("campbell", CAMPBELL),
    ("critical_speeds", CRITICAL_SPEEDS),
    ("response", RESPONSE),
    ("plan_along", PLAN_ALONG),
    ("plan_broomstick", PLAN_BROOMSTICK),
    ("plan_buckling", PLAN_BUCKLING),
    ("plan_friction", PLAN_FRICTION),
    ("plan_limits", PLAN_LIMITS),
    ("plan_surface_limits", PLAN_SURFACE_LIMITS),
    ("plan_hydraulics", PLAN_HYDRAULICS),
    ("plan_fatigue", PLAN_FATIGUE),
    ("plan_wear", PLAN_WEAR),
    ("plan_uncertain", UNCERTAIN),
    ("plan_uncertain_indices", UNCERTAIN_INDICES),
    ("plan_uncertain_samples", UNCERTAIN_SAMPLES),
    ("plan_measured", PLAN_MEASURED),
    ("plan_overlay", PLAN_OVERLAY),
    ("plan_peaks", PLAN_PEAKS),
    ("plan_peaks_time", PLAN_PEAKS_TIME),
    ("reach", REACH),
    ("reach_limits", REACH_LIMITS),
    ("reach_uncertain", UNCERTAIN),
    ("reach_uncertain_indices", UNCERTAIN_INDICES),
    ("reach_uncertain_samples", UNCERTAIN_SAMPLES),
    ("reach_uncertain_stops", UNCERTAIN_STOPS),
    ("calibration", CALIBRATION),
    ("calibration_bands", CALIBRATION_BANDS),
    ("calibration_profiles", CALIBRATION_PROFILES),
    ("calibration_dynamic", CALIBRATION_DYNAMIC),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique() {
        for (_, table) in TABLES {
            for (index, column) in table.iter().enumerate() {
                assert!(
                    table[..index].iter().all(|other| other.name != column.name),
                    "{} is declared twice",
                    column.name
                );
            }
        }
    }

    /// The meaning of a column that may be `null` mentions it.
    #[test]
    fn a_column_that_may_be_null_says_so() {
        for column in TABLES.iter().flat_map(|(_, columns)| *columns) {
            let says = column.meaning.contains("`null`") || column.meaning.contains("empty");
            assert_eq!(says, column.null_where.is_some(), "{}", column.name);
        }
    }
}
