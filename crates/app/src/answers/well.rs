//! Path, hole and string of a case, for its views.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{
    outcome::WellPath,
    string::Component as StringComponent,
    well::{HoleKind, HoleSection, Path},
};
use wholestring_case::Case;

use super::column::Column;

/// Points of the path beside its stations.
const POINTS: usize = 200;

/// Path, hole and string.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct WellView {
    /// Measured depths of the stations and evenly between them, m.
    md_m: Column,
    /// North, m.
    north_m: Column,
    /// East, m.
    east_m: Column,
    /// True vertical depth, m.
    tvd_m: Column,
    /// Distance along the closure's direction, m.
    vertical_section_m: Column,
    /// Inclination, rad.
    inclination_rad: Column,
    /// Azimuth, rad.
    azimuth_rad: Column,
    /// Dogleg severity, rad/m.
    dogleg_severity_rad_per_m: Column,
    /// Sections of the hole, from the surface down.
    hole: Vec<Section>,
    /// Components of the string, from the surface down, at the depth of the case's first operation.
    string: Vec<Component>,
}

/// A section of the hole.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Section {
    /// `casing` or `open`.
    kind: &'static str,
    /// Its top, m.
    from_m: f64,
    /// Its end, m.
    to_m: f64,
    /// Diameter, m.
    diameter_m: f64,
    /// Kinetic coefficient of friction along the hole.
    friction: f64,
}

/// A component of the string.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Component {
    /// What the case calls it.
    name: String,
    /// Its upper end, m.
    from_m: f64,
    /// Its lower end, m.
    to_m: f64,
    /// Outside diameter of the body, m.
    od_m: f64,
    /// Inside diameter, m.
    id_m: f64,
    /// Diameter over joints or blades, which touch the wall first, m.
    contact_od_m: f64,
}

impl WellView {
    /// Those of a case.
    pub(crate) fn of(case: &Case) -> Self {
        let (model, path) = (&case.model, &case.model.well.path);
        let well = WellPath::at(path, depths(path));
        let column = |numbers: Vec<f64>| numbers.into_iter().collect();
        let bit_m = case.operations.first().map_or(path.last_md_m(), |of| of.bit_depth_m);
        let components = model.string.spans().rev().map(|span| Component {
            name: span.component.name.clone(),
            from_m: bit_m - span.to_bit_m,
            to_m: bit_m - span.from_bit_m,
            od_m: span.component.od_m,
            id_m: span.component.id_m,
            contact_od_m: contact_od_m(span.component),
        });
        Self {
            md_m: column(well.md_m),
            north_m: column(well.north_m),
            east_m: column(well.east_m),
            tvd_m: column(well.tvd_m),
            vertical_section_m: column(well.vertical_section_m),
            inclination_rad: column(well.inclination_rad),
            azimuth_rad: column(well.azimuth_rad),
            dogleg_severity_rad_per_m: column(well.dogleg_severity_rad_per_m),
            hole: model.well.hole.sections().iter().map(section).collect(),
            string: components.collect(),
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

fn section(of: &HoleSection) -> Section {
    Section {
        kind: match of.kind {
            HoleKind::Casing => "casing",
            HoleKind::Open => "open",
        },
        from_m: of.from_md_m.max(0.0),
        to_m: of.to_md_m,
        diameter_m: of.diameter_m,
        friction: of.friction.kinetic,
    }
}

fn contact_od_m(of: &StringComponent) -> f64 {
    let joints_m = of.joints.map(|joints| joints.od_m);
    let blades_m = of.blades.map(|blades| blades.od_m);
    joints_m.or(blades_m).unwrap_or(of.od_m)
}
