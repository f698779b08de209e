//! Nearest names, for suggestions.

/// The nearest of the names of which `name` may be a misspelling.
pub fn nearest<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let target = simplify(name);
    if target.is_empty() || target.len() > 80 {
        return None;
    }
    names
        .into_iter()
        .map(|candidate| (likeness(&target, &simplify(candidate)), candidate))
        .filter(|(likeness, _)| *likeness >= 0.7)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}

/// The names that are about as near as the nearest one, the nearest first.
pub fn all_near<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    /// Names whose likeness is smaller by more than this are not suggested.
    const MARGIN: f64 = 0.12;
    let target = simplify(name);
    if target.is_empty() || target.len() > 80 {
        return Vec::new();
    }
    let likenesses =
        names.into_iter().map(|candidate| (likeness(&target, &simplify(candidate)), candidate));
    let mut near: Vec<(f64, &str)> = likenesses.filter(|(alike, _)| *alike >= 0.7).collect();
    near.sort_by(|a, b| b.0.total_cmp(&a.0));
    let best = near.first().map_or(0.0, |(alike, _)| *alike);
    near.retain(|(alike, _)| best - alike < MARGIN);
    near.into_iter().map(|(_, name)| name).collect()
}

/// Spelling without case and separators, which are often mistaken.
fn simplify(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// One for equal names, zero for nothing in common. A truncated name (`diam`, `trip`) is near too.
fn likeness(a: &str, b: &str) -> f64 {
    let edit = strsim::normalized_damerau_levenshtein(a, b);
    let shorter = a.len().min(b.len());
    let cut_short = shorter >= 3 && (a.starts_with(b) || b.starts_with(a));
    // One slip in a name of three letters (`wbo`, `rmp`) counts as in a longer name.
    let one_slip = shorter >= 3 && strsim::damerau_levenshtein(a, b) == 1;
    // Of two equally near names, the one with the same letters: `rmp` is `rpm`, not `rop`.
    let letters = |name: &str| {
        let mut letters: Vec<char> = name.chars().collect();
        letters.sort_unstable();
        letters
    };
    if shorter >= 3 && letters(a) == letters(b) {
        return edit.max(0.75);
    }
    // The Jaro-Winkler measure tolerates a different end more than a different beginning.
    if cut_short || one_slip || strsim::jaro_winkler(a, b) >= 0.86 { edit.max(0.7) } else { edit }
}

/// `"a", "b" or "c"`: the permitted words of a value.
pub fn any_of(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    match quoted.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}

/// A user's text, shortened for a message.
pub fn short(text: &str) -> String {
    const LONGEST: usize = 60;
    let clean: String = text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    if clean.chars().count() <= LONGEST {
        clean
    } else {
        let head: String = clean.chars().take(LONGEST - 3).collect();
        format!("{head}...")
    }
}
