//! Compares every factor with the definition of its unit, computed here independently of the table.

use std::f64::consts::PI;

use wholestring_units::{Dimension, UnitSet};

/// A product of exact decimals over another: at most ten roundings each way.
const ROUNDING: f64 = 10.0 * f64::EPSILON;

fn ratio(over: &[f64], under: &[f64]) -> f64 {
    over.iter().product::<f64>() / under.iter().product::<f64>()
}

/// SI units per unit, from the definitions: 1 in = 2.54 cm, 1 ft = 12 in, 1 yd = 3 ft,
/// 1 lb = 0.45359237 kg, g0 = 9.80665 m/s², 1 gal = 231 in³, 360 deg = 2π rad.
fn definition(dimension: Dimension, symbol: &str) -> Option<f64> {
    use Dimension as D;
    let inch = ratio(&[2.54], &[100.0]);
    let foot = ratio(&[12.0, 2.54], &[100.0]);
    let lbf = [0.453_592_37, 9.806_65];
    let speed = |symbol| match symbol {
        "m/h" => Some(ratio(&[1.0], &[60.0, 60.0])),
        "ft/h" => Some(ratio(&[12.0, 2.54], &[100.0, 60.0, 60.0])),
        "m/s" => Some(1.0),
        "m/min" => Some(ratio(&[1.0], &[60.0])),
        "ft/min" => Some(ratio(&[12.0, 2.54], &[100.0, 60.0])),
        "ft/s" => Some(foot),
        "mm/s" => Some(ratio(&[1.0], &[1000.0])),
        _ => None,
    };
    let value = match (dimension, symbol) {
        (D::Length | D::Diameter, "m") => 1.0,
        (D::Length | D::Diameter, "km") => 1000.0,
        (D::Length | D::Diameter, "cm") => ratio(&[1.0], &[100.0]),
        (D::Length | D::Diameter, "mm") => ratio(&[1.0], &[1000.0]),
        (D::Length | D::Diameter, "in") => inch,
        (D::Length | D::Diameter, "ft") => foot,
        (D::Length | D::Diameter, "yd") => ratio(&[3.0, 12.0, 2.54], &[100.0]),
        // 39.37 US survey inches are one metre.
        (D::Length | D::Diameter, "usft") => ratio(&[12.0], &[39.37]),

        (D::Force, "N") => 1.0,
        (D::Force, "kN") => 1e3,
        (D::Force, "MN") => 1e6,
        (D::Force, "daN") => 10.0,
        (D::Force, "kdaN") => 10_000.0,
        (D::Force, "lbf") => ratio(&lbf, &[]),
        (D::Force, "klbf") => ratio(&[1000.0, lbf[0], lbf[1]], &[]),
        (D::Force, "kgf") => 9.806_65,
        (D::Force, "t") => 9806.65,
        (D::Force, "tonfUS") => ratio(&[2000.0, lbf[0], lbf[1]], &[]),

        (D::Torque, "N.m") => 1.0,
        (D::Torque, "kN.m") => 1e3,
        (D::Torque, "MN.m") => 1e6,
        (D::Torque, "daN.m") => 10.0,
        (D::Torque, "kgf.m") => 9.806_65,
        (D::Torque, "ft-lbf") => ratio(&[12.0, 2.54, lbf[0], lbf[1]], &[100.0]),
        (D::Torque, "kft-lbf") => ratio(&[1000.0, 12.0, 2.54, lbf[0], lbf[1]], &[100.0]),
        (D::Torque, "in-lbf") => ratio(&[2.54, lbf[0], lbf[1]], &[100.0]),

        (D::Pressure | D::Stress, "Pa") => 1.0,
        (D::Pressure | D::Stress, "kPa") => 1e3,
        (D::Pressure | D::Stress, "MPa") => 1e6,
        (D::Pressure | D::Stress, "GPa") => 1e9,
        (D::Pressure | D::Stress, "bar") => 1e5,
        (D::Pressure | D::Stress, "atm") => 101_325.0,
        (D::Pressure | D::Stress, "psi") => ratio(&[1e4, lbf[0], lbf[1]], &[2.54, 2.54]),
        (D::Pressure | D::Stress, "ksi") => ratio(&[1e7, lbf[0], lbf[1]], &[2.54, 2.54]),
        (D::Pressure | D::Stress, "Mpsi") => ratio(&[1e10, lbf[0], lbf[1]], &[2.54, 2.54]),

        (D::Density, "kg/m3") => 1.0,
        (D::Density, "sg") => 1000.0,
        (D::Density, "g/cm3") => ratio(&[1e6], &[1e3]),
        (D::Density, "ppg") => ratio(&[lbf[0], 1e6], &[231.0, 2.54, 2.54, 2.54]),
        (D::Density, "lb/ft3") => ratio(&[lbf[0], 1e6], &[12.0, 12.0, 12.0, 2.54, 2.54, 2.54]),
        // p = rho g h: a column of one foot with 1 psi; gravity cancels the pound-force's.
        (D::Density, "psi/ft") => ratio(&[lbf[0], 1e6], &[2.54, 2.54, 2.54, 12.0]),
        (D::Density, "kPa/m") => ratio(&[1000.0], &[9.806_65]),

        (D::MassPerLength, "kg/m") => 1.0,
        (D::MassPerLength, "t/m") => 1000.0,
        (D::MassPerLength, "lb/ft") => ratio(&[lbf[0], 100.0], &[12.0, 2.54]),

        (D::ForcePerLength, "N/m") => 1.0,
        (D::ForcePerLength, "kN/m") => 1e3,
        (D::ForcePerLength, "daN/m") => 10.0,
        (D::ForcePerLength, "kgf/m") => 9.806_65,
        (D::ForcePerLength, "kN/10m") => ratio(&[1e3], &[10.0]),
        (D::ForcePerLength, "kN/30m") => ratio(&[1e3], &[30.0]),
        (D::ForcePerLength, "lbf/ft") => ratio(&[lbf[0], lbf[1], 100.0], &[12.0, 2.54]),
        (D::ForcePerLength, "lbf/30ft") => ratio(&[lbf[0], lbf[1], 100.0], &[30.0, 12.0, 2.54]),

        (D::RotarySpeed, "rpm") => ratio(&[PI], &[30.0]),
        (D::RotarySpeed, "rad/s") => 1.0,
        (D::RotarySpeed, "rev/s") => ratio(&[2.0, PI], &[]),
        (D::RotarySpeed, "deg/s") => ratio(&[2.0, PI], &[360.0]),

        (D::RateOfPenetration | D::TripSpeed, symbol) => speed(symbol)?,

        (D::Angle, "deg") => ratio(&[2.0, PI], &[360.0]),
        (D::Angle, "rad") => 1.0,
        (D::Angle, "turn") => ratio(&[2.0, PI], &[]),

        (D::DoglegSeverity, "rad/m") => 1.0,
        (D::DoglegSeverity, "deg/m") => ratio(&[2.0, PI], &[360.0]),
        (D::DoglegSeverity, "deg/10m") => ratio(&[2.0, PI], &[360.0, 10.0]),
        (D::DoglegSeverity, "deg/30m") => ratio(&[2.0, PI], &[360.0, 30.0]),
        (D::DoglegSeverity, "deg/ft") => ratio(&[2.0, PI, 100.0], &[360.0, 12.0, 2.54]),
        (D::DoglegSeverity, "deg/100ft") => ratio(&[2.0, PI], &[360.0, 12.0, 2.54]),

        (D::Stiffness, "N/m") => 1.0,
        (D::Stiffness, "kN/m") => 1e3,
        (D::Stiffness, "MN/m") => 1e6,
        (D::Stiffness, "lbf/ft") => ratio(&[lbf[0], lbf[1], 100.0], &[12.0, 2.54]),
        (D::Stiffness, "lbf/in") => ratio(&[lbf[0], lbf[1], 100.0], &[2.54]),
        (D::Stiffness, "klbf/in") => ratio(&[lbf[0], lbf[1], 1e5], &[2.54]),

        (D::Damping, "N.s/m") => 1.0,
        (D::Damping, "kN.s/m") => 1e3,
        (D::Damping, "lbf.s/ft") => ratio(&[lbf[0], lbf[1], 100.0], &[12.0, 2.54]),
        (D::Damping, "lbf.s/in") => ratio(&[lbf[0], lbf[1], 100.0], &[2.54]),

        (D::Viscosity, "Pa.s") => 1.0,
        (D::Viscosity, "mPa.s") => ratio(&[1.0], &[1000.0]),
        // One poise is 0.1 Pa.s.
        (D::Viscosity, "cP") => ratio(&[1.0], &[10.0, 100.0]),

        (D::Consistency, "Pa.s^n") => 1.0,
        (D::Consistency, "mPa.s^n" | "eq cP") => ratio(&[1.0], &[1000.0]),
        (D::Consistency, "lbf.s^n/100ft2") | (D::ShearStress, "lbf/100ft2") => {
            ratio(&[lbf[0], lbf[1]], &[100.0, 0.3048, 0.3048])
        }

        (D::ShearStress, "Pa") => 1.0,
        // A dyne is 1e-5 N.
        (D::ShearStress, "dyn/cm2") => ratio(&[1.0], &[10.0]),

        (D::FlowRate, "m3/s") => 1.0,
        (D::FlowRate, "m3/min") => ratio(&[1.0], &[60.0]),
        (D::FlowRate, "m3/h") => ratio(&[1.0], &[60.0, 60.0]),
        (D::FlowRate, "L/s") => ratio(&[1.0], &[1000.0]),
        (D::FlowRate, "L/min") => ratio(&[1.0], &[1000.0, 60.0]),
        (D::FlowRate, "gpm") => ratio(&[231.0, 0.0254, 0.0254, 0.0254], &[60.0]),
        // A barrel is 42 US gallons.
        (D::FlowRate, "bbl/min") => ratio(&[42.0, 231.0, 0.0254, 0.0254, 0.0254], &[60.0]),

        (D::Volume, "m3") => 1.0,
        (D::Volume, "L") => ratio(&[1.0], &[1000.0]),
        (D::Volume, "gal") => ratio(&[231.0, 0.0254, 0.0254, 0.0254], &[]),
        (D::Volume, "in3") => ratio(&[0.0254, 0.0254, 0.0254], &[]),

        (D::DissipationTime, "s/m") => 1.0,
        (D::DissipationTime, "s/mm") => 1000.0,
        (D::DissipationTime, "s/ft") => ratio(&[100.0], &[12.0, 2.54]),
        (D::DissipationTime, "s/in") => ratio(&[100.0], &[2.54]),

        (D::HoistGain, "m/s/N") => 1.0,
        (D::HoistGain, "m/s/kN") => ratio(&[1.0], &[1000.0]),
        (D::HoistGain, "m/s/t") => ratio(&[1.0], &[9806.65]),
        (D::HoistGain, "ft/s/klbf") => ratio(&[12.0, 2.54], &[100.0, 1000.0, lbf[0], lbf[1]]),

        (D::Time, "s") => 1.0,
        (D::Time, "ms") => ratio(&[1.0], &[1000.0]),
        (D::Time, "min") => 60.0,
        (D::Time, "h") => ratio(&[60.0, 60.0], &[]),
        (D::Time, "d") => ratio(&[24.0, 60.0, 60.0], &[]),

        (D::Frequency, "1/s") => 1.0,
        (D::Frequency, "1/min") => ratio(&[1.0], &[60.0]),
        (D::Frequency, "kHz") => 1000.0,

        (D::Mass, "kg") => 1.0,
        (D::Mass, "g") => ratio(&[1.0], &[1000.0]),
        (D::Mass, "t") => 1000.0,
        (D::Mass, "lb") => 0.453_592_37,
        (D::Mass, "klb") => 453.592_37,
        (D::Mass, "tonUS") => 907.184_74,

        (D::MomentOfInertia, "kg.m2") => 1.0,
        (D::MomentOfInertia, "t.m2") => 1e3,
        (D::MomentOfInertia, "lb.ft2") => {
            ratio(&[0.453_592_37, 12.0, 2.54, 12.0, 2.54], &[100.0, 100.0])
        }

        (D::RotaryDamping, "N.m.s") => 1.0,
        (D::RotaryDamping, "kN.m.s") => 1e3,
        (D::RotaryDamping, "ft-lbf.s") => ratio(&[lbf[0], lbf[1], 12.0, 2.54], &[100.0]),
        (D::RotaryDamping, "kN.m/rpm") => ratio(&[1e3, 60.0], &[2.0, PI]),

        (D::FractureEnergy, "J/m2") => 1.0,
        (D::FractureEnergy, "kJ/m2") => 1e3,
        (D::FractureEnergy, "in-lbf/in2") => ratio(&[lbf[0], lbf[1], 100.0], &[2.54]),
        _ => return None,
    };
    Some(value)
}

#[test]
fn every_factor_is_its_definition() {
    for &dimension in Dimension::ALL {
        for unit in dimension.units() {
            let expected = definition(dimension, unit.symbol)
                .unwrap_or_else(|| panic!("{dimension:?} {} has no definition", unit.symbol));
            let error = (unit.factor / expected - 1.0).abs();
            assert!(
                error <= ROUNDING,
                "{dimension:?} {}: {} is not {expected}",
                unit.symbol,
                unit.factor
            );
        }
    }
}

/// NIST Special Publication 811 (2008), appendix B.8: seven digits, half a unit in the last.
#[test]
fn factors_agree_with_the_nist_guide() {
    use Dimension as D;
    let table = [
        (D::Force, "lbf", 4.448_222),
        (D::Force, "tonfUS", 8.896_443e3),
        (D::Force, "kgf", 9.806_65),
        (D::Torque, "ft-lbf", 1.355_818),
        (D::Torque, "in-lbf", 1.129_848e-1),
        (D::Pressure, "psi", 6.894_757e3),
        (D::Pressure, "ksi", 6.894_757e6),
        (D::Density, "ppg", 1.198_264e2),
        (D::Density, "lb/ft3", 1.601_846e1),
        (D::MassPerLength, "lb/ft", 1.488_164),
        (D::Stiffness, "lbf/ft", 1.459_390e1),
        (D::Stiffness, "lbf/in", 1.751_268e2),
        (D::Length, "usft", 3.048_006e-1),
        (D::RotarySpeed, "rpm", 1.047_198e-1),
        (D::Angle, "deg", 1.745_329e-2),
        (D::Mass, "tonUS", 9.071_847e2),
    ];
    for (dimension, symbol, published) in table {
        let unit = dimension.find_unit(symbol).unwrap();
        let relative = (unit.factor / published - 1.0).abs();
        // Half a unit in the seventh digit is at most 5e-7 of a value that begins with a 1.
        assert!(relative < 5e-7, "{symbol}: {} against {published}", unit.factor);
    }
}

#[test]
fn the_sets_show_the_promised_units() {
    let promised = [
        (UnitSet::Si, ["m", "kN", "kN.m", "mm", "kg/m3"]),
        (UnitSet::Metric, ["m", "t", "kN.m", "mm", "sg"]),
        (UnitSet::Field, ["ft", "klbf", "ft-lbf", "in", "ppg"]),
    ];
    for (set, symbols) in promised {
        let dimensions = [
            Dimension::Length,
            Dimension::Force,
            Dimension::Torque,
            Dimension::Diameter,
            Dimension::Density,
        ];
        assert_eq!(dimensions.map(|dimension| dimension.unit_in(set).symbol), symbols, "{set}");
    }
}
