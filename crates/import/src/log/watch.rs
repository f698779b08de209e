//! Observations on rows, reported at the end of the log.

use crate::{error::ImportErrorKind, fragment::Note};

/// Observations on the rows of a log.
#[derive(Debug, Default)]
pub(super) struct Watch {
    given: u64,
    last_time_s: Option<f64>,
    same_time: u64,
    /// Number of rows with a time before that of the row above, and the line of the first.
    back: (u64, u64),
    without_time: (u64, u64),
    /// Null values that the head does not declare.
    usual_nulls: (u64, f64, u64),
    /// Numbers with a decimal comma.
    commas: (u64, u64),
    /// Values that the logger marks as bad.
    bad: (u64, u64),
}

impl Watch {
    /// Number of rows returned.
    pub(super) fn rows(&self) -> u64 {
        self.given
    }

    /// Counts a returned row.
    pub(super) fn given(&mut self) {
        self.given += 1;
    }

    /// Time of a row; `None` if it has none or goes back.
    pub(super) fn time_s(&mut self, time_s: Option<f64>, line: u64) -> Option<f64> {
        let Some(time_s) = time_s else {
            count(&mut self.without_time, line);
            return None;
        };
        match self.last_time_s {
            Some(last) if time_s < last => {
                count(&mut self.back, line);
                return None;
            }
            Some(last) if time_s == last => self.same_time += 1,
            _ => {}
        }
        self.last_time_s = Some(time_s);
        Some(time_s)
    }

    /// Counts a null value that the head does not declare.
    pub(super) fn usual_null(&mut self, value: f64, line: u64) {
        let (count, first, at) = &mut self.usual_nulls;
        if *count == 0 {
            (*first, *at) = (value, line);
        }
        *count += 1;
    }

    /// Counts a number with a decimal comma.
    pub(super) fn comma(&mut self, line: u64) {
        count(&mut self.commas, line);
    }

    /// Counts a value that the logger marks as bad.
    pub(super) fn bad(&mut self, line: u64) {
        count(&mut self.bad, line);
    }

    /// Adds the notes on the observations.
    pub(super) fn finish(&self, notes: &mut Vec<Note>) -> Result<(), ImportErrorKind> {
        let Watch { given, same_time, back, without_time, usual_nulls, commas, bad, .. } = *self;
        if back.0 * 10 > given {
            let sentence = format!(
                "the time goes back: {} of {} rows are earlier than one above, the first in line \
                 {}; expected rows in the order of time (cut the file there and read its parts \
                 one by one, or choose another column with --pick time=CHANNEL)",
                back.0,
                back.0 + given,
                back.1
            );
            return Err(ImportErrorKind::Refused(sentence));
        }
        if back.0 > 0 {
            notes.push(Note::LeftOut(format!(
                "{}, the first in line {}: earlier than one above (a clock that was set back, or \
                 parts of a log that overlap)",
                rows(back.0),
                back.1
            )));
        }
        if without_time.0 > 0 {
            notes.push(Note::LeftOut(format!(
                "{} without a time, the first in line {}",
                rows(without_time.0),
                without_time.1
            )));
        }
        if same_time > 0 {
            notes.push(Note::Read(format!("{} with the time of the row above", rows(same_time))));
        }
        if usual_nulls.0 > 0 {
            notes.push(Note::Assumed(format!(
                "read as null values, as in many logs, although the head does not declare them: \
                 {} such as {}, the first in line {}",
                values(usual_nulls.0),
                usual_nulls.1,
                usual_nulls.2
            )));
        }
        if bad.0 > 0 {
            notes.push(Note::LeftOut(format!(
                "{} that the logger marks as bad, the first in line {}",
                values(bad.0),
                bad.1
            )));
        }
        if commas.0 > 0 {
            notes.push(Note::Assumed(format!(
                "a comma within a number is read as the decimal sign: {}, the first in line {}",
                values(commas.0),
                commas.1
            )));
        }
        Ok(())
    }
}

fn count((count, first): &mut (u64, u64), line: u64) {
    if *count == 0 {
        *first = line;
    }
    *count += 1;
}

fn rows(count: u64) -> String {
    if count == 1 { "1 row".to_owned() } else { format!("{count} rows") }
}

fn values(count: u64) -> String {
    if count == 1 { "1 value".to_owned() } else { format!("{count} values") }
}
