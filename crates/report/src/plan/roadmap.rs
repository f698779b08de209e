//! The roadmap on a plan's page: what the rig floor reads and writes down.

use wholestring::{operation::OperationKind, outcome::Scalars, well::FrictionLevel};
use wholestring_units::UnitSet;

use super::Plan;
use crate::{
    Grid, StudyPart,
    cell::four,
    grid_cells::{head, row},
    plots::DisplayUnits,
};

/// Spacing of the rows, m: five stands of three joints, as a round number in the reader's units.
const fn spacing_m(units: UnitSet) -> f64 {
    match units {
        UnitSet::Field => 500.0 * 0.3048,
        UnitSet::Si | UnitSet::Metric => 150.0,
    }
}

/// A gauge of the rig.
#[derive(Clone, Copy)]
enum Gauge {
    /// Hook load, with the block where its weight is given.
    HookLoad,
    /// Torque of the top drive.
    Torque,
}

impl Gauge {
    const fn dimension(self) -> &'static str {
        match self {
            Self::HookLoad => "force",
            Self::Torque => "torque",
        }
    }

    fn value(self, scalars: &Scalars, block_N: f64) -> f64 {
        match self {
            Self::HookLoad => scalars.hook_load_N + block_N,
            Self::Torque => scalars.surface_torque_N_m,
        }
    }
}

/// Operations that are compared with readings: off bottom, where the weight on bit is known.
fn gauges(plan: &Plan) -> Vec<(OperationKind, Gauge)> {
    use OperationKind::{RotateOffBottom, TripIn, TripOut};
    let planned = |kind: &OperationKind| plan.operations().any(|own| own == *kind);
    let loads = [TripOut, RotateOffBottom, TripIn].into_iter().filter(planned);
    let torque = Some(RotateOffBottom).filter(planned).map(|kind| (kind, Gauge::Torque));
    loads.map(|kind| (kind, Gauge::HookLoad)).chain(torque).collect()
}

/// A row for each 150 m or 500 ft of the bit: expected hook loads and torque with their bands, and
/// room for the readings; `None` of a plan that only drills.
pub(super) fn table(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let model = *plan.summary.models.first()?;
    let gauges = gauges(plan);
    if gauges.is_empty() {
        return None;
    }
    let block_N = plan.summary.block_weight_N();
    let mut heads = vec![head(format!("bit depth, {}", display.symbol("length")), false)];
    heads.extend(gauges.iter().map(|(operation, gauge)| {
        let what = match gauge {
            Gauge::HookLoad => String::new(),
            Gauge::Torque => ", torque".to_owned(),
        };
        let symbol = display.symbol(gauge.dimension());
        head(format!("{}{what}, {symbol}", operation.words()), false)
    }));
    heads.extend(gauges.iter().map(|(operation, gauge)| match gauge {
        Gauge::HookLoad => head(format!("{}, read", operation.words()), false),
        Gauge::Torque => head("torque, read", false),
    }));
    let depths_m = plan.summary.roadmap_depths_m(spacing_m(display.unit_set()));
    let rows = depths_m.into_iter().map(|depth_m| {
        let mut cells = vec![format!("{:.0}", display.value(depth_m, "length"))];
        cells.extend(gauges.iter().map(|(operation, gauge)| {
            let levels = [FrictionLevel::Expected, FrictionLevel::Low, FrictionLevel::High];
            let [expected, low, high] = levels.map(|level| {
                let found =
                    plan.summary.between_depths((model, *operation, level), depth_m, |scalars| {
                        gauge.value(scalars, block_N.unwrap_or(0.0))
                    });
                display.value(found.unwrap_or(f64::NAN), gauge.dimension())
            });
            band(expected, [low, high])
        }));
        cells.extend(gauges.iter().map(|_| String::new()));
        row(cells)
    });
    let grid = Grid { heads, rows: rows.collect() };
    let block = match block_N {
        Some(block_N) => {
            format!("Hook loads include the block, {}", display.quantity(block_N, "force"))
        }
        None => "Hook loads are without block, whose weight the case does not give".to_owned(),
    };
    let caption = format!(
        "By the {model} string: expected friction, and from low to high friction in brackets; in \
         proportion between the depths of the plan. A dash: no answer at one of them. {block}. The \
         columns at the right are for the readings."
    );
    Some(StudyPart::Table {
        title: "Roadmap".to_owned(),
        caption,
        grid,
        files: "plan".to_owned(),
        endings: &["xlsx"],
    })
}

/// A value, and its band in brackets where friction changes it.
fn band(expected: f64, band: [f64; 2]) -> String {
    let [low, high] = if band[0] > band[1] { [band[1], band[0]] } else { band }.map(four);
    let expected = four(expected);
    match low == high && low == expected {
        true => expected,
        false => format!("{expected} ({low} to {high})"),
    }
}
