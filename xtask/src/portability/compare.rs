//! Differences between the files of two machines.

use super::numbers::Numbers;

/// Values of a run that depend on the machine.
const OF_THE_MACHINE: [&str; 3] = ["\"instructions\"", "\"wall_time_s\"", "\"real_time_factor\""];

/// Prints the differences of each file that differs; returns whether only those of runs that may
/// differ do.
pub(super) fn report(here: &Numbers, there: &Numbers, may_differ: &[&str]) -> bool {
    let (mut differing, mut wrong) = (0, 0);
    for name in here.keys().chain(there.keys().filter(|name| !here.contains_key(*name))) {
        let difference = match (here.get(name), there.get(name)) {
            (Some(here), Some(there)) => difference(here, there),
            (Some(_), None) => Some("is not there".into()),
            _ => Some("is there alone".into()),
        };
        if let Some(difference) = difference {
            differing += 1;
            let run = name.split('/').next().unwrap_or_default();
            wrong += usize::from(!may_differ.contains(&run));
            println!("  {name} {difference}");
        }
    }
    println!("  {differing} of {} files are not the same to the last bit", here.len());
    wrong == 0
}

/// Difference of a file; `None` if it is equal.
fn difference(here: &[u8], there: &[u8]) -> Option<String> {
    if here == there {
        return None;
    }
    let (Ok(here), Ok(there)) = (std::str::from_utf8(here), std::str::from_utf8(there)) else {
        return Some("differs".into());
    };
    let words = |text: &'_ str| -> Vec<(usize, String)> {
        let lines = text.lines().enumerate();
        let lines = lines.filter(|(_, line)| !OF_THE_MACHINE.iter().any(|key| line.contains(key)));
        let split = |(place, line): (usize, &str)| {
            let parts: Vec<_> = line.split([',', ' ', '[', ']', '{', '}', ':']).collect();
            parts.into_iter().map(move |part| (place + 1, part.to_owned())).collect::<Vec<_>>()
        };
        lines.flat_map(split).collect()
    };
    let (here, there) = (words(here), words(there));
    if here.len() != there.len() {
        return Some("has other words".into());
    }
    let pairs = here.iter().zip(&there).filter(|((_, a), (_, b))| a != b).map(|(a, b)| {
        let apart = match (a.1.parse::<f64>(), b.1.parse::<f64>()) {
            (Ok(x), Ok(y)) => (x - y).abs() / x.abs().max(y.abs()),
            _ => f64::INFINITY,
        };
        (a, b, apart)
    });
    let pairs: Vec<_> = pairs.collect();
    let ((line, a), (_, b), apart) = *pairs.first()?;
    let most = pairs.iter().map(|(_, _, apart)| *apart).fold(0.0, f64::max);
    Some(format!(
        "differs in {} of {} numbers, first in line {line}: {a} here, {b} there ({apart:.1e}); the \
         farthest are {most:.1e} apart",
        pairs.len(),
        here.len()
    ))
}
