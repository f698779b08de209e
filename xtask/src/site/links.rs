//! Links between pages of the built book, and their targets.

use std::{collections::BTreeSet, path::Path};

use super::tree::{files, relative};
use crate::command::Failure;

/// Pages without their own addresses: mdBook makes them from the others, or by itself.
const MADE: [&str; 3] = ["print.html", "toc.html", "404.html"];

/// Every page, picture and heading to which a page refers exists.
pub(super) fn check(site: &Path) -> Result<(), Failure> {
    let mut broken = Vec::new();
    let mut pages = files(site, "html")?;
    // The app is not one of the book's pages.
    pages.retain(|(path, _)| !path.starts_with(site.join("playground")));
    let anchors = |text: &str| attributes(text, " id=\"").map(str::to_owned).collect();
    let known: Vec<(&Path, BTreeSet<String>)> =
        pages.iter().map(|(path, text)| (path.as_path(), anchors(text))).collect();
    for (path, text) in &pages {
        if MADE.iter().any(|name| path.ends_with(name)) {
            continue;
        }
        for link in attributes(text, " href=\"").chain(attributes(text, " src=\"")) {
            let Some((file, anchor)) = inside(link) else { continue };
            let target = if file.is_empty() { path.clone() } else { relative(path, file) };
            let page = known.iter().find(|(page, _)| *page == target);
            let there = match (page, anchor) {
                (Some((_, anchors)), Some(anchor)) => anchors.contains(anchor),
                (Some(_), None) => true,
                // Targets outside are next to the sources, not next to the site.
                (None, _) => target.starts_with(site) && target.is_file(),
            };
            if !there {
                let page = path.strip_prefix(site).unwrap_or(path);
                broken.push(format!("{}: {link}", page.display()));
            }
        }
    }
    if broken.is_empty() {
        return Ok(());
    }
    broken.dedup();
    Err(Failure::new(format!("the targets of these pages do not exist:\n{}", broken.join("\n"))))
}

/// File and heading of an address within the site.
fn inside(link: &str) -> Option<(&str, Option<&str>)> {
    let elsewhere =
        link.contains("://") || link.starts_with("mailto:") || link.starts_with("data:");
    if elsewhere {
        return None;
    }
    Some(match link.split_once('#') {
        Some((file, anchor)) => (file, Some(anchor).filter(|anchor| !anchor.is_empty())),
        None => (link, None),
    })
}

/// Values of an attribute, whose name ends with its quote. Text in code is excluded.
fn attributes<'a>(text: &'a str, name: &'static str) -> impl Iterator<Item = &'a str> {
    text.split(name).skip(1).filter_map(|rest| rest.split_once('"')).map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_within_the_site_are_told() {
        assert_eq!(inside("../a.html#b"), Some(("../a.html", Some("b"))));
        assert_eq!(inside("#b"), Some(("", Some("b"))));
        assert_eq!(inside("a.svg"), Some(("a.svg", None)));
        assert_eq!(inside("https://example.org/#b"), None);
        let page = "<p id=\"b\"><a class=\"x\" href=\"#b\">";
        assert_eq!(attributes(page, " href=\"").collect::<Vec<_>>(), ["#b"]);
        assert_eq!(attributes(page, " id=\"").collect::<Vec<_>>(), ["b"]);
    }
}
