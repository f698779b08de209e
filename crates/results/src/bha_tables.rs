//! Tables of a static BHA analysis: nodes, contacts and sweeps.

use serde::{Deserialize, Serialize};
use wholestring::statics::assembly::{AssemblyNode, Contact};

use crate::{
    Row, Table,
    row::{named, rows},
};

rows! {
    for AssemblyNode {
        component = |_| component => Words, "Component at the node";
        from_bit_m => Length, "Distance from the bit";
        md_m => Depth, "Measured depth";
        hole_radius_m => Length, "Radius of the hole";
        offset_high_m = |node| node.offset_m[0] => Length,
            "Offset of the string's axis from the hole's towards the high side";
        offset_right_m = |node| node.offset_m[1] => Length,
            "The same to the right, looking down the hole";
        tilt_high_rad = |node| node.tilt_rad[0] => Angle,
            "Tilt of the string's axis downwards against the hole's, towards the high side; at a \
             bend of the part above it";
        tilt_right_rad = |node| node.tilt_rad[1] => Angle, "The same to the right";
        push_high_N = |node| node.push_N[0] => Force,
            "Contact force on the wall towards the high side";
        push_right_N = |node| node.push_N[1] => Force, "The same to the right";
        bending_moment_high_N_m = |node| node.moment_N_m[0] => Torque,
            "Bending moment whose centre of curvature is towards the high side";
        bending_moment_right_N_m = |node| node.moment_N_m[1] => Torque, "The same to the right";
        bending_moment_N_m = |node| node.bending_moment_N_m() => Torque,
            "Size of the bending moment";
        tension_N => Force, "Effective tension";
        torque_N_m => Torque, "Torque";
        bending_stress_Pa => Stress, "Largest bending stress from here to the next node below";
        von_mises_stress_Pa => Stress,
            "Largest von Mises stress from here to the next node below";
    }

    /// Columns of `bha.parquet`: the assembly and the pipe that was solved with it, one row per
    /// node from the bit up.
    pub const BHA with component: &str;
}

rows! {
    for Contact {
        touching => Words, "Touching part: `bit`, `blades`, `joint` or `body`";
        component = |contact| &contact.name => Words, "Component of the touching part";
        md_m => Depth, "Measured depth of the middle of its force";
        from_bit_m = |contact| contact.from_bit_m[0] => Length, "Its lower end, from the bit";
        to_bit_m = |contact| contact.from_bit_m[1] => Length, "Its upper end, from the bit";
        force_high_N = |contact| contact.force_N[0] => Force,
            "Force on the wall towards the high side";
        force_right_N = |contact| contact.force_N[1] => Force,
            "The same to the right, looking down the hole";
        force_N = |contact| contact.size_N() => Force, "Size of the force";
        side_rad => Angle,
            "Angle of the force from the high side, clockwise looking down the hole";
    }

    /// Columns of `bha_contacts.parquet`: the contacts of the assembly, one row per contact from
    /// the bit up, the bit first.
    pub const BHA_CONTACTS;
}

/// `bha.parquet`: a row for each node. `name` is that of a component, counted from the bit.
pub fn bha_table<'a>(nodes: &[AssemblyNode], name: impl Fn(usize) -> &'a str) -> Table {
    Row::table(nodes.iter().map(|node| (node, name(node.component))))
}

// Sweeps of a static BHA analysis: the assembly at other tool faces, weights and inclinations.

/// Quantity that is varied.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum BhaVaried {
    /// The tool face of the lowest bend, the others with it.
    Toolface,
    /// The weight on bit, and its torque in proportion.
    Weight,
    /// The inclination, of a straight hole or one with a constant build rate.
    Inclination,
}

impl BhaVaried {
    /// All, in the order in which they are reported.
    pub const ALL: [Self; 3] = [Self::Toolface, Self::Weight, Self::Inclination];

    /// Its name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Toolface => "toolface",
            Self::Weight => "weight",
            Self::Inclination => "inclination",
        }
    }
}

named! {
    BhaVaried: name;
}

rows! {
    /// The assembly at another tool face, weight or inclination.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct BhaPoint {
        varied: BhaVaried => Words, "Quantity varied: `toolface`, `weight` or `inclination`";
        message = |point| &point.message => Words,
            "Reason why there is no equilibrium; else empty",
            null_where "there is an equilibrium";
        toolface_rad: Option<f64> => Angle, "Tool face of the lowest bend; `null` without one",
            null_where "no component has a bend";
        weight_on_bit_N: f64 => Force, "Weight on bit";
        inclination_rad: f64 => Angle, "Inclination of the hole at the bit";
        message: String, "Reason why there is no equilibrium; empty where there is one";
        found: Option<BhaFound>, "The equilibrium; none where none was found", columns {
            side_force_high_N = |found| found.side_force_N[0] => Force,
                "Side force of the bit on the rock towards the high side; this and the following \
                 are `null` without an equilibrium",
                null_where "there is no equilibrium";
            side_force_right_N = |found| found.side_force_N[1] => Force,
                "The same to the right, looking down the hole; or `null`",
                null_where "there is no equilibrium";
            tilt_high_rad = |found| found.tilt_rad[0] => Angle,
                "Tilt of the bit against the hole's axis towards the high side; or `null`",
                null_where "there is no equilibrium";
            tilt_right_rad = |found| found.tilt_rad[1] => Angle, "The same to the right; or `null`",
                null_where "there is no equilibrium";
            largest_bending_moment_N_m => Torque,
                "Largest bending moment of the assembly; or `null`",
                null_where "there is no equilibrium";
            largest_von_mises_stress_Pa => Stress, "Largest von Mises stress of it; or `null`",
                null_where "there is no equilibrium";
            sag_inclination_rad => Angle,
                "Correction of the first survey sensor's inclination; `null` without a sensor",
                null_where "there is no survey sensor";
            sag_azimuth_rad => Angle,
                "The same of its azimuth; `null` without a sensor and where the hole is within 1° \
                 of the vertical",
                null_where "there is no survey sensor or the hole is within 1° of the vertical";
        };
    }

    /// Columns of `bha_sweep.parquet`: the assembly at other tool faces, weights and inclinations,
    /// one row for each.
    pub const BHA_SWEEP;
}

/// Results stored for a point of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BhaFound {
    /// Side force of the bit on the rock, N.
    pub side_force_N: [f64; 2],
    /// Tilt of the bit against the hole's axis, rad.
    pub tilt_rad: [f64; 2],
    /// Largest bending moment of the assembly, N·m.
    pub largest_bending_moment_N_m: f64,
    /// Largest von Mises stress of the assembly, Pa.
    pub largest_von_mises_stress_Pa: f64,
    /// Correction of the first sensor's inclination, rad.
    pub sag_inclination_rad: Option<f64>,
    /// The same of its azimuth.
    pub sag_azimuth_rad: Option<f64>,
}

impl BhaPoint {
    /// The number that is varied, SI.
    pub fn value(&self) -> f64 {
        match self.varied {
            BhaVaried::Toolface => self.toolface_rad.unwrap_or(f64::NAN),
            BhaVaried::Weight => self.weight_on_bit_N,
            BhaVaried::Inclination => self.inclination_rad,
        }
    }
}
