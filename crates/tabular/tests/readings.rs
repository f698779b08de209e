//! Weights and torques from CSV and Excel.

use rust_xlsxwriter::Workbook;
use wholestring_tabular::read_readings;

#[test]
fn weights_and_torques_are_read_in_their_units() {
    let text = "well A\n\
        Bit depth (ft);PU wt (klbf);Slack-off (klbf);ROB (klbf);Torque (ft-lbf);case\n\
        1000;100;80,5;90;2500;curve\n\
        # tight hole\n\
        2000;150;-;;3000;tangent\n";
    let read = read_readings(text.as_bytes(), "a.csv").expect("readings");
    let [first, second] = &read.readings[..] else { panic!("two rows") };
    assert_eq!(first.place, "line 3");
    assert!((first.bit_depth_m - 304.8).abs() < 1e-9);
    assert!((first.slack_off_N.expect("a number") / 80.5e3 / 4.448_221_615 - 1.0).abs() < 1e-9);
    assert!((first.torque_N_m.expect("a number") / 2500.0 / 1.355_817_948 - 1.0).abs() < 1e-9);
    assert_eq!((second.slack_off_N, second.rotating_N), (None, None));
    assert_eq!(second.case.as_deref(), Some("tangent"));
}

/// Columns named as keys of a case belong to their row, `use` holds one out, and notes list the
/// others.
#[test]
fn keys_of_the_case_and_rows_held_out() {
    let text = "report,Bit depth (m),Pick-up (kN),string.2.length (ft),well.hole.0.friction,use\n\
        7,800,536.1,674.5,0.2,yes\n\
        8,900,540,,0.25,no\n";
    let read = read_readings(text.as_bytes(), "a.csv").expect("readings");
    let [first, second] = &read.readings[..] else { panic!("two rows") };
    let key = |key: &str, value: &str| (key.to_owned(), value.to_owned());
    let friction = "well.hole.0.friction";
    assert_eq!(first.keys, [key("string.2.length", "674.5 ft"), key(friction, "0.2")]);
    assert_eq!(second.keys, [key(friction, "0.25")]);
    assert_eq!([first.held_out, second.held_out], [false, true]);
    assert!(read.notes.iter().any(|note| note == "the column 'report' is not used"));
    let bad = text.replace(",no", ",perhaps");
    let error = read_readings(bad.as_bytes(), "a.csv").expect_err("neither word").to_string();
    assert!(error.contains("`use` is 'perhaps', expected \"yes\" or \"no\""), "{error}");
}

#[test]
fn units_in_names_and_in_a_row_below() {
    for text in [
        "bit_depth_m,pickup_kN,slackoff_kN,rotating_off_bottom_kN,off_bottom_torque_kNm,mud_ppg\n\
         800,536.1,503.8,524.8,0.15,9.0\n",
        "Bit MD,Pick-up,Slack-off,Rotating,Torque,Mud weight\nm,kN,kN,kN,kN.m,ppg\n\
         800,536.1,503.8,524.8,0.15,9.0\n",
    ] {
        let read = read_readings(text.as_bytes(), "a.csv").expect("readings");
        let readings = &read.readings[0];
        let all =
            [readings.pick_up_N, readings.slack_off_N, readings.rotating_N, readings.torque_N_m];
        assert_eq!(all, [Some(536.1e3), Some(503.8e3), Some(524.8e3), Some(150.0)]);
        assert!((readings.mud_density_kg_per_m3.expect("a number") - 1078.44).abs() < 0.1);
    }
}

#[test]
fn a_workbook_is_read_too() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    for (column, text) in ["MD (m)", "Pick up (t)", "Torque (kN.m)"].iter().enumerate() {
        sheet.write(0, column as u16, *text).expect("a cell");
    }
    for (column, number) in [1500.0, 100.0, 12.5].into_iter().enumerate() {
        sheet.write(1, column as u16, number).expect("a cell");
    }
    let bytes = workbook.save_to_buffer().expect("a workbook");
    let read = read_readings(&bytes, "a.xlsx").expect("readings");
    assert_eq!(read.readings[0].pick_up_N, Some(980_665.0));
    assert_eq!(read.readings[0].place, "row 2 of sheet 'Sheet1'");
}

#[test]
fn bad_files_get_an_answer() {
    for (text, expected) in [
        ("", "the file is empty; readings as CSV"),
        (
            "MD (m),Pick-up\n100,5\n",
            "the pick-up weight under 'Pick-up' has no unit; write it in the header, such as 'Pick-up (kN)', or in a row below it: kN, t, klbf",
        ),
        ("MD,Pick-up (kN)\n100,5\n", "the bit depth under 'MD' has no unit"),
        ("MD (m),Pick-up (m)\n100,5\n", "'m' is a unit of length, not a unit of force"),
        ("MD (m),Pick-up (kN)\n100,x\n", "'x' is not a number; the pick-up weight was expected"),
        ("MD (m),Pick-up (kN)\n-100,5\n", "the bit depth -100 m is out of range"),
        ("MD (m),Pick-up (kN)\n,5\n", "the bit depth is missing in this row"),
        ("MD (m),Pick-up (kN)\n", "no row follows the header"),
        ("MD (m),Remark,Time (s)\n100,a,1\n", "no column is a weight or a torque"),
        ("Pick-up (kN),Slack-off (kN),Torque (kN.m)\n5,4,3\n", "no column of bit depth"),
        ("1,2,3\n", "no header names them"),
        ("MD (m),PU (kN),Pick-up (kN)\n100,5,6\n", "two columns read as pick-up weight"),
    ] {
        let error = read_readings(text.as_bytes(), "a.csv").expect_err(text).to_string();
        assert!(error.contains(expected), "{error}\nlacks: {expected}");
    }
}

/// Headings in abbreviations of daily reports.
#[test]
fn torques_under_abbreviated_headings() {
    for (heading, on_bottom) in [
        ("Tq off btm", false),
        ("TQ_OFF_BTM", false),
        ("Off Btm TQ", false),
        ("Trq Off Bot", false),
        ("Rot tq", false),
        ("Torque off-btm (rotating)", false),
        ("Tq on btm", true),
        ("Drlg torque", true),
        ("On-Btm Trq", true),
    ] {
        let text = format!(
            "Depth (ft),Dn wt (klbs),Hkld up (klbs),Rot wgt (klbs),{heading} (kft-lbs)\n9000,170,230,200,9.5\n"
        );
        let read = read_readings(text.as_bytes(), "a.csv")
            .unwrap_or_else(|error| panic!("{heading}: {error}"));
        let readings = &read.readings[0];
        let found = if on_bottom { readings.torque_on_bottom_N_m } else { readings.torque_N_m };
        let expected = 9.5e3 * 1.355_817_948_331_4;
        assert!((found.unwrap_or_else(|| panic!("{heading}")) / expected - 1.0).abs() < 1e-12);
        assert!(
            readings.slack_off_N < readings.rotating_N && readings.rotating_N < readings.pick_up_N,
            "{heading}: {readings:?}"
        );
    }
}

/// Null values are left out with a note, and so is the last digit of the depths.
#[test]
fn values_that_stand_for_none() {
    let text = "Depth (ft),PU (kN),SO (kN),Torque (kN.m)\n9000,700,-999.25,-9999\n9100,710,N/A,5\n\
                -999.25,720,600,5\n9200.5,720,-999.25,NaN\n";
    let read = read_readings(text.as_bytes(), "a.csv").expect("readings");
    assert_eq!(read.readings.len(), 3);
    assert!(
        read.readings
            .iter()
            .all(|reading| reading.slack_off_N.is_none() && reading.pick_up_N.is_some())
    );
    let torques: Vec<_> = read.readings.iter().map(|reading| reading.torque_N_m).collect();
    assert_eq!(torques, [None, Some(5e3), None]);
    // The finest of the depths has one decimal.
    assert!((read.half_digit_m - 0.05 * 0.3048).abs() < 1e-12);
    for note in [
        "lines 2 and 5: the slack-off weight is '-999.25', which is a null value: left out",
        "line 3: the slack-off weight is 'N/A', which is a null value: left out",
        "line 2: the torque off bottom is '-9999', which is a null value: left out",
        "line 4: left out, because the bit depth is '-999.25', which is a null value",
    ] {
        assert!(read.notes.iter().any(|found| found == note), "{:?}\nlacks: {note}", read.notes);
    }
}

/// Zeros, signs and orders that are impossible for a string.
#[test]
fn readings_that_no_string_gives() {
    use wholestring_judge::Severity::{Error, Warning};
    use wholestring_units::UnitSet;

    let head = "Depth (m),PU (kN),SO (kN),ROT (kN),Torque (kN.m)\n";
    for (rows, kind, severity, sentence) in [
        (
            "1,700,0,650,3\n2,710,600,655,3.5\n3,720,0,0,4\n",
            "zero",
            Warning,
            "the slack-off weight is 0 in lines 2 and 4, 2 of 3 rows",
        ),
        (
            "1,700,600,0,0\n2,710,600,0,0\n",
            "zero",
            Warning,
            "the rotating weight is 0 in all 2 rows (lines 2 and 3)",
        ),
        (
            "1,700,600,650,-3\n2,710,600,655,3.5\n",
            "negative",
            Warning,
            "is -3 kN.m in line 2, 1 of 2",
        ),
        (
            "1,-700,-600,-650,\n2,-710,-600,-655,\n",
            "negative",
            Error,
            "is negative, -700 kN to -710 kN",
        ),
        (
            "1,0,0,0,0\n2,0,0,0,0\n",
            "no_readings",
            Error,
            "no weight and no torque is left of the readings: all are 0, in lines 2 and 3",
        ),
        (
            "1,600,700,650,3\n2,610,710,655,3.5\n3,800,790,795,4\n",
            "swapped",
            Error,
            "the pick-up weight is below the slack-off weight in 2 of 3 rows (lines 2 and 3), by most in line \
             2: 600 kN below 700 kN; friction makes pick-up ≥ rotating ≥ slack-off: are the columns swapped?",
        ),
        ("1,150,700,,\n2,155,710,,\n", "swapped", Error, "is one of the columns in another unit?"),
        (
            "1,700,600,650,3\n2,610,710,655,3.5\n3,800,690,750,4\n",
            "order_of_loads",
            Warning,
            "in 1 of 3 rows (line 3), by most in line 3: 610 kN below 710 kN",
        ),
        // Pumps lift the string while it turns: no error.
        ("1,700,690,600,3\n2,710,695,610,3\n", "order_of_loads", Warning, "do the pumps lift"),
    ] {
        let text = format!("{head}{rows}");
        let read = read_readings(text.as_bytes(), "a.csv").expect("readings");
        let (left, checks) = read.measured(UnitSet::Si);
        let found = checks.iter().find(|check| {
            check.check.kind.name() == kind && check.check.sentence.contains(sentence)
        });
        let found = found.unwrap_or_else(|| panic!("{rows}: {checks:?}"));
        assert_eq!(found.check.severity, severity, "{found:?}");
        for reading in &left.readings {
            assert!(reading.torque_N_m.is_none_or(|torque| torque > 0.0) || severity == Error);
            assert!(reading.slack_off_N != Some(0.0) && reading.rotating_N != Some(0.0));
        }
    }
    // Valid ones, one of them of a vertical hole with an indicator that errs by 1 %.
    for rows in ["1,700,600,650,3\n2,710,605,655,3.5\n", "1,702,699,705,0.1\n2,798,801,800,0.1\n"] {
        let read = read_readings(format!("{head}{rows}").as_bytes(), "a.csv").expect("readings");
        let (left, checks) = read.clone().measured(UnitSet::Si);
        assert_eq!((left, checks), (read, Vec::new()));
    }
}

/// Warnings of the measured readings in a text.
fn checked(text: &str) -> (Vec<wholestring_tabular::ImportedReading>, Vec<String>) {
    let read = read_readings(text.as_bytes(), "a.csv").expect("readings");
    let (read, checks) = read.measured(wholestring_units::UnitSet::Field);
    (read.readings, checks.into_iter().map(|check| check.check.sentence).collect())
}

/// A mud of 0 is not measured, and one of 0.92 ppg is unusual, as the key of a case.
#[test]
fn densities_are_checked_as_weights_are() {
    let (readings, sentences) =
        checked("Bit depth (ft),PU (klbf),Mud (ppg)\n7000,209,9.2\n7900,217,0\n8300,231,0.92\n");
    assert_eq!(readings[1].mud_density_kg_per_m3, None);
    assert!(readings[2].mud_density_kg_per_m3.is_some());
    assert_eq!(
        sentences,
        [
            "the mud density is 0 in line 3, 1 of 3 rows: no mud is without density, and that of \
             the case is used, and a zero is not a reading; left out",
            "the mud density is unusually small in line 4: 0.92 ppg; usual are 5.0072 ppg to \
             21.698 ppg; check its unit",
        ]
    );
}

/// Numbers that no rig measures are left out, and printed in few digits.
#[test]
fn wild_numbers_are_left_out() {
    let text = "Bit depth (ft),PU (klbf),SO (klbf)\n7000,209,200\n7900,217,1e8\n8300,231,190\n";
    let (readings, sentences) = checked(text);
    assert_eq!(readings[1].slack_off_N, None);
    assert_eq!(
        sentences,
        [
            "the slack-off weight is up to 1.000e8 klbf in line 3, 1 of 3 rows: no rig measures more \
          than 22481 klbf; left out"
        ]
    );
    let error = read_readings(text.replace("1e8", "1e300").as_bytes(), "a.csv").unwrap_err();
    assert!(error.to_string().contains("line 3, column 10"), "{error}");
    assert!(error.to_string().len() < 200, "{error}");
}

/// Readings of a second sheet are not read, and a note names the sheet.
#[test]
fn a_second_sheet_of_readings_is_named() {
    let mut book = Workbook::new();
    for name in ["Well 1", "Well 2"] {
        let sheet = book.add_worksheet();
        sheet.set_name(name).expect("a name");
        for (column, heading) in ["Bit depth (ft)", "PU (klbf)"].into_iter().enumerate() {
            sheet.write(0, column as u16, heading).expect("a heading");
            sheet.write(1, column as u16, 200.0).expect("a number");
        }
    }
    let read = read_readings(&book.save_to_buffer().expect("a book"), "a.xlsx").expect("readings");
    let note = "readings in sheet 'Well 2' (1 row) are not read";
    assert!(read.notes.iter().any(|own| own == note), "{:?}", read.notes);
}

/// `3,031` under the last heading without quotation marks.
#[test]
fn a_number_cut_at_its_thousands_is_refused() {
    let text = "Bit depth (ft),Pick-up (klbf),Torque (ft-lbf)\n3000,150,950\n4000,170,3,031\n";
    let error = read_readings(text.as_bytes(), "a.csv").expect_err("four cells").to_string();
    assert!(
        error.contains("line 3, column 10: 4 cells in this row, but the header has 3 columns")
            && error.contains("'3' and '031' look like one number with thousands"),
        "{error}"
    );
    let more = text.replace("3,031", "3031,,").replace("950", "950,");
    let read = read_readings(more.as_bytes(), "a.csv").expect("empty cells at the end");
    assert_eq!(read.readings.len(), 2);
}

/// Rows below headings in another unit are not read in the first.
#[test]
fn units_do_not_change_within_a_table() {
    let head = "Bit depth (ft),Pick-up (kN)\n1000,300\n";
    let refused =
        |rest: &str| read_readings(format!("{head}{rest}").as_bytes(), "a.csv").expect_err(rest);
    let error = refused("Bit depth (m),Pick-up (kN)\n2000,400\n").to_string();
    assert!(error.contains("the bit depth is in 'ft' above and in 'm' from here on"), "{error}");
    let error = refused("Bit depth (ft),Pick-up (klbf)\n2000,400\n").to_string();
    assert!(error.contains("in 'kN' above and in 'klbf' from here on"), "{error}");
    let again = format!("{head}Bit depth (ft),Pick-up (kN)\n2000,400\n");
    assert_eq!(read_readings(again.as_bytes(), "a.csv").expect("readings").readings.len(), 2);
}
