//! A limit before a parser on the length of a token, and the current line.

use std::{
    io::{self, BufRead, Read},
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering::Relaxed},
    },
};

/// Amount of input taken by the parser, shared with its caller.
#[derive(Debug, Clone, Default)]
pub(crate) struct Taken {
    /// Bytes since the last token began.
    since: Arc<AtomicU64>,
    /// Number of line ends passed.
    lines: Arc<AtomicU64>,
}

impl Taken {
    /// Marks the end of a token.
    pub(crate) fn token(&self) {
        self.since.store(0, Relaxed);
    }

    /// The line, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.lines.load(Relaxed) + 1
    }
}

/// Limits the bytes of one token, because text without end would exhaust memory.
pub(crate) struct Capped<R> {
    inner: R,
    most: u64,
    taken: Taken,
}

impl<R> Capped<R> {
    pub(crate) fn new(inner: R, most: u64) -> (Self, Taken) {
        let taken = Taken::default();
        (Self { inner, most, taken: taken.clone() }, taken)
    }
}

impl<R: BufRead> Read for Capped<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let from = self.fill_buf()?;
        let count = from.len().min(into.len());
        into[..count].copy_from_slice(&from[..count]);
        self.consume(count);
        Ok(count)
    }
}

impl<R: BufRead> BufRead for Capped<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken.since.load(Relaxed) > self.most {
            let text = format!("a text or tag of more than {} MB", self.most >> 20);
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, text));
        }
        self.inner.fill_buf()
    }

    fn consume(&mut self, count: usize) {
        if let Ok(buffer) = self.inner.fill_buf() {
            let ends = buffer[..count.min(buffer.len())].iter().filter(|b| **b == b'\n').count();
            add(&self.taken.lines, ends);
        }
        add(&self.taken.since, count);
        self.inner.consume(count);
    }
}

/// Only one thread counts, so that no locked operation is needed.
fn add(to: &AtomicU64, count: usize) {
    to.store(to.load(Relaxed) + count as u64, Relaxed);
}
