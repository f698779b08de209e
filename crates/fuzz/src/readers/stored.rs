//! Checkpoints: the file, the state of a string's run and that of a bit's trial, after a valid
//! checksum.

use std::fs;

use wholestring::{
    dynamics::{Checkpoint, Simulation},
    rock::{Alone, BitShape, DrillingSpec, Rock, Stepper, Trial, TrialSpec},
};
use wholestring_case::{Case, InMemory, parse};

use super::{
    reader::{New, Reader},
    results::Scratch,
};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] =
    &[("checkpoint", file), ("simulation", simulation), ("trial", trial)];

/// The container of a checkpoint.
fn file() -> Reader {
    type Content = (Vec<f64>, String, Option<u64>, Vec<Option<f64>>);
    let scratch = Scratch::new("checkpoint.bin");
    let content: Content = (vec![1.5; 30], "a word".into(), Some(7), vec![None; 20]);
    let folder = scratch.folder();
    folder.write_checkpoint(&content).expect("it is written");
    let seed = fs::read(folder.path().join("checkpoint.bin")).expect("it is there");
    Reader::binary("checkpoint", vec![seed], move |input| {
        scratch.put(input);
        match folder.read_checkpoint::<Content>() {
            Ok(content) => content.is_some(),
            Err(error) => {
                assert!(error.to_string().contains("checkpoint.bin"), "{error}");
                false
            }
        }
    })
}

/// A short string that drills with a motor, in a mud with a rheology, so that each part of a run is
/// present.
fn short_case() -> Case {
    const CASE: &str = r#"
        name = "short"
        model = "dynamic"
        [well]
        stations = [[0, 0, 0], [100, 0, 0], [200, 20, 45]]
        [[well.hole]]
        kind = "open"
        to = "200 m"
        diameter = "8.5 in"
        friction = 0.3
        [mud]
        density = "1.1 sg"
        [[string]]
        component = "bit"
        od = "8.5 in"
        length = "0.3 m"
        [[string]]
        component = "drill pipe"
        catalogue = "5 in 19.50 lb/ft G-105"
        length = "to surface"
        [bit]
        torque = "1 kN.m"
        [rig]
        top_drive_torque = "40 kN.m"
        [operation]
        kind = "drill"
        bit_depth = "200 m"
        rpm = 90
        wob = "5 kN"
        rop = "20 m/h"
        [mesh]
        element_length = "9.6 m"
        [dynamics]
        duration = "1 s"
        settle = "0.2 s"
        start = "centred"
    "#;
    parse("short.toml", CASE.as_bytes(), &InMemory::default(), &[])
        .unwrap_or_else(|report| panic!("{}", report.render(false)))
}

/// A run of a string that is resumed and continued.
fn simulation() -> Reader {
    let case = short_case();
    let operation = case.operations[0];
    let run = || Simulation::new(&case.model, &operation, &case.dynamics).expect("a run begins");
    let stored = |simulation: &Simulation| {
        postcard::to_allocvec(&simulation.checkpoint()).expect("plain data")
    };
    let mut under_way = run();
    under_way.advance(0.4).expect("it continues");
    let seeds = vec![stored(&run()), stored(&under_way)];
    let case = case.clone();
    Reader::binary("simulation", seeds, move |input| {
        let Ok(checkpoint) = postcard::from_bytes::<Checkpoint>(input) else {
            return false;
        };
        let resumed = Simulation::resume(&case.model, &operation, &case.dynamics, checkpoint);
        match resumed {
            Ok(mut simulation) => {
                let gone_on = simulation.advance(0.02);
                simulation.outcome();
                gone_on.is_ok()
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                false
            }
        }
    })
}

/// A trial of a bit on solid rock that is resumed and continued.
fn trial() -> Reader {
    let rock = Rock::for_drilling(60e6);
    let bit = BitShape::Pdc(wholestring::rock::bit_face::PdcBit::for_diameter(0.1));
    let drilling = DrillingSpec::new(rock, bit, 0.02).expect("a bit");
    let spec = TrialSpec {
        weight_N: 5e3,
        rotary_rad_per_s: 10.0,
        mass_kg: 1e3,
        settle_revolutions: 0.01,
        revolutions: 0.05,
        averaging_s: 0.01,
        step_s: 1e-3,
    };
    let mut trial = Trial::new(&spec, &drilling).expect("a trial begins");
    trial.advance(3, &Stepper::default(), &Alone).expect("it continues");
    let seeds = vec![postcard::to_allocvec(&trial).expect("plain data")];
    Reader::binary("trial", seeds, move |input| {
        let Ok(mut trial) = postcard::from_bytes::<Trial>(input) else {
            return false;
        };
        trial.check(&spec, &drilling).is_ok()
            && trial.advance(2, &Stepper::default(), &Alone).is_ok()
    })
}
