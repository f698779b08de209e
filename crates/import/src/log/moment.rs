//! Dates and times of day, as logs write them.

/// A point in time: days since 1970-01-01 and seconds of the day, in UTC if a zone is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Moment {
    pub(crate) day: i64,
    pub(crate) second: f64,
}

impl Moment {
    /// Seconds from another moment to this one.
    pub(crate) fn since(self, other: Moment) -> f64 {
        (self.day - other.day) as f64 * 86_400.0 + (self.second - other.second)
    }

    /// ISO 8601 text with a space between date and time.
    pub(crate) fn text(self) -> String {
        let shift = (self.second / 86_400.0).floor();
        let (year, month, day) = civil(self.day + shift as i64);
        let second = self.second - shift * 86_400.0;
        let whole = second as u32;
        let (hour, minute, rest) =
            (whole / 3600, whole / 60 % 60, second - f64::from(whole / 60 * 60));
        let rest = if rest.fract() == 0.0 { format!("{rest:02}") } else { format!("{rest:06.3}") };
        format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{rest}")
    }
}

/// Which of the first two numbers of `03/04/2021` is the day.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    DayFirst,
    MonthFirst,
}

/// Parses a date: its day, and whether its first two numbers might be in the other order.
pub(crate) fn date(text: &[u8], order: Order) -> Option<(i64, bool)> {
    let parted = |b: &u8| matches!(b, b'-' | b'/' | b'.' | b' ');
    let sign = text.iter().copied().find(|b| parted(b));
    let Some(sign) = sign else {
        // 20210324, or 210324 as in WITS.
        let value = digits(text)?;
        let (year, rest) = (value / 10_000, value % 10_000);
        let year = match text.len() {
            8 => year,
            6 => century(year),
            _ => return None,
        };
        return Some((day_of(year, rest / 100, rest % 100)?, false));
    };
    let mut parts = text.split(|b| *b == sign);
    let (first, second, third) = (parts.next()?, parts.next()?, parts.next()?);
    if parts.next().is_some() {
        return None;
    }
    let year = |part: &[u8]| match part.len() {
        4 => digits(part),
        2 => digits(part).map(century),
        _ => None,
    };
    if let Some(month) = month(second) {
        let (y, d) = if first.len() == 4 { (first, third) } else { (third, first) };
        return Some((day_of(year(y)?, month, digits(d)?)?, false));
    }
    if first.len() == 4 {
        return Some((day_of(year(first)?, digits(second)?, digits(third)?)?, false));
    }
    let (one, two, year) = (digits(first)?, digits(second)?, year(third)?);
    // Points separate dates only where the day is first.
    let both = one <= 12 && two <= 12 && one != two && sign != b'.';
    let day_first = sign == b'.' || one > 12 || (both || one == two) && order == Order::DayFirst;
    let (day, month) = if day_first { (one, two) } else { (two, one) };
    Some((day_of(year, month, day)?, both))
}

/// Parses a time of day with its zone: seconds of the day in UTC, or as written without a zone.
pub(crate) fn time_of_day(text: &[u8]) -> Option<f64> {
    let mut text = text.trim_ascii();
    let mut shift = 0.0;
    let mut noon = None;
    if let Some(rest) = strip_end(text, b"UTC").or_else(|| strip_end(text, b"Z")) {
        text = rest.trim_ascii_end();
    } else if let Some(rest) = strip_end(text, b"AM") {
        (text, noon) = (rest.trim_ascii_end(), Some(false));
    } else if let Some(rest) = strip_end(text, b"PM") {
        (text, noon) = (rest.trim_ascii_end(), Some(true));
    } else if let Some(at) = text.iter().rposition(|b| matches!(b, b'+' | b'-')) {
        let zone: Vec<u8> = text[at + 1..].iter().copied().filter(|b| *b != b':').collect();
        let value = digits(&zone)?;
        let (hours, minutes) = match zone.len() {
            2 => (value, 0),
            4 => (value / 100, value % 100),
            _ => return None,
        };
        let seconds = (hours * 3600 + minutes * 60) as f64;
        shift = if text[at] == b'+' { -seconds } else { seconds };
        text = text[..at].trim_ascii_end();
    }
    let mut parts = text.split(|b| *b == b':');
    let mut hour = digits(parts.next()?)?;
    let minute = digits(parts.next()?)?;
    let second = match parts.next() {
        // ISO 8601 also allows a comma before the fraction.
        Some(part) if part.first().is_some_and(u8::is_ascii_digit) => {
            super::number::marked(part, super::number::Marks::Either)?
        }
        Some(_) => return None,
        None => 0.0,
    };
    match noon {
        Some(_) if !(1..=12).contains(&hour) => return None,
        Some(after) => hour = hour % 12 + if after { 12 } else { 0 },
        None => {}
    }
    if parts.next().is_some() || hour > 24 || minute > 59 || !(0.0..61.0).contains(&second) {
        return None;
    }
    Some((hour * 3600 + minute * 60) as f64 + second + shift)
}

/// Parses `123456` as a time of day: 12:34:56.
pub(crate) fn packed_time(text: &[u8]) -> Option<f64> {
    let whole = text.split(|b| *b == b'.').next()?;
    if !(1..=6).contains(&whole.len()) {
        return None;
    }
    let value = digits(whole)?;
    let (hour, minute, second) = (value / 10_000, value / 100 % 100, value % 100);
    let valid = hour < 24 && minute < 60 && second < 60;
    let fraction = super::number::number(text)?.fract();
    valid.then(|| (hour * 3600 + minute * 60 + second) as f64 + fraction)
}

/// Parses date and time of day in one text, and whether day and month might be in the other order.
pub(crate) fn moment(text: &[u8], order: Order) -> Option<(Moment, bool)> {
    // 2021-03-24T12:34:56.
    if let Some((&[y1, y2, y3, y4, b'-', m1, m2, b'-', d1, d2], rest)) = text.split_first_chunk()
        && let Some((b'T' | b' ', time)) = rest.split_first()
    {
        let year = digits(&[y1, y2, y3, y4])?;
        let day = day_of(year, digits(&[m1, m2])?, digits(&[d1, d2])?)?;
        return Some((Moment { day, second: time_of_day(time)? }, false));
    }
    // The date ends before the time's hour.
    let colon = text.iter().position(|b| *b == b':');
    let Some(colon) = colon else {
        let (day, both) = date(text, order)?;
        return Some((Moment { day, second: 0.0 }, both));
    };
    let hour = text[..colon].iter().rposition(|b| !b.is_ascii_digit())?;
    let (day, both) = date(text[..hour].trim_ascii(), order)?;
    let parted = matches!(text[hour], b'T' | b't' | b' ' | b'_');
    let second = parted.then(|| time_of_day(&text[hour + 1..])).flatten()?;
    Some((Moment { day, second }, both))
}

/// Whether a text of a moment includes a time zone, so that it is read as UTC.
pub(crate) fn has_zone(text: &[u8]) -> bool {
    let time = text.iter().position(|b| *b == b':').map_or(&[][..], |at| &text[at..]);
    time.iter().any(|b| matches!(b, b'Z' | b'z' | b'+' | b'-' | b'C' | b'c'))
}

/// Converts Excel's count of days to a moment.
pub(crate) fn of_excel(days: f64) -> Moment {
    // Day 25569 of its calendar is 1970-01-01.
    let day = days.floor();
    // Excel's seconds are whole except for rounding.
    let second = ((days - day) * 86_400_000.0).round() / 1000.0;
    Moment { day: day as i64 - 25_569, second }
}

fn strip_end<'a>(text: &'a [u8], end: &[u8]) -> Option<&'a [u8]> {
    let at = text.len().checked_sub(end.len())?;
    text[at..].eq_ignore_ascii_case(end).then(|| &text[..at])
}

fn century(year: i64) -> i64 {
    if year < 70 { 2000 + year } else { 1900 + year }
}

fn digits(text: &[u8]) -> Option<i64> {
    let valid = !text.is_empty() && text.len() <= 8 && text.iter().all(u8::is_ascii_digit);
    valid.then(|| text.iter().fold(0, |value, digit| value * 10 + i64::from(digit - b'0')))
}

fn month(text: &[u8]) -> Option<i64> {
    const MONTHS: [&[u8]; 12] = [
        b"jan", b"feb", b"mar", b"apr", b"may", b"jun", b"jul", b"aug", b"sep", b"oct", b"nov",
        b"dec",
    ];
    let short = text.get(..3)?;
    let found = MONTHS.iter().position(|month| short.eq_ignore_ascii_case(month))?;
    text.iter().all(u8::is_ascii_alphabetic).then_some(found as i64 + 1)
}

/// Days since 1970-01-01 of a date of the Gregorian calendar; `None` for an impossible date.
fn day_of(year: i64, month: i64, day: i64) -> Option<i64> {
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let length = match month {
        2 => 28 + i64::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if !(1..=length).contains(&day) || !(1900..=2200).contains(&year) {
        return None;
    }
    // Years begin in March, so that the leap day is the last one.
    let (years, months) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let days =
        365 * years + years / 4 - years / 100 + years / 400 + (153 * months + 2) / 5 + day - 1;
    Some(days - 719_468)
}

/// Year, month and day of a number of days since 1970-01-01.
fn civil(day: i64) -> (i64, i64, i64) {
    let days = day + 719_468;
    let era = days.div_euclid(146_097);
    let of_era = days.rem_euclid(146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let months = (5 * of_year + 2) / 153;
    let month = if months < 10 { months + 3 } else { months - 9 };
    let day = of_year - (153 * months + 2) / 5 + 1;
    (year + era * 400 + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::{Moment, Order, date, day_of, moment, of_excel, packed_time, time_of_day};

    #[test]
    fn dates_of_logs_are_read() {
        let expected = "2021-03-24 12:34:56";
        for text in [
            "2021-03-24T12:34:56Z",
            "2021-03-24T12:34:56",
            "2021-03-24 12:34:56",
            "2021-03-24T14:34:56+02:00",
            "2021-03-24T12:34:56.000Z",
            "2021/03/24 12:34:56",
            "24-Mar-2021 12:34:56",
            "24/Mar/21 12:34:56",
            "24/03/2021 12:34:56",
            "3/24/2021 12:34:56 PM",
            "24.03.2021 12:34:56",
            "20210324T12:34:56",
        ] {
            let read = moment(text.as_bytes(), Order::MonthFirst);
            assert_eq!(read.map(|(at, _)| at.text()), Some(expected.to_owned()), "{text}");
        }
        for text in ["2021-02-29T00:00:00", "24 March", "12030.5", "2021-03-24T25:61:00", "x", ""] {
            assert_eq!(moment(text.as_bytes(), Order::DayFirst), None, "{text}");
        }
    }

    #[test]
    fn a_date_of_small_numbers_may_be_either_way() {
        let read = |text: &[u8], order| date(text, order);
        assert_eq!(read(b"03/04/2021", Order::DayFirst), day_of(2021, 4, 3).map(|d| (d, true)));
        assert_eq!(read(b"03/04/2021", Order::MonthFirst), day_of(2021, 3, 4).map(|d| (d, true)));
        assert_eq!(read(b"13/04/2021", Order::MonthFirst), day_of(2021, 4, 13).map(|d| (d, false)));
        assert_eq!(read(b"03.04.2021", Order::MonthFirst), day_of(2021, 4, 3).map(|d| (d, false)));
        assert_eq!(read(b"210403", Order::MonthFirst), day_of(2021, 4, 3).map(|d| (d, false)));
    }

    #[test]
    fn times_of_the_day_are_read() {
        assert_eq!(time_of_day(b"00:00:01,5"), Some(1.5));
        assert_eq!(time_of_day(b"12:00 AM"), Some(0.0));
        assert_eq!(packed_time(b"123456"), Some(45_296.0));
        assert_eq!(packed_time(b"56"), Some(56.0));
        assert_eq!(packed_time(b"126956"), None);
    }

    #[test]
    fn every_day_is_written_as_it_was_read() {
        for day in (-20_000..40_000).step_by(17) {
            let text = Moment { day, second: 0.0 }.text();
            assert_eq!(moment(text.as_bytes(), Order::DayFirst).map(|(at, _)| at.day), Some(day));
        }
        assert_eq!(of_excel(44_279.5).text(), "2021-03-24 12:00:00");
    }
}
