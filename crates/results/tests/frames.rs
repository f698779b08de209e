//! `frames.parquet`, read back.

mod common;

use std::fs;

use common::{NODES, frame};
use wholestring::dynamics::Channel;
use wholestring_results::{Data, FRAMES, ResultsFolder, Table};

fn numbers<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    match &table
        .column(name)
        .unwrap_or_else(|| panic!("no `{name}`"))
        .data
    {
        Data::Number(values) => values,
        Data::Text(_) => panic!("`{name}` holds words"),
    }
}

#[test]
fn every_channel_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.parquet");
    fs::write(&path, "an earlier run's").unwrap();
    let results = ResultsFolder::create(folder.path()).unwrap();
    let mut writer = results.frames(&Channel::ALL).unwrap();
    assert!(!path.exists(), "an earlier run's frames are not this one's");
    // More than one row group.
    let times: Vec<f64> = (1..=120).map(|i| f64::from(i) * 0.1).collect();
    for time_s in &times {
        let mut frame = frame(*time_s);
        frame.torque_N_m[7] = f64::NAN;
        let operation = if *time_s < 5.0 { "drill" } else { "slide" };
        writer.push(operation, &frame).unwrap();
    }
    assert!(!path.exists(), "not before it is whole");
    writer.finish().unwrap();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);

    let table = Table::read_parquet(&path).unwrap();
    let names: Vec<&str> = table.columns().iter().map(|c| c.name.as_str()).collect();
    let expected: Vec<&str> = FRAMES.iter().map(|spec| spec.name).collect();
    assert_eq!(names, expected);
    assert_eq!(table.rows(), times.len() * NODES);
    for (index, time_s) in times.iter().enumerate() {
        let expected = frame(*time_s);
        let rows = index * NODES..(index + 1) * NODES;
        let channels = Channel::ALL.iter().flat_map(|c| expected.channel(*c));
        for (name, values) in channels.chain([("md_m", expected.md_m.as_slice())]) {
            let found = &numbers(&table, name)[rows.clone()];
            for (node, (found, value)) in found.iter().zip(values).enumerate() {
                let missing = name == "torque_N_m" && node == 7;
                let single = (!missing).then_some(f64::from(*value as f32));
                assert_eq!(*found, single, "{name} at {time_s} s, node {node}");
            }
        }
        assert!(
            numbers(&table, "time_s")[rows.clone()]
                .iter()
                .all(|t| *t == Some(*time_s))
        );
        let node = |(i, node): (usize, &Option<f64>)| *node == Some(i as f64);
        assert!(numbers(&table, "node")[rows].iter().enumerate().all(node));
    }
    let Data::Text(words) = &table.column("operation").unwrap().data else {
        panic!("words");
    };
    assert_eq!(
        (words[0].as_str(), words[100 * NODES].as_str()),
        ("drill", "slide")
    );
    assert_eq!(table.column("tension_N").unwrap().unit, "N");
}

#[test]
fn channels_that_nobody_asked_for_have_no_column() {
    let folder = tempfile::tempdir().unwrap();
    let results = ResultsFolder::create(folder.path()).unwrap();
    let mut writer = results.frames(&[Channel::Contact]).unwrap();
    writer.push("ream", &frame(0.1)).unwrap();
    writer.finish().unwrap();
    let table = Table::read_parquet(&folder.path().join("frames.parquet")).unwrap();
    let names: Vec<&str> = table.columns().iter().map(|c| c.name.as_str()).collect();
    assert_eq!(
        names,
        ["operation", "time_s", "node", "md_m", "contact_force_N"]
    );
    // A run that ended before its first frame.
    let writer = results.frames(&Channel::USUAL).unwrap();
    writer.finish().unwrap();
    let table = Table::read_parquet(&folder.path().join("frames.parquet")).unwrap();
    assert_eq!(table.rows(), 0);
}
