//! Results of an operation against time.

use std::{collections::BTreeMap, ops::Range};

use serde::{Deserialize, Serialize};
use wholestring::operation::OperationKind;
use wholestring_results::{OperationTables, ResultsError, Table};

use super::{frames::Frames, history::History};
use crate::{
    BottomPicture, Packed, packed,
    plots::catalogue::{contact_columns, spectrum_dimension},
};

/// Largest number of times of a contact map in a page, all operations together.
const MAX_TIMES: usize = 450;

/// An operation in time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TimeRun {
    /// The operation.
    pub operation: OperationKind,
    /// Beginning of the statistics window, s.
    pub window_s: f64,
    /// Number of samples of the run.
    pub samples: usize,
    /// Columns of `time.parquet` by their name, thinned.
    pub history: BTreeMap<String, Packed>,
    /// Notes of the schedule, each with its time, s.
    pub notes: Vec<(f64, String)>,
    /// Contact over depth and time.
    pub contact: Option<ContactPicture>,
    /// The string at moments.
    pub frames: Option<Frames>,
    /// Response of the bit to its weight and speed, where it drills: columns of `time.parquet` by
    /// their name, of samples of the window that are evenly spaced in time.
    pub drill_off: Option<BTreeMap<String, Packed>>,
    /// The bottom of the hole at the end, where the bit is on solid rock.
    pub bottom: Option<BottomPicture>,
    /// Power spectral densities of the signals that the case requires.
    #[serde(default)]
    pub spectra: Vec<Spectrum>,
}

impl TimeRun {
    /// Reads an operation whose window begins at `window_s` and which shares the page with `many`,
    /// including itself.
    pub(super) fn read(
        operation: OperationKind,
        window_s: f64,
        tables: &OperationTables,
        many: usize,
    ) -> Result<Self, ResultsError> {
        let table = |name| tables.read(name, None, operation);
        let history = History::read(operation, window_s, tables, many)?;
        Ok(Self {
            operation,
            window_s,
            samples: history.samples,
            notes: history.notes.clone(),
            contact: ContactPicture::new(&table("contact")?, MAX_TIMES / many),
            frames: None,
            drill_off: history.drill_off(),
            bottom: BottomPicture::of_table(&table("bottom_hole")?),
            spectra: Spectrum::all(&table("spectra")?),
            history: history.columns(),
        })
    }
}

/// Contact over depth and time: row after row in time, each from the surface down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactPicture {
    /// Beginning of the first row, s.
    pub from_s: f64,
    /// End of each row, s.
    pub time_s: Packed,
    /// Measured depth of each stretch, m.
    pub md_m: Packed,
    /// Columns of `contact.parquet` that are drawn, by their name.
    pub values: BTreeMap<String, Packed>,
}

impl ContactPicture {
    /// The map of an operation with at most `most` times; `None` where there is no contact.
    fn new(table: &Table, most: usize) -> Option<Self> {
        let times = table.values("time_s");
        // Stretches at one time are consecutive.
        let stretches = times.iter().take_while(|time| **time == times[0]).count();
        let count = times.len().checked_div(stretches)?;
        // Adjacent times are merged if there are too many.
        let many = count.div_ceil(most.max(1));
        let groups: Vec<Range<usize>> =
            (0..count).step_by(many).map(|first| first..(first + many).min(count)).collect();
        let sum = |values: &[f64], times: Range<usize>, stretch: usize| -> f64 {
            times.map(|time| values[time * stretches + stretch]).sum()
        };
        let mean = |name: &str| -> Vec<f64> {
            let values = table.values(name);
            let of_group = |group: &Range<usize>| -> Vec<f64> {
                let mean = |at| sum(&values, group.clone(), at) / group.len() as f64;
                (0..stretches).map(mean).collect()
            };
            groups.iter().flat_map(of_group).collect()
        };
        let depths_m = table.values("md_m");
        let depths = (0..stretches).map(|at| sum(&depths_m, 0..count, at) / count as f64);
        Some(Self {
            from_s: 0.0,
            time_s: Packed::single(groups.iter().map(|group| times[(group.end - 1) * stretches])),
            md_m: Packed::single(depths),
            values: contact_columns()
                .map(|name| (name.to_owned(), Packed::short(&mean(name))))
                .into(),
        })
    }
}

/// A power spectral density.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spectrum {
    /// `surface_torque`, or for a node `tension`, ...
    pub signal: String,
    /// Measured depth of the node, m; `None` for a signal of the whole string.
    pub md_m: Option<f64>,
    /// Dimension of the signal, whose square per frequency is that of the density; empty where it
    /// has none.
    pub dimension: String,
    /// SI unit of the signal: `N`, `N·m`, ...
    #[serde(skip)]
    pub unit: String,
    /// Frequencies, Hz.
    #[serde(with = "packed::single")]
    pub frequency_Hz: Vec<f64>,
    /// Density at each, square of the signal's SI unit per Hz.
    #[serde(with = "packed::single")]
    pub density: Vec<f64>,
}

impl Spectrum {
    /// The densities of an operation; the rows of each are consecutive.
    fn all(table: &Table) -> Vec<Self> {
        let word = |name, row: usize| {
            table.words(name).and_then(|words| words.get(row)).cloned().unwrap_or_default()
        };
        let depths = table.numbers("md_m").unwrap_or_default();
        let [frequencies, densities] = ["frequency_Hz", "density"].map(|name| table.values(name));
        let mut all: Vec<Self> = Vec::new();
        for (row, (frequency_Hz, density)) in frequencies.into_iter().zip(densities).enumerate() {
            let signal = word("signal", row);
            let md_m = depths.get(row).copied().flatten();
            match all.last_mut().filter(|last| last.signal == signal && last.md_m == md_m) {
                Some(last) => {
                    last.frequency_Hz.push(frequency_Hz);
                    last.density.push(density);
                }
                None => all.push(Self {
                    dimension: spectrum_dimension(&signal, md_m.is_some())
                        .unwrap_or_default()
                        .into(),
                    signal,
                    md_m,
                    unit: word("unit", row),
                    frequency_Hz: vec![frequency_Hz],
                    density: vec![density],
                }),
            }
        }
        all
    }
}
