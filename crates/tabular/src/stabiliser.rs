//! Names of stabilisers and reamers.

/// Names, without numbers and sizes, of near-bit and string stabilisers and roller reamers: `SS 2`,
/// `8-1/4" NB`. As words of longer names they have other meanings.
const WHOLE: [&str; 6] = ["nb", "near bit", "nearbit", "ss", "rr", "nb ss"];

/// Whether a component's name is that of a stabiliser or a reamer: `NB Stab`, `string stabiliser`,
/// `IBS` (integral blade), `roller reamer`, `near-bit`.
///
/// ```
/// assert!(wholestring_tabular::is_stabiliser("8-3/8\" IBS"));
/// assert!(!wholestring_tabular::is_stabiliser("near-bit gamma sub"));
/// ```
pub fn is_stabiliser(name: &str) -> bool {
    let lower = name.to_lowercase();
    let words = || lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let is_word = |word: &str| {
        matches!(word, "stab" | "stabs" | "stb" | "ibs" | "nbs" | "nbstab" | "ibstab")
            || word.starts_with("stabili")
            || word.ends_with("reamer")
            || word.ends_with("reamers")
    };
    let is_size = |word: &&str| {
        *word == "in" || *word == "mm" || word.starts_with(|c: char| c.is_ascii_digit())
    };
    let bare: Vec<&str> = words().filter(|word| !is_size(word)).collect();
    words().any(is_word) || WHOLE.contains(&bare.join(" ").as_str())
}

#[cfg(test)]
mod tests {
    use super::is_stabiliser;

    #[test]
    fn names_of_the_field() {
        for name in [
            "IBS",
            "8 3/8\" IBS",
            "IBS #2",
            "NB stab",
            "NB Stab",
            "String Stab",
            "near-bit",
            "Near-bit stabilizer",
            "NB",
            "SS",
            "SS 2",
            "8-1/4 in SS",
            "roller reamer",
            "Roller Reamer 12 1/4",
            "RR",
            "underreamer",
            "stabiliser 1",
        ] {
            assert!(is_stabiliser(name), "{name}");
        }
        for name in [
            "near-bit gamma",
            "near-bit sub",
            "bit",
            "bit sub",
            "SS collar",
            "NMDC",
            "MWD",
            "drill pipe",
            "establishing tool",
            "RSS",
            "",
        ] {
            assert!(!is_stabiliser(name), "{name}");
        }
    }
}
