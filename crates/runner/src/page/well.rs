//! Path, hole and string of a run, from the settings in its summary.

use serde_json::Value as Json;
use wholestring::{
    outcome::{Values, WELL_PATH, WellPath},
    well::{Interpolation, Path, Station, TieIn},
};
use wholestring_report::{Packed, Part, Section, Well};

/// Points of the path on the page, in addition to the stations.
const POINTS: usize = 800;

/// The well of a run.
pub(crate) struct WellBore<'a> {
    settings: &'a Json,
    path: Option<Path>,
    bit_md_m: f64,
}

impl<'a> WellBore<'a> {
    pub(crate) fn of(settings: &'a Json) -> Self {
        Self {
            path: path_of(&settings["well"]),
            bit_md_m: number(&settings["operation"]["bit_depth_m"]),
            settings,
        }
    }

    /// Depths from the surface to the bit, evenly spaced and at every station.
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

    /// The path from the surface to the bit; no rows if the settings do not contain it.
    pub(crate) fn columns(&self) -> WellPath {
        let path = self.path.as_ref();
        path.map_or_else(WellPath::default, |path| WellPath::at(path, self.depths(path)))
    }

    /// The path down to the bit.
    pub(super) fn path(&self) -> Well {
        let columns = self.columns();
        let columns = match self.path.as_ref() {
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
            let path = self.path.iter();
            let sides = path.flat_map(|path| columns.md_m.iter().map(|md| path.high_side_at(*md)));
            Packed::single(sides.map(|side| side[axis]))
        };
        Well { columns: packed.collect(), high: [0, 1, 2].map(high) }
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

/// The path of a case from the surface to the bit, from its settings; no rows if they do not
/// contain it.
pub fn well_path(settings: &Json) -> WellPath {
    WellBore::of(settings).columns()
}

/// The path that a run was solved on; `None` if the settings do not contain it.
pub(crate) fn path_of(well: &Json) -> Option<Path> {
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
