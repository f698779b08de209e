//! Sentences on reported states: descent, rotation and settling of the string, and the reliability
//! of the numbers.

use std::f64::consts::TAU;

use wholestring::dynamics::{Indicators, TableUse, Whirl};

use super::{
    Words,
    text::{self, percent},
};
use crate::{Check, CheckKind, Descent, Severity, drift};

impl Words<'_> {
    pub(super) fn state(&self, check: &Check) -> String {
        let value = check.value.unwrap_or(f64::NAN);
        let limit = check.limit.unwrap_or(f64::NAN);
        let place = text::place(check);
        match check.kind {
            CheckKind::GoesDown => self.goes_down(check, None),
            CheckKind::WeightNotAvailable => format!(
                "The string is too light for the requested weight on bit: {} requested, {} \
                 available without friction",
                text::force(value),
                text::force(limit)
            ),
            CheckKind::WeightOnBitNotReached => format!(
                "The weight on bit of {} is not reached: {} on average{}",
                text::force(limit),
                text::force(value),
                self.held_hook_load()
            ),
            CheckKind::WeightOnBitExceeded => format!(
                "The weight on bit of {} is exceeded: {} on average{}",
                text::force(limit),
                text::force(value),
                self.held_hook_load()
            ),
            CheckKind::WeightOnBitUnsteady => format!(
                "The weight on bit is not steady: it varies by ± {} (standard deviation) about {}",
                text::force(value),
                text::force(self.weight_on_bit_N),
            ),
            CheckKind::BitBounce => {
                format!("The bit bounces: it is off the rock for {} of the time", percent(value))
            }
            CheckKind::TopDriveAtLimit => format!(
                "The top drive works at its torque limit of {}{}",
                text::torque(limit),
                match check.severity {
                    Severity::Error => " and does not hold its speed",
                    _ => "",
                }
            ),
            CheckKind::TopDriveStalled => format!(
                "The top drive stalls: its torque limit of {} does not turn the string",
                text::torque(limit)
            ),
            CheckKind::StickSlip => self.stick_slip(check),
            CheckKind::BackwardWhirl => self.whirl(check, "Backward", |found| found.backward_whirl),
            CheckKind::ForwardWhirl => self.whirl(check, "Forward", |found| found.forward_whirl),
            CheckKind::WallPenetration => format!(
                "The string penetrates the wall by {}{place}; the wall law is valid up to {}",
                text::across(value),
                text::across(limit)
            ),
            CheckKind::EnergyResidual => format!(
                "The integration {} {} of the energy that went through it",
                if value < 0.0 { "gained" } else { "lost" },
                percent(value.abs()),
            ),
            CheckKind::BitTableLeft => match self.bit_table {
                Some(table) => self.bit_table(&table),
                None => "The bit was outside its table".to_owned(),
            },
            CheckKind::NodeUnsettled => format!(
                "The string never settled{place}: its tension varies there by ± {}, that of the \
                 neighbouring nodes by {} or less",
                text::force(value),
                text::force(limit / 10.0),
            ),
            CheckKind::ElementBuckles => format!(
                "An element of the mesh buckles between its nodes{place}: compression {}, its own \
                 buckling load {}, and the string folds there as no pipe does. Shorter elements are \
                 needed{}",
                text::force(value),
                text::force(limit),
                self.sufficient_length(),
            ),
            CheckKind::BendingWavesLeftOut => format!(
                "The friction torque varies by more than ± {}, and so does the side force: elements \
                 from joint to joint leave out how the shaken pipe vibrates between its contacts. \
                 mesh.element_length = \"{}\" has most of it",
                text::torque(value),
                text::element_length(3.2),
            ),
            CheckKind::LateralForceLeftOut => format!(
                "The soft string leaves out {} across its components: the stiff string and the \
                 dynamics have it",
                text::force(value)
            ),
            CheckKind::HelixNotResolved => {
                let finer = match check.limit {
                    Some(finer_N) => format!("is {}", text::force(finer_N)),
                    None => "is not found".to_owned(),
                };
                format!(
                    "The helix that is pushed down is too near lock-up for a number: the hook load \
                     is {}, and {finer} with elements half as long. Judge by the lock-up factor",
                    text::force(value)
                )
            }
            CheckKind::UnstableEquilibrium if check.severity == Severity::Note => format!(
                "The string bows between its contacts, as every string does that is compressed in \
                 a vertical hole; where it rotates, it rolls up the wall{place}. The dynamics compute \
                 that whirl"
            ),
            CheckKind::UnstableEquilibrium if check.md_m.is_some() => format!(
                "The equilibrium found is not stable, and no stable one was found of the turning \
                 string: released, it rolls up the wall, most{place}. The dynamics compute its whirl"
            ),
            CheckKind::UnstableEquilibrium => {
                "The equilibrium found is not stable: after a small disturbance the string would \
                 take another shape"
                    .to_owned()
            }
            CheckKind::WindowDrifts => drift::sentence(self.statistics, self.bit_travel_m)
                .unwrap_or_else(|| "The means of the window drift: settle longer".to_owned()),
            CheckKind::NeverSteady => format!(
                "Not steady after {value:.0} s of settling, the longest by default; inspect \
                 time.parquet before the means are used, or give a longer dynamics.settle",
            ),
            CheckKind::HookLoadSwings => format!(
                "The hook load swings by ± {} (standard deviation) and does not decay, though \
                 nothing excites the string: friction feeds an axial vibration through the bending \
                 of the pipe between its contacts. The means remain valid, the extremes do not. \
                 Elements from joint to joint (mesh.element_length = \"auto\") leave that bending \
                 out; a dynamics.damping.mass of 1 1/s, as of a viscous mud, damps it",
                text::force(value)
            ),
            CheckKind::BitElsewhere => self.bit_elsewhere(value, limit),
            kind => format!("{}{place}", kind.label()),
        }
    }

    /// `, such as mesh.element_length = "2.4 m"`: elements with four times the buckling load.
    fn sufficient_length(&self) -> String {
        let Some(element) = self.buckled_element else { return String::new() };
        let length = text::element_length(element.sufficient_length_m());
        format!(", such as mesh.element_length = \"{length}\"")
    }

    /// `, which follows from the hook load of 80 kN that the hoist holds`.
    fn held_hook_load(&self) -> String {
        self.held_hook_load_N.map_or_else(String::new, |hook_load_N| {
            let hook_load = text::force(hook_load_N);
            format!(", which follows from the hook load of {hook_load} that the hoist holds")
        })
    }

    /// The sentence on how the string goes down; `descent` is that of one that slides down.
    pub(crate) fn goes_down(&self, check: &Check, descent: Option<&Descent>) -> String {
        let value_N = check.value.unwrap_or(f64::NAN);
        let hook_load = text::force(value_N);
        // A hook load that would do, were it not for the drag of a helix that it leaves out.
        let is_held = value_N > 0.0 && descent.is_some_and(|descent| !descent.is_unaided);
        if let Some(push_N) = self.rig.snubbing_force_N {
            return self.push(check, value_N, push_N, is_held);
        }
        if self.hook_load_N > value_N {
            return format!("The hook goes slack at times: hook load down to {hook_load}");
        }
        let block_N = self.rig.block_weight_N.filter(|block_N| *block_N > 0.0);
        let with_block = text::force(value_N + block_N.unwrap_or(0.0));
        match (check.severity, block_N) {
            (Severity::Ok, _) => {
                format!("The string goes down by its weight: hook load {hook_load}")
            }
            (Severity::Error, _) if value_N > 0.0 => {
                format!("The string does not go down: it locks up, hook load {hook_load}")
            }
            (Severity::Error, Some(block_N)) if value_N + block_N > 0.0 => format!(
                "The string does not go down, for it buckles and drags: hook load {hook_load}, \
                 {with_block} with the block"
            ),
            (Severity::Error, Some(_)) => format!(
                "The string does not go down by its weight, nor with the block: hook load \
                 {hook_load}, {with_block} with the block"
            ),
            (_, Some(_)) if is_held => format!(
                "The string does not go down by its weight, for its helix drags; the block pushes \
                 it: hook load {hook_load}, {with_block} with the block"
            ),
            (_, Some(_)) => format!(
                "The string does not go down by its weight, the block pushes it: hook load \
                 {hook_load}, {with_block} with the block"
            ),
            (_, None) => {
                format!("The string does not go down by its weight: hook load {hook_load}")
            }
        }
    }

    /// The sentence for a rig that pushes, with its largest force, N. `is_held`: the hook load is
    /// positive, and the drag of the helix holds the string.
    fn push(&self, check: &Check, hook_load_N: f64, largest_N: f64, is_held: bool) -> String {
        let (hook_load, largest) = (text::force(hook_load_N), text::force(largest_N));
        let block_N = self.rig.block_weight_N.unwrap_or(0.0);
        if self.hook_load_N > hook_load_N {
            return format!(
                "The rig pushes with all of its {largest} at times: hook load down to {hook_load}"
            );
        }
        match check.severity {
            Severity::Ok if hook_load_N > 0.0 && !is_held => {
                format!("The string goes down by its weight: hook load {hook_load}")
            }
            Severity::Ok if is_held => format!(
                "The rig pushes the string down, for its helix drags: hook load {hook_load}, \
                 largest push {largest}"
            ),
            Severity::Ok => format!(
                "The rig pushes the string down: hook load {hook_load}, largest push {largest}"
            ),
            // By the hook load the push would do.
            Severity::Error if hook_load_N + largest_N > 0.0 => format!(
                "The rig does not push the string down, for its helix absorbs the push: hook load \
                 {hook_load}, largest push {largest}"
            ),
            Severity::Error => format!(
                "The rig does not push the string down: hook load {hook_load}, largest push \
                 {largest}"
            ),
            _ => format!(
                "The rig pushes the string down with all of its {largest} and the block: hook load \
                 {hook_load}, {} with the block",
                text::force(hook_load_N + block_N)
            ),
        }
    }

    fn stick_slip(&self, check: &Check) -> String {
        let Some(found) = self.indicators.and_then(|indicators| indicators.stick_slip) else {
            return "Stick-slip".to_owned();
        };
        let mut sentence = match check.value {
            Some(severity) => format!("Stick-slip of severity {severity:.2}"),
            None => "The bit does not turn".to_owned(),
        };
        if let Some(period_s) = found.period_s {
            sentence += &format!(", period {period_s:.1} s");
        }
        sentence += &format!(
            ", bit stuck for {:.0} % of the time and up to {:.0} rev/min fast",
            found.stuck_fraction * 100.0,
            found.bit_speed_max_rad_per_s * 60.0 / TAU,
        );
        sentence
    }

    fn whirl(
        &self,
        check: &Check,
        direction: &str,
        chosen: fn(&Indicators) -> Option<Whirl>,
    ) -> String {
        let place = text::place(check);
        let Some(whirl) = self.indicators.and_then(chosen) else {
            return format!("{direction} whirl{place}");
        };
        format!(
            "{direction} whirl over {} of the string, fastest{place}: {:.0} rev/min, {:.1} × rotary \
             speed",
            percent(whirl.length_fraction),
            whirl.rate_rad_per_s * 60.0 / TAU,
            whirl.ratio,
        )
    }

    fn bit_table(&self, table: &TableUse) -> String {
        let forces =
            |[least, most]: [f64; 2]| format!("{} to {}", text::force(least), text::force(most));
        let speeds = |[slowest, fastest]: [f64; 2]| {
            let [slowest, fastest] = [slowest, fastest].map(|speed| speed * 60.0 / TAU);
            format!("{slowest:.0} to {fastest:.0} rev/min")
        };
        format!(
            "The bit was outside its table for {:.1} % of the time on the rock, where the value at \
             the edge is used: weight on bit {} (table {}), rotary speed {} (table {})",
            table.outside_fraction * 100.0,
            forces(table.weights_N),
            forces(table.table_weights_N),
            speeds(table.speeds_rad_per_s),
            speeds(table.table_speeds_rad_per_s),
        )
    }

    fn bit_elsewhere(&self, mean_m: f64, requested_m: f64) -> String {
        let off_m = mean_m - requested_m;
        let side = if off_m > 0.0 { "deeper" } else { "shallower" };
        format!(
            "Settling took so long that the bit is at {} on average over the window, {} {side} \
             than requested",
            text::depth(mean_m),
            text::depth(off_m.abs()),
        )
    }
}
