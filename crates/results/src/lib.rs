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
mod calibration;
mod calibration_rows;
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
mod names;
mod operation_tables;
mod or_empty;
mod parquet_file;
mod parquet_guard;
mod parts;
mod plan;
mod reach;
mod row;
mod spectrum;
mod stability;
mod summary;
mod table;
mod tables;
mod texts;
mod thrift;
mod uncertain;
mod uncertain_rows;

pub use wholestring_judge::{Check, CheckKind, ReadingCheck, Severity, Unchecked, Verdict};

pub use bha::{BHA_VERSION, BhaPart, BhaState, BhaSummary};
pub use bha_tables::{BHA, BHA_CONTACTS, BHA_SWEEP, BhaFound, BhaPoint, BhaVaried, bha_table};
pub use bit_test::{
    BIT_TEST, BIT_TEST_VERSION, BOTTOM_HOLE, BitTestOutcome, BitTestPoint, BitTestSummary,
    BottomHoleCell, bit_test_common,
};
pub use calibration::{
    CALIBRATION_VERSION, CalibrationRows, CalibrationSummary, ErrorFound, EstimateFound,
    OutlierComparison,
};
pub use calibration_rows::{
    CALIBRATION, CALIBRATION_BANDS, CALIBRATION_DYNAMIC, CALIBRATION_PROFILES, CalibrationBand,
    CalibrationProfile, CalibrationReading, DynamicCheck, InMotion,
};
pub use checkpoint::{checkpoint_bytes, read_checkpoint_bytes};
pub use checks::{NamedCheck, checks_of};
pub use columns::{CONTACT, ColumnSpec, FRAMES, NODES, TIME, WEAR};
pub use digest::digest;
pub use error::ResultsError;
pub use file::{write_file, write_new_files};
pub use folder::ResultsFolder;
pub use frames::{FrameWriter, FramesSoFar};
pub use growing_table::{GrowingTable, TableSoFar};
pub use hold::{Hold, Holding, Occupant};
pub use json::read_any_summary;
pub use modes::{
    CAMPBELL, CRITICAL_SPEEDS, CampbellRow, CriticalSpeed, MODE_SHAPES, MODES, MODES_VERSION,
    ModeFound, ModeShapeRow, ModesRows, ModesSummary, RESPONSE, ResponseRow, Spot,
};
pub use operation_tables::OperationTables;
pub use plan::{
    PLAN_ALONG, PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_FATIGUE, PLAN_FRICTION, PLAN_HYDRAULICS,
    PLAN_LIMITS, PLAN_MEASURED, PLAN_OVERLAY, PLAN_PEAKS, PLAN_PEAKS_TIME, PLAN_SURFACE_LIMITS,
    PLAN_VERSION, PLAN_WEAR, PlanBuckling, PlanCheck, PlanDamage, PlanDensity, PlanFatigue,
    PlanFatigueHour, PlanFriction, PlanGel, PlanHistory, PlanHydraulics, PlanMeasured,
    PlanOperation, PlanOverlay, PlanOverlayDifference, PlanOverlayRow, PlanPeak, PlanPeakOf,
    PlanPeakSample, PlanPoint, PlanStation, PlanSummary, PlanSurfaceLimit, PlanWear,
    plan_broomstick_table, plan_limits_table, plan_peaks_time_table,
};
pub use reach::{
    REACH, REACH_LIMITS, REACH_VERSION, ReachCheck, ReachLimit, ReachMargin, ReachOfFriction,
    ReachStop, ReachSummary,
};
pub use row::{ReadRow, Row};
pub use spectrum::{SPECTRA, Spectrum, SpectrumRow};
pub use stability::{
    STABILITY, StabilityRow, StabilitySummary, StableFrom, StableWhere, TriedController,
};
pub use summary::{
    ENGINE_VERSION, Friction, Numerics, OperationSummary, SCHEMA_VERSION, Status, Summary,
};
pub use table::{Column, Data, Table};
pub use tables::TABLES;
pub use texts::Texts;
pub use uncertain::{UncertainKey, UncertainSummary, UncertainTables};
pub use uncertain_rows::{
    UNCERTAIN, UNCERTAIN_INDICES, UNCERTAIN_SAMPLES, UNCERTAIN_STOPS, UncertainBand,
    UncertainIndex, UncertainOwed, UncertainSample, UncertainStop,
};
pub use wholestring::dynamics::Statistic;
