//! Each sample, read whole.

use insta::assert_snapshot;
use wholestring_import::{Choices, Input, import};

use crate::summary;

macro_rules! sample {
    ($($name:ident: $path:literal;)+) => {
        $(
            #[test]
            fn $name() {
                let bytes = include_bytes!(concat!("../samples/", $path));
                assert_snapshot!(summary($path, bytes, &Choices::default()));
            }
        )+
    };
}

sample! {
    las_of_a_rig: "own/surface-log.las";
    las_with_a_decimal_comma: "las/lasio-comma_decimal_mark.las";
    las_whose_numbers_run_together: "las/lasio-null_policy_runon.las";
    las_that_is_wrapped: "las/lasio-sample_wrapped_1.2.las";
    witsml_1_against_depth: "witsml-1.4.1.1/hashmap-log_with_data.xml";
    witsml_1_against_time: "witsml-1.4.1.1/welleng-time_log.xml";
    witsml_2_without_rows: "witsml-2.0/hashmap-log20.xml";
}

/// The case of a log with the given block weight, and its accompanying files.
#[test]
fn las_of_a_rig_with_its_block() {
    let bytes = include_bytes!("../samples/own/surface-log.las");
    let choices = Choices::default().value("block-weight", "20 tf");
    let imported = import(vec![Input::of_bytes("surface-log.las", bytes)], &choices).unwrap();
    let beside =
        imported.beside.iter().map(|beside| format!("---- well{}\n{}", beside.ending, beside.text));
    let beside: String = beside.collect();
    assert_snapshot!(format!("{}{beside}", imported.text_as("well")));
}
