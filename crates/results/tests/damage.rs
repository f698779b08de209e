//! Damaged files of results cause an error message with their name, and no panic.

use std::{
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::Path,
};

use wholestring_results::{Column, Data, NODES, ResultsError, Summary, Table};

/// A table with words and numbers, some missing.
fn table() -> Table {
    let empty = Table::with_columns(NODES);
    let columns = empty.columns().iter().take(4).map(|column| Column {
        data: match &column.data {
            Data::Text(_) => Data::Text((0..40).map(|row| format!("word {}", row % 3)).collect()),
            Data::Number(_) => Data::Number(
                (0..40).map(|row| (row % 7 != 3).then_some(f64::from(row) * 0.1)).collect(),
            ),
        },
        ..column.clone()
    });
    Table::new(columns.collect())
}

/// Reads a file as a whole and in pieces, which must not panic.
fn read(path: &Path) -> Result<Table, ResultsError> {
    let read = || {
        Table::read_parquet_pieces(path, &["md_m", "tension_N", "operation"], drop)?;
        Table::read_parquet(path)
    };
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| panic!("{}", path.display()))
}

#[track_caller]
fn refused(path: &Path) -> String {
    let error = read(path).unwrap_err().to_string();
    assert!(error.contains("is not a file of results: "), "{error}");
    assert!(error.contains(&path.display().to_string()), "{error}");
    for word in ["Parquet error", "External", "EOF", "thrift", "failed to"] {
        assert!(!error.contains(word), "{error}");
    }
    error
}

/// Files that caused `report` and `plot` to panic.
#[test]
fn files_that_made_the_reader_panic_are_refused() {
    for name in ["p4201.parquet", "p9353.parquet"] {
        refused(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name));
    }
}

/// Every byte of a file in turn is replaced by others, among them the largest that a number's first
/// byte can be.
#[test]
fn no_byte_of_a_table_makes_the_reader_panic() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("nodes.parquet");
    table().write_parquet(&path).unwrap();
    assert_eq!(read(&path).unwrap(), table());
    let valid = fs::read(&path).unwrap();
    let mut refused = 0;
    for place in 0..valid.len() {
        for byte in [valid[place] ^ 1 << (place % 8), 0xff] {
            let mut bytes = valid.clone();
            bytes[place] = byte;
            fs::write(&path, &bytes).unwrap();
            refused += usize::from(read(&path).is_err());
            if place % 16 == 0 && read(&path).is_err() {
                self::refused(&path);
            }
        }
        if place % 16 == 0 {
            fs::write(&path, &valid[..place]).unwrap();
            assert!(read(&path).is_err(), "cut at {place}");
        }
    }
    assert!(refused > valid.len() / 2, "{refused} of {}", valid.len());
}

/// Nested columns were followed until the stack overflowed.
#[test]
fn columns_within_columns_are_refused() {
    // A footer: version; a list of elements of which each has one child; then their names.
    let mut footer = vec![0x15, 2, 0x19, 0xfc];
    let count = 200_000_u32;
    for shift in (0..32).step_by(7).take(3) {
        let more = if shift < 14 { 0x80 } else { 0 };
        footer.push((count >> shift & 0x7f) as u8 | more);
    }
    for _ in 0..count {
        // 4: name of one letter, 5: one child.
        footer.extend([0x48, 1, b'a', 0x15, 2, 0]);
    }
    footer.extend([0x16, 0, 0x19, 0x0c, 0]);
    let mut file = b"PAR1".to_vec();
    file.extend(&footer);
    file.extend((footer.len() as u32).to_le_bytes());
    file.extend(b"PAR1");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("nodes.parquet");
    fs::write(&path, &file).unwrap();
    assert!(refused(&path).contains("a flat table was expected"));
}

/// Text that a spreadsheet would compute is written as text, and read back unchanged.
#[test]
fn formulas_in_csv_are_text() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sweep.csv");
    let words = ["=1+2", "-5 m", "@x", "'=y", "drill", "-5", "+1e3", ""];
    let table = Table::new(vec![Column::words("=key", words.map(str::to_owned).into())]);
    table.write_csv(&path).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    for line in text.lines() {
        let cell = line.trim_matches('"');
        let computed = cell.starts_with(['=', '+', '-', '@']);
        assert!(!computed || cell.parse::<f64>().is_ok(), "{line}");
    }
    assert_eq!(Table::read_csv(&path).unwrap(), table);
}

/// A table of comma-separated values with a line that was cut.
#[test]
fn a_cut_line_of_csv_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sweep.csv");
    for (text, reason) in [
        (&b"a,b,c\n1,2,3\n4,5\n"[..], "line 3 has 2 values, expected 3 as in its heading"),
        (b"a,b\n1,\xff\n", "line 2 is not UTF-8 text"),
    ] {
        fs::write(&path, text).unwrap();
        let error = Table::read_csv(&path).unwrap_err().to_string();
        assert_eq!(error, format!("{} is not a file of results: {reason}", path.display()));
    }
}

/// A number without a JSON form, in any part of a summary, is read back as none.
#[test]
fn infinities_in_a_summary_are_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("summary.json");
    let operation = r#"{"model": "dynamic", "operation": "drill", "status": "complete",
        "friction": 0.3, "bit_depth_m": 1.0, "weight_on_bit_N": 1.0, "bit_torque_N_m": 1.0,
        "hook_load_N": 1.0, "surface_torque_N_m": 1.0, "friction_torque_N_m": 1.0,
        "axial_friction_N": 1.0, "side_force_total_N": 1.0, "twist_rad": 1.0, "stretch_m": 1.0,
        "neutral_point_m": null, "cutoff_depth_m": null,
        "indicators": {"stick_slip": null, "backward_whirl": null, "forward_whirl": null,
                       "top_drive": {"p95": 1.0, "max": 2.0}}}"#;
    fs::write(
        &path,
        format!(
            r#"{{"schema_version": 1, "case": "x", "settings": {{}}, "operations": [{operation}]}}"#
        ),
    )
    .unwrap();
    let mut summary = Summary::read(&path).unwrap();
    let drive = summary.operations[0].indicators.as_mut().unwrap();
    let drive = drive.top_drive.as_mut().unwrap();
    // The torque over a rating of 1e-305 N.m.
    drive.p95 = 3e4 / 1e-305;
    assert!(drive.p95.is_infinite());
    summary.write(&path).unwrap();
    let back = Summary::read(&path).unwrap();
    let drive = back.operations[0].indicators.unwrap().top_drive.unwrap();
    assert!(drive.p95.is_nan() && drive.max == 2.0);
}
