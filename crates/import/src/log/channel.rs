//! Channels of a log, and the choice of those that fill a record.

use wholestring_units::{Dimension, Unit};

use super::{
    mnemonics::{self, Rank},
    quantity::Quantity,
};
use crate::{choices::Choices, error::ImportErrorKind, fragment::Note};

/// A channel of a log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Channel {
    /// Its name, with `:2` after the second channel of the same name.
    pub mnemonic: String,
    /// Its unit as written; empty if there is none.
    pub unit: String,
    /// Which field of a [`Record`](super::Record) it gives.
    pub quantity: Option<Quantity>,
    /// Description in the file.
    pub description: String,
}

impl Channel {
    /// Its name with its unit.
    pub(crate) fn named(&self) -> String {
        let Channel { mnemonic, unit, quantity, .. } = self;
        match (unit.as_str(), quantity) {
            ("", Some(Quantity::Time) | None) => mnemonic.clone(),
            ("", Some(_)) => format!("{mnemonic} (no unit)"),
            _ => format!("{mnemonic} ({unit})"),
        }
    }
}

/// A column as a format declares it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Column {
    pub(crate) mnemonic: String,
    /// An alternative name.
    pub(crate) alias: Option<String>,
    pub(crate) unit: String,
    pub(crate) description: String,
    /// Null value of this column only.
    pub(crate) null: Option<f64>,
    /// Quantity given by its position: the index of the log.
    pub(crate) index: Option<Quantity>,
}

/// A column that gives a field of a record.
#[derive(Debug, Clone)]
pub(crate) struct Wanted {
    pub(crate) column: usize,
    pub(crate) quantity: Quantity,
    pub(crate) unit: &'static Unit,
}

/// Columns chosen for each quantity.
#[derive(Debug, Default)]
pub(crate) struct Chosen {
    pub(crate) channels: Vec<Channel>,
    pub(crate) wanted: Vec<Wanted>,
    pub(crate) time: Option<usize>,
    pub(crate) date: Option<usize>,
    pub(crate) notes: Vec<Note>,
    /// Choices that the user must make before the log can be read.
    pub(crate) asked: Vec<ImportErrorKind>,
}

/// A column that may give a quantity.
struct Candidate {
    column: usize,
    rank: Rank,
    unit: Option<&'static Unit>,
}

/// Chooses the columns of a log.
pub(crate) fn choose(columns: &[Column], choices: &Choices) -> Chosen {
    let mut chosen = Chosen { channels: numbered(columns), ..Chosen::default() };
    for quantity in Quantity::ALL {
        let found = match quantity {
            Quantity::Time => time(columns, choices, &mut chosen),
            _ => one(quantity, columns, choices, &mut chosen),
        };
        if let Err(kind) = found {
            chosen.asked.push(kind);
        }
    }
    chosen
}

/// The unit of a quantity, including spellings of recorders such as `ft_lbs` and `gal_per_min`.
pub(crate) fn unit(dimension: Dimension, written: &str) -> Option<&'static Unit> {
    dimension.find_unit(written).or_else(|| {
        let tidy = written.to_ascii_lowercase().replace("_per_", "/").replace('_', ".");
        dimension.find_unit(&tidy)
    })
}

/// Whether a unit text means that there is no unit.
pub(crate) fn is_no_unit(written: &str) -> bool {
    let words = ["", "-", "--", "none", "unitless", "n/a", "na", "unknown", "nil", "null"];
    words.contains(&written.to_ascii_lowercase().as_str())
}

/// Channels of the columns; the second of a name gets `:2` after it.
fn numbered(columns: &[Column]) -> Vec<Channel> {
    let mut seen = std::collections::BTreeMap::<String, usize>::new();
    let channel = |column: &Column| {
        let Column { mnemonic, unit, description, .. } = column;
        let count = seen.entry(mnemonic.clone()).or_default();
        *count += 1;
        let mnemonic = if *count == 1 { mnemonic.clone() } else { format!("{mnemonic}:{count}") };
        Channel { mnemonic, unit: unit.clone(), quantity: None, description: description.clone() }
    };
    columns.iter().map(channel).collect()
}

fn one(
    quantity: Quantity,
    columns: &[Column],
    choices: &Choices,
    chosen: &mut Chosen,
) -> Result<(), ImportErrorKind> {
    let dimension = quantity.dimension();
    if let Some(column) = picked(quantity, choices, &chosen.channels)? {
        let written = &chosen.channels[column].unit;
        let found = unit(dimension, written);
        if found.is_none() && !is_no_unit(written) {
            let kind = ImportErrorKind::WrongUnit { found: written.clone(), dimension };
            unit_choice(quantity, column, choices, chosen)?.ok_or(kind)?;
        }
        return take(quantity, column, found, choices, chosen);
    }
    let mut candidates = Vec::new();
    let of_trips = is_of_trips(columns);
    for (column, Column { mnemonic, alias, unit: written, index, .. }) in columns.iter().enumerate()
    {
        let by_name = mnemonics::quantity(mnemonic)
            .or_else(|| alias.as_deref().and_then(mnemonics::quantity));
        let rank = match (index, by_name) {
            (Some(index), _) if *index == quantity => Rank::Index,
            // In a log of trips the only depth is that of the bit.
            (_, Some((Quantity::HoleDepth, Rank::Loose))) if of_trips => {
                if quantity != Quantity::BitDepth {
                    continue;
                }
                Rank::Loose
            }
            (_, Some((named, rank))) if named == quantity => rank,
            _ => continue,
        };
        // `--pick bit-depth=DEPT` has taken it.
        if chosen.channels[column].quantity.is_some_and(|other| other != Quantity::Time) {
            continue;
        }
        let found = unit(dimension, written);
        if found.is_none()
            && !is_no_unit(written)
            && unit_choice(quantity, column, choices, chosen)?.is_none()
        {
            let name = &chosen.channels[column].mnemonic;
            let (words, measures) = (quantity.words(), dimension.name());
            chosen.notes.push(Note::LeftOut(format!(
                "{name} is not used as the {words}, because its unit '{written}' is not one of \
                 {measures} (--unit {}=UNIT selects it)",
                quantity.name()
            )));
            continue;
        }
        candidates.push(Candidate { column, rank, unit: found });
    }
    // Of two equally good candidates, the one with a known unit is preferred.
    candidates.sort_by_key(|candidate| (candidate.rank, candidate.unit.is_none()));
    let Some(best) = candidates.first() else { return Ok(()) };
    let name = |candidate: &Candidate| chosen.channels[candidate.column].mnemonic.clone();
    let alike =
        |other: &&Candidate| other.rank == best.rank && other.unit.is_none() == best.unit.is_none();
    if candidates.iter().filter(alike).count() > 1 {
        let names = candidates.iter().map(name).collect();
        return Err(ImportErrorKind::Ambiguous { what: quantity.name().to_owned(), names });
    }
    if candidates.len() > 1 {
        let others: Vec<String> = candidates[1..].iter().map(name).collect();
        let note = format!(
            "{} is {} and used as the {}; not used: {} ({} selects that)",
            name(best),
            best.rank.words(),
            quantity.words(),
            others.join(", "),
            pick(quantity, &others[0]),
        );
        chosen.notes.push(Note::Read(note));
    }
    let (column, unit) = (best.column, best.unit);
    if best.rank == Rank::Loose && of_trips {
        let name = &chosen.channels[column].mnemonic;
        chosen.notes.push(Note::Assumed(format!(
            "{name} is used as the depth of the bit, because this is a log of trips ({} uses it \
             as the hole's)",
            pick(Quantity::HoleDepth, name)
        )));
    } else if best.rank == Rank::Loose {
        let name = &chosen.channels[column].mnemonic;
        chosen.notes.push(Note::Assumed(format!(
            "{name} is used as the depth of the hole, not of the bit ({} uses it as that)",
            pick(Quantity::BitDepth, name)
        )));
    }
    if best.rank == Rank::Greatest || best.rank == Rank::Least {
        chosen.notes.push(Note::Assumed(format!(
            "{} is used as the {}, though it is {} between two rows; there is no average",
            chosen.channels[column].mnemonic,
            quantity.words(),
            best.rank.words(),
        )));
    }
    take(quantity, column, unit, choices, chosen)
}

/// Whether the channels are those of a log of trips: `TRIPNUM`, `TRIPFILL`, `STANDSTOGO`, and only
/// one depth.
fn is_of_trips(columns: &[Column]) -> bool {
    /// Minimum number of its channels.
    const FEWEST: usize = 3;
    let is_of_trip = |column: &&Column| {
        let name = column.mnemonic.to_ascii_uppercase();
        name.starts_with("TRIP") || name.starts_with("STANDS")
    };
    let is_depth = |column: &&Column| {
        matches!(
            mnemonics::quantity(&column.mnemonic),
            Some((Quantity::BitDepth | Quantity::HoleDepth, _))
        )
    };
    let is_time = |column: &Column| {
        column.index == Some(Quantity::Time)
            || matches!(mnemonics::quantity(&column.mnemonic), Some((Quantity::Time, _)))
    };
    columns.iter().filter(is_of_trip).count() >= FEWEST
        && columns.iter().filter(is_depth).count() == 1
        && columns.iter().any(is_time)
}

/// The option that picks a channel, quoted for a shell.
fn pick(quantity: Quantity, name: &str) -> String {
    let option = format!("{}={name}", quantity.name());
    let plain = |c: char| c.is_alphanumeric() || "=-_.:".contains(c);
    if option.chars().all(plain) {
        format!("--pick {option}")
    } else {
        format!("--pick '{option}'")
    }
}

/// The column that `--pick` names.
fn picked(
    quantity: Quantity,
    choices: &Choices,
    channels: &[Channel],
) -> Result<Option<usize>, ImportErrorKind> {
    let Some(name) = choices.picked(quantity.name()) else { return Ok(None) };
    let found = channels.iter().position(|channel| channel.mnemonic.eq_ignore_ascii_case(name));
    found.map(Some).ok_or_else(|| ImportErrorKind::NoSuch {
        what: quantity.name().to_owned(),
        name: name.to_owned(),
        names: channels.iter().map(|channel| channel.mnemonic.clone()).collect(),
    })
}

/// The unit given for a column with `--unit`.
fn unit_choice(
    quantity: Quantity,
    column: usize,
    choices: &Choices,
    chosen: &Chosen,
) -> Result<Option<&'static Unit>, ImportErrorKind> {
    let mnemonic = chosen.channels[column].mnemonic.as_str();
    choices.unit_of(&[quantity.name(), mnemonic], quantity.dimension())
}

/// Assigns a column to a quantity, with the unit given by the user or else that of the file.
fn take(
    quantity: Quantity,
    column: usize,
    of_file: Option<&'static Unit>,
    choices: &Choices,
    chosen: &mut Chosen,
) -> Result<(), ImportErrorKind> {
    chosen.channels[column].quantity = Some(quantity);
    let chosen_unit = unit_choice(quantity, column, choices, chosen)?;
    let channel = &chosen.channels[column];
    let (name, written) = (&channel.mnemonic, &channel.unit);
    if let Some(chosen_unit) = chosen_unit
        && !is_no_unit(written)
        && of_file.is_none_or(|unit| unit.symbol != chosen_unit.symbol)
    {
        let note = format!(
            "{name} is in {}, as given with --unit; the file has '{written}'",
            chosen_unit.symbol
        );
        chosen.notes.push(Note::Checked(note));
    }
    let unit = match chosen_unit.or(of_file) {
        Some(unit) => unit,
        None if quantity == Quantity::RotarySpeed => {
            let note = format!("{name} has no unit and is taken to be in rpm");
            chosen.notes.push(Note::Assumed(note));
            quantity.dimension().units().iter().find(|unit| unit.symbol == "rpm").ok_or_else(
                || ImportErrorKind::Missing { what: "the unit of the rotary speed".to_owned() },
            )?
        }
        None => {
            return Err(ImportErrorKind::MissingUnit {
                what: format!("{} {name}", quantity.words()),
                name: quantity.name().to_owned(),
                dimension: quantity.dimension(),
            });
        }
    };
    chosen.wanted.push(Wanted { column, quantity, unit });
    Ok(())
}

/// Finds the columns of time and date; their format is determined from the rows.
fn time(columns: &[Column], choices: &Choices, chosen: &mut Chosen) -> Result<(), ImportErrorKind> {
    let is_time = |column: &Column| {
        matches!(mnemonics::quantity(&column.mnemonic), Some((Quantity::Time, _)))
            && (is_no_unit(&column.unit) || may_be_of_time(&column.unit))
    };
    let picked = picked(Quantity::Time, choices, &chosen.channels)?;
    let index = || columns.iter().position(|column| column.index == Some(Quantity::Time));
    let named: Vec<usize> = (0..columns.len()).filter(|&at| is_time(&columns[at])).collect();
    chosen.date = columns.iter().position(|column| mnemonics::is_date(&column.mnemonic));
    chosen.time = picked.or_else(index).or(named.first().copied());
    if picked.is_none()
        && let Some(taken) = chosen.time
        && let Some(&other) = named.iter().find(|&&at| at != taken)
    {
        let name = |at: usize| &chosen.channels[at].mnemonic;
        chosen.notes.push(Note::Read(format!(
            "{} is used as the time, not {} ({} selects that)",
            name(taken),
            name(other),
            pick(Quantity::Time, name(other)),
        )));
    }
    if chosen.time.is_none() {
        chosen.time = chosen.date.take();
    }
    if let Some(column) = chosen.time {
        chosen.channels[column].quantity = Some(Quantity::Time);
    }
    Ok(())
}

/// Whether a unit may be that of a time column: `s`, or the pattern of a date or time.
fn may_be_of_time(written: &str) -> bool {
    unit(Dimension::Time, written).is_some() || is_pattern(written)
}

/// A pattern of dates and times: `hh:mm:ss`, `YYYY-MM-DD`, `ISO8601`, `datetime`.
pub(crate) fn is_pattern(written: &str) -> bool {
    let lower = written.to_ascii_lowercase();
    [
        "hh",
        "yy",
        "iso",
        "date",
        "utc",
        "timestamp",
        "dd-",
        "dd/",
        "excel",
        "time",
        "epoch",
        "unix",
        "1970",
    ]
    .iter()
    .any(|part| lower.contains(part))
}
