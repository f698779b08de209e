//! `trajectory`: the path of the well.

use wholestring::well::{Interpolation, Path, Station, TieIn};
use wholestring_tabular::{StatedPosition, within_a_turn};
use wholestring_units::{Dimension, UnitSet};

use super::{
    measure::{Measure, Source, Units, datum, short},
    object::Object,
    tree::Node,
};
use crate::{
    doubts,
    error::{ImportError, ImportErrorKind},
    fragment::{Fragment, Note, Survey},
};

/// Maximum measured depth of a hole, m.
const DEEPEST_M: f64 = 1e5;

/// A station and the element that contains it.
struct Found<'a> {
    station: Station,
    md: Measure,
    node: &'a Node,
}

/// Numbers of stations by their azimuths.
#[derive(Default)]
struct Azimuths {
    /// Vertical, without an azimuth.
    vertical: usize,
    /// With an azimuth of more than a turn.
    turned: usize,
}

impl Azimuths {
    fn notes(&self) -> impl Iterator<Item = Note> {
        let vertical = (self.vertical > 0).then(|| {
            let stations = stations_of(self.vertical);
            Note::Assumed(format!("the azi of {stations}, vertical and without one: 0"))
        });
        let turned = (self.turned > 0).then(|| {
            let stations = stations_of(self.turned);
            Note::Read(format!("the azi of {stations}, more than 360 deg, is reduced by 360 deg"))
        });
        vertical.into_iter().chain(turned)
    }
}

/// The stations of a trajectory, down the hole.
pub(crate) fn read(
    object: &Object,
    source: &Source,
    fragment: &mut Fragment,
) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let mut units = Units::default();
    let mut stations = Vec::new();
    let (mut rejected, mut without) = (0, 0);
    let mut azimuths = Azimuths::default();
    for node in object.node.all("trajectoryStation") {
        if node.text_of("statusTrajStation") == Some("rejected") {
            rejected += 1;
            continue;
        }
        match station(node, source, &mut units, &mut azimuths)? {
            Some(found) => stations.push(found),
            None => without += 1,
        }
    }
    for (count, why) in [
        (rejected, "with the statusTrajStation 'rejected'"),
        (without, "without inclination and azimuth, of no survey"),
    ] {
        if count > 0 {
            notes.push(Note::LeftOut(format!("{} {why}", stations_of(count))));
        }
    }
    notes.extend(azimuths.notes());
    stations.sort_by(|a, b| a.station.md_m.total_cmp(&b.station.md_m));
    let stations = once(stations, source, notes)?;
    let (Some(first), Some(last)) = (stations.first(), stations.last()) else {
        return Err(too_few(object, source, 0));
    };
    if stations.len() < 2 {
        return Err(too_few(object, source, 1));
    }
    notes.extend(units.note());
    let tie_in = tie_in(first, source, notes)?;
    let set = doubts::unit_set(&units.said());
    notes.extend(positions(&stations, tie_in, source, set)?);
    let list: Vec<Station> = stations.iter().map(|found| found.station).collect();
    notes.extend(doubts::notes(&list, set, |index| line_of(&stations, index)));
    says_how(object, &stations, notes);
    fragment.survey = Some(Survey {
        place: format!(
            "{}, lines {} to {}",
            object.label(),
            stations.iter().map(|found| found.node.line).min().unwrap_or(first.node.line),
            stations.iter().map(|found| found.node.line).max().unwrap_or(last.node.line)
        ),
        units: units.said(),
        tie_in,
        stations: stations.iter().map(|found| found.station).collect(),
    });
    Ok(())
}

/// Reads a station; `None` if it has neither inclination nor azimuth.
fn station<'a>(
    node: &'a Node,
    source: &Source,
    units: &mut Units,
    azimuths: &mut Azimuths,
) -> Result<Option<Found<'a>>, ImportError> {
    let inclination = source.measure(node, "incl", Dimension::Angle)?;
    let azimuth = source.measure(node, "azi", Dimension::Angle)?;
    if inclination.is_none() && azimuth.is_none() {
        return Ok(None);
    }
    let missing = |what: &str| {
        let what = format!("the {what} of this station");
        source.error(node.line, ImportErrorKind::Missing { what })
    };
    let md = source.measure(node, "md", Dimension::Length)?.ok_or_else(|| missing("md"))?;
    let md_m = md.si();
    if !(0.0..=DEEPEST_M).contains(&md_m) {
        return Err(source.out_of_range(&md, "md", "0 to 100 km"));
    }
    let inclination = inclination.ok_or_else(|| missing("incl"))?;
    let inclination_rad = inclination.si();
    if !(0.0..=std::f64::consts::PI).contains(&inclination_rad) {
        return Err(source.out_of_range(&inclination, "incl", "0 to 180 deg"));
    }
    let azimuth_rad = match &azimuth {
        Some(azimuth) => {
            let turn = std::f64::consts::TAU;
            if !(-turn..=2.0 * turn).contains(&azimuth.si()) {
                return Err(source.out_of_range(azimuth, "azi", "-360 to 720 deg"));
            }
            units.add(2, azimuth);
            let (azimuth_rad, is_turned) = within_a_turn(azimuth.si());
            azimuths.turned += usize::from(is_turned);
            azimuth_rad
        }
        // A vertical hole has no azimuth.
        None if inclination_rad == 0.0 => {
            azimuths.vertical += 1;
            0.0
        }
        None => return Err(missing("azi")),
    };
    units.add(0, &md);
    units.add(1, &inclination);
    Ok(Some(Found { station: Station { md_m, inclination_rad, azimuth_rad }, md, node }))
}

/// Keeps one station per depth: the first of identical ones, otherwise the one in use or measured
/// last.
fn once<'a>(
    stations: Vec<Found<'a>>,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<Vec<Found<'a>>, ImportError> {
    let mut unique: Vec<Found> = Vec::with_capacity(stations.len());
    let mut alike = 0;
    for found in stations {
        let Some(last) = unique.last_mut().filter(|last| last.station.md_m == found.station.md_m)
        else {
            unique.push(found);
            continue;
        };
        if last.station == found.station {
            alike += 1;
            continue;
        }
        let rank = |station: &Found<'a>| {
            let in_use = station.node.text_of("statusTrajStation") == Some("position");
            (in_use, station.node.text_of("dTimStn"))
        };
        let (old, new) = (rank(last), rank(&found));
        if old == new {
            let kind = ImportErrorKind::Refused(format!(
                "two stations at {} differ, and neither statusTrajStation nor dTimStn shows which \
                 is valid (the other is in line {}); remove one of them",
                found.md.written, last.node.line
            ));
            return Err(source.error(found.node.line, kind));
        }
        let why = if old.0 == new.0 { "is the later one" } else { "is in use ('position')" };
        let (stays, goes) = if new > old { (&found, &*last) } else { (&*last, &found) };
        notes.push(Note::LeftOut(format!(
            "of two stations at {} that in line {}: the other, in line {}, {why}",
            found.md.written, goes.node.line, stays.node.line
        )));
        if new > old {
            *last = found;
        }
    }
    if alike > 0 {
        notes.push(Note::LeftOut(format!(
            "{} of the same depth as another and identical",
            stations_of(alike)
        )));
    }
    Ok(unique)
}

/// Position of the first station as the file states it.
fn tie_in(
    first: &Found,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<Option<TieIn>, ImportError> {
    let length = |name| -> Result<Option<f64>, ImportError> {
        Ok(source.measure(first.node, name, Dimension::Length)?.map(|measure| measure.si()))
    };
    let (tvd_m, north_m, east_m) = (length("tvd")?, length("dispNs")?, length("dispEw")?);
    let md_m = first.station.md_m;
    let Some(tvd_m) = tvd_m.or((md_m == 0.0).then_some(0.0)) else {
        notes.push(Note::Assumed(format!(
            "the first station, at {}, has no tvd: assumed equal to its measured depth, \
             vertically below the origin",
            first.md.written
        )));
        return Ok(None);
    };
    let tie_in = TieIn { north_m: north_m.unwrap_or(0.0), east_m: east_m.unwrap_or(0.0), tvd_m };
    // The case starts there by default.
    Ok((tie_in != TieIn::default() || md_m != 0.0).then_some(tie_in))
}

/// Notes on the positions that the stations state against those of the path through them.
fn positions(
    stations: &[Found],
    tie_in: Option<TieIn>,
    source: &Source,
    set: UnitSet,
) -> Result<Vec<Note>, ImportError> {
    let list: Vec<Station> = stations.iter().map(|found| found.station).collect();
    let start = tie_in.unwrap_or(TieIn { tvd_m: list[0].md_m, ..TieIn::default() });
    let path = Path::new(&list, Interpolation::MinimumCurvature, start).map_err(|error| {
        let kind = ImportErrorKind::Refused(format!("its stations make no path: {error}"));
        source.error(stations[error.index().unwrap_or(0)].node.line, kind)
    })?;
    let stated = stations.iter().map(|found| {
        let length_m = |name| -> Result<Option<f64>, ImportError> {
            let length = source.optional(found.node, name, Dimension::Length, &mut Vec::new())?;
            Ok(length.map(|length| length.si()))
        };
        Ok(StatedPosition {
            tvd_m: length_m("tvd")?,
            north_m: length_m("dispNs")?,
            east_m: length_m("dispEw")?,
            dogleg_severity_rad_per_m: None,
        })
    });
    let stated = stated.collect::<Result<Vec<_>, ImportError>>()?;
    Ok(doubts::positions(&list, &stated, &path, set, |index| line_of(stations, index)))
}

/// Line of a station in its file: `line 12`.
fn line_of(stations: &[Found], index: usize) -> String {
    stations.get(index).map_or_else(String::new, |found| format!("line {}", found.node.line))
}

/// Adds notes on the properties of the trajectory that an engineer needs to know.
fn says_how(object: &Object, stations: &[Found], notes: &mut Vec<Note>) {
    let node = &object.node;
    notes.extend(datum(stations[0].node.child("md")));
    if let Some(north) = node.text_of("aziRef") {
        notes.push(Note::Read(format!("azimuths are from {}, as written", short(north))));
    }
    for (kind, said) in
        [("interpolated", "interpolated"), ("extrapolated", "extrapolated, not surveyed")]
    {
        let is = |found: &&Found| found.node.text_of("typeTrajStation") == Some(kind);
        let count = stations.iter().filter(is).count();
        if count > 0 {
            notes.push(Note::Read(format!("{} {said}", stations_of(count))));
        }
    }
}

fn stations_of(count: usize) -> String {
    if count == 1 { "1 station".to_owned() } else { format!("{count} stations") }
}

fn too_few(object: &Object, source: &Source, found: usize) -> ImportError {
    let kind = ImportErrorKind::Refused(format!(
        "{} has {} with inclination and azimuth; a path needs two or more",
        object.label(),
        if found == 0 { "no station".to_owned() } else { stations_of(found) }
    ));
    source.error(object.node.line, kind)
}
