//! `[rig]` and `[hoist]`.

pub(crate) mod top_drive;

use wholestring::{
    GRAVITY_M_PER_S2,
    dynamics::{
        Autodriller, DynamicsSettings, HoistControl, HoistLine, Schedule, WEIGHT_TOLERANCE,
    },
    operation::Operation,
    rig::Rig,
};
use wholestring_config::prelude::*;

/// Tolerance between the block's weight and its mass, for rounding, as a part of the weight.
const SAME_BLOCK: f64 = 0.05;

table! {
    /// Limits of the rig. A run warns of an operation that exceeds them; only `snubbing_force`
    /// changes the dynamic model.
    RigTable in "[rig]" {
        /// Weight of travelling block and top drive. Never part of the reported hook load. Their
        /// inertia is `mass` of `[hoist]`.
        block_weight: f64 = optional(Quantity::si(
            Dimension::Force, Range::from_to(0.0, 1e8).usual(1e4, 2e7), "20 tf",
        ));
        /// Largest load that the hoist carries, block included.
        hoist_capacity: f64 = optional(force("450 tf"));
        /// Largest force with which the rig pushes the string into the hole, the block's weight
        /// excluded: of a snubbing unit, an injector head for coiled tubing, a pull-down. The hook
        /// load can then fall to minus this force; where more is needed the string does not go
        /// down. Default: none, the rig only lifts.
        snubbing_force: f64 = optional(force("250 kN"));
        /// Rated (continuous) torque of the top drive.
        top_drive_torque: f64 = optional(torque("45 kN.m"));
        /// Largest torque of the top drive for a short time. A dynamic run may reach it at times;
        /// its mean is compared with the rated torque.
        top_drive_peak_torque: f64 = optional(torque("70 kN.m"));
        /// Largest pressure of pumps, standpipe and hoses.
        pump_pressure_limit: f64 = optional(Quantity::si(
            Dimension::Pressure,
            Range::positive_to(2e8).usual(5e6, 1.1e8),
            "345 bar",
        ));
    }
}

fn torque(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Torque, Range::positive_to(1e6).usual(2e3, 2e5), example)
}

fn force(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Force, Range::positive_to(1e8).usual(1e4, 2e7), example)
}

impl RigTable {
    pub(crate) fn build(&self, reader: &mut Reader) -> Option<Rig> {
        let block = self.block_weight.optional()?;
        let capacity = self.hoist_capacity.optional()?;
        if let (Some(block), Some(capacity)) = (block, capacity)
            && block.value >= capacity.value
        {
            return Diagnostic::error("the hoist does not carry its own block")
                .at(block.place, "weight of block and top drive")
                .at(capacity.place, "largest load, block included")
                .refuse(reader);
        }
        let torque = self.top_drive_torque.optional()?;
        let peak = self.top_drive_peak_torque.optional()?;
        if let (Some(torque), Some(peak)) = (torque, peak)
            && peak.value < torque.value
        {
            return Diagnostic::error("the top drive's peak torque is below its rated one")
                .at(peak.place, "for a short time")
                .at(torque.place, "all the time")
                .refuse(reader);
        }
        Some(Rig {
            block_weight_N: block.map(|at| at.value),
            hoist_capacity_N: capacity.map(|at| at.value),
            snubbing_force_N: self.snubbing_force.optional()?.map(|at| at.value),
            top_drive_torque_N_m: torque.map(|at| at.value),
            top_drive_peak_torque_N_m: peak.map(|at| at.value),
            pump_pressure_limit_Pa: self.pump_pressure_limit.optional()?.map(|at| at.value),
        })
    }
}

/// The ways of moving the top of the string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Control {
    Autodriller,
    BlockVelocity,
    HookLoad,
    TunedLift,
}

/// The word of the control that is found before the run.
pub(crate) const TUNED_LIFT: &str = "tuned-lift";

const AUTODRILLER: &str = "autodriller";
const BLOCK_VELOCITY: &str = "block-velocity";
const HOOK_LOAD: &str = "hook-load";

impl Control {
    const WORDS: &[(&'static str, Self)] = &[
        (AUTODRILLER, Self::Autodriller),
        (BLOCK_VELOCITY, Self::BlockVelocity),
        (HOOK_LOAD, Self::HookLoad),
        (TUNED_LIFT, Self::TunedLift),
    ];
}

table! {
    /// Axial motion of the top of the string in the dynamic model.
    HoistTable in "[hoist]" {
        /// "autodriller" (the block follows the bit to keep the weight on bit at `wob`),
        /// "block-velocity" (constant speed), "hook-load" (constant lifting force) or "tuned-lift"
        /// (the constant lifting force under which the mean weight on bit over the window is `wob`:
        /// it is found in several runs of the case, and the summary shows it). Default: the
        /// autodriller where the bit is on bottom, the operation's own constant speed elsewhere.
        control: Control = optional(Choice {
            noun: "a hoist control",
            words: Control::WORDS,
        });
        /// Autodriller: block speed per missing weight on bit. Raising it follows the weight on bit
        /// faster, until the control loop hunts.
        gain: f64 = default(
            Quantity::si(Dimension::HoistGain, Range::positive_to(1e-3), "1e-4 m/s/kN"),
            Autodriller::default().gain_m_per_s_per_N,
        ).used_with(&[AUTODRILLER]);
        /// Autodriller: time in which a lasting lack of weight adds as much speed again as `gain`
        /// gives at once. Raising it removes the remaining deviation more slowly; if it is too
        /// short, the control loop hunts. Default: none.
        integral_time: f64 = optional(Quantity::si(
            Dimension::Time,
            Range::positive_to(1e5),
            "60 s",
        )).used_with(&[AUTODRILLER]);
        /// Autodriller: time constant of the filter on the measured weight on bit.
        filter: f64 = default(
            Quantity::si(Dimension::Time, Range::positive_to(1e3), "1 s"),
            Autodriller::default().filter_s,
        ).used_with(&[AUTODRILLER]);
        /// Autodriller: lowest speed of the block, positive downwards; a negative one lets it pick
        /// the string up.
        min_speed: f64 = default(
            Quantity::si(Dimension::TripSpeed, Range::from_to(-10.0, 10.0), "-10 m/h"),
            Autodriller::default().min_speed_m_per_s,
        ).used_with(&[AUTODRILLER]);
        /// Autodriller: highest speed of the block. Default: none.
        max_speed: f64 = optional(Quantity::si(
            Dimension::TripSpeed,
            Range::from_to(-10.0, 10.0),
            "60 m/h",
        )).used_with(&[AUTODRILLER]);
        /// Block velocity: speed of the block, positive downwards.
        block_velocity: f64 = optional(Quantity::si(
            Dimension::TripSpeed,
            Range::from_to(-10.0, 10.0),
            "0.3 m/s",
        )).used_with(&[BLOCK_VELOCITY]);
        /// Hook load: lifting force on the top of the string, block excluded. A negative one
        /// pushes, no more than `snubbing_force` of `[rig]`.
        hook_load: f64 = optional(Quantity::si(
            Dimension::Force,
            Range::from_to(-1e8, 1e8).usual(-1e6, 2e7),
            "900 kN",
        )).used_with(&[HOOK_LOAD]);
        /// Tuned lift: tolerance of the mean weight on bit, as a part of `wob`. Raising it requires
        /// fewer runs.
        tolerance: f64 = default(
            Number { unit: "", range: Range::from_to(1e-4, 0.5) },
            WEIGHT_TOLERANCE,
        ).used_with(&[TUNED_LIFT]);
        /// Axial stiffness of lines and derrick.
        stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e3, 1e12).usual(1e5, 1e10), "1e7 N/m"),
            DynamicsSettings::default().hoist_line.stiffness_N_per_m,
        );
        /// Damping of lines and derrick. Without it a short string rings.
        damping: f64 = default(
            Quantity::si(Dimension::Damping, Range::from_to(0.0, 1e9), "1e5 N.s/m"),
            DynamicsSettings::default().hoist_line.damping_N_s_per_m,
        );
        /// Mass of travelling block and top drive, which move with the top of the string. Raising
        /// it slows the top's axial swings; the reported hook load never includes its weight. A
        /// difference of more than 5 % from `block_weight` of `[rig]` gives a warning.
        mass: f64 = default(
            Quantity::si(Dimension::Mass, Range::from_to(0.0, 1e6).usual(500.0, 2e5), "25 t"),
            DynamicsSettings::default().hoist_line.block_mass_kg,
        );
    }
}

impl HoistTable {
    /// Warns where the block's weight, for the rig's limits, contradicts its mass, for its motion.
    pub(crate) fn check_block(&self, rig: &RigTable, reader: &mut Reader) {
        let (Some(weight), Some(mass)) = (rig.block_weight.given(), self.mass.given()) else {
            return;
        };
        let weight_kg = weight.value / GRAVITY_M_PER_S2;
        if (mass.value - weight_kg).abs() > SAME_BLOCK * weight_kg {
            Diagnostic::warning("the block's mass is not that of its weight")
                .at(mass.place, format!("{} kg move", number_text(mass.value.round())))
                .at(weight.place, format!("{} kg hang", number_text(weight_kg.round())))
                .help(
                    "both are of travelling block and top drive: the mass acts in the \
                           dynamic model, the weight on the limits of the rig",
                )
                .report(reader);
        }
    }

    /// Warns of a push that exceeds the rig's.
    pub(crate) fn check_push(&self, rig: &RigTable, reader: &mut Reader) {
        let Some(load) = self.hook_load.given() else { return };
        let push = rig.snubbing_force.given();
        let most_N = push.map_or(0.0, |at| at.value);
        if load.value >= -most_N {
            return;
        }
        let units = reader.units();
        let force = |force_N: f64| shown(Dimension::Force, force_N, units);
        let mut diagnostic = Diagnostic::error("the rig does not push so hard")
            .at(load.place, format!("pushes with {}", force(-load.value)));
        diagnostic = match push {
            Some(push) => diagnostic.at(push.place, "the most that it gives"),
            None => diagnostic.help("a rig that pushes has a snubbing_force in [rig]"),
        };
        diagnostic.report(reader);
    }

    pub(crate) fn line(&self) -> Option<HoistLine> {
        Some(HoistLine {
            stiffness_N_per_m: *self.stiffness.get()?,
            damping_N_s_per_m: *self.damping.get()?,
            block_mass_kg: *self.mass.get()?,
        })
    }

    /// Returns the settings of the autodriller, for any control.
    pub(crate) fn autodriller(&self, reader: &mut Reader) -> Option<Autodriller> {
        let (min, max) = (self.min_speed.at()?, self.max_speed.optional()?);
        if let Some(max) = max
            && max.value <= min.value
        {
            return Diagnostic::error("the block's highest speed is not above its lowest")
                .at(
                    max.place,
                    format!("expected more than {}", reader.shown(Dimension::TripSpeed, min.value)),
                )
                .refuse(reader);
        }
        let integral_time = self.integral_time.optional()?;
        Some(Autodriller {
            gain_m_per_s_per_N: *self.gain.get()?,
            integral_time_s: integral_time.map_or(f64::INFINITY, |at| at.value),
            filter_s: *self.filter.get()?,
            min_speed_m_per_s: min.value,
            max_speed_m_per_s: max.map_or(f64::INFINITY, |at| at.value),
        })
    }

    /// The word of the control that was chosen.
    pub(crate) fn control_word(&self) -> Option<&'static str> {
        self.control.given().map(|control| word_of(Control::WORDS, &control.value))
    }

    /// Returns the control that was chosen, if one was. A schedule may switch to the autodriller
    /// later.
    pub(crate) fn control(
        &self,
        schedule: &Schedule,
        reader: &mut Reader,
    ) -> Option<Option<HoistControl>> {
        let chosen = self.control.optional()?;
        let control = chosen.map(|at| word_of(Control::WORDS, &at.value));
        let later = schedule.holds_a_weight().then_some(AUTODRILLER);
        for key in self.written() {
            // The line that carries the string is a part of every control.
            let [word] = key.used_with[..] else { continue };
            if control == Some(word) || later == Some(word) {
                continue;
            }
            let why = format!("used with control = \"{word}\"");
            let diagnostic = Diagnostic::idle(key.name, key.place, why);
            reader.report(match chosen {
                Some(chosen) => diagnostic.at(chosen.place, "the control"),
                None => diagnostic.help(format!("add control = \"{word}\" to [hoist]")),
            });
        }
        let Some(chosen) = chosen else {
            return Some(None);
        };
        let control = match chosen.value {
            Control::Autodriller => HoistControl::Autodriller,
            Control::BlockVelocity => {
                let velocity =
                    needed(&self.block_velocity, "block_velocity", chosen.place, reader)?;
                HoistControl::BlockVelocity(velocity)
            }
            Control::HookLoad => {
                HoistControl::HookLoad(needed(&self.hook_load, "hook_load", chosen.place, reader)?)
            }
            Control::TunedLift => return Some(None),
        };
        Some(Some(control))
    }

    /// Whether the lift is found before the run, and refuses a case in which that is not possible:
    /// nothing to tune it for, or no constant lift.
    pub(crate) fn tunes_hook_load(
        &self,
        operations: &[Operation],
        schedule: &Schedule,
        reader: &mut Reader,
    ) -> Option<bool> {
        let Some(chosen) = self.control.optional()? else {
            return Some(false);
        };
        if chosen.value != Control::TunedLift {
            return Some(false);
        }
        let off_bottom = operations.iter().find(|one| !one.kind.on_bottom());
        let why = if let Some(operation) = off_bottom {
            format!("\"{}\" puts no weight on the bit", operation.kind.name())
        } else if operations.iter().any(|one| one.weight_on_bit_N <= 0.0) {
            "`wob` is 0".to_owned()
        } else if schedule.moves_the_hoist() {
            "the schedule moves the block".to_owned()
        } else {
            return Some(true);
        };
        Diagnostic::error("there is no weight on bit to tune a constant lift for")
            .at(chosen.place, why)
            .help(
                "\"tuned-lift\" is for \"drill\" and \"slide\" with a `wob`, the hoist left \
                       alone",
            )
            .refuse(reader)
    }
}

fn needed(
    field: &Field<f64>,
    name: &str,
    chosen: wholestring_config::source::Span,
    reader: &mut Reader,
) -> Option<f64> {
    if let Field::Absent = field {
        Diagnostic::error(format!("this hoist control needs `{name}`"))
            .at(chosen, format!("`{name}` is missing in [hoist]"))
            .report(reader);
    }
    field.get().copied()
}
