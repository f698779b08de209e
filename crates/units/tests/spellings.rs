//! Texts of quantities, and the errors of invalid ones.

use wholestring_units::{Dimension, QuantityErrorKind, UnitSet, UnknownUnitSet};

fn close(dimension: Dimension, text: &str, si: f64) {
    let value = dimension.parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    assert!((value - si).abs() <= 4.0 * f64::EPSILON * si.abs(), "{text}: {value} is not {si}");
}

#[test]
fn numbers_are_decimals_fractions_or_mixed() {
    use Dimension::{Diameter, Force, Length};
    close(Diameter, "5-1/2 in", 5.5 * 0.0254);
    close(Diameter, "5 1/2 in", 5.5 * 0.0254);
    close(Diameter, "5½ in", 5.5 * 0.0254);
    close(Diameter, "5-½\"", 5.5 * 0.0254);
    close(Diameter, "½ in", 0.5 * 0.0254);
    close(Diameter, "9 5/8\"", 9.625 * 0.0254);
    close(Diameter, "9-5/8”", 9.625 * 0.0254);
    close(Diameter, "5/8in", 0.625 * 0.0254);
    close(Diameter, "-5 1/2 in", -5.5 * 0.0254);
    close(Diameter, "222.96 mm", 0.22296);
    close(Length, " 4305 m ", 4305.0);
    close(Length, "4305m", 4305.0);
    close(Length, "14124'", 14124.0 * 0.3048);
    close(Length, ".5 m", 0.5);
    close(Length, "5. m", 5.0);
    close(Force, "-1.5e3 N", -1500.0);
    close(Force, "−1.5E+3 N", -1500.0);
    close(Force, "+6 tf", 6.0 * 9806.65);
    close(Dimension::Frequency, "30 1/s", 30.0);
}

#[test]
fn the_fields_units_are_read_in_its_spellings() {
    use Dimension as D;
    close(D::Density, "1.2 sg", 1200.0);
    close(D::Density, "1.2 SG", 1200.0);
    close(D::Density, "10 lb/gal", 10.0 * 0.45359237 / (231.0 * 0.0254f64.powi(3)));
    close(D::Density, "0.52 psi/ft", 0.52 * 0.45359237 / (0.0254 * 0.0254 * 0.3048));
    close(D::Pressure, "210 GPa", 2.1e11);
    close(D::MassPerLength, "21.90 ppf", 21.9 * 0.45359237 / 0.3048);
    close(D::MassPerLength, "21.90 lbm/ft", 21.9 * 0.45359237 / 0.3048);
    close(D::RotarySpeed, "70 rev/min", 70.0 * std::f64::consts::PI / 30.0);
    close(D::RateOfPenetration, "36 m/hr", 0.01);
    close(D::TripSpeed, "60 ft/min", 0.3048);
    for text in ["3 deg/30m", "3 deg/30 m", "3°/30m", "3 ° / 30 m", "3 DEG/30M", "3 dega/30m"] {
        close(D::DoglegSeverity, text, 0.1f64.to_radians());
    }
    for text in ["3 deg/100ft", "3 deg/100 ft", "3°/100 ft", "3 deg per 100 ft"] {
        close(D::DoglegSeverity, text, 3f64.to_radians() / 30.48);
    }
    for text in ["45 kN.m", "45 kN·m", "45 kN*m", "45 kNm", "45 kN-m", "45 kN m", "45 KN.M"] {
        close(D::Torque, text, 45e3);
    }
    let foot_pound = 0.3048 * 0.45359237 * 9.80665;
    for text in ["9 ft-lbf", "9 ft.lbf", "9 lbf.ft", "9 lbf·ft", "9 ft-lb", "9 ft lbs", "9 lb-ft"]
    {
        close(D::Torque, text, 9.0 * foot_pound);
    }
    for text in [
        "9 kft-lbf",
        "9 klbf.ft",
        "9 kft.lbf",
        "9 kft-lb",
        "9 kft-lbs",
        "9 kft.lbs",
        "9 k ft-lbs",
        "9 klbs-ft",
        "9 ft-klbs",
        "9 ft-kips",
        "9 kip-ft",
        "9 1000 ft-lbs",
    ] {
        close(D::Torque, text, 9e3 * foot_pound);
    }
    let pound = 0.45359237 * 9.80665;
    for text in ["9 klbs", "9 kips", "9 klb", "9 klbf", "9 k-lbs", "9 KLBS", "9 1000 lbs"] {
        close(D::Force, text, 9e3 * pound);
    }
    close(D::Force, "9 metric tons", 9e3 * 9.80665);
    for text in ["36 m/hr", "36 M/HR", "36 m/hour", "36 metres per hour"] {
        close(D::RateOfPenetration, text, 0.01);
    }
    for text in ["90 ft/hr", "90 ft/hour", "90 fph", "90 feet per hour"] {
        close(D::RateOfPenetration, text, 90.0 * 0.3048 / 3600.0);
    }
    let gallon = 231.0 * 0.0254f64.powi(3);
    for text in ["600 gpm", "600 GPM", "600 gal/min", "600 USgpm"] {
        close(D::FlowRate, text, 10.0 * gallon);
    }
    for text in ["9 bbl/min", "9 bpm"] {
        close(D::FlowRate, text, 9.0 * 42.0 * gallon / 60.0);
    }
    close(D::FlowRate, "3 m^3/min", 0.05);
    for text in ["10 ppg", "10 PPG", "10 lbs/gal", "10 lb/gal"] {
        close(D::Density, text, 10.0 * 0.45359237 / gallon);
    }
    close(D::Density, "1.2 g/cm^3", 1200.0);
    close(D::MassPerLength, "19.5#", 19.5 * 0.45359237 / 0.3048);
    close(D::Pressure, "9 PSI", 9.0 * pound / 0.0254 / 0.0254);
    close(D::Viscosity, "20 cps", 0.02);
    close(D::ShearStress, "15 lbs/100 ft^2", 15.0 * pound / 9.290304);
    close(D::RotarySpeed, "60 RPM", 2.0 * std::f64::consts::PI);
}

#[test]
fn milli_is_never_mega() {
    for text in ["5 mN", "5 mn"] {
        assert!(Dimension::Force.parse(text).is_err(), "{text}");
    }
    for text in ["5 mPa", "5 mpsi"] {
        assert!(Dimension::Pressure.parse(text).is_err(), "{text}");
    }
    assert!(Dimension::Viscosity.parse("5 MPa.s").is_err());
    assert!(Dimension::Time.parse("5 Ms").is_err());
    close(Dimension::Force, "5 MN", 5e6);
    close(Dimension::Pressure, "5 MPA", 5e6);
    close(Dimension::Diameter, "5 MM", 0.005);
}

#[test]
fn every_spelling_means_its_unit_alone() {
    for &dimension in Dimension::ALL {
        for unit in dimension.units() {
            for spelling in unit.spellings() {
                let found = dimension.find_unit(spelling);
                assert_eq!(found, Some(unit), "{dimension:?} '{spelling}'");
                let value = dimension.parse(&format!("2 {spelling}")).unwrap();
                assert_eq!(value, unit.to_si(2.0), "{dimension:?} '{spelling}'");
            }
        }
    }
}

#[track_caller]
fn refused(dimension: Dimension, text: &str, at: &str, sentence: &str) -> QuantityErrorKind {
    let error = dimension.parse(text).unwrap_err();
    assert_eq!(&text[error.span.clone()], at, "{text}");
    let message = error.to_string();
    assert!(message.starts_with(sentence), "{text}: {message}");
    error.kind
}

#[test]
fn a_text_that_is_no_quantity_gets_a_sentence() {
    use Dimension::{Angle, Density, Diameter, Force, Length};
    assert_eq!(
        Length.parse("5 bar").unwrap_err().to_string(),
        "'bar' is a unit of pressure; a length was expected, with one of: \
         m, ft, mm, in, cm, km, yd, usft"
    );
    assert_eq!(
        Density.parse("12 pppg").unwrap_err().to_string(),
        "'pppg' is not a unit of density; did you mean 'ppg'? \
         Accepted: kg/m3, sg, ppg, g/cm3, lb/ft3, psi/ft, kPa/m"
    );
    refused(Length, "", "", "there is nothing here; a length was expected, such as '1 m'");
    refused(Length, "  ", "  ", "there is nothing here");
    refused(Angle, "4305", "4305", "'4305' has no unit; an angle was expected, with one of: deg");
    refused(Diameter, "5-1/2", "5-1/2", "'5-1/2' has no unit");
    refused(Force, " 12 wombats", "wombats", "'wombats' is not a unit of force; accepted: kN");
    for text in ["nan m", "NaN m", "inf m", "-inf m", "infinity m", "m", "- m", "e5 m", ". m"] {
        let kind = refused(Length, text, text.split(' ').next().unwrap(), "'");
        assert!(matches!(kind, QuantityErrorKind::NotANumber { .. }), "{text}: {kind:?}");
    }
    for (text, at) in [
        ("1.2.3 m", "1.2.3"),
        ("15,00 m", "15,00"),
        ("0,250 ft", "0,250"),
        ("1500,000 ft", "1500,000"),
        ("1,500,00 ft", "1,500,00"),
        ("1.500,5 m", "1.500,5"),
        ("1 50 m", "1 50"),
        ("12,5 m", "12,5"),
        ("5 9/8 m", "5 9/8"),
        ("1/0 m", "1/0"),
        ("5-1/2-1/2 m", "5-1/2-1/2"),
    ] {
        let kind = Length.parse(text).unwrap_err();
        assert_eq!(&text[kind.span.clone()], at);
        assert!(matches!(kind.kind, QuantityErrorKind::NotANumber { .. }), "{text}: {kind:?}");
    }
    let sentence = Length.parse("12,5 m").unwrap_err().to_string();
    assert!(sentence.contains("thousands not separated: '1500.5 m'"), "{sentence}");
    // A comma may be a decimal mark.
    let sentence = "'1,500' may be 1500 or 1.5; write '1500 m' or '1.5 m'";
    let kind = refused(Length, "1,500 m", "1,500", sentence);
    assert!(matches!(kind, QuantityErrorKind::AmbiguousComma { .. }), "{kind:?}");
    for (text, at) in [("1e400 m", "1e400"), ("1e308 km", "1e308"), ("-1e999 m", "-1e999")] {
        let kind = refused(Length, text, at, &format!("'{at}' is too large for a length"));
        assert!(matches!(kind, QuantityErrorKind::TooLarge { .. }), "{text}: {kind:?}");
    }
    // A `ton` is 907 kg, 1000 kg or 1016 kg: no unit is suggested.
    let kind =
        refused(Force, "6 ton", "ton", "'ton' is not a unit of force: a ton is 2000 lb to some");
    assert!(matches!(kind, QuantityErrorKind::AmbiguousUnit { .. }));
}

/// Separated thousands where they are unambiguous; feet and inches in one length.
#[test]
fn thousands_and_inches_are_read() {
    use Dimension::{Density, Diameter, Force, Length, Torque};
    let pound = 0.45359237 * 9.80665;
    close(Length, "20,000 ft", 6096.0);
    close(Length, "20,000ft", 6096.0);
    close(Length, "-1,234.5 ft", -1234.5 * 0.3048);
    close(Length, "20 000 ft", 6096.0);
    close(Length, "20\u{202f}000 m", 20_000.0);
    close(Length, "1 500 m", 1500.0);
    close(Length, "1_500 m", 1500.0);
    close(Length, "20'000 m", 20_000.0);
    close(Force, "1,200,000 N", 1.2e6);
    close(Force, "110,000 lbf", 110e3 * pound);
    close(Torque, "35,000 ft-lbf", 35e3 * 0.3048 * pound);
    close(Density, "1,200.5 kg/m3", 1200.5);
    close(Diameter, "8.5\"", 8.5 * 0.0254);
    close(Diameter, "8.5''", 8.5 * 0.0254);
    close(Length, "30'", 30.0 * 0.3048);
    close(Length, "31' 6\"", 31.5 * 0.3048);
    close(Length, "31'-6 1/2\"", (31.0 + 6.5 / 12.0) * 0.3048);
}

/// The symbols of WITS level 0, of LAS files and in Cyrillic letters.
#[test]
fn the_symbols_of_wits_and_las_are_read() {
    use Dimension as D;
    let pound = 0.45359237 * 9.80665;
    let gallon = 231.0 * 0.0254f64.powi(3);
    for (dimension, symbol, si) in [
        (D::Length, "F", 0.3048),
        (D::Length, "M", 1.0),
        (D::Length, "м", 1.0),
        (D::Length, "метр", 1.0),
        (D::Diameter, "MM", 1e-3),
        (D::Diameter, "IN", 0.0254),
        (D::Force, "KDN", 1e4),
        (D::Force, "KLB", 1e3 * pound),
        (D::Force, "MT", 9806.65),
        (D::Force, "тс", 9806.65),
        (D::Torque, "KFLB", 1e3 * 0.3048 * pound),
        (D::Torque, "KNM", 1e3),
        (D::Pressure, "KPA", 1e3),
        (D::Pressure, "PSI", pound / (0.0254 * 0.0254)),
        (D::Density, "KGM3", 1.0),
        (D::Density, "PPG", 0.45359237 / gallon),
        (D::Density, "G/CC", 1e3),
        (D::MassPerLength, "KG/M", 1.0),
        (D::MassPerLength, "LB/F", 0.45359237 / 0.3048),
        (D::FlowRate, "L/M", 1e-3 / 60.0),
        (D::FlowRate, "GPM", gallon / 60.0),
        (D::FlowRate, "M3/M", 1.0 / 60.0),
        (D::RateOfPenetration, "M/HR", 1.0 / 3600.0),
        (D::RateOfPenetration, "F/HR", 0.3048 / 3600.0),
        (D::TripSpeed, "FPM", 0.3048 / 60.0),
        (D::ShearStress, "PHSF", pound / 9.290304),
        (D::Angle, "DEG", 1f64.to_radians()),
        (D::Time, "SEC", 1.0),
        (D::Viscosity, "CP", 1e-3),
    ] {
        close(dimension, &format!("3 {symbol}"), 3.0 * si);
    }
    // Feet are not written in this way for diameters.
    assert_eq!(D::Diameter.find_unit("F"), None);
}

#[test]
fn people_are_shown_five_digits_in_their_units() {
    use Dimension as D;
    assert_eq!(D::Length.format(4305.274, UnitSet::Si), "4305.3 m");
    assert_eq!(D::Length.format(4305.274, UnitSet::Field), "14125 ft");
    assert_eq!(D::Length.format(1_234_567.8, UnitSet::Si), "1234568 m");
    assert_eq!(D::Force.format(1_234_567.0, UnitSet::Si), "1234.6 kN");
    assert_eq!(D::Force.format(980_665.0, UnitSet::Metric), "100 t");
    assert_eq!(D::Torque.format(0.0, UnitSet::Field), "0 ft-lbf");
    assert_eq!(D::Torque.format(-0.0, UnitSet::Si), "0 kN.m");
    assert_eq!(D::Diameter.format(0.2159, UnitSet::Field), "8.5 in");
    assert_eq!(D::Diameter.format(-0.2159, UnitSet::Si), "-215.9 mm");
    assert_eq!(D::Pressure.format(2.1e11, UnitSet::Field), "3.0458e7 psi");
    assert_eq!(D::Density.format(1e-9, UnitSet::Si), "1e-9 kg/m3");
    assert_eq!(D::DoglegSeverity.format(0.1f64.to_radians(), UnitSet::Metric), "3 deg/30m");
    assert_eq!(D::Length.format_exact(0.1397, UnitSet::Si), "0.1397 m");
    assert_eq!(D::Diameter.format_exact(5.5 * 0.0254, UnitSet::Field), "5.5 in");
    assert_eq!(D::DoglegSeverity.format_exact(0.1f64.to_radians(), UnitSet::Si), "3 deg/30m");
}

#[test]
fn unit_sets_have_three_names() {
    for &set in UnitSet::ALL {
        assert_eq!(set.to_string().parse(), Ok(set));
    }
    let error: UnknownUnitSet = "imperial".parse::<UnitSet>().unwrap_err();
    assert_eq!(
        error.to_string(),
        "'imperial' is not a unit set; expected \"si\", \"metric\" or \"field\""
    );
}

#[test]
fn the_spellings_of_rig_recorders_are_read() {
    use Dimension as D;
    close(D::Force, "3 kkgf", 3.0 * 9806.65);
    close(D::Force, "3 1000 kgf", 3.0 * 9806.65);
    close(D::Force, "3 kDaN", 3e4);
    close(D::Pressure, "3 psig", 3.0 * 0.45359237 * 9.80665 / (0.0254 * 0.0254));
    close(D::Pressure, "3 barg", 3e5);
    close(D::FlowRate, "3 USgal/min", 3.0 * 231.0 * 0.0254f64.powi(3) / 60.0);
    close(D::FlowRate, "3 galUS/min", 3.0 * 231.0 * 0.0254f64.powi(3) / 60.0);
}
