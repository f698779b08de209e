//! `wholestring import`: a case from files of other programs.

use std::path::{Path, PathBuf};

use clap::Args;
use wholestring_case::Template;
use wholestring_runner::import::{self, Choices, Imported};

use crate::{
    check,
    failure::Failure,
    screen::color,
    terminal::{in_shell, print_stderr, print_stdout},
};

#[derive(Debug, Args)]
pub(crate) struct ImportArgs {
    /// Survey, tally, WITSML, Landmark EDM, LAS or log, recognised by content; several files make
    /// one case
    #[arg(value_name = "FILE", required = true)]
    pub(crate) files: Vec<PathBuf>,

    /// Case file to write; an existing file is not overwritten [default: the screen]
    #[arg(short, long, value_name = "CASE.toml")]
    pub(crate) output: Option<PathBuf>,

    /// Unit of a quantity whose file does not give one, such as md=ft
    #[arg(long = "unit", value_name = "NAME=UNIT", value_parser = pair)]
    pub(crate) units: Vec<(String, String)>,

    /// Value that is required and in no file, such as block-weight="25 tf" for a log
    #[arg(long = "value", value_name = "NAME=VALUE", value_parser = pair)]
    pub(crate) values: Vec<(String, String)>,

    /// Choice where a file holds several, such as tubular="BHA 7", or the file to use for a part of
    /// the case, such as survey=survey.csv
    #[arg(long = "pick", value_name = "WHAT=NAME", value_parser = pair)]
    pub(crate) picks: Vec<(String, String)>,
}

impl ImportArgs {
    fn choices(&self) -> Result<Choices, Failure> {
        let mut choices = Choices::default();
        let options = [("--unit", &self.units), ("--value", &self.values), ("--pick", &self.picks)];
        for (option, pairs) in options {
            for (index, (name, value)) in pairs.iter().enumerate() {
                if pairs[..index].iter().any(|(other, _)| other == name) {
                    let text = format!("error: {option} {name}= is given twice");
                    return Err(Failure::BadInput(text));
                }
                choices = match option {
                    "--unit" => choices.unit(name, value),
                    "--value" => choices.value(name, value),
                    _ => choices.pick(name, value),
                };
            }
        }
        Ok(choices)
    }
}

pub(crate) fn import(args: &ImportArgs) -> Result<(), Failure> {
    let imported = import::read(&args.files, &args.choices()?)?;
    let Some(output) = &args.output else {
        print_stderr(&contents(&imported));
        return print_stdout(&imported.text);
    };
    let written = import::write(&imported, output)?;
    let mut text = contents(&imported);
    for path in &written {
        text += &format!("wrote {}\n", path.display());
    }
    print_stdout(&text)?;
    conclusion(&imported, output, &written)
}

/// Format of each file, and notes about it.
fn contents(imported: &Imported) -> String {
    let mut text = String::new();
    let alone = imported.files.len() == 1;
    for (index, (name, what)) in imported.files.iter().enumerate() {
        let mark = if alone { String::new() } else { format!("[{}] ", index + 1) };
        text += &format!("{mark}{name}: {what}\n");
    }
    for (file, note) in &imported.notes {
        let index = imported.files.iter().position(|(name, _)| Some(name) == file.as_ref());
        let mark = match index {
            Some(index) if !alone => format!("[{}] ", index + 1),
            _ => String::new(),
        };
        text += &format!("  {mark}{}: {}\n", note.kind(), note.text());
    }
    text
}

/// Whether the written case can be solved, and the next step.
fn conclusion(imported: &Imported, output: &Path, written: &[PathBuf]) -> Result<(), Failure> {
    let path = in_shell(&output.display().to_string());
    if !imported.missing.is_empty() {
        let mut text = format!("{} still needs\n", output.display());
        for missing in &imported.missing {
            text += &format!("  {missing}\n");
        }
        return print_stdout(&format!("{text}then: wholestring check {path}\n"));
    }
    let case = Template::read(output)?.case(&[])?;
    if !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    let overlay = written.iter().map(|path| path.display().to_string());
    let overlay = overlay.filter(|path| path.ends_with("-overlay.csv"));
    let overlay: String = overlay.map(|path| format!(" --overlay {}", in_shell(&path))).collect();
    print_stdout(&format!(
        "{} is valid: {}\nnext: wholestring plan {path}{overlay}\n",
        output.display(),
        check::outline(&case)
    ))
}

/// `name=value`, both non-empty.
fn pair(text: &str) -> Result<(String, String), String> {
    match text.split_once('=').map(|(name, value)| (name.trim(), value.trim())) {
        Some((name, value)) if !name.is_empty() && !value.is_empty() => {
            Ok((name.to_owned(), value.to_owned()))
        }
        _ => Err("expected a name, `=` and a value".to_owned()),
    }
}
