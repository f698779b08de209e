//! Logs from the field: symbols of WITS and LAS, nulls, serial days, rows newest first, joined
//! exports, a sensor with a zero offset, workbooks. All are of one trip of five stands with known
//! pick-up weights: those that were put into the log, in which the indicator includes the block's
//! 55 klbf.

use wholestring_import::{Choices, Input, contents, import};

/// The trip with depths in `F`, as a recorder writes it to LAS.
const TRIP: &str = include_str!("../samples/own/trip-in-feet.las");

/// Pick-up weights including the block, kN, from the deepest on, as put into the log.
const PICK_UPS_KN: [f64; 5] = [1200.8, 1192.0, 1183.5, 1174.6, 1165.6];

/// A pound-force, kN.
const KLBF_KN: f64 = 4.448_221_615;

struct Picked {
    pick_ups_kN: Vec<f64>,
    notes: Vec<String>,
}

impl Picked {
    fn says(&self, part: &str) -> bool {
        self.notes.iter().any(|note| note.contains(part))
    }
}

fn picked_with(name: &str, bytes: &[u8], choices: &Choices) -> Result<Picked, String> {
    let choices = choices.clone().value("block-weight", "55 klbf");
    let imported = import(vec![Input::of_bytes(name, bytes)], &choices);
    let imported = imported.map_err(|error| error.to_string())?;
    let mut readings: Vec<(f64, f64)> = imported.picks[0]
        .readings()
        .iter()
        .filter_map(|reading| Some((reading.bit_depth_m, 1e-3 * reading.pick_up_N?)))
        .collect();
    readings.sort_by(|a, b| b.0.total_cmp(&a.0));
    let notes = imported.notes.iter().map(|(_, note)| note.text().to_owned()).collect();
    Ok(Picked { pick_ups_kN: readings.into_iter().map(|reading| reading.1).collect(), notes })
}

fn picked(name: &str, bytes: &[u8]) -> Picked {
    picked_with(name, bytes, &Choices::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Checks the pick-up weights. They were printed to 0.1 kN; the median in slips is within 0.1 klbf
/// of the block's weight, which is not corrected.
#[track_caller]
fn assert_pick_ups(picked: &Picked) {
    assert_eq!(picked.pick_ups_kN.len(), 5, "{:?}", picked.notes);
    for (found, expected) in picked.pick_ups_kN.iter().zip(PICK_UPS_KN) {
        assert!((found - expected).abs() < 0.06, "{:?}", picked.pick_ups_kN);
    }
}

/// The rows of the trip in order, as numbers.
fn rows() -> Vec<Vec<f64>> {
    let (_, data) = TRIP.split_once("~ASCII").unwrap();
    let rows = data.lines().skip(1).filter(|line| !line.trim().is_empty());
    rows.map(|line| line.split_whitespace().map(|cell| cell.parse().unwrap()).collect()).collect()
}

/// The trip with other rows.
fn with_rows(rows: &[Vec<f64>]) -> String {
    let (head, data) = TRIP.split_once("~ASCII").unwrap();
    let title = data.lines().next().unwrap();
    let lines = rows.iter().map(|row| {
        let cells: Vec<String> = row.iter().map(|cell| format!("{cell}")).collect();
        cells.join(" ")
    });
    format!("{head}~ASCII{title}\n{}\n", lines.collect::<Vec<_>>().join("\n"))
}

/// The rows with their depths in metres.
fn in_metres() -> Vec<Vec<f64>> {
    let mut rows = rows();
    for row in &mut rows {
        row[1..4].iter_mut().for_each(|depth| *depth *= 0.3048);
    }
    rows
}

#[test]
fn feet_are_f_in_las() {
    assert_pick_ups(&picked("trip.las", TRIP.as_bytes()));
    // Metres in Cyrillic letters, and in WITS.
    for metres in ["м", "метр", "M", "mts"] {
        let text = with_rows(&in_metres()).replace(".F ", &format!(".{metres} "));
        assert_pick_ups(&picked("trip.las", text.as_bytes()));
    }
}

/// Letters of Windows-1251, one byte each, in which `м` is not valid UTF-8.
#[test]
fn cyrillic_letters_of_a_byte_are_read() {
    let text = with_rows(&in_metres()).replace(".F ", ".\u{ec} ");
    let bytes: Vec<u8> = text.chars().map(|letter| letter as u8).collect();
    assert!(std::str::from_utf8(&bytes).is_err());
    assert_pick_ups(&picked("trip.las", &bytes));
}

/// The symbols of WITS level 0: KLB and KFLB, KDN and KNM.
#[test]
fn the_symbols_of_wits_are_read() {
    let field = TRIP.replace(".klbs ", ".KLB ").replace(".ft-lbs", ".KFLB").replace(".psi", ".PSI");
    assert_pick_ups(&picked("trip.las", field.as_bytes()));
    let metric: Vec<Vec<f64>> = rows()
        .into_iter()
        .map(|mut row| {
            row[4] *= 0.1 * KLBF_KN;
            row[5] *= 0.1 * KLBF_KN;
            row
        })
        .collect();
    let metric = with_rows(&metric).replace(".klbs ", ".KDN ").replace(".ft-lbs", ".KNM");
    assert_pick_ups(&picked("trip.las", metric.as_bytes()));
}

/// A channel that was left out is named in the error, and its unit alone includes it.
#[test]
fn a_channel_left_out_is_named_where_it_is_missed() {
    let odd = TRIP.replace(".F ", ".ftx ");
    let refused = picked_with("trip.las", odd.as_bytes(), &Choices::default());
    let refused = refused.err().expect("a log without depths");
    assert!(refused.contains("the depth of the bit is missing"), "{refused}");
    let reason = "DBTM is not used as the bit depth, because its unit 'ftx' is not one of length \
         (--unit bit-depth=UNIT selects it)";
    assert!(refused.contains(reason), "{refused}");
    let mut choices = Choices::default();
    for name in ["bit-depth", "hole-depth", "block-position"] {
        choices = choices.unit(name, "ft");
    }
    let found = picked_with("trip.las", odd.as_bytes(), &choices);
    assert_pick_ups(&found.unwrap_or_else(|error| panic!("{error}")));
}

/// A null of 0 would remove every speed and torque of a string that does not turn.
#[test]
fn a_null_of_zero_is_not_believed_of_what_is_often_zero() {
    let text = TRIP.replace("-999.25 : NULL", "0 : NULL");
    assert_ne!(text, TRIP);
    let found = picked("trip.las", text.as_bytes());
    assert_pick_ups(&found);
    assert!(found.says("0 is read as a value of"), "{:?}", found.notes);
}

/// Excel's days, regardless of the unit: 45368.1666 is 2024-03-17 04:00.
#[test]
fn serial_days_are_dates() {
    let days: Vec<Vec<f64>> = rows()
        .into_iter()
        .map(|mut row| {
            row[0] = 45_368.0 + (4.0 * 3600.0 + row[0]) / 86_400.0;
            row
        })
        .collect();
    for unit in ["d", "days", "D", "S", ""] {
        let text = with_rows(&days).replace("TIME .S ", &format!("TIME .{unit} "));
        let held = contents(Input::of_bytes("trip.las", text.as_bytes())).unwrap();
        let from = held.lines.iter().any(|line| line.contains("from 2024-03-17 04:00:00"));
        assert!(from, "{unit}: {:?}", held.lines);
        assert_pick_ups(&picked("trip.las", text.as_bytes()));
    }
    // Hours of a long campaign remain hours.
    let hours = with_rows(&rows());
    assert_pick_ups(&picked("trip.las", hours.as_bytes()));
}

#[test]
fn rows_newest_first_are_read_from_the_last_on() {
    let mut newest = rows();
    newest.reverse();
    let found = picked("trip.las", with_rows(&newest).as_bytes());
    assert_pick_ups(&found);
    assert!(found.says("the log runs newest first"), "{:?}", found.notes);
    // A clock that is set back once is not a log in reverse order.
    let mut back = rows();
    let late = back.len() / 2;
    back[late..].iter_mut().for_each(|row| row[0] -= 1.0);
    let found = picked("trip.las", with_rows(&back).as_bytes());
    assert!(!found.says("newest first"), "{:?}", found.notes);
}

/// The trip as text of a recorder.
fn text_of(rows: &[Vec<f64>], heading: &str) -> String {
    let mut text = format!("{heading}\n");
    for row in rows {
        let at_s = 4.0 * 3600.0 + row[0];
        let (hour, minute, second) = (at_s / 3600.0, at_s / 60.0 % 60.0, at_s % 60.0);
        text += &format!(
            "2024/03/17 {:02}:{:02}:{:02},{},{},{},{},{},{},{}\n",
            hour as u32,
            minute as u32,
            second as u32,
            row[1],
            row[2],
            row[3],
            row[4],
            row[5],
            row[6],
            row[7]
        );
    }
    text
}

const HEADING: &str = "YYYY/MM/DD HH:MM:SS,Bit Depth (feet),Hole Depth (feet),Block Height \
                       (feet),Hook Load (klbs),Weight on Bit (klbs),Rotary Torque (ft_lbs),Rotary RPM \
                       (RPM)";

/// Two joined exports have their headings twice.
#[test]
fn headings_in_the_middle_are_passed_over() {
    let rows = rows();
    let half = rows.len() / 2;
    let text = text_of(&rows[..half], HEADING) + &text_of(&rows[half..], HEADING);
    let found = picked("edr.csv", text.as_bytes());
    assert_pick_ups(&found);
    let line = format!("1 line with the headings again, the first line {}", half + 2);
    assert!(found.says(&line), "{:?}", found.notes);
    // Different headings are those of another log.
    let other =
        HEADING.replace("Bit Depth (feet),Hole Depth (feet)", "Hole Depth (feet),Bit Depth (feet)");
    let text = text_of(&rows[..half], HEADING) + &text_of(&rows[half..], &other);
    let refused = picked_with("edr.csv", text.as_bytes(), &Choices::default()).err().unwrap();
    assert!(refused.contains("the headings of another log follow"), "{refused}");
}

/// The load below the block is the reading minus the reading in slips, for any zero offset.
#[test]
fn a_weight_indicator_off_zero_is_corrected() {
    // In slips the indicator shows 55 klbf; these shift it.
    for (shift, note) in [
        (-47.0, "with an offset of 8"),
        (-62.0, "with an offset of -6.99"),
        (-90.0, "with an offset of -35"),
        (4.0, "the zero of the weight indicator is off"),
        (-4.0, "the zero of the weight indicator is off"),
    ] {
        let off: Vec<Vec<f64>> = rows()
            .into_iter()
            .map(|mut row| {
                row[4] += shift;
                row
            })
            .collect();
        let found = picked("trip.las", with_rows(&off).as_bytes());
        assert!(found.says(note), "{shift}: {:?}", found.notes);
        assert_eq!(found.pick_ups_kN.len(), 5, "{shift}");
        for (found, expected) in found.pick_ups_kN.iter().zip(PICK_UPS_KN) {
            // The noise of the median in slips, 0.1 klbf.
            assert!((found - expected).abs() < 0.6, "{shift}: {found} for {expected}");
        }
    }
}

/// A recorder's export as a workbook is a log, with Excel cells of date and time.
#[test]
fn a_log_as_a_workbook_is_a_log() {
    let bytes = include_bytes!("../samples/own/recorder.xlsx");
    let held = contents(Input::of_bytes("edr.xlsx", bytes)).unwrap();
    assert_eq!(held.what, "a log of a rig in sheet 'EDR'");
    let from = held
        .lines
        .iter()
        .any(|line| line.contains("390 rows") && line.contains("2024-05-14 23:55"));
    assert!(from, "{:?}", held.lines);
    let found = picked("edr.xlsx", bytes);
    assert_eq!(found.pick_ups_kN.len(), 5, "{:?}", found.notes);
    for (found, expected) in found.pick_ups_kN.iter().zip(PICK_UPS_KN) {
        // Hook loads are written to 0.1 klbf.
        assert!((found - expected).abs() < 0.1 * KLBF_KN, "{found} for {expected}");
    }
    // An error names the row of the sheet.
    let mut workbook = rust_xlsxwriter::Workbook::new();
    let sheet = workbook.add_worksheet().set_name("Rig").unwrap();
    for (column, text) in ["Time (s)", "Bit Depth (m)", "Hook Load (kN)"].into_iter().enumerate() {
        sheet.write_string(0, column as u16, text).unwrap();
    }
    for row in 1..5_u32 {
        for column in 0..3 {
            sheet.write_number(row, column, f64::from(row)).unwrap();
        }
    }
    sheet.write_string(3, 2, "off").unwrap();
    let bytes = workbook.save_to_buffer().unwrap();
    let error = contents(Input::of_bytes("rig.xlsx", &bytes)).unwrap_err().to_string();
    assert!(error.starts_with("rig.xlsx, sheet 'Rig', row 4: 'off' is not a number"), "{error}");
}

/// In a log of trips the only depth is that of the bit.
#[test]
fn the_only_depth_of_a_log_of_trips_is_the_bits() {
    let names = "Time,TRIPNUM,TRIPFILL,STANDSTOGO,Depth,BLOCKCOMP,HKLD,RPM30s,TORQUE30s";
    let units = "s,unitless,m3,unitless,ft,ft,klbf,rpm,ft-lbf";
    let data = rows().into_iter().map(|row| {
        format!(
            "<data>{},1,0,5,{},{},{},{},{}</data>",
            row[0], row[1], row[3], row[4], row[7], row[6]
        )
    });
    let text = format!(
        "<logs xmlns=\"http://www.witsml.org/schemas/1series\" version=\"1.4.1.1\"><log>\
         <nameWell>W</nameWell><name>TripTime</name><indexType>elapsed time</indexType>\
         <indexCurve>Time</indexCurve><logData><mnemonicList>{names}</mnemonicList>\
         <unitList>{units}</unitList>{}</logData></log></logs>",
        data.collect::<String>()
    );
    let found = picked("trip.xml", text.as_bytes());
    assert_pick_ups(&found);
    assert!(found.says("Depth is used as the depth of the bit"), "{:?}", found.notes);
    assert!(found.says("it is assumed to be off bottom throughout"), "{:?}", found.notes);
    // It is recognised by decreasing depth even if no channel shows that it is a log of trips,
    // because no hole gets shallower.
    let plain = text.replace("TRIPNUM,TRIPFILL,STANDSTOGO", "A,B,C");
    let found = picked("trip.xml", plain.as_bytes());
    assert_pick_ups(&found);
    assert!(found.says("the only depth increases and decreases"), "{:?}", found.notes);
}

/// The refusal of the trip with one column changed.
fn refused_with(column: usize, change: impl Fn(f64) -> f64) -> String {
    let mut rows = rows();
    rows.iter_mut().for_each(|row| row[column] = change(row[column]));
    let found = picked_with("trip.las", with_rows(&rows).as_bytes(), &Choices::default());
    found.err().expect("a log that cannot be picked")
}

/// The channel is present: the advice to pick one would lead to the same channel.
#[test]
fn a_channel_of_null_values_is_named() {
    for (column, channel, what) in
        [(1, "DBTM", "the depth of the bit"), (4, "HKLA", "the hook load")]
    {
        let text = refused_with(column, |_| -999.25);
        let expected = format!(
            "{what} is missing: its channel {channel} has only null values, such as -999.25, or \
             empty cells; if another channel has it, choose it with --pick"
        );
        assert!(text.contains(&expected), "{text}");
    }
    let text = refused_with(1, |depth| depth * 1e3);
    assert!(
        text.contains("its channel DBTM has only values outside the range of any rig"),
        "{text}"
    );
}

#[test]
fn a_hook_load_that_never_changes_is_no_reading() {
    let text = refused_with(4, |_| 0.0);
    assert!(text.contains("the hook load is 0 throughout; if another channel has"), "{text}");
    let mut rows = rows();
    rows.iter_mut().for_each(|row| row[4] = 250.0);
    let found = picked("trip.las", with_rows(&rows).as_bytes());
    assert!(
        found.says("THE HOOK LOAD NEVER CHANGES: it is 250 klbf in all rows"),
        "{:?}",
        found.notes
    );
    assert!(found.pick_ups_kN.is_empty());
}

/// Thousands of pounds under pounds; the block weighs 55 klbf.
#[test]
fn a_hook_load_in_thousands_is_refused_with_its_unit() {
    let text = TRIP.replace("HKLA .klbs", "HKLA .lbs");
    let refused = picked_with("trip.las", text.as_bytes(), &Choices::default());
    let refused = refused.err().expect("a hook load of pounds");
    assert!(refused.contains("the hook load shows no string"), "{refused}");
    assert!(refused.contains("is the hook load in klbf instead of lbf?"), "{refused}");
}
