//! `[well]`: the survey, the path through it, and the hole around it.

use wholestring::well::{
    Friction, Hole, HoleError, HoleKind, HoleSection, Interpolation, Path, PathError, TieIn,
};
use wholestring_units::Dimension;

use crate::{
    diagnostic::Diagnostic,
    names::short,
    node::{Node, Value},
    reader::Reader,
    rule::{At, Choice, List, Number, Quantity, Range, Rule, Section, Table, Text, number_text},
    source::{Files, Place},
    stations::{self, StationRule, Stations},
    table::{optional, required, table},
};

/// Beyond the survey's end by more than this a projection deserves a word, m.
const PROJECTION_M: f64 = 50.0;

table! {
    /// Position of the first survey station.
    TieInTable in "[well.tie_in]" {
        /// North of the first station, m unless a unit is given. Default 0.
        north: f64 = crate::table::default(coordinate(), 0.0);
        /// East of the first station, m unless a unit is given. Default 0.
        east: f64 = crate::table::default(coordinate(), 0.0);
        /// True vertical depth of the first station, m unless a unit is given. Default: its measured
        /// depth, as if the hole were vertical down to it.
        tvd: f64 = optional(coordinate());
    }
}

fn coordinate() -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(-1e7, 1e7), "120 m")
}

table! {
    /// Friction between string and wall, sliding and at rest.
    FrictionTable in "friction" {
        /// Coefficient while sliding.
        kinetic: f64 = required(coefficient());
        /// Coefficient at rest, at least the kinetic one. Default: the kinetic one.
        r#static: f64 = optional(coefficient());
    }
}

fn coefficient() -> Number {
    Number {
        unit: "",
        range: Range::from_to(0.0, 2.0),
    }
}

/// A coefficient of friction, or a table of two.
pub(crate) struct FrictionRule;

impl Rule for FrictionRule {
    type Value = Friction;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Friction> {
        match &node.value {
            Value::Number { .. } => {
                let kinetic = coefficient().read(node, reader)?;
                Some(Friction {
                    kinetic,
                    at_rest: kinetic,
                })
            }
            Value::Table(entries) => {
                let table = FrictionTable::read(entries, node.place, reader);
                let kinetic = table.kinetic.get()?;
                let Some(at_rest) = table.r#static.optional()? else {
                    return Some(Friction {
                        kinetic: *kinetic,
                        at_rest: *kinetic,
                    });
                };
                if at_rest.value < *kinetic {
                    reader.report(
                        Diagnostic::error("static friction is smaller than kinetic friction")
                            .at(at_rest.place, format!("expected at least {kinetic}")),
                    );
                    return None;
                }
                Some(Friction {
                    kinetic: *kinetic,
                    at_rest: at_rest.value,
                })
            }
            _ => {
                reader.expected(node, "a coefficient such as 0.3, without quotes");
                None
            }
        }
    }

    fn schema(&self) -> serde_json::Value {
        serde_json::json!({ "anyOf": [coefficient().schema(), FrictionTable::schema()] })
    }
}

table! {
    /// A stretch of hole with one diameter, wall and friction; from the surface down.
    HoleTable in "[[well.hole]]" {
        /// "casing" (steel) or "open" (rock).
        kind: HoleKind = required(Choice {
            noun: "a kind of hole",
            words: &[("casing", HoleKind::Casing), ("open", HoleKind::Open)],
        });
        /// Measured depth where it begins. Default: the end of the section above, or the surface; there
        /// can be no other, so that it only serves to check.
        from: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0),
            "0 m",
        ));
        /// Measured depth where it ends, m unless a unit is given.
        to: f64 = required(Quantity::si(
            Dimension::Length,
            Range::positive_to(20_000.0),
            "2986.53 m",
        ));
        /// Diameter of the hole, or inside diameter of the casing, m unless a unit is given.
        diameter: f64 = required(Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.02, 2.0),
            "8-1/2 in",
        ));
        /// Coefficient of friction between string and wall, or { kinetic = 0.25, static = 0.3 }.
        friction: Friction = required(FrictionRule);
        /// Young's modulus of the wall. Default: 210 GPa in casing; 51.5 GPa in open hole, the rock of
        /// the article that the dynamics follow. Used by Hertz contact.
        youngs_modulus: f64 = optional(Quantity::si(
            Dimension::Pressure,
            Range::from_to(1e6, 2e12),
            "51.5 GPa",
        ));
        /// Poisson's ratio of the wall. Default: 0.3 in casing, 0.33 in open hole. Used by Hertz contact.
        poisson_ratio: f64 = optional(Number { unit: "", range: Range::from_to(0.0, 0.5) });
    }
}

/// Elastic constants of a wall where the case does not say: steel, and the rock of Table 1 of *New
/// Analysis Theory and Method for Drag and Torque Based on Full-Hole System Dynamics in Highly
/// Deviated Well*.
const fn wall_constants(kind: HoleKind) -> (f64, f64) {
    match kind {
        HoleKind::Casing => (210e9, 0.3),
        HoleKind::Open => (51.5e9, 0.33),
    }
}

table! {
    /// Where the hole runs and how wide and rough it is.
    WellTable in "[well]" {
        /// Survey file beside the case, CSV or Excel, with columns md, inc and azi.
        survey: String = optional(Text);
        /// The survey itself, instead of a file: a list of [md, inc, azi] in m, deg and deg.
        stations: Vec<At<[f64; 3]>> = optional(List {
            item: StationRule,
            or_one: false,
            noun: "stations",
            most: 100_000,
        });
        /// Curve through the survey: "spline" (default, continuous curvature) or "minimum-curvature"
        /// (circular arcs).
        path: Interpolation = crate::table::default(
            Choice {
                noun: "a path",
                words: &[
                    ("spline", Interpolation::Spline),
                    ("minimum-curvature", Interpolation::MinimumCurvature),
                ],
            },
            Interpolation::Spline,
        );
        /// Position of the first station. Default: what the survey file says, or on the vertical under
        /// the origin, as deep as its measured depth.
        tie_in: TieInTable = optional(Section::<TieInTable>::RULE);
        /// Sections of the hole from the surface down to the bit or deeper.
        hole: Vec<At<HoleTable>> = required(List {
            item: Section::<HoleTable>::RULE,
            or_one: false,
            noun: "hole sections ([[well.hole]])",
            most: 1000,
        });
    }
}

impl WellTable {
    /// The survey, from the file or from the case.
    pub(crate) fn stations(
        &self,
        place: Place,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<Stations> {
        let survey = self.survey.optional()?;
        let listed = self.stations.optional()?;
        match (survey, listed) {
            (Some(file), None) => stations::from_file(file, files, reader),
            (None, Some(listed)) => Some(stations::from_case(listed)),
            (Some(file), Some(listed)) => {
                reader.report(
                    Diagnostic::error("the survey is given twice")
                        .at(listed.place, "`stations` in the case")
                        .at(file.place, "`survey` in a file")
                        .help("keep one of the two"),
                );
                None
            }
            (None, None) => {
                reader.report(
                    Diagnostic::error("[well] has no survey")
                        .at(place, "`survey` or `stations` is missing")
                        .help("survey = \"survey.csv\", or stations = [[0, 0, 0], [1000, 30, 45]]"),
                );
                None
            }
        }
    }

    /// The path through the survey.
    pub(crate) fn path(&self, stations: &Stations, reader: &mut Reader) -> Option<Path> {
        let tie_in = self.tie_in(stations)?;
        let interpolation = *self.path.get()?;
        stations.check(reader)?;
        match Path::new(&stations.list, interpolation, tie_in) {
            Ok(path) => Some(path),
            Err(error) => {
                reader.report(path_error(&error, stations));
                None
            }
        }
    }

    fn tie_in(&self, stations: &Stations) -> Option<TieIn> {
        let under_origin = TieIn {
            tvd_m: stations.list.first().map_or(0.0, |first| first.md_m),
            ..TieIn::default()
        };
        match self.tie_in.optional()? {
            Some(given) if self.tie_in.given().is_some() => Some(TieIn {
                north_m: *given.value.north.get()?,
                east_m: *given.value.east.get()?,
                tvd_m: given
                    .value
                    .tvd
                    .optional()?
                    .map_or(under_origin.tvd_m, |at| at.value),
            }),
            _ => Some(stations.tie_in.unwrap_or(under_origin)),
        }
    }

    /// The sections, one below the other.
    pub(crate) fn hole(&self, reader: &mut Reader) -> Option<Hole> {
        let tables = self.hole.get()?;
        let mut sections = Vec::new();
        let mut above: Option<(f64, Place)> = None;
        let mut sound = true;
        for table in tables {
            let Some(to) = table.value.to.at() else {
                sound = false;
                above = None;
                continue;
            };
            if let Some((above_m, above_place)) = above
                && to.value <= above_m
            {
                reader.report(
                    Diagnostic::error("hole sections must go down")
                        .at(
                            to.place,
                            format!("expected more than {} m", number_text(above_m)),
                        )
                        .at(above_place, "the section above ends here"),
                );
                sound = false;
            } else if let Some(from) = table.value.from.given() {
                sound &= check_from(from, above, sections.is_empty(), reader);
            }
            match section(&table.value, above.map_or(0.0, |(md_m, _)| md_m)) {
                Some(section) => sections.push(section),
                None => sound = false,
            }
            above = Some((to.value, to.place));
        }
        if !sound {
            return None;
        }
        match Hole::new(sections) {
            Ok(hole) => Some(hole),
            Err(error) => {
                reader.report(hole_error(&error, tables));
                None
            }
        }
    }

    /// Whether hole and survey reach the bit.
    pub(crate) fn reaches(
        &self,
        path: Option<&Path>,
        hole: Option<&Hole>,
        bit_depth_m: f64,
        bit_place: Option<Place>,
        reader: &mut Reader,
    ) -> Option<()> {
        let bit_text = format!("bit at {} m", number_text(bit_depth_m));
        if let Some(path) = path {
            let last_m = path.last_md_m();
            let beyond_m = bit_depth_m - last_m;
            if beyond_m > PROJECTION_M
                && let Some(place) = bit_place
            {
                reader.report(
                    Diagnostic::warning(format!(
                        "the survey ends at {} m, {} m above the bit",
                        number_text(last_m),
                        number_text((beyond_m * 100.0).round() / 100.0)
                    ))
                    .at(place, "the hole is taken to go on straight to here"),
                );
            }
        }
        let end_m = hole?.sections().last()?.to_md_m;
        if bit_depth_m > end_m + 1e-6 {
            let last = self.hole.get()?.last()?;
            let to = last.value.to.at()?;
            let mut diagnostic = Diagnostic::error(format!(
                "the hole ends at {} m, but the bit is at {} m",
                number_text(end_m),
                number_text(bit_depth_m)
            ))
            .at(
                to.place,
                format!("expected {} m or more", number_text(bit_depth_m)),
            );
            if let Some(place) = bit_place {
                diagnostic = diagnostic.at(place, bit_text);
            } else {
                diagnostic = diagnostic.help(
                    "without bit_depth under [operation] the bit is at the last survey station",
                );
            }
            reader.report(diagnostic);
            return None;
        }
        Some(())
    }
}

/// Whether a section begins where the one above ends.
fn check_from(
    from: &At<f64>,
    above: Option<(f64, Place)>,
    first: bool,
    reader: &mut Reader,
) -> bool {
    let expected_m = match above {
        Some((md_m, _)) => md_m,
        None if first => 0.0,
        // The section above could not be read.
        None => return true,
    };
    if (from.value - expected_m).abs() <= 1e-6 {
        return true;
    }
    let message = if above.is_none() {
        "the first hole section must begin at the surface"
    } else if from.value < expected_m {
        "hole sections overlap"
    } else {
        "there is a gap between hole sections"
    };
    let mut diagnostic = Diagnostic::error(message).at(
        from.place,
        format!("expected {} m", number_text(expected_m)),
    );
    if let Some((_, place)) = above {
        diagnostic = diagnostic.at(place, "the section above ends here");
    }
    reader.report(diagnostic);
    false
}

fn section(table: &HoleTable, from_md_m: f64) -> Option<HoleSection> {
    let kind = *table.kind.get()?;
    let (youngs_modulus_Pa, poisson_ratio) = wall_constants(kind);
    let youngs_modulus = table.youngs_modulus.optional()?;
    let poisson = table.poisson_ratio.optional()?;
    Some(HoleSection {
        kind,
        from_md_m,
        to_md_m: *table.to.get()?,
        diameter_m: *table.diameter.get()?,
        friction: *table.friction.get()?,
        youngs_modulus_Pa: youngs_modulus.map_or(youngs_modulus_Pa, |at| at.value),
        poisson_ratio: poisson.map_or(poisson_ratio, |at| at.value),
    })
}

/// What the core says about the sections, at the one that it says it of.
fn hole_error(error: &HoleError, tables: &[At<HoleTable>]) -> Diagnostic {
    let index = match error {
        HoleError::OutOfRange { index, .. }
        | HoleError::Reversed { index, .. }
        | HoleError::Apart { index, .. } => *index,
        _ => 0,
    };
    let place = tables
        .get(index)
        .map(|table| table.place)
        .unwrap_or_default();
    Diagnostic::error(error.to_string()).at(place, "this section")
}

/// What the core says about the survey, at the station that it says it of.
fn path_error(error: &PathError, stations: &Stations) -> Diagnostic {
    let at = |index: usize| stations.place(index);
    match error {
        PathError::TooFewStations(found) => {
            Diagnostic::error(format!("the survey has {found} station"))
                .at(at(0), "expected two stations or more")
        }
        PathError::DepthNotIncreasing {
            index,
            md_m,
            previous_md_m,
        } => Diagnostic::error(format!(
            "measured depth must grow down the survey: {} m follows {} m",
            number_text(*md_m),
            number_text(*previous_md_m)
        ))
        .at(
            at(*index),
            format!("expected more than {} m", number_text(*previous_md_m)),
        )
        .at(at(index - 1), "the station above"),
        PathError::Inclination {
            index,
            inclination_rad,
            ..
        } => Diagnostic::error(format!(
            "inclination {} deg is out of range",
            number_text(inclination_rad.to_degrees())
        ))
        .at(at(*index), "expected 0 to 180 deg from vertical")
        .help("the columns are md, inc, azi: are inclination and azimuth exchanged?"),
        PathError::NotFinite {
            index, quantity, ..
        } => Diagnostic::error(format!("{quantity} is not a finite number")).at(at(*index), ""),
        PathError::Reversal { index, .. } => {
            Diagnostic::error("the hole turns by 180 deg between two stations")
                .at(at(*index), "opposite to the station above")
                .at(at(index - 1), "the station above")
        }
        _ => Diagnostic::error(short(&error.to_string())).at(at(0), ""),
    }
}
