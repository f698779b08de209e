//! The path of a wellbore.

use wholestring::well::{Interpolation, Path, Station, TieIn};
use wholestring_tabular::{StatedPosition, within_a_turn};

use super::{
    chooser::{Chosen, label},
    datum::Depths,
    reader::{Reader, agree, children, parent},
    row::Row,
    table::Table,
    unit_set::Measure,
};
use crate::{
    doubts,
    error::{ImportError, ImportErrorKind},
    fragment::Survey,
};

const KEYS: [&str; 3] = ["well_id", "wellbore_id", "def_survey_header_id"];

/// Tolerance within which depths are equal, m.
const SAME_M: f64 = 1e-3;

/// Reads the chosen path and the reference of its depths.
pub(super) fn read<'a>(
    reader: &mut Reader<'a>,
    chosen: &Chosen<'a>,
) -> Result<(Option<Survey>, Depths), ImportError> {
    let Some(header) = header(reader, chosen)? else {
        reader.left_out("the path of the well, because the file has none of this wellbore");
        return Ok((None, Depths::default()));
    };
    let rows = children(reader.rows, Table::SurveyStation, header, &KEYS)?;
    let (rows, order) = sorted(reader, rows)?;
    let mut stations: Vec<(Station, Row)> = Vec::with_capacity(rows.len());
    let mut depths = Depths::default();
    let mut turned = 0;
    for row in rows {
        let lacks = |column: &str| {
            row.error(column, ImportErrorKind::Missing { what: format!("{column} of a station") })
        };
        let md = reader.units.quantity(row, "md", Measure::Length)?.ok_or_else(|| lacks("md"))?;
        if stations.is_empty() {
            depths = Depths::found(reader, chosen, md)?;
        }
        let angle = |column: &str, range: std::ops::RangeInclusive<f64>| {
            let degrees = row.number(column)?.ok_or_else(|| lacks(column))?;
            let kind = || ImportErrorKind::OutOfRange {
                what: column.to_owned(),
                found: format!("{degrees} deg"),
                expected: format!("{} to {} deg", range.start(), range.end()),
            };
            if range.contains(&degrees) { Ok(degrees) } else { Err(row.error(column, kind())) }
        };
        let (azimuth_rad, is_turned) =
            within_a_turn(angle("azimuth", -360.0..=720.0)?.to_radians());
        turned += usize::from(is_turned);
        let station = Station {
            md_m: md.si() + depths.shift_m,
            inclination_rad: angle("inclination", 0.0..=180.0)?.to_radians(),
            azimuth_rad,
        };
        match stations.last() {
            Some((above, _)) if station.md_m - above.md_m < SAME_M => {
                if station.inclination_rad == above.inclination_rad
                    && station.azimuth_rad == above.azimuth_rad
                {
                    reader.read(format!(
                        "the station at {} of line {} is a duplicate and is skipped",
                        md.text(),
                        row.line()
                    ));
                    continue;
                }
                let kind = ImportErrorKind::Refused(format!(
                    "two stations at {} have different angles",
                    md.text()
                ));
                return Err(row.error("md", kind));
            }
            _ => stations.push((station, row)),
        }
    }
    if turned > 0 {
        reader.read(format!(
            "the azimuth of {turned} station{}, more than 360 deg, is reduced by 360 deg",
            if turned == 1 { "" } else { "s" }
        ));
    }
    if stations.len() < 2 {
        reader.left_out(format!(
            "the path '{}', which has {} stations of the two it needs",
            label(header),
            stations.len()
        ));
        return Ok((None, depths));
    }
    let unit = reader.units.of(Measure::Length).symbol;
    let list: Vec<Station> = stations.iter().map(|(station, _)| *station).collect();
    let place = |index: usize| {
        let row = stations.get(index).map(|(_, row)| row);
        row.map_or_else(String::new, |row| format!("line {}", row.line()))
    };
    let set = doubts::unit_set(unit);
    let tie_in = tie_in(reader, &stations[0], depths)?;
    let stated = stated(reader, &stations, depths)?;
    let start = tie_in.unwrap_or(TieIn { tvd_m: list[0].md_m, ..TieIn::default() });
    let path = Path::new(&list, Interpolation::MinimumCurvature, start).map_err(|error| {
        let row = &stations[error.index().unwrap_or(0)].1;
        row.error("md", ImportErrorKind::Refused(format!("its stations make no path: {error}")))
    })?;
    let notes = doubts::positions(&list, &stated, &path, set, place).into_iter();
    reader.notes.extend(notes.chain(doubts::notes(&list, set, place)));
    let phase = header.get("phase").map_or(String::new(), |phase| format!(" ({phase})"));
    let survey = Survey {
        tie_in,
        place: format!(
            "{} stations of wellpath '{}'{phase}, {order}",
            stations.len(),
            label(header)
        ),
        units: format!("{unit}, deg, deg"),
        stations: list,
    };
    Ok((Some(survey), depths))
}

/// Returns the header of the path: the picked one, the scenario's, or the only one of the wellbore.
fn header<'a>(
    reader: &mut Reader<'a>,
    chosen: &Chosen<'a>,
) -> Result<Option<Row<'a>>, ImportError> {
    if let Some(path) = chosen.path {
        return Ok(Some(path));
    }
    let Some(case) = chosen.case else { return Ok(None) };
    let mut own: Vec<Row> = Vec::new();
    let all = reader.rows.of(Table::SurveyHeader);
    for row in all.filter(|row| agree(case, *row, &["well_id", "wellbore_id"])) {
        if !own.iter().any(|known| known.same(row)) {
            own.push(row);
        }
    }
    let names = || own.iter().map(|row| label(*row).to_owned()).collect::<Vec<_>>();
    if let Some(picked) = reader.choices.picked("wellpath") {
        let found = own.iter().find(|row| {
            label(**row).eq_ignore_ascii_case(picked)
                || row.get("def_survey_header_id") == Some(picked)
        });
        let kind = || ImportErrorKind::NoSuch {
            what: "wellpath".to_owned(),
            name: picked.to_owned(),
            names: names(),
        };
        return found.map(|row| Some(*row)).ok_or_else(|| reader.rows.error(kind()));
    }
    let named = match chosen.scenario {
        Some(scenario) => match parent(reader.rows, Table::SurveyHeader, scenario, &KEYS)? {
            Some(found) => return Ok(Some(found)),
            None => scenario.get("def_survey_header_id").map(|id| (scenario, id)),
        },
        None => None,
    };
    if let Some((scenario, id)) = named {
        // The stations may be present without their header.
        let without = children(reader.rows, Table::SurveyStation, scenario, &KEYS)?;
        if !without.is_empty() {
            reader.read(format!("the path '{id}' of the scenario has stations and no header"));
            return Ok(Some(scenario));
        }
        reader.read(format!(
            "the scenario '{}' refers to the path '{id}', which the file does not have",
            label(scenario)
        ));
    }
    match own[..] {
        [] => Ok(None),
        [only] => {
            let why = "the only one of its wellbore; no scenario names it";
            reader.assumed(format!("the path is '{}', {why}", label(only)));
            Ok(Some(only))
        }
        _ => {
            let kind = ImportErrorKind::Ambiguous { what: "wellpath".to_owned(), names: names() };
            Err(reader.rows.error(kind))
        }
    }
}

/// Sorts the stations by number, or by depth if the numbers do not increase with depth.
fn sorted<'a>(
    reader: &mut Reader,
    rows: Vec<Row<'a>>,
) -> Result<(Vec<Row<'a>>, &'static str), ImportError> {
    let mut numbered = Vec::with_capacity(rows.len());
    for row in rows {
        let (number, md) = (row.number("sequence_no")?, row.number("md")?);
        numbered.push((number, md.unwrap_or(f64::NAN), row));
    }
    let all = numbered.iter().all(|(number, ..)| number.is_some());
    if all {
        let key = |number: Option<f64>| number.unwrap_or(f64::NAN);
        numbered.sort_by(|a, b| key(a.0).total_cmp(&key(b.0)));
        if numbered.is_sorted_by(|a, b| a.1 <= b.1) {
            return Ok((numbered.into_iter().map(|(.., row)| row).collect(), "by sequence_no"));
        }
        reader.warning("the numbers of the stations (sequence_no) do not go down the hole");
    }
    numbered.sort_by(|a, b| a.1.total_cmp(&b.1));
    Ok((numbered.into_iter().map(|(.., row)| row).collect(), "by md"))
}

/// Position of the first station, unless it is at the surface.
fn tie_in(
    reader: &mut Reader,
    (first, row): &(Station, Row),
    depths: Depths,
) -> Result<Option<TieIn>, ImportError> {
    if first.md_m < SAME_M {
        return Ok(None);
    }
    let place = |column| reader.units.quantity(*row, column, Measure::Length);
    let found = (place("tvd")?, place("offset_north")?, place("offset_east")?);
    let (Some(tvd), Some(north), Some(east)) = found else {
        reader.assumed(format!(
            "the path begins at {} m and not at the surface; the hole is vertical above",
            (first.md_m * 100.0).round() / 100.0
        ));
        return Ok(None);
    };
    Ok(Some(TieIn { north_m: north.si(), east_m: east.si(), tvd_m: tvd.si() + depths.shift_m }))
}

/// Positions of the stations in the file, relative to the depth reference.
fn stated(
    reader: &Reader,
    stations: &[(Station, Row)],
    depths: Depths,
) -> Result<Vec<StatedPosition>, ImportError> {
    let unit = reader.units.of(Measure::Length);
    let of_row = |(_, row): &(Station, Row)| {
        // A zero means that no value was entered.
        let length_m = |column| -> Result<Option<f64>, ImportError> {
            let written = row.number(column)?.filter(|number| *number != 0.0);
            Ok(written.map(|number| unit.to_si(number)))
        };
        Ok(StatedPosition {
            tvd_m: length_m("tvd")?.map(|tvd_m| tvd_m + depths.shift_m),
            north_m: length_m("offset_north")?,
            east_m: length_m("offset_east")?,
            dogleg_severity_rad_per_m: None,
        })
    };
    stations.iter().map(of_row).collect()
}
