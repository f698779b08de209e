//! Reading a designation the way people write it.

use super::{
    CatalogueEntry, CatalogueError, PipeClass, TubularKind, coiled, entries,
    parts::{Part, parts},
};

/// Two outside diameters or bores closer than this are the same, in: "5.88 in" is 5-7/8 in.
const DIAMETER_TOLERANCE_IN: f64 = 0.006;
/// Two nominal weights closer than this are the same, lb/ft; those of one size differ by 1.7 or
/// more.
const WEIGHT_TOLERANCE_LB_PER_FT: f64 = 0.15;
/// Two walls of coiled tubing closer than this are the same, in; makers round 0.190 to 0.19 and
/// 0.188.
const WALL_TOLERANCE_IN: f64 = 0.0025;
/// Number of entries that an error lists.
const NEAREST: usize = 4;

/// The entry of a designation.
///
/// Understood are `5-1/2 in 21.90 lb/ft S-135`, `HWDP 5 in 49.3 lb/ft` and
/// `8 in x 2-13/16 in collar`, `CT 2 in x 0.190 in CT-90`, and the usual other spellings:
/// `5 1/2" 21.9 ppf S135`, `5.5 in 21.90# s-135 drill pipe`. Drill pipe may have a class,
/// `5 in 19.50 lb/ft S-135 premium` or `... class 2`. An unknown designation is answered with the
/// nearest entries:
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
    let requested = (designation.len() <= 120).then(|| Reading::of(designation)).flatten();
    let found = entries.iter().find(|entry| {
        let own = Reading::of(&entry.designation);
        requested.as_ref().zip(own).is_some_and(|(requested, own)| own.same(requested))
    });
    match (found, &requested) {
        (Some(found), Some(requested)) if requested.class != PipeClass::New => {
            Ok(found.worn(requested.class))
        }
        (Some(found), _) => Ok(found.clone()),
        (None, _) => Err(unknown(designation, requested.as_ref(), &entries)),
    }
}

/// Ranks by numbers where the designation was understood, by spelling otherwise.
fn unknown(
    designation: &str,
    requested: Option<&Reading>,
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
            let distance = match requested.zip(own) {
                Some((requested, own)) => own.distance(requested),
                None => edit_distance(&spelling, &key(&entry.designation)) as f64,
            };
            (distance, &entry.designation)
        })
        .collect();
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    let of_pipe = requested.filter(|requested| requested.kind == TubularKind::DrillPipe);
    let suffix = of_pipe.map_or("", |of_pipe| of_pipe.class.suffix());
    CatalogueError::Unknown {
        designation: designation.to_owned(),
        nearest: ranked.into_iter().take(NEAREST).map(|(_, name)| name.clone() + suffix).collect(),
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

/// Parts of a designation.
#[derive(Debug, PartialEq)]
struct Reading {
    kind: TubularKind,
    od_in: f64,
    /// Nominal weight in lb/ft, or in inches the bore of a collar or the wall of coiled tubing; of
    /// heavy-weight pipe, whose sizes have one weight each, it may be left out.
    second: Option<f64>,
    /// Letter of the grade, `e`, `x`, `g`, `s`, or `ct90` of coiled tubing.
    grade: Option<String>,
    /// Wear class.
    class: PipeClass,
}

impl Reading {
    fn same(&self, other: &Self) -> bool {
        let tolerance = match self.kind {
            TubularKind::Collar => DIAMETER_TOLERANCE_IN,
            TubularKind::CoiledTubing => WALL_TOLERANCE_IN,
            TubularKind::DrillPipe | TubularKind::HeavyWeight => WEIGHT_TOLERANCE_LB_PER_FT,
        };
        // Drill pipe alone has classes.
        self.kind == other.kind
            && (self.kind == TubularKind::DrillPipe || self.class == other.class)
            && self.grade == other.grade
            && (self.od_in - other.od_in).abs() < DIAMETER_TOLERANCE_IN
            && match (self.second, other.second) {
                (Some(own), Some(requested)) => (own - requested).abs() < tolerance,
                _ => self.kind == TubularKind::HeavyWeight,
            }
    }

    /// Distance between two readings; the outside diameter has the greatest weight.
    fn distance(&self, other: &Self) -> f64 {
        let differs = |differs: bool, by: f64| if differs { by } else { 0.0 };
        differs(self.kind != other.kind, 100.0)
            + 10.0 * (self.od_in - other.od_in).abs()
            + self.second.zip(other.second).map_or(0.0, |(own, requested)| (own - requested).abs())
            + differs(self.grade != other.grade, 0.1)
    }

    /// `None` where a word is not understood, or where there are not exactly two numbers.
    fn of(designation: &str) -> Option<Self> {
        let mut kind = TubularKind::DrillPipe;
        let mut grade = None;
        let mut class = PipeClass::New;
        let mut numbers: Vec<f64> = Vec::new();
        let mut parts = parts(designation).into_iter().peekable();
        while let Some(part) = parts.next() {
            match part {
                Part::Number(number) => numbers.push(number),
                Part::Word(word) => match word.as_str() {
                    "hwdp" | "hw" | "hwt" | "heavy" => kind = TubularKind::HeavyWeight,
                    "collar" | "collars" | "dc" | "dcs" | "nmdc" => kind = TubularKind::Collar,
                    "ct" | "coiled" | "coil" => {
                        kind = TubularKind::CoiledTubing;
                        if let (None, Some(&Part::Number(ksi))) = (&grade, parts.peek())
                            && let Some(name) = coiled::grade(ksi)
                        {
                            grade = Some(name);
                            parts.next();
                        }
                    }
                    "premium" | "prem" => class = PipeClass::Premium,
                    "class" => match parts.next() {
                        Some(Part::Number(2.0)) => class = PipeClass::Class2,
                        _ => return None,
                    },
                    "e" | "x" | "g" | "s" => match (word.as_str(), parts.peek()) {
                        ("e", Some(Part::Number(75.0)))
                        | ("x", Some(Part::Number(95.0)))
                        | ("g", Some(Part::Number(105.0)))
                        | ("s", Some(Part::Number(135.0)))
                            if grade.is_none() =>
                        {
                            grade = Some(word);
                            parts.next();
                        }
                        ("x", _) => {}
                        _ => return None,
                    },
                    "in" | "inch" | "inches" | "lb" | "lbs" | "lbm" | "ft" | "ppf" | "per"
                    | "weight" | "drill" | "pipe" | "dp" | "drillpipe" | "od" | "id" | "bore"
                    | "grade" | "by" | "new" | "tubing" | "tube" | "wall" | "string" => {}
                    _ => return None,
                },
            }
        }
        match numbers[..] {
            [od_in, second] => Some(Self { kind, od_in, second: Some(second), grade, class }),
            [od_in] if kind == TubularKind::HeavyWeight => {
                Some(Self { kind, od_in, second: None, grade, class })
            }
            _ => None,
        }
    }
}

// Finding entries by the words and numbers that describe them.

/// Two numbers closer than this are the same: `5.88` is 5-7/8.
const NUMBER_TOLERANCE: f64 = 0.006;

/// Words that name the unit of a number, which a description need not repeat.
const UNITS: [&str; 10] = ["in", "inch", "inches", "lb", "lbs", "ft", "ppf", "per", "x", "by"];

/// Whether a description has every word and every number that is requested.
///
/// Words count without capitals, and may be cut short; numbers however they are written.
///
/// ```
/// use wholestring::string::catalogue::describes;
///
/// let pipe = "5-1/2 in 21.90 lb/ft S-135 drill pipe";
/// assert!(describes(pipe, "5.5 S135"));
/// assert!(describes(pipe, "drill 5 1/2"));
/// assert!(!describes(pipe, "5"));
/// ```
pub fn describes(description: &str, query: &str) -> bool {
    let own = parts(description);
    parts(query).iter().all(|part| match part {
        Part::Word(word) => {
            UNITS.contains(&word.as_str())
                || own
                    .iter()
                    .any(|own| matches!(own, Part::Word(own) if own.starts_with(word.as_str())))
        }
        Part::Number(number) => own
            .iter()
            .any(|own| matches!(own, Part::Number(own) if (own - number).abs() < NUMBER_TOLERANCE)),
    })
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
            ("5-1/2\" 21.90# s-135 drill pipe", "5-1/2 in 21.90 lb/ft S-135"),
            ("5 in 19.5 lb/ft G 105", "5 in 19.50 lb/ft G-105"),
            ("5in. 19.50 lbs/ft E75", "5 in 19.50 lb/ft E-75"),
            ("4 in 14 lb/ft X-95", "4 in 14.00 lb/ft X-95"),
            ("5-7/8 in 26.40 lb/ft S-135", "5-7/8 in 26.30 lb/ft S-135"),
            ("HWDP 5 in 49.3 lb/ft", "HWDP 5 in 49.3 lb/ft"),
            ("5\" hwdp 49.3 ppf", "HWDP 5 in 49.3 lb/ft"),
            ("5\" HWDP", "HWDP 5 in 49.3 lb/ft"),
            ("5 1/2 in heavy weight", "HWDP 5-1/2 in 57.0 lb/ft"),
            ("DP 5 in 19.5 lb/ft G105", "5 in 19.50 lb/ft G-105"),
            ("drillpipe 5\" 19.5# S135", "5 in 19.50 lb/ft S-135"),
            ("6-1/2 in DC 2-13/16 in", "6-1/2 in x 2-13/16 in collar"),
            ("heavy-weight drill pipe 5-1/2 in 57 lb/ft", "HWDP 5-1/2 in 57.0 lb/ft"),
            ("8 in x 2-13/16 in collar", "8 in x 2-13/16 in collar"),
            ("drill collar 8\" × 2 13/16\"", "8 in x 2-13/16 in collar"),
            ("DC 6.5 x 2.8125", "6-1/2 in x 2-13/16 in collar"),
            ("5 in 19.50 lb/ft S-135 premium", "5 in 19.50 lb/ft S-135 premium"),
            ("premium 5\" 19.5# S135", "5 in 19.50 lb/ft S-135 premium"),
            ("5 in 19.5 ppf G-105 Class 2", "5 in 19.50 lb/ft G-105 class 2"),
            ("new 5 in 19.5 ppf G-105", "5 in 19.50 lb/ft G-105"),
            ("CT 2 in x 0.190 in CT-90", "CT 2 in x 0.190 in CT-90"),
            ("coiled tubing 2\" 0.188 wall CT90", "CT 2 in x 0.190 in CT-90"),
            ("2-3/8 in x .204 CT 110", "CT 2-3/8 in x 0.204 in CT-110"),
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
        assert_eq!(nearest("5-1/2 in 21.90 lb/ft")[0], "5-1/2 in 21.90 lb/ft E-75");
        assert_eq!(nearest("5 in 19.50 lb/ft S-140")[0], "5 in 19.50 lb/ft S-135");
        assert_eq!(nearest("5 in 19.9 lb/ft S-135 premium")[0], "5 in 19.50 lb/ft S-135 premium");
        // Other tubulars have no class.
        assert_eq!(nearest("HWDP 5 in 49.3 lb/ft premium")[0], "HWDP 5 in 49.3 lb/ft");
        assert_eq!(nearest("CT 2 in x 0.19 in CT-95")[0], "CT 2 in x 0.190 in CT-90");
        assert_eq!(nearest("HWDP 5 in 44 lb/ft")[0], "HWDP 5 in 49.3 lb/ft");
        assert_eq!(nearest("8 in x 2-7/8 in collar")[0], "8 in x 2-13/16 in collar");
        // The light weights are made in E-75 alone.
        assert_eq!(nearest("5 in 16.25 lb/ft S-135").len(), NEAREST);
        for nonsense in [
            "",
            " ",
            "pipe",
            "class",
            "class 3 5 in 19.5 lb/ft S-135",
            "CT",
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
