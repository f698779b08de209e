//! Laws defined by Python functions.

use std::sync::{Arc, Mutex, PoisonError};

use pyo3::prelude::*;
use wholestring::dynamics::Shake;
use wholestring_runner::run::{BitAnswer, BitReading, OwnLaws, SampledLaw, ShakeReading};

use crate::error;

/// Exception of a function called by a run.
#[derive(Clone, Default)]
pub(crate) struct Raised(Arc<Mutex<Option<PyErr>>>);

impl Raised {
    /// Takes it.
    pub(crate) fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    /// Two numbers from a Python function; none if it raised an exception, which is kept.
    fn ask<const N: usize>(&self, function: &Py<PyAny>, numbers: [f64; N]) -> Option<[f64; 2]> {
        let answer = Python::attach(|py| {
            let arguments = pyo3::types::PyTuple::new(py, numbers)?;
            function.bind(py).call1(arguments)?.extract::<(f64, f64)>()
        });
        match answer {
            Ok((one, other)) => Some([one, other]),
            Err(error) => {
                self.keep(error);
                None
            }
        }
    }

    fn keep(&self, error: PyErr) {
        // The first exception is the reason why the run stops.
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }

    /// An invalid return value is raised as an exception of the function.
    fn refuse<T>(&self, expected: &str, [one, other]: [f64; 2]) -> Option<T> {
        let message = format!("{expected}, not ({one}, {other})");
        self.keep(error::bad_input(message));
        None
    }
}

/// A function with its name and its rate, Hz.
pub(crate) type Function = (Py<PyAny>, String, f64);

/// The laws of a run, and their exceptions.
pub(crate) fn laws(bit_law: Option<Function>, excitation: Option<Function>) -> (OwnLaws, Raised) {
    let raised = Raised::default();
    let bit_law = bit_law.map(|(function, name, rate_Hz)| {
        let raised = raised.clone();
        let ask = move |reading: &BitReading| {
            let inputs = [
                reading.time_s,
                reading.weight_on_bit_N,
                reading.rotary_speed_rad_per_s,
                reading.angle_rad,
                reading.drilled_m,
            ];
            let answer @ [depth_of_cut_m, torque_N_m] = raised.ask(&function, inputs)?;
            if answer.iter().any(|answer| !answer.is_finite() || *answer < 0.0) {
                let expected =
                    "a bit law returns a depth of cut and a torque, finite and zero or more";
                return raised.refuse(expected, answer);
            }
            Some(BitAnswer { depth_of_cut_m, torque_N_m })
        };
        SampledLaw { name, rate_Hz, ask: Arc::new(ask) }
    });
    let excitation = excitation.map(|(function, name, rate_Hz)| {
        let raised = raised.clone();
        let ask = move |reading: &ShakeReading| {
            let answer @ [front_m, torque] =
                raised.ask(&function, [reading.time_s, reading.angle_rad])?;
            if answer.iter().any(|answer| !answer.is_finite()) {
                let expected = "an excitation returns a length and a part of torque, finite";
                return raised.refuse(expected, answer);
            }
            Some(Shake { front_m, torque })
        };
        SampledLaw { name, rate_Hz, ask: Arc::new(ask) }
    });
    (OwnLaws { bit_law, excitation }, raised)
}
