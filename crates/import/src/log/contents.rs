//! Summary of a log for the user.

use super::{channel::Channel, kind::Kind, log::Log, quantity::Quantity, read::unasked};
use crate::{choices::Choices, error::ImportError, fragment::Contents, input::Input};

/// Maximum number of unused channels that are listed.
const NAMED: usize = 200;

/// Describes a log and its contents. Its rows are counted; choices that an import requires are
/// listed at the end.
pub(crate) fn contents(input: Input, kind: Kind) -> Result<Contents, ImportError> {
    contents_of(unasked(input, kind, &Choices::default())?)
}

/// Describes an open log and its contents.
pub(super) fn contents_of(mut log: Log) -> Result<Contents, ImportError> {
    let mut lines = Vec::new();
    lines.extend(log.well.iter().map(|well| format!("well: {well}")));
    for channel in &log.channels {
        let Some(quantity) = channel.quantity else { continue };
        let (name, words) = (&channel.mnemonic, quantity.words());
        let description = if channel.description.is_empty() || channel.description == *name {
            String::new()
        } else {
            format!(": {}", channel.description)
        };
        lines.push(format!("{words}: {}{description}", channel.named()));
    }
    let unused = || log.channels.iter().filter(|channel| channel.quantity.is_none());
    let names: Vec<String> = unused().take(NAMED).map(Channel::named).collect();
    if !names.is_empty() {
        let more = unused().count() - names.len();
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        lines.push(format!("not used: {}{more}", names.join(", ")));
    }
    let depth = |record: &super::Record| {
        if record.bit_depth_m.is_nan() { record.hole_depth_m } else { record.bit_depth_m }
    };
    let mut depths = (f64::INFINITY, f64::NEG_INFINITY);
    let mut last_s = f64::NAN;
    // Without their units, depths and loads are unknown.
    for record in log.by_ref() {
        let record = record?;
        last_s = record.time_s;
        // A comparison with NaN is false.
        depths = (depths.0.min(depth(&record)), depths.1.max(depth(&record)));
    }
    let count = log.rows();
    let mut rows = format!("{count} {}", if count == 1 { "row" } else { "rows" });
    if last_s > 0.0 {
        rows.push_str(&format!(" in {}", duration(last_s)));
    }
    if let Some(start) = &log.start {
        rows.push_str(&format!(", from {start}"));
    }
    lines.push(rows);
    if depths.0 <= depths.1 {
        let words = if log.has(Quantity::BitDepth) { "bit depth" } else { "depth" };
        lines.push(format!("{words} from {:.1} to {:.1} m", depths.0, depths.1));
    }
    lines.extend(log.notes.iter().map(|note| format!("{}: {}", note.kind(), note.text())));
    lines.extend(log.asked.iter().map(|kind| format!("to import it: {kind}")));
    Ok(Contents { what: log.what, lines, ..Contents::default() })
}

/// Hours, minutes and seconds.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 120.0 => format!("{s} s"),
        s if s < 7200.0 => format!("{:.1} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}
