//! Counts of the outcomes of a reader's inputs, in a file that outlives the process that wrote it.

use std::{
    fs::File,
    io::{self, Read, Seek, SeekFrom, Write},
    time::Duration,
};

/// Number of numbers in a tally.
const NUMBERS: usize = 8;

/// Counts of outcomes of inputs.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Tally {
    /// The current input, or the one after the last.
    pub(crate) next: u64,
    pub(crate) accepted: u64,
    pub(crate) refused: u64,
    pub(crate) panicked: u64,
    pub(crate) slowest: Duration,
    pub(crate) slowest_input: u64,
    pub(crate) peak_bytes: u64,
    pub(crate) peak_input: u64,
}

impl Tally {
    pub(crate) fn inputs(&self) -> u64 {
        self.accepted + self.refused + self.panicked
    }

    /// Adds the counts of another process.
    pub(crate) fn join(&mut self, other: &Self) {
        self.next = other.next;
        self.accepted += other.accepted;
        self.refused += other.refused;
        self.panicked += other.panicked;
        if other.slowest > self.slowest {
            (self.slowest, self.slowest_input) = (other.slowest, other.slowest_input);
        }
        if other.peak_bytes > self.peak_bytes {
            (self.peak_bytes, self.peak_input) = (other.peak_bytes, other.peak_input);
        }
    }

    /// Writes it over the previous contents.
    pub(crate) fn write(&self, file: &mut File) -> io::Result<()> {
        let numbers: [u64; NUMBERS] = [
            self.next,
            self.accepted,
            self.refused,
            self.panicked,
            self.slowest.as_micros() as u64,
            self.slowest_input,
            self.peak_bytes,
            self.peak_input,
        ];
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&bytes)
    }

    /// Reads a written tally; an empty file gives zeros.
    pub(crate) fn read(file: &mut File) -> io::Result<Self> {
        let mut bytes = Vec::new();
        file.seek(SeekFrom::Start(0))?;
        file.read_to_end(&mut bytes)?;
        let mut numbers = [0; NUMBERS];
        for (number, eight) in numbers.iter_mut().zip(bytes.as_chunks::<8>().0) {
            *number = u64::from_le_bytes(*eight);
        }
        let [next, accepted, refused, panicked, slowest, slowest_input, peak_bytes, peak_input] =
            numbers;
        Ok(Self {
            next,
            accepted,
            refused,
            panicked,
            slowest: Duration::from_micros(slowest),
            slowest_input,
            peak_bytes,
            peak_input,
        })
    }
}
