//! Comparison of the positions in a file with those computed from its angles.

use wholestring::well::{Interpolation, Path, PathPoint, Station};
use wholestring_units::{Dimension, UnitSet};

use super::{
    imported::StatedPosition,
    places::{depth, difference},
};

/// Maximum difference of positions from rounding per length. Angles are written to 0.01 deg: half
/// of that in inclination and in azimuth, always to the same side, turns the hole by 1.23e-4; and
/// positions are written to a tenth.
const ROUNDED_M_PER_M: f64 = 1.25e-4;
const ROUNDED_M: f64 = 0.1;

/// Error of a turn from two angles rounded to 0.01 deg, rad, and of a severity written to 0.01
/// deg/30 m.
const ROUNDED_TURN_RAD: f64 = 0.015 * std::f64::consts::PI / 180.0;
const ROUNDED_SEVERITY_RAD_PER_M: f64 = 0.01 * std::f64::consts::PI / 180.0 / 30.0;

/// A foot, m, and the relative tolerance within which a ratio is taken to be that of feet and
/// metres.
const FOOT_M: f64 = 0.3048;
const NEAR: f64 = 0.01;

/// A column of positions or doglegs of a file, compared with the computed ones.
#[derive(Debug, Clone, PartialEq)]
pub struct PositionCheck {
    /// Whether they differ by no more than rounding.
    pub agrees: bool,
    /// The station with the largest excess over rounding, counted from 0.
    pub index: usize,
    /// Their difference, in one sentence.
    pub sentence: String,
    /// Possible reason; empty if rounding explains the difference.
    pub reason: String,
}

/// Compares the positions of a file with those of a path through its stations, and its doglegs;
/// columns that the file lacks are skipped. `stated` has the positions in the file for each
/// station; `set` has the units of the sentences.
pub fn position_checks(
    stations: &[Station],
    stated: &[StatedPosition],
    path: &Path,
    set: UnitSet,
) -> Vec<PositionCheck> {
    let points: Vec<_> = stations.iter().map(|station| path.at(station.md_m)).collect();
    let curve = match path.interpolation() {
        Interpolation::MinimumCurvature => "minimum curvature",
        Interpolation::Spline => "the spline",
    };
    type Stated = fn(&StatedPosition) -> Option<f64>;
    let columns: [(&str, Stated, usize); 3] = [
        ("true vertical depth", |stated| stated.tvd_m, 2),
        ("north", |stated| stated.north_m, 0),
        ("east", |stated| stated.east_m, 1),
    ];
    let mut checks = Vec::new();
    let mut within: Vec<String> = Vec::new();
    for (name, stated_m, axis) in columns {
        let computed = points.iter().map(|point| point.position_m[axis]);
        let all = stations.iter().zip(stated).zip(computed).enumerate();
        let rows: Vec<Row> = all
            .filter_map(|(index, ((station, stated), computed_m))| {
                let stated_m = stated_m(stated)?;
                Some(Row { index, md_m: station.md_m, stated_m, computed_m })
            })
            .collect();
        // Positions are compared relative to the first, so that one alone cannot be compared.
        let Some(worst) = worst(&rows).filter(|_| rows.len() > 1) else { continue };
        if worst.difference_m.abs() <= worst.rounding_m {
            within.push(format!("{name} by {}", difference(largest(&rows), set)));
            continue;
        }
        checks.push(PositionCheck {
            agrees: false,
            index: worst.index,
            sentence: format!(
                "{name} of the file is {} {} than computed from its angles by {curve}, at {}: \
                 rounding explains at most {}",
                difference(worst.difference_m.abs(), set),
                if worst.difference_m > 0.0 { "more" } else { "less" },
                depth(worst.md_m, set),
                difference(worst.rounding_m, set),
            ),
            reason: worst.reason().to_owned(),
        });
    }
    if !within.is_empty() {
        let sentence = format!(
            "positions by {curve} agree with those of the file within rounding: {} at most",
            within.join(", ")
        );
        checks.insert(0, PositionCheck { agrees: true, index: 0, sentence, reason: String::new() });
    }
    checks.extend(severity(stations, stated, &points, set));
    checks
}

/// A position in the file and the computed one.
struct Row {
    index: usize,
    md_m: f64,
    stated_m: f64,
    computed_m: f64,
}

/// The row of the largest difference of a column.
struct Worst {
    index: usize,
    md_m: f64,
    /// Difference, file minus computed, relative to the first station.
    difference_m: f64,
    /// Allowance for rounding there.
    rounding_m: f64,
    /// Ratio of the file's distance to the computed one.
    ratio: f64,
}

impl Worst {
    fn reason(&self) -> &'static str {
        let near = |value: f64| (self.ratio / value - 1.0).abs() < NEAR;
        if near(FOOT_M) || near(1.0 / FOOT_M) {
            "their ratio is that of feet to metres: is a unit wrong?"
        } else {
            "another unit, another method, or missing stations? The case uses measured depth, \
             inclination and azimuth"
        }
    }
}

/// Returns the row whose difference exceeds rounding the most.
fn worst(rows: &[Row]) -> Option<Worst> {
    let first = rows.first()?;
    let rows = rows.iter().map(|row| {
        let (stated, computed) = (row.stated_m - first.stated_m, row.computed_m - first.computed_m);
        let rounding_m = ROUNDED_M + ROUNDED_M_PER_M * (row.md_m - first.md_m);
        Worst {
            index: row.index,
            md_m: row.md_m,
            difference_m: stated - computed,
            rounding_m,
            ratio: stated / computed,
        }
    });
    let excess = |worst: &Worst| worst.difference_m.abs() / worst.rounding_m;
    let rows = rows.filter(|row| row.difference_m.is_finite());
    rows.max_by(|a, b| excess(a).total_cmp(&excess(b)))
}

/// Largest difference, including rounding, m.
fn largest(rows: &[Row]) -> f64 {
    let Some(first) = rows.first() else { return 0.0 };
    let difference =
        |row: &Row| row.stated_m - first.stated_m - (row.computed_m - first.computed_m);
    rows.iter().map(|row| difference(row).abs()).fold(0.0, f64::max)
}

/// Largest difference of dogleg severities.
fn severity(
    stations: &[Station],
    stated: &[StatedPosition],
    points: &[PathPoint],
    set: UnitSet,
) -> Option<PositionCheck> {
    let rows = stations.windows(2).zip(points.windows(2)).zip(stated.iter().skip(1));
    let differences = rows.enumerate().filter_map(|(above, ((stations, points), stated))| {
        let stated_severity = stated.dogleg_severity_rad_per_m?;
        let length_m = stations[1].md_m - stations[0].md_m;
        let computed = points[0].dogleg_rad(&points[1]) / length_m;
        let rounding = ROUNDED_TURN_RAD / length_m + ROUNDED_SEVERITY_RAD_PER_M;
        Some((above + 1, (stated_severity - computed).abs(), rounding))
    });
    let excess = |row: &(usize, f64, f64)| row.1 / row.2;
    let (index, off, rounding) = differences.max_by(|a, b| excess(a).total_cmp(&excess(b)))?;
    let unit = Dimension::DoglegSeverity.unit_in(set);
    let text = format!(
        "dogleg severity differs from that of the file by {:.2} {} at {}",
        unit.from_si(off),
        unit.symbol,
        depth(stations[index].md_m, set)
    );
    let agrees = off <= rounding;
    Some(PositionCheck {
        agrees,
        index,
        sentence: match agrees {
            true => format!("{text}, within rounding"),
            false => format!("{text}, which exceeds rounding"),
        },
        reason: match agrees {
            true => String::new(),
            false => "another unit, another method, or missing stations?".to_owned(),
        },
    })
}
