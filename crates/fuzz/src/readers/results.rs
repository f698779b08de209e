//! Results of a run: summaries, tables in Parquet and CSV.

use std::{fs, path::PathBuf};

use tempfile::TempDir;
use wholestring::dynamics::{Channel, Frame};
use wholestring_results::{
    BhaSummary, BitTestSummary, CONTACT, Column, ColumnSpec, Data, NODES, ResultsError,
    ResultsFolder, Summary, TIME, Table, WEAR,
};

use super::reader::{New, Reader};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] =
    &[("summary", summary), ("parquet", parquet), ("sweep-csv", csv)];

/// A file to which inputs are written, because these readers read files.
pub(super) struct Scratch {
    folder: TempDir,
    name: &'static str,
}

impl Scratch {
    pub(super) fn new(name: &'static str) -> Self {
        let folder = tempfile::tempdir().expect("a folder for inputs");
        Self { folder, name }
    }

    pub(super) fn folder(&self) -> ResultsFolder {
        ResultsFolder::create(self.folder.path()).expect("a folder for inputs")
    }

    /// Writes an input; returns its path.
    pub(super) fn put(&self, input: &[u8]) -> PathBuf {
        let path = self.folder.path().join(self.name);
        fs::write(&path, input).expect("the input is written");
        path
    }
}

/// Whether reading succeeded; an error must name its file.
fn explained<T>(read: Result<T, ResultsError>, name: &str) -> bool {
    match read {
        Ok(_) => true,
        Err(error) => {
            assert!(error.to_string().contains(name), "{error}");
            false
        }
    }
}

const SUMMARY: &str = r#"{
  "schema_version": 1, "case": "Slant", "settings": {"units": "si", "well": {"stations": [[0.0, 0.0, 0.0]]}},
  "operations": [
    {"model": "soft", "operation": "drill", "status": "complete", "friction": 0.3, "bit_depth_m": 1500.0,
     "findings": [{"kind": "lock_up", "level": "error", "md_m": 1.0, "value": 2.0, "limit": null, "message": "x"}],
     "weight_on_bit_N": 1.0, "bit_torque_N_m": 2.0, "hook_load_N": null, "surface_torque_N_m": 3.0, "friction_torque_N_m": 4.0,
     "axial_friction_N": 5.0, "side_force_total_N": 6.0, "twist_rad": 7.0, "stretch_m": 8.0, "neutral_point_m": null,
     "cutoff_depth_m": 9.0},
    {"model": "dynamic", "operation": "slide", "status": "failed", "message": "it diverged", "friction": [0.2, 0.3],
     "bit_depth_m": 1500.0, "weight_on_bit_N": 1.0, "bit_torque_N_m": 2.0, "hook_load_N": 3.0, "surface_torque_N_m": 3.0,
     "friction_torque_N_m": 4.0, "axial_friction_N": 5.0, "side_force_total_N": 6.0, "twist_rad": 7.0, "stretch_m": 8.0,
     "neutral_point_m": 1.0, "cutoff_depth_m": null, "lift": {"hook_load_N": 1.0, "weight_on_bit_N": 2.0, "runs": 5},
     "indicators": {"stick_slip": {"severity": 1.0, "bit_speed_max_rad_per_s": 20.0, "torque_severity": null, "period_s": 2.0, "stuck_fraction": 0.0},
       "backward_whirl": null, "forward_whirl": null, "top_drive": {"p95": 0.5, "max": 0.7}}}
  ]
}"#;

/// `summary.json`, and its equivalents of a bit test or an assembly.
fn summary() -> Reader {
    let scratch = Scratch::new("summary.json");
    let words = r#"
        null true { } [ ] , : " "complete" "failed" "soft" "stiff" "statistics" "numerics" "lift"
        "schema_version" 1e999 \u0000 \ud800
    "#;
    let words: Vec<&str> = words.split_whitespace().collect();
    Reader::text("summary", [SUMMARY.as_bytes()], &words, move |input| {
        let path = scratch.put(input);
        let read = Summary::read(&path);
        let mut again = false;
        if let Ok(summary) = &read {
            // A summary that was read can be written and read back.
            summary.write(&path).expect("it can be written");
            again = Summary::read(&path).is_err();
        }
        assert!(!again, "it is not read back");
        explained(BitTestSummary::read(&path), "summary.json")
            | explained(BhaSummary::read(&path), "summary.json")
            | explained(read, "summary.json")
    })
}

/// A table with some rows.
fn table(specs: &[ColumnSpec], rows: usize) -> Table {
    let empty = Table::with_columns(specs);
    let columns = empty.columns().iter().enumerate().map(|(index, column)| Column {
        data: match &column.data {
            Data::Text(_) => Data::Text((0..rows).map(|row| format!("word {}", row % 3)).collect()),
            Data::Number(_) => Data::Number(
                (0..rows)
                    .map(|row| (row % 7 != 3).then_some((index * rows + row) as f64 * 0.1))
                    .collect(),
            ),
        },
        ..column.clone()
    });
    Table::new(columns.collect())
}

/// Parquet files of each kind.
fn parquet() -> Reader {
    let scratch = Scratch::new("table.parquet");
    let mut seeds = Vec::new();
    for (specs, rows) in [(NODES, 40), (TIME, 60), (WEAR, 20), (CONTACT, 30), (WEAR, 0)] {
        let path = scratch.put(b"");
        table(specs, rows).write_parquet(&path).expect("a table is written");
        seeds.push(fs::read(&path).expect("it is there"));
    }
    seeds.push(frames());
    Reader::binary("parquet", seeds, move |input| {
        let path = scratch.put(input);
        let names = ["md_m", "tension_N", "operation", "time_s"];
        let pieces = Table::read_parquet_pieces(&path, &names, |piece| {
            assert!(piece.columns().len() <= names.len());
        });
        explained(pieces, "table.parquet") | explained(Table::read_parquet(&path), "table.parquet")
    })
}

/// A file of frames.
fn frames() -> Vec<u8> {
    let scratch = Scratch::new("frames.parquet");
    let channels = [Channel::Velocity, Channel::Force];
    let column = vec![1.5; 12];
    let frame = Frame {
        time_s: 1.0,
        md_m: column.clone(),
        velocity_high_m_per_s: column.clone(),
        velocity_right_m_per_s: column.clone(),
        axial_velocity_m_per_s: column.clone(),
        tension_N: column.clone(),
        torque_N_m: column,
        ..Frame::default()
    };
    let folder = scratch.folder();
    let mut writer = folder.frames(&channels).expect("frames begin");
    for _ in 0..5 {
        writer.push("drill", &frame).expect("a frame is kept");
    }
    writer.write().expect("frames are written");
    fs::read(folder.path().join("frames.parquet")).expect("they are there")
}

/// `sweep.csv` and similar files.
fn csv() -> Reader {
    let scratch = Scratch::new("sweep.csv");
    let seeds: [&[u8]; 2] = [
        b"friction,model,operation,bit_depth_m,hook_load_N,status,message,folder\n0.1,soft,drill,1500,1e5,complete,,friction=0.1\n0.2,soft,drill,1500,,failed,\"a, b\",friction=0.2\n",
        b"name,model,operation,bit_depth_m\n'=1+2,dynamic,slide,-5\n\"'-x\",soft,drill,3\n",
    ];
    let words = &[",", "\n", "\"", "\"\"", "\r\n", "'", "=", "model", "operation"];
    Reader::text("sweep-csv", seeds, words, move |input| {
        let path = scratch.put(input);
        let read = Table::read_csv(&path);
        if let Ok(table) = &read
            && !table.columns().is_empty()
        {
            // A table that was read is written and read back unchanged.
            table.write_csv(&path).expect("it can be written");
            let again = Table::read_csv(&path).expect("it is read back");
            assert!(again == *table || table.rows() == 0, "it is not the same");
        }
        explained(read, "sweep.csv")
    })
}
