//! Assumed values are listed in the case, each as a sentence.

#[allow(dead_code, reason = "other tests have more of it")]
mod rig_log;

use rig_log::{Manner, Rig, TRUTH};
use wholestring_import::{Choices, Input, import};

/// The sentences under `Assumed` at the head of a case.
fn assumed(name: &str, bytes: &[u8], choices: &Choices) -> Vec<String> {
    let imported = import(vec![Input::of_bytes(name, bytes)], choices);
    let text = imported.unwrap_or_else(|error| panic!("{error}")).text;
    let lines = text.lines().skip_while(|line| *line != "# Assumed:").skip(1);
    let lines = lines.take_while(|line| line.starts_with("#   "));
    lines.map(|line| line.trim_start_matches("#   ").to_owned()).collect()
}

#[track_caller]
fn holds(found: &[String], sentence: &str) {
    assert!(found.iter().any(|found| found.contains(sentence)), "{sentence}: {found:#?}");
}

#[test]
fn angles_without_a_unit_are_in_degrees() {
    let headed = b"MD (m),Inc,Azi\n0,0,0\n100,1,45\n";
    let sentence = "no unit for inclination and azimuth: read in degrees";
    holds(&assumed("a.csv", headed, &Choices::default()), sentence);
    let half = b"MD (m),Inc (rad),Azi\n0,0,0\n100,0.1,45\n";
    let found = assumed("a.csv", half, &Choices::default());
    holds(&found, "no unit for azimuth: read in degrees");
    let all = b"MD (m),Inc (deg),Azi (deg)\n0,0,0\n100,1,45\n";
    let found = assumed("a.csv", all, &Choices::default());
    assert!(!found.iter().any(|found| found.contains("degrees")), "{found:?}");
    // Without headings, the meaning of the columns is assumed as well.
    let bare = b"0 0 0\n100 1 45\n";
    let found = assumed("a.txt", bare, &Choices::default().unit("md", "m"));
    let sentence = "three columns read as measured depth in m as given, inclination in deg, \
                    azimuth in deg";
    holds(&found, sentence);
}

#[test]
fn a_rotary_speed_and_an_index_without_a_unit() {
    let manner = Manner { step_s: 2.0, ..Manner::default() };
    let mut rig = Rig::new(manner, TRUTH, 3000.0, 3000.0);
    rig.trips_out(3);
    rig.trips_in(3);
    rig.drills_a_stand();
    let text = rig.las();
    let choices = Choices::default().value("block-weight", "245 kN");
    let notes = assumed("rig.las", text.as_bytes(), &choices);
    assert!(!notes.iter().any(|found| found.contains("has no unit")), "{notes:?}");
    let bare = text.replace("TIME.s:", "TIME. :").replace("RPMA.rpm:", "RPMA. :");
    let found = assumed("rig.las", bare.as_bytes(), &choices);
    holds(&found, "RPMA has no unit and is taken to be in rpm");
    holds(&found, "TIME has no unit and is taken to be in 's' as STRT");
}
