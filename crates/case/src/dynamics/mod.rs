//! `[dynamics]`.

pub(crate) mod effort;
pub(crate) mod mesh;
pub(crate) mod records;

use wholestring::{
    dynamics::{
        Autodriller, BitSettings, CentredStart, ContactLaw, DynamicsSettings, FrictionLaw,
        HoistControl, Precision, RodDamping, Schedule, Start, StartTension, TopDriveSettings,
        UntilSteady,
    },
    operation::Operation,
    well::{Hole, HoleSection},
};
use wholestring_config::prelude::*;

use crate::{
    dynamics::mesh::MeshTable,
    rig::HoistTable,
    values::auto::{AutoOr, AutoOrQuantity},
};

/// Default wall-clock time between checkpoints, s: an acceptable loss of computing time.
const CHECKPOINT_INTERVAL_S: f64 = 30.0;

/// Maximum number of rows in the tables of a run; more rows need memory and disk without adding
/// insight.
const MAX_SAMPLES: f64 = 2e6;

/// The contact laws, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Contact {
    Hertz,
    Linear,
}

table! {
    /// Rayleigh damping of the rod.
    DampingTable in "[dynamics.damping]" {
        /// Proportional to mass, 1/s, on velocities relative to the string's rigid motion.
        mass: f64 = default(
            Quantity::si(Dimension::Frequency, Range::from_to(0.0, 100.0).usual(1e-4, 50.0), "0.1 1/s"),
            DynamicsSettings::default().damping.mass_per_s,
        );
        /// Proportional to stiffness, s, on strain rates.
        stiffness: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(0.0, 0.01), "1e-4 s"),
            DynamicsSettings::default().damping.stiffness_s,
        );
    }
}

table! {
    /// Settings of the dynamic model; the others ignore them.
    DynamicsTable in "[dynamics]" {
        /// Length of the window that the statistics cover.
        duration: f64 = default(
            Quantity::si(Dimension::Time, Range::positive_to(86_400.0).usual(0.01, 86_400.0), "60 s"),
            DynamicsSettings::default().duration_s,
        );
        /// Simulated time before that window, or "auto": until the string is steady, 120 s at most.
        /// With a schedule it lasts beyond the end of the last line, and the 120 s count from
        /// there.
        settle: AutoOr = default(
            AutoOrQuantity {
                quantity: Quantity::si(Dimension::Time, Range::from_to(0.0, 86_400.0), "20 s"),
                noun: "a time",
                auto: "Until the string is steady.",
            },
            AutoOr::Auto,
        );
        /// Position of the string at time zero: "prepared" (on its contact side with the soft
        /// string's tension and torque) or "centred" (on the hole's axis, untwisted, at rest).
        start: Start = default(
            Choice {
                noun: "a start",
                words: &[("prepared", Start::Prepared), ("centred", Start::Centred)],
            },
            DynamicsSettings::default().start,
        );
        /// Centred start: tension of the string at time zero. "static" (the tension of the string
        /// that hangs in its hole without friction, its weight on the bit included) or "cold"
        /// (none: its whole weight is applied at once, and the string rings axially).
        start_tension: StartTension = default(
            Choice {
                noun: "a tension",
                words: &[("static", StartTension::Static), ("cold", StartTension::Cold)],
            },
            CentredStart::default().tension,
        );
        /// Centred start: time in which the top reaches its rotary speed, linearly. Raising it
        /// softens the torsional wave that the start sends down the string.
        start_ramp: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(0.0, 3600.0), "1 s"),
            CentredStart::default().ramp_s,
        );
        /// "vector" (friction opposes the resultant sliding velocity) or "independent" (full
        /// friction axially and full friction around, up to 1.41 times too strong in sum).
        friction_law: FrictionLaw = default(
            Choice {
                noun: "a friction law",
                words: &[
                    ("vector", FrictionLaw::Vector),
                    ("independent", FrictionLaw::Independent),
                ],
            },
            DynamicsSettings::default().friction_law,
        );
        /// Sliding speed at which half of the excess of static over kinetic friction has decayed.
        /// Raising it keeps more of the static friction in slow sliding. Used where a hole section
        /// has static friction.
        stribeck_speed: f64 = default(
            Quantity::si(Dimension::TripSpeed, Range::from_to(1e-4, 100.0).usual(1e-3, 10.0), "0.1 m/s"),
            DynamicsSettings::default().stribeck_speed_m_per_s,
        );
        /// "hertz" (stiffness from the elastic constants and radii of pipe and hole) or "linear" (a
        /// spring and a dashpot).
        contact_law: Contact = default(
            Choice {
                noun: "a contact law",
                words: &[("hertz", Contact::Hertz), ("linear", Contact::Linear)],
            },
            Contact::Hertz,
        );
        /// Linear contact: stiffness of the contact of one node. Means do not change with it from
        /// 2e7 to 2e11 N/m.
        contact_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e3, 1e13).usual(1e5, 1e11), "1e8 N/m"),
            1e8,
        );
        /// Linear contact: damping as a fraction of the critical damping of the node on its
        /// contact. Raising it reduces the rebound of impacts.
        contact_damping_ratio: f64 = default(
            Number { unit: "", range: Range::from_to(0.0, 2.0) },
            0.05,
        );
        /// Hertz contact: dissipation of Hunt and Crossley, s/m. Raising it reduces the rebound of
        /// impacts.
        hertz_dissipation: f64 = default(
            Quantity::si(Dimension::DissipationTime, Range::from_to(0.0, 100.0), "0.5 s/m"),
            hertz_dissipation_default(),
        );
        /// Rayleigh damping of the rod.
        damping: DampingTable = optional(Section::<DampingTable>::RULE);
        /// Time between samples of the statistics and rows of the time table. Contact forces are
        /// averaged over it.
        sample_interval: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(1e-4, 10.0), "10 ms"),
            DynamicsSettings::default().sample_interval_s,
        );
        /// Wall-clock time between checkpoints, from which `--resume` continues a run that was
        /// stopped or killed. Lowering it reduces the loss in that case; each checkpoint costs some
        /// hundredths of a second. Results do not depend on it.
        checkpoint_interval: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(0.01, 86_400.0), "30 s"),
            CHECKPOINT_INTERVAL_S,
        );
        /// Seed of the microscopic lateral disturbance that breaks the symmetry of the start, and
        /// of the bit's excitation.
        seed: u64 = default(Whole, DynamicsSettings::default().seed);
        /// "double" or "single": sixteen digits, or seven in six tenths of the time, for strings
        /// that turn all the time in elements of at least 1 m. Over ten minutes of quiet rotation
        /// the two agree to a millionth.
        precision: Precision = default(
            Choice {
                noun: "a precision",
                words: &[("double", Precision::Double), ("single", Precision::Single)],
            },
            DynamicsSettings::default().precision,
        );
    }
}

fn hertz_dissipation_default() -> f64 {
    match DynamicsSettings::default().contact_law {
        ContactLaw::Hertz { dissipation_s_per_m } => dissipation_s_per_m,
        ContactLaw::Linear { .. } => 0.0,
    }
}

/// Inputs of a dynamic run from other tables; missing ones have been reported.
pub(crate) struct GivenSettings<'a> {
    pub(crate) hoist: &'a HoistTable,
    pub(crate) bit: Option<BitSettings>,
    pub(crate) top_drive: Option<TopDriveSettings>,
    pub(crate) schedule: Option<Schedule>,
}

impl DynamicsTable {
    /// End of the run, s, if the case gives it.
    pub(crate) fn end_s(&self) -> Option<f64> {
        Some(self.settle.get()?.given()? + *self.duration.get()?)
    }

    /// Time between samples, s.
    pub(crate) fn sample_interval_s(&self) -> Option<f64> {
        self.sample_interval.get().copied()
    }

    pub(crate) fn build(
        &self,
        mesh: &MeshTable,
        given_settings: GivenSettings<'_>,
        reader: &mut Reader,
    ) -> Option<DynamicsSettings> {
        let GivenSettings { hoist, bit, top_drive, schedule } = given_settings;
        self.warn_of_centred_keys(reader);
        mesh.warn_of_idle_keys(reader);
        let contact_law = self.contact(reader);
        let plan = schedule.clone().unwrap_or_default();
        let hoist_control = hoist.control(&plan, reader);
        let autodriller = hoist.autodriller(reader);
        self.check_samples(reader)?;
        let damping = self.damping.get()?;
        Some(DynamicsSettings {
            mesh: mesh.settings()?,
            duration_s: *self.duration.get()?,
            // Chosen by the program.
            settle_s: self.settle.get()?.given().unwrap_or(0.0),
            steady: match *self.settle.get()? {
                AutoOr::Auto => Some(UntilSteady::default()),
                AutoOr::Given(_) => None,
            },
            start: *self.start.get()?,
            centred: CentredStart {
                tension: *self.start_tension.get()?,
                ramp_s: *self.start_ramp.get()?,
            },
            friction_law: *self.friction_law.get()?,
            stribeck_speed_m_per_s: *self.stribeck_speed.get()?,
            // Set by programs only.
            friction_coefficient: None,
            contact_law: contact_law?,
            damping: RodDamping {
                mass_per_s: *damping.mass.get()?,
                stiffness_s: *damping.stiffness.get()?,
            },
            hoist_control: hoist_control?,
            lift_tolerance: *hoist.tolerance.get()?,
            // An operation that selects the autodriller by default uses its default settings.
            autodriller: if hoist_control? == Some(HoistControl::Autodriller)
                || plan.holds_a_weight()
            {
                autodriller?
            } else {
                autodriller.map(|_| Autodriller::default())?
            },
            top_drive: top_drive?,
            schedule: schedule?,
            hoist_line: hoist.line()?,
            bit: bit?,
            sample_interval_s: *self.sample_interval.get()?,
            // [records] lists the recorded nodes.
            probes: Vec::new(),
            seed: *self.seed.get()?,
            precision: *self.precision.get()?,
        })
    }

    /// Warns of single precision where it does not suffice.
    pub(crate) fn check_precision(
        &self,
        operations: &[Operation],
        dynamics: &DynamicsSettings,
        reader: &mut Reader,
    ) -> Option<()> {
        for operation in operations {
            if let Err(reason) = dynamics.precision.serves(operation, dynamics) {
                let precision = self.precision.at()?;
                return Diagnostic::error(format!(
                    "single precision does not serve \"{}\" here",
                    operation.kind.name()
                ))
                .at(precision.place, "expected \"double\"")
                .help(reason)
                .refuse(reader);
            }
        }
        Some(())
    }

    /// Warns of a Stribeck speed without static friction that could decay.
    pub(crate) fn check_stribeck(&self, hole: &Hole, reader: &mut Reader) {
        let decays = |section: &HoleSection| section.friction.at_rest > section.friction.kinetic;
        if let Some(entry) = self.stribeck_speed.given()
            && !hole.sections().iter().any(decays)
        {
            let why = "used with `static` friction above `kinetic` in a hole section";
            reader.report(Diagnostic::idle("stribeck_speed", entry.place, why));
        }
    }

    /// Warns of keys of a centred start where the start is another.
    fn warn_of_centred_keys(&self, reader: &mut Reader) {
        if self.start.get() != Some(&Start::Prepared) {
            return;
        }
        for (place, name) in
            [(self.start_tension.place(), "start_tension"), (self.start_ramp.place(), "start_ramp")]
        {
            let Some(place) = place else { continue };
            Diagnostic::idle(name, place, "used with start = \"centred\"")
                .chosen("the start", self.start.place(), "prepared")
                .report(reader);
        }
    }

    fn contact(&self, reader: &mut Reader) -> Option<ContactLaw> {
        let law = self.contact_law.at()?;
        for (field, name, owner, word) in [
            (&self.contact_stiffness, "contact_stiffness", Contact::Linear, "linear"),
            (&self.contact_damping_ratio, "contact_damping_ratio", Contact::Linear, "linear"),
            (&self.hertz_dissipation, "hertz_dissipation", Contact::Hertz, "hertz"),
        ] {
            let Some(entry) = field.given().filter(|_| owner != law.value) else { continue };
            Diagnostic::idle(name, entry.place, format!("used with contact_law = \"{word}\""))
                .chosen("the contact law", self.contact_law.place(), "hertz")
                .report(reader);
        }
        Some(match law.value {
            Contact::Hertz => {
                ContactLaw::Hertz { dissipation_s_per_m: *self.hertz_dissipation.get()? }
            }
            Contact::Linear => ContactLaw::Linear {
                stiffness_N_per_m: *self.contact_stiffness.get()?,
                damping_ratio: *self.contact_damping_ratio.get()?,
            },
        })
    }

    fn check_samples(&self, reader: &mut Reader) -> Option<()> {
        let duration = self.duration.at()?;
        let interval = self.sample_interval.at()?;
        let settle_s = match *self.settle.get()? {
            AutoOr::Auto => UntilSteady::default().max_s,
            AutoOr::Given(settle_s) => settle_s,
        };
        let prefer = |preferred: Span, is_given: bool, other: Span| {
            if is_given { preferred } else { other }
        };
        let place = prefer(duration.place, self.duration.given().is_some(), interval.place);
        if interval.value > duration.value {
            return Diagnostic::error("the window is shorter than one sample")
                .at(place, format!("window of {} s", number_text(duration.value)))
                .help(format!("sample_interval is {} s", number_text(interval.value)))
                .refuse(reader);
        }
        let samples = (duration.value + settle_s) / interval.value;
        if samples > MAX_SAMPLES {
            return Diagnostic::error(format!(
                "{} s sampled every {} s make {} rows",
                number_text(duration.value + settle_s),
                number_text(interval.value),
                number_text(samples.ceil())
            ))
            .at(place, format!("expected at most {} rows", number_text(MAX_SAMPLES)))
            .help("shorten duration and settle, or raise sample_interval")
            .refuse(reader);
        }
        Some(())
    }
}
