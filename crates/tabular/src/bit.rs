//! Names of bits.

/// Words after `bit` in names that are not bits.
const NO_BITS: [&str; 12] = [
    "sub",
    "subs",
    "stab",
    "stabiliser",
    "stabilizer",
    "breaker",
    "box",
    "float",
    "reamer",
    "saver",
    "connection",
    "crossover",
];

/// Whether a name is that of a bit: `8 1/2 PDC Bit`, `Bit - 8 1/2`; neither a bit sub nor a
/// near-bit stabiliser.
pub fn is_bit(name: &str) -> bool {
    let lower = name.to_lowercase();
    let words: Vec<&str> =
        lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let Some(at) = words.iter().position(|word| *word == "bit") else {
        return words.iter().any(|word| *word == "pdc" || *word == "tricone")
            && !words.iter().any(|word| NO_BITS.contains(word));
    };
    let is_near = at > 0 && words[at - 1] == "near";
    !is_near && !words.iter().any(|word| NO_BITS.contains(word))
}

#[cfg(test)]
mod tests {
    use super::is_bit;

    #[test]
    fn a_bit_is_told_from_what_stands_near_it() {
        for name in ["8 1/2\" PDC Bit", "Bit - PDC M516", "BIT", "Tricone 12 1/4", "PDC M323"] {
            assert!(is_bit(name), "{name}");
        }
        for name in ["Bit sub", "Near-bit stabiliser", "NB stab", "Orbit RSS", "Bit saver sub", ""]
        {
            assert!(!is_bit(name), "{name}");
        }
    }
}
