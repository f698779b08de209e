//! `wholestring new`: a commented case to start from.

use std::{io, path::PathBuf};

use clap::Args;
use wholestring_case::new_case;
use wholestring_results::{ResultsError, write_new_files};

use crate::{
    failure::Failure,
    terminal::{in_shell, print_stdout},
};

#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Name of the case, written to NAME.toml; an existing file is not overwritten
    #[arg(value_name = "NAME", default_value = "my-well")]
    pub(crate) name: PathBuf,
}

pub(crate) fn new(args: &NewArgs) -> Result<(), Failure> {
    let path = file(&args.name);
    let path_text = path.display();
    let stem = path.file_stem().map(|stem| stem.to_string_lossy());
    let Some(stem) = stem.filter(|stem| !stem.chars().any(char::is_control)) else {
        return Err(Failure::BadInput(format!(
            "error: `{}` is no name of a file",
            path_text.to_string().escape_debug()
        )));
    };
    let text = new_case(&stem);
    // Existing files are not overwritten.
    if let Err((_, error)) = write_new_files(&[(path.clone(), text.as_bytes())]) {
        return Err(match error.kind() {
            io::ErrorKind::AlreadyExists => Failure::BadInput(format!(
                "error: {path_text} is there already\nhelp: give another name: wholestring new NAME"
            )),
            io::ErrorKind::NotFound => Failure::BadInput(format!(
                "error: cannot write {path_text}: there is no such folder"
            )),
            _ => ResultsError::Write { path: path.clone(), source: error }.into(),
        });
    }
    print_stdout(&format!(
        "wrote {path_text}: adapt it, then\n  wholestring check {0}\n  wholestring run \
         {0}\n",
        in_shell(&path_text.to_string())
    ))
}

/// `NAME.toml`, also if the extension is given.
fn file(name: &std::path::Path) -> PathBuf {
    let is_toml = name.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if is_toml {
        return name.to_owned();
    }
    // Not `with_extension`, which would truncate `well-1.2`.
    let mut whole = name.as_os_str().to_owned();
    whole.push(".toml");
    whole.into()
}
