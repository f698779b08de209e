//! Sentences on limits.

use super::{Words, text};
use crate::{Check, CheckKind, Descent, Severity, Verdict};

/// `Tension of 5 in drill pipe at 0 m: load 711.2 kN, capacity 466.1 kN, factor 0.66, required
/// 1.11: exceeded`.
fn limit(check: &Check) -> String {
    let load = text::of_kind(check.kind.quantity(), check.value.unwrap_or(f64::NAN));
    limit_of_load(check, &format!("{} {load}", load_word(check.kind)))
}

fn limit_of_load(check: &Check, load: &str) -> String {
    let component = check.component.as_ref();
    let component = match (component, check.kind) {
        (Some(name), _) => format!(" of {name}"),
        // Each component has one as well.
        (None, CheckKind::Overpull) => " of the hoist".to_owned(),
        (None, _) => String::new(),
    };
    let capacity = text::of_kind(check.kind.quantity(), check.limit.unwrap_or(f64::NAN));
    format!(
        "{}{component}{}: {load}, {} {capacity}, {}",
        check.kind.label(),
        text::place(check),
        capacity_word(check.kind),
        verdict(check)
    )
}

const fn load_word(kind: CheckKind) -> &'static str {
    match kind {
        CheckKind::Overpull => "requested",
        CheckKind::VonMises => "stress",
        CheckKind::SinusoidalBuckling | CheckKind::HelicalBuckling => "compression",
        CheckKind::LockUp => "friction and requested weight on bit",
        _ => "load",
    }
}

const fn capacity_word(kind: CheckKind) -> &'static str {
    match kind {
        CheckKind::Overpull => "left",
        CheckKind::SideForce => "limit",
        CheckKind::VonMises => "yield strength",
        CheckKind::SinusoidalBuckling | CheckKind::HelicalBuckling => "critical",
        CheckKind::LockUp => "drive",
        _ => "capacity",
    }
}

/// `factor 0.66, required 1.11: exceeded`.
fn verdict(check: &Check) -> String {
    let [factor, required] =
        [check.factor, check.required].map(|factor| text::factor(factor.unwrap_or(f64::NAN)));
    let at_times = match (check.verdict, check.severity) {
        (Verdict::Exceeded, Severity::Note) if check.kind == CheckKind::TopDrive => {
            " at times, within the peak torque"
        }
        (Verdict::Exceeded, Severity::Warning) if check.kind.stops() => " at times",
        _ => "",
    };
    format!("factor {factor}, required {required}: {}{at_times}", check.verdict.words())
}

impl Words<'_> {
    /// A limit; for the hoist with the parts of its load.
    pub(super) fn limit(&self, check: &Check) -> String {
        if check.kind != CheckKind::Hoist {
            return limit(check);
        }
        let value_N = check.value.unwrap_or(f64::NAN);
        let load = text::force(value_N);
        let load = match self.rig.block_weight_N {
            Some(block_N) => format!(
                "load {load} (hook load {} and block {})",
                text::force(value_N - block_N),
                text::force(block_N)
            ),
            None => format!("load {load}, the block not counted"),
        };
        limit_of_load(check, &load)
    }

    pub(super) fn beyond_collapse(&self, check: &Check) -> String {
        let component = check.component.as_deref().unwrap_or("the string");
        format!(
            "Collapse of {component}{}: not computed, for the tension there leaves less yield \
             strength than the formulas of API TR 5C3 are made for; pressure outside over inside {}",
            text::place(check),
            text::of_kind(check.kind.quantity(), check.value.unwrap_or(f64::NAN)),
        )
    }

    pub(super) fn buckling(&self, check: &Check) -> String {
        let helix = check.kind == CheckKind::HelicalBuckling;
        let (compression, critical) = (
            text::force(check.value.unwrap_or(f64::NAN)),
            text::force(check.limit.unwrap_or(f64::NAN)),
        );
        if check.verdict != Verdict::Exceeded {
            return limit(check);
        }
        let shape = if helix { "a helix" } else { "a sinusoid" };
        let drag = match helix && !self.has_helix_friction {
            true => {
                let name = self.model.method().long_name;
                format!("; the {name} does not count the drag of the helix")
            }
            false => String::new(),
        };
        format!(
            "Buckled to {shape}{}: compression {compression}, critical {critical}{drag}",
            text::place(check)
        )
    }

    /// The sentence on whether the requested weight reaches the bit.
    pub(crate) fn lock_up(&self, descent: &Descent, check: &Check) -> String {
        if !descent.locks_up {
            return limit(check);
        }
        let block = descent.block_N.is_some_and(|block_N| block_N > 0.0) && !descent.in_time;
        let pushed = match (block, descent.injector_N.is_some()) {
            (true, true) => {
                "with all of its weight slacked off, the block on it and the rig pushing"
            }
            (true, false) => "with all of its weight slacked off and the block on it",
            (false, true) => "with all of its weight slacked off and the rig pushing",
            (false, false) => "with all of its weight slacked off",
        };
        let (requested_N, arrives_N) = (descent.requested_N, descent.arrives_N);
        let mut sentence = if requested_N > 0.0 && arrives_N >= 0.0 {
            format!(
                "Lock-up: {pushed}, only {} of {} of the requested weight reaches the bit",
                text::force(arrives_N),
                text::force(requested_N)
            )
        } else if requested_N > 0.0 {
            format!(
                "Lock-up: {pushed}, the string stops; {} short of the requested weight on bit",
                text::force(requested_N - arrives_N)
            )
        } else if arrives_N < 0.0 {
            format!(
                "Lock-up: {pushed}, the string stops; {} more force is needed to move it",
                text::force(-arrives_N)
            )
        } else {
            format!("Lock-up: {pushed}, the string stops and does not follow the block")
        };
        if let Some(md_m) = descent.absorbed_above_md_m {
            sentence += &format!(
                "; any further push from above {} is absorbed by the helix",
                text::depth(md_m)
            );
        }
        sentence
    }
}
