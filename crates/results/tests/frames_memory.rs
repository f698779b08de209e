//! Frames are written in memory that does not grow: measured on the whole process, so that nothing
//! else is tested here.
#![cfg(target_os = "linux")]

mod common;

use std::fs;

use common::{NODES, frame};
use wholestring::dynamics::Channel;
use wholestring_results::ResultsFolder;

/// Largest resident memory of this process so far, MB.
fn peak_MB() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).unwrap();
    let kB: f64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
    kB / 1024.0
}

/// Writes so many frames of every channel.
fn write(frames: u32) {
    let folder = tempfile::tempdir().unwrap();
    let results = ResultsFolder::create(folder.path()).unwrap();
    let mut writer = results.frames(&Channel::ALL).unwrap();
    let mut frame = frame(0.0);
    for index in 0..frames {
        frame.time_s = f64::from(index) * 0.1;
        frame.tension_N[index as usize % NODES] += 1.0;
        writer.push("drill", &frame).unwrap();
        if index % 90 == 0 {
            results.write_checkpoint(writer.so_far()).unwrap();
        }
    }
    writer.write().unwrap();
}

/// Memory does not grow with the run: after the first row groups, three times as many frames take
/// less than 10 MB more. A frame is 113 kB as it is held, 400 of them 45 MB.
#[test]
fn memory_does_not_grow_with_the_frames() {
    write(200);
    let before = peak_MB();
    write(600);
    let grown = peak_MB() - before;
    assert!(grown < 10.0, "{grown} MB");
}

/// 10 000 frames of 1350 nodes and all columns.
#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn ten_thousand_frames_take_less_than_200_MB() {
    write(10_000);
    let peak = peak_MB();
    assert!(peak < 200.0, "{peak} MB");
}
