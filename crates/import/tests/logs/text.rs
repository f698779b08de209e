//! Logs as text of electronic drilling recorders.

use wholestring_import::{Choices, Input, contents};

use crate::{notes, read, refused, summary};

/// Headings in a recorder's style, invented.
const RECORDER: &str = "\"Well: Synthetic 2\"\n\"Exported 2021-03-25\"\n\n\
    YYYY/MM/DD,HH:MM:SS,Hole Depth (feet),Bit Depth (feet),Block Height (feet),Hook Load (klbs),\
    Weight on Bit (klbs),Rotary Torque (kft_lb),Rotary RPM (RPM),Standpipe Pressure (psi),\
    Total Pump Output (gal_per_min),Rate Of Penetration (ft_per_hr),Memos\n\
    2021/03/24,10:00:00,12050,12030.5,62.1,251.3,0,0,0,2450,610,0,\n\
    2021/03/24,10:00:05,12050,12025.1,67,268.9,0,0,0,2452,610,0,\"pulled, 30 klbs \"\"over\"\"\"\n\
    2021/03/24,10:00:10,12050,12020.3,71.8,-999.25,0,11.25,80,2449,610,,\"two\nlines\"\n\
    2021/03/24,10:00:15,12050,12020.3,71.8,NaN,,,,,,,9 5/8\" shoe\n";

#[test]
fn the_text_of_a_recorder_is_read() {
    insta::assert_snapshot!(summary("edr.csv", RECORDER.as_bytes(), &Choices::default()));
}

#[test]
fn units_may_stand_in_the_second_row() {
    for text in [
        "Time;Bit depth;Hook load\ns;m;t\n0;10,5;1.000,5\n5;11;2\n",
        "Time\tBit depth\tHook load\n(s)\t(m)\t(t)\n0\t10,5\t1.000,5\n5\t11\t2\n",
    ] {
        let (rows, log) = read(text);
        assert_eq!(rows[0].bit_depth_m, 10.5);
        assert_eq!(rows[0].hook_load_N, 1000.5 * 9806.65);
        assert_eq!(notes(&log), "read: numbers have decimal commas\n");
    }
    let (rows, _) = read("Time;Bit depth;Hook load\ns;m;t\n0;10.5;1,000.5\n5;11;2\n");
    assert_eq!(rows[0].hook_load_N, 1000.5 * 9806.65);
}

#[test]
fn marks_that_may_mean_either_are_refused() {
    let error = refused("Time;Bit depth;Hook load\ns;m;t\n0;10,5;1\n5;10.5;2\n");
    assert_eq!(
        error,
        "a log, line 4: '10.5' is not a number; the bit depth Bit depth was expected"
    );
    let error = refused("Time (s),Bit depth (m),Hook load (t)\n0,\"12,030\",1\n");
    assert!(error.contains("'12,030' is not a number"), "{error}");
    let error = refused("Time (s),Bit depth (m),Hook load (t)\n0,12,030,1\n");
    assert_eq!(
        error,
        "a log, line 2: the row has 4 cells; 3 were expected (are there commas within numbers?)"
    );
}

#[test]
fn short_rows_and_cells_without_a_number_hold_nothing() {
    let (rows, _) = read("Time (s),Bit depth (m),Hook load (t)\n0,,1\n1\n2,--,#N/A\n3,4,5\n");
    assert!(rows[0].bit_depth_m.is_nan() && rows[1].hook_load_N.is_nan());
    assert!(rows[2].bit_depth_m.is_nan());
    assert_eq!(rows[3].bit_depth_m, 4.0);
    let error = refused("Time (s),Bit depth (m),Hook load (t)\n0,x,1\n");
    assert_eq!(error, "a log, line 2: 'x' is not a number; the bit depth Bit depth was expected");
}

#[test]
fn a_line_between_headings_and_rows_is_said() {
    let (rows, log) =
        read("Time (s),Bit depth (m),Hook load (t)\nRig clock,Driller,Sensor 2\n0,1,2\n1,2,3\n");
    assert_eq!(rows.len(), 2);
    assert_eq!(notes(&log), "left out: line 2, which is not a row: 'Rig clock,Driller,Sensor 2'\n");
}

#[test]
fn a_quotation_that_stays_open_is_refused() {
    let open = format!("Time (s),Hook load (t),Bit depth (m)\n0,1,\"x\n{}", "1,2,3\n".repeat(200));
    assert_eq!(
        refused(&open),
        "a log, line 2: a quotation mark opens and is not closed within 100 lines"
    );
}

#[test]
fn readings_and_surveys_are_no_logs() {
    for text in [
        "MD (m),Inc (deg),Azi (deg)\n0,0,0\n10,0,0\n20,0,0\n",
        "Bit depth (m),Pick-up (t),Slack-off (t)\n100,50,40\n200,60,50\n",
    ] {
        let what = contents(Input::of_bytes("a.csv", text.as_bytes())).map(|content| content.what);
        assert!(!what.unwrap_or_default().contains("log"), "{text}");
    }
}

#[test]
fn a_unit_may_begin_with_a_number() {
    let text = "\"Time\",\"Hook Load\",\"Bit Depth\"\n\"\",\"1000 lbf\",\"ft\"\n\
        \"03/14/2021 10:00:00.000 PM\",\"250.1\",\"1000\"\n";
    let (rows, log) = read(text);
    assert!((rows[0].hook_load_N - 250.1 * 4448.2216152605).abs() < 1e-6);
    assert_eq!(log.start.as_deref(), Some("2021-03-14 22:00:00"));
}
