//! Parts of a case from one file.

mod block;

pub use block::{Block, Contents, Entry, Note, Origin, Survey, Value};
pub(crate) use block::{quoted, rounded};

use wholestring_tabular::ImportedReading;
use wholestring_units::UnitSet;

use crate::log::picking::Picks;

/// A part of a case that comes from one file as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// The path of the well.
    Survey,
    /// The sections of the hole.
    Hole,
    /// The string.
    String,
    /// The mud.
    Mud,
    /// The rig.
    Rig,
    /// Set points of the operations, and the bit's torque.
    Operation,
}

impl Part {
    /// Every part, in the order of a case.
    pub const ALL: [Part; 6] =
        [Part::Survey, Part::Hole, Part::Mud, Part::String, Part::Rig, Part::Operation];

    /// Its name in `--pick`: `--pick survey=FILE`.
    pub fn name(self) -> &'static str {
        match self {
            Part::Survey => "survey",
            Part::Hole => "hole",
            Part::String => "string",
            Part::Mud => "mud",
            Part::Rig => "rig",
            Part::Operation => "operation",
        }
    }
}

/// Parts of a case, from one file.
///
/// Keys of entries are those of the case file. A part that is not in the file is empty.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Fragment {
    /// Kind of file, for messages: `a tally of 7 components`.
    pub what: String,
    /// Name of the well, for `name`.
    pub name: Option<Entry>,
    /// Path of the well.
    pub survey: Option<Survey>,
    /// Sections of the hole, from the surface down: the keys of `[[well.hole]]`.
    pub hole: Vec<Block>,
    /// Components of the string, from the bit up: the keys of `[[string]]`.
    pub string: Vec<Block>,
    /// The keys of `[mud]`.
    pub mud: Block,
    /// The keys of `[rig]`.
    pub rig: Block,
    /// The keys of `[operation]`.
    pub operation: Block,
    /// The keys of `[bit]`.
    pub bit: Block,
    /// Weights and torques at the surface, measured or picked from a log.
    pub measured: Vec<ImportedReading>,
    /// Weights and torques at the surface computed by another program, to be drawn over a plan.
    pub overlay: Vec<ImportedReading>,
    /// Evidence of the weights that were picked from a log.
    pub picks: Option<Box<Picks>>,
    /// Units of the file's measured weights and depths, if it has any.
    pub units: Option<UnitSet>,
    /// Notes on assumptions, omissions and checks.
    pub notes: Vec<Note>,
    /// Those of its measured readings for which a calibration refuses them.
    pub refused: Vec<String>,
}

impl Fragment {
    /// The parts that are present.
    pub fn parts(&self) -> Vec<Part> {
        Part::ALL.into_iter().filter(|part| self.has(*part)).collect()
    }

    fn has(&self, part: Part) -> bool {
        match part {
            Part::Survey => self.survey.is_some(),
            Part::Hole => !self.hole.is_empty(),
            Part::String => !self.string.is_empty(),
            Part::Mud => !self.mud.entries.is_empty(),
            Part::Rig => !self.rig.entries.is_empty(),
            Part::Operation => !self.operation.entries.is_empty() || !self.bit.entries.is_empty(),
        }
    }

    /// Leaves a part out.
    pub(crate) fn drop_part(&mut self, part: Part) {
        match part {
            Part::Survey => self.survey = None,
            Part::Hole => self.hole.clear(),
            Part::String => self.string.clear(),
            Part::Mud => self.mud = Block::default(),
            Part::Rig => self.rig = Block::default(),
            Part::Operation => {
                self.operation = Block::default();
                self.bit = Block::default();
            }
        }
    }
}
