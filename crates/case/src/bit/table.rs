//! The keys of `[bit]`.

use std::f64::consts::PI;

use wholestring::dynamics::BitSettings;
use wholestring_units::Dimension;

use wholestring_config::{
    number::{Count, Number},
    quantity::Quantity,
    range::Range,
    rule::{Choice, Section},
    table::{default, optional, table},
};

use super::{
    excitation::ExcitationTable,
    face::FaceTable,
    kind::Kind,
    law::{CUTTERS, DETOURNAY, FRONT, Law, RATE, REGENERATIVE, ROCK, SHAPED, TABLE},
    motor::MotorTable,
    points::PointsTable,
};

/// Numbers of the laws where the case does not say: the rock and the cutters of Richard, Germay and
/// Detournay's examples, somewhat worn.
const BLADES: u64 = 4;
const SPECIFIC_ENERGY_PA: f64 = 60e6;
const WEAR_FLAT_M: f64 = 5e-3;
const CONTACT_STRENGTH_PA: f64 = 60e6;
const GEOMETRY: f64 = 1.0;
const FULL_CONTACT_M: f64 = 0.3e-3;
const ROCK_STIFFNESS_N_PER_M: f64 = 1e8;

fn depth(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1).usual(1e-5, 0.02), example)
}

table! {
    /// The bit on the rock.
    BitTable in "[bit]" {
        /// "rate" (the operation's rate of penetration in proportion to weight and speed, torque in
        /// proportion to weight), "regenerative" (Richard, Germay and Detournay: weight and torque
        /// from the depth of cut that the blade before has left, which sticks, slips and bounces by
        /// itself), "detournay-defourny" (weight and torque from the depth of cut of a revolution,
        /// in three regimes), "table" (rate and torque as they were measured) or "rock" (the bit's
        /// face breaks the solid rock of `[rock]`). Only the dynamic model lets the bit move; the
        /// soft string takes the law's steady torque.
        law: Law = default(
            Choice { noun: "a bit law", words: Law::WORDS },
            Law::Rate,
        );
        /// "pdc", "roller cone", "core" or "inserts" (fixed ones that crush and scrape). The laws
        /// of cutters take other numbers for a roller cone where none are given, cut a ring with a
        /// core bit and know no inserts; against solid rock the bit has the shape of `[bit.face]`,
        /// and cones that roll are not modelled.
        kind: Kind = default(
            Choice { noun: "a kind of bit", words: Kind::WORDS },
            Kind::Pdc,
        ).used_with(SHAPED);
        /// Core bit: diameter of the core that it leaves. Raising it leaves less to cut.
        core_diameter: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::positive_to(1.0).usual(0.01, 0.3),
            "4 in",
        ));
        /// Rate law: torque of the bit at the operation's weight on bit. Where an operation drills
        /// or slides and it is not given, the bit is taken to turn freely, and a warning says so.
        torque: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::from_to(0.0, 1e6).usual(50.0, 1e5),
            "3.1 kN.m",
        )).used_with(&[RATE]);
        /// All laws but the regenerative and "rock": stiffness of the contact between bit and rock
        /// front. Raising it makes the weight on bit answer harder to axial motion. Only the
        /// dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12).usual(1e6, 1e11), "1e8 N/m"),
            ROCK_STIFFNESS_N_PER_M,
        ).used_with(FRONT);
        /// All laws but the regenerative and "rock": what shakes the bit.
        excitation: ExcitationTable = optional(Section::<ExcitationTable>::RULE).used_with(FRONT);
        /// Regenerative law: number of blades. Raising it stiffens the rock and shortens the delay.
        blades: u64 = default(Count { from: 1, to: 50 }, BLADES).used_with(&[REGENERATIVE]);
        /// Laws of cutters (regenerative, Detournay-Defourny): work that cutting takes per volume
        /// of rock. Raising it lowers the rate of penetration and stiffens the rock.
        intrinsic_specific_energy: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(1e5, 1e10).usual(1e6, 2e9), "60 MPa"),
            SPECIFIC_ENERGY_PA,
        ).used_with(CUTTERS);
        /// Laws of cutters: the cutting force along the hole over that around. Raising it takes
        /// more weight for the same torque. Default: 0.6, of a roller cone 3.
        cutter_inclination: f64 = optional(
            Number { unit: "", range: Range::from_to(0.01, 10.0) },
        ).used_with(CUTTERS);
        /// Laws of cutters: length of the wear flats of all blades together. Raising it lets more
        /// weight rest on them, which cuts nothing and damps axial motion.
        wear_flat: f64 = default(
            Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1).usual(1e-5, 0.05), "5 mm"),
            WEAR_FLAT_M,
        ).used_with(CUTTERS);
        /// Laws of cutters: strength of the contact between wear flats and rock. Raising it does
        /// what longer wear flats do.
        contact_strength: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(0.0, 1e10).usual(1e6, 2e9), "60 MPa"),
            CONTACT_STRENGTH_PA,
        ).used_with(CUTTERS);
        /// Laws of cutters: where the wear flats lie; 1 for evenly over the radius, 4/3 for evenly
        /// over the face. Raising it raises their torque.
        bit_geometry: f64 = default(Number::up_to(2.0), GEOMETRY).used_with(CUTTERS);
        /// Laws of cutters: friction of the wear flats on rock. Raising it raises their torque.
        /// Default: 0.6, of a roller cone 0.3.
        friction: f64 = optional(Number::up_to(2.0)).used_with(CUTTERS);
        /// Detournay-Defourny: depth of cut per revolution from which the wear flats are in full
        /// contact. Raising it lets a light weight cut more.
        full_contact_depth: f64 = default(depth("0.3 mm"), FULL_CONTACT_M).used_with(&[DETOURNAY]);
        /// Detournay-Defourny: largest depth of cut per revolution that the mud keeps clean; what
        /// weight is beyond rubs and does not cut. Raising it lets the bit drill faster. Default:
        /// none.
        cleaning_limit: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::positive_to(0.1).usual(1e-4, 0.03),
            "8 mm",
        )).used_with(&[DETOURNAY]);
        /// The law "rock" and a bit test: the shape of the bit.
        face: FaceTable = optional(Section::<FaceTable>::RULE).used_with(&[ROCK]);
        /// The law "table": what was measured.
        table: PointsTable = optional(Section::<PointsTable>::RULE).used_with(&[TABLE]);
        /// Speed at which a mud motor turns the bit against the string, whatever the torque; a bare
        /// number is in rev/min. "slide" needs it, or `[bit.motor]`, where the bit's angle counts:
        /// in all laws but the rate law, and with an excitation.
        motor_speed: f64 = optional(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(0.0, 1000.0 * PI / 30.0).usual(10.0 * PI / 30.0, 600.0 * PI / 30.0),
                "120 rpm",
            )
            .bare("rev/min", PI / 30.0),
        );
        /// A mud motor that turns with the flow and yields to the torque.
        motor: MotorTable = optional(Section::<MotorTable>::RULE);
        /// Side cutting: what the bit cuts sideways per side force over what it cuts ahead per
        /// weight. Raising it lets a side force move the bit off the hole's axis faster. Only the
        /// dynamic model uses it.
        steerability: f64 = default(Number::up_to(1.0), 0.0);
        /// Lateral stiffness that holds the bit to the hole's axis, instead of contact and friction
        /// with the wall: the bit fills its hole. Raising it holds the bit closer. On solid rock it
        /// stands for what the wall is finer than elements; with 0 the elements alone hold the bit.
        /// Only the dynamic model uses it.
        lateral_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(0.0, 1e12).usual(1e4, 1e10), "1e7 N/m"),
            BitSettings::default().lateral_stiffness_N_per_m,
        );
    }
}
