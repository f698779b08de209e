//! Symbols of the Energistics standards in WITSML, old and new, and their values.

use wholestring_units::Dimension;

/// Each symbol with its value in SI, by the definitions of the foot, the pound and gravity.
fn same(dimension: Dimension, symbols: &[(&str, f64)]) {
    for &(symbol, factor) in symbols {
        let unit = dimension.find_unit(symbol).unwrap_or_else(|| panic!("{symbol} is not known"));
        let off = (unit.factor - factor).abs() / factor;
        assert!(off < 4.0 * f64::EPSILON, "{symbol}: {} is not {factor}", unit.factor);
    }
}

const FOOT: f64 = 0.3048;
const INCH: f64 = 0.0254;
const POUND: f64 = 0.45359237;
const POUND_FORCE: f64 = POUND * 9.80665;
const GALLON: f64 = 231.0 * INCH * INCH * INCH;

#[test]
fn lengths_and_angles() {
    let survey_foot = 1200.0 / 3937.0;
    same(
        Dimension::Length,
        &[("m", 1.0), ("ft", FOOT), ("ftUS", survey_foot), ("ft[US]", survey_foot), ("km", 1e3)],
    );
    same(Dimension::Diameter, &[("in", INCH), ("mm", 1e-3), ("cm", 1e-2), ("m", 1.0)]);
    same(Dimension::Angle, &[("dega", 1f64.to_radians()), ("rad", 1.0)]);
    same(
        Dimension::DoglegSeverity,
        &[("dega/30m", 1f64.to_radians() / 30.0), ("dega/ft", 1f64.to_radians() / FOOT)],
    );
    // A part of an inch is not a unit that can be read back.
    for symbol in ["1/32 in", "0.1 in", "in[US]", "ftSe"] {
        assert_eq!(Dimension::Diameter.find_unit(symbol), None, "{symbol}");
    }
}

#[test]
fn forces_torques_and_pressures() {
    same(
        Dimension::Force,
        &[
            ("N", 1.0),
            ("kN", 1e3),
            ("MN", 1e6),
            ("daN", 10.0),
            ("kdaN", 1e4),
            ("lbf", POUND_FORCE),
            ("klbf", 1e3 * POUND_FORCE),
            ("1000 lbf", 1e3 * POUND_FORCE),
            ("kgf", 9.80665),
            ("Mgf", 9806.65),
            ("tonfUS", 2e3 * POUND_FORCE),
            ("tonf[US]", 2e3 * POUND_FORCE),
        ],
    );
    same(
        Dimension::Torque,
        &[
            ("N.m", 1.0),
            ("kN.m", 1e3),
            ("daN.m", 10.0),
            ("kgf.m", 9.80665),
            ("ft.lbf", FOOT * POUND_FORCE),
            ("lbf.ft", FOOT * POUND_FORCE),
            ("kft.lbf", 1e3 * FOOT * POUND_FORCE),
            ("klbf.ft", 1e3 * FOOT * POUND_FORCE),
            ("1000 lbf.ft", 1e3 * FOOT * POUND_FORCE),
            ("lbf.in", INCH * POUND_FORCE),
        ],
    );
    let psi = POUND_FORCE / (INCH * INCH);
    same(
        Dimension::Pressure,
        &[
            ("Pa", 1.0),
            ("N/m2", 1.0),
            ("kPa", 1e3),
            ("kN/m2", 1e3),
            ("MPa", 1e6),
            ("bar", 1e5),
            ("psi", psi),
            ("lbf/in2", psi),
            ("kpsi", 1e3 * psi),
            ("Mpsi", 1e6 * psi),
        ],
    );
}

#[test]
fn masses_per_length_and_volume() {
    same(Dimension::MassPerLength, &[("kg/m", 1.0), ("lbm/ft", POUND / FOOT)]);
    same(
        Dimension::Density,
        &[
            ("kg/m3", 1.0),
            ("g/L", 1.0),
            ("g/dm3", 1.0),
            ("g/cm3", 1e3),
            ("kg/dm3", 1e3),
            ("kg/L", 1e3),
            ("t/m3", 1e3),
            ("Mg/m3", 1e3),
            ("lbm/galUS", POUND / GALLON),
            ("lbm/gal[US]", POUND / GALLON),
            ("lbm/ft3", POUND / FOOT.powi(3)),
        ],
    );
    // Weights are not masses.
    assert_eq!(Dimension::MassPerLength.find_unit("lbf/ft"), None);
    assert_eq!(Dimension::MassPerLength.find_unit("N/m"), None);
}

#[test]
fn rates_and_what_a_mud_report_has() {
    use std::f64::consts::TAU;
    same(
        Dimension::RotarySpeed,
        &[
            ("rpm", TAU / 60.0),
            ("c/min", TAU / 60.0),
            ("rev/s", TAU),
            ("c/s", TAU),
            ("rad/s", 1.0),
            ("dega/s", TAU / 360.0),
        ],
    );
    same(
        Dimension::RateOfPenetration,
        &[("m/h", 1.0 / 3600.0), ("ft/h", FOOT / 3600.0), ("m/s", 1.0), ("ft/min", FOOT / 60.0)],
    );
    same(
        Dimension::FlowRate,
        &[
            ("L/min", 1e-3 / 60.0),
            ("m3/min", 1.0 / 60.0),
            ("m3/s", 1.0),
            ("L/s", 1e-3),
            ("dm3/s", 1e-3),
            ("galUS/min", GALLON / 60.0),
            ("gal[US]/min", GALLON / 60.0),
            ("bbl/min", 42.0 * GALLON / 60.0),
        ],
    );
    same(Dimension::Viscosity, &[("cP", 1e-3), ("mPa.s", 1e-3), ("Pa.s", 1.0), ("N.s/m2", 1.0)]);
    let hundred_square_feet = 100.0 * FOOT * FOOT;
    same(
        Dimension::ShearStress,
        &[
            ("lbf/100ft2", POUND_FORCE / hundred_square_feet),
            ("0.01 lbf/ft2", POUND_FORCE / hundred_square_feet),
            ("Pa", 1.0),
        ],
    );
}
