//! Cost of each mechanism when it is switched on.

use serde::Serialize;

use super::{clock::Spread, session::Bench, well};
use crate::Error;

/// A mechanism that a case can switch on, by keys of the case as for `--set`.
struct Mechanism {
    name: &'static str,
    keys: &'static [&'static str],
}

const fn with(name: &'static str, keys: &'static [&'static str]) -> Mechanism {
    Mechanism { name, keys }
}

/// Mechanisms in the order of the book, with typical field values so that each one is active.
const MECHANISMS: &[Mechanism] = &[
    with("linear contact", &["dynamics.contact_law=linear"]),
    with("independent friction", &["dynamics.friction_law=independent"]),
    with(
        "friction at rest",
        &[
            "well.hole.0.friction={ kinetic = 0.3, static = 0.4 }",
            "well.hole.1.friction={ kinetic = 0.3, static = 0.4 }",
        ],
    ),
    with(
        "friction around other than along",
        &[
            "well.hole.0.friction={ kinetic = 0.3, around = 0.25 }",
            "well.hole.1.friction={ kinetic = 0.3, around = 0.25 }",
        ],
    ),
    with("rough, winding wall", &["well.roughness.rms=0.5 mm", "well.roughness.tortuosity=2 mm"]),
    with(
        "viscous mud, pumps on",
        &[
            "mud.rheology=bingham",
            "mud.plastic_viscosity=20 cP",
            "mud.yield_point=5 Pa",
            "operation.flow_rate=30 L/s",
        ],
    ),
    with("bent motor housing", &["string.1.bend=1.5 deg", "string.1.bend_at=2 m"]),
    with("eccentric collar", &["string.4.eccentricity=5 mm"]),
    with("eccentric pipe, all of it", &["string.10.eccentricity=1 mm"]),
    with("stiff top drive", &["top_drive.control=pi"]),
    with("SoftTorque", &["top_drive.control=soft-torque"]),
    with("Z-Torque", &["top_drive.control=z-torque"]),
    with("block on the hoist", &["hoist.mass=25 t"]),
    with("schedule under way", &["operation.schedule=[{ at = 0.5, ramp = 10, rpm = 90 }]"]),
    with(
        "excitation of the bit",
        &[
            "bit.excitation.amplitude=1 mm",
            "bit.excitation.roughness=0.5 mm",
            "bit.excitation.torque_fluctuation=0.1",
        ],
    ),
    with("regenerative bit", &["bit.law=regenerative"]),
    with("bit in three regimes", &["bit.law=detournay-defourny", "bit.steerability=0.05"]),
    with(
        "bit from a table, with its spread",
        &[
            "bit.law=table",
            "bit.table.points=[[30e3, 60, 3, 2e3, 300], [30e3, 120, 6, 2e3, 300], [90e3, 60, 9, \
             6e3, 900], [90e3, 120, 18, 6e3, 900]]",
            "bit.excitation.lobes=3",
        ],
    ),
    with(
        "mud motor",
        &[
            "operation.flow_rate=30 L/s",
            "bit.motor={ displacement = \"20 L\", max_differential_pressure = \"5 MPa\" }",
        ],
    ),
    with("statistics every ms, not every 10", &["dynamics.sample_interval=1 ms"]),
    with("frames, 10 in a second", &["records.frames=10 Hz"]),
];

/// Measured costs of the mechanisms.
#[derive(Debug, Serialize)]
pub struct Mechanisms {
    /// Time of a step per element without any mechanism.
    pub ns_per_element_step: f64,
    /// A row for each mechanism.
    pub rows: Vec<MechanismRow>,
}

/// Cost of one mechanism.
#[derive(Debug, Serialize)]
pub struct MechanismRow {
    /// Its name.
    pub mechanism: &'static str,
    /// Time of a step per element with the mechanism.
    pub ns_per_element_step: f64,
    /// Processor time for the same simulated time, relative to that without the mechanism.
    pub time_ratio: Spread,
}

impl Bench<'_> {
    /// Measures the cost of each mechanism when it is switched on.
    ///
    /// # Errors
    /// As [`Self::kernel`].
    pub fn mechanisms(&self) -> Result<Mechanisms, Error> {
        self.begin(1 + MECHANISMS.len());
        let plain_case = self.well.case(&[])?;
        let plain = well::initialise(&plain_case, plain_case.dynamics.precision)?;
        let mut plain_s = Vec::new();
        let mut rows = Vec::new();
        self.next("a run without any mechanism")?;
        for mechanism in MECHANISMS {
            self.next(mechanism.name)?;
            let case = self.well.case(mechanism.keys)?;
            let simulation = well::initialise(&case, case.dynamics.precision)?;
            let mut run_s = Vec::new();
            // The two runs alternate, so that a processor that slows down affects both.
            let ratio = self.repeat(|| {
                let without = self.well.run_s(&plain_case, &plain)?;
                let with = self.well.run_s(&case, &simulation)?;
                plain_s.push(without);
                run_s.push(with);
                Ok(with / without)
            })?;
            rows.push(MechanismRow {
                mechanism: mechanism.name,
                ns_per_element_step: ns(&simulation, run_s),
                time_ratio: ratio,
            });
        }
        Ok(Mechanisms { ns_per_element_step: ns(&plain, plain_s), rows })
    }
}

/// Converts the run times, s per simulated second, to nanoseconds per element and step.
fn ns(simulation: &wholestring::dynamics::Simulation, run_s: Vec<f64>) -> f64 {
    1e9 * Spread::of(run_s).median / simulation.element_steps_per_s()
}
