//! Mutations: of bytes, of the words and numbers of a text, of its lines.

use fastrand::Rng;

/// Maximum size of inputs, bytes.
const LONGEST: usize = 1 << 18;

/// Numbers at the limits of number formats.
const NUMBERS: &str = "\
    0 -0 1 -1 2 0.1 1e-305 5e-324 1e308 -1e308 1e309 nan inf -inf 1e5 1000000 65535 65536 \
    2147483648 4294967296 9223372036854775807 18446744073709551616 99999999999999999999999 0x10 \
    1_000 1,5 1,500.0 ٣ 5-1/2 1/0 0.30000000000000004";

/// Extreme bytes.
const BYTES: &[u8] =
    &[0, 1, 2, 0x7f, 0x80, 0xff, 0xfe, 0xc0, 0xe2, 0xf0, b'\n', b'\r', b'\t', b'"', b'='];

/// Returns a damaged copy of one of the seeds, with a few changes. A text is also changed by words,
/// including `words`.
pub(crate) fn damaged(seeds: &[Vec<u8>], words: &[&str], is_text: bool, rng: &mut Rng) -> Vec<u8> {
    let Some(seed) = rng.choice(seeds) else {
        return Vec::new();
    };
    let mut input = seed.clone();
    let changes = 1 + rng.usize(..4) * rng.usize(..3);
    for _ in 0..changes {
        if is_text && rng.u8(..4) != 0 {
            text(&mut input, words, rng);
        } else {
            bytes(&mut input, seeds, rng);
        }
    }
    input.truncate(LONGEST);
    input
}

fn range(length: usize, rng: &mut Rng) -> std::ops::Range<usize> {
    let from = rng.usize(..=length);
    let longest = (length - from).min(1 << rng.u8(..12));
    from..from + rng.usize(..=longest)
}

fn bytes(input: &mut Vec<u8>, seeds: &[Vec<u8>], rng: &mut Rng) {
    let length = input.len();
    let at = rng.usize(..=length);
    match rng.u8(..10) {
        0 | 1 if length > 0 => input[at.min(length - 1)] ^= 1 << rng.u8(..8),
        2 if length > 0 => input[at.min(length - 1)] = *rng.choice(BYTES).unwrap_or(&0),
        3 => input.insert(at, rng.u8(..)),
        4 => drop(input.drain(range(length, rng))),
        5 => input.truncate(at),
        6 => {
            let copied = input[range(length, rng)].to_vec();
            input.splice(at..at, copied);
        }
        7 => {
            // A whole number of one to eight bytes, small, large or negative.
            let value = match rng.u8(..4) {
                0 => u64::MAX >> rng.u8(..64),
                1 => 1 << rng.u8(..63),
                2 => rng.u64(..),
                _ => rng.u64(..300),
            };
            let width = (1 << rng.u8(..4)).min(length - at);
            input[at..at + width].copy_from_slice(&value.to_le_bytes()[..width]);
        }
        8 => {
            if let Some(other) = rng.choice(seeds) {
                let piece = other[range(other.len(), rng)].to_vec();
                input.splice(at..at, piece);
            }
        }
        _ => {
            let piece = input[range(length, rng)].to_vec();
            repeat(input, at, &piece, rng);
        }
    }
}

/// Inserts a piece many times.
fn repeat(input: &mut Vec<u8>, at: usize, piece: &[u8], rng: &mut Rng) {
    if piece.is_empty() {
        return;
    }
    // The longest inputs are rare, because each takes as long to read as hundreds of others.
    let doublings = rng.u8(..17).min(rng.u8(..17)).min(rng.u8(..17));
    let times = (1 << doublings).min(LONGEST / piece.len());
    input.splice(at..at, piece.repeat(times));
}

/// The words of a text: ranges of runs of letters and digits, or of single signs.
fn words_of(input: &[u8]) -> Vec<std::ops::Range<usize>> {
    let in_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte >= 0x80;
    let mut words: Vec<std::ops::Range<usize>> = Vec::new();
    for (at, &byte) in input.iter().enumerate() {
        match words.last_mut() {
            Some(word)
                if in_word(byte)
                    && word.end == at
                    && in_word(input[word.start])
                    // `-1.5e3` is one word.
                    || byte == b'.' && word_is_number(&input[word.clone()]) && word.end == at =>
            {
                word.end = at + 1;
            }
            _ if byte == b' ' => {}
            _ => words.push(at..at + 1),
        }
    }
    words
}

fn word_is_number(word: &[u8]) -> bool {
    word.iter().all(u8::is_ascii_digit)
}

fn text(input: &mut Vec<u8>, more: &[&str], rng: &mut Rng) {
    let words = words_of(input);
    let Some(word) = rng.choice(&words).cloned() else {
        input.extend_from_slice(rng.choice(more).unwrap_or(&"x").as_bytes());
        return;
    };
    match rng.u8(..12) {
        0..=2 => {
            // A number in place of a number, or of any word.
            let numbers: Vec<_> =
                words.iter().filter(|word| input[word.start].is_ascii_digit()).collect();
            let word = rng.choice(numbers).cloned().unwrap_or(word);
            let numbers: Vec<&str> = NUMBERS.split(' ').collect();
            let number = rng.choice(&numbers).unwrap_or(&"0");
            input.splice(word, number.bytes());
        }
        3 | 4 => {
            let new = rng.choice(more).unwrap_or(&"");
            input.splice(word, new.bytes());
        }
        5 => {
            if let Some(other) = rng.choice(&words) {
                let other = input[other.clone()].to_vec();
                input.splice(word, other);
            }
        }
        6 => drop(input.drain(word)),
        7 => {
            let new = rng.choice(more).unwrap_or(&"");
            input.splice(word.start..word.start, new.bytes());
        }
        8 => lines(input, rng),
        9 => {
            // Repeats parts of a key, nested brackets, or digits of a number.
            let next = (word.end + 1).min(input.len());
            let piece = input[word.start..next].to_vec();
            repeat(input, word.end, &piece, rng);
        }
        10 => {
            let piece = rng.choice(more).unwrap_or(&"[").as_bytes().to_vec();
            repeat(input, word.end, &piece, rng);
        }
        _ => drop(input.drain(word.start..rng.usize(word.start..=input.len()))),
    }
}

/// Deletes, duplicates or moves a line.
fn lines(input: &mut Vec<u8>, rng: &mut Rng) {
    let mut lines: Vec<Vec<u8>> =
        input.split_inclusive(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
    let (one, other) = (rng.usize(..lines.len().max(1)), rng.usize(..lines.len().max(1)));
    if lines.is_empty() {
        return;
    }
    match rng.u8(..3) {
        0 => drop(lines.remove(one)),
        1 => lines.insert(other, lines[one].clone()),
        _ => lines.swap(one, other),
    }
    *input = lines.concat();
}
