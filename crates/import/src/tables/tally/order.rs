//! Direction of a tally.

use wholestring_tabular::{Column, TallyRow, is_bit};

use super::{part::Refusal, sums::Steps};
use crate::{choices::Choices, error::ImportErrorKind, fragment::Note};

/// The order of a tally's rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    /// From the bit up.
    BitFirst,
    /// From the surface down.
    BitLast,
}

const NAMES: [(&str, Order); 2] = [("bit-first", Order::BitFirst), ("bit-last", Order::BitLast)];

/// Determines the order from the user's choice, the row of the bit, the cumulative length, or the
/// numbers.
pub(crate) fn find(
    rows: &[TallyRow],
    names: &[String],
    steps: &Steps,
    choices: &Choices,
    notes: &mut Vec<Note>,
) -> Result<Order, Refusal> {
    if rows.len() == 1 {
        return Ok(Order::BitFirst);
    }
    let say = |order: Order, why: &str| {
        let how = match order {
            Order::BitFirst => "read as listed, from the bit up",
            Order::BitLast => "listed from the surface down, and reversed",
        };
        format!("the tally is {how}: {why}")
    };
    let bits: Vec<usize> = (0..rows.len()).filter(|&row| is_bit(&names[row])).collect();
    if let [first, second, ..] = bits[..] {
        let [first, second] =
            [first, second].map(|row| format!("'{}' in {}", names[row], rows[row].place));
        let sentence = format!(
            "two rows are bits, {first} and {second}; a string has one: keep the rows of one \
             string, or rename the row that is no bit"
        );
        return Err((Some(rows[bits[1]].place.clone()), ImportErrorKind::Refused(sentence)));
    }
    if let Some(picked) = choices.picked("order") {
        let Some((_, order)) = NAMES.iter().find(|(name, _)| *name == picked) else {
            let kind = ImportErrorKind::NoSuch {
                what: "order".to_owned(),
                name: picked.to_owned(),
                names: NAMES.map(|(name, _)| name.to_owned()).to_vec(),
            };
            return Err((None, kind));
        };
        notes.push(Note::Read(say(*order, "as given")));
        return Ok(*order);
    }
    let last = rows.len() - 1;
    let at_end = match bits[..] {
        [0] => Some(Order::BitFirst),
        [bit] if bit == last => Some(Order::BitLast),
        _ => None,
    };
    if let Some(order) = at_end {
        let row = if order == Order::BitFirst { 0 } else { last };
        let why = format!("the bit, '{}', is in {}", names[row], rows[row].place);
        notes.push(Note::Read(say(order, &why)));
        return Ok(order);
    }
    if let [bit] = bits[..] {
        let sentence = format!(
            "the bit, '{}', is neither first nor last; expected the components of one string, \
             from the bit up or from the surface down (--pick order=bit-first or bit-last if it \
             is not a bit)",
            names[bit]
        );
        return Err((Some(rows[bit].place.clone()), ImportErrorKind::Refused(sentence)));
    }
    match (steps.grow, steps.fall) {
        (grow, fall) if grow > fall && grow >= 2 => {
            let why = "the cumulative length increases down the table, and counts from the bit";
            notes.push(Note::Assumed(say(Order::BitFirst, why)));
            return Ok(Order::BitFirst);
        }
        (grow, fall) if fall > grow && fall >= 2 => {
            let why = "the cumulative length decreases down the table, and counts from the bit";
            notes.push(Note::Assumed(say(Order::BitLast, why)));
            return Ok(Order::BitLast);
        }
        _ => {}
    }
    let numbers: Vec<f64> = rows
        .iter()
        .filter_map(|row| {
            row.get(Column::Number)?.written.trim_matches(['#', '.', ' ']).parse().ok()
        })
        .collect();
    if numbers.len() == rows.len() {
        let by = "the numbers count from the bit";
        let order = match () {
            () if numbers.windows(2).all(|two| two[1] > two[0]) => Some(Order::BitFirst),
            () if numbers.windows(2).all(|two| two[1] < two[0]) => Some(Order::BitLast),
            () => None,
        };
        if let Some(order) = order {
            notes.push(Note::Assumed(say(order, by)));
            return Ok(order);
        }
    }
    let sentence = "it is unknown which end of the tally is the bit's: no row is a bit, and \
         neither a cumulative length nor numbers count from it; choose with --pick \
         order=bit-first or --pick order=bit-last";
    Err((None, ImportErrorKind::Refused(sentence.to_owned())))
}

/// Whether the case recognises a name as that of a bit: its last word is `bit`.
pub(crate) fn ends_with_bit(name: &str) -> bool {
    let last = name.split(|c: char| !c.is_alphanumeric()).rfind(|word| !word.is_empty());
    last.is_some_and(|word| word.eq_ignore_ascii_case("bit"))
}
