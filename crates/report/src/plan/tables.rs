//! Tables of a plan's page.

use wholestring::{operation::OperationKind, outcome::ModelKind};

use super::{Plan, PlanSpot, mud::STATES};
use crate::digits::four;
use crate::grid_cells::{head, row};
use crate::{Grid, StudyPart, Verdict, plots::DisplayUnits};

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
    let rows =
        plan.levels.iter().map(|level| row(vec![level.name.clone(), level.sections.join("; ")]));
    part(
        "Friction".into(),
        "Low, expected and high friction of this plan.",
        Grid { heads, rows: rows.collect() },
        "plan_friction",
    )
}

/// Every operation at the deepest depth.
pub(super) fn at_depth(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let deepest = |points: &[PlanSpot]| points.last().cloned();
    let depth_m =
        plan.curves.iter().filter_map(|curve| deepest(&curve.points)).next_back()?.bit_depth_m;
    let block_N = plan.block_N;
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
    let rows = plan.curves.iter().filter_map(|curve| {
        let spot = deepest(&curve.points)?;
        let level = plan.levels.get(curve.level)?;
        let quantity = |si: f64, dimension: &str| four(display.value(si, dimension));
        let mut cells = vec![
            curve.operation.words().to_owned(),
            format!("{}, {}", level.name, level.label),
            curve.model.name().to_owned(),
            quantity(spot.hook_load_N, "force"),
        ];
        cells.extend(block_N.map(|block| quantity(spot.hook_load_N + block, "force")));
        let worst = match &spot.worst {
            Some((words, severity)) => format!("{}: {words}", severity.name()),
            None => String::new(),
        };
        cells.extend([quantity(spot.torque_N_m, "torque"), spot.buckling.clone(), worst]);
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
    for model in &plan.models {
        let hook = grid(plan, display, *model, "force", |spot| spot.hook_load_N, |_| true);
        parts.push(part(
            format!("Hook load without block, {}, {model} string", display.symbol("force")),
            "Against the depth of the bit.",
            hook,
            "plan_broomstick",
        ));
        let torque =
            grid(plan, display, *model, "torque", |spot| spot.torque_N_m, OperationKind::rotates);
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
    spot: fn(&PlanSpot) -> f64,
    is_shown: fn(OperationKind) -> bool,
) -> Grid {
    let mut heads = vec![head(format!("bit depth, {}", display.symbol("length")), false)];
    let mut columns = Vec::new();
    // Trip in to the left, trip out to the right, then operations that drill.
    let mut operations = plan.operations();
    operations.sort_by_key(|operation| (operation.on_bottom(), order(*operation)));
    for operation in operations.into_iter().filter(|operation| is_shown(*operation)) {
        for curve in plan.curves_of(model, operation) {
            let level = plan.levels.get(curve.level).map_or("", |level| &level.label);
            heads.push(head(format!("{} {level}", operation.words()), false));
            columns.push(curve);
        }
    }
    let rows = columns.first().map_or(0, |first| first.points.len());
    let rows = (0..rows).map(|place| {
        let depth_m = columns[0].points[place].bit_depth_m;
        let mut cells = vec![format!("{:.0}", display.value(depth_m, "length"))];
        cells.extend(columns.iter().map(|curve| {
            let value = curve.points.get(place).map_or(f64::NAN, spot);
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
    let expected = plan.levels.len() / 2;
    let curves: Vec<_> =
        plan.buckling.iter().filter(|buckling| buckling.level == expected).collect();
    let first = curves.first()?;
    let mut heads = vec![head(format!("bit depth, {}", display.symbol("length")), false)];
    for curve in &curves {
        for shape in ["sinusoid", "helix"] {
            heads.push(head(format!("{}: {shape}", curve.operation.words()), false));
        }
    }
    let rows = (0..first.points.len()).map(|place| {
        let mut cells = vec![format!("{:.0}", display.value(first.points[place].0, "length"))];
        for curve in &curves {
            let weights_N = curve.points.get(place).map_or([f64::NAN; 2], |point| point.1);
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
    let mud = plan.mud.as_ref().filter(|mud| !mud.rows.is_empty())?;
    let has_shoe = mud.rows.iter().any(|row| row.at_shoe_kg_per_m3[0].is_finite());
    let mut heads = vec![
        head(format!("bit depth, {}", display.symbol("length")), false),
        head(format!("standpipe, {}", display.symbol("pressure")), false),
    ];
    for place in ["bit", "shoe"].into_iter().take(if has_shoe { 2 } else { 1 }) {
        heads.extend(STATES.iter().map(|state| head(format!("{place}: {state}"), false)));
    }
    let density = |value: f64| four(display.value(value, "density"));
    let rows = mud.rows.iter().map(|mud_row| {
        let mut cells = vec![
            format!("{:.0}", display.value(mud_row.bit_depth_m, "length")),
            four(display.value(mud_row.standpipe_Pa, "pressure")),
        ];
        cells.extend(mud_row.at_bit_kg_per_m3.map(density));
        if has_shoe {
            cells.extend(mud_row.at_shoe_kg_per_m3.map(density));
        }
        row(cells)
    });
    let grid = Grid { heads, rows: rows.collect() };
    let title = format!("Mud: equivalent density, {}", display.symbol("density"));
    let caption = "Pumps as while drilling, or as the first operation that circulates.";
    Some(part(title, caption, grid, "plan_hydraulics"))
}

/// Points without an answer, and the reasons.
pub(super) fn without_answer(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for curve in &plan.curves {
        for message in curve.points.iter().filter_map(|spot| spot.message.as_ref()) {
            let message = display.chosen(message);
            let level = plan.levels.get(curve.level).map_or("", |level| &level.name);
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
