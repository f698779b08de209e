//! The table of the margins of a reach, and its page and picture, made from the files in its
//! folder.

use std::path::Path;

use wholestring::operation::OperationKind;
use wholestring_judge::DepthLimit;
use wholestring_plan::reach::OperationReach;
use wholestring_report::{Plot, REACH_PICTURES, Reach, reach_html, reach_plots};
use wholestring_results::{ReachMargin, ReachSummary, ResultsError, Row as _, Table};
use wholestring_units::UnitSet;

use crate::{
    page::read_rows,
    picture_table::{Entry, Row, with_rows},
    results_kind::Results,
};

/// Names of the tables, without their extensions.
pub(super) const REACH: &str = "reach";
pub(super) const LIMITS: &str = "reach_limits";

/// `reach.parquet`: a row for each margin at each depth. The results of the friction factors follow
/// each other; `None` is the case's own.
pub(super) fn reach_table(answers: &[(Option<f64>, &[OperationReach])]) -> Table {
    let mut rows = Vec::new();
    for (friction, reaches) in answers {
        for reach in *reaches {
            for curve in &reach.curves {
                let (force, torque) = (DepthLimit::Hoist.unit(), DepthLimit::TopDrive.unit());
                let of_unit =
                    |unit: &str, value: f64| (curve.limit.unit() == unit).then_some(value);
                let depths = reach.depth_m.iter().zip(&curve.margins);
                rows.extend(depths.map(|(depth_m, margin)| ReachMargin {
                    operation: reach.kind,
                    limit: curve.limit,
                    friction: *friction,
                    bit_depth_m: *depth_m,
                    margin: margin.margin,
                    force_N: of_unit(force, margin.load),
                    force_limit_N: of_unit(force, margin.bound),
                    torque_N_m: of_unit(torque, margin.load),
                    torque_limit_N_m: of_unit(torque, margin.bound),
                    md_m: margin.at_md_m,
                }));
            }
        }
    }
    ReachMargin::table(&rows)
}

/// Additional data of the picture: depths of the limits, and for uncertain inputs the bands of
/// margins and the bars of depths that contain 90 % of the samples.
pub(super) fn picture(margins: &Table, summary: &ReachSummary) -> Table {
    let mut rows: Vec<Row<'_>> = Vec::new();
    let named = |operation: Option<OperationKind>, limit: &str, friction: Option<f64>| {
        vec![
            ("operation", Entry::Word(operation.map_or("", OperationKind::name).to_owned())),
            ("limit", Entry::Word(limit.to_owned())),
            ("friction", Entry::Number(friction.unwrap_or(f64::NAN))),
        ]
    };
    for answer in &summary.frictions {
        for limit in &answer.limits {
            let Some(depth_m) = limit.depth_m else { continue };
            let first = answer.first.as_ref();
            let is_first = first.is_some_and(|first| {
                (&first.operation, &first.limit) == (&limit.operation, &limit.limit)
            });
            let mut row = named(Some(limit.operation), limit.limit.name(), answer.friction);
            row.extend([
                ("met_at_bit_depth_m", Entry::Number(depth_m)),
                ("stops_first", Entry::Number(f64::from(u8::from(is_first)))),
            ]);
            rows.push(row);
        }
    }
    let bands = summary.uncertain.iter().flat_map(|uncertain| &uncertain.bands);
    for band in bands.filter(|band| !band.limit.is_empty()) {
        let [low, .., high] = band.quantiles;
        let mut row = named(band.operation, &band.limit, band.friction);
        match band.quantity.as_str() {
            "margin" => row.extend([
                ("bit_depth_m", Entry::Number(band.bit_depth_m.unwrap_or(f64::NAN))),
                ("margin_p05", Entry::Number(low)),
                ("margin_p95", Entry::Number(high)),
            ]),
            "depth" if band.not_met < band.answers => {
                row.extend([("met_p05_m", Entry::Number(low)), ("met_p95_m", Entry::Number(high))])
            }
            _ => continue,
        }
        rows.push(row);
    }
    with_rows(margins, &rows)
}

// `report.html` and the picture of a reach, made from the files in its folder.

impl Results for Reach {
    const NOUN: &'static str = "a reach";
    const TABLE: &'static str = REACH;
    const PICTURES: &'static [&'static str] = &REACH_PICTURES;
    const WITH_NUMBERS: bool = true;

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        ReachSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = ReachSummary::read(&folder.join("summary.json"))?;
        Ok(Self::new(summary, &read_rows(folder, REACH)?, units))
    }

    fn html(&self) -> Option<String> {
        Some(reach_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        reach_plots(self, &self.head.units)
    }
}
