//! Names of pipe.

/// Whether a component's name is that of pipe, which fills the string to the surface.
pub(crate) fn is_pipe(name: &str) -> bool {
    const WORDS: [&str; 10] =
        ["dp", "hwdp", "pipe", "drillpipe", "tubing", "ct", "coil", "coiled", "casing", "liner"];
    let lower = name.to_lowercase();
    lower.split(|c: char| !c.is_alphanumeric()).any(|word| WORDS.contains(&word))
}
