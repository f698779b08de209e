//! Kinds of bits by name.

use wholestring_config::prelude::*;

/// Cutting mechanism of a bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Pdc,
    RollerCone,
    Core,
    Inserts,
}

pub(crate) const PDC: &str = "pdc";
const ROLLER_CONE: &str = "roller cone";
pub(crate) const CORE: &str = "core";
pub(crate) const INSERTS: &str = "inserts";

impl Kind {
    pub(crate) const WORDS: &[(&'static str, Self)] = &[
        (PDC, Self::Pdc),
        (ROLLER_CONE, Self::RollerCone),
        (CORE, Self::Core),
        (INSERTS, Self::Inserts),
    ];

    /// Default inclination of the cutting force: the drag bit of Richard, Germay and Detournay's
    /// examples; for a roller cone `3/(4 · 0.25)`, such that its torque is 0.25 of `2aW/3`.
    pub(crate) fn inclination(self) -> f64 {
        match self {
            Self::RollerCone | Self::Inserts => 3.0,
            Self::Pdc | Self::Core => 0.6,
        }
    }

    /// Default friction of the wear flats; rolling teeth have half of it.
    pub(crate) fn friction(self) -> f64 {
        match self {
            Self::RollerCone | Self::Inserts => 0.3,
            Self::Pdc | Self::Core => 0.6,
        }
    }

    pub(crate) fn word(self) -> &'static str {
        word_of(Self::WORDS, &self)
    }
}

keys! {
    /// Mechanism by which the bit breaks rock, for the laws that need it and for a bit test.
    KindKeys {
        /// "pdc", "roller cone", "core" or "inserts" (fixed ones that crush and scrape). The laws
        /// of cutters use other defaults for a roller cone, cut a ring with a core bit and do not
        /// apply to inserts; against solid rock the bit has the shape of `[bit.face]`, and rolling
        /// cones are not modelled.
        kind: Kind = default(
            Choice { noun: "a kind of bit", words: Kind::WORDS },
            Kind::Pdc,
        );
        /// Core bit: diameter of the core. Raising it reduces the volume of rock to cut.
        core_diameter: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::positive_to(1.0).usual(0.01, 0.3),
            "4 in",
        ));
    }
}

impl KindKeys {
    /// Returns the radius of the core that a bit `radius_m` wide leaves, m; zero for a bit that
    /// leaves none.
    pub(crate) fn core_radius_m(&self, radius_m: f64, reader: &mut Reader) -> Option<f64> {
        let kind = self.kind.at()?;
        match (kind.value, self.core_diameter.optional()?) {
            (Kind::Core, None) => Diagnostic::error("a core bit needs the diameter of its core")
                .at(kind.place, "`core_diameter` is missing in [bit]")
                .help("such as core_diameter = \"4 in\"")
                .refuse(reader),
            (Kind::Core, Some(core)) if core.value >= 2.0 * radius_m => {
                Diagnostic::error("the core is as wide as the bit, or wider")
                    .at(
                        core.place,
                        format!(
                            "expected less than {}",
                            reader.shown(Dimension::Diameter, 2.0 * radius_m)
                        ),
                    )
                    .refuse(reader)
            }
            (Kind::Core, Some(core)) => Some(0.5 * core.value),
            _ => Some(0.0),
        }
    }
}
