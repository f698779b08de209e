//! Logs of a rig: LAS, text of recorders, WITSML.

mod channels;
mod field;
mod hostile;
mod las;
mod samples;
mod text;
mod times;
mod witsml;

use wholestring_import::{Choices, ImportError, Input, Log, Record, contents, import, log};

/// The rows of a log, and the log when it has ended.
pub fn rows(
    name: &str,
    text: &[u8],
    choices: &Choices,
) -> Result<(Vec<Record>, Log<'static>), ImportError> {
    let mut log = log(Input::new(name, std::io::Cursor::new(text.to_vec())), choices)?;
    let rows: Result<Vec<Record>, ImportError> = log.by_ref().collect();
    Ok((rows?, log))
}

/// The rows of a log that needs nothing to be said.
pub fn read(text: &str) -> (Vec<Record>, Log<'static>) {
    rows("a log", text.as_bytes(), &Choices::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Why a log is not read.
pub fn refused(text: &str) -> String {
    match rows("a log", text.as_bytes(), &Choices::default()) {
        Ok((rows, _)) => panic!("{} rows were read", rows.len()),
        Err(error) => error.to_string(),
    }
}

/// What was said of a log.
pub fn notes(log: &Log) -> String {
    let notes = log.notes.iter().map(|note| format!("{}: {}\n", note.kind(), note.text()));
    notes.collect()
}

/// A log for people: what it is, its rows, and what was said; or why it is refused.
pub fn summary(name: &str, bytes: &[u8], choices: &Choices) -> String {
    let mut text = match contents(Input::of_bytes(name, bytes)) {
        Ok(contents) => format!("{}\n  {}\n", contents.what, contents.lines.join("\n  ")),
        Err(error) => format!("{error}\n"),
    };
    text.push_str("---- rows\n");
    match rows(name, bytes, choices) {
        Ok((rows, log)) => {
            for row in &rows {
                text.push_str(&format!("{}\n", line(row)));
            }
            text.push_str(&format!("{} rows, from {:?}\n{}", rows.len(), log.start, notes(&log)));
        }
        Err(error) => text.push_str(&format!("{error}\n")),
    }
    text.push_str("---- import\n");
    match import(vec![Input::of_bytes(name, bytes)], choices) {
        Ok(imported) => {
            for (file, what) in imported.files {
                text.push_str(&format!("{file}: {what}\n"));
            }
            for (_, note) in imported.notes {
                text.push_str(&format!("{}: {}\n", note.kind(), note.text()));
            }
        }
        Err(error) => text.push_str(&format!("{error}\n")),
    }
    text
}

fn line(row: &Record) -> String {
    let of = |name: &str, value: f64, unit: &str| {
        (!value.is_nan()).then(|| format!("{name} {value:.3} {unit}"))
    };
    let parts = [
        of("t", row.time_s, "s"),
        of("bit", row.bit_depth_m, "m"),
        of("hole", row.hole_depth_m, "m"),
        of("block", row.block_position_m, "m"),
        of("hook load", row.hook_load_N, "N"),
        of("wob", row.weight_on_bit_N, "N"),
        of("torque", row.torque_N_m, "N.m"),
        of("rotary", row.rotary_speed_rad_per_s, "rad/s"),
        of("flow", row.flow_rate_m3_per_s, "m3/s"),
        of("spp", row.standpipe_pressure_Pa, "Pa"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}
