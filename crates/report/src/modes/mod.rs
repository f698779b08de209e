//! The page of linear vibration about the static equilibrium of the string, and its pictures.

mod curves;
mod figures;
mod page;

pub use figures::{MODES_PICTURES, modes_plots};
pub use page::modes_html;

use wholestring_results::{ModesSummary, ModesTables, Table};
use wholestring_units::UnitSet;

use self::curves::{AnswerCurve, ModeBranch, ModeShape};
use crate::{
    Cell, Fact, PageHead,
    stability::{StabilityPicture, stability_sentences},
};

/// Linear vibration with the head of its page. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: ModesSummary,
    /// Shapes of the modes.
    shapes: Vec<ModeShape>,
    /// Natural frequencies against rotary speed.
    branches: Vec<ModeBranch>,
    /// Response to the excitation.
    answer: AnswerCurve,
    /// The map of torsional stability.
    stability_map: Option<StabilityPicture>,
}

impl Modes {
    /// The page of linear vibration, of its tables, and of `stability.parquet` where the summary
    /// has torsional stability; it opens in these units, by default in those of the case.
    pub fn new(
        summary: ModesSummary,
        tables: &ModesTables,
        stability: &Table,
        units: Option<UnitSet>,
    ) -> Self {
        let title = format!("{}: natural frequencies", summary.case);
        let own = summary.torsional_stability.as_ref();
        Self {
            head: PageHead::new(title, units, Some(&summary.settings), facts(&summary)),
            shapes: curves::shapes(&tables.shapes),
            branches: curves::branches(&tables.campbell),
            answer: curves::answer(&tables.response),
            stability_map: own.map(|own| StabilityPicture::new(stability, own)),
            summary,
        }
    }

    /// Parts that turn with the string and excite it, in words.
    fn forcing(&self, units: UnitSet) -> String {
        self.summary.texts.in_units(&self.summary.forcing, units)
    }

    /// Results of the map of torsional stability, the verdict first, or the reason why there is
    /// none, in sentences.
    fn stability(&self, units: UnitSet) -> Vec<String> {
        match &self.summary.torsional_stability {
            Some(own) => stability_sentences(self.summary.operation, own, units),
            None => self.summary.no_torsional_stability.iter().cloned().collect(),
        }
    }
}

/// Key facts of the state.
fn facts(summary: &ModesSummary) -> Vec<Fact> {
    let speed_rad_per_s = summary.rotary_speed_rad_per_s;
    vec![
        Fact::new("Operation", Cell::Text(summary.operation.words().to_owned())),
        Fact::new("Rotary speed", Cell::quantity(speed_rad_per_s, "rotary speed")),
        Fact::new("Assembly", Cell::quantity(summary.assembly_length_m, "length")),
        Fact::new("Elements", Cell::Text(summary.elements.to_string())),
    ]
}
