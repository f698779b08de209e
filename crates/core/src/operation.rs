//! The driller's operation.

mod event;
mod set_points;

pub use event::Event;

use std::fmt;

use serde::{Deserialize, Serialize};

/// Axial motion of the string in an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AxialMotion {
    /// Out of the hole, at the trip speed.
    Out,
    /// Into the hole, at the trip speed, off bottom.
    In,
    /// Not at all.
    Still,
    /// Into the rock, at the rate of penetration.
    Drilling,
}

impl AxialMotion {
    /// Its direction: 1 towards the bit, -1 towards the surface.
    pub(crate) const fn direction(self) -> f64 {
        match self {
            Self::Out => -1.0,
            Self::Still => 0.0,
            Self::In | Self::Drilling => 1.0,
        }
    }
}

/// Declares the kinds of operation, each once: its description and motion of the string, its name
/// in case files and results, which is also that of its constructor, its words for a reader, and
/// the constructor's further arguments.
macro_rules! operation_kinds {
    ($(
        $(#[$meaning:meta])*
        $kind:ident = $name:ident, $words:literal {
            moves: $motion:ident, rotates: $rotates:literal, circulates: $circulates:literal
        } $(needs $needs:literal)?;
    )+) => {
        /// The operations that torque and drag are computed for.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum OperationKind {
            $($(#[$meaning])* $kind,)+
        }

        impl OperationKind {
            /// Every operation, in the order in which reports list them.
            pub const ALL: [Self; [$(stringify!($name)),+].len()] = [$(Self::$kind),+];

            /// Name in case files and results: `trip_out`, `rotate_off_bottom`, ...
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => stringify!($name),)+
                }
            }

            /// Name in messages, pages and tables: "trip out", "rotate off bottom", ...
            pub const fn words(self) -> &'static str {
                match self {
                    $(Self::$kind => $words,)+
                }
            }

            /// Axial motion of the string.
            pub(crate) const fn axial_motion(self) -> AxialMotion {
                match self {
                    $(Self::$kind => AxialMotion::$motion,)+
                }
            }

            /// Whether the whole string turns.
            pub const fn rotates(self) -> bool {
                match self {
                    $(Self::$kind => $rotates,)+
                }
            }

            /// Whether the pumps run: while the string trips without rotation the top drive is off
            /// it.
            pub const fn circulates(self) -> bool {
                match self {
                    $(Self::$kind => $circulates,)+
                }
            }
        }

        /// Each kind of operation, with the bit at a measured depth.
        impl Operation {
            $(
                $(#[$meaning])*
                ///
                /// The bit is at a measured depth, m.
                $(#[doc = concat!("It needs ", $needs, ".")])?
                pub const fn $name(bit_depth_m: f64) -> Self {
                    Self::new(OperationKind::$kind, bit_depth_m)
                }
            )+
        }
    };
}

operation_kinds! {
    /// Pulling the string out of the hole without rotation.
    TripOut = trip_out, "trip out" { moves: Out, rotates: false, circulates: false };
    /// Running the string into the hole without rotation.
    TripIn = trip_in, "trip in" { moves: In, rotates: false, circulates: false };
    /// Rotating with the bit off bottom and no axial motion.
    RotateOffBottom = rotate_off_bottom, "rotate off bottom" { moves: Still, rotates: true, circulates: true }
        needs "a rotary speed";
    /// Rotary drilling: rotating and advancing with weight on the bit.
    Drill = drill, "drill" { moves: Drilling, rotates: true, circulates: true }
        needs "a rotary speed, and weight on bit, torque and rate of penetration of the bit";
    /// Advancing with weight on the bit without rotating the string (mud motor).
    Slide = slide, "slide" { moves: Drilling, rotates: false, circulates: true }
        needs "weight on bit, torque and rate of penetration of the bit";
    /// Rotating while running in, off bottom.
    Ream = ream, "ream" { moves: In, rotates: true, circulates: true } needs "a rotary speed";
    /// Rotating while pulling out, off bottom.
    BackReam = back_ream, "back ream" { moves: Out, rotates: true, circulates: true } needs "a rotary speed";
}

/// Its [words](OperationKind::words).
impl fmt::Display for OperationKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.words())
    }
}

impl OperationKind {
    /// The operation of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether the bit is on bottom and cuts.
    pub const fn on_bottom(self) -> bool {
        matches!(self.axial_motion(), AxialMotion::Drilling)
    }

    /// Whether the string moves at the trip speed.
    pub const fn trips(self) -> bool {
        matches!(self.axial_motion(), AxialMotion::Out | AxialMotion::In)
    }

    /// The operation that moves the string along the hole as this one does and does not turn it;
    /// itself where there is none.
    pub(crate) fn without_rotation(self) -> Self {
        if !self.rotates() {
            return self;
        }
        let alike = |kind: &Self| !kind.rotates() && kind.axial_motion() == self.axial_motion();
        Self::ALL.into_iter().find(alike).unwrap_or(self)
    }
}

/// One operation with its set points, as the driller gives them.
///
/// Every set point is kept whatever the kind; the accessors below return the values that apply to
/// the kind (a tripping string does not rotate, whatever the value of `rotary_speed_rad_per_s`).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Operation {
    /// Kind of the operation.
    pub kind: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Rotary speed at surface when the string turns, rad/s, clockwise looking down the hole.
    pub rotary_speed_rad_per_s: f64,
    /// Weight on bit when the bit is on bottom, N, positive in compression.
    pub weight_on_bit_N: f64,
    /// Pull on the bit when it is off bottom, N: the resistance of a stuck bit, a fish or a core.
    pub bit_pull_N: f64,
    /// Torque of the bit at `weight_on_bit_N`, N·m.
    pub bit_torque_N_m: f64,
    /// Rate of penetration at `weight_on_bit_N` and `rotary_speed_rad_per_s`, m/s.
    pub rate_of_penetration_m_per_s: f64,
    /// Axial speed of tripping and reaming, m/s, positive.
    pub trip_speed_m_per_s: f64,
    /// Flow rate of the pumps while they run, m³/s.
    pub flow_rate_m3_per_s: f64,
    /// Pressure drop of the bit's nozzles at that flow rate, Pa.
    pub bit_pressure_drop_Pa: f64,
    /// Pressure drop of a mud motor that gives `bit_torque_N_m`, Pa.
    pub motor_pressure_drop_Pa: f64,
}

impl Operation {
    /// Whether it pushes its string down the hole without rotation.
    pub fn slides_down(&self) -> bool {
        !self.kind.rotates() && self.kind.axial_motion().direction() > 0.0
    }

    /// Rotary speed of the string, rad/s; zero where the kind does not rotate.
    pub fn rotation_rad_per_s(&self) -> f64 {
        if self.kind.rotates() { self.rotary_speed_rad_per_s } else { 0.0 }
    }

    /// Axial speed of the string, m/s, positive towards the bit.
    pub fn axial_velocity_m_per_s(&self) -> f64 {
        match self.kind.axial_motion() {
            AxialMotion::Out => -self.trip_speed_m_per_s,
            AxialMotion::In => self.trip_speed_m_per_s,
            AxialMotion::Still => 0.0,
            AxialMotion::Drilling => self.rate_of_penetration_m_per_s,
        }
    }

    /// Axial speed of the string at another weight on bit and rotary speed, m/s, positive towards
    /// the bit: on bottom in proportion to both, but that a motor turns the bit of a string that
    /// slides.
    pub fn axial_velocity_at_m_per_s(
        &self,
        weight_on_bit_N: f64,
        rotary_speed_rad_per_s: f64,
    ) -> f64 {
        let part = |value: f64, whole: f64| if whole > 0.0 { value / whole } else { 1.0 };
        let cutting =
            if self.kind.on_bottom() { part(weight_on_bit_N, self.weight_on_bit_N) } else { 1.0 };
        let turning = if self.kind.on_bottom() && self.kind.rotates() {
            part(rotary_speed_rad_per_s, self.rotary_speed_rad_per_s)
        } else {
            1.0
        };
        self.axial_velocity_m_per_s() * cutting * turning
    }

    /// Weight on bit, N; zero off bottom.
    pub fn weight_on_bit_now_N(&self) -> f64 {
        if self.kind.on_bottom() { self.weight_on_bit_N } else { 0.0 }
    }

    /// Pull on the bit, N; zero on bottom.
    pub fn bit_pull_now_N(&self) -> f64 {
        if self.kind.on_bottom() { 0.0 } else { self.bit_pull_N }
    }

    /// Effective tension at the bit, N, without the thrust of its jets: the pull there, less the
    /// weight on it.
    pub fn tension_at_bit_N(&self) -> f64 {
        self.bit_pull_now_N() - self.weight_on_bit_now_N()
    }

    /// Bit torque that the string carries, N·m; zero off bottom. A sliding string carries the
    /// reaction of its motor, which is the same torque.
    pub fn bit_torque_now_N_m(&self) -> f64 {
        if self.kind.on_bottom() { self.bit_torque_N_m } else { 0.0 }
    }

    /// Present flow rate of the pumps, m³/s; zero while the string trips without rotation, because
    /// the top drive is disconnected.
    pub fn flow_now_m3_per_s(&self) -> f64 {
        if self.kind.circulates() { self.flow_rate_m3_per_s } else { 0.0 }
    }

    /// Pressure drop of a mud motor, Pa; zero off bottom, where the bit takes no torque.
    pub fn motor_loss_Pa(&self) -> f64 {
        if self.kind.on_bottom() { self.motor_pressure_drop_Pa } else { 0.0 }
    }

    /// Pressure drop of the nozzles at a flow rate, Pa: by its square.
    pub fn bit_loss_Pa(&self, flow_m3_per_s: f64) -> f64 {
        if self.flow_rate_m3_per_s > 0.0 {
            self.bit_pressure_drop_Pa * (flow_m3_per_s / self.flow_rate_m3_per_s).powi(2)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::OperationKind::{
        self, BackReam, Drill, Ream, RotateOffBottom, Slide, TripIn, TripOut,
    };

    #[test]
    fn what_turns_has_an_operation_that_slides_the_same_way() {
        let pairs = [(Drill, Slide), (Ream, TripIn), (BackReam, TripOut)];
        for kind in OperationKind::ALL {
            let pair = pairs.iter().find(|(turns, _)| *turns == kind);
            assert_eq!(kind.without_rotation(), pair.map_or(kind, |(_, slides)| *slides));
        }
        assert_eq!(RotateOffBottom.without_rotation(), RotateOffBottom);
    }

    #[test]
    fn a_bit_is_pressed_on_bottom_and_pulled_off_it() {
        for kind in OperationKind::ALL {
            let operation = super::Operation::new(kind, 1e3).weight_on_bit_N(4e4).bit_pull_N(9e4);
            let expected = if kind.on_bottom() { -4e4 } else { 9e4 };
            assert_eq!(operation.tension_at_bit_N(), expected);
        }
    }

    #[test]
    fn its_name_is_that_in_files() {
        for kind in OperationKind::ALL {
            assert_eq!(serde_json::to_value(kind).expect("a name"), kind.name());
            assert_eq!(kind.name().replace('_', " "), kind.words());
            let read: OperationKind = serde_json::from_value(kind.name().into()).expect("a kind");
            assert_eq!(read, kind);
        }
    }

    #[test]
    fn the_pumps_stand_only_while_the_string_trips() {
        let still = OperationKind::ALL.into_iter().filter(|kind| !kind.circulates());
        assert_eq!(still.collect::<Vec<_>>(), [TripOut, TripIn]);
    }
}
