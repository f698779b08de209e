//! Every table.

use super::{
    BHA, BHA_CONTACTS, BHA_SWEEP, BIT_TEST, BOTTOM_HOLE, CALIBRATION, CALIBRATION_BANDS,
    CALIBRATION_PROFILES, CAMPBELL, CONTACT, CRITICAL_SPEEDS, ColumnSpec, FRAMES, MODE_SHAPES,
    MODES, NODES, PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_FATIGUE, PLAN_FRICTION, PLAN_HYDRAULICS,
    PLAN_LIMITS, PLAN_PEAKS, PLAN_PEAKS_TIME, PLAN_WEAR, REACH, REACH_LIMITS, RESPONSE, SPECTRA,
    STABILITY, TIME, WEAR,
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
    ("plan_broomstick", PLAN_BROOMSTICK),
    ("plan_buckling", PLAN_BUCKLING),
    ("plan_friction", PLAN_FRICTION),
    ("plan_limits", PLAN_LIMITS),
    ("plan_hydraulics", PLAN_HYDRAULICS),
    ("plan_fatigue", PLAN_FATIGUE),
    ("plan_wear", PLAN_WEAR),
    ("plan_peaks", PLAN_PEAKS),
    ("plan_peaks_time", PLAN_PEAKS_TIME),
    ("reach", REACH),
    ("reach_limits", REACH_LIMITS),
    ("calibration", CALIBRATION),
    ("calibration_bands", CALIBRATION_BANDS),
    ("calibration_profiles", CALIBRATION_PROFILES),
];
