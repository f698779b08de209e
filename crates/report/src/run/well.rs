//! Path, hole and string of a run, from the settings in its summary.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;
use wholestring::{
    outcome::{Values, WELL_PATH, WellPath},
    well::{Interpolation, Path, Station, TieIn},
};

use crate::Packed;

/// Points of the path on the page, in addition to the stations.
const POINTS: usize = 800;

/// The path of the well, point by point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Well {
    /// Columns of the path by their name.
    #[serde(flatten)]
    pub columns: BTreeMap<String, Packed>,
    /// Unit vector to the high side: north, east and down of all points, one component after the
    /// other.
    pub high: [Packed; 3],
}

impl Well {
    /// The path down to the bit.
    pub(super) fn new(settings: &Json) -> Self {
        let columns = well_path(settings);
        let path = path_of(settings);
        let columns = match &path {
            Some(path) => columns.drawn(path),
            None => columns,
        };
        let packed = WELL_PATH.iter().filter_map(|column| match (column.of)(&columns) {
            Values::Numbers(values) => {
                Some((column.quantity.name.to_owned(), Packed::single(values.iter().copied())))
            }
            Values::Words(_) => None,
        });
        let high = |axis: usize| {
            let path = path.iter();
            let sides = path.flat_map(|path| columns.md_m.iter().map(|md| path.high_side_at(*md)));
            Packed::single(sides.map(|side| side[axis]))
        };
        Self { columns: packed.collect(), high: [0, 1, 2].map(high) }
    }
}

/// A section of the hole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// `casing` or `open`.
    pub kind: String,
    /// Measured depth of its upper end, m.
    pub from_m: f64,
    /// Measured depth of its lower end, m.
    pub to_m: f64,
    /// Its diameter, m.
    pub diameter_m: f64,
    /// Coefficient of kinetic friction.
    pub friction: f64,
}

impl Section {
    /// Sections of the hole down to the bit, from the surface down.
    pub fn all(settings: &Json) -> Vec<Self> {
        let section = |section: &Json| Self {
            kind: section["kind"].as_str().unwrap_or("open").into(),
            from_m: number(&section["from_m"]).max(0.0),
            to_m: number(&section["to_m"]),
            diameter_m: number(&section["diameter_m"]),
            friction: number(&section["friction"]["kinetic"]),
        };
        let sections = settings["well"]["hole"].as_array().into_iter().flatten().map(section);
        sections.filter(|section| section.from_m < bit_md_m(settings)).collect()
    }
}

/// A part of the string.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Name given by the user.
    pub name: String,
    /// Measured depth of its upper end, m.
    pub from_m: f64,
    /// Measured depth of its lower end, m.
    pub to_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter, m.
    pub id_m: f64,
    /// Diameter at which it touches the wall: of joints or blades where it has them, m.
    pub contact_od_m: f64,
}

impl Part {
    /// Parts of the string, from the surface down.
    pub(super) fn all(settings: &Json) -> Vec<Self> {
        let mut bottom_m = bit_md_m(settings);
        let part = |component: &Json| {
            let to_m = bottom_m;
            bottom_m -= number(&component["length_m"]);
            let od_m = number(&component["od_m"]);
            let touching = component["blade_od_m"].as_f64();
            let touching = touching.or(component["joint_od_m"].as_f64());
            Self {
                name: component["component"].as_str().unwrap_or_default().into(),
                from_m: bottom_m,
                to_m,
                od_m,
                id_m: number(&component["id_m"]),
                contact_od_m: touching.unwrap_or(od_m),
            }
        };
        let components = settings["string"].as_array().into_iter().flatten();
        let mut parts: Vec<Self> = components.map(part).collect();
        parts.reverse();
        parts
    }
}

/// The path of a case from the surface to the bit, evenly spaced and at every station, from its
/// settings; no rows if they do not contain it.
pub fn well_path(settings: &Json) -> WellPath {
    let Some(path) = path_of(settings) else { return WellPath::default() };
    let from = path.first_md_m().max(0.0);
    let to = bit_md_m(settings).max(from);
    let even = (0..=POINTS).map(|i| from + (to - from) * i as f64 / POINTS as f64);
    let stations = path.stations().iter().map(|station| station.md_m);
    let mut depths: Vec<f64> = even.chain(stations.filter(|md| (from..=to).contains(md))).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
    WellPath::at(&path, depths)
}

/// The path that a run was solved on, from its settings; `None` if they do not contain it.
pub fn path_of(settings: &Json) -> Option<Path> {
    let well = &settings["well"];
    let column = |name: &str| well["stations"][name].as_array();
    let (md, inclination, azimuth) =
        (column("md_m")?, column("inclination_rad")?, column("azimuth_rad")?);
    let stations: Vec<Station> = md
        .iter()
        .zip(inclination)
        .zip(azimuth)
        .map(|((md, inclination), azimuth)| Station {
            md_m: number(md),
            inclination_rad: number(inclination),
            azimuth_rad: number(azimuth),
        })
        .collect();
    let interpolation = match well["path"].as_str()? {
        "minimum-curvature" => Interpolation::MinimumCurvature,
        _ => Interpolation::Spline,
    };
    let tie_in = &well["tie_in"];
    let tie_in = TieIn {
        north_m: number(&tie_in["north_m"]),
        east_m: number(&tie_in["east_m"]),
        tvd_m: number(&tie_in["tvd_m"]),
    };
    Path::new(&stations, interpolation, tie_in).ok()
}

fn bit_md_m(settings: &Json) -> f64 {
    number(&settings["operation"]["bit_depth_m"])
}

fn number(value: &Json) -> f64 {
    value.as_f64().unwrap_or(0.0)
}
