//! How long a log of a month takes: `cargo test --release -- --ignored a_log_of_ten_million_rows`.

use std::{io::Read, time::Instant};

use wholestring_import::{Choices, Input, log};

/// Rows that are made as they are read.
struct Made {
    row: u64,
    rows: u64,
    line: fn(u64) -> String,
    ready: Vec<u8>,
    at: usize,
}

impl Read for Made {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        if self.at == self.ready.len() {
            self.ready.clear();
            self.at = 0;
            while self.row < self.rows && self.ready.len() < 1 << 16 {
                self.ready.extend_from_slice((self.line)(self.row).as_bytes());
                self.row += 1;
            }
        }
        let count = into.len().min(self.ready.len() - self.at);
        into[..count].copy_from_slice(&self.ready[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

fn las(row: u64) -> String {
    let wave = (row % 977) as f64;
    format!(
        "{row}.0 {:.2} 12050.00 {:.2} {:.1} {:.1} {:.0} {} {:.0} {:.1} -999.25 {:.3}\n",
        12_030.0 - 0.01 * wave,
        0.1 * wave,
        250.0 + 0.03 * wave,
        12.0,
        11_250.0 + wave,
        row % 120,
        2450.0 + wave,
        610.0,
        0.001 * wave
    )
}

fn csv(row: u64) -> String {
    let (day, second) = (row / 86_400, row % 86_400);
    let (hour, minute, second) = (second / 3600, second / 60 % 60, second % 60);
    let (month, day) = (1 + day / 28 % 12, 1 + day % 28);
    format!(
        "2021/{month:02}/{day:02},{hour:02}:{minute:02}:{second:02},{}",
        las(row).replace(' ', ",")
    )
}

/// The rows and the seconds that they took, those of making the text apart.
fn time(head: &'static str, line: fn(u64) -> String, rows: u64) {
    let made = || Made { row: 0, rows, line, ready: Vec::new(), at: 0 };
    let start = Instant::now();
    let bytes = std::io::copy(&mut made(), &mut std::io::sink()).unwrap();
    let making_s = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let input = Input::new("made", head.as_bytes().chain(made()));
    let (mut count, mut sum_N) = (0, 0.0);
    for row in log(input, &Choices::default()).unwrap() {
        sum_N += row.unwrap().hook_load_N;
        count += 1;
    }
    let whole_s = start.elapsed().as_secs_f64();
    let reading_s = whole_s - making_s;
    println!(
        "{count} rows of {} MB in {reading_s:.1} s (and {making_s:.1} s to make them), mean hook load \
         {:.0} N",
        bytes >> 20,
        sum_N / f64::from(u32::try_from(count).unwrap())
    );
    assert!(reading_s < 60.0 * rows as f64 / 1e7);
}

/// The target is 60 s for reading and picking on one core; reading should leave most of it.
#[test]
#[ignore = "half a minute, and only of use when compiled for speed"]
fn a_log_of_ten_million_rows() {
    time(
        "~V\nVERS. 2.0:\nWRAP. NO:\n~W\nNULL. -999.25:\n~C\nTIME.s:\nDBTM.ft:\nDMEA.ft:\nBPOS.ft:\n\
         HKLA.klbs:\nWOBA.klbs:\nTQA.ft-lbs:\nRPMA.rpm:\nSPPA.psi:\nMFIA.gpm:\nGAS.%:\nDEXP.:\n~A\n",
        las,
        10_000_000,
    );
    time(
        "YYYY/MM/DD,HH:MM:SS,ETIM (s),DBTM (ft),DMEA (ft),BPOS (ft),HKLA (klbs),WOBA (klbs),\
         TQA (ft-lbs),RPMA (rpm),SPPA (psi),MFIA (gpm),GAS (%),DEXP\n",
        csv,
        10_000_000,
    );
    // The most that the process ever held, where the system tells.
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        println!("{}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or_default());
    }
}
