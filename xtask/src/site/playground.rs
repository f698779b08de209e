//! The app that runs in a browser alone, on its page of the book.

use std::{env, fs, path::PathBuf, process::Command};

use crate::{
    command::Failure,
    folders::{copy, target},
};

/// Where the page shows the app; what stands up to the end says how to make it.
const BEGIN: &str = "<!-- playground: begin -->\n";
const END: &str = "<!-- playground: end -->\n";

/// The app, from the root of the book's site.
const FOLDER: &str = "playground";

/// In the place of what says how to make it. What is fetched is fetched when it comes into sight.
const SHOWN: &str = "\
<iframe class=\"app-alone\" src=\"playground/index.html\" loading=\"lazy\" title=\"The app of wholestring, \
in this browser alone\"></iframe>

[Open it in a window of its own](playground/index.html). It needs a server of files: where the book is opened from a folder, the frame stays empty.
";

/// Tells the preprocessor that the app will be put beside the pages: mdBook that is called by itself
/// puts in none.
const PUT_IN: &str = "WHOLESTRING_BOOK_HAS_APP";

/// The folder that `cargo xtask playground` makes, if it has made it.
fn made() -> Option<PathBuf> {
    let folder = target().join(FOLDER);
    folder.join("index.html").is_file().then_some(folder)
}

/// Has pages show the app that will be put in.
pub(super) fn announce(mdbook: &mut Command) {
    match made() {
        Some(_) => mdbook.env(PUT_IN, "1"),
        None => mdbook.env_remove(PUT_IN),
    };
}

/// The page with the app, where it will be put in, else with what says how to make it.
pub(super) fn shown(page: &str) -> Result<String, String> {
    shown_if(page, env::var_os(PUT_IN).is_some())
}

fn shown_if(page: &str, put_in: bool) -> Result<String, String> {
    let Some((before, rest)) = page.split_once(BEGIN) else { return Ok(page.into()) };
    let Some((how, after)) = rest.split_once(END) else {
        return Err(format!("there is no {} after {}", END.trim_end(), BEGIN.trim_end()));
    };
    Ok(format!("{before}{}{after}", if put_in { SHOWN } else { how }))
}

/// Puts the app beside the pages, where it has been made; whether it has.
pub(super) fn put_in(site: PathBuf) -> Result<bool, Failure> {
    let Some(folder) = made() else { return Ok(false) };
    let site = site.join(FOLDER);
    let cannot = |error| Failure::new(format!("{}: {error}", site.display()));
    if site.exists() {
        fs::remove_dir_all(&site).map_err(cannot)?;
    }
    copy(&folder, &site).map_err(cannot)?;
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_has_the_app_or_how_to_make_it() {
        let page = format!("a\n\n{BEGIN}Make it.\n{END}\nb\n");
        assert_eq!(shown_if(&page, false).as_deref(), Ok("a\n\nMake it.\n\nb\n"));
        let shown = shown_if(&page, true).unwrap_or_else(|error| panic!("{error}"));
        assert!(shown.contains("<iframe") && !shown.contains("Make it."), "{shown}");
        // An element ends at an empty line, and so does what a link stands in.
        assert!(shown.contains("</iframe>\n\n["), "{shown}");
        assert!(shown_if(BEGIN, true).is_err());
        assert_eq!(shown_if("a\n", true).as_deref(), Ok("a\n"));
    }
}
