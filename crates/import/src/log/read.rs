//! Opens a log.

use wholestring_units::{Dimension, UnitSet};

use super::{
    kind::Kind,
    log::{Log, Opened},
    picking::{self, Thresholds},
    quantity::Quantity,
    {csv, las, witsml},
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::{Fragment, Note},
    input::Input,
};

/// Opens a log of a rig, whose rows are read on demand.
///
/// ```
/// use wholestring_import::{Choices, Input, log};
///
/// let text = b"Time (s),Bit Depth (m),Hook Load (kN)\n0,3000,1200\n5,3001.5,1310\n";
/// let log = log(Input::of_bytes("trip.csv", text), &Choices::default())?;
/// let loads: Result<Vec<f64>, _> = log.map(|row| row.map(|row| row.hook_load_N)).collect();
/// assert_eq!(loads?, [1_200_000.0, 1_310_000.0]);
/// # Ok::<(), wholestring_import::ImportError>(())
/// ```
///
/// # Errors
/// It is not a log, its head is damaged, a unit is missing or several channels are possible.
pub fn log<'a>(mut input: Input<'a>, choices: &Choices) -> Result<Log<'a>, ImportError> {
    let Some(kind) = Kind::of(input.head()?) else {
        let kind = ImportErrorKind::NotRecognised { found: "it is not a log".to_owned() };
        return Err(ImportError::new(input.name(), None, kind));
    };
    open(input, kind, choices)
}

/// Opens a log of a kind.
fn open<'a>(input: Input<'a>, kind: Kind, choices: &Choices) -> Result<Log<'a>, ImportError> {
    let mut log = unasked(input, kind, choices)?;
    log.ask()?;
    Ok(log)
}

/// Opens a log without an error for missing choices.
pub(super) fn unasked<'a>(
    input: Input<'a>,
    kind: Kind,
    choices: &Choices,
) -> Result<Log<'a>, ImportError> {
    let opened: Opened<'a> = match kind {
        Kind::Las => las::open(input)?,
        Kind::Csv => csv::open(input)?,
        Kind::Witsml => witsml::open(input, choices)?,
    };
    Log::of(opened, choices)
}

/// Picks weights and torques from a log.
pub(crate) fn read(input: Input, kind: Kind, choices: &Choices) -> Result<Fragment, ImportError> {
    let name = input.name().to_owned();
    read_log(open(input, kind, choices)?, &name, choices)
}

/// Picks weights and torques from an open log.
pub(super) fn read_log(
    mut log: Log,
    name: &str,
    choices: &Choices,
) -> Result<Fragment, ImportError> {
    let measured = [Quantity::HookLoad, Quantity::Torque];
    if !measured.iter().any(|quantity| log.has(*quantity)) {
        let channels: Vec<&str> =
            log.channels.iter().take(20).map(|channel| channel.mnemonic.as_str()).collect();
        let more = log.channels.len().saturating_sub(20);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let left_out: Vec<&str> = log
            .notes
            .iter()
            .map(Note::text)
            .filter(|text| {
                let not = |quantity: &Quantity| {
                    text.contains(&format!("is not used as the {}", quantity.words()))
                };
                measured.iter().any(not)
            })
            .collect();
        let left_out =
            if left_out.is_empty() { String::new() } else { format!("; {}", left_out.join("; ")) };
        let sentence = format!(
            "it has no hook load and no surface torque; its channels are {}{more} (choose one \
             with --pick hookload=CHANNEL){left_out}",
            channels.join(", "),
        );
        return Err(ImportError::new(name, None, ImportErrorKind::Refused(sentence)));
    }
    let unit = log.unit(Quantity::HookLoad).unwrap_or(Dimension::Force.unit_in(UnitSet::Si));
    let picked = picking::pick(log.by_ref(), name, unit, &Thresholds::default(), choices);
    let mut picks = picked.map_err(|error| explained(error, &log))?;
    let depth = log.unit(Quantity::BitDepth).or(log.unit(Quantity::HoleDepth));
    if depth.is_some_and(|depth| !depth.is_field()) {
        picks.units = UnitSet::Si;
    }
    let mut fragment = picks.fragment();
    fragment.what = format!("{}, {}", log.what, fragment.what);
    let mut notes = vec![Note::Read(format!("channels: {}", taken(&log)))];
    notes.append(&mut log.notes);
    notes.append(&mut fragment.notes);
    Ok(Fragment { notes, ..fragment })
}

/// Adds to the error of an incomplete log the channel of the missing quantity, if it has no usable
/// value, or the channels that might be the missing one and were left out.
fn explained(error: ImportError, log: &Log) -> ImportError {
    let ImportErrorKind::Refused(sentence) = error.kind() else { return error };
    let is_missing = |quantity: &&Quantity| {
        sentence.contains("is missing")
            && sentence.contains(&format!("--pick {}=", quantity.name()))
    };
    let Some(missing) = Quantity::ALL.iter().find(is_missing) else { return error };
    if let Some(channel) = log.channels.iter().find(|channel| channel.quantity == Some(*missing)) {
        let values = match sentence.contains(&format!("of the {}, the first", missing.words())) {
            true => "values outside the range of any rig",
            false => "null values, such as -999.25, or empty cells",
        };
        let (what, rest) = sentence.split_once(" is missing; ").unwrap_or((sentence, ""));
        let sentence = format!(
            "{what} is missing: its channel {} has only {values}; {}",
            channel.mnemonic,
            rest.replacen("if a channel has it", "if another channel has it", 1)
        );
        return ImportError::new(error.file(), None, ImportErrorKind::Refused(sentence));
    }
    let notes = &log.notes;
    let words = format!("is not used as the {}", missing.words());
    let others = |text: &str| text.contains("is not used as the ") && !text.contains(&words);
    let all = || notes.iter().filter(|note| matches!(note, Note::LeftOut(_))).map(Note::text);
    let mut left_out: Vec<&str> = all().filter(|text| text.contains(&words)).collect();
    if left_out.is_empty() {
        return error;
    }
    left_out.extend(all().filter(|text| others(text)));
    let sentence = format!("{sentence}; {}", left_out.join("; "));
    ImportError::new(error.file(), None, ImportErrorKind::Refused(sentence))
}

/// Lists the quantity assigned to each channel in use.
fn taken(log: &Log) -> String {
    let taken = log.channels.iter().filter_map(|channel| {
        Some(format!("{} from {}", channel.quantity?.words(), channel.named()))
    });
    taken.collect::<Vec<_>>().join(", ")
}
