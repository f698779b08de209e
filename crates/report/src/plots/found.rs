//! Errors and warnings that have a place along the string.

use super::{display::DisplayUnits, styles::CurveStyles};
use crate::{
    Severity,
    figure::{Key, Mark, Sample},
};

/// The findings of each level, the most severe last, so that it is above the others.
pub(super) struct Found(Vec<(Severity, Places)>);

/// Places of findings.
struct Places {
    /// Stretches of measured depth, m, apart from one another and downwards; one place has one
    /// depth twice.
    stretches: Vec<(f64, f64)>,
    /// Operations or runs of the findings, where there are several.
    whose: Vec<String>,
}

impl Found {
    pub(super) fn of(styles: &CurveStyles<'_>) -> Self {
        let places = |level: Severity| {
            let (mut stretches, mut whose) = (Vec::new(), Vec::new());
            for (run, solved) in styles.solved() {
                let of_level = solved.checks.iter().filter(|check| check.severity == level);
                let placed = of_level.filter_map(|of_level| {
                    let from = of_level.md_m?;
                    Some((from, of_level.to_md_m.unwrap_or(from)))
                });
                let before = stretches.len();
                stretches.extend(placed);
                if let (true, Some(name)) = (stretches.len() > before, styles.whose(run, solved))
                    && !whose.contains(&name)
                {
                    whose.push(name);
                }
            }
            (!stretches.is_empty()).then(|| Places { stretches: joined(stretches), whose })
        };
        let levels = [Severity::Warning, Severity::Error].into_iter();
        Self(levels.filter_map(|level| Some((level, places(level)?))).collect())
    }

    /// Marks at the places, for every track.
    pub(super) fn marks(&self, display: DisplayUnits<'_>) -> Vec<Mark> {
        let all = self.0.iter();
        let all = all.flat_map(|(level, places)| {
            places.stretches.iter().map(move |stretch| (level, stretch))
        });
        all.map(|(level, (from, to))| Mark::Found {
            level: *level,
            from: display.value(*from, "length"),
            to: display.value(*to, "length"),
        })
        .collect()
    }

    /// Their entries in a legend, the most severe first.
    pub(super) fn keys(&self) -> Vec<Key> {
        let key = |(level, places): &(Severity, Places)| {
            let name = match level {
                Severity::Error => "error here",
                Severity::Warning => "warning here",
                Severity::Note | Severity::Ok => "note here",
            };
            let name = match &places.whose[..] {
                [] => name.to_owned(),
                whose => format!("{name}: {}", whose.join(", ")),
            };
            Key { name, sample: Sample::Found(*level) }
        };
        self.0.iter().rev().map(key).collect()
    }
}

/// Stretches, with touching ones joined; a place within a stretch belongs to it.
fn joined(mut stretches: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut apart: Vec<(f64, f64)> = Vec::new();
    for (from, to) in stretches {
        match apart.last_mut() {
            Some(last) if from <= last.1 => last.1 = last.1.max(to),
            _ => apart.push((from, to)),
        }
    }
    apart
}

#[cfg(test)]
mod tests {
    use wholestring::operation::OperationKind;

    use super::*;
    use crate::{CheckRow, Packed, Report, Run, figure::Figure, page::tests::report, plots::plots};

    fn finding(severity: Severity, md_m: Option<f64>, to_md_m: Option<f64>) -> CheckRow {
        CheckRow {
            kind: "helical_buckling".into(),
            label: "Helical buckling".into(),
            severity,
            verdict: "exceeded".into(),
            component: String::new(),
            md_m,
            to_md_m,
            value: crate::Cell::Nothing,
            limit: crate::Cell::Nothing,
            factor: None,
            required: None,
            sentences: Default::default(),
        }
    }

    /// A report of operations with these findings, each with a curve of tension.
    fn solved(operations: &[(OperationKind, Vec<CheckRow>)]) -> Report {
        let mut report = report();
        let remove = report.solved.remove(0);
        let column = |values: &[f64]| Packed::single(values.iter().copied());
        report.solved = operations
            .iter()
            .map(|(operation, checks)| crate::Solved {
                operation: *operation,
                checks: checks.clone(),
                profile: [
                    ("md_m".into(), column(&[0.0, 500.0, 1000.0])),
                    ("tension_N".into(), column(&[1e5, -2e4, 0.0])),
                ]
                .into(),
                ..remove.clone()
            })
            .collect();
        report.runs.clear();
        report
    }

    fn tension(report: &Report) -> Figure {
        let run = Run { name: "", report };
        let plots = plots(&[run], "si");
        let tension = plots.into_iter().find(|plot| plot.name == "tension");
        tension.unwrap().figure
    }

    /// Buckled stretches are drawn below the curve of every track; overlapping ones of two models
    /// are joined.
    #[test]
    fn what_was_found_is_shaded_where_it_is() {
        let report = solved(&[
            (
                OperationKind::Slide,
                vec![
                    finding(Severity::Error, Some(300.0), Some(600.0)),
                    finding(Severity::Error, Some(550.0), Some(700.0)),
                    finding(Severity::Error, Some(900.0), None),
                    finding(Severity::Error, None, None),
                    finding(Severity::Note, Some(0.0), Some(1000.0)),
                ],
            ),
            (OperationKind::Drill, vec![finding(Severity::Warning, Some(100.0), Some(200.0))]),
        ]);
        let figure = tension(&report);
        let finding = |mark: &Mark| match mark {
            Mark::Found { level, from, to } => Some((*level, *from, *to)),
            _ => None,
        };
        let found: Vec<_> = figure.panels[0].marks.iter().filter_map(finding).collect();
        assert_eq!(
            found,
            [
                (Severity::Warning, 100.0, 200.0),
                (Severity::Error, 300.0, 700.0),
                (Severity::Error, 900.0, 900.0)
            ]
        );
        let names: Vec<&str> = figure.keys.iter().map(|key| key.name.as_str()).collect();
        assert!(names.ends_with(&["error here: slide", "warning here: drill"]), "{names:?}");
        // One ground for each stretch, none for a single place; bars for all three.
        let svg = figure.drawing().svg();
        assert_eq!(svg.matches("fill-opacity=\"0.1\"").count(), 2, "{svg}");
    }

    /// A single operation needs no name, and without findings there is no key.
    #[test]
    fn nothing_is_said_where_nothing_was_found() {
        let alone = |checks| tension(&solved(&[(OperationKind::Slide, checks)]));
        let has = |figure: &Figure, name: &str| figure.keys.iter().any(|key| key.name == name);
        let judged = alone(vec![finding(Severity::Error, Some(300.0), None)]);
        assert!(has(&judged, "error here"), "{:?}", judged.keys);
        let clean = alone(vec![finding(Severity::Error, None, None)]);
        assert!(!has(&clean, "error here"), "{:?}", clean.keys);
    }
}
