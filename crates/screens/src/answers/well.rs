//! Path, hole and string of a case, for its views.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{
    outcome::WellPath,
    string::{Component as StringComponent, DrillString},
    well::{HoleSection, Path},
};
use wholestring_case::Case;

use super::column::Column;
use crate::words;

/// Number of points of the path in addition to its stations.
const POINTS: usize = 200;

/// Path, hole and string.
#[derive(Debug, Serialize, ToSchema)]
pub struct WellView {
    /// The path.
    #[serde(flatten)]
    path: PathView,
    /// Sections of the hole, from the surface down.
    hole: Vec<Section>,
    /// Components of the string, from the surface down, at the bit depth of the case's first
    /// operation.
    string: Vec<Component>,
}

/// A path, at its stations and between them.
#[derive(Debug, Serialize, ToSchema)]
pub struct PathView {
    /// Measured depths of the stations and of evenly spaced points between them, m.
    #[schema(value_type = Vec<f32>)]
    md_m: Column,
    /// North, m.
    #[schema(value_type = Vec<f32>)]
    north_m: Column,
    /// East, m.
    #[schema(value_type = Vec<f32>)]
    east_m: Column,
    /// True vertical depth, m.
    #[schema(value_type = Vec<f32>)]
    tvd_m: Column,
    /// Distance along the direction of the closure, m.
    #[schema(value_type = Vec<f32>)]
    vertical_section_m: Column,
    /// Inclination, rad.
    #[schema(value_type = Vec<f32>)]
    inclination_rad: Column,
    /// Azimuth, rad.
    #[schema(value_type = Vec<f32>)]
    azimuth_rad: Column,
    /// Dogleg severity, rad/m.
    dogleg_severity_rad_per_m: Column,
}

/// A section of the hole.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Section {
    /// Kind of the hole.
    #[schema(value_type = words::HoleKind)]
    kind: &'static str,
    /// Its top, m.
    from_m: f64,
    /// Its end, m.
    to_m: f64,
    /// Diameter, m.
    diameter_m: f64,
    /// Kinetic coefficient of axial friction.
    friction: f64,
}

/// A component of the string.
#[derive(Debug, Serialize, ToSchema)]
pub struct Component {
    /// Its name in the case.
    name: String,
    /// Its upper end, m.
    from_m: f64,
    /// Its lower end, m.
    to_m: f64,
    /// Outside diameter of the body, m.
    od_m: f64,
    /// Inside diameter, m.
    id_m: f64,
    /// Diameter over joints or blades, which contact the wall first, m.
    contact_od_m: f64,
}

impl WellView {
    /// The views of a case.
    pub fn of(case: &Case) -> Self {
        let (model, path) = (&case.model, &case.model.well.path);
        let bit_m =
            case.operations.first().map_or(path.last_md_m(), |operation| operation.bit_depth_m);
        Self {
            path: PathView::of(path),
            hole: model.well.hole.sections().iter().map(Section::of).collect(),
            string: Component::all(&model.string, bit_m),
        }
    }
}

impl PathView {
    /// The view of a path.
    pub fn of(path: &Path) -> Self {
        let well = WellPath::at(path, depths(path)).drawn(path);
        let column = |numbers: Vec<f64>| numbers.into_iter().collect();
        Self {
            md_m: column(well.md_m),
            north_m: column(well.north_m),
            east_m: column(well.east_m),
            tvd_m: column(well.tvd_m),
            vertical_section_m: column(well.vertical_section_m),
            inclination_rad: column(well.inclination_rad),
            azimuth_rad: column(well.azimuth_rad),
            dogleg_severity_rad_per_m: column(well.dogleg_severity_rad_per_m),
        }
    }
}

fn depths(path: &Path) -> Vec<f64> {
    let (from_m, to_m) = (path.first_md_m(), path.last_md_m());
    let even = (0..=POINTS).map(|i| from_m + (to_m - from_m) * i as f64 / POINTS as f64);
    let stations = path.stations().iter().map(|station| station.md_m);
    let mut depths: Vec<f64> = even.chain(stations).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
    depths
}

impl Section {
    /// The view of a hole section.
    pub fn of(section: &HoleSection) -> Self {
        Self {
            kind: words::hole_kind(section.kind),
            from_m: section.from_md_m.max(0.0),
            to_m: section.to_md_m,
            diameter_m: section.diameter_m,
            friction: section.friction.kinetic,
        }
    }
}

impl Component {
    /// The components of a string, from the surface down, for this bit depth, m.
    pub fn all(string: &DrillString, bit_m: f64) -> Vec<Self> {
        let components = string.spans().rev().map(|span| Self {
            name: span.component.name.clone(),
            from_m: bit_m - span.to_bit_m,
            to_m: bit_m - span.from_bit_m,
            od_m: span.component.od_m,
            id_m: span.component.id_m,
            contact_od_m: contact_od_m(span.component),
        });
        components.collect()
    }
}

fn contact_od_m(component: &StringComponent) -> f64 {
    let joints_m = component.joints.map(|joints| joints.od_m);
    let blades_m = component.blades.map(|blades| blades.od_m);
    joints_m.or(blades_m).unwrap_or(component.od_m)
}
