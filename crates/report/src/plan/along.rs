//! The string along the hole on a plan's page: the standard table of each operation.

use wholestring::{operation::OperationKind, outcome::Buckling};
use wholestring_results::PlanStation;

use super::Plan;
use crate::{
    Grid, Head, StudyPart, Verdict,
    cell::four,
    grid_cells::{head, row},
    plots::DisplayUnits,
};

/// Meaning of the numbers.
const ABOUT: &str = "By the soft string with the expected friction and the bit at the deepest \
    depth. Tension is effective tension, negative in compression; side force is positive where the \
    string lies on the high side.";

/// A folded table for each operation with an answer.
pub(super) fn tables(plan: &Plan, display: DisplayUnits<'_>) -> Vec<StudyPart> {
    let table = |operation: OperationKind| {
        let stations = plan.along.iter().filter(|station| station.operation == operation);
        let rows: Vec<_> = stations.map(|station| cells(station, display)).collect();
        (!rows.is_empty()).then(|| {
            StudyPart::Folded(Box::new(StudyPart::Table {
                title: format!("Along the string, {}", operation.words()),
                caption: ABOUT.to_owned(),
                grid: Grid { heads: heads(display), rows },
                files: "plan_along".to_owned(),
                endings: &["csv", "parquet"],
            }))
        })
    };
    plan.operations().filter_map(table).collect()
}

fn heads(display: DisplayUnits<'_>) -> Vec<Head> {
    let number = |words: &str, dimension: &str| {
        head(format!("{words}, {}", display.symbol(dimension)), false)
    };
    vec![
        number("MD", "length"),
        number("TVD", "length"),
        number("inclination", "angle"),
        number("DLS", "dogleg severity"),
        head("component", true),
        number("tension", "force"),
        number("torque", "torque"),
        number("side force", "force per length"),
        number("stress", "stress"),
        head("of yield", false),
        head("buckling", true),
    ]
}

fn cells(station: &PlanStation, display: DisplayUnits<'_>) -> Vec<(String, Verdict)> {
    let number = |si: f64, dimension: &str| four(display.value(si, dimension));
    let depth = |si: f64| format!("{:.0}", display.value(si, "length"));
    row(vec![
        depth(station.md_m),
        depth(station.tvd_m),
        format!("{:.2}", display.value(station.inclination_rad, "angle")),
        format!("{:.2}", display.value(station.dogleg_severity_rad_per_m, "dogleg severity")),
        station.component.clone(),
        number(station.tension_N, "force"),
        number(station.torque_N_m, "torque"),
        number(station.side_force_N_per_m, "force per length"),
        number(station.von_mises_stress_Pa, "stress"),
        station.yield_use.map_or("–".to_owned(), |share| format!("{:.0} %", 100.0 * share)),
        match station.buckling {
            Buckling::None => String::new(),
            state => state.name().to_owned(),
        },
    ])
}
