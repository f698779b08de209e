//! The limits on a plan's page: the nearest of each kind, severities with words.

use wholestring::operation::OperationKind;
use wholestring_judge::CheckKind;
use wholestring_results::{PlanCheck, PlanOperation, PlanSurfaceLimit};

use super::Plan;
use crate::{
    Grid, Severity, StudyPart, Verdict, cell::four, check_row::printed, grid_cells::head,
    plots::DisplayUnits, shown_dimension,
};

/// Limits with a load and a capacity.
fn limits(plan: &Plan) -> impl Iterator<Item = &PlanCheck> {
    plan.summary.checks.iter().filter(|row| {
        let check = &row.check;
        [check.value, check.limit, check.factor, check.required].iter().all(Option::is_some)
    })
}

/// The operation in words, or the event of the dynamic part.
fn operation(row: &PlanCheck) -> String {
    match row.operation {
        PlanOperation::Event(event) => format!("{}, dynamics", event.label()),
        PlanOperation::Kind(kind) => kind.words().to_owned(),
    }
}

/// The checks that need attention, the most severe first, then the governing limit of each
/// operation that is not among them.
pub(super) fn verdicts(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let heads = ["verdict", "operation", "friction", "bit at", "finding"];
    let heads = heads.map(|name| head(name, true)).into();
    let (checks, governing) = (&plan.summary.checks, &plan.summary.governing);
    let severe = checks.iter().filter(|row| row.check.severity >= Severity::Warning);
    let mut rows: Vec<&PlanCheck> = severe.collect();
    rows.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    let others: Vec<&PlanCheck> = governing.iter().filter(|row| !rows.contains(row)).collect();
    rows.extend(others);
    let row = |row: &PlanCheck| {
        let plain = |text: String| (text, Verdict::None);
        let check = &row.check;
        let governs = if governing.contains(row) { ", governs" } else { "" };
        vec![
            (format!("{}{governs}", check.verdict.words()), Verdict::Judged(check.severity)),
            plain(format!("{}, {}", operation(row), row.model)),
            plain(row.friction.name().to_owned()),
            plain(display.depth(row.bit_depth_m)),
            plain(printed(&check.sentence_in(display.unit_set()))),
        ]
    };
    let rows: Vec<_> = rows.into_iter().map(row).collect();
    let caption = "Errors first, then warnings: the most severe check of each kind and operation, \
        over all models, depths and frictions. The limit that governs an operation has the least \
        reserve among those that break something or stop it.";
    (!rows.is_empty()).then(|| part("Verdict", caption.to_owned(), Grid { heads, rows }))
}

/// Kinds in their order.
fn kinds(plan: &Plan) -> Vec<CheckKind> {
    let mut kinds: Vec<CheckKind> = Vec::new();
    for limit in limits(plan) {
        if !kinds.contains(&limit.check.kind) {
            kinds.push(limit.check.kind);
        }
    }
    kinds
}

/// A row for each kind, a column for each operation: the least factor of all depths and frictions.
pub(super) fn factors(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let words = |operation: OperationKind| operation.words().to_owned();
    let mut operations: Vec<String> = plan.operations().map(words).collect();
    for operation in limits(plan).map(operation) {
        if !operations.contains(&operation) {
            operations.push(operation);
        }
    }
    let mut heads = vec![head("limit", true), head("required", false)];
    heads.extend(operations.iter().map(|operation| head(operation.clone(), false)));
    let row = |kind: CheckKind| {
        let of_kind = || limits(plan).filter(|limit| limit.check.kind == kind);
        let required = of_kind().next().and_then(|limit| limit.check.required);
        let mut cells =
            vec![(kind.label().to_owned(), Verdict::None), (two(required), Verdict::None)];
        cells.extend(operations.iter().map(|words| {
            match of_kind().find(|limit| operation(limit) == *words) {
                Some(PlanCheck { check, .. }) => {
                    let place = check.md_m.map(|md_m| format!(", {}", display.depth(md_m)));
                    let (factor, verdict) = (two(check.factor), check.verdict.words());
                    let text = format!("{factor} {verdict}{}", place.unwrap_or_default());
                    (text, Verdict::Judged(check.severity))
                }
                None => (String::new(), Verdict::None),
            }
        }));
        cells
    };
    let rows: Vec<_> = kinds(plan).into_iter().map(row).collect();
    let mut caption =
        "Least factor, capacity over load, of all depths and frictions, and its place \
        in the string. Marginal: \
        the required factor is met by less than a tenth; exceeded: the load is larger than the \
        capacity. An empty cell: no load."
            .to_owned();
    let unchecked = plan.texts(&plan.summary.unchecked, display.unit_set());
    let unchecked: Vec<String> = unchecked.collect();
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
    let least = |kind: CheckKind| {
        let of_kind = limits(plan).filter(|limit| limit.check.kind == kind);
        of_kind.min_by(|a, b| a.check.reserve().total_cmp(&b.check.reserve()))
    };
    let mut nearest: Vec<&PlanCheck> = kinds(plan).into_iter().filter_map(least).collect();
    nearest.sort_by(|a, b| {
        let [(a_continues, a_reserve), (b_continues, b_reserve)] =
            [a, b].map(|row| (!row.check.kind.stops(), row.check.reserve()));
        a_continues.cmp(&b_continues).then(a_reserve.total_cmp(&b_reserve))
    });
    let row = |row: &PlanCheck| {
        let check = &row.check;
        let place = match check.md_m {
            Some(md_m) => {
                let component = check.component.as_deref().unwrap_or_default();
                format!("{component}, {}", display.depth(md_m))
            }
            None => "whole string, rig".to_owned(),
        };
        let dimension = shown_dimension(check.kind.quantity());
        let quantity = |si: Option<f64>| {
            let value = display.value(si.unwrap_or(f64::NAN), dimension);
            format!("{} {}", four(value), display.symbol(dimension))
        };
        let plain = |text: String| (text, Verdict::None);
        vec![
            plain(check.kind.label().to_owned()),
            (check.verdict.words().to_owned(), Verdict::Judged(check.severity)),
            plain(operation(row)),
            plain(row.friction.name().to_owned()),
            plain(place),
            plain(display.depth(row.bit_depth_m)),
            plain(quantity(check.value)),
            plain(quantity(check.limit)),
            plain(two(check.factor)),
            plain(two(check.required)),
        ]
    };
    let rows: Vec<_> = nearest.into_iter().map(row).collect();
    let caption = "For each kind, the operation, friction and place with the least reserve. Limits \
        that break something or stop the operation are listed first, the least reserve at the top; \
        buckling and the requested overpull follow.";
    (!rows.is_empty()).then(|| part("Nearest limits", caption.to_owned(), Grid { heads, rows }))
}

/// A factor in two decimals; large ones as "over 100".
fn two(factor: Option<f64>) -> String {
    match factor.filter(|factor| !factor.is_nan()) {
        None => "–".to_owned(),
        Some(factor) if factor >= 100.0 => "over 100".to_owned(),
        Some(factor) => format!("{factor:.2}"),
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

// Limits of hook load and torque at the surface.

/// A limit beyond the curves by more than this factor is written, not drawn, because it would
/// flatten them.
pub(super) const FAR: f64 = 1.35;

/// Title of the line of a limit: `hoist`, `pipe, torsion`, ...
pub fn surface_limit_title(limit: &PlanSurfaceLimit) -> &str {
    match CheckKind::named(&limit.kind) {
        Some(CheckKind::Hoist) => "hoist",
        Some(CheckKind::Tension) => "pipe, tension",
        Some(CheckKind::Torsion) => "pipe, torsion",
        Some(CheckKind::MakeUp) => "make-up",
        Some(CheckKind::TopDrive) => "top drive",
        Some(CheckKind::TopDrivePeak) => "top drive, peak",
        _ => &limit.kind,
    }
}

/// Whether a limit is drawn with curves up to this value, N or N·m.
pub fn surface_limit_is_near(limit: &PlanSurfaceLimit, largest: f64) -> bool {
    limit.allowed <= FAR * largest
}
