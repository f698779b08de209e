//! The drawable parts of a case that is invalid elsewhere.

use wholestring::{
    string::DrillString,
    well::{Hole, Path, Station, TieIn},
};
use wholestring_config::{file::tree, prelude::*};

use crate::case::{
    build::CASE_FILE,
    stages::{Bore, Tables},
    table::CaseTable,
};

/// Survey, path, hole and string of a case, each where it can be read. The mistakes of the rest are
/// reported by [`parse`](crate::parse).
#[derive(Debug, Default)]
pub struct Parts {
    /// The stations as read, from the case or from the file that it names.
    pub stations: Vec<Station>,
    /// Position of the first station, if the survey's file gives it.
    pub tie_in: Option<TieIn>,
    /// The path through the stations.
    pub path: Option<Path>,
    /// The hole around it.
    pub hole: Option<Hole>,
    /// The string at the depth of the bit.
    pub string: Option<DrillString>,
    /// The depth of the bit, m: the case's, or that of the last station.
    pub bit_depth_m: Option<f64>,
}

impl Parts {
    /// Reads the parts of a text; `name` is its name in diagnostics.
    pub fn read(name: &str, text: &[u8], files: &dyn Files) -> Self {
        let Ok((root, mut reader)) = tree(name, text, &CASE_FILE) else {
            return Self::default();
        };
        let reader = &mut reader;
        let case = CaseTable::read(&root, Span::default(), reader);
        let tables = Tables::new(&case, files, reader);
        let bore = tables.bore(reader);
        let bit_depth_m = match case.operation.get() {
            Some(_) => tables.bit_depth_m(&bore),
            None => bore.path.as_ref().map(Path::last_md_m),
        };
        let steel = case.steel.get().and_then(|steel| steel.build(reader));
        let spec = tables.string_spec(steel.as_ref(), reader);
        let string = tables.string(spec.as_ref(), bit_depth_m, reader);
        let Bore { stations, path, hole, .. } = bore;
        let (tie_in, stations) =
            stations.map_or((None, Vec::new()), |stations| (stations.tie_in, stations.list));
        Self { stations, tie_in, path, hole, string, bit_depth_m }
    }
}

#[cfg(test)]
mod tests {
    use wholestring_config::source::InMemory;

    use super::*;

    const CASE: &str = r#"
[well]
stations = [[0, 0, 0], [1000, "0.5 rad", 0]]
[[well.hole]]
kind = "open"
to = "1000 m"
diameter = "8-1/2 in"
friction = 0.3
[mud]
density = "1.2 sg"
[[string]]
component = "collar"
od = "170 mm"
id = "70 mm"
length = "100 m"
[[string]]
component = "pipe"
catalogue = "5 in 19.50 lb/ft G-105"
length = "to surface"
[operation]
kind = "trip_out"
"#;

    fn parts(text: &str) -> Parts {
        Parts::read("a.toml", text.as_bytes(), &InMemory::default())
    }

    #[test]
    fn a_mistake_elsewhere_takes_nothing_from_the_rest() {
        let whole = parts(CASE);
        assert_eq!(whole.stations.len(), 2);
        assert_eq!(whole.path.as_ref().map(Path::last_md_m), Some(1000.0));
        assert_eq!(whole.bit_depth_m, Some(1000.0));
        let spans = |parts: &Parts| parts.string.as_ref().map(|string| string.spans().count());
        assert_eq!(spans(&whole), Some(2));

        let no_mud = parts(&CASE.replace("1.2 sg", "1.2 bar"));
        assert!(no_mud.path.is_some() && no_mud.hole.is_some() && no_mud.string.is_some());
        let no_string = parts(&CASE.replace("G-105", "G-999"));
        assert!(no_string.path.is_some() && no_string.hole.is_some());
        assert!(no_string.string.is_none());
        let no_hole = parts(&CASE.replace("friction = 0.3", "friction = 7"));
        assert!(no_hole.path.is_some() && no_hole.hole.is_none() && no_hole.string.is_some());
        let no_path = parts(&CASE.replace("[1000, ", "[-5, "));
        assert!(no_path.path.is_none() && no_path.hole.is_some() && no_path.string.is_none());
        assert!(parts("[well").path.is_none());
    }
}
