//! The watching process: it starts a reading process, and reports how that ended.

use std::{
    env,
    fs::{self, File},
    io::{self, Read},
    path::Path,
    process::{Child, Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use crate::{
    tally::Tally,
    worker::{FAULT, Inputs, LONGEST},
};

/// Multiple of [`LONGEST`] after which a reading process is ended: next to other programs an input
/// takes many times as long as alone, and a slow one is read twice.
const GIVEN_UP: u32 = 30;

/// Interval at which a reading process is checked.
const POLL_INTERVAL: Duration = Duration::from_millis(50);

/// An input on which a reader failed.
pub(crate) struct Fault {
    pub(crate) reader: &'static str,
    pub(crate) input: u64,
    pub(crate) what: String,
}

/// Result of a reader.
pub(crate) struct Outcome {
    pub(crate) tally: Tally,
    pub(crate) faults: Vec<Fault>,
}

/// Runs a reader on its inputs in separate processes: one that ends early is followed by another,
/// from the next input on.
pub(crate) fn run(reader: &'static str, inputs: Inputs, folder: &Path) -> io::Result<Outcome> {
    let begin = Instant::now();
    let mut outcome = Outcome { tally: Tally::default(), faults: Vec::new() };
    let end = inputs.from.saturating_add(inputs.count);
    let mut from = inputs.from;
    loop {
        let left = inputs.time.saturating_sub(begin.elapsed());
        if from >= end || left.is_zero() {
            return Ok(outcome);
        }
        let counted = folder.join(format!("{reader}-{from}"));
        let part = Inputs { from, count: end - from, time: left, ..inputs };
        let (ended, faults) = one_process(reader, part, &counted)?;
        let mut tally = match File::open(&counted) {
            Ok(mut file) => Tally::read(&mut file)?,
            Err(_) => Tally::default(),
        };
        fs::remove_file(&counted).ok();
        outcome.faults.extend(faults);
        match ended {
            None => {
                outcome.tally.join(&tally);
                return Ok(outcome);
            }
            Some(what) => {
                let input = tally.next.max(from);
                outcome.faults.push(Fault { reader, input, what });
                tally.next = input + 1;
                tally.panicked += 1;
                outcome.tally.join(&tally);
                from = input + 1;
            }
        }
        // A reader that fails on every input is not restarted a million times.
        if outcome.faults.len() > 100 {
            return Ok(outcome);
        }
    }
}

/// Runs one process to its end; returns its failure, if any, and the faults that it reported.
fn one_process(
    reader: &'static str,
    inputs: Inputs,
    counted: &Path,
) -> io::Result<(Option<String>, Vec<Fault>)> {
    let mut child = Command::new(env::current_exe()?)
        .arg("--worker")
        .arg(reader)
        .args([inputs.seed, inputs.from, inputs.count].map(|number| number.to_string()))
        .arg(inputs.time.as_millis().to_string())
        .arg(counted)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let drained = [drain(child.stdout.take()), drain(child.stderr.take())];
    let [Ok(output), Ok(erred)] = drained else {
        child.kill()?;
        child.wait()?;
        return Err(io::Error::other("the system refuses a thread"));
    };
    let ended = wait(&mut child, counted)?;
    let output = output.join().unwrap_or_default();
    let erred = erred.join().unwrap_or_default();
    let faults = output
        .lines()
        .filter_map(|line| {
            let (number, what) = line.strip_prefix(FAULT)?.split_once(' ')?;
            Some(Fault { reader, input: number.parse().ok()?, what: what.to_owned() })
        })
        .collect();
    let ended = ended.map(|how| match erred.trim().lines().next_back() {
        Some(last) if !last.is_empty() => format!("{how}: {last}"),
        _ => how,
    });
    Ok((ended, faults))
}

/// Reads a pipe to its end in a thread of its own.
fn drain(pipe: Option<impl Read + Send + 'static>) -> io::Result<thread::JoinHandle<String>> {
    thread::Builder::new().spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            pipe.read_to_end(&mut bytes).ok();
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// Waits for a process; returns the reason if it ended early. One that exceeds the time limit at an
/// input is ended.
fn wait(child: &mut Child, counted: &Path) -> io::Result<Option<String>> {
    let (mut at, mut since) = (u64::MAX, Instant::now());
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok((!status.success()).then(|| format!("ends the program ({status})")));
        }
        thread::sleep(POLL_INTERVAL);
        let next = File::open(counted)
            .and_then(|mut file| Tally::read(&mut file))
            .map_or(u64::MAX, |tally| tally.next);
        if next != at {
            (at, since) = (next, Instant::now());
        } else if since.elapsed() > GIVEN_UP * LONGEST {
            child.kill()?;
            child.wait()?;
            return Ok(Some(format!("takes longer than {} s", (GIVEN_UP * LONGEST).as_secs())));
        }
    }
}
