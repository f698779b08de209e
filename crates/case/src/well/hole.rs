//! `[[well.hole]]`: the hole around the path.

use wholestring::well::{CasingPipe, Friction, Hole, HoleError, HoleKind, HoleSection};
use wholestring_config::{prelude::*, table::required_unless};

use crate::{catalogue::OwnCatalogue, well::roughness::RoughnessTable};

/// Width of a section, and the casing that determines it.
pub(crate) struct Bore {
    pub(crate) diameter_m: f64,
    pub(crate) casing: Option<CasingPipe>,
}

table! {
    /// Friction between string and wall: kinetic and static, axial and rotational.
    FrictionTable in "friction" {
        /// Coefficient of sliding friction along the hole and, unless `around` is given, around it.
        kinetic: f64 = required(coefficient());
        /// Static coefficient along the hole, at least the kinetic one; around the hole it is in
        /// the same ratio to `around`. Raising it makes the string stick longer and break away at a
        /// higher force. Default: the kinetic one.
        r#static: f64 = optional(coefficient());
        /// Coefficient while sliding around the hole: raising it raises torque, not drag. Default:
        /// the kinetic one.
        around: f64 = optional(coefficient());
    }
}

/// The largest coefficient of friction that a case may have.
pub const MAX_FRICTION: f64 = 2.0;

pub(crate) fn coefficient() -> Number {
    Number { unit: "", range: Range::from_to(0.0, MAX_FRICTION).usual(0.05, 0.8) }
}

/// Smallest coefficient along the hole for which the one around the hole is taken as a ratio to it.
const MIN_FRICTION: f64 = 1e-3;

impl FrictionTable {
    fn build(&self, reader: &mut Reader) -> Option<Friction> {
        let kinetic = self.kinetic.get();
        let (at_rest, around) = (self.r#static.optional()?, self.around.optional()?);
        let kinetic = *kinetic?;
        let mut friction = Friction::uniform(kinetic);
        if let Some(at_rest) = at_rest {
            if at_rest.value < kinetic {
                return Diagnostic::error("static friction is smaller than kinetic friction")
                    .at(at_rest.place, format!("expected at least {kinetic}"))
                    .refuse(reader);
            }
            friction.at_rest = at_rest.value;
        }
        if let Some(around) = around
            && around.value != kinetic
        {
            if kinetic < MIN_FRICTION {
                return Diagnostic::error("rotational friction needs axial friction")
                    .at(around.place, "taken in its ratio to `kinetic`")
                    .help(format!("give a kinetic friction of {MIN_FRICTION} or more"))
                    .refuse(reader);
            }
            friction.around = around.value / kinetic;
        }
        Some(friction)
    }
}

/// A coefficient of friction, or a table of several.
pub(crate) struct FrictionRule;

impl Rule for FrictionRule {
    type Value = Friction;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Friction> {
        match &node.value {
            Value::Number { .. } => {
                let kinetic = coefficient().read(node, reader)?;
                Some(Friction::uniform(kinetic))
            }
            Value::Table(entries) => FrictionTable::read(entries, node.place, reader).build(reader),
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
        /// Measured depth where it begins. Default: the end of the section above, or the surface;
        /// no other value is possible, so that the key serves as a check only.
        from: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0),
            "0 m",
        ));
        /// Measured depth where it ends, m unless a unit is given.
        to: f64 = required(Quantity::si(
            Dimension::Length,
            Range::positive_to(20_000.0).usual(5.0, 13_000.0),
            "2986.53 m",
        ));
        /// Diameter of the hole, or inside diameter of the casing, m unless a unit is given. Needed
        /// without `casing`.
        diameter: f64 = required_unless("casing", Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.02, 2.0).usual(0.06, 1.3),
            "8-1/2 in",
        ));
        /// Casing of API Spec 5CT by its size and weight, such as "9-5/8 in 40 lb/ft": gives the
        /// inside diameter.
        casing: String = optional(Text);
        /// Diameter of the drift mandrel that passes every joint of the casing, for a casing of a
        /// special drift. Default: that of API Spec 5CT for `casing`. A wider part of the string is
        /// warned of.
        drift: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.02, 2.0).usual(0.06, 1.3),
            "8.75 in",
        ));
        /// Coefficient of friction between string and wall, or
        /// { kinetic = 0.25, static = 0.3, around = 0.2 }.
        friction: Friction = required(FrictionRule);
        /// Young's modulus of the wall. Default: 210 GPa in casing; 51.5 GPa in open hole, from the
        /// article that the dynamics follow. Used by Hertz contact.
        youngs_modulus: f64 = optional(Quantity::si(
            Dimension::Stress,
            Range::from_to(1e6, 2e12).usual(1e8, 3e11),
            "51.5 GPa",
        ));
        /// Poisson's ratio of the wall. Default: 0.3 in casing, 0.33 in open hole. Used by Hertz
        /// contact.
        poisson_ratio: f64 = optional(Number { unit: "", range: Range::from_to(0.0, 0.5) });
        /// Factor on the amplitudes of [well.roughness] in this section: 0 makes it smooth.
        roughness: f64 = default(Number { unit: "", range: Range::from_to(0.0, 10.0) }, 1.0);
    }
}

/// Builds the sections, one below the other.
pub(crate) fn build(
    tables: &[Spanned<HoleTable>],
    roughness: Option<&RoughnessTable>,
    own: Option<&OwnCatalogue>,
    reader: &mut Reader,
) -> Option<Hole> {
    warn_of_sections(roughness, tables, reader);
    let roughness = roughness.map(|table| table.build(reader));
    let mut sections = Vec::new();
    let mut above: Option<(f64, Span)> = None;
    let mut valid = true;
    for (index, table) in tables.iter().enumerate() {
        let Some(to) = table.value.to.at() else {
            valid = false;
            above = None;
            continue;
        };
        if let Some((above_m, above_place)) = above
            && to.value <= above_m
        {
            Diagnostic::error("hole sections must go down")
                .at(
                    to.place,
                    format!("expected more than {}", reader.shown(Dimension::Length, above_m)),
                )
                .at(above_place, "the section above ends here")
                .report(reader);
            valid = false;
        } else if let Some(from) = table.value.from.given() {
            valid &= check_from(from, above, sections.is_empty(), reader);
        }
        let bore = table.value.bore(&tables[index + 1..], own, reader);
        match section(&table.value, above.map_or(0.0, |(md_m, _)| md_m), bore) {
            Some(section) => sections.push(section),
            None => valid = false,
        }
        above = Some((to.value, to.place));
    }
    if !valid {
        return None;
    }
    let roughness = match roughness {
        Some(built) => Some(built?),
        None => None,
    };
    match Hole::new(sections).and_then(|hole| hole.with_roughness(roughness)) {
        Ok(hole) => Some(hole),
        Err(error) => hole_error(&error, tables).refuse(reader),
    }
}

/// Whether a section begins where the one above ends.
fn check_from(
    from: &Spanned<f64>,
    above: Option<(f64, Span)>,
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
    let mut diagnostic = Diagnostic::error(message)
        .at(from.place, format!("expected {}", reader.shown(Dimension::Length, expected_m)));
    if let Some((_, place)) = above {
        diagnostic = diagnostic.at(place, "the section above ends here");
    }
    reader.report(diagnostic);
    false
}

fn section(table: &HoleTable, from_md_m: f64, bore: Option<Bore>) -> Option<HoleSection> {
    let Bore { diameter_m, casing } = bore?;
    let kind = *table.kind.get()?;
    let (youngs_modulus_Pa, poisson_ratio) = kind.elastic_constants();
    let youngs_modulus = table.youngs_modulus.optional()?;
    let poisson = table.poisson_ratio.optional()?;
    Some(HoleSection {
        kind,
        from_md_m,
        to_md_m: *table.to.get()?,
        diameter_m,
        friction: *table.friction.get()?,
        youngs_modulus_Pa: youngs_modulus.map_or(youngs_modulus_Pa, |at| at.value),
        poisson_ratio: poisson.map_or(poisson_ratio, |at| at.value),
        roughness: *table.roughness.get()?,
        casing,
    })
}

/// Reports an error of the core about the sections, at the section that it concerns.
fn hole_error(error: &HoleError, tables: &[Spanned<HoleTable>]) -> Diagnostic {
    let index = match error {
        HoleError::OutOfRange { index, .. }
        | HoleError::Reversed { index, .. }
        | HoleError::Apart { index, .. } => *index,
        _ => 0,
    };
    let place = tables.get(index).map(|table| table.place).unwrap_or_default();
    Diagnostic::error(error.to_string()).at(place, "this section")
}

/// Warns of a section's factor on a roughness that the case does not have.
fn warn_of_sections(
    roughness: Option<&RoughnessTable>,
    sections: &[Spanned<HoleTable>],
    reader: &mut Reader,
) {
    if roughness.is_some_and(RoughnessTable::is_rough) {
        return;
    }
    for section in sections {
        if let Some(entry) = section.value.roughness.given() {
            let why = "used with `rms` or `tortuosity` of [well.roughness]";
            reader.report(Diagnostic::idle("roughness", entry.place, why));
        }
    }
}
