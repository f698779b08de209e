//! Effects of a plan's campaign on string and casing, in the form of the results.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind, string::StringSpec};
use wholestring_judge::Quantity;
use wholestring_plan::{
    Broomstick, BroomstickPoint, Campaign, CampaignPart, FrictionLevel, Share, Statics,
    fatigue::{DamageRow, FatigueRow},
    wear::WearRow,
};
use wholestring_results::{PlanDamage, PlanFatigue, PlanFatigueHour, PlanWear};

/// Damage beyond any fatigue life, because JSON has no infinite number.
const SURELY: f64 = 1e9;

/// A contribution to the campaign from one operation by one model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Taken {
    pub(super) model: ModelKind,
    pub(super) operation: OperationKind,
    /// Measured depth of the bit, m.
    pub(super) bit_depth_m: f64,
    /// The contribution, or the verdict of a point without a solution.
    pub(super) share: Result<Share, String>,
}

/// Contributions of these points of a broomstick.
pub(super) fn taken(broomstick: &Broomstick, found: &[BroomstickPoint]) -> Vec<Taken> {
    let Some(campaign) = broomstick.campaign() else { return Vec::new() };
    let is_part = |point: &&BroomstickPoint| {
        let (kind, bit_depth_m) = (point.operation, point.bit_depth_m);
        let mut all = campaign.operations();
        point.friction == FrictionLevel::Expected
            && all.any(|own| (own.kind, own.bit_depth_m) == (kind, bit_depth_m))
    };
    let one = |point: &BroomstickPoint| {
        let share = match &point.outcome {
            Ok(answer) => Ok(answer.share.clone()?),
            Err(why) => Err(why.words().to_owned()),
        };
        Some(Taken {
            model: point.model.kind(),
            operation: point.operation,
            bit_depth_m: point.bit_depth_m,
            share,
        })
    };
    found.iter().filter(is_part).filter_map(one).collect()
}

/// Sums of all contributions.
#[derive(Debug, Default)]
pub(super) struct Totals {
    pub(super) fatigue: Vec<PlanFatigue>,
    pub(super) damage: Vec<PlanDamage>,
    pub(super) wear: Vec<PlanWear>,
    pub(super) worst_wear: Vec<PlanWear>,
}

/// Sums the contributions, model after model. Wear from the dynamics follows, combined with that of
/// the first static model for the other operations.
pub(super) fn totals(
    broomstick: &Broomstick,
    models: &[Statics],
    taken: &[Taken],
    by_dynamics: &[(OperationKind, Share)],
) -> Totals {
    let mut totals = Totals::default();
    let Some(campaign) = broomstick.campaign() else { return totals };
    for model in models.iter().map(|model| model.kind()) {
        let mut shares = taken
            .iter()
            .filter(|part| part.model == model)
            .filter_map(|part| part.share.as_ref().ok());
        let Some(first) = shares.next() else { continue };
        let mut all = first.clone();
        shares.for_each(|share| all.merge(share));
        totals.add(broomstick, campaign, model, &all);
    }
    if let (Some((_, all)), Some(first)) = (by_dynamics.first(), models.first()) {
        let is_replaced =
            |operation| by_dynamics.iter().any(|(by_dynamic, _)| *by_dynamic == operation);
        let others =
            taken.iter().filter(|part| part.model == first.kind() && !is_replaced(part.operation));
        let mut all = all.clone();
        by_dynamics[1..].iter().for_each(|(_, share)| all.worn.merge(&share.worn));
        let others = others.filter_map(|part| part.share.as_ref().ok());
        others.for_each(|share| all.worn.merge(&share.worn));
        totals.add_wear(campaign, ModelKind::Dynamic, &all);
    }
    totals
}

impl Totals {
    fn add(&mut self, broomstick: &Broomstick, campaign: &Campaign, model: ModelKind, all: &Share) {
        let components = &broomstick.setup(FrictionLevel::Expected).string.components;
        let name =
            |row: &DamageRow| components.get(row.component).map(|component| component.name.clone());
        self.damage.extend(all.damage.rows().map(|row| PlanDamage {
            model,
            component: name(&row).unwrap_or_default(),
            from_lower_end_m: row.from_lower_end_m,
            damage: row.damage.min(SURELY),
        }));
        for index in 0..components.len() {
            let Some(worst) = all.damage.worst(index) else { continue };
            let hour = all.rates.iter().find(|rate| rate.component == index);
            self.fatigue.push(PlanFatigue {
                model,
                component: name(&worst).unwrap_or_default(),
                damage: worst.damage.min(SURELY),
                from_lower_end_m: worst.from_lower_end_m,
                hour: hour.map(hourly),
            });
        }
        self.add_wear(campaign, model, all);
    }

    fn add_wear(&mut self, campaign: &Campaign, model: ModelKind, all: &Share) {
        let wear: Vec<PlanWear> =
            campaign.casings(all).iter().map(|row| stretch(model, row)).collect();
        for row in &wear {
            let worn = |wear: &PlanWear| wear.worn.or(wear.groove_m).unwrap_or(f64::INFINITY);
            match self
                .worst_wear
                .iter_mut()
                .find(|one| one.section == row.section && one.model == row.model)
            {
                Some(worst) if worn(row) > worn(worst) => *worst = row.clone(),
                Some(_) => {}
                None => self.worst_wear.push(row.clone()),
            }
        }
        self.wear.extend(wear);
    }
}

fn hourly(row: &FatigueRow) -> PlanFatigueHour {
    PlanFatigueHour {
        md_m: row.md_m,
        damage_per_hour: row.damage_per_hour.min(SURELY),
        bending_Pa: row.bending_Pa,
        dogleg_rad_per_m: row.dogleg_rad_per_m,
        permissible_dogleg_rad_per_m: row.permissible_dogleg_rad_per_m,
    }
}

fn stretch(model: ModelKind, row: &WearRow) -> PlanWear {
    PlanWear {
        model,
        section: row.section + 1,
        md_m: row.md_m,
        groove_m: row.groove_m,
        wall_m: row.pipe.map(|pipe| pipe.wall_m),
        wall_left_m: row.pipe.map(|pipe| pipe.wall_left_m),
        worn: row.pipe.map(|pipe| pipe.worn_part()),
        burst_Pa: row.pipe.and_then(|pipe| pipe.burst_Pa),
        collapse_Pa: row.pipe.and_then(|pipe| pipe.collapse_Pa),
    }
}

// Parts of a campaign that are included in fatigue and casing wear, and those that are not, in
// words.

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
