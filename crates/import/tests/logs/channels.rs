//! Assignment of channels to quantities.

use wholestring_import::{Choices, ImportErrorKind, Quantity};

use crate::{notes, read, refused, rows};

#[test]
fn the_average_comes_before_the_greatest() {
    let text = "Time (s),HKLX (kN),HKLA (kN),Block position (m)\n0,9,5,1\n";
    let (found, log) = read(text);
    assert_eq!(found[0].hook_load_N, 5000.0);
    assert_eq!(
        notes(&log),
        "read: HKLA is the average and used as the hook load; not used: HKLX (--pick \
         hookload=HKLX selects that)\n"
    );
    let (found, log) =
        rows("a.csv", text.as_bytes(), &Choices::default().pick("hookload", "hklx")).unwrap();
    assert_eq!(found[0].hook_load_N, 9000.0);
    assert_eq!(notes(&log), "");
}

#[test]
fn the_greatest_alone_is_said() {
    let (_, log) = read("Time (s),HKLX (kN),BPOS (m)\n0,9,5\n");
    assert_eq!(
        notes(&log),
        "assumed: HKLX is used as the hook load, though it is the greatest between two rows; \
         there is no average\n"
    );
}

#[test]
fn a_unit_of_another_dimension_is_not_that_channel() {
    let text = "Time (s),Hook Load (m),HKLD (kN),Torque (furlong)\n0,9,5,1\n";
    let (rows, log) = read(text);
    assert_eq!(rows[0].hook_load_N, 5000.0);
    assert!(!log.has(Quantity::Torque));
    assert_eq!(
        notes(&log),
        "left out: Hook Load is not used as the hook load, because its unit 'm' is not one of \
         force (--unit hookload=UNIT selects it)\nleft out: Torque is not used as the torque, \
         because its unit 'furlong' is not one of torque (--unit torque=UNIT selects it)\n"
    );
}

#[test]
fn a_unit_is_said_or_asked_for() {
    let text = "Time (s),Hook Load,Block Position (m)\n0,9,5\n";
    assert!(refused(text).contains("give it with --unit hookload="), "{}", refused(text));
    for name in ["hookload", "Hook Load"] {
        let choices = Choices::default().unit(name, "t");
        let (rows, _) = rows("a.csv", text.as_bytes(), &choices).unwrap();
        assert_eq!(rows[0].hook_load_N, 9.0 * 9806.65);
    }
    // The user's unit takes precedence, and a note reports that it differs from the file's.
    let text = "Time (s),Hook Load (kN),Block Position (m)\n0,9,5\n";
    let (rows, log) =
        rows("a.csv", text.as_bytes(), &Choices::default().unit("hookload", "t")).unwrap();
    assert_eq!(rows[0].hook_load_N, 9.0 * 9806.65);
    assert_eq!(
        notes(&log),
        "checked: Hook Load is in t, as given with --unit; the file has 'kN'\n"
    );
}

#[test]
fn a_pick_that_is_not_there_is_refused_with_the_names() {
    let text = "Time (s),Hook Load (kN),Block Position (m)\n0,9,5\n";
    let choices = Choices::default().pick("hookload", "HL");
    let error = rows("a.csv", text.as_bytes(), &choices).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.csv: there is no hookload 'HL'; it holds: 'Time', 'Hook Load', 'Block Position'"
    );
    let choices = Choices::default().pick("hookload", "Block Position");
    let error = rows("a.csv", text.as_bytes(), &choices).unwrap_err();
    assert!(matches!(error.kind(), ImportErrorKind::WrongUnit { .. }), "{error}");
}

#[test]
fn the_bit_of_a_motor_is_not_the_string() {
    let (rows, log) = read("Time (s),Bit RPM (rpm),Surf RPM (rpm),HKLD (kN)\n0,180,60,1\n");
    assert!((rows[0].rotary_speed_rad_per_s - std::f64::consts::TAU).abs() < 1e-14);
    assert_eq!(log.channels[1].quantity, None);
}

#[test]
fn item_numbers_of_wits_are_names() {
    let text =
        "0105,0106,0108,0112,0114\ndate,time,m,m,t\n210324,235958,10,1,5\n210325,000003,11,2,6\n";
    let (rows, log) = read(text);
    assert_eq!(rows[1].time_s, 5.0);
    assert_eq!(rows[1].bit_depth_m, 11.0);
    assert_eq!(log.start.as_deref(), Some("2021-03-24 23:59:58"));
}

#[test]
fn a_depth_is_the_holes_unless_it_is_said() {
    let text = "Time (s),DEPT (m),HKLD (kN),BPOS (m)\n0,100,1,2\n";
    let (found, log) = read(text);
    assert_eq!(found[0].hole_depth_m, 100.0);
    assert_eq!(
        notes(&log),
        "assumed: DEPT is used as the depth of the hole, not of the bit (--pick bit-depth=DEPT \
         uses it as that)\n"
    );
    let choices = Choices::default().pick("bit-depth", "DEPT");
    let (found, log) = rows("a.csv", text.as_bytes(), &choices).unwrap();
    assert!(found[0].bit_depth_m == 100.0 && found[0].hole_depth_m.is_nan());
    assert_eq!(notes(&log), "");
}
