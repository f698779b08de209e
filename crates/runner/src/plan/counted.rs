//! Parts of a campaign that are included in fatigue and casing wear, and those that are not, in
//! words.

use wholestring::string::StringSpec;
use wholestring_judge::Quantity;
use wholestring_plan::{Broomstick, CampaignPart, FrictionLevel};

use super::campaign::Taken;

/// The parts of a campaign in words, their depths marked as quantities.
#[derive(Debug, Default)]
pub(super) struct Counted {
    /// Included parts, with their hours.
    pub(super) counted: Vec<String>,
    /// Parts that are not included, with the reasons.
    pub(super) not_counted: Vec<String>,
}

impl Counted {
    /// Parts of the campaign of a broomstick, given the points that were solved.
    pub(super) fn of(broomstick: &Broomstick, taken: &[Taken]) -> Self {
        let Some(campaign) = broomstick.campaign() else { return Self::default() };
        let mut found = Self::default();
        for part in campaign.parts() {
            match (part.operation, part.duration_s) {
                (Some(_), Some(duration_s)) => {
                    let hours = duration_s / 3600.0;
                    found.counted.push(format!("{} in {hours:.1} h", named(&part)));
                }
                (Some(_), None) => {
                    let text = format!("{}: its speed is zero", named(&part));
                    found.not_counted.push(text);
                }
                (None, _) => {
                    let text = format!("{}: the case has no such operation", named(&part));
                    found.not_counted.push(text);
                }
            }
        }
        found.not_counted.extend(unsolved(taken));
        let string = &broomstick.setup(FrictionLevel::Expected).string;
        let settings = campaign.fatigue_settings();
        if settings.tensile_strength_Pa.is_none() {
            found.not_counted.extend(without_strength(string));
        }
        found
    }
}

/// A part of the campaign with its interval of the hole.
fn named(part: &CampaignPart) -> String {
    let name = match part.operation {
        Some(kind) => kind.words().to_owned(),
        None if part.drills => "drilling".to_owned(),
        None => "an operation".to_owned(),
    };
    match part.from_m < part.to_m {
        true => format!(
            "{name} from {} to {}",
            Quantity::depth(part.from_m),
            Quantity::depth(part.to_m)
        ),
        false => format!("{name} at {}", Quantity::depth(part.to_m)),
    }
}

/// Points of the campaign without a solution, for each operation.
fn unsolved(taken: &[Taken]) -> Vec<String> {
    let mut found: Vec<(&Taken, &String, [f64; 2], usize)> = Vec::new();
    for point in taken {
        let Err(why) = &point.share else { continue };
        let at_m = point.bit_depth_m;
        let is_same = |other: &&mut (&Taken, &String, [f64; 2], usize)| {
            (other.0.model, other.0.operation, other.1) == (point.model, point.operation, why)
        };
        match found.iter_mut().find(is_same) {
            Some((_, _, ends_m, count)) => {
                *ends_m = [ends_m[0].min(at_m), ends_m[1].max(at_m)];
                *count += 1;
            }
            None => found.push((point, why, [at_m; 2], 1)),
        }
    }
    let text = |(point, why, [from_m, to_m], count): &(&Taken, &String, [f64; 2], usize)| {
        let [from, to] = [from_m, to_m].map(|at_m| Quantity::depth(*at_m));
        let bit = match count {
            1 => format!("with the bit at {from}"),
            count => format!("with the bit at {count} depths from {from} to {to}"),
        };
        format!("{} {bit}, {} string: {why}", point.operation, point.model)
    };
    found.iter().map(text).collect()
}

/// Components whose fatigue is not computed because their strength is not given.
fn without_strength(string: &StringSpec) -> Option<String> {
    let bit = usize::from(string.components.len() > 1);
    let lacking = string.components.iter().skip(bit).filter(|one| one.yield_strength_Pa.is_none());
    let mut names: Vec<&str> = lacking.map(|component| component.name.as_str()).collect();
    names.dedup();
    (!names.is_empty()).then(|| format!("fatigue of {}: no yield strength", names.join(", ")))
}
