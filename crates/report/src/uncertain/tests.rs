//! Pages of uncertain numbers.

use wholestring::operation::OperationKind;

use super::{Uncertain, UncertainNumber, UncertainShares, bands, figure, owed};
use crate::{StudyPart, plots::DisplayUnits};

fn number(quantity: &str, not_met: usize) -> UncertainNumber {
    UncertainNumber {
        quantity: quantity.into(),
        title: quantity.replace('_', " "),
        limit: String::new(),
        operation: Some(OperationKind::TripOut),
        friction: None,
        bit_depth_m: (quantity != "depth").then_some(1000.0),
        dimension: "force".into(),
        expected: 2e5,
        quantiles: [1e5, 1.2e5, 2e5, 2.8e5, 3e5],
        answers: 200,
        without_answer: 3,
        not_met,
        owed: Some(UncertainShares {
            first: vec![0.7, f64::NAN],
            total: vec![0.75, 0.25],
            predicts: 0.75,
        }),
    }
}

fn all() -> Uncertain {
    Uncertain {
        notes: vec!["200 samples.".into()],
        inputs: vec![["friction".into(), "even".into()], ["seed".into(), "one of 200".into()]],
        bands: vec![number("hook_load", 0), number("depth", 20), number("margin", 0)],
        stops: Vec::new(),
        files: ["a".into(), "b".into(), "c".into(), String::new()],
    }
}

fn cells(part: Option<StudyPart>) -> Vec<Vec<String>> {
    let Some(StudyPart::Table { grid, .. }) = part else { panic!("a table") };
    grid.rows.into_iter().map(|row| row.into_iter().map(|(cell, _)| cell).collect()).collect()
}

/// Samples without an answer are counted, an unreached limit is reported as beyond, a choice among
/// many values has the remainder.
#[test]
fn tables_say_what_is_missing() {
    let none = std::collections::BTreeMap::new();
    let rows = cells(bands(&all(), DisplayUnits::new(&none, "si")));
    // Margins are only in the figure.
    assert_eq!(rows.len(), 2);
    assert!(rows.iter().all(|row| row.last().unwrap() == "3"), "{rows:?}");
    let over = |row: &[String]| row.iter().filter(|cell| cell.starts_with("over ")).count();
    assert_eq!((over(&rows[0]), over(&rows[1])), (0, 1), "{rows:?}");
    let rows = cells(owed(&all()));
    assert_eq!(rows[0][2..], ["70 / 75", "– / 25", "75"]);
}

#[test]
fn bars_are_drawn_of_several_inputs() {
    let figure_of_all = figure(&all(), "a well").expect("a figure");
    assert_eq!(figure_of_all.panels.len(), 2);
    let mut one = all();
    one.inputs.truncate(1);
    assert_eq!(figure(&one, "a well"), None);
}
