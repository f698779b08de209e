//! Time of a row.

use wholestring_units::Dimension;

use super::{
    channel::{Chosen, is_no_unit, is_pattern, unit},
    moment::{Moment, Order, has_zone, moment, of_excel, packed_time, time_of_day},
    number::{Marks, is_nothing, marked, number},
    quantity::Quantity,
    record::Row,
};
use crate::{choices::Choices, error::ImportErrorKind, fragment::Note};

/// Format of the times.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    /// A number of units of this many seconds.
    Number { seconds: f64 },
    /// Days in Excel's count.
    Excel,
    /// Date and time of day in one text.
    Moment,
    /// Time of day, with the date in another column or absent.
    OfDay { packed: bool },
}

/// Reads the time of rows.
#[derive(Debug, Clone)]
pub(crate) struct Clock {
    column: usize,
    date: Option<usize>,
    form: Form,
    marks: Marks,
    order: Order,
    /// The date that was read last, as written, and its day: the next row mostly has the same.
    last_date: (Vec<u8>, i64),
    /// Number of midnights passed.
    midnights: i64,
    last_of_day: f64,
    first: Option<Moment>,
    /// Time zone of the times, if written.
    zone: &'static str,
}

impl Clock {
    /// Determines the format of times from the first rows; `None` if the log has no time.
    pub(crate) fn of(
        chosen: &mut Chosen,
        rows: &[Row],
        marks: Marks,
        choices: &Choices,
    ) -> Result<Option<Self>, ImportErrorKind> {
        let Some(column) = chosen.time else { return Ok(None) };
        let cells = || rows.iter().map(|row| row.cell(column)).filter(|cell| !is_nothing(cell));
        let Some(cell) = cells().next() else { return Ok(None) };
        let channel = &chosen.channels[column];
        let (name, written) = (channel.mnemonic.clone(), channel.unit.clone());
        let given_unit = choices.unit_of(&[Quantity::Time.name(), &name], Dimension::Time)?;
        let of_file = unit(Dimension::Time, &written);
        let mut order = Order::DayFirst;
        let zone = if has_zone(cell) { " UTC" } else { "" };
        let mut assume = |text: String| chosen.notes.push(Note::Assumed(text));
        let form = match marked(cell, marks) {
            None if moment(cell, order).is_some() => Form::Moment,
            None if time_of_day(cell).is_some() => Form::OfDay { packed: false },
            None => {
                return Err(ImportErrorKind::Refused(format!(
                    "'{}' in the column {name} is not a time; expected seconds, or a date and \
                     time such as 2021-03-24T12:34:56Z",
                    String::from_utf8_lossy(cell)
                )));
            }
            // This applies with any unit: such a number of days is a date, and no rig logs a
            // thousand rows per second.
            Some(value)
                if is_serial_day(value)
                    && given_unit.or(of_file).is_some_and(|unit| {
                        unit.factor == DAY_S || (unit.factor == 1.0 && are_days(cells(), marks))
                    }) =>
            {
                assume(format!("{name} is taken to be days as Excel counts them"));
                Form::Excel
            }
            // In seconds they would be of the year 17 000: a clock that counts from 1970, under the
            // unit of another.
            Some(value)
                if since_1970(value).is_some_and(|(_, seconds)| seconds < 1.0)
                    && given_unit.or(of_file).is_some_and(|unit| unit.factor == 1.0) =>
            {
                let (name_of_unit, seconds) = since_1970(value).unwrap_or(("seconds", 1.0));
                assume(format!(
                    "{name} is taken to be {name_of_unit} since 1970: its values are too large for \
                     its unit, s"
                ));
                Form::Number { seconds }
            }
            Some(_) if given_unit.is_some() => {
                Form::Number { seconds: given_unit.map_or(1.0, |unit| unit.factor) }
            }
            Some(_) if of_file.is_some() => {
                Form::Number { seconds: of_file.map_or(1.0, |unit| unit.factor) }
            }
            Some(value) if is_no_unit(&written) || is_pattern(&written) => {
                let packed = cells().all(|cell| packed_time(cell).is_some());
                let hours = written.to_ascii_lowercase().starts_with("hh");
                if packed && (hours || chosen.date.is_some()) {
                    if !hours {
                        assume(format!("{name} is taken to be the time of the day as HHMMSS"));
                    }
                    Form::OfDay { packed: true }
                } else if is_serial_day(value)
                    && cells().filter_map(|cell| marked(cell, marks)).any(|day| day.fract() != 0.0)
                {
                    assume(format!("{name} is taken to be days as Excel counts them"));
                    Form::Excel
                } else if let Some((unit, seconds)) = since_1970(value) {
                    assume(format!("{name} is taken to be {unit} since 1970"));
                    Form::Number { seconds }
                } else if name.eq_ignore_ascii_case("seconds") {
                    Form::Number { seconds: 1.0 }
                } else {
                    return Err(ImportErrorKind::MissingUnit {
                        what: format!("time {name}"),
                        name: Quantity::Time.name().to_owned(),
                        dimension: Dimension::Time,
                    });
                }
            }
            Some(_) => {
                return Err(ImportErrorKind::WrongUnit {
                    found: written,
                    dimension: Dimension::Time,
                });
            }
        };
        let date = match form {
            Form::OfDay { .. } => chosen.date,
            _ => None,
        };
        if let Some(date) = date {
            chosen.channels[date].quantity = Some(Quantity::Time);
        }
        let dates: Vec<&[u8]> = match (form, date) {
            (Form::Moment, _) => cells().collect(),
            (_, Some(date)) => rows.iter().map(|row| row.cell(date)).collect(),
            _ => Vec::new(),
        };
        order = day_or_month(&dates, choices)?;
        if date.is_none() && matches!(form, Form::OfDay { .. }) {
            assume(format!(
                "{name} has no date: where it goes back by more than twelve hours a day has passed"
            ));
        }
        let (last_date, midnights, last_of_day) = ((Vec::new(), 0), 0, f64::NEG_INFINITY);
        Ok(Some(Self {
            column,
            date,
            form,
            marks,
            order,
            last_date,
            midnights,
            last_of_day,
            first: None,
            zone,
        }))
    }

    /// Returns the time of a row in seconds since the first row with a time; `None` if it has none.
    ///
    /// # Errors
    /// The cell's text, if it is not a time.
    pub(crate) fn time_s(&mut self, row: &Row) -> Result<Option<f64>, String> {
        let cell = row.cell(self.column);
        // Null values of a numeric column are far below any time.
        let is_null = |value: f64| value < -800.0;
        if is_nothing(cell) || marked(cell, self.marks).is_some_and(is_null) {
            return Ok(None);
        }
        let Some(moment) = self.moment(cell, row) else {
            let mut text = String::from_utf8_lossy(cell).into_owned();
            if let Some(date) = self.date {
                text = format!("{} {text}", String::from_utf8_lossy(row.cell(date)));
            }
            return Err(text);
        };
        let first = *self.first.get_or_insert(moment);
        Ok(Some(moment.since(first)))
    }

    fn moment(&mut self, cell: &[u8], row: &Row) -> Option<Moment> {
        match self.form {
            Form::Number { seconds } => {
                marked(cell, self.marks).map(|value| Moment { day: 0, second: value * seconds })
            }
            Form::Excel => marked(cell, self.marks).filter(|days| days.abs() < 1e6).map(of_excel),
            Form::Moment => moment(cell, self.order).map(|(moment, _)| moment),
            Form::OfDay { packed } => {
                let second = if packed { packed_time(cell)? } else { time_of_day(cell)? };
                let day = match self.date {
                    Some(date) => {
                        let written = row.cell(date);
                        if self.last_date.0 != written {
                            let (moment, _) = moment(written, self.order)?;
                            self.last_date = (written.to_vec(), moment.day);
                        }
                        self.last_date.1
                    }
                    None => {
                        if second < self.last_of_day - 43_200.0 {
                            self.midnights += 1;
                        }
                        self.last_of_day = second;
                        self.midnights
                    }
                };
                Some(Moment { day, second })
            }
        }
    }

    /// Time of the first row, if it is a date.
    pub(crate) fn start(&self) -> Option<String> {
        let first = self.first?;
        match (self.form, self.date) {
            (Form::Moment | Form::Excel, _) | (Form::OfDay { .. }, Some(_)) => {
                Some(format!("{}{}", first.text(), self.zone))
            }
            // Seconds since 1970.
            (Form::Number { .. }, _) if SINCE_1970_S.contains(&first.second) => {
                Some(format!("{} UTC", first.text()))
            }
            _ => None,
        }
    }
}

/// A day, s.
const DAY_S: f64 = 86_400.0;

/// Unit of a number that counts from 1970, in the years 1985 to 2128, and its seconds.
fn since_1970(value: f64) -> Option<(&'static str, f64)> {
    let units = [("seconds", 1.0), ("milliseconds", 1e-3), ("microseconds", 1e-6)];
    units.into_iter().find(|(_, seconds)| SINCE_1970_S.contains(&(value * seconds)))
}

/// Seconds since 1970 of the years 1985 to 2128.
const SINCE_1970_S: std::ops::Range<f64> = 5e8..5e9;

/// Whether a number of days is a date in Excel's count, in the years 1954 to 2119.
fn is_serial_day(value: f64) -> bool {
    (20_000.0..80_000.0).contains(&value)
}

/// Whether numbers increase by less than a thousandth from row to row: fractions of days, not
/// seconds.
fn are_days<'a>(cells: impl Iterator<Item = &'a [u8]>, marks: Marks) -> bool {
    let values: Vec<f64> = cells.filter_map(|cell| marked(cell, marks)).collect();
    let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let mut steps: Vec<f64> = steps.filter(|step| *step > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).is_some_and(|step| *step < 1e-3)
}

/// Order of day and month in dates: from an unambiguous date, or as the user gives it.
fn day_or_month(dates: &[&[u8]], choices: &Choices) -> Result<Order, ImportErrorKind> {
    let mut unsure = None;
    for date in dates {
        match moment(date, Order::DayFirst) {
            Some((_, true)) => unsure = unsure.or(Some(*date)),
            // `13/04/2021` and `04/13/2021` can be read in one way only; they decide for the other
            // dates.
            Some((_, false)) if date.iter().filter(|b| **b == b'/').count() == 2 => {
                let first: Vec<u8> = date.iter().copied().take_while(u8::is_ascii_digit).collect();
                let first = number(&first).unwrap_or(0.0);
                if first > 12.0 && first < 32.0 {
                    return Ok(Order::DayFirst);
                }
                if first <= 12.0 && !is_twice(date) {
                    return Ok(Order::MonthFirst);
                }
            }
            _ => {}
        }
    }
    let Some(date) = unsure else { return Ok(Order::DayFirst) };
    match choices.picked("date") {
        Some("dmy") => Ok(Order::DayFirst),
        Some("mdy") => Ok(Order::MonthFirst),
        Some(other) => Err(ImportErrorKind::NoSuch {
            what: "date".to_owned(),
            name: other.to_owned(),
            names: vec!["dmy".to_owned(), "mdy".to_owned()],
        }),
        None => Err(ImportErrorKind::Refused(format!(
            "the date '{}' may begin with the day or with the month; choose with --pick date=dmy \
             or --pick date=mdy",
            String::from_utf8_lossy(date)
        ))),
    }
}

/// Whether day and month of a date are the same number: `04/04/2021`.
fn is_twice(date: &[u8]) -> bool {
    let mut parts = date.split(|b| *b == b'/').map(|part| number(part).unwrap_or(0.0));
    parts.next() == parts.next()
}
