//! `[well]`: the survey, the path through it, and the hole around it.

pub(crate) mod casing;
pub(crate) mod hole;
pub(crate) mod programme;
pub(crate) mod roughness;
pub(crate) mod stations;
mod tortuosity;

use wholestring::well::{Hole, Interpolation, Path, PathError, TieIn};
use wholestring_config::prelude::*;
use wholestring_tabular::{Said, under_origin};
use wholestring_units::{Unit, UnitSet};

use crate::well::{
    hole::HoleTable,
    roughness::RoughnessTable,
    stations::{LengthUnit, Listed, StationRule, Stations},
    tortuosity::TortuosityTable,
};

/// Distance beyond the survey's end above which a projection gets a note, m.
const PROJECTION_M: f64 = 50.0;

table! {
    /// Position of the first survey station.
    TieInTable in "[well.tie_in]" {
        /// North of the first station, m unless a unit is given.
        north: f64 = wholestring_config::table::default(coordinate(), 0.0);
        /// East of the first station, m unless a unit is given.
        east: f64 = wholestring_config::table::default(coordinate(), 0.0);
        /// True vertical depth of the first station, m unless a unit is given. Default: its
        /// measured depth, as if the hole were vertical down to it.
        tvd: f64 = optional(coordinate());
    }
}

fn coordinate() -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(-1e7, 1e7), "120 m")
}

table! {
    /// Path, diameter and friction of the hole.
    WellTable in "[well]" {
        /// Survey file, relative to the case, CSV or Excel, with columns md, inc and azi.
        survey: String = optional(Text);
        /// The survey itself, instead of a file: a list of [md, inc, azi] in m, deg and deg; a
        /// station of inclination 0 may lack the azimuth.
        stations: Vec<Spanned<Listed>> = optional(List::of(StationRule, "stations", 100_000));
        /// Unit of the lengths in the survey file, such as "m" or "ft", where the file does not
        /// contain it. Without a unit the file is refused.
        survey_unit: &'static Unit = optional(LengthUnit);
        /// Curve through the survey: "minimum-curvature" (circular arcs, as surveys are computed)
        /// or "spline" (continuous curvature, for a string in motion).
        path: Interpolation = wholestring_config::table::default(
            Choice {
                noun: "a path",
                words: &[
                    ("minimum-curvature", Interpolation::MinimumCurvature),
                    ("spline", Interpolation::Spline),
                ],
            },
            Interpolation::MinimumCurvature,
        );
        /// Position of the first station. Default: the position in the survey file, or on the
        /// vertical under the origin, as deep as its measured depth.
        tie_in: TieInTable = optional(Section::<TieInTable>::RULE);
        /// Roughness and micro-tortuosity of the wall. Default: a smooth wall.
        roughness: RoughnessTable = optional(Section::<RoughnessTable>::RULE);
        /// Tortuosity of a planned path. Default: the plan's smooth curve.
        tortuosity: TortuosityTable = optional(Section::<TortuosityTable>::RULE);
        /// Sections of the hole from the surface down to the bit or deeper.
        hole: Vec<Spanned<HoleTable>> = required(List::tables::<HoleTable>(
            "hole sections ([[well.hole]])", 1000,
        ));
    }
}

impl WellTable {
    /// Returns the survey, from the file or from the case.
    pub(crate) fn stations(
        &self,
        place: Span,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<Stations> {
        let survey = self.survey.optional()?;
        let listed = self.stations.optional()?;
        match (survey, listed) {
            (Some(file), None) => {
                let length_unit = self.survey_unit.optional()?.map(|at| at.value);
                stations::from_file(file, &Said { length_unit, ..Said::default() }, files, reader)
            }
            (None, Some(listed)) => {
                if let Some(unit) = self.survey_unit.optional()? {
                    Diagnostic::warning("`survey_unit` has no effect")
                        .at(unit.place, "it applies to a survey in a file")
                        .at(listed.place, "`stations` in the case are in m, deg, deg")
                        .report(reader);
                }
                Some(stations::from_case(listed))
            }
            (Some(file), Some(listed)) => Diagnostic::error("the survey is given twice")
                .at(listed.place, "`stations` in the case")
                .at(file.place, "`survey` in a file")
                .help("keep one of the two")
                .refuse(reader),
            (None, None) => Diagnostic::error("[well] has no survey")
                .at(place, "`survey` or `stations` is missing")
                .help("survey = \"survey.csv\", or stations = [[0, 0, 0], [1000, 30, 45]]")
                .refuse(reader),
        }
    }

    /// Returns the path through the survey, with its tortuosity.
    pub(crate) fn path(
        &self,
        stations: &mut Stations,
        units: UnitSet,
        reader: &mut Reader,
    ) -> Option<Path> {
        let plan = self.plan(stations, reader)?;
        match self.tortuosity.given() {
            Some(at) => at.value.wind(at.place, plan, stations, units, reader),
            None => Some(plan),
        }
    }

    fn plan(&self, stations: &mut Stations, reader: &mut Reader) -> Option<Path> {
        let tie_in = self.tie_in(stations)?;
        let interpolation = *self.path.get()?;
        stations.check(reader)?;
        match Path::new(&stations.list, interpolation, tie_in) {
            Ok(path) => {
                stations.check_surface(&path, reader)?;
                stations.check_positions(&path, reader);
                Some(path)
            }
            Err(error) => path_error(&error, stations, reader).refuse(reader),
        }
    }

    fn tie_in(&self, stations: &Stations) -> Option<TieIn> {
        let under_origin = under_origin(&stations.list);
        match self.tie_in.optional()? {
            Some(entry) if self.tie_in.given().is_some() => Some(TieIn {
                north_m: *entry.value.north.get()?,
                east_m: *entry.value.east.get()?,
                tvd_m: entry.value.tvd.optional()?.map_or(under_origin.tvd_m, |at| at.value),
            }),
            _ => Some(stations.tie_in.unwrap_or(under_origin)),
        }
    }

    /// Whether hole and survey reach the bit.
    pub(crate) fn reaches(
        &self,
        path: Option<&Path>,
        hole: Option<&Hole>,
        bit_depth_m: f64,
        bit_place: Option<Span>,
        reader: &mut Reader,
    ) -> Option<()> {
        let bit_text = format!("bit at {}", reader.shown(Dimension::Length, bit_depth_m));
        if let Some(path) = path {
            let last_m = path.last_md_m();
            let beyond_m = bit_depth_m - last_m;
            if beyond_m > PROJECTION_M
                && let Some(place) = bit_place
            {
                Diagnostic::warning(format!(
                    "the survey ends at {}, {} above the bit",
                    reader.shown(Dimension::Length, last_m),
                    reader.shown(Dimension::Length, beyond_m)
                ))
                .at(place, "the hole is assumed to continue straight to here")
                .report(reader);
            }
        }
        let end_m = hole?.sections().last()?.to_md_m;
        if bit_depth_m > end_m + 1e-6 {
            let last = self.hole.get()?.last()?;
            let to = last.value.to.at()?;
            let mut diagnostic = Diagnostic::error(format!(
                "the hole ends at {}, but the bit is at {}",
                reader.shown(Dimension::Length, end_m),
                reader.shown(Dimension::Length, bit_depth_m)
            ))
            .at(
                to.place,
                format!("expected {} or more", reader.shown(Dimension::Length, bit_depth_m)),
            );
            if let Some(place) = bit_place {
                diagnostic = diagnostic.at(place, bit_text);
            } else {
                diagnostic = diagnostic.help(
                    "without bit_depth under [operation] the bit is at the last survey station",
                );
            }
            return diagnostic.refuse(reader);
        }
        Some(())
    }
}

/// Reports an error of the core about the survey, at the station that it concerns.
fn path_error(error: &PathError, stations: &mut Stations, reader: &mut Reader) -> Diagnostic {
    let index = error.index().unwrap_or(0);
    let depth = |reader: &Reader, md_m: f64| reader.shown(Dimension::Length, md_m);
    let (message, label, shows_above) = match error {
        PathError::TooFewStations(found) => {
            let message = format!("the survey has {found} station");
            (message, "expected two stations or more".to_owned(), false)
        }
        PathError::DepthNotIncreasing { md_m, previous_md_m, .. } => {
            let (here, above) = (depth(reader, *md_m), depth(reader, *previous_md_m));
            let message =
                format!("measured depth must grow down the survey: {here} follows {above}");
            (message, format!("expected more than {above}"), true)
        }
        PathError::Inclination { inclination_rad, .. } => {
            let degrees = number_text(inclination_rad.to_degrees());
            let message = format!("inclination {degrees} deg is out of range");
            (message, "expected 0 to 180 deg from vertical".to_owned(), false)
        }
        PathError::NotFinite { quantity, .. } => {
            (format!("{quantity} is not a finite number"), String::new(), false)
        }
        PathError::Reversal { .. } => {
            let message = "the hole turns by 180 deg between two stations".to_owned();
            (message, "opposite to the station above".to_owned(), true)
        }
        _ => (short(&error.to_string()), String::new(), false),
    };
    let mut diagnostic = stations.point(Diagnostic::error(message), index, &label, reader);
    if shows_above && index > 0 {
        diagnostic = stations.point(diagnostic, index - 1, "the station above", reader);
    }
    match error {
        PathError::Inclination { .. } => {
            diagnostic.help("the columns are md, inc, azi: are inclination and azimuth exchanged?")
        }
        _ => diagnostic,
    }
}
