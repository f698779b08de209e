//! Reading a designation the way people write it.

use super::{CatalogueEntry, CatalogueError, TubularKind, entries};

/// Two outside diameters or bores closer than this are the same, in: "5.88 in" is 5-7/8 in.
const DIAMETER_TOLERANCE_IN: f64 = 0.006;
/// Two nominal weights closer than this are the same, lb/ft; those of one size differ by 1.7 or more.
const WEIGHT_TOLERANCE_LB_PER_FT: f64 = 0.15;
/// How many entries an error names.
const NEAREST: usize = 4;

/// The entry of a designation.
///
/// Understood are `5-1/2 in 21.90 lb/ft S-135`, `HWDP 5 in 49.3 lb/ft` and `8 in x 2-13/16 in collar`,
/// and the usual other spellings: `5 1/2" 21.9 ppf S135`, `5.5 in 21.90# s-135 drill pipe`. An unknown
/// designation is answered with the nearest entries:
///
/// ```
/// use wholestring::string::catalogue;
///
/// let pipe = catalogue::find("5 1/2\" 21.9 ppf S135")?;
/// assert_eq!(pipe.designation, "5-1/2 in 21.90 lb/ft S-135");
///
/// let error = catalogue::find("5-1/2 in 21.90 lb/ft S-130").unwrap_err();
/// assert!(error.to_string().starts_with(
///     "the catalogue has no `5-1/2 in 21.90 lb/ft S-130`; the nearest entries are \
///      `5-1/2 in 21.90 lb/ft S-135`"
/// ));
/// # Ok::<(), catalogue::CatalogueError>(())
/// ```
pub fn find(designation: &str) -> Result<CatalogueEntry, CatalogueError> {
    let entries = entries();
    // Text longer than any spelling of a tubular is not read.
    let asked = (designation.len() <= 120)
        .then(|| Reading::of(designation))
        .flatten();
    let found = entries.iter().find(|entry| {
        let own = Reading::of(&entry.designation);
        asked
            .as_ref()
            .zip(own)
            .is_some_and(|(asked, own)| own.same(asked))
    });
    found
        .cloned()
        .ok_or_else(|| unknown(designation, asked.as_ref(), &entries))
}

/// Ranks by numbers where the designation was understood, by spelling otherwise.
fn unknown(
    designation: &str,
    asked: Option<&Reading>,
    entries: &[CatalogueEntry],
) -> CatalogueError {
    let key = |text: &str| -> Vec<char> {
        text.chars()
            .filter(|c| c.is_alphanumeric() || *c == '.' || *c == '/')
            .flat_map(char::to_lowercase)
            .take(60)
            .collect()
    };
    let spelling = key(designation);
    let mut ranked: Vec<(f64, &String)> = entries
        .iter()
        .map(|entry| {
            let own = Reading::of(&entry.designation);
            let distance = match asked.zip(own) {
                Some((asked, own)) => own.distance(asked),
                None => edit_distance(&spelling, &key(&entry.designation)) as f64,
            };
            (distance, &entry.designation)
        })
        .collect();
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    CatalogueError::Unknown {
        designation: designation.to_owned(),
        nearest: ranked
            .into_iter()
            .take(NEAREST)
            .map(|(_, name)| name.clone())
            .collect(),
    }
}

/// Levenshtein's distance.
fn edit_distance(a: &[char], b: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// What a designation says.
#[derive(Debug, PartialEq)]
struct Reading {
    kind: TubularKind,
    od_in: f64,
    /// Nominal weight in lb/ft, or the bore of a collar in inches.
    second: f64,
    /// Letter of the grade: `e`, `x`, `g`, `s`.
    grade: Option<String>,
}

impl Reading {
    fn same(&self, other: &Self) -> bool {
        let tolerance = match self.kind {
            TubularKind::Collar => DIAMETER_TOLERANCE_IN,
            TubularKind::DrillPipe | TubularKind::HeavyWeight => WEIGHT_TOLERANCE_LB_PER_FT,
        };
        self.kind == other.kind
            && self.grade == other.grade
            && (self.od_in - other.od_in).abs() < DIAMETER_TOLERANCE_IN
            && (self.second - other.second).abs() < tolerance
    }

    /// How far apart two readings are; the outside diameter counts most.
    fn distance(&self, other: &Self) -> f64 {
        let differs = |differs: bool, by: f64| if differs { by } else { 0.0 };
        differs(self.kind != other.kind, 100.0)
            + 10.0 * (self.od_in - other.od_in).abs()
            + (self.second - other.second).abs()
            + differs(self.grade != other.grade, 0.1)
    }

    /// `None` where a word is not understood, or where there are not exactly two numbers.
    fn of(designation: &str) -> Option<Self> {
        let mut kind = TubularKind::DrillPipe;
        let mut grade = None;
        let mut numbers: Vec<f64> = Vec::new();
        let mut tokens = tokens(designation).into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                Token::Whole(whole) => {
                    // "5-1/2" and "5 1/2"
                    if let Some(Token::Fraction(part)) = tokens.peek() {
                        numbers.push(whole + part);
                        tokens.next();
                    } else {
                        numbers.push(whole);
                    }
                }
                Token::Decimal(number) | Token::Fraction(number) => numbers.push(number),
                Token::Word(word) => match word.as_str() {
                    "hwdp" | "hw" | "heavy" => kind = TubularKind::HeavyWeight,
                    "collar" | "collars" | "dc" => kind = TubularKind::Collar,
                    "e" | "x" | "g" | "s" => match (word.as_str(), tokens.peek()) {
                        ("e", Some(Token::Whole(75.0)))
                        | ("x", Some(Token::Whole(95.0)))
                        | ("g", Some(Token::Whole(105.0)))
                        | ("s", Some(Token::Whole(135.0)))
                            if grade.is_none() =>
                        {
                            grade = Some(word);
                            tokens.next();
                        }
                        ("x", _) => {}
                        _ => return None,
                    },
                    "in" | "inch" | "inches" | "lb" | "lbs" | "lbm" | "ft" | "ppf" | "per"
                    | "weight" | "drill" | "pipe" | "dp" | "od" | "id" | "bore" | "grade"
                    | "by" => {}
                    _ => return None,
                },
            }
        }
        match numbers[..] {
            [od_in, second] => Some(Self {
                kind,
                od_in,
                second,
                grade,
            }),
            _ => None,
        }
    }
}

#[derive(Debug, PartialEq)]
enum Token {
    Whole(f64),
    Decimal(f64),
    Fraction(f64),
    Word(String),
}

/// Words and numbers; hyphens, quotes, slashes between words and `#` separate them.
fn tokens(text: &str) -> Vec<Token> {
    let chars: Vec<char> = text.chars().flat_map(char::to_lowercase).collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    let run = |from: usize, accept: &dyn Fn(char) -> bool| {
        chars[from..].iter().take_while(|&&c| accept(c)).count()
    };
    while at < chars.len() {
        let c = chars[at];
        if c.is_ascii_digit() || (c == '.' && chars.get(at + 1).is_some_and(char::is_ascii_digit)) {
            let length = run(at, &|c| c.is_ascii_digit() || c == '.');
            let number: String = chars[at..at + length].iter().collect();
            at += length;
            let is_fraction =
                chars.get(at) == Some(&'/') && chars.get(at + 1).is_some_and(char::is_ascii_digit);
            let value: Option<f64> = number.parse().ok();
            if is_fraction {
                let length = run(at + 1, &|c| c.is_ascii_digit());
                let below: String = chars[at + 1..at + 1 + length].iter().collect();
                at += 1 + length;
                match (value, below.parse::<f64>()) {
                    (Some(above), Ok(below)) if below > 0.0 => {
                        tokens.push(Token::Fraction(above / below));
                    }
                    _ => tokens.push(Token::Word(number)),
                }
            } else {
                tokens.push(match value {
                    Some(value) if number.contains('.') => Token::Decimal(value),
                    Some(value) => Token::Whole(value),
                    None => Token::Word(number),
                });
            }
        } else if c.is_alphabetic() {
            let length = run(at, &char::is_alphabetic);
            tokens.push(Token::Word(chars[at..at + length].iter().collect()));
            at += length;
        } else {
            match c {
                '×' => tokens.push(Token::Word("x".into())),
                '"' | '″' | '”' | '#' | '-' | '–' | '/' | '.' | ',' | ';' | '(' | ')' => {}
                c if c.is_whitespace() => {}
                other => tokens.push(Token::Word(other.into())),
            }
            at += 1;
        }
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_spellings_are_understood() {
        for (spelling, designation) in [
            ("5-1/2 in 21.90 lb/ft S-135", "5-1/2 in 21.90 lb/ft S-135"),
            ("5 1/2\" 21.9 ppf S135", "5-1/2 in 21.90 lb/ft S-135"),
            ("5.5 in 21.90 lb/ft S-135", "5-1/2 in 21.90 lb/ft S-135"),
            (
                "5-1/2\" 21.90# s-135 drill pipe",
                "5-1/2 in 21.90 lb/ft S-135",
            ),
            ("5 in 19.5 lb/ft G 105", "5 in 19.50 lb/ft G-105"),
            ("5in. 19.50 lbs/ft E75", "5 in 19.50 lb/ft E-75"),
            ("4 in 14 lb/ft X-95", "4 in 14.00 lb/ft X-95"),
            ("5-7/8 in 26.40 lb/ft S-135", "5-7/8 in 26.30 lb/ft S-135"),
            ("HWDP 5 in 49.3 lb/ft", "HWDP 5 in 49.3 lb/ft"),
            ("5\" hwdp 49.3 ppf", "HWDP 5 in 49.3 lb/ft"),
            (
                "heavy-weight drill pipe 5-1/2 in 57 lb/ft",
                "HWDP 5-1/2 in 57.0 lb/ft",
            ),
            ("8 in x 2-13/16 in collar", "8 in x 2-13/16 in collar"),
            ("drill collar 8\" × 2 13/16\"", "8 in x 2-13/16 in collar"),
            ("DC 6.5 x 2.8125", "6-1/2 in x 2-13/16 in collar"),
        ] {
            let found = find(spelling).map(|entry| entry.designation);
            assert_eq!(found.as_deref(), Ok(designation), "{spelling}");
        }
    }

    #[test]
    fn every_entry_is_found_by_its_own_name_and_by_no_other() {
        for entry in entries() {
            assert_eq!(find(&entry.designation).as_ref(), Ok(&entry));
        }
    }

    #[test]
    fn unknown_ones_name_the_nearest() {
        let nearest = |designation: &str| match find(designation) {
            Err(CatalogueError::Unknown { nearest, .. }) => nearest,
            Ok(entry) => panic!("{designation} is {}", entry.designation),
        };
        assert_eq!(
            nearest("5-1/2 in 21.90 lb/ft")[0],
            "5-1/2 in 21.90 lb/ft E-75"
        );
        assert_eq!(
            nearest("5 in 19.50 lb/ft S-140")[0],
            "5 in 19.50 lb/ft S-135"
        );
        assert_eq!(nearest("HWDP 5 in 44 lb/ft")[0], "HWDP 5 in 49.3 lb/ft");
        assert_eq!(
            nearest("8 in x 2-7/8 in collar")[0],
            "8 in x 2-13/16 in collar"
        );
        // The light weights are made in E-75 alone.
        assert_eq!(nearest("5 in 16.25 lb/ft S-135").len(), NEAREST);
        for nonsense in [
            "",
            " ",
            "pipe",
            "5//0 in 3",
            "1/0 in 2",
            "1.2.3 in",
            "½",
            "\u{130}",
            "139.7 mm S-135",
        ] {
            assert_eq!(nearest(nonsense).len(), NEAREST, "{nonsense}");
        }
        assert_eq!(nearest(&"5 ".repeat(100_000)).len(), NEAREST);
    }
}
