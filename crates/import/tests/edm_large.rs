//! A large export: import time and memory.
//!
//! `cargo test --release -p wholestring-import --test edm_large -- --ignored --nocapture` prints both.

use std::{
    io::{self, Read, Write},
    time::Instant,
};

use wholestring_import::{Choices, Input, import};

/// As large as the largest public export.
const BYTES: usize = 200 << 20;

/// Tables that are not read: rows of forty numbers.
const OTHER: [&str; 4] = ["TU_LOAD_PROFILE", "CD_PORE_PRESSURE", "WP_HYD_RESULT", "CD_FORMATION"];

/// An export generated on reading: a whole well at its end, and before it rows of other tables,
/// with stations of other paths at a fixed interval. Stations are kept until the file ends.
struct Made {
    row: Vec<u8>,
    at: usize,
    returned: usize,
    rows: usize,
    /// Interval of rows that are stations.
    every: usize,
    end: &'static [u8],
}

impl Made {
    fn next(&mut self) -> io::Result<()> {
        self.row.clear();
        self.at = 0;
        if self.returned >= BYTES {
            self.row.extend_from_slice(self.end);
            self.end = b"";
            return Ok(());
        }
        let n = self.rows;
        self.rows += 1;
        if n.is_multiple_of(self.every) {
            let header = n / (100 * self.every);
            writeln!(
                self.row,
                "<CD_DEFINITIVE_SURVEY_STATION well_id=\"W{header}\" wellbore_id=\"B{header}\" \
                 def_survey_header_id=\"H\" md=\"{n}.5\" inclination=\"12.5\" azimuth=\"145.25\" \
                 sequence_no=\"{n}\" tvd=\"1000\" covariance_xx=\"0.123456\" ellipse_east=\"1.5\"/>"
            )?;
            return Ok(());
        }
        write!(self.row, "<{} well_id=\"W1\"", OTHER[n % OTHER.len()])?;
        for column in 0..40 {
            write!(self.row, " value_number_{column}=\"{}.{n}\"", n % 977 + column)?;
        }
        self.row.extend_from_slice(b"/>\n");
        Ok(())
    }
}

impl Read for Made {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.at == self.row.len() {
            self.next()?;
        }
        let count = into.len().min(self.row.len() - self.at);
        into[..count].copy_from_slice(&self.row[self.at..self.at + count]);
        self.at += count;
        self.returned += count;
        Ok(count)
    }
}

/// Peak memory of the program, MB, if the system reports it.
fn peak_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes / 1024.0)
}

#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn two_hundred_megabytes() {
    let well = include_str!("samples/own/edm-well.xml");
    let body = well.split_once("<TOPLEVEL>").expect("rows").1;
    // A tenth of the bytes in stations, as in large exports; and stations only.
    for every in [3, 1] {
        let made = Made {
            row: b"<export><TOPLEVEL>".to_vec(),
            at: 0,
            returned: 0,
            rows: 0,
            every,
            end: body.as_bytes(),
        };
        let choices = Choices::default()
            .unit("edm", "api")
            .pick("case", "8 1/2 in drilling")
            .pick("wellbore", "WS-1");
        let before_mb = peak_mb();
        let start = Instant::now();
        let imported = import(vec![Input::new("large.xml", made)], &choices).expect("imported");
        let (seconds, after_mb) = (start.elapsed().as_secs_f64(), peak_mb());
        println!(
            "200 MB, one row in {every} a station, in {seconds:.1} s; memory {before_mb:?} MB before, \
             {after_mb:?} MB at most"
        );
        assert!(imported.missing.is_empty(), "{:?}", imported.missing);
        if let Some(after_mb) = after_mb {
            assert!(after_mb <= 200.0, "{after_mb} MB");
        }
        if !cfg!(debug_assertions) {
            assert!(seconds <= 20.0, "{seconds} s");
        }
    }
}
