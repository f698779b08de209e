//! Findings in words, in users' units.

#[cfg(test)]
mod tests;

use std::f64::consts::TAU;

use wholestring::{
    dynamics::{TableUse, Whirl},
    findings::{Finding, Kind, Level},
    rig::Rig,
    rod::buckled_element::BuckledElement,
};
use wholestring_results::OperationSummary;
use wholestring_units::{Dimension, UnitSet};

use super::drift;

/// What a sentence must know beside the finding and the answer.
#[derive(Debug, Clone, Copy)]
pub struct Around<'a> {
    /// The rig's limits.
    pub rig: &'a Rig,
    /// Whether the answer's forces hold the friction of a helix.
    pub has_helix_friction: bool,
    /// The units that people are shown.
    pub units: UnitSet,
}

/// A sentence that begins with a capital and ends without a full stop.
pub(super) fn sentence(found: &Finding, of: &OperationSummary, around: &Around<'_>) -> String {
    let Around { rig, has_helix_friction, units } = *around;
    let words = Words { found, of, rig, has_helix_friction, units };
    match found.kind {
        Kind::HookLoadNegative => words.hook_load(),
        Kind::LockUp => words.lock_up(),
        Kind::WeightOnBitNotReached => words.weight_on_bit("is not reached"),
        Kind::WeightOnBitExceeded => words.weight_on_bit("is exceeded"),
        Kind::WeightOnBitUnsteady => format!(
            "The weight on bit is not held: it varies by ± {} (standard deviation) about {}",
            words.force(words.value()),
            words.force(of.scalars.weight_on_bit_N),
        ),
        Kind::BitBounce => format!(
            "The bit bounces: it is off the rock for {} of the time",
            percent(words.value())
        ),
        Kind::SinusoidalBuckling => words.buckled("Buckled to a sinusoid"),
        Kind::HelicalBuckling => words.buckled("Buckled to a helix"),
        Kind::HoistOverloaded => words.hoist(),
        Kind::TopDriveOverloaded => words.top_drive(),
        Kind::PumpPressure => format!(
            "Pump pressure of {} {} the limit of {}",
            words.pressure(words.value()),
            if words.value() > words.limit() { "exceeds" } else { "comes near" },
            words.pressure(words.limit())
        ),
        Kind::TopDriveAtLimit => format!(
            "The top drive works at its torque limit of {}{}",
            words.torque(words.limit()),
            match found.level {
                Level::Error => " and does not hold its speed",
                _ => "",
            }
        ),
        Kind::TopDriveStalled => format!(
            "The top drive stalls: its torque limit of {} does not turn the string",
            words.torque(words.limit())
        ),
        Kind::YieldUse => words.yield_use(),
        Kind::StickSlip => words.stick_slip(),
        Kind::BackwardWhirl => words.whirl("Backward", |of| of.backward_whirl),
        Kind::ForwardWhirl => words.whirl("Forward", |of| of.forward_whirl),
        Kind::WallPenetration => format!(
            "The string goes {} into the wall, beyond the {} that the law of the wall is good for",
            words.across(words.value()),
            words.across(words.limit())
        ),
        Kind::EnergyResidual => format!(
            "The integration {} {} of the energy that went through it",
            if words.value() < 0.0 { "gained" } else { "lost" },
            percent(words.value().abs()),
        ),
        Kind::BitTableLeft => match of.bit_table {
            Some(of) => words.bit_table(&of),
            None => "The bit was outside its table".to_owned(),
        },
        Kind::NodeUnsettled => format!(
            "The string never settled{}: its tension varies there by ± {}, {} and less about it",
            words.place(),
            words.force(words.value()),
            words.force(words.limit() / 10.0),
        ),
        Kind::ElementBuckles => format!(
            "An element of the mesh buckles between its nodes{}: compression of {}, its own \
             buckling load is {}, and the string folds there as no pipe does. Shorter elements are \
             needed{}",
            words.place(),
            words.force(words.value()),
            words.force(words.limit()),
            words.sufficient_length(),
        ),
        Kind::BendingWavesLeftOut => format!(
            "The friction torque varies by more than ± {}, and so does the side force: elements \
             from joint to joint leave out how the shaken pipe vibrates between its contacts. \
             mesh.element_length = \"3.2 m\" has most of it",
            words.torque(words.value())
        ),
        Kind::LateralForceLeftOut => format!(
            "The soft string leaves out {} across its components: the stiff string and the \
             dynamics have it",
            words.force(words.value())
        ),
        Kind::UnstableEquilibrium if found.from_md_m.is_some() => format!(
            "The equilibrium found is not stable, and none that is was found of the string that \
             turns: let go, it rolls around its hole by its friction, most{}. The dynamics show \
             how it whirls",
            words.place()
        ),
        Kind::UnstableEquilibrium => {
            "The equilibrium found is not stable: a small disturbance would \
                                      leave it, and a buckled string would lie otherwise"
                .to_owned()
        }
        Kind::NoEquilibrium => words.no_equilibrium(),
        Kind::WindowDrifts => drift::sentence(of, units)
            .unwrap_or_else(|| "The means of the window drift: settle longer".to_owned()),
        Kind::NeverSteady => format!(
            "Not steady after {:.0} s of settling, the most that it may take by itself; look at \
             time.parquet before you \
             believe the means, or give a longer dynamics.settle",
            words.value()
        ),
        Kind::BitElsewhere => words.bit_elsewhere(),
    }
}

/// `2.4 m`: a length of elements that do not buckle where one has, rounded down to two digits.
pub fn shorter_element(element: &BuckledElement, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    let length = unit.from_si(element.sufficient_length_m());
    let scale = libm::pow(10.0_f64, 1.0 - libm::log10(length).floor());
    format!("{} {}", (length * scale).floor() / scale, unit.symbol)
}

struct Words<'a> {
    found: &'a Finding,
    of: &'a OperationSummary,
    rig: &'a Rig,
    has_helix_friction: bool,
    units: UnitSet,
}

/// `12.5 %`, below one per cent to two digits.
fn percent(part: f64) -> String {
    let percent = part * 100.0;
    if percent.abs() < 10.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") }
}

impl Words<'_> {
    fn value(&self) -> f64 {
        self.found.value.unwrap_or(f64::NAN)
    }

    fn limit(&self) -> f64 {
        self.found.limit.unwrap_or(f64::NAN)
    }

    fn force(&self, force_N: f64) -> String {
        Dimension::Force.format(self.shown(Dimension::Force, force_N), self.units)
    }

    fn torque(&self, torque_N_m: f64) -> String {
        Dimension::Torque.format(self.shown(Dimension::Torque, torque_N_m), self.units)
    }

    fn pressure(&self, pressure_Pa: f64) -> String {
        Dimension::Pressure.format(self.shown(Dimension::Pressure, pressure_Pa), self.units)
    }

    fn depth(&self, md_m: f64) -> String {
        let unit = Dimension::Length.unit_in(self.units);
        format!("{:.0} {}", unit.from_si(md_m) + 0.0, unit.symbol)
    }

    /// `, such as mesh.element_length = "2.4 m"`: elements that bear four times the compression.
    fn sufficient_length(&self) -> String {
        let in_time = self.of.numerics.as_ref().and_then(|of| of.run.buckled_element);
        let at_rest = self.of.at_rest.as_ref().and_then(|of| of.convergence.buckled_element);
        let Some(element) = in_time.or(at_rest) else { return String::new() };
        format!(", such as mesh.element_length = {:?}", shorter_element(&element, self.units))
    }

    fn across(&self, length_m: f64) -> String {
        Dimension::Diameter.format(self.shown(Dimension::Diameter, length_m), self.units)
    }

    /// A value with the four digits that a verdict deserves.
    fn shown(&self, dimension: Dimension, si: f64) -> f64 {
        let unit = dimension.unit_in(self.units);
        let value = unit.from_si(si);
        if value == 0.0 || !value.is_finite() {
            return si;
        }
        let scale = libm::pow(10.0_f64, 3.0 - libm::log10(value.abs()).floor());
        si * ((value * scale).round() / scale / value)
    }

    fn bit_elsewhere(&self) -> String {
        let off_m = self.value() - self.limit();
        let side = if off_m > 0.0 { "deeper" } else { "shallower" };
        format!(
            "Settling took so long that the bit is at {} on average over the window, {} {side} \
             than asked",
            self.depth(self.value()),
            self.depth(off_m.abs()),
        )
    }

    /// ` at 4310 m`, ` from 50 m to 3350 m` or nothing.
    fn place(&self) -> String {
        match (self.found.from_md_m, self.found.to_md_m) {
            (Some(from), Some(to)) => format!(" from {} to {}", self.depth(from), self.depth(to)),
            (Some(at), None) => format!(" at {}", self.depth(at)),
            _ => String::new(),
        }
    }

    fn no_equilibrium(&self) -> String {
        let residual = self.found.value.map_or_else(String::new, |residual_N| {
            format!(": forces are out of balance by {}", self.force(residual_N))
        });
        format!("No state of rest was found{}{residual}", self.place())
    }

    fn hook_load(&self) -> String {
        let value_N = self.value();
        let hook_load = self.force(value_N);
        if let Some(push_N) = self.rig.snubbing_force_N {
            return self.push(value_N, push_N);
        }
        if self.of.scalars.hook_load_N > value_N {
            return format!("The hook goes slack at times: hook load down to {hook_load}");
        }
        let block_N = self.rig.block_weight_N.filter(|block| *block > 0.0);
        match (block_N, self.found.level) {
            (Some(block_N), Level::Error) => format!(
                "The string does not go down by its weight, nor by that of the block: hook load \
                 {hook_load}, {} with \
                 the block",
                self.force(value_N + block_N)
            ),
            (Some(block_N), _) => format!(
                "The string does not go down by its weight, the block pushes it: hook load \
                 {hook_load}, {} with the \
                 block",
                self.force(value_N + block_N)
            ),
            (None, _) => {
                format!("The string does not go down by its weight: hook load {hook_load}")
            }
        }
    }

    /// Of a rig that pushes, and with how much at most, N.
    fn push(&self, hook_load_N: f64, most_N: f64) -> String {
        let (hook_load, most) = (self.force(hook_load_N), self.force(most_N));
        let block_N = self.rig.block_weight_N.unwrap_or(0.0);
        if self.of.scalars.hook_load_N > hook_load_N {
            format!("The rig pushes with all of its {most} at times: hook load down to {hook_load}")
        } else if self.found.level == Level::Error {
            format!(
                "The rig does not push the string down: hook load {hook_load}, the rig pushes with \
                 {most} at most"
            )
        } else {
            format!(
                "The rig pushes the string down with all of its {most} and the block: hook load \
                 {hook_load}, {} with the block",
                self.force(hook_load_N + block_N)
            )
        }
    }

    fn lock_up(&self) -> String {
        let (asked_N, arrives_N) = (self.value(), self.limit());
        let has_block = self.rig.block_weight_N.is_some_and(|block| block > 0.0);
        let block_pushes = has_block && !self.of.model.in_time();
        let pushed = match (block_pushes, self.rig.snubbing_force_N.is_some()) {
            (true, true) => {
                "with all of its weight slacked off, the block on it and the rig pushing"
            }
            (true, false) => "with all of its weight slacked off and the block on it",
            (false, true) => "with all of its weight slacked off and the rig pushing",
            (false, false) => "with all of its weight slacked off",
        };
        let mut text = if asked_N > 0.0 && arrives_N >= 0.0 {
            format!(
                "Lock-up: {pushed} the string brings {} of {} to the bit",
                self.force(arrives_N),
                self.force(asked_N)
            )
        } else if arrives_N < 0.0 {
            format!(
                "Lock-up: {pushed} the string stands; at the bit {} are missing",
                self.force(asked_N - arrives_N)
            )
        } else {
            format!("Lock-up: {pushed} the string stands and does not follow the block")
        };
        if let Some(md_m) = self.found.from_md_m {
            text += &format!("; its helix takes any push from above {}", self.depth(md_m));
        }
        text
    }

    fn weight_on_bit(&self, is: &str) -> String {
        format!(
            "The weight on bit of {} {is}: {} on average",
            self.force(self.limit()),
            self.force(self.value())
        )
    }

    fn buckled(&self, how: &str) -> String {
        let helix = self.found.kind == Kind::HelicalBuckling;
        let method = self.of.model.method();
        let more = match helix && !self.has_helix_friction {
            true => format!("; the {} does not count the drag of the helix", method.long_name),
            false => String::new(),
        };
        format!(
            "{how}{}: compression of {} where {} is critical{more}",
            self.place(),
            self.force(self.value()),
            self.force(self.limit())
        )
    }

    fn hoist(&self) -> String {
        let (value_N, capacity) = (self.value(), self.force(self.limit()));
        let load = match self.rig.block_weight_N {
            Some(block_N) => format!(
                "Hook load with block of {} ({} without)",
                self.force(value_N),
                self.force(value_N - block_N)
            ),
            None => format!("Hook load of {}, the block not counted,", self.force(value_N)),
        };
        if value_N > self.limit() {
            format!("{load} exceeds the hoist's capacity of {capacity}")
        } else {
            format!("{load} comes near the hoist's capacity of {capacity}")
        }
    }

    fn top_drive(&self) -> String {
        let peak_N_m = self.rig.top_drive_peak_torque_N_m;
        let which = if peak_N_m == Some(self.limit()) { "peak" } else { "rated" };
        if self.value() > self.limit() {
            let mut text = format!(
                "Surface torque of {} exceeds the top drive's {which} torque of {}",
                self.torque(self.value()),
                self.torque(self.limit())
            );
            if let (Level::Note, Some(peak_N_m)) = (self.found.level, peak_N_m) {
                text += &format!(" at times, within its peak torque of {}", self.torque(peak_N_m));
            }
            return text;
        }
        let mut text = format!(
            "Surface torque up to {} of the top drive's {which} torque",
            percent(self.value() / self.limit())
        );
        if let Some(of) = self.of.indicators.and_then(|of| of.top_drive) {
            text += &format!(", 95th percentile {}", percent(of.p95));
        }
        text
    }

    fn yield_use(&self) -> String {
        let what = if self.value() > 1.0 {
            "The string yields"
        } else {
            "The string comes near to yielding"
        };
        format!(
            "{what}{}: the stress reaches {} of the yield strength",
            self.place(),
            percent(self.value())
        )
    }

    fn stick_slip(&self) -> String {
        let Some(of) = self.of.indicators.and_then(|of| of.stick_slip) else {
            return "Stick-slip".to_owned();
        };
        let mut text = match self.found.value {
            Some(severity) => format!("Stick-slip of severity {severity:.2}"),
            None => "The bit does not turn".to_owned(),
        };
        if let Some(period_s) = of.period_s {
            text += &format!(", period {period_s:.1} s");
        }
        text += &format!(
            ", bit stuck for {:.0} % of the time and up to {:.0} rev/min fast",
            of.stuck_fraction * 100.0,
            of.bit_speed_max_rad_per_s * 60.0 / TAU,
        );
        text
    }

    fn whirl(
        &self,
        direction: &str,
        of: fn(&wholestring::dynamics::Indicators) -> Option<Whirl>,
    ) -> String {
        let Some(whirl) = self.of.indicators.as_ref().and_then(of) else {
            return format!("{direction} whirl{}", self.place());
        };
        format!(
            "{direction} whirl over {} of the string, fastest{}: {:.0} rev/min, {:.1} × rotary \
             speed",
            percent(whirl.length_fraction),
            self.place(),
            whirl.rate_rad_per_s * 60.0 / TAU,
            whirl.ratio,
        )
    }

    fn bit_table(&self, of: &TableUse) -> String {
        let forces =
            |[least, most]: [f64; 2]| format!("{} to {}", self.force(least), self.force(most));
        let speeds = |[slowest, fastest]: [f64; 2]| {
            let [slowest, fastest] = [slowest, fastest].map(|speed| speed * 60.0 / TAU);
            format!("{slowest:.0} to {fastest:.0} rev/min")
        };
        format!(
            "The bit was outside its table for {:.1} % of the time on the rock, which stays at \
             its edge there: \
             weight on bit {} (table {}), rotary speed {} (table {})",
            of.outside_fraction * 100.0,
            forces(of.weights_N),
            forces(of.table_weights_N),
            speeds(of.speeds_rad_per_s),
            speeds(of.table_speeds_rad_per_s),
        )
    }
}
