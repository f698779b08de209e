//! `[bit.table]`: a measured law, from the case or from a file that it names.

use std::f64::consts::PI;

use serde_json::json;
use wholestring::dynamics::{BitTable as Points, TableFault, TablePoint};

use super::file::{self, MAX};
use wholestring_config::prelude::*;
use wholestring_units::UnitSet;

table! {
    /// A measured law: rate of penetration and torque against weight on bit and rotary speed of the
    /// bit, every weight at every speed. Between its points the law is bilinear; a run that leaves
    /// the table uses its edge, with a warning.
    PointsTable in "[bit.table]" {
        /// CSV file, relative to the case: a line of column names, then a line for each point.
        /// Columns weight_on_bit_N, rotary_speed_rpm, rate_of_penetration_m_per_h, torque_N_m, and
        /// optionally the standard deviations torque_std_N_m and weight_on_bit_std_N, which become
        /// noise; other columns are ignored.
        file: String = optional(Text);
        /// The same in the case, in place of a file: [weight, speed, rate, torque], or with the
        /// standard deviation of the torque, or of torque and weight, after them. Bare numbers are
        /// in N, rev/min, m/h, N.m, N.m and N.
        points: Vec<Spanned<TablePoint>> = optional(List::of(PointRule, "points", MAX));
    }
}

/// A point in the case.
pub(super) struct PointRule;

impl PointRule {
    const NAMES: [&str; 6] = [
        "weight on bit",
        "rotary speed",
        "rate of penetration",
        "torque",
        "torque's deviation",
        "weight's deviation",
    ];

    fn cells() -> [Quantity; 6] {
        let torque = Quantity::si(Dimension::Torque, Range::from_to(0.0, 1e6), "3.1 kN.m");
        let force = |range| Quantity::si(Dimension::Force, range, "60 kN");
        [
            force(Range::positive_to(5e6)),
            Quantity::si(Dimension::RotarySpeed, Range::positive_to(1000.0 * PI / 30.0), "120 rpm")
                .bare("rev/min", PI / 30.0),
            Quantity::si(Dimension::RateOfPenetration, Range::from_to(0.0, 0.3), "10 m/h")
                .bare("m/h", 1.0 / 3600.0),
            torque,
            torque,
            force(Range::from_to(0.0, 5e6)),
        ]
    }
}

impl Rule for PointRule {
    type Value = TablePoint;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<TablePoint> {
        const EXPECTED: &str = "expected [weight, speed, rate, torque]";
        let items = match &node.value {
            Value::List(items) if (4..=6).contains(&items.len()) => items,
            other => {
                let message = match other {
                    Value::List(items) => format!("this point has {} numbers", items.len()),
                    other => format!("a point is four to six numbers, found {}", other.noun()),
                };
                return Diagnostic::error(message).at(node.place, EXPECTED).refuse(reader);
            }
        };
        let mut values = [None; 6];
        let cells = Self::cells().into_iter().zip(Self::NAMES).zip(items);
        for (i, ((cell, name), item)) in cells.enumerate() {
            reader.key = name;
            values[i] = Some(cell.read(item, reader)?);
        }
        Some(TablePoint {
            weight_on_bit_N: values[0]?,
            rotary_speed_rad_per_s: values[1]?,
            rate_of_penetration_m_per_s: values[2]?,
            torque_N_m: values[3]?,
            torque_std_N_m: values[4],
            weight_on_bit_std_N: values[5],
        })
    }

    fn schema(&self) -> serde_json::Value {
        let cells: Vec<_> = Self::cells().iter().map(Rule::schema).collect();
        json!({ "type": "array", "prefixItems": cells, "minItems": 4, "maxItems": 6 })
    }
}

impl PointsTable {
    pub(super) fn build(
        &self,
        place: Span,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<Points> {
        let points = match (self.file.optional()?, self.points.optional()?) {
            (Some(file), None) => file::read(file, files, reader)?,
            (None, Some(points)) => points.value.clone(),
            (Some(file), Some(points)) => {
                return Diagnostic::error("the table of the bit is given twice")
                    .at(points.place, "`points` in the case")
                    .at(file.place, "`file` in addition")
                    .help("keep one of the two")
                    .refuse(reader);
            }
            (None, None) => {
                return Diagnostic::error("[bit.table] has no points")
                    .at(place, "`file` or `points` is missing")
                    .help(
                        "file = \"bit.csv\", or points = [[\"60 kN\", 120, \"10 m/h\", \"3 \
                               kN.m\"]]",
                    )
                    .refuse(reader);
            }
        };
        let list: Vec<TablePoint> = points.iter().map(|at| at.value).collect();
        match Points::new(&list) {
            Ok(table) => Some(table),
            Err(fault) => {
                reader.report(no_table(&fault, &points, place, reader.units()));
                None
            }
        }
    }
}

fn no_table(
    fault: &TableFault,
    points: &[Spanned<TablePoint>],
    whole: Span,
    units: UnitSet,
) -> Diagnostic {
    let at = |line: usize| points.get(line - 1).map_or(whole, |at| at.place);
    match *fault {
        TableFault::Twice { first, second } => {
            Diagnostic::error("two points have the same weight on bit and rotary speed")
                .at(at(second), "again here")
                .at(at(first), "first here")
        }
        TableFault::Missing { weight_on_bit_N, rotary_speed_rad_per_s } => {
            Diagnostic::error("the table has a gap: every weight needs every speed").at(
                whole,
                format!(
                    "no point for {} at {} rev/min",
                    shown(Dimension::Force, weight_on_bit_N, units),
                    number_text(rotary_speed_rad_per_s * 30.0 / PI)
                ),
            )
        }
        TableFault::Spread { line } => {
            Diagnostic::error("a standard deviation is given at some points but not at others")
                .at(at(line), "not as the first point")
        }
        TableFault::Number { line } => {
            Diagnostic::error("weight and speed must be positive, and no number negative")
                .at(at(line), "out of range")
        }
        TableFault::Empty => Diagnostic::error("the table of the bit is empty").at(whole, ""),
    }
}
