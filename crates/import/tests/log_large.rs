//! A log of a third of a year at one row per second: import time and memory.
//!
//! `cargo test --release -p wholestring-import --test log_large -- --ignored --nocapture` prints both.

#[allow(dead_code, reason = "other tests have more of it")]
mod rig_log;

use std::{
    fmt::Write,
    io::{self, Read},
    sync::Arc,
    time::Instant,
};

use rig_log::{Manner, Rig, TRUTH};
use wholestring_import::{Choices, Input, import};

const ROWS: usize = 10_000_000;

/// Limits: import time on one core, and memory.
const LONGEST_S: f64 = 60.0;
const MOST_MB: f64 = 1000.0;

/// Channels from which no weight is picked, as every recorder writes some.
const OTHERS: &str = "2450.00 610.0 0.012 -999.25";

/// One day of a rig, written repeatedly, and a format's function that writes a row.
struct Made {
    day: Arc<Vec<String>>,
    lasts_s: f64,
    head: &'static str,
    row: fn(&mut String, f64, &str),
    end: &'static str,
    next: usize,
    ready: String,
    at: usize,
}

impl Made {
    fn fill(&mut self) {
        self.ready.clear();
        self.at = 0;
        if self.next == 0 {
            self.ready.push_str(self.head);
        }
        while self.next < ROWS && self.ready.len() < 1 << 16 {
            let (days, row) = (self.next / self.day.len(), self.next % self.day.len());
            let time_s = self.lasts_s * days as f64 + row as f64;
            (self.row)(&mut self.ready, time_s, &self.day[row]);
            self.next += 1;
        }
        if self.next == ROWS {
            self.ready.push_str(std::mem::take(&mut self.end));
        }
    }
}

impl Read for Made {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.at == self.ready.len() {
            self.fill();
        }
        let count = into.len().min(self.ready.len() - self.at);
        into[..count].copy_from_slice(&self.ready.as_bytes()[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

const LAS: &str = "~V\nVERS. 2.0:\nWRAP. NO:\n~W\nNULL. -999.25:\n~C\nTIME.s:\nDBTM.m:\nDMEA.m:\nBPOS.m:\n\
                   HKLA.kN:\nTQA.kN.m:\nRPMA.rpm:\nSPPA.kPa:\nMFIA.L/min:\nGAS.%:\nDEXP.:\n~A\n";

fn las_row(into: &mut String, time_s: f64, values: &str) {
    let _ = writeln!(into, "{time_s} {values} {OTHERS}");
}

const WITSML: &str = "<logs xmlns=\"http://www.witsml.org/schemas/1series\" version=\"1.4.1.1\"><log uid=\"1\">\
    <nameWell>W</nameWell><name>L</name><indexType>date time</indexType><indexCurve>TIME</indexCurve>\
    <nullValue>-999.25</nullValue>\
    <logCurveInfo uid=\"TIME\"><mnemonic>TIME</mnemonic><unit>s</unit></logCurveInfo>\
    <logCurveInfo uid=\"DBTM\"><mnemonic>DBTM</mnemonic><unit>m</unit></logCurveInfo>\
    <logCurveInfo uid=\"DMEA\"><mnemonic>DMEA</mnemonic><unit>m</unit></logCurveInfo>\
    <logCurveInfo uid=\"BPOS\"><mnemonic>BPOS</mnemonic><unit>m</unit></logCurveInfo>\
    <logCurveInfo uid=\"HKLA\"><mnemonic>HKLA</mnemonic><unit>kN</unit></logCurveInfo>\
    <logCurveInfo uid=\"TQA\"><mnemonic>TQA</mnemonic><unit>kN.m</unit></logCurveInfo>\
    <logCurveInfo uid=\"RPMA\"><mnemonic>RPMA</mnemonic><unit>rpm</unit></logCurveInfo>\
    <logCurveInfo uid=\"SPPA\"><mnemonic>SPPA</mnemonic><unit>kPa</unit></logCurveInfo>\
    <logCurveInfo uid=\"MFIA\"><mnemonic>MFIA</mnemonic><unit>L/min</unit></logCurveInfo>\
    <logCurveInfo uid=\"GAS\"><mnemonic>GAS</mnemonic><unit>%</unit></logCurveInfo>\
    <logCurveInfo uid=\"DEXP\"><mnemonic>DEXP</mnemonic><unit>Euc</unit></logCurveInfo><logData>\
    <mnemonicList>TIME,DBTM,DMEA,BPOS,HKLA,TQA,RPMA,SPPA,MFIA,GAS,DEXP</mnemonicList>\
    <unitList>s,m,m,m,kN,kN.m,rpm,kPa,L/min,%,Euc</unitList>\n";

/// Date and time of day. Months have 28 days, so that time always increases.
fn clock(time_s: f64) -> ([u64; 2], [u64; 3]) {
    let seconds = time_s as u64;
    let (days, second) = (seconds / 86_400, seconds % 86_400);
    ([1 + days / 28, 1 + days % 28], [second / 3600, second / 60 % 60, second % 60])
}

/// The values of a row with commas between them.
fn with_commas(into: &mut String, values: &str) {
    into.extend(values.chars().chain(" ".chars()).chain(OTHERS.chars()).map(|c| match c {
        ' ' => ',',
        other => other,
    }));
}

fn witsml_row(into: &mut String, time_s: f64, values: &str) {
    let ([month, day], [hour, minute, second]) = clock(time_s);
    let _ = write!(into, "<data>2021-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z,");
    with_commas(into, values);
    into.push_str("</data>\n");
}

const CSV: &str = "YYYY/MM/DD,HH:MM:SS,DBTM (m),DMEA (m),BPOS (m),HKLA (kN),TQA (kN.m),RPMA (rpm),SPPA (kPa),\
                   MFIA (L/min),GAS (%),DEXP\n";

fn csv_row(into: &mut String, time_s: f64, values: &str) {
    let ([month, day], [hour, minute, second]) = clock(time_s);
    let _ = write!(into, "2021/{month:02}/{day:02},{hour:02}:{minute:02}:{second:02},");
    with_commas(into, values);
    into.push('\n');
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
fn ten_million_rows_are_imported() {
    let mut rig =
        Rig::new(Manner { faults: Some(400), ..Manner::default() }, TRUTH, 3000.0, 3000.0);
    rig.trips_out(6);
    rig.trips_in(6);
    rig.drills_a_stand();
    rig.drills_a_stand();
    let text = rig.las();
    let rows = text.split_once("~A\n").expect("rows").1.lines();
    // Rows without their time.
    let day: Vec<String> =
        rows.map(|row| row.split_once(' ').expect("a time").1.to_owned()).collect();
    let (stands, lasts_s) = (14, day.len() as f64);
    let day = Arc::new(day);
    let choices = || Choices::default().value("block-weight", "245 kN");
    type Format = (&'static str, &'static str, fn(&mut String, f64, &str), &'static str);
    let formats: [Format; 3] = [
        ("LAS", LAS, las_row, ""),
        ("CSV", CSV, csv_row, ""),
        ("WITSML 1.4.1.1", WITSML, witsml_row, "</logData></log></logs>"),
    ];
    for (name, head, row, end) in formats {
        let made = || Made {
            day: Arc::clone(&day),
            lasts_s,
            head,
            row,
            end,
            next: 0,
            ready: String::new(),
            at: 0,
        };
        let start = Instant::now();
        let bytes = io::copy(&mut made(), &mut io::sink()).expect("made");
        let making_s = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let imported = import(vec![Input::new("large", made())], &choices()).expect("a case");
        let whole_s = start.elapsed().as_secs_f64();
        let windows = imported.picks[0].windows.len();
        let peak_mb = peak_mb();
        println!(
            "{name}: {ROWS} rows of {} MB in {:.1} s (and {making_s:.1} s to make them), {windows} windows, \
             {peak_mb:?} MB at most",
            bytes >> 20,
            whole_s - making_s
        );
        // Each day gives a weight or a torque of nearly every stand.
        let days = ROWS as f64 / lasts_s;
        assert!(windows as f64 > 0.8 * f64::from(stands) * days, "{windows} of {days} days");
        if let Some(peak_mb) = peak_mb {
            assert!(peak_mb <= MOST_MB, "{peak_mb} MB");
        }
        if !cfg!(debug_assertions) {
            assert!(whole_s - making_s <= LONGEST_S, "{} s", whole_s - making_s);
        }
    }
}
