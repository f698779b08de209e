//! Fronts show verdicts and make none: their sources have no word of a verdict.

use std::{fs, path::Path};

use wholestring_judge::Verdict;

/// Folders of the fronts, from the root of the repository.
const FRONTS: [&str; 4] =
    ["web/app/src", "web/components", "crates/report/web/src", "crates/python/python/wholestring"];

/// Endings of their sources.
const SOURCES: [&str; 4] = ["ts", "js", "svelte", "py"];

fn sources(folder: &Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && name != "node_modules" {
            sources(&path, found);
        } else if path.extension().is_some_and(|ending| SOURCES.iter().any(|of| ending == *of)) {
            found.push(path);
        }
    }
}

#[test]
fn fronts_make_no_verdicts() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    for front in FRONTS {
        sources(&root.join(front), &mut files);
    }
    assert!(files.len() > 100, "{} sources", files.len());
    let words = [Verdict::Marginal, Verdict::BelowRequired, Verdict::Exceeded];
    for file in files {
        let text = fs::read_to_string(&file).expect("a text").to_lowercase();
        // What a docstring lists is no verdict.
        let code = text.lines().filter(|line| !line.contains("``\""));
        for line in code {
            for word in words.map(Verdict::words) {
                let is_own =
                    line.contains(&format!(" {word}")) || line.contains(&format!("\"{word}"));
                assert!(!is_own, "{}: {line}", file.display());
            }
            assert!(
                !line.contains("locks up\"") && !line.contains("lock-up"),
                "{}",
                file.display()
            );
        }
    }
}
