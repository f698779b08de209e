//! Survey stations, from the case or from a file, each with its place.

use serde_json::json;
use wholestring::well::{Interpolation, Path, Station, TieIn};
use wholestring_config::prelude::*;
use wholestring_tabular::{
    ImportedSurvey, Place, PositionCheck, Said, is_null, position_checks, read_as, station_doubts,
    straight_start, surface_doubts,
};
use wholestring_units::Unit;

use crate::beside::{read_beside, unfit};

/// Sharpest turn of a hole, rad/m: 10 deg/m is a radius of 5.7 m.
const SHARPEST_RAD_PER_M: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// Number of doubtful turns that are reported one by one.
const MAX_DOUBTS: usize = 5;

/// A survey and the places of its stations.
#[derive(Debug)]
pub(crate) struct Stations {
    pub(crate) list: Vec<Station>,
    /// One for each station, if the case contains them.
    places: Vec<Span>,
    /// The survey as a whole.
    whole: Span,
    /// Position of the first station, if the survey's file gives it.
    pub(crate) tie_in: Option<TieIn>,
    /// Interpretation of the file.
    pub(crate) notes: Vec<String>,
    /// The file, and its index among the reader's texts, once a place in it was named.
    file: Option<(ImportedSurvey, String, Option<usize>)>,
}

impl Stations {
    /// Returns the place of the first station in the case, or of the key that names the file.
    pub(crate) fn first_place(&self) -> Span {
        self.places.first().copied().unwrap_or(self.whole)
    }

    /// Returns the place of a station: in the case, or in the file of the survey.
    pub(crate) fn point(
        &mut self,
        diagnostic: Diagnostic,
        index: usize,
        text: &str,
        reader: &mut Reader,
    ) -> Diagnostic {
        if let Some(place) = self.places.get(index) {
            return diagnostic.at(*place, text);
        }
        let is_first = diagnostic.labels.is_empty();
        let Some((survey, name, source)) = &mut self.file else {
            return diagnostic.at(self.whole, text);
        };
        match (survey.places.place(index), survey.places.text()) {
            (Some(Place::Text { span, .. }), Some(whole)) => {
                let source = *source.get_or_insert_with(|| reader.add_source(name, whole));
                let place = Span { source, start: span.start, end: span.end };
                let diagnostic = diagnostic.at(place, text);
                if is_first { diagnostic.at(self.whole, "the survey") } else { diagnostic }
            }
            (Some(_), _) => {
                let row = survey.places.row_name(index);
                diagnostic.at(self.whole, format!("{row}: {text}"))
            }
            (None, _) => diagnostic.at(self.whole, text),
        }
    }

    /// Warns of turns that exceed the endurance of pipe of this outside diameter, m, and of
    /// stations that are probably slips.
    pub(crate) fn check_turns(&mut self, endured_rad_per_m: f64, reader: &mut Reader) {
        let doubts = station_doubts(&self.list, endured_rad_per_m, reader.units());
        let more = doubts.len().saturating_sub(MAX_DOUBTS);
        for (count, doubt) in doubts.into_iter().take(MAX_DOUBTS).enumerate() {
            let diagnostic = Diagnostic::warning(doubt.sentence);
            let mut diagnostic = self.point(diagnostic, doubt.index, &doubt.label, reader);
            diagnostic = diagnostic.help(doubt.help);
            if count + 1 == MAX_DOUBTS && more > 0 {
                diagnostic = diagnostic.help(format!("and {more} more turns of this kind"));
            }
            diagnostic.report(reader);
        }
    }

    /// Compares the positions that the file has with those of the path through its stations.
    pub(crate) fn check_positions(&mut self, path: &Path, reader: &mut Reader) {
        let Some((survey, ..)) = &self.file else { return };
        let set = reader.units();
        let compared = |path: &Path| position_checks(&survey.stations, &survey.stated, path, set);
        let checks = compared(path);
        let agrees = |checks: &[PositionCheck]| checks.iter().all(|check| check.agrees);
        let by_arcs = path.interpolation() == Interpolation::Spline && !agrees(&checks) && {
            let arcs = Path::new(&self.list, Interpolation::MinimumCurvature, path.tie_in());
            arcs.is_ok_and(|arcs| agrees(&compared(&arcs)))
        };
        for check in checks {
            if check.agrees {
                self.notes.push(check.sentence);
                continue;
            }
            let diagnostic = Diagnostic::warning(check.sentence);
            let diagnostic = self.point(diagnostic, check.index, "the file's position", reader);
            match by_arcs {
                true => {
                    diagnostic.help("by minimum curvature they agree: path = \"minimum-curvature\"")
                }
                false => diagnostic.help(check.reason),
            }
            .report(reader);
        }
    }

    /// Refuses a path to which no hole from the surface leads, and notes its course above the first
    /// station.
    pub(crate) fn check_surface(&mut self, path: &Path, reader: &mut Reader) -> Option<()> {
        let set = reader.units();
        if let Some(doubt) = surface_doubts(path, set).into_iter().next() {
            let diagnostic = Diagnostic::error(doubt.sentence);
            let diagnostic = self.point(diagnostic, doubt.index, &doubt.label, reader);
            return diagnostic.help(doubt.help).refuse(reader);
        }
        self.notes.extend(straight_start(path, set));
        Some(())
    }

    /// Checks for values that no survey has, although the engine could compute with them.
    pub(crate) fn check(&mut self, reader: &mut Reader) -> Option<()> {
        for (index, station) in self.list.clone().iter().enumerate() {
            if !(-1000.0..=20_000.0).contains(&station.md_m) {
                let diagnostic = Diagnostic::error(format!(
                    "measured depth {} is deeper than any well",
                    reader.shown(Dimension::Length, station.md_m)
                ));
                let most = reader.shown(Dimension::Length, 20_000.0);
                return self
                    .point(diagnostic, index, &format!("expected at most {most}"), reader)
                    .refuse(reader);
            }
        }
        for (index, pair) in self.list.clone().windows(2).enumerate() {
            let [above, below] = pair else { continue };
            let length_m = below.md_m - above.md_m;
            let turn_rad = angle_between(above, below);
            // The path reports a step that is too small or backwards.
            if length_m > 1e-3 && turn_rad / length_m > SHARPEST_RAD_PER_M {
                let diagnostic = Diagnostic::error(format!(
                    "the hole bends by {} deg within {} below {}",
                    number_text((turn_rad.to_degrees() * 10.0).round() / 10.0),
                    reader.shown(Dimension::Length, length_m),
                    reader.shown(Dimension::Length, above.md_m)
                ));
                return self
                    .point(diagnostic, index + 1, "expected at most 10 deg per metre", reader)
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
            let message = format!("`{}` is not a unit of length", short(text));
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

/// A station as it is listed in the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Listed {
    md_m: f64,
    inclination_rad: f64,
    /// None of a vertical hole, which needs no azimuth.
    azimuth_rad: Option<f64>,
}

/// A station in the case: `[md, inc, azi]`; a vertical one may lack the azimuth.
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

/// Whether a value is `nan` or a null of databases, which stand for no value.
fn is_missing(node: &Node) -> bool {
    matches!(node.value, Value::Number { value, .. } if value.is_nan() || is_null(value))
}

impl Rule for StationRule {
    type Value = Listed;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Listed> {
        let items = match &node.value {
            Value::List(items) if (2..=3).contains(&items.len()) => items,
            _ => {
                let message = match &node.value {
                    Value::List(items) if items.len() == 1 => {
                        "this station has 1 number".to_owned()
                    }
                    Value::List(items) => format!("this station has {} numbers", items.len()),
                    other => format!("a station is three numbers, found {}", other.noun()),
                };
                return Diagnostic::error(message)
                    .at(node.place, "expected [md, inc, azi]")
                    .refuse(reader);
            }
        };
        let azimuth = items.get(2).filter(|azimuth| !is_missing(azimuth));
        let cells = Self::cells();
        let mut read = |place: usize, item: &Node| {
            reader.key = ["md", "inc", "azi"][place];
            cells[place].read(item, reader)
        };
        let md_m = read(0, &items[0]);
        let inclination_rad = read(1, &items[1]);
        let azimuth_rad = match azimuth {
            Some(item) => Some(read(2, item)?),
            None => None,
        };
        let (md_m, inclination_rad) = (md_m?, inclination_rad?);
        if azimuth_rad.is_none() && inclination_rad != 0.0 {
            let (place, found) = match items.get(2) {
                Some(item) => (item.place, "it has no value"),
                None => (node.place, "expected [md, inc, azi]"),
            };
            let degrees = number_text((inclination_rad.to_degrees() * 100.0).round() / 100.0);
            return Diagnostic::error(format!(
                "the station at {} has an inclination of {degrees} deg and no azimuth",
                reader.shown(Dimension::Length, md_m)
            ))
            .at(place, found)
            .help("only a vertical station, of inclination 0, needs no azimuth")
            .refuse(reader);
        }
        Some(Listed { md_m, inclination_rad, azimuth_rad })
    }

    fn schema(&self) -> serde_json::Value {
        let cells: Vec<_> = Self::cells().iter().map(Rule::schema).collect();
        json!({ "type": "array", "prefixItems": cells, "minItems": 2, "maxItems": 3 })
    }
}

/// Returns the stations in the case.
pub(crate) fn from_case(listed: &Spanned<Vec<Spanned<Listed>>>) -> Stations {
    let mut notes = Vec::new();
    let mut rows: Vec<&Spanned<Listed>> = listed.value.iter().collect();
    let is_turned = rows.len() > 2
        && rows.is_sorted_by(|a, b| a.value.md_m >= b.value.md_m)
        && rows.first().map(|row| row.value.md_m) > rows.last().map(|row| row.value.md_m);
    if is_turned {
        rows.reverse();
        notes.push("the deepest station is listed first: the list is reversed".to_owned());
    }
    let count = rows.len();
    rows.dedup_by(|below, above| below.value == above.value);
    match count - rows.len() {
        0 => {}
        1 => notes.push("1 station is identical to the one above and is left out".to_owned()),
        left => {
            notes.push(format!("{left} stations are identical to those above and are left out"));
        }
    }
    let without = rows.iter().filter(|row| row.value.azimuth_rad.is_none()).count();
    if without > 0 {
        let stations =
            if without == 1 { "1 station".to_owned() } else { format!("{without} stations") };
        notes.push(format!("the azimuth of {stations}, vertical and without one, is taken as 0"));
    }
    let list = rows.iter().map(|row| {
        let Listed { md_m, inclination_rad, azimuth_rad } = row.value;
        Station { md_m, inclination_rad, azimuth_rad: azimuth_rad.unwrap_or(0.0) }
    });
    Stations {
        list: list.collect(),
        places: rows.iter().map(|row| row.place).collect(),
        whole: listed.place,
        tie_in: None,
        notes,
        file: None,
    }
}

/// Reads the stations of a file that the case names.
pub(crate) fn from_file(
    file: &Spanned<String>,
    hints: &Said,
    files: &dyn Files,
    reader: &mut Reader,
) -> Option<Stations> {
    let bytes = read_beside(file, "survey", files, reader)?;
    match read_as(&bytes, &file.value, hints) {
        Ok(mut imported) => Some(Stations {
            list: imported.stations.clone(),
            places: Vec::new(),
            whole: file.place,
            tie_in: imported.tie_in,
            notes: std::mem::take(&mut imported.notes),
            file: Some((imported, file.value.clone(), None)),
        }),
        Err(error) => {
            let diagnostic = unfit(&error, file, "survey", reader);
            diagnostic.refuse(reader)
        }
    }
}
