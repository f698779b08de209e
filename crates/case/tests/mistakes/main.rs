//! Mistakes that people make, and the complete message for each.

#[path = "../common/mod.rs"]
mod common;

mod bit;
mod catalogue;
mod dynamics;
mod field_units;
mod magnitudes;
mod measured;
mod mud;
mod operation;
mod overrides;
mod plan;
mod plan_dynamic;
mod plan_limits;
mod plan_uncertain;
mod records;
mod rock;
mod schedule;
mod string;
mod surface;
mod survey;
mod top_side;
mod well;
mod writing;

use common::{change::changes, changed, read};
use wholestring_case::{Case, Report};

/// Compares the message with the one on record. The mistake must be refused.
#[track_caller]
fn refused(name: &str, answer: Result<Case, Report>) {
    let Err(report) = answer else { panic!("`{name}` was accepted") };
    assert!(report.errors() > 0, "`{name}` is refused without an error");
    on_record(name, &report);
}

/// The same for input that is accepted with a warning.
#[track_caller]
fn warned(name: &str, answer: Result<Case, Report>) {
    let case = answer.unwrap_or_else(|report| panic!("`{name}` was refused:\n{report}"));
    assert!(!case.warnings.is_empty(), "`{name}` gets no warning");
    on_record(name, &case.warnings);
}

fn on_record(name: &str, report: &Report) {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path("snapshots");
    settings.bind(|| insta::assert_snapshot!(name, report.render(false)));
}

/// Mistakes of the example, as [`changes`] has them.
fn each_refused(table: &str) {
    for (name, from, to) in changes(table) {
        let text = changed(&from, &to);
        field_units::required(name, &text);
        refused(name, read(&text));
    }
}

/// Whole case files with a mistake.
fn texts_refused<const N: usize>(cases: [(&str, String); N]) {
    for (name, text) in cases {
        field_units::required(name, &text);
        refused(name, read(&text));
    }
}

/// Changes of the example that are accepted with a warning.
fn each_warned(table: &str) {
    for (name, from, to) in changes(table) {
        let text = changed(&from, &to);
        field_units::required(name, &text);
        warned(name, read(&text));
    }
}
