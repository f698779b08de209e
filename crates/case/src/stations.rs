//! Survey stations, from the case or from a file, each with its place.

use serde_json::json;
use wholestring::well::{Station, TieIn};
use wholestring_config::prelude::*;
use wholestring_tabular::{Said, read_as};
use wholestring_units::Unit;

use crate::beside::{read_beside, unfit};

/// No hole bends more sharply than this, rad/m: 10 deg/m is a radius of 5.7 m.
const SHARPEST_RAD_PER_M: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// A survey and where its stations stand.
#[derive(Debug)]
pub(crate) struct Stations {
    pub(crate) list: Vec<Station>,
    /// One for each station, if they stand in the case.
    places: Vec<Span>,
    /// The survey as a whole.
    whole: Span,
    /// Position of the first station, if the survey's file says it.
    pub(crate) tie_in: Option<TieIn>,
    /// How the file was understood.
    pub(crate) notes: Vec<String>,
}

impl Stations {
    pub(crate) fn place(&self, index: usize) -> Span {
        self.places.get(index).copied().unwrap_or(self.whole)
    }

    /// What no survey has, although the engine could compute with it.
    pub(crate) fn check(&self, reader: &mut Reader) -> Option<()> {
        for (index, station) in self.list.iter().enumerate() {
            if !(-1000.0..=20_000.0).contains(&station.md_m) {
                return Diagnostic::error(format!(
                    "measured depth {} m is deeper than any well",
                    number_text(station.md_m)
                ))
                .at(self.place(index), "expected at most 20000 m")
                .refuse(reader);
            }
        }
        for (index, pair) in self.list.windows(2).enumerate() {
            let [above, below] = pair else { continue };
            let length_m = below.md_m - above.md_m;
            let turn_rad = angle_between(above, below);
            // A step too small or backwards is the path's to report.
            if length_m > 1e-3 && turn_rad / length_m > SHARPEST_RAD_PER_M {
                return Diagnostic::error(format!(
                    "the hole bends by {} deg within {} m below {} m",
                    number_text((turn_rad.to_degrees() * 10.0).round() / 10.0),
                    number_text((length_m * 1e3).round() / 1e3),
                    number_text(above.md_m)
                ))
                .at(self.place(index + 1), "expected at most 10 deg per metre")
                .refuse(reader);
            }
        }
        Some(())
    }
}

fn angle_between(a: &Station, b: &Station) -> f64 {
    let sines = libm::sin(a.inclination_rad) * libm::sin(b.inclination_rad);
    // Half-angle form: exact for small turns.
    let turn = (b.azimuth_rad - a.azimuth_rad) / 2.0;
    let build = (b.inclination_rad - a.inclination_rad) / 2.0;
    let half = (libm::sin(build).powi(2) + sines * libm::sin(turn).powi(2)).clamp(0.0, 1.0);
    2.0 * libm::asin(half.sqrt())
}

/// The name of a unit of length.
pub(crate) struct LengthUnit;

impl Rule for LengthUnit {
    type Value = &'static Unit;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<&'static Unit> {
        let expected = "a unit of length, such as \"m\" or \"ft\"";
        let Value::Text { text, .. } = &node.value else {
            reader.expected(node, expected);
            return None;
        };
        let unit = Dimension::Length.find_unit(text);
        if unit.is_none() {
            let message = format!("`{}` is no unit of length", short(text));
            reader
                .report(Diagnostic::error(message).at(node.place, format!("expected {expected}")));
        }
        unit
    }

    fn example(&self) -> Option<String> {
        Some("\"m\"".to_owned())
    }

    fn schema(&self) -> serde_json::Value {
        json!({ "type": "string", "minLength": 1, "maxLength": 64 })
    }

    fn json(&self, unit: &&'static Unit) -> serde_json::Value {
        json!(unit.symbol)
    }
}

/// One station in the case: `[md, inc, azi]`.
pub(crate) struct StationRule;

impl StationRule {
    fn cells() -> [Quantity; 3] {
        let degree = std::f64::consts::PI / 180.0;
        [
            Quantity::si(Dimension::Length, Range::from_to(0.0, 20_000.0), "322.9 m"),
            Quantity::si(Dimension::Angle, Range::from_to(0.0, std::f64::consts::PI), "45 deg")
                .bare("deg", degree),
            Quantity::si(
                Dimension::Angle,
                Range::from_to(-360.0 * degree, 360.0 * degree),
                "45 deg",
            )
            .bare("deg", degree),
        ]
    }
}

impl Rule for StationRule {
    type Value = [f64; 3];

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<[f64; 3]> {
        let items = match &node.value {
            Value::List(items) if items.len() == 3 => items,
            _ => {
                let message = match &node.value {
                    Value::List(items) => format!("this station has {} numbers", items.len()),
                    other => format!("a station is three numbers, found {}", other.noun()),
                };
                return Diagnostic::error(message)
                    .at(node.place, "expected [md, inc, azi]")
                    .refuse(reader);
            }
        };
        let cells = Self::cells();
        let mut values = [None; 3];
        for (i, (cell, item)) in cells.iter().zip(items).enumerate() {
            reader.key = ["md", "inc", "azi"][i];
            values[i] = cell.read(item, reader);
        }
        let [Some(md), Some(inclination), Some(azimuth)] = values else {
            return None;
        };
        Some([md, inclination, azimuth])
    }

    fn schema(&self) -> serde_json::Value {
        let cells: Vec<_> = Self::cells().iter().map(Rule::schema).collect();
        json!({ "type": "array", "prefixItems": cells, "minItems": 3, "maxItems": 3 })
    }
}

/// The stations that stand in the case.
pub(crate) fn from_case(listed: &Spanned<Vec<Spanned<[f64; 3]>>>) -> Stations {
    let list = listed.value.iter().map(|at| {
        let [md_m, inclination_rad, azimuth_rad] = at.value;
        Station { md_m, inclination_rad, azimuth_rad }
    });
    Stations {
        list: list.collect(),
        places: listed.value.iter().map(|at| at.place).collect(),
        whole: listed.place,
        tie_in: None,
        notes: Vec::new(),
    }
}

/// The stations of a file beside the case.
pub(crate) fn from_file(
    file: &Spanned<String>,
    said: &Said,
    files: &dyn Files,
    reader: &mut Reader,
) -> Option<Stations> {
    let bytes = read_beside(file, "survey", files, reader)?;
    match read_as(&bytes, &file.value, said) {
        Ok(imported) => Some(Stations {
            list: imported.stations,
            places: Vec::new(),
            whole: file.place,
            tie_in: imported.tie_in,
            notes: imported.notes,
        }),
        Err(error) => {
            let diagnostic = unfit(&error, file, "survey", reader);
            diagnostic.refuse(reader)
        }
    }
}
