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

/// Columns named as keys of a case belong to their row, `use` holds one out, and others are told.
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
        let of = &read.readings[0];
        let all = [of.pick_up_N, of.slack_off_N, of.rotating_N, of.torque_N_m];
        assert_eq!(all, [Some(536.1e3), Some(503.8e3), Some(524.8e3), Some(150.0)]);
        assert!((of.mud_density_kg_per_m3.expect("a number") - 1078.44).abs() < 0.1);
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
