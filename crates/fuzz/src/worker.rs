//! The reading process: it may end at any input, and its counts remain.

use std::{
    fs::{self, OpenOptions},
    path::Path,
    time::{Duration, Instant},
};

use fastrand::Rng;
use wholestring_contain::contain;

use crate::{allocator, readers::Reader, tally::Tally};

/// Time limit of an input; processor time if the system reports it.
pub(crate) const LONGEST: Duration = Duration::from_secs(2);

/// Beginning of a line that reports a fault; the input's number and a sentence follow.
pub(crate) const FAULT: &str = "fault ";

/// Range of inputs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Inputs {
    pub(crate) seed: u64,
    pub(crate) from: u64,
    /// Maximum number of inputs.
    pub(crate) count: u64,
    /// Maximum time.
    pub(crate) time: Duration,
}

/// The input of a number: the same on every machine.
pub(crate) fn input(reader: &Reader, seed: u64, number: u64) -> Vec<u8> {
    let name = reader.name.bytes().fold(0xcbf2_9ce4_8422_2325, |sum: u64, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    let mut rng = Rng::with_seed(seed ^ name ^ number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    reader.input(&mut rng)
}

/// Processor time of this process, to a hundredth of a second, if the system reports it.
fn processor_time() -> Option<Duration> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    // After the program's name: the state, and ten numbers before these two.
    let mut ticks = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
    let mut next = || ticks.next()?.parse::<u64>().ok();
    Some(Duration::from_millis(10 * (next()? + next()?)))
}

/// Reads the inputs; reports panics, and inputs that exceed the time limit, on standard output, one
/// line each.
pub(crate) fn work(reader: &mut Reader, inputs: Inputs, counted: &Path) -> std::io::Result<()> {
    let mut file = OpenOptions::new().write(true).create(true).truncate(false).open(counted)?;
    let mut tally = Tally { next: inputs.from, ..Tally::default() };
    let begin = Instant::now();
    for number in inputs.from..inputs.from.saturating_add(inputs.count) {
        if begin.elapsed() > inputs.time {
            break;
        }
        let bytes = input(reader, inputs.seed, number);
        tally.next = number;
        tally.write(&mut file)?;
        allocator::forget_peak();
        let start = Instant::now();
        match contain(|| reader.read(&bytes)) {
            Ok(true) => tally.accepted += 1,
            Ok(false) => tally.refused += 1,
            Err(panicked) => {
                tally.panicked += 1;
                let message = panicked.0.lines().next().unwrap_or_default().to_owned();
                println!("{FAULT}{number} panics: {message}");
            }
        }
        let (mut took, peak) = (start.elapsed(), allocator::peak() as u64);
        if took > LONGEST {
            // Other load of the machine at the time is not counted.
            let (again, before) = (Instant::now(), processor_time());
            drop(contain(|| reader.read(&bytes)));
            let used = processor_time().zip(before).map(|(after, before)| after - before);
            took = took.min(used.unwrap_or_else(|| again.elapsed()));
        }
        if took > LONGEST {
            println!("{FAULT}{number} takes {:.1} s", took.as_secs_f64());
        }
        if took > tally.slowest {
            (tally.slowest, tally.slowest_input) = (took, number);
        }
        if peak > tally.peak_bytes {
            (tally.peak_bytes, tally.peak_input) = (peak, number);
        }
        tally.next = number + 1;
    }
    tally.write(&mut file)
}

/// Writes an input to the folder of the requested ones, and reads it alone, without protection.
pub(crate) fn one(
    reader: &mut Reader,
    seed: u64,
    number: u64,
    folder: &Path,
) -> std::io::Result<()> {
    let bytes = input(reader, seed, number);
    fs::create_dir_all(folder)?;
    let path = folder.join(format!("{}-{seed}-{number}", reader.name));
    fs::write(&path, &bytes)?;
    println!("{} bytes in {}", bytes.len(), path.display());
    allocator::forget_peak();
    let start = Instant::now();
    let accepted = reader.read(&bytes);
    println!(
        "{} in {:.3} s, {} MB",
        if accepted { "accepted" } else { "refused" },
        start.elapsed().as_secs_f64(),
        allocator::peak() >> 20
    );
    Ok(())
}
