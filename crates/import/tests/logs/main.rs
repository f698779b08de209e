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

/// Rows of a log, and the log after its end.
pub fn rows(
    name: &str,
    text: &[u8],
    choices: &Choices,
) -> Result<(Vec<Record>, Log<'static>), ImportError> {
    let mut log = log(Input::new(name, std::io::Cursor::new(text.to_vec())), choices)?;
    let rows: Result<Vec<Record>, ImportError> = log.by_ref().collect();
    Ok((rows?, log))
}

/// Rows of a log that requires no choices.
pub fn read(text: &str) -> (Vec<Record>, Log<'static>) {
    rows("a log", text.as_bytes(), &Choices::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The reason why a log is refused.
pub fn refused(text: &str) -> String {
    match rows("a log", text.as_bytes(), &Choices::default()) {
        Ok((rows, _)) => panic!("{} rows were read", rows.len()),
        Err(error) => error.to_string(),
    }
}

/// Notes of a log.
pub fn notes(log: &Log) -> String {
    let notes = log.notes.iter().map(|note| format!("{}: {}\n", note.kind(), note.text()));
    notes.collect()
}

/// Summary of a log: its kind, rows and notes, or the refusal.
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
    let shown = |name: &str, value: f64, unit: &str| {
        (!value.is_nan()).then(|| format!("{name} {value:.3} {unit}"))
    };
    let parts = [
        shown("t", row.time_s, "s"),
        shown("bit", row.bit_depth_m, "m"),
        shown("hole", row.hole_depth_m, "m"),
        shown("block", row.block_position_m, "m"),
        shown("hook load", row.hook_load_N, "N"),
        shown("wob", row.weight_on_bit_N, "N"),
        shown("torque", row.torque_N_m, "N.m"),
        shown("rotary", row.rotary_speed_rad_per_s, "rad/s"),
        shown("flow", row.flow_rate_m3_per_s, "m3/s"),
        shown("spp", row.standpipe_pressure_Pa, "Pa"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}
