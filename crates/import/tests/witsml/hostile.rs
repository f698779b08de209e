//! Damaged and malicious files.

use std::collections::BTreeMap;

use proptest::prelude::*;
use wholestring_case::Template;
use wholestring_import::{Choices, Input, contents};

use crate::{
    WELL, WELL_21, component, geometry, imported, one_series, refusal, sample, section, station,
    text_of, tubular,
};

#[test]
fn names_cannot_write_into_the_case() {
    let stations = station("0", "0", "0") + &station("100", "0", "0");
    let name = "T\n[mud]\ndensity = 0\u{85}\r\n# \"";
    let file = one_series(
        "trajectory",
        &format!(
            "<trajectory><nameWell>{name}</nameWell><name>{name}</name>{stations}</trajectory>"
        ),
    );
    let text = text_of(&file);
    assert!(!text.contains("\n[mud]") && !text.contains("\ndensity"), "{text}");
    assert!(text.contains("trajectory 'T [mud] density = 0 # \"'"), "{text}");
}

#[test]
fn hostile_files_are_refused_in_time() {
    let laughs = "<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b 'c'>]><trajectorys/>";
    assert!(refusal(laughs).contains("it declares a document type (DTD)"));
    let deep = tubular(&"<tubularComponent>".repeat(1000));
    assert!(refusal(&deep).contains("nested more than 64 deep"));
    let wide = tubular(&"<a/>".repeat(500_000));
    assert!(refusal(&wide).contains("objects of more than 400000 elements and 32 MB"));
    let many = tubular(&component("jar", "", "").repeat(3000));
    assert!(refusal(&many).contains("a tubular of more than 2000 components"));
    let sections = geometry(&section("casing", 0.0, 9.0, "").repeat(1000));
    assert!(refusal(&sections).contains("a geometry of more than 500 sections"));
    let objects = one_series("tubular", &"<tubular/>".repeat(2000));
    assert!(refusal(&objects).contains("more than 1000 objects"));
    let heavy = format!("<description>{}</description>", "x".repeat(40 << 20));
    assert!(refusal(&tubular(&component("jar", "", &heavy))).contains("and 32 MB"));
    assert!(
        refusal(&tubular("<tubularComponent>").replace("</tubular>", ""))
            .contains("not well-formed")
    );
}

/// Returns the bytes of a sample with some of them changed.
fn changed(bytes: &[u8], changes: &[(usize, u8)], cut: usize) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for &(at, byte) in changes {
        let at = at % bytes.len();
        bytes[at] = byte;
    }
    let keep = bytes.len() - cut % bytes.len() / 4;
    bytes.truncate(keep);
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// Damaged files are read or refused; the output is TOML.
    #[test]
    fn damaged_files_do_not_end_the_program(
        which in 0..9usize,
        changes in prop::collection::vec((any::<usize>(), prop::sample::select(b"0195.-<>/&;\"e \n\xff".to_vec())), 0..6),
        cut in prop_oneof![Just(0usize), any::<usize>()],
    ) {
        let name = WELL.iter().chain(&WELL_21).nth(which).copied().unwrap_or_default();
        let bytes = changed(&sample(&format!("own/{name}")), &changes, cut);
        let files = [(name, bytes.as_slice())];
        if let Ok(imported) = imported(&files, &Choices::default()) {
            let template = Template::in_memory("case.toml", &imported.text, BTreeMap::new());
            if let Err(report) = template.case(&[]) {
                prop_assert!(!format!("{report:?}").contains("TOML"), "{report:?}");
            }
        }
        let _ = contents(Input::of_bytes(name, &bytes));
    }
}
