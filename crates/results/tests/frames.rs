//! `frames.parquet`, read back.

mod common;

use std::fs;

use common::{NODES, frame};
use wholestring::dynamics::{Channel, Frame};
use wholestring_results::{FRAMES, FramesSoFar, ResultsFolder, Table};

fn numbers<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    table.numbers(name).expect(name)
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
    writer.write().unwrap();
    results.remove_checkpoint().unwrap();
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
        assert!(numbers(&table, "time_s")[rows.clone()].iter().all(|t| *t == Some(*time_s)));
        let node = |(i, node): (usize, &Option<f64>)| *node == Some(i as f64);
        assert!(numbers(&table, "node")[rows].iter().enumerate().all(node));
    }
    let words = table.words("operation").expect("words");
    assert_eq!((words[0].as_str(), words[100 * NODES].as_str()), ("drill", "slide"));
    assert_eq!(table.column("tension_N").unwrap().unit, "N");
}

#[test]
fn channels_that_nobody_asked_for_have_no_column() {
    let folder = tempfile::tempdir().unwrap();
    let results = ResultsFolder::create(folder.path()).unwrap();
    let mut writer = results.frames(&[Channel::Contact]).unwrap();
    writer.push("ream", &frame(0.1)).unwrap();
    writer.write().unwrap();
    let table = Table::read_parquet(&folder.path().join("frames.parquet")).unwrap();
    let names: Vec<&str> = table.columns().iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["operation", "time_s", "node", "md_m", "contact_force_N"]);
    // A run that ended before its first frame.
    let mut writer = results.frames(&Channel::USUAL).unwrap();
    writer.write().unwrap();
    let table = Table::read_parquet(&folder.path().join("frames.parquet")).unwrap();
    assert_eq!(table.rows(), 0);
}

const CHANNELS: [Channel; 2] = [Channel::Rotation, Channel::Contact];

/// Frame of that number; one in three has a number that is not finite.
fn numbered(number: u32) -> Frame {
    let mut frame = frame(f64::from(number) * 0.1);
    if number.is_multiple_of(3) {
        frame.contact_force_N[number as usize] = f64::NAN;
    }
    frame
}

/// Frames that continue from a checkpoint, whatever was written after it, are the same file to the
/// byte: the checkpoint before the first part, at its last frame and after it, within the second,
/// and twice the same; each time with all frames on the disk already, whole and in parts.
#[test]
fn frames_go_on_from_any_checkpoint() {
    // Two parts and a rest.
    let frames = 220;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("frames.parquet");
    let results = ResultsFolder::create(folder.path()).unwrap();
    let mut writer = results.frames(&CHANNELS).unwrap();
    let mut checkpoints = Vec::new();
    for number in 0..frames {
        checkpoints.push(writer.so_far().clone());
        writer.push("drill", &numbered(number)).unwrap();
    }
    writer.write().unwrap();
    let whole = fs::read(&path).unwrap();
    let parts = || fs::read_dir(folder.path().join("frames.parts")).unwrap().count();
    assert_eq!(parts(), 2);
    for from in [0, 97, 98, 99, 150, 150, 219] {
        // The state on the disk.
        results.write_checkpoint(&checkpoints[from]).unwrap();
        let so_far = results.read_checkpoint::<FramesSoFar>().unwrap().unwrap();
        let mut writer = results.resume_frames(&CHANNELS, so_far).unwrap();
        for number in from as u32..frames {
            writer.push("drill", &numbered(number)).unwrap();
            if number == 160 {
                // The files after Ctrl-C can be read, and reading does not change the end.
                writer.write().unwrap();
                let table = Table::read_parquet(&path).unwrap();
                assert_eq!(table.rows(), 161 * NODES);
            }
        }
        writer.write().unwrap();
        assert!(fs::read(&path).unwrap() == whole, "from frame {from}");
        assert_eq!(parts(), 2);
    }
    // A run that starts again uses none of it.
    results.frames(&CHANNELS).unwrap();
    assert!(!path.exists() && !folder.path().join("frames.parts").exists());
}

#[test]
fn frames_that_cannot_go_on_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let results = ResultsFolder::create(folder.path()).unwrap();
    let mut writer = results.frames(&CHANNELS).unwrap();
    for number in 0..100 {
        writer.push("drill", &numbered(number)).unwrap();
    }
    let so_far = writer.so_far().clone();
    let refused = |channels: &[Channel]| {
        let error = results.resume_frames(channels, so_far.clone()).err().unwrap();
        let place = format!("{}{}", folder.path().display(), std::path::MAIN_SEPARATOR);
        error.to_string().replace(&place, "").replace('\\', "/")
    };
    assert_eq!(
        refused(&Channel::USUAL),
        "checkpoint.bin is no checkpoint that can be resumed: its frames have other columns"
    );
    let part = folder.path().join("frames.parts/000001.parquet");
    fs::write(&part, "something else").unwrap();
    let message = refused(&CHANNELS);
    let begin = "frames.parts/000001.parquet is not a file of results: ";
    assert!(message.starts_with(begin), "{message}");
    fs::remove_file(&part).unwrap();
    assert_eq!(refused(&CHANNELS), "cannot read frames.parts/000001.parquet: it does not exist");
    let message = writer.write().unwrap_err().to_string();
    assert!(message.contains("frames.parquet: cannot read"), "{message}");
}
