//! The limits on a plan's page: the nearest of each kind, severities with words.

use wholestring::operation::OperationKind;

use super::{Plan, PlanLimitRow, PlanVerdict};
use crate::digits::four;
use crate::grid_cells::head;
use crate::{Grid, StudyPart, Verdict, check_row::printed, plots::DisplayUnits};

/// The checks that need attention, the most severe first, then the governing limit of each
/// operation.
pub(super) fn verdicts(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let heads = ["verdict", "operation", "friction", "bit at", "finding"];
    let heads = heads.map(|name| head(name, true)).into();
    let row = |found: &PlanVerdict| {
        let plain = |text: String| (text, Verdict::None);
        let governs = if found.governs { ", governs" } else { "" };
        vec![
            (format!("{}{governs}", found.verdict), Verdict::Judged(found.severity)),
            plain(format!("{}, {}", found.operation, found.model)),
            plain(found.friction.name().to_owned()),
            plain(display.depth(found.bit_depth_m)),
            plain(printed(display.chosen::<String>(&found.sentences))),
        ]
    };
    let rows: Vec<_> = plan.checks.iter().map(row).collect();
    let caption = "Errors first, then warnings: the most severe check of each kind and operation, \
        over all models, depths and frictions. The limit that governs an operation has the least \
        reserve among those that break something or stop it.";
    (!rows.is_empty()).then(|| part("Verdict", caption.to_owned(), Grid { heads, rows }))
}

/// Kinds in their order.
fn kinds(plan: &Plan) -> Vec<&str> {
    let mut kinds: Vec<&str> = Vec::new();
    for limit in &plan.limits {
        if !kinds.contains(&limit.kind.as_str()) {
            kinds.push(&limit.kind);
        }
    }
    kinds
}

/// A row for each kind, a column for each operation: the least factor of all depths and frictions.
pub(super) fn factors(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let mut operations: Vec<&str> =
        plan.operations().into_iter().map(OperationKind::words).collect();
    for limit in &plan.limits {
        if !operations.contains(&limit.operation.as_str()) {
            operations.push(&limit.operation);
        }
    }
    let mut heads = vec![head("limit", true), head("required", false)];
    heads.extend(operations.iter().map(|operation| head((*operation).to_owned(), false)));
    let row = |kind: &str| {
        let of_kind = || plan.limits.iter().filter(|limit| limit.kind == kind);
        let required = of_kind().next().map_or(f64::NAN, |of_kind| of_kind.required);
        let mut cells = vec![(kind.to_owned(), Verdict::None), (two(required), Verdict::None)];
        cells.extend(operations.iter().map(|operation| {
            match of_kind().find(|of_kind| of_kind.operation == *operation) {
                Some(row) => {
                    (format!("{} {}", two(row.factor), row.verdict), Verdict::Judged(row.severity))
                }
                None => (String::new(), Verdict::None),
            }
        }));
        cells
    };
    let rows: Vec<_> = kinds(plan).into_iter().map(row).collect();
    let mut caption = "Least factor, capacity over load, of all depths and frictions. Marginal: \
        the required factor is met by less than a tenth; exceeded: the load is larger than the \
        capacity. An empty cell: no load."
        .to_owned();
    let unchecked = display.chosen(&plan.unchecked);
    if !unchecked.is_empty() {
        caption += &format!(" Not checked for want of data: {}.", unchecked.join("; "));
    }
    (!rows.is_empty()).then(|| part("Limits", caption, Grid { heads, rows }))
}

/// The place nearest to the limit, for each kind.
pub(super) fn nearest(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
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
        let of_kind = plan.limits.iter().filter(|limit| limit.kind == kind);
        of_kind.min_by(|a, b| reserve(a).total_cmp(&reserve(b)))
    };
    let mut nearest: Vec<&PlanLimitRow> = kinds(plan).into_iter().filter_map(least).collect();
    let order = |row: &PlanLimitRow| (!row.breaks, reserve(row));
    nearest.sort_by(|a, b| {
        let ((a, of_a), (b, of_b)) = (order(a), order(b));
        a.cmp(&b).then(of_a.total_cmp(&of_b))
    });
    let row = |row: &PlanLimitRow| {
        let place = match row.md_m {
            Some(md_m) => format!("{}, {}", row.component, display.depth(md_m)),
            None => "whole string, rig".to_owned(),
        };
        let quantity = |si: f64| {
            format!(
                "{} {}",
                four(display.value(si, &row.dimension)),
                display.symbol(&row.dimension)
            )
        };
        let plain = |text: String| (text, Verdict::None);
        vec![
            plain(row.kind.clone()),
            (row.verdict.clone(), Verdict::Judged(row.severity)),
            plain(row.operation.clone()),
            plain(row.friction.name().to_owned()),
            plain(place),
            plain(display.depth(row.bit_depth_m)),
            plain(quantity(row.load)),
            plain(quantity(row.capacity)),
            plain(two(row.factor)),
            plain(two(row.required)),
        ]
    };
    let rows: Vec<_> = nearest.into_iter().map(row).collect();
    let caption = "For each kind, the operation, friction and place with the least reserve. Limits \
        that break something or stop the operation are listed first, the least reserve at the top; \
        buckling and the requested overpull follow.";
    (!rows.is_empty()).then(|| part("Nearest limits", caption.to_owned(), Grid { heads, rows }))
}

fn reserve(row: &PlanLimitRow) -> f64 {
    row.factor / row.required
}

/// A factor in two decimals; large ones as "over 100".
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
