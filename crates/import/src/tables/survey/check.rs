//! The positions of a file against those that follow from its angles.

use wholestring::well::{Interpolation, Path};
use wholestring_tabular::{ImportedSurvey, StatedPosition};

use crate::fragment::Note;

/// Angles are written to 0.01 deg: half of that in inclination and in azimuth, were it all to one side,
/// turns the hole by 1.23e-4; and positions are written to a tenth. Rounding cannot do more.
const ROUNDED_M_PER_M: f64 = 1.25e-4;
const ROUNDED_M: f64 = 0.1;

/// What two rounded angles of 0.01 deg make of a turn, rad, and a severity written to 0.01 deg/30 m.
const ROUNDED_TURN_RAD: f64 = 0.015 * std::f64::consts::PI / 180.0;
const ROUNDED_SEVERITY_RAD_PER_M: f64 = 0.01 * std::f64::consts::PI / 180.0 / 30.0;

/// A foot, m, and how near a ratio comes to it that is its.
const FOOT_M: f64 = 0.3048;
const NEAR: f64 = 0.01;

/// The largest differences from what the file says; nothing where it says nothing.
pub(super) fn check(survey: &ImportedSurvey) -> Vec<Note> {
    let Ok(path) = Path::new(&survey.stations, Interpolation::MinimumCurvature, survey.start())
    else {
        return Vec::new();
    };
    let points: Vec<_> = survey.stations.iter().map(|of| path.at(of.md_m)).collect();
    type Said = fn(&StatedPosition) -> Option<f64>;
    let position: [(&str, Said, usize); 3] = [
        ("true vertical depth", |of| of.tvd_m, 2),
        ("north", |of| of.north_m, 0),
        ("east", |of| of.east_m, 1),
    ];
    let mut notes = Vec::new();
    let mut within: Vec<String> = Vec::new();
    for (name, said, axis) in position {
        let computed = points.iter().map(|point| point.position_m[axis]);
        let pairs: Vec<(f64, f64, f64)> = survey
            .stations
            .iter()
            .zip(&survey.stated)
            .zip(computed)
            .filter_map(|((station, stated), computed)| {
                Some((station.md_m, said(stated)?, computed))
            })
            .collect();
        let Some(worst) = worst(&pairs) else { continue };
        if worst.difference_m.abs() <= worst.rounding_m {
            within.push(format!("{name} by {:.2} m", largest(&pairs)));
        } else {
            notes.push(Note::Checked(format!(
                "{name} of the file is {:.2} m {} than what follows from its angles by minimum \
                 curvature, at {:.1} m: rounding makes {:.2} m at most{}",
                worst.difference_m.abs(),
                if worst.difference_m > 0.0 { "more" } else { "less" },
                worst.md_m,
                worst.rounding_m,
                worst.reason(),
            )));
        }
    }
    if !within.is_empty() {
        let text = format!(
            "positions by minimum curvature differ from those of the file as rounding makes them: \
             {} at most",
            within.join(", ")
        );
        notes.insert(0, Note::Checked(text));
    }
    notes.extend(severity(survey, &points));
    notes
}

/// Where a column differs most.
struct Worst {
    md_m: f64,
    /// What the file has more, from its first station on.
    difference_m: f64,
    /// How much rounding makes there.
    rounding_m: f64,
    /// The file's way over the computed one.
    ratio: f64,
}

impl Worst {
    fn reason(&self) -> &'static str {
        let near = |value: f64| (self.ratio / value - 1.0).abs() < NEAR;
        if near(FOOT_M) || near(1.0 / FOOT_M) {
            "; they are to each other as feet to metres: is a unit wrong?"
        } else {
            "; another unit, another method, or stations that are missing? The case takes measured \
             depth, inclination and azimuth"
        }
    }
}

/// The row in which rounding explains least of the difference; rows are measured depth, the file's
/// and the computed position.
fn worst(pairs: &[(f64, f64, f64)]) -> Option<Worst> {
    let &(first_md_m, first_said, first_computed) = pairs.first()?;
    let rows = pairs.iter().map(|&(md_m, said, computed)| {
        let (said, computed) = (said - first_said, computed - first_computed);
        let rounding_m = ROUNDED_M + ROUNDED_M_PER_M * (md_m - first_md_m);
        Worst { md_m, difference_m: said - computed, rounding_m, ratio: said / computed }
    });
    let excess = |of: &Worst| of.difference_m.abs() / of.rounding_m;
    let rows = rows.filter(|of| of.difference_m.is_finite());
    rows.max_by(|a, b| excess(a).total_cmp(&excess(b)))
}

/// The largest difference, whatever explains it, m.
fn largest(pairs: &[(f64, f64, f64)]) -> f64 {
    let &(_, first_said, first_computed) = match pairs.first() {
        Some(first) => first,
        None => return 0.0,
    };
    let differences = pairs.iter().map(|of| (of.1 - first_said - (of.2 - first_computed)).abs());
    differences.fold(0.0, f64::max)
}

/// The largest difference of dogleg severities.
fn severity(survey: &ImportedSurvey, points: &[wholestring::well::PathPoint]) -> Option<Note> {
    let rows = survey.stations.windows(2).zip(points.windows(2)).zip(survey.stated.iter().skip(1));
    let differences = rows.filter_map(|((stations, points), stated)| {
        let said = stated.dogleg_severity_rad_per_m?;
        let length_m = stations[1].md_m - stations[0].md_m;
        let computed = points[0].dogleg_rad(&points[1]) / length_m;
        let rounding = ROUNDED_TURN_RAD / length_m + ROUNDED_SEVERITY_RAD_PER_M;
        Some((stations[1].md_m, (said - computed).abs(), rounding))
    });
    let excess = |of: &(f64, f64, f64)| of.1 / of.2;
    let (md_m, difference, rounding) =
        differences.max_by(|a, b| excess(a).total_cmp(&excess(b)))?;
    let shown = |value: f64| value.to_degrees() * 30.0;
    let ends = match difference <= rounding {
        true => "as rounding makes it",
        false => {
            "which is more than rounding makes: another unit, another method, or stations that are \
             missing?"
        }
    };
    Some(Note::Checked(format!(
        "dogleg severity differs from that of the file by {:.2} deg/30m at {md_m:.1} m, {ends}",
        shown(difference)
    )))
}
