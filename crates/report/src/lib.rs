//! Pages, pictures and workbooks of the answers in `wholestring-results`: figures as SVG and PNG,
//! and all of it as one HTML file.
#![warn(missing_docs)]

mod bha;
mod bit_test;
mod bottom;
mod calibration;
mod cell;
mod check_row;
mod conventions;
mod dimensions;
mod draw;
pub mod figure;
mod grid_cells;
mod inputs;
mod modes;
mod packed;
mod page;
mod page_head;
mod picks;
mod plan;
mod plots;
mod reach;
mod run;
mod stability;
pub mod study;
mod sweep;
mod thin;
mod uncertain;
mod workbook;

pub use bha::{Bha, bha_number, bha_plots, bha_quantity, bha_tendency};
pub use bit_test::{BitTest, bit_test_plots};
pub use bottom::BottomPicture;
pub use calibration::{
    CALIBRATION_PICTURES, Calibration, calibration_html, calibration_plots, reading_words,
};
pub use cell::{Cell, PageTable, Place};
pub use check_row::{CheckRow, printed};
pub use conventions::Conventions;
pub use dimensions::{DisplayUnit, display_unit, display_units, pretty_symbol};
pub use draw::{Drawing, palette::operation_colour};
pub use inputs::{input_tables, setting_dimension};
pub use modes::{MODES_PICTURES, Modes, modes_html, modes_plots};
pub use packed::Packed;
pub use page::{bha_html, bit_test_html, report_html, sweep_html};
pub use page_head::{Fact, PROGRAM, PageHead};
pub use picks::{picked_stand_figure, picks_html};
pub use plan::{
    FRICTION_STROKES, PLAN_PICTURES, Plan, plan_friction_label, plan_html, plan_plots,
    surface_limit_is_near, surface_limit_title,
};
pub use plots::{Plot, Run, common_operations, plots, profile, shown_dimension};
pub use reach::{
    REACH_PICTURES, Reach, end_of_limit, reach_answers, reach_html, reach_notes, reach_plots,
};
pub use run::{
    ContactPicture, Frames, KeyResult, Part, Report, Section, Solved, Spectrum, TimeRun, Well,
    path_of, well_path,
};
pub use stability::stability_sentences;
pub use study::{Grid, Head, StudyPage, StudyPart, Verdict, address};
pub use sweep::{Sweep, sweep_plots};
pub use uncertain::uncertain_notes;
pub use wholestring_judge::Severity;
pub use workbook::{
    Cells, Sheet, SheetColumn, Workbook, WorkbookChart, WorkbookError, WorkbookSeries,
};
