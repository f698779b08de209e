//! The rules of keys that are common to `[[string]]` and the `[[tubular]]` of a catalogue.

use wholestring_config::prelude::*;

pub(crate) fn diameter(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.005, 2.0).usual(0.02, 1.2), example)
}

pub(crate) fn joint_spacing() -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(0.5, 100.0).usual(4.0, 16.0), "9.6 m")
}

pub(crate) fn mass_per_length() -> Quantity {
    Quantity::si(
        Dimension::MassPerLength,
        Range::positive_to(20_000.0).usual(3.0, 1500.0),
        "35.8 kg/m",
    )
}

pub(crate) fn yield_strength() -> Quantity {
    Quantity::si(Dimension::Stress, Range::from_to(1e7, 1e10).usual(1.5e8, 1.5e9), "931 MPa")
}

pub(crate) fn make_up_torque() -> Quantity {
    Quantity::si(Dimension::Torque, Range::positive_to(1e6).usual(1e3, 2e5), "36.7 kN.m")
}
