//! Hook load and surface torque against the depth of the bit, for several frictions: the curves
//! that a driller compares with the weight indicator, known as a broomstick for their shape.
//!
//! Each point is one operation of one string, just long enough to reach the bit, at one friction: a
//! [soft](wholestring::statics::soft) or a [stiff](wholestring::statics::stiff) string. A
//! broomstick also includes the weight on bit under which the string begins to buckle.

mod along;
mod answer;
mod buckling_weight;
mod expected;
mod friction;
mod point;

pub use along::StringStation;
pub use buckling_weight::BucklingWeight;
pub use expected::ExpectedLoads;
pub use friction::{Frictions, KindFriction, LevelFriction};
pub use point::{BroomstickPoint, PointAnswer, Statics, bit_depths_m};

use wholestring::{
    operation::Operation,
    statics::{soft::SoftSettings, stiff::StiffSettings},
    well::HoleError,
};

use wholestring_judge::Judge;

use crate::{Campaign, CampaignSettings, FrictionLevel, Setup, wear::CasingError};

/// A string at several depths of the bit, with several frictions.
#[derive(Debug, Clone)]
pub struct Broomstick {
    /// The well, the string, the mud and the rig at each of [`FrictionLevel::ALL`].
    setups: [Setup; FrictionLevel::ALL.len()],
    /// The operations; their depths are those of the case.
    operations: Vec<Operation>,
    /// Depths of the bit, m, increasing.
    depths_m: Vec<f64>,
    models: Vec<Statics>,
    soft: SoftSettings,
    stiff: StiffSettings,
    judge: Judge,
    /// The campaign that the operations with the expected friction are part of.
    campaign: Option<Campaign>,
}

/// The unit of solving: one operation at one depth by one model, with every friction; or the weight
/// to buckle at one depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BroomstickTask {
    /// The model.
    pub model: Statics,
    /// The operation, with the depth of its bit.
    pub operation: Operation,
}

impl Broomstick {
    /// Returns a broomstick of these operations at these depths, m, by these models.
    ///
    /// # Errors
    /// A friction factor that is out of its range.
    pub fn new(
        setup: &Setup,
        frictions: &Frictions,
        operations: Vec<Operation>,
        depths_m: Vec<f64>,
        models: Vec<Statics>,
    ) -> Result<Self, HoleError> {
        let at = |level: FrictionLevel| frictions.of(level).applied_to(setup);
        let [low, expected, high] = FrictionLevel::ALL.map(at);
        Ok(Self {
            setups: [low?, expected?, high?],
            operations,
            depths_m,
            models,
            soft: SoftSettings::default(),
            stiff: StiffSettings::default(),
            judge: Judge::default(),
            campaign: None,
        })
    }

    /// Returns the same with the settings of its models.
    #[must_use]
    pub fn with_settings(self, soft: SoftSettings, stiff: StiffSettings) -> Self {
        Self { soft, stiff, ..self }
    }

    /// Returns the same with the judge of its results.
    #[must_use]
    pub fn with_judge(self, judge: Judge) -> Self {
        Self { judge, ..self }
    }

    /// Returns the same with a campaign: its operations with the expected friction have their
    /// [`Share`](crate::Share) of it.
    ///
    /// # Errors
    /// Casing that cannot be worn.
    pub fn with_campaign(self, settings: &CampaignSettings) -> Result<Self, CasingError> {
        let setup = self.setup(FrictionLevel::Expected);
        let campaign = Campaign::new(settings, setup, &self.operations, &self.depths_m)?;
        Ok(Self { campaign: Some(campaign), ..self })
    }

    /// Returns the campaign, if it has one.
    pub fn campaign(&self) -> Option<&Campaign> {
        self.campaign.as_ref()
    }

    /// Returns the judge of its results.
    pub fn judge(&self) -> &Judge {
        &self.judge
    }

    /// Returns the string at a level of friction.
    pub fn setup(&self, level: FrictionLevel) -> &Setup {
        &self.setups[level as usize]
    }

    /// Returns the depths of the bit, m, increasing.
    pub fn depths_m(&self) -> &[f64] {
        &self.depths_m
    }

    /// Returns the tasks to solve: model after model, operation after operation, down the hole.
    pub fn tasks(&self) -> Vec<BroomstickTask> {
        let operations = |model: Statics| {
            let depths = |operation: &Operation| {
                let template = *operation;
                self.depths_m.iter().map(move |bit_depth_m| BroomstickTask {
                    model,
                    operation: Operation { bit_depth_m: *bit_depth_m, ..template },
                })
            };
            self.operations.iter().flat_map(depths).collect::<Vec<_>>()
        };
        self.models.iter().flat_map(|model| operations(*model)).collect()
    }

    /// Returns the operations of the campaign that are not points of the broomstick, by each of its
    /// models: at other depths, or not among its operations. Only [the expected
    /// friction](Self::solve_at) is needed for them.
    pub fn campaign_tasks(&self) -> Vec<BroomstickTask> {
        let is_point = |operation: &Operation| {
            let mut own = self.operations.iter();
            self.depths_m.contains(&operation.bit_depth_m)
                && own.any(|own| own.kind == operation.kind)
        };
        let campaign = self.campaign.iter().flat_map(Campaign::operations);
        let others: Vec<Operation> = campaign.filter(|one| !is_point(one)).collect();
        let task =
            |model: Statics, operation: &Operation| BroomstickTask { model, operation: *operation };
        let by = |model: &Statics| -> Vec<BroomstickTask> {
            others.iter().map(|operation| task(*model, operation)).collect()
        };
        self.models.iter().flat_map(by).collect()
    }
}
