//! `[modes]`: natural frequencies and their excitation.

use std::f64::consts::PI;

use serde::Serialize;
use wholestring::{
    dynamics::{BitLaw, DynamicsSettings},
    operation::Operation,
    string::DrillString,
};
use wholestring_config::prelude::*;
use wholestring_vibration::{modal::assembly_length_m, torsional_stability::HIGHEST_HZ};

/// Default number of modes of each family.
const COUNT: u64 = 10;

/// Default upper limit of the rotary speed, rad/s, and the default ratio of that limit to the speed
/// of the operations.
const FASTEST: f64 = 200.0 * PI / 30.0;
const FASTER: f64 = 1.5;

/// Order of a bit with three cones or of stabilisers with three blades.
const THREE: f64 = 3.0;

/// Force with a visible response, N.
const FORCE_N: f64 = 1e3;

/// Maximum number of orders.
const MAX_ORDERS: usize = 20;

/// Default limits of the weight on bit of the map over that of the operation, and the weight that
/// they refer to where no operation drills, N.
const LIGHTEST: f64 = 0.2;
const HEAVIEST: f64 = 2.0;
const USUAL_N: f64 = 50e3;

table! {
    /// Natural frequencies, critical speeds, the response to a rotating force, and torsional
    /// stability, for `wholestring modes`.
    ModesTable in "[modes]" {
        /// Modes of each family: lateral of the assembly, axial and torsional of the whole string.
        count: u64 = default(Count { from: 1, to: 100 }, COUNT);
        /// Length of the assembly, from the bit up, whose lateral modes are computed. Default: up
        /// to the drill pipe.
        assembly: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::positive_to(2e4).usual(20.0, 1e3),
            "200 m",
        ));
        /// Slowest rotary speed of the diagram; a bare number is in rev/min.
        slowest: f64 = default(speed("20 rpm"), 0.0);
        /// Fastest rotary speed of the diagram; a bare number is in rev/min. Default: one and a
        /// half times that of the operations, at least 200 rpm.
        fastest: f64 = optional(speed("200 rpm"));
        /// Orders of excitation: number of pulses in one revolution of the string. Default: 1 for
        /// imbalance, the blades or lobes of the bit's law, or else 3.
        orders: Vec<Spanned<f64>> = optional(List::or_one(
            Number { unit: "", range: Range::positive_to(100.0) },
            "orders",
            MAX_ORDERS,
        ));
        /// Size of the force that rotates with the string where none of its components is
        /// eccentric.
        force: f64 = default(
            Quantity::si(Dimension::Force, Range::positive_to(1e6).usual(10.0, 1e5), "1 kN"),
            FORCE_N,
        );
        /// Distance of that force from the bit. Default: the middle of the longest unsupported
        /// stretch of the assembly.
        force_at: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 2e4),
            "15 m",
        ));
        /// Least weight on bit of the map of torsional stability. Default: a fifth of the
        /// operation's.
        lightest: f64 = optional(weight("10 kN"));
        /// Largest weight on bit of the map. Default: twice the operation's.
        heaviest: f64 = optional(weight("150 kN"));
        /// Highest frequency of the map. Raising it finds faster chatter, in more time.
        highest_frequency: f64 = default(
            Number { unit: "Hz", range: Range::from_to(0.5, 200.0) },
            HIGHEST_HZ,
        );
        /// Ratio of static to kinetic friction that the map of torsional stability assumes where a
        /// hole section gives no `static`: 1.2 is usual, 1 uses the friction of the case unchanged.
        /// Raising it makes the string stick and slip at higher speeds.
        static_over_kinetic: f64 = default(
            Number { unit: "", range: Range::from_to(1.0, 5.0).usual(1.0, 2.5) },
            1.0,
        );
    }
}

fn weight(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Force, Range::positive_to(5e6).usual(1e3, 7e5), example)
}

fn speed(example: &'static str) -> Quantity {
    let range = Range::from_to(0.0, 1000.0 * PI / 30.0);
    Quantity::si(Dimension::RotarySpeed, range, example).bare("rev/min", PI / 30.0)
}

/// Settings of natural frequencies and their excitation.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Modes {
    /// Modes of each family.
    pub count: usize,
    /// Length of the assembly, m.
    pub assembly_m: f64,
    /// Slowest and fastest rotary speed of the diagram, rad/s.
    pub rotary_rad_per_s: [f64; 2],
    /// Orders of excitation: number of pulses in one revolution of the string.
    pub orders: Vec<f64>,
    /// A force that rotates with the string, N.
    pub force_N: f64,
    /// Position of the force, m from the bit; `None` for the middle of the longest free stretch.
    pub force_from_bit_m: Option<f64>,
    /// Least and largest weight on bit of the map of torsional stability, N.
    pub weights_N: [f64; 2],
    /// Highest frequency of the map, Hz.
    pub highest_frequency_Hz: f64,
    /// Ratio of static to kinetic friction that the map assumes where the static friction of a
    /// section does not exceed the kinetic one.
    pub static_over_kinetic: f64,
}

pub(crate) fn build(
    table: &ModesTable,
    string: &DrillString,
    operations: &[Operation],
    dynamics: &DynamicsSettings,
    reader: &mut Reader,
) -> Option<Modes> {
    let turns = operations.iter().map(|one| one.rotation_rad_per_s()).fold(0.0, f64::max);
    let slowest = table.slowest.at()?;
    let fastest = table.fastest.optional()?;
    let fastest_rad_per_s = fastest.map_or(FASTEST.max(FASTER * turns), |at| at.value);
    if slowest.value >= fastest_rad_per_s {
        let place = fastest.map_or(slowest.place, |at| at.place);
        return Diagnostic::error("the diagram of [modes] has no speeds")
            .at(place, "expected `slowest` to be less than `fastest`")
            .refuse(reader);
    }
    let mut orders: Vec<f64> = match table.orders.optional()? {
        Some(entry) => entry.value.iter().map(|at| at.value).collect(),
        None => vec![1.0, bit_order(&dynamics.bit.law)],
    };
    orders.sort_by(f64::total_cmp);
    orders.dedup();
    let drills = operations.iter().find(|one| one.kind.on_bottom());
    let usual_N = drills.map_or(USUAL_N, |one| one.weight_on_bit_N);
    let (lightest, heaviest) = (table.lightest.optional()?, table.heaviest.optional()?);
    let weights_N = [
        lightest.map_or(LIGHTEST * usual_N, |at| at.value),
        heaviest.map_or(HEAVIEST * usual_N, |at| at.value),
    ];
    if let (Some(at), true) = (lightest.or(heaviest), weights_N[0] >= weights_N[1]) {
        return Diagnostic::error("the map of [modes] has no weights on bit")
            .at(at.place, "expected `lightest` to be less than `heaviest`")
            .refuse(reader);
    }
    let assembly = table.assembly.optional()?;
    let of_string = || assembly_length_m(string);
    let force_at = table.force_at.optional()?;
    Some(Modes {
        count: *table.count.get()? as usize,
        assembly_m: assembly.map_or_else(of_string, |at| at.value).min(string.length_m()),
        rotary_rad_per_s: [slowest.value, fastest_rad_per_s],
        orders,
        force_N: *table.force.get()?,
        force_from_bit_m: force_at.map(|at| at.value),
        weights_N,
        highest_frequency_Hz: *table.highest_frequency.get()?,
        static_over_kinetic: *table.static_over_kinetic.get()?,
    })
}

/// Order of excitation of the bit.
fn bit_order(law: &BitLaw) -> f64 {
    match law {
        BitLaw::Regenerative(law) => f64::from(law.blades),
        BitLaw::Rate(law) => law.excitation.map_or(THREE, |excitation| f64::from(excitation.lobes)),
        BitLaw::DetournayDefourny(law) => {
            law.excitation.map_or(THREE, |excitation| f64::from(excitation.lobes))
        }
        _ => THREE,
    }
}
