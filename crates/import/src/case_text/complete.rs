//! What a case needs beyond its files: assumed where that may be, missing otherwise.

use wholestring_case::MAX_FRICTION;
use wholestring_units::number_text;

use crate::{
    fragment::{Block, Entry, Note, Origin, Part, Value},
    merge::{Draft, Of},
    pipe::is_pipe,
};

/// Friction of steel on steel and on rock where nothing tells it: what torque and drag is usually
/// planned with in water-based mud, before anything has been measured.
const CASED: f64 = 0.2;
const OPEN: f64 = 0.3;

/// What a string does at a depth, where nothing tells what it does.
const OPERATIONS: [&str; 3] = ["trip_out", "trip_in", "rotate_off_bottom"];

/// Of a string that rotates off bottom, where nothing tells how fast.
const ROTARY_SPEED_REV_PER_MIN: f64 = 60.0;

/// A part that a case cannot do without.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Missing {
    pub(crate) part: Part,
    /// For people.
    pub(crate) sentence: &'static str,
    /// How it is written in the case, each line to be uncommented.
    pub(crate) example: &'static str,
}

const NEEDED: [Missing; 4] = [
    Missing {
        part: Part::Survey,
        sentence: "the path of the well: give a survey too, or `survey` or `stations` in the case",
        example: "survey = \"survey.csv\"               # measured depth, inclination, azimuth",
    },
    Missing {
        part: Part::Hole,
        sentence: "the sections of the hole: write them in the case ([[well.hole]])",
        example: "[[well.hole]]\nkind = \"casing\"\nto = \"900 m\"\ncasing = \"9-5/8 in 40 \
                  lb/ft\"\nfriction = 0.2\n[[well.hole]]\nkind = \"open\"\nto = \"1800 \
                  m\"\ndiameter = \"8-1/2 in\"\nfriction = 0.3",
    },
    Missing {
        part: Part::Mud,
        sentence: "the density of the mud: write it in the case ([mud])",
        example: "[mud]\ndensity = \"1.2 sg\"",
    },
    Missing {
        part: Part::String,
        sentence: "the string: give a tally too, or write it in the case ([[string]], from the \
                   bit up)",
        example: "[[string]]\ncomponent = \"bit\"\nod = \"8-1/2 in\"\nlength = \"0.3 \
                  m\"\n[[string]]\ncomponent = \"drill pipe\"\ncatalogue = \"5 in 19.50 lb/ft \
                  S-135\"\nlength = \"to surface\"",
    },
];

/// Of a string whose topmost component is of an assembly.
const PIPE: Missing = Missing {
    part: Part::String,
    sentence: "the pipe above the topmost component: write it as the last [[string]], \"to surface\"",
    example: "[[string]]\ncomponent = \"drill pipe\"\ncatalogue = \"5 in 19.50 lb/ft S-135\"\nlength = \
              \"to surface\"",
};

/// Fills in what may be assumed, and returns what is missing.
pub(crate) fn complete(draft: &mut Draft) -> Vec<Missing> {
    friction(draft);
    let ends_in_pipe = top_component(draft);
    operations(draft);
    bit_depth(draft);
    let lacks = |part: Part| match part {
        Part::Survey => draft.survey.is_none(),
        Part::Hole => draft.hole.is_none(),
        Part::String => draft.string.is_none(),
        Part::Mud => !draft.mud.iter().any(|entry| entry.of.key == "density"),
        Part::Rig | Part::Operation => false,
    };
    let mut missing: Vec<Missing> =
        NEEDED.into_iter().filter(|needed| lacks(needed.part)).collect();
    if !ends_in_pipe {
        missing.push(PIPE);
    }
    missing
}

/// What the string does, and how fast it turns.
fn operations(draft: &mut Draft) {
    let words = OPERATIONS.map(str::to_owned).to_vec();
    let assumed = [
        ("kind", Value::Words(words), "no file says what the string does"),
        (
            "rpm",
            Value::Number(ROTARY_SPEED_REV_PER_MIN),
            "no file says it; weights and torque at rest do not depend on it",
        ),
    ];
    for (at, (key, value, because)) in assumed.into_iter().enumerate() {
        if !draft.operation.iter().any(|entry| entry.of.key == key) {
            let origin = Origin::Assumed { because: because.to_owned() };
            draft.operation.insert(at, Of { file: 0, of: Entry { key, value, origin } });
        }
    }
}

/// Gives sections without friction the usual one.
fn friction(draft: &mut Draft) {
    let Some(Of { file, of: sections }) = &mut draft.hole else { return };
    let mut assumed = 0;
    for section in sections.iter_mut().filter(|section| section.get("friction").is_none()) {
        let cased = section.get("kind") == Some(&Value::text("casing"));
        let value = if cased { CASED } else { OPEN };
        debug_assert!(value < MAX_FRICTION);
        let because = format!("usual in {}; calibrate it", if cased { "casing" } else { "rock" });
        section.push("friction", Value::Number(value), Origin::Assumed { because });
        assumed += 1;
    }
    if assumed > 0 {
        let text = format!(
            "no file tells the friction of {assumed} of {} hole sections: {CASED} in casing, \
             {OPEN} in rock",
            sections.len()
        );
        draft.notes.push((Some(*file), Note::Assumed(text)));
    }
}

/// The topmost component fills the string whatever the depth of the bit, if it is pipe; whether the
/// string reaches to the surface.
fn top_component(draft: &mut Draft) -> bool {
    let Some(Of { file, of: components }) = &mut draft.string else { return true };
    let Some(top) = components.last_mut() else { return true };
    let name = match top.get("component") {
        Some(Value::Text(name)) => name.clone(),
        _ => String::new(),
    };
    let length = top.entries.iter_mut().find(|entry| entry.key == "length");
    let Some(Entry { value, origin, .. }) = length else { return true };
    let Value::Quantity { number, unit } = value else { return true };
    if !is_pipe(&name) {
        return false;
    }
    let found = format!("{} {}", number_text(*number), unit.symbol);
    *origin = Origin::Assumed {
        because: format!("found {found}; it fills the string at every depth of the bit"),
    };
    *value = Value::text("to surface");
    let text = format!(
        "the topmost component, found with a length of {found}, is taken to reach to the surface \
         whatever the depth of the bit"
    );
    draft.notes.push((Some(*file), Note::Assumed(text)));
    true
}

/// The bit is where the hole ends, if the survey goes deeper.
fn bit_depth(draft: &mut Draft) {
    if draft.operation.iter().any(|entry| entry.of.key == "bit_depth") {
        return;
    }
    let (Some(survey), Some(hole)) = (&draft.survey, &draft.hole) else { return };
    let end = hole.of.last().and_then(|section: &Block| section.get("to")).cloned();
    let (Some(last), Some(end)) = (survey.of.stations.last(), end) else { return };
    if end.si().is_some_and(|end_m| end_m < last.md_m) {
        let because = "the hole ends there, above the last station".to_owned();
        let entry =
            Entry { key: "bit_depth", value: end, origin: Origin::Derived { from: because } };
        draft.operation.push(Of { file: hole.file, of: entry });
    }
}
