//! `[mesh]`.

use wholestring::dynamics::{Accuracy, ElementLength, MeshSettings, Regions};
use wholestring_config::prelude::*;
use wholestring_units::Dimension;

use crate::values::auto::{AUTO, AutoOr, AutoOrQuantity};

table! {
    /// Mesh of the string.
    MeshTable in "[mesh]" {
        /// Length of the elements, at most a quarter longer where joints require it, because tool
        /// joints and stabilisers get nodes. Halving it makes a dynamic run four times slower.
        /// "auto": from joint to joint, finer where needed, according to `accuracy`.
        element_length: AutoOr = default(
            AutoOrQuantity {
                quantity: Quantity::si(
                    Dimension::Length, Range::from_to(0.2, 30.0).usual(0.3, 30.0), "3.2 m",
                ),
                noun: "a length",
                auto: "From joint to joint, finer where needed.",
            },
            default_length(),
        );
        /// Accuracy of automatically chosen elements: "coarse" (from joint to joint, the
        /// bottom-hole assembly too), "standard" (the assembly at 3 m, more where the body touches
        /// between joints and where compression nears buckling) or "fine" (half of the standard
        /// lengths).
        accuracy: Accuracy = default(
            Choice {
                noun: "an accuracy",
                words: &[
                    ("coarse", Accuracy::Coarse),
                    ("standard", Accuracy::Standard),
                    ("fine", Accuracy::Fine),
                ],
            },
            Accuracy::default(),
        ).used_with(&[AUTO]);
        /// Whether parts of the string have steps of their own: "auto" (the bottom-hole assembly,
        /// where its mesh is finer than that of the pipe, takes several steps in one of the pipe,
        /// if that is faster) or "one". Default: "auto" where the element length is automatic, else
        /// "one".
        regions: Regions = optional(Choice {
            noun: "a choice of regions",
            words: &[("one", Regions::One), ("auto", Regions::Auto)],
        });
        /// Divisor of all element lengths, given or automatic: for convergence studies, such as
        /// `--vary mesh.refinement=1,2`. `run --converge` compares the case with twice this
        /// refinement.
        refinement: u64 = default(
            Count { from: 1, to: 16 },
            u64::from(MeshSettings::default().refinement),
        );
    }
}

/// Default length of the engine.
fn default_length() -> AutoOr {
    match MeshSettings::default().element_length {
        ElementLength::Uniform(length_m) => AutoOr::Given(length_m),
        ElementLength::Auto(_) => AutoOr::Auto,
    }
}

impl MeshTable {
    /// Settings of the engine's mesh.
    pub(crate) fn settings(&self) -> Option<MeshSettings> {
        let chosen = match *self.element_length.get()? {
            AutoOr::Auto => MeshSettings::auto(*self.accuracy.get()?),
            AutoOr::Given(length_m) => MeshSettings::uniform(length_m),
        };
        Some(MeshSettings {
            refinement: u32::try_from(*self.refinement.get()?).ok()?,
            regions: self.regions.get().copied().unwrap_or(chosen.regions),
            ..chosen
        })
    }

    /// Warns of an accuracy together with a given length.
    pub(crate) fn warn_of_idle_keys(&self, reader: &mut Reader) {
        let (Some(accuracy), Some(AutoOr::Given(_))) =
            (self.accuracy.given(), self.element_length.get())
        else {
            return;
        };
        let diagnostic = Diagnostic::warning("`accuracy` has no effect here")
            .at(accuracy.place, "used with element_length = \"auto\"");
        reader.report(match self.element_length.given() {
            Some(length) => diagnostic.at(length.place, "the length"),
            None => diagnostic.help("the length is given where no other is"),
        });
    }
}
