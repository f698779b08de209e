//! Tables of a plan's page.

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_results::PlanPoint;

use super::{
    Plan,
    curves::{buckling_weights_N, hook_load_N, surface_torque_N_m},
    mud::{STATES, at_shoe_kg_per_m3, has_shoe},
};
use crate::{
    Grid, StudyPart, Verdict,
    cell::four,
    grid_cells::{head, row},
    plots::DisplayUnits,
};

/// Number of reasons that are listed; further ones are counted.
const REASONS: usize = 8;

type Row = Vec<(String, Verdict)>;

fn part(title: String, caption: &str, grid: Grid, files: &str) -> StudyPart {
    StudyPart::Table {
        title,
        caption: caption.to_owned(),
        grid,
        files: files.to_owned(),
        endings: &["csv", "parquet"],
    }
}

/// The levels of friction.
pub(super) fn frictions(plan: &Plan) -> StudyPart {
    let heads = vec![head("friction", true), head("coefficients along the hole", true)];
    let rows = plan.levels.iter();
    let rows = rows.map(|level| row(vec![level.name().to_owned(), level.sections.join("; ")]));
    part(
        "Friction".into(),
        "Low, expected and high friction of this plan.",
        Grid { heads, rows: rows.collect() },
        "plan_friction",
    )
}

/// Every operation at the deepest depth.
pub(super) fn at_depth(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let depth_m =
        plan.curves().filter_map(|curve| curve.points.last().copied()).last()?.bit_depth_m;
    let block_N = plan.summary.block_weight_N();
    let (force, torque) = (display.symbol("force"), display.symbol("torque"));
    let mut heads = vec![
        head("operation", true),
        head("friction", true),
        head("model", true),
        head(format!("hook load, {force}"), false),
    ];
    heads.extend(block_N.map(|_| head(format!("with block, {force}"), false)));
    heads.extend([
        head(format!("surface torque, {torque}"), false),
        head("buckling", true),
        head("most severe check", true),
    ]);
    let rows = plan.curves().filter_map(|curve| {
        let point = curve.points.last()?;
        let hook_load_N = hook_load_N(point);
        let quantity = |si: f64, dimension: &str| four(display.value(si, dimension));
        let mut cells = vec![
            curve.operation.words().to_owned(),
            format!("{}, {}", curve.level.name(), curve.level.label),
            curve.model.name().to_owned(),
            quantity(hook_load_N, "force"),
        ];
        cells.extend(block_N.map(|block| quantity(hook_load_N + block, "force")));
        let worst = point.worst.as_ref().map_or_else(String::new, |worst| {
            format!("{}: {}", worst.severity.name(), worst.kind.label())
        });
        let buckling = point.buckling.clone().unwrap_or_default();
        cells.extend([quantity(surface_torque_N_m(point), "torque"), buckling, worst]);
        Some(row(cells))
    });
    let grid = Grid { heads, rows: rows.collect() };
    let title = format!("With the bit at {}", display.depth(depth_m));
    let caption =
        "Every operation at the deepest depth of the plan; the workbook has them all.".to_owned();
    let (files, endings) = ("plan".to_owned(), &["xlsx"][..]);
    Some(StudyPart::Table { title, caption, grid, files, endings })
}

/// A number of every operation with every friction against depth, for each model.
pub(super) fn against_depth(plan: &Plan, display: DisplayUnits<'_>) -> Vec<StudyPart> {
    let mut parts = Vec::new();
    for model in &plan.summary.models {
        let hook = grid(plan, display, *model, "force", hook_load_N, |_| true);
        parts.push(part(
            format!("Hook load without block, {}, {model} string", display.symbol("force")),
            "Against the depth of the bit.",
            hook,
            "plan_broomstick",
        ));
        let torque =
            grid(plan, display, *model, "torque", surface_torque_N_m, OperationKind::rotates);
        if torque.heads.len() > 1 {
            parts.push(part(
                format!("Surface torque, {}, {model} string", display.symbol("torque")),
                "Against the depth of the bit.",
                torque,
                "plan_broomstick",
            ));
        }
    }
    parts
}

fn grid(
    plan: &Plan,
    display: DisplayUnits<'_>,
    model: ModelKind,
    dimension: &str,
    number: fn(&PlanPoint) -> f64,
    is_shown: fn(OperationKind) -> bool,
) -> Grid {
    let mut heads = vec![head(format!("bit depth, {}", display.symbol("length")), false)];
    let mut columns = Vec::new();
    // Trip in to the left, trip out to the right, then operations that drill.
    let mut operations: Vec<OperationKind> = plan.operations().collect();
    operations.sort_by_key(|operation| (operation.on_bottom(), order(*operation)));
    for operation in operations.into_iter().filter(|operation| is_shown(*operation)) {
        for curve in plan.curves_of(model, operation) {
            heads.push(head(format!("{} {}", operation.words(), curve.level.label), false));
            columns.push(curve);
        }
    }
    let rows = columns.first().map_or(0, |first| first.points.len());
    let rows = (0..rows).map(|place| {
        let depth_m = columns[0].points[place].bit_depth_m;
        let mut cells = vec![format!("{:.0}", display.value(depth_m, "length"))];
        cells.extend(columns.iter().map(|curve| {
            let value = curve.points.get(place).map_or(f64::NAN, |point| number(point));
            four(display.value(value, dimension))
        }));
        row(cells)
    });
    Grid { heads, rows: rows.collect() }
}

fn order(operation: OperationKind) -> u8 {
    match operation {
        OperationKind::TripIn | OperationKind::Ream => 0,
        OperationKind::RotateOffBottom => 1,
        _ => 2,
    }
}

/// Weights to buckle against depth, with the expected friction.
pub(super) fn buckling(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let force = display.symbol("force");
    let curves = plan.buckling_curves();
    let curves = curves.filter(|curve| curve.level.friction == FrictionLevel::Expected);
    let curves: Vec<_> = curves.collect();
    let first = curves.first()?;
    let mut heads = vec![head(format!("bit depth, {}", display.symbol("length")), false)];
    for curve in &curves {
        for shape in ["sinusoid", "helix"] {
            heads.push(head(format!("{}: {shape}", curve.operation.words()), false));
        }
    }
    let rows = (0..first.points.len()).map(|place| {
        let mut cells =
            vec![format!("{:.0}", display.value(first.points[place].bit_depth_m, "length"))];
        for curve in &curves {
            let point = curve.points.get(place);
            let weights_N = point.map_or([f64::NAN; 2], |point| buckling_weights_N(point));
            cells.extend(weights_N.map(|weight| four(display.value(weight, "force"))));
        }
        row(cells)
    });
    let grid = Grid { heads, rows: rows.collect() };
    let title = format!("Least weight on bit to buckle, {force}");
    Some(part(title, "With the expected friction.", grid, "plan_buckling"))
}

/// The mud against depth.
pub(super) fn mud(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let mud = &plan.summary.hydraulics;
    if mud.is_empty() {
        return None;
    }
    let has_shoe = has_shoe(mud);
    let mut heads = vec![
        head(format!("bit depth, {}", display.symbol("length")), false),
        head(format!("standpipe, {}", display.symbol("pressure")), false),
    ];
    for place in ["bit", "shoe"].into_iter().take(if has_shoe { 2 } else { 1 }) {
        heads.extend(STATES.iter().map(|state| head(format!("{place}: {state}"), false)));
    }
    let density = |value: f64| four(display.value(value, "density"));
    let rows = mud.iter().map(|mud_row| {
        let mut cells = vec![
            format!("{:.0}", display.value(mud_row.bit_depth_m, "length")),
            four(display.value(mud_row.standpipe_pressure_Pa, "pressure")),
        ];
        let densities = mud_row.densities().map(|(_, state)| state);
        cells.extend(densities.map(|state| density(state.bit_kg_per_m3)));
        if has_shoe {
            cells.extend(densities.map(|state| density(at_shoe_kg_per_m3(state))));
        }
        row(cells)
    });
    let grid = Grid { heads, rows: rows.collect() };
    let title = format!("Mud: equivalent density, {}", display.symbol("density"));
    let caption = "Pumps as while drilling, or as the first operation that circulates.";
    Some(part(title, caption, grid, "plan_hydraulics"))
}

/// Reason why a point has no answer.
fn message(plan: &Plan, point: &PlanPoint, display: DisplayUnits<'_>) -> Option<String> {
    let message = point.message.as_ref()?;
    Some(match &point.worst {
        Some(worst) if worst.sentence == *message => worst.sentence_in(display.unit_set()),
        _ => plan.summary.texts.in_units(message, display.unit_set()),
    })
}

/// Points without an answer, and the reasons.
pub(super) fn without_answer(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for curve in plan.curves() {
        for point in &curve.points {
            let Some(message) = message(plan, point, display) else { continue };
            let level = curve.level.name();
            let operation = curve.operation.words().to_owned();
            let text = format!("{operation}, {level} friction, {} string: {message}", curve.model);
            match reasons.iter_mut().find(|(reason, _)| *reason == text) {
                Some((_, count)) => *count += 1,
                None => reasons.push((text, 1)),
            }
        }
    }
    if reasons.is_empty() {
        return None;
    }
    let heads = vec![head("why", true), head("points", false)];
    let more: usize = reasons.iter().skip(REASONS).map(|(_, count)| count).sum();
    let mut rows: Vec<Row> = reasons
        .into_iter()
        .take(REASONS)
        .map(|(reason, count)| row(vec![reason, count.to_string()]))
        .collect();
    if more > 0 {
        rows.push(row(vec!["other reasons, in the table".into(), more.to_string()]));
    }
    let grid = Grid { heads, rows };
    Some(part("Without an answer".into(), "Points without a solution.", grid, "plan_broomstick"))
}
