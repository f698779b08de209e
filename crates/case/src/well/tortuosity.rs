//! `[well.tortuosity]`: deviations of the drilled path from the planned one.

use std::f64::consts::{PI, TAU};

use serde_json::{Value as Json, json};
use wholestring::well::{Path, Tortuosity, TortuosityKind};
use wholestring_config::prelude::*;
use wholestring_units::UnitSet;

use crate::well::stations::Stations;

const DEGREE: f64 = PI / 180.0;

/// The forms by name.
const KINDS: &[(&str, TortuosityKind)] = &[
    ("random", TortuosityKind::Random),
    ("sinusoidal", TortuosityKind::Sinusoidal),
    ("helical", TortuosityKind::Helical),
];

/// Sharpest turn of a hole, rad/m.
const SHARPEST_RAD_PER_M: f64 = 10.0 * DEGREE;

/// Maximum number of stations of a plan.
const MOST_STATIONS: f64 = 50_000.0;

/// Distance of stations, as a part of a period, below which a survey has measured its waves.
const MEASURED: f64 = 0.5;

table! {
    /// Tortuosity of a planned path: small angles are added to its smooth curve, as in planning
    /// practice, so that a plan has the doglegs that drilling adds. All models follow it. Not for a
    /// survey with close stations, which already includes them.
    TortuosityTable in "[well.tortuosity]" {
        /// Form: "random" (inclination at each course length), "sinusoidal" (a sine of measured
        /// depth) or "helical" (a helix about the plan). In the first two forms an angle in
        /// inclination is combined with half of it across the hole, an azimuth that depends on the
        /// inclination.
        kind: TortuosityKind = default(
            Choice { noun: "a form of tortuosity", words: KINDS },
            TortuosityKind::Random,
        );
        /// Largest angle in inclination, of a helix to any side; a bare number is in degrees.
        /// Raising it raises doglegs, torque and drag in proportion.
        amplitude: f64 = default(
            Quantity::si(
                Dimension::Angle,
                Range::from_to(0.0, 10.0 * DEGREE).usual(0.02 * DEGREE, 3.0 * DEGREE),
                "0.5 deg",
            )
            .bare("deg", DEGREE),
            0.0,
        );
        /// Length of a wave, or the course length after which the next random angle is drawn.
        /// Raising it lowers doglegs, torque and drag in proportion.
        period: f64 = default(
            Quantity::si(Dimension::Length, Range::from_to(1.0, 10_000.0).usual(9.0, 1000.0), "100 m"),
            30.0,
        );
        /// Measured depth where it begins. Default: the first station.
        from: f64 = optional(depth());
        /// Measured depth where it ends. Default: the last station.
        to: f64 = optional(depth());
        /// Seed of the random angles: another one gives another path with the same statistics.
        seed: u64 = default(Whole, 1);
    }
}

fn depth() -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(0.0, 20_000.0).usual(1.0, 13_000.0), "600 m")
}

impl TortuosityTable {
    /// Returns the path with its tortuosity, and a sentence on its effect.
    pub(crate) fn wind(
        &self,
        place: Span,
        plan: Path,
        stations: &mut Stations,
        units: UnitSet,
        reader: &mut Reader,
    ) -> Option<Path> {
        let tortuosity = self.build(&plan, place, reader)?;
        self.warn(&tortuosity, stations, reader);
        if tortuosity.amplitude_rad == 0.0 {
            return Some(plan);
        }
        let wound = match plan.with_tortuosity(&tortuosity) {
            Ok(wound) => wound,
            Err(error) => {
                return Diagnostic::error("no path has this tortuosity")
                    .at(place, short(&error.to_string()))
                    .refuse(reader);
            }
        };
        let length_m = plan.last_md_m() - plan.first_md_m();
        let unit = Dimension::DoglegSeverity.unit_in(units);
        let severity =
            |turn_rad: f64| format!("{:.2} {}", unit.from_si(turn_rad / length_m), unit.symbol);
        stations.notes.push(format!(
            "tortuosity adds {} to {} of dogleg severity, in the mean of {} stations",
            severity(wound.turn_rad() - plan.turn_rad()),
            severity(plan.turn_rad()),
            wound.stations().len(),
        ));
        Some(wound)
    }

    fn build(&self, plan: &Path, place: Span, reader: &mut Reader) -> Option<Tortuosity> {
        let ends = [(&self.from, plan.first_md_m()), (&self.to, plan.last_md_m())];
        let mut md_m = [0.0; 2];
        for ((field, default), md_m) in ends.into_iter().zip(&mut md_m) {
            *md_m = field.optional()?.map_or(default, |at| at.value);
        }
        let tortuosity = Tortuosity {
            kind: *self.kind.get()?,
            amplitude_rad: *self.amplitude.get()?,
            period_m: *self.period.get()?,
            md_m,
            seed: *self.seed.get()?,
        };
        let [from_m, to_m] = md_m;
        let (first_m, last_m) = (plan.first_md_m(), plan.last_md_m());
        for field in [&self.from, &self.to] {
            if let Some(entry) = field.given()
                && !(first_m..=last_m).contains(&entry.value)
            {
                return Diagnostic::error("the tortuosity extends beyond the survey")
                    .at(
                        entry.place,
                        format!(
                            "expected {} to {}",
                            reader.shown(Dimension::Length, first_m),
                            reader.shown(Dimension::Length, last_m)
                        ),
                    )
                    .refuse(reader);
            }
        }
        let end = self.to.given().or(self.from.given());
        if to_m <= from_m {
            return Diagnostic::error("the tortuosity ends above its beginning")
                .at(
                    end.map_or(place, |at| at.place),
                    format!(
                        "it would act from {} to {}",
                        reader.shown(Dimension::Length, from_m),
                        reader.shown(Dimension::Length, to_m)
                    ),
                )
                .refuse(reader);
        }
        let amplitude = self.amplitude.place().unwrap_or(place);
        let sharpest_rad_per_m = TAU * tortuosity.amplitude_rad / tortuosity.period_m;
        if sharpest_rad_per_m > SHARPEST_RAD_PER_M {
            let most_deg = SHARPEST_RAD_PER_M * tortuosity.period_m / TAU / DEGREE;
            return Diagnostic::error("the hole would bend by more than 10 deg per metre")
                .at(amplitude, format!("expected at most {most_deg:.2} deg"))
                .help("raise the period or lower the amplitude")
                .refuse(reader);
        }
        let count = (to_m - from_m) / tortuosity.spacing_m();
        if tortuosity.amplitude_rad > 0.0 && count > MOST_STATIONS {
            return Diagnostic::error(format!("the tortuosity needs {count:.0} stations"))
                .at(self.period.place().unwrap_or(place), "expected at most 50000")
                .help("raise the period")
                .refuse(reader);
        }
        Some(tortuosity)
    }

    fn warn(&self, tortuosity: &Tortuosity, stations: &Stations, reader: &mut Reader) {
        if tortuosity.amplitude_rad == 0.0 {
            let others = [
                self.kind.place(),
                self.period.given().map(|at| at.place),
                self.seed.given().map(|at| at.place),
            ];
            if let Some(place) = others.into_iter().flatten().next() {
                Diagnostic::warning("[well.tortuosity] has no effect here")
                    .at(place, "used with `amplitude`")
                    .report(reader);
            }
            return;
        }
        if let (Some(seed), false) = (self.seed.given(), tortuosity.kind == TortuosityKind::Random)
        {
            Diagnostic::idle("seed", seed.place, "used with kind = \"random\"")
                .chosen("the form", self.kind.place(), "random")
                .report(reader);
        }
        let within = |md_m: f64| (tortuosity.md_m[0]..=tortuosity.md_m[1]).contains(&md_m);
        let depths = stations.list.iter().map(|station| station.md_m);
        let depths: Vec<f64> = depths.filter(|md_m| within(*md_m)).collect();
        let mut spacings: Vec<f64> = depths.windows(2).map(|pair| pair[1] - pair[0]).collect();
        spacings.sort_by(f64::total_cmp);
        let Some(median_m) = spacings.get(spacings.len() / 2).filter(|_| spacings.len() > 2) else {
            return;
        };
        if *median_m <= MEASURED * tortuosity.period_m {
            let every = reader.shown(Dimension::Length, *median_m);
            Diagnostic::warning("a survey has its tortuosity already")
                .at(
                    self.period.place().unwrap_or(stations.first_place()),
                    format!("stations every {every} have measured such waves"),
                )
                .help("it is meant for a plan, or for waves shorter than two of its stations")
                .report(reader);
        }
    }

    /// Returns its record.
    pub(crate) fn settings(&self) -> Option<Json> {
        let word = KINDS.iter().find(|(_, kind)| Some(kind) == self.kind.get());
        let end = |field: &Field<f64>| field.given().map(|at| at.value);
        Some(json!({
            "kind": word?.0,
            "amplitude_rad": self.amplitude.get()?,
            "period_m": self.period.get()?,
            "from_m": end(&self.from),
            "to_m": end(&self.to),
            "seed": self.seed.get()?,
        }))
    }
}
