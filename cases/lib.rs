//! Ready-to-run wells: the case files of this folder and the files that they name, as texts.
//! `README.md` describes their contents and sources.

/// A ready-to-run case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReadyCase {
    /// Its name: that of its file without the extension.
    pub name: &'static str,
    /// The name of its file.
    pub file_name: &'static str,
    /// Its description, in a sentence.
    pub title: &'static str,
    /// Its text.
    pub text: &'static str,
    /// The files that it names: their names and texts.
    pub beside: &'static [(&'static str, &'static str)],
}

/// Declares the cases and the list of them, each with its title and the files that it names.
macro_rules! cases {
    ($($constant:ident = $name:literal: $title:literal $(with $beside:literal)*;)*) => {
        $(
            #[doc = $title]
            pub const $constant: ReadyCase = ReadyCase {
                name: $name,
                file_name: concat!($name, ".toml"),
                title: $title,
                text: include_str!(concat!($name, ".toml")),
                beside: &[$(($beside, include_str!($beside))),*],
            };
        )*

        /// All of them, small ones first.
        pub const ALL: &[ReadyCase] = &[$($constant),*];
    };
}

cases! {
    VERTICAL = "vertical": "A vertical well of 1500 m: hook load is buoyed weight";
    SLANT = "slant": "A slant well of 1200 m that builds to 42 deg";
    HORIZONTAL = "horizontal":
        "A shallow horizontal well of 1100 m with heavy-weight pipe above the lateral";
    LATERAL_THAT_CANNOT_BE_DRILLED = "lateral-that-cannot-be-drilled":
        "A lateral of 3100 m with nothing but light pipe in the hole";
    BENT_MOTOR = "bent-motor":
        "A bent motor that slides in a tangent: an assembly to look at";
    NP13_X1042 = "np13-x1042":
        "A highly deviated well of 4305 m, from a published article"
        with "np13-x1042-survey.csv";
    ISCWSA_04 = "iscwsa-04":
        "ISCWSA standard wellpath 04: a horizontal well that turns twice"
        with "iscwsa-04-survey.csv";
    FORGE_16A = "forge-16a":
        "Utah FORGE 16A(78)-32, a geothermal well in granite, with readings of the rig"
        with "forge-16a-survey.csv" with "forge-16a-measured.csv";
    WELL_B_1714 = "well-b-1714":
        "A string that starts to turn off bottom at 1714 m, from a published article";
    WELL_B_2235 = "well-b-2235":
        "A string that sticks and slips off bottom, from a published article";
    ROCK_300 = "rock-300": "A short string that drills solid rock, element by element";
    NP13_X1042_ROCK = "np13-x1042-rock":
        "The well of 4305 m with solid rock under its bit, element by element"
        with "np13-x1042-survey.csv";
}

#[cfg(test)]
mod tests {
    use std::{collections::BTreeSet, fs, path::Path};

    use super::ALL;

    #[test]
    fn every_file_of_the_folder_is_listed() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let names: BTreeSet<String> = names.map(|name| name.into_string().unwrap()).collect();
        let ends = |name: &&String| name.ends_with(".toml") || name.ends_with(".csv");
        let there: BTreeSet<&str> = names
            .iter()
            .filter(ends)
            .map(String::as_str)
            .filter(|name| *name != "Cargo.toml")
            .collect();
        let beside = ALL.iter().flat_map(|case| case.beside).map(|(name, _)| *name);
        let listed: BTreeSet<&str> = ALL.iter().map(|case| case.file_name).chain(beside).collect();
        assert_eq!(listed, there);
    }

    #[test]
    fn what_is_beside_a_case_is_known_to_its_page() {
        let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md"));
        let page = page.unwrap();
        for case in ALL {
            assert!(page.contains(&format!("`{}`", case.file_name)), "{}", case.file_name);
        }
    }
}
