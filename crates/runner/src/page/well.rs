//! Path, hole and string of a run, from the settings in its summary.

use serde_json::Value as Json;
use wholestring::{
    outcome::{
        Quantity,
        QuantityKind::{self, Angle, Curvature, Depth, Length},
    },
    well::{Interpolation, Path, Station, TieIn},
};
use wholestring_report::{Packed, Part, Section, Well};

/// Points of the path on the page, besides the stations.
const POINTS: usize = 800;

/// A quantity, and its value at a measured depth.
type PathColumn = (Quantity, fn(&Path, f64) -> f64);

const fn of_path(name: &'static str, kind: QuantityKind, meaning: &'static str) -> Quantity {
    Quantity::number(name, kind, meaning)
}

/// Horizontal distance from the first station, projected on the direction to the last one: the
/// abscissa of a vertical section, m. Zero of a path that ends below its beginning.
fn vertical_section_m(path: &Path, md_m: f64) -> f64 {
    let from = path.at(path.first_md_m()).position_m;
    let closure = (path.at(path.last_md_m()).position_m - from).xy();
    let direction = closure.try_normalize(1e-9).unwrap_or_default();
    (path.at(md_m).position_m - from).xy().dot(&direction)
}

/// The well of a run.
pub(crate) struct WellBore<'a> {
    settings: &'a Json,
    path: Option<Path>,
    bit_md_m: f64,
}

impl<'a> WellBore<'a> {
    pub(crate) fn of(settings: &'a Json) -> Self {
        Self {
            path: path(&settings["well"]),
            bit_md_m: number(&settings["operation"]["bit_depth_m"]),
            settings,
        }
    }

    /// Depths from the surface to the bit, evenly and at every station.
    fn depths(&self, path: &Path) -> Vec<f64> {
        let from = path.first_md_m().max(0.0);
        let to = self.bit_md_m.max(from);
        let even = (0..=POINTS).map(|i| from + (to - from) * i as f64 / POINTS as f64);
        let stations = path.stations().iter().map(|station| station.md_m);
        let mut depths: Vec<f64> =
            even.chain(stations.filter(|md| (from..=to).contains(md))).collect();
        depths.sort_by(f64::total_cmp);
        depths.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
        depths
    }

    /// A quantity at these depths; nothing without a path.
    fn column(&self, depths: &[f64], of: &dyn Fn(&Path, f64) -> f64) -> Vec<f64> {
        let path = self.path.iter();
        path.flat_map(|path| depths.iter().map(|md| of(path, *md))).collect()
    }

    /// A column of [`Self::COLUMNS`], from the surface to the bit.
    pub(crate) fn column_named(&self, name: &str) -> Vec<f64> {
        let depths = self.path.as_ref().map(|path| self.depths(path));
        let column = Self::COLUMNS.iter().find(|(column, _)| column.name == name);
        column.map_or_else(Vec::new, |(_, of)| self.column(&depths.unwrap_or_default(), of))
    }

    /// What is known of the path at a measured depth.
    pub(crate) const COLUMNS: &'static [PathColumn] = &[
        (of_path("md_m", Depth, "Measured depth"), |_, md| md),
        (of_path("north_m", Length, "North"), |path, md| path.at(md).position_m.x),
        (of_path("east_m", Length, "East"), |path, md| path.at(md).position_m.y),
        (of_path("tvd_m", Depth, "True vertical depth"), |path, md| path.at(md).position_m.z),
        (
            of_path("vertical_section_m", Length, "Distance along the closure's direction"),
            vertical_section_m,
        ),
        (of_path("inclination_rad", Angle, "Inclination"), |path, md| {
            path.at(md).inclination_rad()
        }),
        (of_path("azimuth_rad", Angle, "Azimuth"), |path, md| path.at(md).azimuth_rad()),
        (of_path("dogleg_severity_rad_per_m", Curvature, "Dogleg severity"), |path, md| {
            path.dogleg_severity_rad_per_m(md)
        }),
    ];

    /// The path down to the bit.
    pub(super) fn path(&self) -> Well {
        let depths = self.path.as_ref().map(|path| self.depths(path));
        let depths = depths.unwrap_or_default();
        let column = |of: &dyn Fn(&Path, f64) -> f64| Packed::single(self.column(&depths, of));
        let named = |name: &str| Packed::single(self.column_named(name));
        Well {
            md_m: named("md_m"),
            north_m: named("north_m"),
            east_m: named("east_m"),
            tvd_m: named("tvd_m"),
            inclination_rad: named("inclination_rad"),
            azimuth_rad: named("azimuth_rad"),
            dogleg_rad_per_m: named("dogleg_severity_rad_per_m"),
            high: [0, 1, 2].map(|axis| column(&|path, md| path.high_side_at(md)[axis])),
        }
    }

    /// Sections of the hole down to the bit.
    pub(crate) fn hole(&self) -> Vec<Section> {
        let sections = self.settings["well"]["hole"].as_array();
        sections
            .into_iter()
            .flatten()
            .map(|section| Section {
                kind: section["kind"].as_str().unwrap_or("open").into(),
                from_m: number(&section["from_m"]).max(0.0),
                to_m: number(&section["to_m"]),
                diameter_m: number(&section["diameter_m"]),
                friction: number(&section["friction"]["kinetic"]),
            })
            .filter(|section| section.from_m < self.bit_md_m)
            .collect()
    }

    /// Parts of the string, from the surface down.
    pub(super) fn string(&self) -> Vec<Part> {
        let mut bottom_m = self.bit_md_m;
        let components = self.settings["string"].as_array();
        let mut parts: Vec<Part> = components
            .into_iter()
            .flatten()
            .map(|component| {
                let to_m = bottom_m;
                bottom_m -= number(&component["length_m"]);
                let od_m = number(&component["od_m"]);
                let touching = component["blade_od_m"].as_f64();
                let touching = touching.or(component["joint_od_m"].as_f64());
                Part {
                    name: component["component"].as_str().unwrap_or_default().into(),
                    from_m: bottom_m,
                    to_m,
                    od_m,
                    id_m: number(&component["id_m"]),
                    contact_od_m: touching.unwrap_or(od_m),
                }
            })
            .collect();
        parts.reverse();
        parts
    }
}

/// The path that a run was solved on; none where the settings do not hold it.
fn path(well: &Json) -> Option<Path> {
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

fn number(value: &Json) -> f64 {
    value.as_f64().unwrap_or(0.0)
}
