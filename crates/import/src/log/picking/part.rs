//! Contribution of picked weights to a case.

use super::picks::Picks;
use crate::fragment::{Block, Fragment, Origin};

impl Picks {
    /// Returns their contribution to a case.
    pub fn fragment(self) -> Fragment {
        let mut rig = Block::default();
        let because = "--value block-weight".to_owned();
        rig.push("block_weight", self.block.said.clone(), Origin::at(because));
        let notes = self.notes();
        Fragment {
            what: format!("a log of {} rows, one every {} s", self.counts.rows, self.step()),
            rig,
            measured: self.readings(),
            notes,
            picks: Some(Box::new(self)),
            ..Fragment::default()
        }
    }
}
