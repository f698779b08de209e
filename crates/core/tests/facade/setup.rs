//! A short vertical string that drills, and a run that is written to a checkpoint.

use wholestring::{
    dynamics::{Checkpoint, DynamicOutcome, ResumeError},
    prelude::*,
};

pub const BIT_DEPTH_M: f64 = 600.0;

pub fn model() -> Model {
    let path = Path::minimum_curvature(&[
        Station::from_degrees(0.0, 0.0, 0.0),
        Station::from_degrees(BIT_DEPTH_M, 20.0, 0.0),
    ])
    .expect("a sound survey");
    let hole = Hole::new(vec![HoleSection::open(0.0..BIT_DEPTH_M, 0.2159, 0.25)]);
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
        .catalogue("6-1/2 in x 2-13/16 in collar", Metres(60.0))
        .expect("a collar")
        .catalogue("5 in 19.50 lb/ft S-135", ToSurface)
        .expect("a pipe")
        .assemble(BIT_DEPTH_M)
        .expect("a sound string");
    let well = Well::new(path, hole.expect("a sound hole"));
    Model::new(well, string, Mud::of_density(1200.0))
}

pub fn drill() -> Operation {
    Operation::drill(BIT_DEPTH_M)
        .rotary_speed_rad_per_s(12.0)
        .weight_on_bit_N(40e3)
        .bit_torque_N_m(2e3)
        .rate_of_penetration_m_per_s(5e-3)
}

pub fn settings() -> DynamicsSettings {
    DynamicsSettings { settle_s: 2.0, duration_s: 2.0, ..DynamicsSettings::default() }
}

pub fn run(settings: &DynamicsSettings) -> DynamicOutcome {
    let mut simulation = Simulation::new(&model(), &drill(), settings).expect("a valid case");
    simulation.to_end().expect("a run that stays finite")
}

/// The bytes of a checkpoint after 1.5 s.
pub fn checkpoint(settings: &DynamicsSettings) -> Vec<u8> {
    let mut simulation = Simulation::new(&model(), &drill(), settings).expect("a valid case");
    simulation.advance(1.5).expect("a run that stays finite");
    postcard::to_stdvec(&simulation.checkpoint()).expect("plain data")
}

/// Results of a run; a run resumed by a new program, with equal but separate settings, gives the
/// same results to the bit.
#[track_caller]
pub fn assert_resumes(settings: impl Fn() -> DynamicsSettings) -> DynamicOutcome {
    let whole = run(&settings());
    let again = resumed(&settings(), &checkpoint(&settings())).expect("the same law");
    assert_eq!(whole, again);
    whole
}

/// A checkpoint of the law `own`, which keeps so many numbers, is refused with a sentence where the
/// settings have one called `other` as `what` or none of one's own, and so is one without it.
#[track_caller]
pub fn assert_refused(what: &str, numbers: usize, [own, other, plain]: [&DynamicsSettings; 3]) {
    let bytes = checkpoint(own);
    let error = resumed(other, &bytes).expect_err("another law");
    let state = format!("(state of length {numbers})");
    assert_eq!(
        error.to_string(),
        format!(
            "the checkpoint was written with `own` {state} as {what}, the settings have `other` \
             {state}"
        )
    );
    for (settings, bytes) in [(plain, bytes), (own, checkpoint(plain))] {
        let error = resumed(settings, &bytes).expect_err("another law");
        assert!(matches!(error, ResumeError::Damaged(_)), "{error}");
    }
}

/// Results of a run that is resumed from the bytes of a checkpoint.
pub fn resumed(settings: &DynamicsSettings, bytes: &[u8]) -> Result<DynamicOutcome, ResumeError> {
    let checkpoint: Checkpoint<'static> = postcard::from_bytes(bytes).expect("a whole checkpoint");
    let mut simulation = Simulation::resume(&model(), &drill(), settings, checkpoint)?;
    Ok(simulation.to_end().expect("a run that stays finite"))
}
