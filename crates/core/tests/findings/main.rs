//! What is reported of an answer: every kind where it must be, and not where it must not.

#[path = "../common/mod.rs"]
mod common;
mod in_time;
mod judged;
mod soft_string;

use wholestring::findings::{Kind, Level};

#[test]
fn words_of_kinds_are_their_own() {
    let mut words: Vec<&str> = Kind::ALL.iter().map(|kind| kind.name()).collect();
    words.sort_unstable();
    words.dedup();
    assert_eq!(words.len(), Kind::ALL.len());
    let plain = |word: &str| word.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase());
    assert!(words.iter().all(|word| plain(word)), "{words:?}");
    assert!(Level::Error > Level::Warning && Level::Warning > Level::Note);
}
