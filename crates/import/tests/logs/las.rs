//! Difficulties of LAS.

use wholestring_import::{Choices, Quantity};

use crate::{notes, read, refused, rows};

/// A log of time, bit depth and hook load with these rows.
fn las(rows: &str) -> String {
    format!(
        "~V\nVERS. 2.0:\nWRAP. NO:\n~W\nNULL. -999.25:\n~C\nTIME.s :\nDBTM.m :\nHKLA.kN :\n~A\n{rows}"
    )
}

fn loads_kN(text: &str) -> Vec<f64> {
    read(text).0.iter().map(|row| row.hook_load_N / 1e3).collect()
}

#[test]
fn nulls_are_nothing_however_they_are_written() {
    let (rows, log) = read(&las("0 1 -999.2500\n1 2 -999.25\n2 3 5\n"));
    assert!(rows[0].hook_load_N.is_nan() && rows[1].hook_load_N.is_nan());
    assert_eq!(rows[2].hook_load_N, 5000.0);
    assert_eq!(notes(&log), "");
}

#[test]
fn usual_nulls_are_said_where_the_head_has_another() {
    let (rows, log) = read(&las("0 1 -9999\n1 2 4\n2 -9999 5\n"));
    assert!(rows[0].hook_load_N.is_nan() && rows[2].bit_depth_m.is_nan());
    assert_eq!(
        notes(&log),
        "assumed: read as null values, as in many logs, although the head does not declare them: \
         2 values such as -9999, the first in line 11\n"
    );
}

#[test]
fn byte_order_marks_and_utf_16_are_read() {
    let text = las("0 1 2\n1 2 3\n").replace("HKLA.kN :", "HKLA.kN : Hakenlast größer");
    let mut marked = b"\xef\xbb\xbf".to_vec();
    marked.extend_from_slice(text.as_bytes());
    let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    for bytes in [
        marked,
        [&b"\xff\xfe"[..], &little].concat(),
        [&b"\xfe\xff"[..], &big].concat(),
        little,
        big,
        // Latin-1.
        text.chars().map(|c| c as u8).collect(),
        text.replace('\n', "\r\n").into_bytes(),
        text.replace('\n', "\r").into_bytes(),
    ] {
        let (rows, log) = rows("a.las", &bytes[..], &Choices::default()).unwrap();
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[1].hook_load_N, 3000.0);
        assert_eq!(log.channels[2].description, "Hakenlast größer");
    }
}

#[test]
fn wrapped_rows_end_with_their_last_line() {
    let wrapped = las("0\n 1.5 2.5\n1\n 2.5\n 3.5\n").replace("WRAP. NO", "WRAP. YES");
    assert_eq!(loads_kN(&wrapped), [2.5, 3.5]);
    let uneven = las("0\n 1.5 2.5\n1\n 2.5\n2\n 3.5 4.5\n").replace("WRAP. NO", "WRAP. YES");
    assert_eq!(
        refused(&uneven),
        "a log, line 16: this wrapped row begins differently from the first, with or without its \
         index alone in a line; a value may be missing above"
    );
}

#[test]
fn a_comma_may_stand_before_decimals() {
    let (rows, log) = read(&las("0 1 2,5\n1,5 2 3.5\n"));
    assert_eq!(rows[0].hook_load_N, 2500.0);
    assert!(notes(&log).contains("a comma within a number is read as the decimal sign: 1 value"));
}

#[test]
fn delimiters_are_those_of_the_head_or_of_the_rows() {
    for (declared, rows) in [
        ("DLM. COMMA :\n", "0,1,2\n1,,3\n"),
        ("DLM. TAB :\n", "0\t1\t2\n1\t\t3\n"),
        ("DLM. SPACE :\n", "0 1 2\n1 -999.25 3\n"),
        ("", "0,1,2\n1,,3\n"),
        ("", "0, 1, 2,\n1, , 3,\n"),
        ("", "0\t1\t2\n1\t\t3\n"),
        // The head is wrong.
        ("DLM. SPACE :\n", "0,1,2\n1,,3\n"),
    ] {
        let text = las(rows).replace("~W\n", &format!("{declared}~W\n"));
        if rows.starts_with("0\t1") && declared.is_empty() {
            // Blanks separate three values; the row below has two.
            assert!(refused(&text).contains("line 12: the row has 2 values"), "{rows}");
            continue;
        }
        let (rows, _) = read(&text);
        assert_eq!(
            (rows[0].hook_load_N, rows[1].hook_load_N),
            (2000.0, 3000.0),
            "{declared}{text}"
        );
        assert!(rows[1].bit_depth_m.is_nan());
    }
}

#[test]
fn numbers_that_have_run_together_are_refused() {
    assert_eq!(
        refused(&las("0 1 2\n1 7.020101130.188\n")),
        "a log, line 12: the row has 2 values; 3 were expected; '7.020101130.188' may be two numbers \
         that have run together"
    );
    assert_eq!(
        refused(&las("0 1 2\n1 2 7.330-19508.961\n")),
        "a log, line 12: '7.330-19508.961' is not a number; the hook load HKLA was expected"
    );
}

#[test]
fn a_file_may_end_within_its_last_row() {
    let (rows, log) = read(&las("0 1 2\n1 2"));
    assert_eq!(rows.len(), 1);
    assert_eq!(notes(&log), "left out: the last row, line 12: the file ends within it\n");
    assert!(refused(&las("0 1 2\n1 2\n")).contains("the row has 2 values; 3 were expected"));
}

#[test]
fn comments_blank_lines_and_tabs_are_passed_over() {
    let text = las("\n# 5 6 7\n0\t1\t2\n\n# end\n  1   2 \t 3\n\x1a");
    let text = format!("# made by a tool\n\n{}", text.replace("~C\n", "~C\n# mnemonics\n\n"));
    assert_eq!(loads_kN(&text), [2.0, 3.0]);
}

#[test]
fn names_may_stand_behind_the_title_of_the_data() {
    let text = "~V\nVERS. 2.0:\n~A DBTM HKLA\n10 20\n";
    let choices = Choices::default().unit("hookload", "kN").unit("bit-depth", "m");
    let (rows, log) = rows("a.las", text.as_bytes(), &choices).unwrap();
    assert_eq!(rows[0].hook_load_N, 20_000.0);
    assert!(notes(&log).contains("the names after ~A are used as the curves'"));
    assert!(refused("~V\nVERS. 2.0:\n~A\n1 2\n").contains("there is no section ~Curve before"));
    assert!(refused("~V\nVERS. 2.0:\n~A\n1 2\n~C\nDEPT.m:\n").contains("no section ~Curve"));
    assert_eq!(
        refused("~V\nVERS. 2.0:\n~C\nTIME.s:\n"),
        "a log: the section ~A with the data is missing"
    );
}

#[test]
fn sections_may_stand_in_another_order() {
    let text = "~C\nTIME.s:\nHKLA.kN:\n~P\nX. 1:\n~W\nNULL. -1:\n~V\nVERS. 2.0:\n~A\n0 -1\n1 5\n";
    let (rows, _) = read(text);
    assert!(rows[0].hook_load_N.is_nan());
    assert_eq!(rows[1].hook_load_N, 5000.0);
}

#[test]
fn las_3_has_definitions_and_data() {
    let text = "~Version\nVERS. 3.0:\nWRAP. NO:\nDLM. COMMA:\n~Well\nNULL. -999.25:\nWELL. A-1: name\n\
        ~Parameter\nHKLA.kN 3 : not a curve {F}\n\
        ~Log_Definition\nTIME.s : time {F8.1}\nTOOL. : text {S}\nHKLA.klbf : Hook load {F8.2} | x\n\
        ~Core_Definition\nCORE.m:\n~Core_Data | Core_Definition\n1,2,3,4\n\
        ~Log_Data | Log_Definition\n0,\"A, b\",100\n1,B,-999.25\n2,,101\n\
        ~Tops_Data\n5,6\n";
    let (rows, log) = read(text);
    assert_eq!(rows.len(), 3);
    assert!((rows[2].hook_load_N - 101.0 * 4448.2216152605).abs() < 1e-6);
    assert_eq!(log.what, "LAS 3.0");
    assert_eq!(log.well.as_deref(), Some("A-1"));
    assert_eq!(log.channels[2].description, "Hook load");
    let notes = notes(&log);
    assert!(notes.contains("the sections ~Core_Data, which are not the log"), "{notes}");
    assert!(notes.contains("what follows from line 22: ~Tops_Data"), "{notes}");
}

#[test]
fn names_may_be_empty_or_stand_twice() {
    let text = "~V\nVERS. 2.0:\n~C\nTIME.s:\n.m : nameless\nHKLD.kN:\nHKLD.kN:\n~A\n0 1 2 3\n";
    assert_eq!(
        refused(text),
        "a log: it holds 2 of the kind 'hookload': 'HKLD', 'HKLD:2'; pick one: --pick hookload=NAME"
    );
    let choices = Choices::default().pick("hookload", "HKLD:2");
    let (rows, log) = rows("a.las", text.as_bytes(), &choices).unwrap();
    assert_eq!(rows[0].hook_load_N, 3000.0);
    assert_eq!(log.channels[1].mnemonic, "UNKNOWN");
}

#[test]
fn channels_of_text_do_no_harm() {
    let text = "~V\nVERS. 2.0:\n~C\nTIME.s:\nACT. : activity\nHKLD.kN:\n~A\n\
        0 DRILL 2\n1 \"TRIP IN\" 3\n2 - 4\n";
    assert_eq!(loads_kN(text), [2.0, 3.0, 4.0]);
}

#[test]
fn a_curve_without_a_point_has_no_unit() {
    let text = "~V\nVERS. 2.0:\n~C\nTIME.s:\nHKLD kN: hook load\n~A\n0 1\n";
    let error = refused(text);
    assert!(
        error.starts_with("a log: the hook load HKLD has no unit; give it with --unit hookload="),
        "{error}"
    );
    let (rows, log) =
        rows("a.las", text.as_bytes(), &Choices::default().unit("hookload", "kN")).unwrap();
    assert_eq!(rows[0].hook_load_N, 1000.0);
    assert!(notes(&log).contains("without a point after the name"));
}

#[test]
fn units_of_recorders_are_known() {
    let force = |unit: &str, expected: f64| {
        let text =
            format!("~V\nVERS. 2.0:\n~C\nTIME.s:\nHKLD.{unit} : hook load: average\n~A\n0 1\n");
        let load = read(&text).0[0].hook_load_N;
        assert!((load - expected).abs() < 1e-6 * expected, "{unit}: {load}");
    };
    for unit in ["klbs", "1000 lbf", "1000lbf", "klbf", "KLBF", "kips"] {
        force(unit, 4448.2216152605);
    }
    force("kkgf", 9806.65);
    force("kdaN", 1e4);
    force("tonne", 9806.65);
    let text = "~V\nVERS. 2.0:\n~C\nTIME.s:\nTQA.ft-lbs:\nMFIA.galUS/min:\nSPPA.psi:\nRPMA.:\n~A\n0 1 1 1 60\n";
    let (rows, log) = read(text);
    assert!((rows[0].torque_N_m - 1.3558179483314).abs() < 1e-12);
    assert!((rows[0].flow_rate_m3_per_s - 6.30901964e-5).abs() < 1e-15);
    assert!((rows[0].standpipe_pressure_Pa - 6894.757293168).abs() < 1e-8);
    assert!((rows[0].rotary_speed_rad_per_s - std::f64::consts::TAU).abs() < 1e-14);
    assert!(notes(&log).contains("RPMA has no unit and is taken to be in rpm"));
}

#[test]
fn a_log_against_depth_has_no_time() {
    let text = "~V\nVERS. 2.0:\n~W\nSTRT.ft 10:\n~C\nDEPT. :\nHKLD.kN:\n~A\n10 1\n9 2\n";
    let (rows, log) = read(text);
    assert!(rows[0].time_s.is_nan());
    assert!((rows[1].hole_depth_m - 2.7432).abs() < 1e-12);
    assert!(log.has(Quantity::HoleDepth) && !log.has(Quantity::Time));
    assert_eq!(notes(&log), "assumed: DEPT has no unit and is taken to be in 'ft' as STRT\n");
}

#[test]
fn a_blank_behind_the_point_may_be_missing() {
    let text = "~V\nVERS.2.0:\nWRAP.YES:\n~W\nNULL.-5:\n~C\nTIME.s:\nHKLD.kN:\n~A\n0\n-5\n1\n7\n";
    let (rows, log) = read(text);
    assert!(rows[0].hook_load_N.is_nan());
    assert_eq!(rows[1].hook_load_N, 7000.0);
    assert_eq!(log.what, "LAS 2.0, wrapped");
}

#[test]
fn a_repeated_heading_of_the_rows_loses_none() {
    let (rows, log) = read(&las("0 1 5\n1 2 6\n~ASCII\n2 3 7\n"));
    assert_eq!(rows.len(), 3);
    assert!(notes(&log).contains("the ~ASCII of line 13 continues the rows above"));
    let joined = las(&format!("0 1 5\n1 2 6\n{}", las("2 3 7\n")));
    let error = refused(&joined);
    assert!(
        error.contains("line 22: another section of rows, ~A, after other sections"),
        "{error}"
    );
}

#[test]
fn the_names_of_the_curves_may_stand_again() {
    let (rows, log) = read(&las("0 1 5\nTIME DBTM HKLA\n1 2 6\ntime dbtm hkla\n2 3 7\n"));
    assert_eq!(rows.len(), 3);
    let note = "lines with the names of the curves again, the first line 12";
    assert!(notes(&log).contains(note), "{}", notes(&log));
}

#[test]
fn values_that_the_logger_marks_as_bad_are_said() {
    let (rows, log) = read(&las("0 1 5\n1 2 Bad\n2 3 BAD\n"));
    assert!(rows[1].hook_load_N.is_nan() && rows[2].hook_load_N.is_nan());
    let note = "2 values that the logger marks as bad, the first in line 12";
    assert!(notes(&log).contains(note), "{}", notes(&log));
}
