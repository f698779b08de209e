//! Result of the solution of a well.

use wholestring::{
    operation::OperationKind,
    prelude::*,
    statics::{
        soft::{self, SoftSettings},
        stiff::{self, StiffError, StiffSettings},
    },
};

use crate::{clock::processor_time, well::well};

/// A well that was tried.
pub struct Try {
    pub seed: u64,
    pub weight_N: f64,
    pub kind: OperationKind,
    pub ms: f64,
    /// Newton steps; zero where the error of a string that locks up has no number.
    pub steps: usize,
    /// The largest compression over the loads of the sinusoid and of the helix.
    pub over: [f64; 2],
    pub end: End,
}

/// By the largest compression along the string.
#[derive(Clone, Copy, PartialEq)]
pub enum Class {
    Below,
    Buckled,
    Beyond,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    Found { stable: bool },
    LocksUp,
    Rolls,
    NotConverged,
}

impl Class {
    pub const ALL: [Self; 3] = [Self::Below, Self::Buckled, Self::Beyond];

    pub fn of(one: &Try) -> Self {
        match one.over {
            [sinusoidal, _] if sinusoidal < 1.0 => Self::Below,
            [_, helical] if helical <= 2.0 => Self::Buckled,
            _ => Self::Beyond,
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Below => "below the sinusoidal load",
            Self::Buckled => "to twice the helical load",
            Self::Beyond => "beyond",
        }
    }
}

impl Try {
    pub fn well(seed: u64, weight_N: f64) -> Self {
        let (model, operation) = well(seed, weight_N);
        let begin = processor_time();
        let solved = stiff::solve(&model, &operation, &StiffSettings::default());
        let ms = 1e3 * (processor_time() - begin).as_secs_f64();
        let (end, steps) = match solved {
            Ok(found) => {
                let convergence = found.convergence;
                (End::Found { stable: convergence.stable }, convergence.iterations)
            }
            Err(StiffError::LocksUp { .. }) => (End::LocksUp, 0),
            Err(StiffError::RunsAway { iterations, .. }) => (End::LocksUp, iterations),
            Err(StiffError::ElementBuckles { .. } | StiffError::ThroughWall { .. }) => {
                (End::NotConverged, 0)
            }
            Err(StiffError::Rolls { iterations, .. }) => (End::Rolls, iterations),
            Err(StiffError::NotConverged { iterations, .. }) => (End::NotConverged, iterations),
            Err(error) => panic!("well {seed}: {error}"),
        };
        let over = over(&model, &operation);
        Self { seed, weight_N, kind: operation.kind, ms, steps, over, end }
    }

    pub fn found(&self) -> bool {
        matches!(self.end, End::Found { .. })
    }
}

/// The largest compression along the soft string over the loads of the sinusoid and of the helix.
fn over(model: &Model, operation: &Operation) -> [f64; 2] {
    let soft = soft::solve(model, operation, &SoftSettings::default()).expect("a soft string");
    [&soft.sinusoidal_load_N, &soft.helical_load_N].map(|loads_N| {
        let pairs = soft.tension_N.iter().zip(loads_N);
        pairs.filter_map(|(tension_N, load_N)| Some(-tension_N / (*load_N)?)).fold(0.0, f64::max)
    })
}
