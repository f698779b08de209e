//! A run to its end, and who looks at it.

use std::ops::ControlFlow;

use wholestring::{
    dynamics::{Observer, UntilSteady},
    prelude::*,
};

use crate::setup::{drill, model, run, settings};

/// The run to its end is the one that was always possible, sample for sample.
#[test]
fn to_end_is_the_whole_window() {
    let whole = run(&settings());
    let mut by_hand = Simulation::new(&model(), &drill(), &settings()).expect("a valid case");
    by_hand.advance(4.0).expect("a run that stays finite");
    assert_eq!(whole, by_hand.outcome());
    assert!((whole.series.time_s[whole.series.time_s.len() - 1] - 4.0).abs() < 0.01);
}

/// Where settling ends by itself, the end is unknown at the beginning.
#[test]
fn to_end_waits_until_the_string_is_steady() {
    let settings = DynamicsSettings { steady: Some(UntilSteady { max_s: 30.0 }), ..settings() };
    let outcome = run(&settings);
    let last_s = outcome.series.time_s[outcome.series.time_s.len() - 1];
    let expected_s = outcome.numerics.settle_s + settings.duration_s;
    assert!((last_s - expected_s).abs() < 0.011, "{last_s} {expected_s}");
}

#[derive(Default)]
struct Count {
    samples: usize,
    stop_at: usize,
}

impl Observer for Count {
    fn sampled(&mut self, simulation: &Simulation) -> ControlFlow<()> {
        self.samples += 1;
        assert_eq!(simulation.series().time_s.len(), self.samples);
        if self.samples == self.stop_at {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}

/// It sees every sample, can stop the run, and changes nothing.
#[test]
fn an_observer_sees_every_sample_and_can_stop() {
    let mut simulation = Simulation::new(&model(), &drill(), &settings()).expect("a valid case");
    let mut count = Count { stop_at: 30, ..Count::default() };
    let stopped = simulation.to_end_with(&mut count);
    assert_eq!(stopped.expect("finite").series.time_s.len(), 30);
    count.stop_at = 0;
    let flow = simulation.advance_with(0.5, &mut count).expect("finite");
    assert!(flow.is_continue());
    let samples = (0.5 / simulation.sample_interval_s()).round() as usize;
    assert_eq!(count.samples, 30 + samples);
    let whole = simulation.to_end_with(&mut count).expect("finite");
    assert_eq!(count.samples, whole.series.time_s.len());
    assert_eq!(whole, run(&settings()));
}
