//! Parts that a case needs and its files lack: assumed where possible, otherwise missing.

use wholestring_case::MAX_FRICTION;
use wholestring_units::number_text;

use crate::{
    fragment::{Block, Entry, Note, Origin, Part, Value},
    merge::{Draft, Sourced},
    pipe::is_pipe,
};

/// Default friction factors in casing and open hole: the usual values for planning torque and drag
/// in water-based mud before measurements exist.
const CASED: f64 = 0.2;
const OPEN: f64 = 0.3;

/// Default operations at a depth.
const OPERATIONS: [&str; 3] = ["trip_out", "trip_in", "rotate_off_bottom"];

/// Default rotary speed of a string that rotates off bottom.
const ROTARY_SPEED_REV_PER_MIN: f64 = 60.0;

/// A part that a case requires.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Missing {
    pub(crate) part: Part,
    /// Sentence for messages.
    pub(crate) sentence: &'static str,
    /// Example lines for the case, as comments.
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

/// For a string whose topmost component belongs to an assembly.
const PIPE: Missing = Missing {
    part: Part::String,
    sentence: "the pipe above the topmost component: write it as the last [[string]], \"to surface\"",
    example: "[[string]]\ncomponent = \"drill pipe\"\ncatalogue = \"5 in 19.50 lb/ft S-135\"\nlength = \
              \"to surface\"",
};

/// Fills in the parts that may be assumed, and returns the missing ones.
pub(crate) fn complete(draft: &mut Draft) -> Vec<Missing> {
    friction(draft);
    let ends_in_pipe = top_component(draft);
    operations(draft);
    bit_depth(draft);
    let lacks = |part: Part| match part {
        Part::Survey => draft.survey.is_none(),
        Part::Hole => draft.hole.is_none(),
        Part::String => draft.string.is_none(),
        Part::Mud => !draft.mud.iter().any(|entry| entry.item.key == "density"),
        Part::Rig | Part::Operation => false,
    };
    let mut missing: Vec<Missing> =
        NEEDED.into_iter().filter(|needed| lacks(needed.part)).collect();
    if !ends_in_pipe {
        missing.push(PIPE);
    }
    missing
}

/// Adds the operations and the rotary speed.
fn operations(draft: &mut Draft) {
    let words = OPERATIONS.map(str::to_owned).to_vec();
    let assumed = [
        ("kind", Value::Words(words), "no file gives the operations of the string"),
        (
            "rpm",
            Value::Number(ROTARY_SPEED_REV_PER_MIN),
            "no file gives it; weights and torque at rest do not depend on it",
        ),
    ];
    for (at, (key, value, because)) in assumed.into_iter().enumerate() {
        if !draft.operation.iter().any(|entry| entry.item.key == key) {
            let origin = Origin::Assumed { because: because.to_owned() };
            draft.operation.insert(at, Sourced { file: 0, item: Entry { key, value, origin } });
        }
    }
}

/// Adds the default friction to sections without any.
fn friction(draft: &mut Draft) {
    let Some(Sourced { file, item: sections }) = &mut draft.hole else { return };
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
            "no file gives the friction of {assumed} of {} hole sections: {CASED} in casing, \
             {OPEN} in rock",
            sections.len()
        );
        draft.notes.push((Some(*file), Note::Assumed(text)));
    }
}

/// Extends the topmost component to the surface for any bit depth, if it is pipe; returns whether
/// the string reaches the surface.
fn top_component(draft: &mut Draft) -> bool {
    let Some(Sourced { file, item: components }) = &mut draft.string else { return true };
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

/// Sets the bit at the end of the hole, if the survey is deeper.
fn bit_depth(draft: &mut Draft) {
    if draft.operation.iter().any(|entry| entry.item.key == "bit_depth") {
        return;
    }
    let (Some(survey), Some(hole)) = (&draft.survey, &draft.hole) else { return };
    let end = hole.item.last().and_then(|section: &Block| section.get("to")).cloned();
    let (Some(last), Some(end)) = (survey.item.stations.last(), end) else { return };
    if end.si().is_some_and(|end_m| end_m < last.md_m) {
        let because = "the hole ends there, above the last station".to_owned();
        let entry =
            Entry { key: "bit_depth", value: end, origin: Origin::Derived { from: because } };
        draft.operation.push(Sourced { file: hole.file, item: entry });
    }
}
