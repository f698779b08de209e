//! `wholestring catalogue`: tubulars that a case can name, and common rig equipment.

mod args;
mod cells;
mod rigs;
mod tubulars;

use wholestring_case::OwnCatalogue;
use wholestring_runner::Found;
use wholestring_units::UnitSet;

use crate::{failure::Failure, terminal::print_stdout};

pub(crate) use args::CatalogueArgs;

pub(crate) fn catalogue(args: &CatalogueArgs) -> Result<(), Failure> {
    let query = args.words.join(" ");
    let units = args.units.unwrap_or(UnitSet::Si);
    let own = match &args.with {
        Some(path) => OwnCatalogue::load(path)?,
        None => OwnCatalogue::default(),
    };
    let found = Found::described(&query, own.entries(), own.casings());
    if found.is_empty() {
        return Err(Failure::BadInput(format!(
            "error: the catalogue has nothing of `{query}`\n\
             help: search by size, weight, grade, class or kind, such as 5-1/2, 21.9, S-135, \
             premium, hwdp, collar, coiled, casing, rig; \
             without a word everything is listed"
        )));
    }
    let string = found.string.iter();
    let mut tables: Vec<String> =
        string.map(|(kind, entries)| tubulars::of_string(*kind, entries, units)).collect();
    if !found.casings.is_empty() {
        tables.push(tubulars::casing(&found.casings, units));
    }
    if !found.top_drives.is_empty() {
        tables.push(rigs::top_drives(&found.top_drives, units));
    }
    if !found.hoists.is_empty() {
        tables.push(rigs::hoists(&found.hoists, units));
    }
    let how =
        "In a case: catalogue = \"NAME\" under [[string]]; casing = \"NAME\" under [[well.hole]]\n";
    let sources: Vec<String> =
        found.sources().iter().map(|source| format!("  {source}\n")).collect();
    print_stdout(&format!(
        "{}\n\
         {}\
         Sources:\n{}",
        tables.join("\n"),
        if found.has_tubulars() { how } else { "" },
        sources.concat()
    ))
}
