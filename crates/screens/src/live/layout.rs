//! Layout of a live string, which a viewer needs before its first frame.

use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{
    dynamics::{Simulation, TopDriveSettings},
    operation::Operation,
    outcome::WellPath,
    rod::mesh::MeshElement,
    well::Path,
};
use wholestring_case::{Case, MAX_FRICTION, usual_speed_controllers};
use wholestring_judge::{CheckKind, surface_limits};

use super::{
    channels::{self, Channel},
    set_points::{
        MAX_BLOCK_VELOCITY_M_PER_S, MAX_FLOW_RATE_M3_PER_S, MAX_ROTARY_SPEED_RAD_PER_S,
        MAX_WEIGHT_ON_BIT_N,
    },
};
use crate::{answers::Section, words};

/// Number of points of the path in addition to its stations.
const POINTS: usize = 400;

/// Layout of a live string, which a viewer needs before the first frame.
#[derive(Debug, Clone, Serialize, ToSchema)]
#[schema(as = LiveLayout)]
pub struct Layout {
    /// Identifier in requests.
    pub id: String,
    /// Its case.
    pub case: String,
    /// The name of the case.
    pub name: String,
    /// Name of the operation.
    pub operation: &'static str,
    /// Depth of the bit at the start of the operation, m.
    bit_depth_m: f64,
    /// Time between two samples, s: sample `n` is at `(n + 1)` intervals.
    pub sample_interval_s: f64,
    /// Number of samples kept for viewers that join later.
    pub samples_kept: usize,
    /// Number of elements of the string.
    elements: usize,
    /// Travel time of a torsional wave from the surface to the bit, s.
    torsional_travel_s: f64,
    /// Columns of a sample, in their order.
    samples: Vec<Channel>,
    /// Columns of a frame, in their order.
    frame: Vec<Channel>,
    /// Display units of each dimension: in SI, metric and field units.
    #[schema(value_type = BTreeMap<String, UnitsOfSets>)]
    units: BTreeMap<String, [LiveUnit; 3]>,
    /// Contact radius of each node from the surface down, m.
    contact_radius_m: Vec<f32>,
    /// The path.
    path: LivePath,
    /// Sections of the hole, from the surface down.
    hole: Vec<Section>,
    /// The knobs.
    knobs: Knobs,
    /// Limits of the strip charts.
    limits: Vec<LiveLimit>,
    /// Units of the case.
    #[schema(value_type = words::UnitSet)]
    case_units: &'static str,
}

/// A limit of a column of the samples.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct LiveLimit {
    /// Name of the column.
    column: &'static str,
    /// Its label.
    label: String,
    /// The allowable value, SI.
    value: f64,
}

/// A display unit.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct LiveUnit {
    symbol: String,
    /// Its SI value.
    factor: f64,
}

/// Description of the units of a dimension in each set.
#[derive(Debug, ToSchema)]
#[schema(min_items = 3, max_items = 3)]
pub struct UnitsOfSets(#[allow(dead_code)] Vec<LiveUnit>);

/// The path of the well in columns.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct LivePath {
    md_m: Vec<f32>,
    north_m: Vec<f32>,
    east_m: Vec<f32>,
    tvd_m: Vec<f32>,
    /// Components of the direction towards the high side: north, east and down.
    #[schema(min_items = 3, max_items = 3)]
    high: [Vec<f32>; 3],
}

/// Knobs in SI units: bounds and initial value; null if the value cannot be set.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Knobs {
    rotary_speed_rad_per_s: Option<Knob>,
    block_velocity_m_per_s: Option<Knob>,
    weight_on_bit_N: Option<Knob>,
    /// Null without a mud rheology, because the flow rate then has no effect on the string.
    flow_rate_m3_per_s: Option<Knob>,
    friction: Option<Knob>,
    /// The available controllers of the top drive; empty for a drive that follows its set point at
    /// any torque.
    controllers: Vec<&'static str>,
}

/// A knob.
#[derive(Debug, Clone, Copy, Serialize, ToSchema)]
pub struct Knob {
    low: f64,
    high: f64,
    begins: f64,
}

impl Layout {
    pub(super) fn of(
        id: &str,
        case_id: &str,
        case: &Case,
        operation: &Operation,
        simulation: &Simulation,
        samples_kept: usize,
    ) -> Self {
        let mesh = simulation.mesh();
        let radii = mesh.nodes.iter().map(|node| node.contact_radius_m as f32);
        let units = wholestring_runner::display_units().into_iter().map(|(name, units)| {
            let display = units.map(|unit| LiveUnit { symbol: unit.symbol, factor: unit.factor });
            (name, display)
        });
        Self {
            id: id.to_owned(),
            case: case_id.to_owned(),
            name: case.name.clone(),
            operation: operation.kind.name(),
            bit_depth_m: operation.bit_depth_m,
            sample_interval_s: simulation.sample_interval_s(),
            samples_kept,
            elements: simulation.elements(),
            torsional_travel_s: mesh.elements.iter().map(torsional_travel_s).sum(),
            samples: channels::sampled(),
            frame: channels::framed(),
            units: units.collect(),
            contact_radius_m: radii.collect(),
            path: path(&case.model.well.path),
            hole: case.model.well.hole.sections().iter().map(Section::of).collect(),
            knobs: knobs(case, operation),
            limits: limits(case, operation),
            case_units: case.units.name(),
        }
    }
}

/// Travel time of a torsional wave through an element, s: `L/c` with `c² = GJ/(ρ J)`.
fn torsional_travel_s(element: &MeshElement) -> f64 {
    let section = &element.section;
    element.length_m * (section.polar_inertia_kg_m / section.torsional_stiffness_N_m2).sqrt()
}

fn path(path: &Path) -> LivePath {
    let (from_m, to_m) = (path.first_md_m(), path.last_md_m());
    let even = (0..=POINTS).map(|i| from_m + (to_m - from_m) * i as f64 / POINTS as f64);
    let stations = path.stations().iter().map(|station| station.md_m);
    let mut depths: Vec<f64> = even.chain(stations).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
    let sides: Vec<_> = depths.iter().map(|md| path.high_side_at(*md)).collect();
    let well = WellPath::at(path, depths).drawn(path);
    let single = |values: &[f64]| values.iter().map(|value| *value as f32).collect();
    LivePath {
        md_m: single(&well.md_m),
        north_m: single(&well.north_m),
        east_m: single(&well.east_m),
        tvd_m: single(&well.tvd_m),
        high: [0, 1, 2].map(|axis| sides.iter().map(|side| side[axis] as f32).collect()),
    }
}

fn knobs(case: &Case, operation: &Operation) -> Knobs {
    let knob = |low, high, begins| Some(Knob { low, high, begins });
    let first = case.dynamics.schedule.at_time_zero(operation);
    let driven = matches!(case.dynamics.top_drive, TopDriveSettings::Driven { .. });
    let speed = first.rotation_rad_per_s();
    let block = first.axial_velocity_m_per_s();
    let friction =
        case.model.well.hole.sections().first().map_or(0.0, |section| section.friction.kinetic);
    let turns = operation.kind.rotates();
    let weight_N = first.weight_on_bit_now_N();
    let (bottom, pumps) =
        (operation.weight_on_bit_now_N() > 0.0, case.model.mud.rheology.is_some());
    Knobs {
        rotary_speed_rad_per_s: knob(0.0, MAX_ROTARY_SPEED_RAD_PER_S, speed).filter(|_| turns),
        block_velocity_m_per_s: knob(
            -MAX_BLOCK_VELOCITY_M_PER_S,
            MAX_BLOCK_VELOCITY_M_PER_S,
            block,
        ),
        weight_on_bit_N: knob(0.0, MAX_WEIGHT_ON_BIT_N, weight_N).filter(|_| bottom),
        flow_rate_m3_per_s: knob(0.0, MAX_FLOW_RATE_M3_PER_S, first.flow_now_m3_per_s())
            .filter(|_| pumps),
        friction: knob(0.0, MAX_FRICTION, friction),
        controllers: usual_speed_controllers()
            .iter()
            .filter(|_| driven)
            .map(|(word, _)| *word)
            .collect(),
    }
}

/// Limits of rig and topmost component at the surface.
fn limits(case: &Case, operation: &Operation) -> Vec<LiveLimit> {
    let settings = case.judge(case.units).limits;
    let of_surface = surface_limits(&case.model, &settings).into_iter().filter_map(|limit| {
        let (column, label) = match limit.kind {
            CheckKind::Hoist => ("hook_load_N", "hoist"),
            CheckKind::Tension => ("hook_load_N", "pipe"),
            CheckKind::TopDrive => ("surface_torque_N_m", "drive, rated"),
            CheckKind::TopDrivePeak => ("surface_torque_N_m", "drive, peak"),
            CheckKind::MakeUp => ("surface_torque_N_m", "make-up"),
            _ => return None,
        };
        Some(LiveLimit { column, label: label.to_owned(), value: limit.allowed })
    });
    let limit = |column, label: &str, value: Option<f64>| {
        value.map(|value| LiveLimit { column, label: label.to_owned(), value })
    };
    let drive_N_m = case.dynamics.top_drive.torque_limit_N_m();
    let drive = limit("surface_torque_N_m", "drive, limit", drive_N_m);
    let pump_Pa = case.model.rig.pump_pressure_limit_Pa.filter(|_| operation.kind.circulates());
    let pump_Pa = pump_Pa.map(|limit_Pa| limit_Pa / settings.factors.pump_pressure);
    let pump = limit("pump_pressure_Pa", "pump", pump_Pa);
    of_surface.chain(drive).chain(pump).collect()
}
