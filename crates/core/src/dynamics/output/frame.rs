//! The state of the whole string at one moment.

use serde::Serialize;

use crate::outcome::{IN_TIME, columns};

columns! {
    /// The whole string at one moment: one number a node in each vector, from the surface down.
    /// High and right are those of a person who looks down the hole; contact and friction are
    /// averages over the sample that ends at this moment.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Frame, "Columns of a frame, one value per node, in the order of `frames.parquet`."
    FRAME {
        md_m: Vec<f64> => Depth, "Measured depth of the node", known_by IN_TIME;
        offset_high_m: Vec<f64> => Length,
            "Offset of the string's axis from the hole's towards the high side",
            label "Offset to the high side", known_by IN_TIME;
        offset_right_m: Vec<f64> => Length,
            "Offset to the right, looking down the hole", label "Offset to the right", known_by IN_TIME;
        north_m: Vec<f64> => Length, "North of the node", known_by IN_TIME;
        east_m: Vec<f64> => Length, "East of the node", known_by IN_TIME;
        tvd_m: Vec<f64> => Depth, "True vertical depth of the node", known_by IN_TIME;
        velocity_high_m_per_s: Vec<f64> => Speed,
            "Velocity towards the high side", known_by IN_TIME;
        velocity_right_m_per_s: Vec<f64> => Speed, "Velocity to the right", known_by IN_TIME;
        axial_velocity_m_per_s: Vec<f64> => Speed, "Velocity down the hole", known_by IN_TIME;
        rotary_speed_rad_per_s: Vec<f64> => RotarySpeed,
            "Rotary speed of the node; positive clockwise looking down the hole", known_by IN_TIME;
        twist_rad: Vec<f64> => Angle,
            "Turn of the node against the bit; positive where it leads", known_by IN_TIME;
        tilt_high_rad: Vec<f64> => Angle,
            "Angle of the string's axis with the hole's towards the high side", known_by IN_TIME;
        tilt_right_rad: Vec<f64> => Angle, "Angle to the right", known_by IN_TIME;
        contact_force_N: Vec<f64> => Force,
            "Contact force of the node, averaged over the sample; positive on the high side",
            label "Contact force of the node",
            known_by IN_TIME;
        axial_friction_N: Vec<f64> => Force,
            "Axial friction of the wall on the node, averaged over the sample; positive \
             adds to hook load", known_by IN_TIME;
        friction_torque_N_m: Vec<f64> => Torque,
            "Torque of wall friction on the node, averaged over the sample", known_by IN_TIME;
        tension_N: Vec<f64> => Force,
            "Effective tension; negative in compression", label "Effective tension", known_by IN_TIME;
        torque_N_m: Vec<f64> => Torque, "Torque that the string carries", known_by IN_TIME;
        bending_moment_N_m: Vec<f64> => Torque,
            "Magnitude of the bending moment", known_by IN_TIME;
        von_mises_stress_Pa: Vec<f64> => Stress,
            "Von Mises stress at the most stressed point of the body's surface", known_by IN_TIME;
    }
    beside {
        /// Time since the start, s.
        time_s: f64;
    }
}

/// Declares the channels: the name of each in case files, and the columns of a frame that it is.
macro_rules! channels {
    ($($(#[$about:meta])* $channel:ident, $name:literal => $($column:ident),+;)*) => {
        /// A group of quantities that a frame holds of every node.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
        pub enum Channel {
            $($(#[$about])* $channel,)*
        }

        impl Channel {
            /// Every channel.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$channel,)*];

            /// Every channel by its name.
            pub const BY_NAME: &[(&'static str, Self)] = &[$(($name, Self::$channel),)*];

            /// Name in case files.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$channel => $name,)*
                }
            }

            /// The columns of a frame that it is, by their names.
            pub const fn columns(self) -> &'static [&'static str] {
                match self {
                    $(Self::$channel => &[$(stringify!($column)),+],)*
                }
            }
        }

        impl Frame {
            /// The vectors of a channel by their names in results.
            pub fn channel(&self, channel: Channel) -> Vec<(&'static str, &[f64])> {
                match channel {
                    $(Channel::$channel => {
                        vec![$((stringify!($column), &self.$column[..])),+]
                    })*
                }
            }
        }
    };
}

channels! {
    /// Offset from the hole's axis towards the high side and to the right of it.
    Position, "position" => offset_high_m, offset_right_m;
    /// North, east and vertical depth.
    Coordinates, "coordinates" => north_m, east_m, tvd_m;
    /// Lateral and axial velocity.
    Velocity, "velocity" =>
        velocity_high_m_per_s, velocity_right_m_per_s, axial_velocity_m_per_s;
    /// Rotary speed and turn against the bit.
    Rotation, "rotation" => rotary_speed_rad_per_s, twist_rad;
    /// Angle of the pipe's axis with the hole's.
    Tilt, "tilt" => tilt_high_rad, tilt_right_rad;
    /// Contact force.
    Contact, "contact" => contact_force_N;
    /// Friction on the wall.
    Friction, "friction" => axial_friction_N, friction_torque_N_m;
    /// Tension and torque.
    Force, "force" => tension_N, torque_N_m;
    /// Bending moment and von Mises stress.
    Stress, "stress" => bending_moment_N_m, von_mises_stress_Pa;
}

impl Channel {
    /// Those that are kept where nobody chooses.
    pub const USUAL: [Self; 5] =
        [Self::Position, Self::Velocity, Self::Rotation, Self::Contact, Self::Force];
}
