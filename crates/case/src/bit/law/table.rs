//! A measured law.

use std::f64::consts::PI;

use wholestring::{
    dynamics::{BitLaw, BitSettings, TableLaw},
    operation::Operation,
};
use wholestring_config::prelude::*;

use super::law_keys::{FrontKeys, LawKeys};
use crate::bit::{
    given::{Around, Given},
    points::PointsTable,
};

keys! {
    /// A measured law.
    TableKeys {
        /// The measured points.
        table: PointsTable = optional(Section::<PointsTable>::RULE);
        ..front: FrontKeys;
    }
}

impl Variant for TableKeys {
    const WORD: &'static str = "table";
    const MEANING: &'static str = "rate and torque as they were measured";
}

impl LawKeys for TableKeys {
    fn build(&self, place: Span, around: &Around<'_>, reader: &mut Reader) -> Option<BitLaw> {
        let table = self.points(place, around.files, reader)?;
        let (rock_stiffness_N_per_m, excitation) = self.front.build(Some(&table), reader)?;
        Some(BitLaw::Table(TableLaw { table, rock_stiffness_N_per_m, excitation }))
    }

    fn finds_rate(&self) -> Option<&'static str> {
        Some("the table of the bit has its own")
    }

    fn check_operation(
        &self,
        bit: &BitSettings,
        operation: &Operation,
        set_points: &Given<'_>,
        reader: &mut Reader,
    ) -> Option<()> {
        let BitLaw::Table(law) = &bit.law else {
            return Some(());
        };
        let speed = bit.drilling_speed_rad_per_s(operation);
        if law.table.holds(operation.weight_on_bit_N, speed) {
            return Some(());
        }
        let force = |force_N: f64| reader.shown(Dimension::Force, force_N);
        let [least, largest] = law.table.weights_N().map(force);
        let [slowest, fastest] = law.table.speeds_rad_per_s().map(in_rev_per_min);
        let mut diagnostic = Diagnostic::error(format!(
            "the table of the bit does not know \"{}\": {} at {} rev/min",
            operation.kind.name(),
            force(operation.weight_on_bit_N),
            in_rev_per_min(speed),
        ));
        let weight = format!("the table has {least} to {largest}");
        let turning = format!("the table has {slowest} to {fastest} rev/min of the bit");
        if let Some(wob) = set_points.wob {
            diagnostic = diagnostic.at(wob.place, weight);
        }
        if let Some(rpm) = set_points.rpm.filter(|_| operation.kind.rotates()) {
            diagnostic = diagnostic.at(rpm.place, turning);
        } else {
            diagnostic = diagnostic.help(turning);
        }
        reader.report(diagnostic);
        None
    }
}

impl TableKeys {
    fn points(
        &self,
        place: Span,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<wholestring::dynamics::BitTable> {
        let Some(entry) = self.table.given() else {
            if !matches!(self.table, Field::Bad) {
                reader.report(
                    Diagnostic::error("the law \"table\" needs a table")
                        .at(place, "[bit.table] is missing")
                        .help("such as [bit.table] with file = \"bit.csv\""),
                );
            }
            return None;
        };
        entry.value.build(entry.place, files, reader)
    }
}

fn in_rev_per_min(speed_rad_per_s: f64) -> String {
    number_text((speed_rad_per_s * 300.0 / PI).round() * 0.1)
}
