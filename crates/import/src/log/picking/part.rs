//! Contribution of picked weights to a case.

use wholestring_tabular::ImportedReading;
use wholestring_units::{Dimension, Unit, significant};

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
            measured: self.written(),
            units: Some(self.units),
            notes,
            picks: Some(Box::new(self)),
            ..Fragment::default()
        }
    }

    /// The readings to the digits that are written: depths to hundredths, weights and torques to
    /// five digits, which is below their standard errors, in the units of the written file.
    fn written(&self) -> Vec<ImportedReading> {
        let unit = |dimension: Dimension| dimension.unit_in(self.units);
        let (length, force) = (unit(Dimension::Length), unit(Dimension::Force));
        let torque = unit(Dimension::Torque);
        let five = |unit: &Unit, si: f64| unit.to_si(significant(unit.from_si(si), 5));
        let readings = self.readings().into_iter().map(|reading| ImportedReading {
            bit_depth_m: length
                .to_si((100.0 * length.from_si(reading.bit_depth_m)).round() / 100.0),
            pick_up_N: reading.pick_up_N.map(|si| five(force, si)),
            slack_off_N: reading.slack_off_N.map(|si| five(force, si)),
            rotating_N: reading.rotating_N.map(|si| five(force, si)),
            torque_N_m: reading.torque_N_m.map(|si| five(torque, si)),
            torque_on_bottom_N_m: reading.torque_on_bottom_N_m.map(|si| five(torque, si)),
            ..reading
        });
        readings.collect()
    }
}
