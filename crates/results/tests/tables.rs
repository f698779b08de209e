//! Tables written and read back, and the view of CSV readers.

use std::fs;

use wholestring_results::{Column, Data, NODES, ResultsError, ResultsFolder, TIME, Table};

fn column(name: &str, unit: &str, data: Data) -> Column {
    Column {
        name: name.into(),
        unit: unit.into(),
        meaning: format!("Meaning of {name}, in m³"),
        data,
    }
}

#[test]
fn parquet_gives_back_every_bit() {
    // More rows than one page or dictionary has, so that the reader must join pages.
    let numbers: Vec<Option<f64>> = (0..300_000_u64)
        .map(|row| match row % 7 {
            0 => None,
            1 => Some(-0.0),
            2 => Some(f64::MIN_POSITIVE / 8.0),
            3 => Some(f64::MAX),
            _ => Some((row as f64).sqrt() * 1e-7),
        })
        .collect();
    let words =
        (0..300_000).map(|row| ["soft", "", "Ölfeld, \"N\"\n"][row % 3].to_owned()).collect();
    let table = Table::new(vec![
        column("word", "", Data::Text(words)),
        column("x_m3", "m³", Data::Number(numbers)),
    ]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.parquet");
    table.write_parquet(&path).unwrap();
    let back = Table::read_parquet(&path).unwrap();
    assert_eq!(back, table);
    let (Data::Number(back), Data::Number(table)) =
        (&back.columns()[1].data, &table.columns()[1].data)
    else {
        panic!("both are numbers");
    };
    assert!(back.iter().zip(table).all(|(a, b)| a.map(f64::to_bits) == b.map(f64::to_bits)));
}

#[test]
fn what_is_not_finite_becomes_null() {
    let values =
        vec![Some(f64::NAN), Some(1.5), Some(f64::INFINITY), None, Some(f64::NEG_INFINITY)];
    let table = Table::new(vec![column("x_m", "m", Data::Number(values))]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.parquet");
    table.write_parquet(&path).unwrap();
    let back = Table::read_parquet(&path).unwrap();
    assert_eq!(back.columns()[0].data, Data::Number(vec![None, Some(1.5), None, None, None]));
    let path = folder.path().join("t.csv");
    table.write_csv(&path).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "x_m\n\"\"\n1.5\n\"\"\n\"\"\n\"\"\n");
}

#[test]
fn csv_numbers_are_exact() {
    let values = [0.1 + 0.2, 1e300, 5e-324, -1234567.890625, 1e21];
    let table = Table::new(vec![
        column("word", "", Data::Text(vec!["a,b".into(); values.len()])),
        column("x_m", "m", Data::Number(values.map(Some).to_vec())),
    ]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.csv");
    table.write_csv(&path).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("word,x_m"));
    for (line, value) in lines.zip(values) {
        let number = line.strip_prefix("\"a,b\",").unwrap();
        assert_eq!(number.parse::<f64>().unwrap().to_bits(), value.to_bits());
    }
}

#[test]
fn appended_rows_leave_the_other_columns_null() {
    let mut table = Table::with_columns(NODES);
    table.append(
        &[
            ("model", &["soft"]),
            ("operation", &["drill"]),
            ("contact_class", &["none", "continuous"]),
            ("contact_side", &["none", "low"]),
            ("element_size", &[""]),
            ("buckling", &["none"]),
        ],
        &[("md_m", &[0.0, 10.0]), ("tension_N", &[1e6, f64::NAN])],
    );
    table.append(
        &[
            ("model", &["dynamic"]),
            ("operation", &["drill"]),
            ("contact_class", &["intermittent"]),
            ("contact_side", &["high"]),
            ("element_size", &["given"]),
            ("buckling", &["helical"]),
        ],
        &[("md_m", &[0.0]), ("contact_force_std_N", &[3.0])],
    );
    assert_eq!(table.rows(), 3);
    let number = |name| table.numbers(name).expect(name);
    assert_eq!(number("tension_N"), [Some(1e6), None, None]);
    assert_eq!(number("contact_force_std_N"), [None, None, Some(3.0)]);
    assert_eq!(number("twist_rad"), [None; 3]);
    let words = |name| table.words(name).expect(name);
    assert_eq!(words("operation"), ["drill"; 3]);
    assert_eq!(words("contact_side"), ["none", "low", "high"]);
}

#[test]
#[should_panic(expected = "the table has no `md_ft`")]
fn a_name_outside_the_registry_is_refused() {
    Table::with_columns(NODES)
        .append(&[("model", &["soft"]), ("operation", &["drill"])], &[("md_ft", &[0.0])]);
}

#[test]
fn a_table_without_rows_keeps_its_columns() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("time.parquet");
    Table::with_columns(TIME).write_parquet(&path).unwrap();
    let back = Table::read_parquet(&path).unwrap();
    assert_eq!(back, Table::with_columns(TIME));
}

#[test]
fn what_is_not_ours_is_refused_with_its_path() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.parquet");
    let missing = Table::read_parquet(&path).unwrap_err();
    assert_eq!(missing.to_string(), format!("cannot read {}: it does not exist", path.display()));
    for bytes in [&b""[..], b"PAR1", b"PAR1 and then no Parquet at all, but long enough PAR1"] {
        fs::write(&path, bytes).unwrap();
        let error = Table::read_parquet(&path).unwrap_err();
        assert!(matches!(error, ResultsError::Format { .. }), "{error}");
        assert!(error.to_string().contains("t.parquet"), "{error}");
    }
}

#[test]
fn a_file_in_the_place_of_the_folder_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out");
    fs::write(&path, "").unwrap();
    for path in [path.clone(), path.join("case")] {
        let error = ResultsFolder::create(&path).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("cannot make the folder {}: a file has the name of the folder", path.display())
        );
    }
}

#[test]
fn a_folder_in_the_place_of_a_file_is_named() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("nodes.parquet")).unwrap();
    let results = ResultsFolder::create(folder.path()).unwrap();
    let error = results.write_table("nodes", &Table::with_columns(NODES), false).unwrap_err();
    assert!(matches!(error, ResultsError::Write { .. }));
    assert!(error.to_string().contains("nodes.parquet"), "{error}");
    // Neither the probe nor the attempt leaves a file.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_folder_never_mixes_two_runs() {
    let folder = tempfile::tempdir().unwrap();
    let results = ResultsFolder::create(folder.path().join("out/case")).unwrap();
    let table = Table::with_columns(TIME);
    let names = || {
        let mut names: Vec<_> = fs::read_dir(results.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    };
    results.write_table("time", &table, true).unwrap();
    assert_eq!(names(), ["time.csv", "time.parquet"]);
    results.write_table("time", &table, false).unwrap();
    assert_eq!(names(), ["time.parquet"]);
}
