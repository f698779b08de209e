//! `[well.roughness]`: deviations of the wall that neither survey nor caliper shows.

use std::f64::consts::TAU;

use wholestring::{
    string::DrillString,
    well::{Hole, Roughness},
};
use wholestring_config::prelude::*;

/// Largest slope of a roughness, rad, because steps follow it to first order.
const STEEPEST: f64 = 0.3;

/// Height of the wall's peaks that a tool should pass, in root mean squares.
const PEAK: f64 = 3.0;

table! {
    /// Roughness and micro-tortuosity of the wall, random but the same for the same seed. The
    /// dynamic model includes it; the soft string assumes a smooth wall.
    RoughnessTable in "[well.roughness]" {
        /// Root mean square of the radius about the nominal one, m unless a unit is given. Raising
        /// it increases the variation of contact forces while the string moves along the hole.
        rms: f64 = default(amplitude("1 mm"), 0.0);
        /// Root mean square distance of the hole's axis from the surveyed path, m unless a unit is
        /// given. Raising it bends the string more between its contacts.
        tortuosity: f64 = default(amplitude("5 mm"), 0.0);
        /// Shortest wavelength along the hole. Waves shorter than two elements act at the nodes,
        /// but are not resolved; shorter waves slow the computation of a string that moves axially.
        shortest_wavelength: f64 = default(wavelength("2 m"), 2.0);
        /// Longest wavelength, at least 1.2 times the shortest. Each octave between them contains
        /// the same part of the roughness.
        longest_wavelength: f64 = default(wavelength("30 m"), 30.0);
        /// Seed: another one gives another wall with the same statistics.
        seed: u64 = default(Whole, 1);
    }
}

fn amplitude(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.5).usual(1e-5, 0.05), example)
}

fn wavelength(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(0.2, 10_000.0).usual(0.2, 2000.0), example)
}

impl RoughnessTable {
    pub(crate) fn build(&self, reader: &mut Reader) -> Option<Roughness> {
        let roughness = Roughness {
            radius_rms_m: *self.rms.get()?,
            tortuosity_rms_m: *self.tortuosity.get()?,
            shortest_m: *self.shortest_wavelength.get()?,
            longest_m: *self.longest_wavelength.get()?,
            seed: *self.seed.get()?,
        };
        self.check_band(&roughness, reader)?;
        for field in [&self.rms, &self.tortuosity] {
            check_slope(field, &roughness, reader)?;
        }
        self.warn_of_no_effect(&roughness, reader);
        Some(roughness)
    }

    /// Whether any wall is rough.
    pub(crate) fn is_rough(&self) -> bool {
        [&self.rms, &self.tortuosity].iter().any(|field| field.get().is_some_and(|rms| *rms > 0.0))
    }

    fn check_band(&self, roughness: &Roughness, reader: &mut Reader) -> Option<()> {
        let min_m = wholestring::well::NARROWEST_BAND * roughness.shortest_m;
        if roughness.longest_m >= min_m {
            return Some(());
        }
        let longest = self.longest_wavelength.given();
        let place = longest.or(self.shortest_wavelength.given())?.place;
        let mut diagnostic = Diagnostic::error("the band of wavelengths is too narrow").at(
            place,
            match longest {
                Some(_) => {
                    format!("expected {} or more", reader.at_least(Dimension::Length, min_m))
                }
                None => {
                    let longest = reader.shown(Dimension::Length, roughness.longest_m);
                    format!("the longest is {longest}")
                }
            },
        );
        if let (Some(_), Some(shortest)) = (longest, self.shortest_wavelength.given()) {
            diagnostic = diagnostic.at(shortest.place, "the shortest wavelength");
        }
        reader.report(diagnostic.help("the longest wavelength is at least 1.2 times the shortest"));
        None
    }

    fn warn_of_no_effect(&self, roughness: &Roughness, reader: &mut Reader) {
        if roughness.radius_rms_m > 0.0 || roughness.tortuosity_rms_m > 0.0 {
            return;
        }
        let others = [
            self.shortest_wavelength.given().map(|at| at.place),
            self.longest_wavelength.given().map(|at| at.place),
            self.seed.given().map(|at| at.place),
        ];
        if let Some(place) = others.into_iter().flatten().next() {
            Diagnostic::warning("[well.roughness] has no effect here")
                .at(place, "used with `rms` or `tortuosity`")
                .report(reader);
        }
    }
}

/// Refuses waves that are too high for their length.
fn check_slope(field: &Field<f64>, roughness: &Roughness, reader: &mut Reader) -> Option<()> {
    let Some(entry) = field.given() else {
        return Some(());
    };
    let highest_m = STEEPEST * roughness.shortest_m / TAU;
    if entry.value <= highest_m {
        return Some(());
    }
    Diagnostic::error("the waves of the wall are too steep")
        .at(
            entry.place,
            format!("expected {} or less", reader.at_most(Dimension::Diameter, highest_m)),
        )
        .help(format!(
            "waves of {} and more may be 1/20 as high; for higher ones raise \
                 shortest_wavelength",
            reader.shown(Dimension::Length, roughness.shortest_m)
        ))
        .refuse(reader)
}

/// Warns of tools that the wall's peaks leave without clearance.
pub(crate) fn check_clearance(
    string: &DrillString,
    hole: &Hole,
    rms_place: Option<Span>,
    reader: &mut Reader,
) {
    let (Some(roughness), Some(place)) = (hole.roughness(), rms_place) else {
        return;
    };
    for span in string.spans().skip(1) {
        let bottom_md_m = string.length_m() - span.from_bit_m;
        let radius_m = span.component.contact_radius_m();
        let tight = hole.sections().iter().find(|section| {
            let peak_m = PEAK * section.roughness * roughness.radius_rms_m;
            let clearance_m = 0.5 * section.diameter_m - radius_m;
            section.from_md_m < bottom_md_m && clearance_m > 0.0 && clearance_m < peak_m
        });
        let Some(section) = tight else { continue };
        let clearance_m = 0.5 * section.diameter_m - radius_m;
        let peak_m = PEAK * section.roughness * roughness.radius_rms_m;
        Diagnostic::warning(format!(
            "the rough wall closes in on `{}`",
            short(&span.component.name)
        ))
        .at(place, format!("peaks of {} and more", reader.shown(Dimension::Diameter, peak_m)))
        .help(format!(
            "it has {} of radial clearance below {}; where the wall leaves none, the tool \
                 is held on the hole's axis",
            reader.shown(Dimension::Diameter, clearance_m),
            reader.shown(Dimension::Length, section.from_md_m)
        ))
        .report(reader);
        return;
    }
}
