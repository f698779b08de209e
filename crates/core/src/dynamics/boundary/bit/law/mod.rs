//! The laws of the bit.

mod custom;
mod detournay;
mod rate;
mod regenerative;
pub(super) mod rules;
mod table;

use serde::{Deserialize, Serialize};

use self::{
    custom::CustomCut,
    rate::Rate,
    regenerative::RegenerativeCut,
    rules::{CutStart, CutState, LawRules},
    table::Measured,
};
use super::{
    cutters::SteadyCut,
    front::FrontCut,
    motor::Drive,
    rock::RockCut,
    step::{Approach, RockReaction},
    table::TableUse,
};
use crate::{
    damage::Damaged,
    dynamics::{assemble::SetupError, boundary::extension::AnotherExtension},
};

pub use self::{
    custom::{BitRockLaw, CustomLaw},
    detournay::DetournayDefournyLaw,
    rate::RateLaw,
    regenerative::RegenerativeLaw,
    table::TableLaw,
};
pub use super::rock::RockLaw;

/// Makes of the list of laws their enum, that of the rock under the bit, and the choice among both.
macro_rules! laws {
    ($( $(#[$about:meta])+ $name:ident($law:ty) => $cut:ty, )+) => {
        /// Law of the bit on rock.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        pub enum BitLaw {
            $( $(#[$about])+ $name($law), )+
        }

        impl BitLaw {
            /// Stiffness of the rock under the bit, N/m.
            pub fn stiffness_N_per_m(&self) -> f64 {
                match self {
                    $( Self::$name(law) => law.stiffness_N_per_m(), )+
                }
            }

            /// Steady drilling under a weight on bit, at a speed. The rate law cannot compute it,
            /// and for solid rock it is an [estimate](RockLaw::estimate).
            pub fn steady(
                &self,
                weight_on_bit_N: f64,
                rotary_speed_rad_per_s: f64,
            ) -> Option<SteadyCut> {
                match self {
                    $( Self::$name(law) => {
                        law.steady_cut(weight_on_bit_N, rotary_speed_rad_per_s)
                    } )+
                }
            }

            /// Whether the bit's angle counts.
            pub(super) fn counts_angle(&self) -> bool {
                match self {
                    $( Self::$name(law) => law.counts_angle(), )+
                }
            }

            /// Refuses numbers that no run can use.
            pub(in crate::dynamics) fn check(&self) -> Result<(), SetupError> {
                match self {
                    $( Self::$name(law) => law.check(), )+
                }
            }

            /// The rock under a bit that drills steadily; none where it comes under the bit later.
            pub(super) fn begin(&self, start: &CutStart<'_>) -> Option<Cut> {
                match self {
                    $( Self::$name(law) => {
                        law.begin(start).map(|cut| Cut::$name(Box::new(cut)))
                    } )+
                }
            }
        }

        /// The rock under the bit by one of the laws.
        #[derive(Debug, Clone, Serialize, Deserialize)]
        pub(super) enum Cut {
            $( $name(Box<$cut>), )+
        }

        impl Cut {
            /// Whether stored rock is one of this law.
            pub(super) fn check(&self, law: &BitLaw) -> Result<(), Damaged> {
                match (self, law) {
                    $( (Self::$name(cut), BitLaw::$name(law)) => cut.check(law), )+
                    _ => Err(Damaged("the law of the bit")),
                }
            }

            /// Attaches the caller's parts of the law to rock that has been read back.
            pub(super) fn attach(&mut self, law: &BitLaw) -> Result<(), AnotherExtension> {
                match (self, law) {
                    $( (Self::$name(cut), BitLaw::$name(law)) => cut.attach(law), )+
                    _ => Ok(()),
                }
            }

            /// Reaction of the rock on the bit's node; none for solid rock.
            pub(super) fn meet(&mut self, at: &Approach, drive: &mut Drive) -> Option<RockReaction> {
                match self {
                    $( Self::$name(cut) => cut.meet(at, drive), )+
                }
            }

            /// Count of the bit's excursions outside its table, if it has one.
            pub(super) fn table_use(&self) -> Option<TableUse> {
                match self {
                    $( Self::$name(cut) => cut.table_use(), )+
                }
            }

            /// Counts [`Self::table_use`] anew.
            pub(super) fn restart(&mut self) {
                match self {
                    $( Self::$name(cut) => cut.restart(), )+
                }
            }
        }
    };
}

laws! {
    /// The operation's rate of penetration in proportion to weight and speed; torque in proportion
    /// to weight.
    Rate(RateLaw) => FrontCut<Rate>,
    /// Weight and torque from the depth of cut, which the bit's own passage before has left.
    Regenerative(RegenerativeLaw) => RegenerativeCut,
    /// Weight and torque from the depth of cut of a revolution, in three regimes.
    DetournayDefourny(DetournayDefournyLaw) => FrontCut<DetournayDefournyLaw>,
    /// Rate of penetration and torque as they were measured.
    Table(TableLaw) => FrontCut<Measured>,
    /// The face of the bit breaks solid rock.
    Rock(Box<RockLaw>) => RockCut,
    /// A law of the caller's own. Its name alone is serialised.
    #[serde(skip_deserializing)]
    Custom(CustomLaw) => FrontCut<CustomCut>,
}
