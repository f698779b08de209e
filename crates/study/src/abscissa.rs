//! The horizontal axis of a figure that has a point for each case.

use wholestring_config::prelude::*;

use crate::{chosen::Chosen, sweep::Sweep};

/// A varied key as an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Abscissa {
    /// The key.
    pub key: String,
    /// Dimension of its values; none for bare numbers.
    pub dimension: Option<Dimension>,
}

impl Abscissa {
    /// The number of a value of the key, SI; none if it is a word.
    pub fn number(&self, value: &str) -> Option<f64> {
        let bare = value.parse::<f64>().ok().filter(|number| number.is_finite());
        bare.or_else(|| self.dimension?.parse(value).ok())
    }

    /// The key with this name, which every sweep must vary; otherwise an error.
    pub(crate) fn named(
        at: &Spanned<String>,
        chosen: &Chosen,
        sweeps: &[Sweep],
        reader: &mut Reader,
    ) -> Option<Self> {
        let mut dimension = None;
        for sweep in chosen.sweeps.iter().map(|index| &sweeps[*index]) {
            let Some(varied) = sweep.vary.iter().find(|varied| varied.key == at.value) else {
                let message =
                    format!("sweep `{}` does not vary `{}`", sweep.name, short(&at.value));
                let mut diagnostic = Diagnostic::error(message)
                    .at(at.place, "from = \"summary\" draws against a key that is varied");
                if let Some(near) = nearest(&at.value, sweep.keys()) {
                    diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
                }
                reader.report(diagnostic);
                return None;
            };
            for value in varied.bare_values() {
                if value.parse::<f64>().is_ok() {
                    continue;
                }
                let mut all = Dimension::ALL.iter().copied();
                dimension =
                    dimension.or_else(|| all.find(|dimension| dimension.parse(value).is_ok()));
                if dimension.is_none_or(|dimension| dimension.parse(value).is_err()) {
                    let message =
                        format!("`{}` of `{}` cannot be placed on an axis", short(value), at.value);
                    return Diagnostic::error(message)
                        .at(at.place, "expected a key of numbers of one unit")
                        .refuse(reader);
                }
            }
        }
        Some(Self { key: at.value.clone(), dimension })
    }
}
