//! The page of linear vibration about the static equilibrium of the string, and its pictures.

mod figures;
mod page;

pub use figures::{MODES_PICTURES, modes_plots};
pub use page::modes_html;

use wholestring_results::{CampbellRow, ModeShapeRow, ModesRows, ModesSummary, Table};
use wholestring_units::UnitSet;

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
    /// Shapes of the modes, natural frequencies against rotary speed, and response.
    rows: ModesRows,
    /// The map of torsional stability.
    stability_map: Option<StabilityPicture>,
}

impl Modes {
    /// The page of linear vibration, of the rows of its tables, and of `stability.parquet` where the
    /// summary has torsional stability; it opens in these units, by default in those of the case.
    pub fn new(
        summary: ModesSummary,
        rows: ModesRows,
        stability: &Table,
        units: Option<UnitSet>,
    ) -> Self {
        let title = format!("{}: natural frequencies", summary.case);
        let own = summary.torsional_stability.as_ref();
        Self {
            head: PageHead::new(title, units, Some(&summary.settings), facts(&summary)),
            rows,
            stability_map: own.map(|own| StabilityPicture::new(stability, own)),
            summary,
        }
    }

    /// The shape of each mode along the string, from the top down.
    fn shapes(&self) -> impl Iterator<Item = &[ModeShapeRow]> {
        let is_same = |one: &ModeShapeRow, other: &ModeShapeRow| {
            one.family == other.family && one.number == other.number
        };
        self.rows.shapes.chunk_by(is_same)
    }

    /// Each natural frequency against rotary speed.
    fn branches(&self) -> impl Iterator<Item = &[CampbellRow]> {
        let is_same = |one: &CampbellRow, other: &CampbellRow| {
            one.family == other.family && one.branch == other.branch
        };
        self.rows.campbell.chunk_by(is_same)
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
