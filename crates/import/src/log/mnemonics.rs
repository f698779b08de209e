//! Names of known channels.
//!
//! Names of four letters are the long mnemonics of WITS level 0, record 1 (general time-based). The
//! list also has its item numbers (`0108`) and the words that recorders print.

use std::{collections::HashMap, sync::LazyLock};

use super::quantity::Quantity::{self, *};

/// Quality of a name's match: of two channels for one quantity the lower one is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// By position, not by name.
    Index,
    Average,
    Plain,
    /// A name that may have another meaning if a better one is present: `DEPT`.
    Loose,
    Greatest,
    Least,
}

impl Rank {
    /// Explanation in a sentence, after the channel's name.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Rank::Index => "the index",
            Rank::Average => "the average",
            Rank::Plain => "the value",
            Rank::Loose => "a depth",
            Rank::Greatest => "the greatest",
            Rank::Least => "the least",
        }
    }
}

/// Names reduced to lower-case letters and digits.
const NAMES: &[(Quantity, Rank, &str)] = &[
    (
        Time,
        Rank::Plain,
        "time datetime timestamp dateandtime datetimeutc timeutc utc rigtime etim elapsedtime \
         timeelapsed dtim logtime localtime datetimelocal yyyymmddhhmmss hhmmss 0106 timehhmmss \
         timeofday datatime timeindex timedate rtime indextime seconds unixtime epoch epochtime \
         unixtimestamp timeunix posixtime",
    ),
    (
        BitDepth,
        Rank::Plain,
        "dbtm bitdepth bitdep bitdpt bdep bdepth bitmd mdbit depthbit bitpos bitposition \
         bitmeasureddepth depthbitmeas depthbitmeasured deptbit dbit depbit bitdepthmd mdofbit \
         depthofbit bitdepthmeasured 0108",
    ),
    (
        HoleDepth,
        Rank::Plain,
        "dmea holedepth hdep hdepth hdth holedep depthhole depthholemeas depthholemeasured depmeas \
         holemd mdhole holemeasureddepth measureddepthofhole holedepthmd totaldepth 0110",
    ),
    (HoleDepth, Rank::Loose, "dept depth md mdepth measureddepth mddepth depthmd"),
    (
        BlockPosition,
        Rank::Plain,
        "bpos blkpos bkpos blockposition blockpos blockheight blkht blkhgt blockhgt tbpos \
         travellingblockposition travelingblockposition travellingblock travelingblock hookposition \
         blockcomp blkcomp bposcomp blockposcomp blockpositioncompensated blockheightcompensated \
         hkpos hookheight hkht hkh blockelevation 0112",
    ),
    (HookLoad, Rank::Average, "hkla hklav hkldav hookloadav 0114"),
    (
        HookLoad,
        Rank::Plain,
        "hkld hkl hookload hookld hkload hld who woh weightonhook hookweight hkwt hkli hoisthookload",
    ),
    (HookLoad, Rank::Greatest, "hklx 0115"),
    (HookLoad, Rank::Least, "hkln"),
    (WeightOnBit, Rank::Average, "woba wobav 0116"),
    (
        WeightOnBit,
        Rank::Plain,
        "wob swob weightonbit bitweight surfacewob wobsurface surfwob wobs weightonbitsurface \
         surfaceweightonbit",
    ),
    (WeightOnBit, Rank::Greatest, "wobx 0117"),
    (Torque, Rank::Average, "tqa torqa tqav 0118"),
    (
        Torque,
        Rank::Plain,
        "tq torque trq torq stor surfacetorque rotarytorque rottorque topdrivetorque tdtorque tdtq \
         surftq tqsurf stq rtq tdstorque surfacetq torquesurface rotarytrq",
    ),
    (Torque, Rank::Greatest, "tqx torqx 0119"),
    (RotarySpeed, Rank::Average, "rpma rpmav 0120"),
    (
        RotarySpeed,
        Rank::Plain,
        "rpm surfrpm rpms surfacerpm rotaryrpm rotaryspeed topdriverpm tdrpm rotrpm rpmsurf srpm \
         rotarytablerpm rotaryspeedsurface surfacerotaryspeed tdsrpm rpmsurface stringrpm rotary",
    ),
    (RotarySpeed, Rank::Greatest, "rpmx"),
    (FlowRate, Rank::Average, "mfia 0130"),
    (
        FlowRate,
        Rank::Plain,
        "tflo mfi flwi flowin flowrate flowratein mudflowin flowpumps totalpumpoutput pumpoutput \
         flwpmps mudflowrate mudflowratein flin flowinrate pumpflow totalflow totalpumpflow fli \
         mudflowinrate totalflowin flowinpumps pumprate",
    ),
    (StandpipePressure, Rank::Average, "sppa sppav 0121"),
    (
        StandpipePressure,
        Rank::Plain,
        "spp standpipepressure standpipe sppr stpp pumppressure pumppress standpipepress \
         circulatingpressure stdppress",
    ),
    (StandpipePressure, Rank::Greatest, "sppx"),
];

/// The same, indexed by name, because every cell of a possible heading is looked up.
static QUANTITIES: LazyLock<HashMap<&'static str, (Quantity, Rank)>> = LazyLock::new(|| {
    let each = |&(quantity, rank, names): &(Quantity, Rank, &'static str)| {
        names.split_ascii_whitespace().map(move |name| (name, (quantity, rank)))
    };
    NAMES.iter().flat_map(each).collect()
});

/// Columns of a date that accompanies one of the time of day.
const DATES: &str =
    "date yyyymmdd ddmmyyyy mmddyyyy yymmdd ddmmyy mmddyy 0105 logdate dateutc rigdate";

/// Headings of a table of readings, which is not a log.
const READINGS: &str = "pickup pickupweight puw pu pickuphookload slackoff slackoffweight sow so \
    rotatingweight rotating rob robweight freerotating freerotatingweight";

/// The quantity of a name.
pub(crate) fn quantity(name: &str) -> Option<(Quantity, Rank)> {
    if name.len() > 80 || is_number(name) {
        return None;
    }
    let mut words = words(name);
    // `GS_HKLD`: a prefix of the service company.
    if words.len() > 1 && words[0] == "gs" {
        words.remove(0);
    }
    let whole = words.concat();
    if let Some(found) = find(&whole) {
        return Some(found);
    }
    // `RPM30s`: an average over half a minute.
    if let Some((quantity, Rank::Plain)) = over_a_time(&whole).and_then(find) {
        return Some((quantity, Rank::Average));
    }
    // "Avg TQ", "Hook Load (max)", "HKLD_MIN".
    let qualifier = |word: &String| match word.as_str() {
        "avg" | "average" | "mean" | "av" => Some(Rank::Average),
        "max" | "maximum" | "peak" => Some(Rank::Greatest),
        "min" | "minimum" => Some(Rank::Least),
        _ => None,
    };
    let mut qualifiers = words.iter().filter_map(qualifier);
    let (Some(rank), None) = (qualifiers.next(), qualifiers.next()) else { return None };
    let rest: String =
        words.iter().filter(|word| qualifier(word).is_none()).map(String::as_str).collect();
    let (quantity, found) = find(&rest)?;
    (found == Rank::Plain).then_some((quantity, rank))
}

/// The name before the averaging time: `rpm` of `rpm30s`.
fn over_a_time(squeezed: &str) -> Option<&str> {
    let rest = ["sec", "min", "s"].iter().find_map(|unit| squeezed.strip_suffix(unit))?;
    let name = rest.trim_end_matches(|c: char| c.is_ascii_digit());
    (name.len() < rest.len()).then_some(name)
}

/// Whether a name means a date.
pub(crate) fn is_date(name: &str) -> bool {
    !is_number(name) && is_of(DATES, &words(name).concat())
}

/// Whether a name is that of a reading taken from a log by hand.
pub(crate) fn is_reading(name: &str) -> bool {
    is_of(READINGS, &words(name).concat())
}

/// Whether it is a number other than an item of WITS, which has four digits; most cells are.
fn is_number(name: &str) -> bool {
    name.len() != 4 && !name.contains(char::is_alphabetic)
}

fn find(squeezed: &str) -> Option<(Quantity, Rank)> {
    QUANTITIES.get(squeezed).copied()
}

fn is_of(names: &str, squeezed: &str) -> bool {
    !squeezed.is_empty() && names.split_ascii_whitespace().any(|name| name == squeezed)
}

/// Words of a name in lower case: `hookLoadAvg` has three.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in name.chars() {
        if c.is_alphanumeric() {
            let begins = !before.is_alphanumeric() || (before.is_lowercase() && c.is_uppercase());
            match words.last_mut() {
                Some(word) if !begins => word.extend(c.to_lowercase()),
                _ => words.push(c.to_lowercase().collect()),
            }
        }
        before = c;
    }
    words
}

#[cfg(test)]
mod tests {
    use super::{NAMES, Quantity, Rank, is_reading, quantity};

    #[test]
    fn names_of_recorders_are_known() {
        for (name, expected) in [
            ("HKLA", Some((Quantity::HookLoad, Rank::Average))),
            ("HKLX", Some((Quantity::HookLoad, Rank::Greatest))),
            ("Hook Load", Some((Quantity::HookLoad, Rank::Plain))),
            ("hookload_max", Some((Quantity::HookLoad, Rank::Greatest))),
            ("Avg TQ", Some((Quantity::Torque, Rank::Average))),
            ("hookLoadAvg", Some((Quantity::HookLoad, Rank::Average))),
            ("0108", Some((Quantity::BitDepth, Rank::Plain))),
            ("DEPT", Some((Quantity::HoleDepth, Rank::Loose))),
            ("Surf RPM", Some((Quantity::RotarySpeed, Rank::Plain))),
            ("RPM30s", Some((Quantity::RotarySpeed, Rank::Average))),
            ("HKLD_10sec", Some((Quantity::HookLoad, Rank::Average))),
            ("BLOCKCOMP", Some((Quantity::BlockPosition, Rank::Plain))),
            ("GS_TQA", Some((Quantity::Torque, Rank::Average))),
            ("HKLDs", None),
            ("YYYY/MM/DD HH:MM:SS", Some((Quantity::Time, Rank::Plain))),
            // With a motor the bit turns faster than the string.
            ("Bit RPM", None),
            ("Max - Min TQ", None),
            ("TQ on btm", None),
            ("DWOB", None),
            ("", None),
        ] {
            assert_eq!(quantity(name), expected, "{name}");
        }
        assert!(is_reading("Pick-up") && !is_reading("Hook load"));
    }

    #[test]
    fn no_name_stands_twice() {
        let mut all: Vec<&str> = NAMES.iter().flat_map(|(_, _, names)| names.split(' ')).collect();
        all.retain(|name| !name.is_empty());
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count);
    }
}
