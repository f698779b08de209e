//! The limits on a plan's page: the nearest of each kind, severities beside words.

use super::{Plan, PlanLimitRow, PlanVerdict};
use crate::grid_cells::head;
use crate::operation_words::{four, operation_name};
use crate::{Grid, StudyPart, Verdict, plots::Shown};

/// A sentence of the judge as a page prints its units.
fn printed(sentence: &str) -> String {
    sentence.replace("N.m", "N·m").replace("ft-lbf", "ft·lbf")
}

/// The checks that need attention, the most severe first. Their sentences are in the units of the
/// case, and so is all of a row.
pub(super) fn verdicts(plan: &Plan) -> Option<StudyPart> {
    let shown = Shown::new(&plan.head.dimensions, &plan.head.units);
    let heads = ["verdict", "check", "operation", "friction", "bit at", "what was found"];
    let heads = heads.map(|name| head(name, true)).into();
    let row = |found: &PlanVerdict| {
        let plain = |text: String| (text, Verdict::None);
        vec![
            (found.verdict.clone(), Verdict::Judged(found.severity)),
            plain(found.label.clone()),
            plain(format!("{}, {}", operation_name(&found.operation), found.model)),
            plain(found.friction.clone()),
            plain(shown.depth(found.bit_depth_m)),
            plain(printed(&found.sentence)),
        ]
    };
    let rows: Vec<_> = plan.checks.iter().map(row).collect();
    let caption = "Of each kind of check and each operation the most severe of all models, depths and \
        frictions.";
    (!rows.is_empty()).then(|| part("Verdict", caption.to_owned(), Grid { heads, rows }))
}

/// The governing limit of each operation, from sentences that begin with the operation.
pub(super) fn governing(sentences: &[String]) -> Option<StudyPart> {
    let heads = vec![head("operation", true), head("limit", true)];
    let plain = |text: &str| (printed(text.trim_end_matches('.')), Verdict::None);
    let row = |sentence: &String| {
        let (operation, limit) = sentence.split_once(": ").unwrap_or(("", sentence));
        vec![plain(operation), plain(limit)]
    };
    let rows: Vec<_> = sentences.iter().map(row).collect();
    let caption = "Of each operation the limit with the least reserve of those that break \
        something or stop it, of all depths and frictions.";
    (!rows.is_empty()).then(|| part("Governing limits", caption.to_owned(), Grid { heads, rows }))
}

/// Kinds in their order.
fn kinds(plan: &Plan) -> Vec<&str> {
    let mut kinds: Vec<&str> = Vec::new();
    for of in &plan.limits {
        if !kinds.contains(&of.kind.as_str()) {
            kinds.push(&of.kind);
        }
    }
    kinds
}

/// A row for each kind, a column for each operation: the least factor of all depths and frictions.
pub(super) fn factors(plan: &Plan) -> Option<StudyPart> {
    let mut operations = plan.operations();
    for of in &plan.limits {
        if !operations.contains(&of.operation.as_str()) {
            operations.push(&of.operation);
        }
    }
    let mut heads = vec![head("limit", true), head("required", false)];
    heads.extend(operations.iter().map(|of| head(operation_name(of), false)));
    let row = |kind: &str| {
        let of_kind = || plan.limits.iter().filter(|of| of.kind == kind);
        let required = of_kind().next().map_or(f64::NAN, |of| of.required);
        let mut cells = vec![(kind.to_owned(), Verdict::None), (two(required), Verdict::None)];
        cells.extend(operations.iter().map(|operation| {
            match of_kind().find(|of| of.operation == *operation) {
                Some(of) => {
                    (format!("{} {}", two(of.factor), of.verdict), Verdict::Judged(of.severity))
                }
                None => (String::new(), Verdict::None),
            }
        }));
        cells
    };
    let rows: Vec<_> = kinds(plan).into_iter().map(row).collect();
    let mut caption = "Least factor, capacity over load, of all depths and frictions. Marginal: the \
        required factor is kept by less than a tenth; exceeded: the load is larger than the capacity. An \
        empty cell: nothing loads it."
        .to_owned();
    if !plan.unchecked.is_empty() {
        caption += &format!(" Not checked for want of data: {}.", plan.unchecked.join("; "));
    }
    (!rows.is_empty()).then(|| part("Limits", caption, Grid { heads, rows }))
}

/// Where each kind is nearest to its limit.
pub(super) fn nearest(plan: &Plan, shown: Shown<'_>) -> Option<StudyPart> {
    let heads = vec![
        head("limit", true),
        head("verdict", true),
        head("operation", true),
        head("friction", true),
        head("where", true),
        head("bit at", false),
        head("load", false),
        head("capacity", false),
        head("factor", false),
        head("required", false),
    ];
    let least = |kind: &str| {
        let of_kind = plan.limits.iter().filter(|of| of.kind == kind);
        of_kind.min_by(|a, b| reserve(a).total_cmp(&reserve(b)))
    };
    let mut nearest: Vec<&PlanLimitRow> = kinds(plan).into_iter().filter_map(least).collect();
    let order = |of: &PlanLimitRow| (!of.breaks, reserve(of));
    nearest.sort_by(|a, b| {
        let ((a, of_a), (b, of_b)) = (order(a), order(b));
        a.cmp(&b).then(of_a.total_cmp(&of_b))
    });
    let row = |of: &PlanLimitRow| {
        let place = match of.md_m {
            Some(md_m) => format!("{}, {}", of.component, shown.depth(md_m)),
            None => "whole string, rig".to_owned(),
        };
        let quantity = |si: f64| {
            format!("{} {}", four(shown.value(si, &of.dimension)), shown.symbol(&of.dimension))
        };
        let plain = |text: String| (text, Verdict::None);
        vec![
            plain(of.kind.clone()),
            (of.verdict.clone(), Verdict::Judged(of.severity)),
            plain(operation_name(&of.operation)),
            plain(of.friction.clone()),
            plain(place),
            plain(shown.depth(of.bit_depth_m)),
            plain(quantity(of.load)),
            plain(quantity(of.capacity)),
            plain(two(of.factor)),
            plain(two(of.required)),
        ]
    };
    let rows: Vec<_> = nearest.into_iter().map(row).collect();
    let caption = "Of each kind the operation, friction and place with the least reserve. Limits \
        that break something or stop the operation come first, the least reserve at the top; buckling and \
        the requested overpull follow.";
    (!rows.is_empty()).then(|| part("Nearest limits", caption.to_owned(), Grid { heads, rows }))
}

fn reserve(of: &PlanLimitRow) -> f64 {
    of.factor / of.required
}

/// A factor in two decimals; large ones are large.
fn two(factor: f64) -> String {
    match factor {
        factor if factor.is_nan() => "–".to_owned(),
        factor if factor >= 100.0 => "over 100".to_owned(),
        factor => format!("{factor:.2}"),
    }
}

fn part(title: &str, caption: String, grid: Grid) -> StudyPart {
    StudyPart::Table {
        title: title.to_owned(),
        caption,
        grid,
        files: "plan_limits".to_owned(),
        endings: &["csv", "parquet"],
    }
}
