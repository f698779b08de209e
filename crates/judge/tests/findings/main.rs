//! Findings of a result: every kind is reported where it must be, and only there.

#[path = "../../../core/tests/common/mod.rs"]
#[allow(unused_macros)]
mod common;
mod helix;
mod hydraulics;
mod in_time;
mod judged;
mod soft_string;
mod swings;
mod vertical;

use wholestring_judge::{CheckKind, Severity};

#[test]
fn words_of_kinds_are_their_own() {
    let mut words: Vec<&str> = CheckKind::ALL.iter().map(|kind| kind.name()).collect();
    words.sort_unstable();
    words.dedup();
    assert_eq!(words.len(), CheckKind::ALL.len());
    let plain = |word: &str| word.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase());
    assert!(words.iter().all(|word| plain(word)), "{words:?}");
    assert!(Severity::Error > Severity::Warning && Severity::Warning > Severity::Note);
}
