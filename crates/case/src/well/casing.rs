//! `casing` and `diameter` of `[[well.hole]]`.

use wholestring::well::{
    CasingPipe, HoleKind,
    casing::{self, Casing},
};
use wholestring_config::prelude::*;
use wholestring_units::UnitSet;

use crate::{
    catalogue::OwnCatalogue,
    well::hole::{Bore, HoleTable},
};

impl HoleTable {
    /// Place of the key that gives the diameter, if the case has one.
    pub(crate) fn diameter_place(&self) -> Option<Span> {
        let own_place = self.diameter.given().map(|at| at.place);
        own_place.or(self.casing.given().map(|at| at.place))
    }

    /// Returns the diameter of the hole, given or that of the casing; `None` after a mistake. `below`
    /// are the sections below; `own` is `None` after a mistake in the user's catalogue.
    pub(crate) fn bore(
        &self,
        below: &[Spanned<Self>],
        own: Option<&OwnCatalogue>,
        reader: &mut Reader,
    ) -> Option<Bore> {
        let diameter = self.diameter.optional()?;
        let Some(name) = self.casing.optional()? else {
            let diameter = diameter?;
            self.warn_of_outside_diameter(diameter, below, reader);
            return Some(Bore { diameter_m: diameter.value, casing: None });
        };
        if let Some(diameter) = diameter {
            return Diagnostic::error("`diameter` is given together with `casing`")
                .at(diameter.place, "the casing gives it")
                .at(name.place, "the casing")
                .help("remove one of the two")
                .refuse(reader);
        }
        if let Some(kind) = self.kind.at()
            && kind.value == HoleKind::Open
        {
            return Diagnostic::error("open hole has no casing")
                .at(name.place, "expected `diameter` instead")
                .at(kind.place, "open hole")
                .refuse(reader);
        }
        let own = own?;
        match own.find_casing(&name.value) {
            Ok(found) => {
                let yield_strength_Pa = found.grade.map(|grade| grade.yield_strength_Pa);
                let casing = Some(CasingPipe { od_m: found.od_m, yield_strength_Pa });
                Some(Bore { diameter_m: found.id_m, casing })
            }
            Err(unknown) => {
                let nearest: Vec<String> =
                    unknown.nearest.iter().map(|name| format!("\"{name}\"")).collect();
                let mut diagnostic =
                    Diagnostic::error(format!("there is no casing `{}`", short(&name.value)))
                        .at(name.place, "expected its size and weight");
                if let Some(near) = own.nearest_casing(&name.value) {
                    diagnostic = diagnostic.help(format!("your own has \"{near}\""));
                }
                diagnostic
                    .help(format!("the nearest: {}", nearest.join(", ")))
                    .help("or give its inside diameter as `diameter`")
                    .refuse(reader)
            }
        }
    }

    /// Warns of an outside diameter: casing is named by it, but the string moves in the inside one.
    /// It is the inside one where the bit of a section below passes it and passes no casing of this
    /// outside diameter.
    fn warn_of_outside_diameter(
        &self,
        diameter: &Spanned<f64>,
        below: &[Spanned<Self>],
        reader: &mut Reader,
    ) {
        let sizes = casing::of_outside_diameter(diameter.value);
        let Some(first) = sizes.first() else { return };
        let widest_m = sizes.iter().fold(0.0, |widest_m, casing| f64::max(widest_m, casing.id_m));
        let mut drilled = below.iter().filter_map(|table| table.value.diameter.given());
        let is_inside = drilled.any(|at| (widest_m..=diameter.value).contains(&at.value));
        if is_inside || self.kind.get() != Some(&HoleKind::Casing) {
            return;
        }
        let written = reader.text_at(diameter.place);
        let in_inches = written.contains("in") || written.contains("\"\"");
        let units = if in_inches { UnitSet::Field } else { reader.units() };
        let inside: Vec<String> = sizes
            .iter()
            .map(|casing| {
                format!("{} ({})", Dimension::Diameter.format(casing.id_m, units), weight(casing))
            })
            .collect();
        let size = first.designation.split_once(" in ");
        let size = size.map_or("", |(size, _)| size);
        let common = sizes.get(sizes.len() / 2).unwrap_or(first);
        let mut diagnostic =
            Diagnostic::warning(format!("{size} in is the outside diameter of a casing"))
                .at(diameter.place, "expected the inside diameter")
                .help(format!("{size} in casing has inside diameters of {}", inside.join(", ")))
                .help(format!("or name it: casing = \"{}\"", common.designation));
        let also = casing::entries()
            .into_iter()
            .find(|casing| (casing.id_m - diameter.value).abs() < 1e-4);
        if let Some(also) = also {
            diagnostic = diagnostic.help(format!(
                "it is also the inside diameter of casing = \"{}\"",
                also.designation
            ));
        }
        reader.report(diagnostic);
    }
}

/// Returns the nominal weight in the words of its name.
fn weight(casing: &Casing) -> &str {
    let parted = casing.designation.split_once(" in ");
    parted.map_or("", |(_, weight)| weight)
}
