//! What is called pipe.

/// Whether a component's name is that of pipe, of which a string has as much as it needs.
pub(crate) fn is_pipe(name: &str) -> bool {
    const WORDS: [&str; 10] =
        ["dp", "hwdp", "pipe", "drillpipe", "tubing", "ct", "coil", "coiled", "casing", "liner"];
    let lower = name.to_lowercase();
    lower.split(|c: char| !c.is_alphanumeric()).any(|word| WORDS.contains(&word))
}
