//! `wholestring completions` and `wholestring man`: shell completions and manual page, generated
//! from the declaration of the command line.

use std::io;

use clap::{Command, CommandFactory};
use clap_complete::Shell;

use crate::{args::Cli, failure::Failure, terminal::print_stdout};

/// Prints the script that completes commands and options in a shell.
pub(crate) fn completions(shell: Shell) -> Result<(), Failure> {
    let mut command = Cli::command();
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, name, &mut script);
    print_stdout(&String::from_utf8_lossy(&script))
}

/// Prints the manual page with all commands.
pub(crate) fn man() -> Result<(), Failure> {
    let page = page().map_err(|error| {
        Failure::Failed(format!("error: the manual page cannot be made: {error}"))
    })?;
    print_stdout(&String::from_utf8_lossy(&page))
}

fn page() -> io::Result<Vec<u8>> {
    let mut command = Cli::command();
    command.build();
    let mut page = Vec::new();
    clap_mangen::Man::new(command.clone()).render(&mut page)?;
    let name = command.get_name().to_owned();
    let commands = command.get_subcommands().filter(|command| !command.is_hide_set());
    for command in commands.filter(|command| command.get_name() != "help") {
        section(&name, command, &mut page)?;
    }
    Ok(page)
}

/// One command, as a section of the page.
fn section(program: &str, command: &Command, page: &mut Vec<u8>) -> io::Result<()> {
    use io::Write;

    let title = format!("{program} {}", command.get_name());
    writeln!(page, ".SH \"{}\"", title.to_uppercase())?;
    let mut own = Vec::new();
    let man = clap_mangen::Man::new(command.clone());
    man.render_description_section(&mut own)?;
    man.render_options_section(&mut own)?;
    // The headings of a command's own page move one level down.
    for line in String::from_utf8_lossy(&own).lines() {
        match line.strip_prefix(".SH ") {
            Some("DESCRIPTION") => {}
            Some(heading) => writeln!(page, ".SS \"{heading}\"")?,
            None => writeln!(page, "{line}")?,
        }
    }
    Ok(())
}
