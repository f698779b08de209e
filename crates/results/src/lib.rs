//! Files of a run: `summary.json`, `nodes.parquet`, `time.parquet` and others that the case
//! requires, and the tables as CSV.
//!
//! Files are SI with the unit in every name, hold `null` where a number is not finite or does not
//! apply, and appear whole or not at all, because each is written under a temporary name and then
//! renamed.
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod bha;
mod bha_tables;
mod bit_test;
mod bit_test_table;
mod calibration;
mod checkpoint;
mod checks;
mod columns;
mod digest;
mod error;
mod file;
mod folder;
mod formula;
mod fourier;
mod frames;
mod growing_table;
mod hold;
mod json;
mod modes;
mod modes_tables;
mod names;
mod or_empty;
mod parquet_file;
mod parquet_guard;
mod parts;
mod plan;
mod reach;
mod reach_table;
mod row_operation;
mod spectrum;
mod stability;
mod stability_table;
mod summary;
mod table;
mod texts;
mod thrift;
mod uncertain;

pub use wholestring_judge::{Check, CheckKind, ReadingCheck, Severity, Unchecked, Verdict};

pub use bha::{BHA_VERSION, BhaFound, BhaPart, BhaPoint, BhaState, BhaSummary, BhaVaried};
pub use bha_tables::{bha_contacts_table, bha_sweep_table, bha_table};
pub use bit_test::{BIT_TEST_VERSION, BitTestOutcome, BitTestPoint, BitTestSummary};
pub use bit_test_table::bit_test_table;
pub use calibration::{
    CALIBRATION_VERSION, CalibrationSummary, CalibrationTables, DynamicCheck, ErrorFound,
    EstimateFound, InMotion, OutlierComparison, calibration_dynamic_table,
};
pub use checkpoint::{checkpoint_bytes, read_checkpoint_bytes};
pub use checks::{NamedCheck, checks_of};
pub use columns::{
    BHA, BHA_CONTACTS, BHA_SWEEP, BIT_TEST, BOTTOM_HOLE, CALIBRATION, CALIBRATION_BANDS,
    CALIBRATION_DYNAMIC, CALIBRATION_PROFILES, CAMPBELL, CONTACT, CRITICAL_SPEEDS, ColumnSpec,
    FRAMES, MODE_SHAPES, MODES, NODES, PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_FATIGUE, PLAN_FRICTION,
    PLAN_HYDRAULICS, PLAN_LIMITS, PLAN_MEASURED, PLAN_OVERLAY, PLAN_PEAKS, PLAN_PEAKS_TIME,
    PLAN_SURFACE_LIMITS, PLAN_WEAR, REACH, REACH_LIMITS, RESPONSE, SPECTRA, STABILITY, TABLES,
    TIME, UNCERTAIN, UNCERTAIN_INDICES, UNCERTAIN_SAMPLES, UNCERTAIN_STOPS, WEAR,
};
pub use digest::digest;
pub use error::ResultsError;
pub use file::{write_file, write_new_files};
pub use folder::ResultsFolder;
pub use frames::{FrameWriter, FramesSoFar};
pub use growing_table::{GrowingTable, TableSoFar};
pub use hold::{Hold, Holding, Occupant};
pub use modes::{CriticalSpeed, MODES_VERSION, ModeFound, ModesSummary, ModesTables, Spot};
pub use plan::{
    PLAN_VERSION, PlanBuckling, PlanCheck, PlanDamage, PlanDensity, PlanFatigue, PlanFatigueHour,
    PlanFriction, PlanGel, PlanHistory, PlanHydraulics, PlanMeasured, PlanOperation, PlanOverlay,
    PlanOverlayDifference, PlanOverlayRow, PlanPeak, PlanPeakOf, PlanPoint, PlanSummary,
    PlanSurfaceLimit, PlanWear, plan_broomstick_table, plan_fatigue_table, plan_limits_table,
    plan_peaks_table, plan_peaks_time_table, plan_wear_table,
};
pub use reach::{REACH_VERSION, ReachCheck, ReachLimit, ReachOfFriction, ReachStop, ReachSummary};
pub use reach_table::reach_limits_table;
pub use spectrum::Spectrum;
pub use stability::{StabilitySummary, StableFrom, StableWhere, TriedController};
pub use stability_table::stability_table;
pub use summary::{
    ENGINE_VERSION, Friction, Numerics, OperationSummary, SCHEMA_VERSION, Status, Summary,
};
pub use table::{Column, Data, Table};
pub use texts::Texts;
pub use uncertain::{
    UncertainBand, UncertainKey, UncertainOwed, UncertainStop, UncertainSummary, UncertainTables,
};
pub use wholestring::dynamics::Statistic;
