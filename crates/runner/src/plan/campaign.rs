//! What the campaign of a plan does to string and casing, as results have it.

use serde::{Deserialize, Serialize};
use wholestring::outcome::ModelKind;
use wholestring_plan::{
    Broomstick, BroomstickPoint, Campaign, FrictionLevel, Share, Statics,
    fatigue::{DamageRow, FatigueRow},
    wear::WearRow,
};
use wholestring_results::{PlanDamage, PlanFatigue, PlanFatigueHour, PlanWear};

/// A damage that nothing survives: what is beyond has no number in JSON.
const SURELY: f64 = 1e9;

/// A share of the campaign, by which model and of which operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Taken {
    pub(super) model: String,
    pub(super) operation: String,
    /// Measured depth of the bit, m.
    pub(super) bit_depth_m: f64,
    /// The share, or the verdict of a point that has no answer.
    pub(super) share: Result<Share, String>,
}

/// The shares of these points of a broomstick.
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
            model: point.model.name().to_owned(),
            operation: point.operation.name().to_owned(),
            bit_depth_m: point.bit_depth_m,
            share,
        })
    };
    found.iter().filter(is_part).filter_map(one).collect()
}

/// What all of it comes to.
#[derive(Debug, Default)]
pub(super) struct Came {
    pub(super) fatigue: Vec<PlanFatigue>,
    pub(super) damage: Vec<PlanDamage>,
    pub(super) wear: Vec<PlanWear>,
    pub(super) worst_wear: Vec<PlanWear>,
}

/// Adds up the shares, model after model. What the dynamics wears stands after them: with it in the place of what
/// the first of them says of the same operations.
pub(super) fn came(
    of: &Broomstick,
    models: &[Statics],
    taken: &[Taken],
    by_dynamics: &[(String, Share)],
) -> Came {
    let mut came = Came::default();
    let Some(campaign) = of.campaign() else { return came };
    for model in models.iter().map(|model| model.name()) {
        let mut shares =
            taken.iter().filter(|of| of.model == model).filter_map(|of| of.share.as_ref().ok());
        let Some(first) = shares.next() else { continue };
        let mut all = first.clone();
        shares.for_each(|share| all.merge(share));
        came.add(of, campaign, model, &all);
    }
    if let (Some((_, all)), Some(first)) = (by_dynamics.first(), models.first()) {
        let is_replaced = |name: &str| by_dynamics.iter().any(|(of, _)| of == name);
        let others =
            taken.iter().filter(|of| of.model == first.name() && !is_replaced(&of.operation));
        let mut all = all.clone();
        by_dynamics[1..].iter().for_each(|(_, share)| all.worn.merge(&share.worn));
        let others = others.filter_map(|of| of.share.as_ref().ok());
        others.for_each(|share| all.worn.merge(&share.worn));
        came.add_wear(campaign, ModelKind::Dynamic.name(), &all);
    }
    came
}

impl Came {
    fn add(&mut self, of: &Broomstick, campaign: &Campaign, model: &str, all: &Share) {
        let components = &of.setup(FrictionLevel::Expected).string.components;
        let name = |row: &DamageRow| components.get(row.component).map(|of| of.name.clone());
        self.damage.extend(all.damage.rows().map(|row| PlanDamage {
            model: model.to_owned(),
            component: name(&row).unwrap_or_default(),
            from_lower_end_m: row.from_lower_end_m,
            damage: row.damage.min(SURELY),
        }));
        for index in 0..components.len() {
            let Some(worst) = all.damage.worst(index) else { continue };
            let hour = all.rates.iter().find(|of| of.component == index);
            self.fatigue.push(PlanFatigue {
                model: model.to_owned(),
                component: name(&worst).unwrap_or_default(),
                damage: worst.damage.min(SURELY),
                from_lower_end_m: worst.from_lower_end_m,
                hour: hour.map(hourly),
            });
        }
        self.add_wear(campaign, model, all);
    }

    fn add_wear(&mut self, campaign: &Campaign, model: &str, all: &Share) {
        let wear: Vec<PlanWear> =
            campaign.casings(all).iter().map(|row| stretch(model, row)).collect();
        for of in &wear {
            let worn = |of: &PlanWear| of.worn.or(of.groove_m).unwrap_or(f64::INFINITY);
            match self
                .worst_wear
                .iter_mut()
                .find(|one| one.section == of.section && one.model == of.model)
            {
                Some(worst) if worn(of) > worn(worst) => *worst = of.clone(),
                Some(_) => {}
                None => self.worst_wear.push(of.clone()),
            }
        }
        self.wear.extend(wear);
    }
}

fn hourly(of: &FatigueRow) -> PlanFatigueHour {
    PlanFatigueHour {
        md_m: of.md_m,
        damage_per_hour: of.damage_per_hour.min(SURELY),
        bending_Pa: of.bending_Pa,
        dogleg_rad_per_m: of.dogleg_rad_per_m,
        permissible_dogleg_rad_per_m: of.permissible_dogleg_rad_per_m,
    }
}

fn stretch(model: &str, of: &WearRow) -> PlanWear {
    PlanWear {
        model: model.to_owned(),
        section: of.section + 1,
        md_m: of.md_m,
        groove_m: of.groove_m,
        wall_m: of.pipe.map(|pipe| pipe.wall_m),
        wall_left_m: of.pipe.map(|pipe| pipe.wall_left_m),
        worn: of.pipe.map(|pipe| pipe.worn_part()),
        burst_Pa: of.pipe.and_then(|pipe| pipe.burst_Pa),
        collapse_Pa: of.pipe.and_then(|pipe| pipe.collapse_Pa),
    }
}
