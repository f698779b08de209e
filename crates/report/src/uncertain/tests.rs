//! Pages of uncertain numbers.

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{
    UncertainBand, UncertainKey, UncertainOwed, UncertainSummary, UncertainTables,
};

use super::{Uncertain, bands, figure, owed};
use crate::{StudyPart, plots::DisplayUnits};

fn number(quantity: &str, not_met: usize) -> UncertainBand {
    UncertainBand {
        quantity: quantity.into(),
        limit: String::new(),
        operation: Some(OperationKind::TripOut),
        friction: None,
        bit_depth_m: (quantity != "depth").then_some(1000.0),
        unit: "N".into(),
        expected: Some(2e5),
        quantiles: [1e5, 1.2e5, 2e5, 2.8e5, 3e5],
        mean: 2e5,
        std: 5e4,
        answers: 200,
        without_answer: 3,
        not_met,
        owed: Some(UncertainOwed {
            first: vec![Some(0.7), None],
            total: vec![0.75, 0.25],
            predicts: 0.75,
            degree: 2,
        }),
    }
}

fn key(key: &str, distribution: &str) -> UncertainKey {
    UncertainKey { key: key.into(), distribution: distribution.into() }
}

fn all() -> UncertainSummary {
    UncertainSummary {
        model: ModelKind::Soft,
        samples: 200,
        solved: 200,
        lacking: 0,
        reasons: Vec::new(),
        seed: 1,
        inputs: vec![key("friction", "even"), key("seed", "one of 200")],
        bands: vec![number("hook_load", 0), number("depth", 20), number("margin", 0)],
        stops: Vec::new(),
    }
}

fn uncertain(summary: &UncertainSummary) -> Uncertain<'_> {
    Uncertain { summary, tables: &UncertainTables::PLAN }
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
    let rows = cells(bands(uncertain(&all()), DisplayUnits::new(&none, "si")));
    // Margins are only in the figure.
    assert_eq!(rows.len(), 2);
    assert!(rows.iter().all(|row| row.last().unwrap() == "3"), "{rows:?}");
    let over = |row: &[String]| row.iter().filter(|cell| cell.starts_with("over ")).count();
    assert_eq!((over(&rows[0]), over(&rows[1])), (0, 1), "{rows:?}");
    let rows = cells(owed(uncertain(&all())));
    assert_eq!(rows[0][2..], ["70 / 75", "– / 25", "75"]);
}

#[test]
fn bars_are_drawn_of_several_inputs() {
    let figure_of_all = figure(uncertain(&all()), "a well").expect("a figure");
    assert_eq!(figure_of_all.panels.len(), 2);
    let mut one = all();
    one.inputs.truncate(1);
    assert_eq!(figure(uncertain(&one), "a well"), None);
}
