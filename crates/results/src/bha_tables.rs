//! Nodes and contacts of a static BHA analysis.

use wholestring::statics::assembly::{AssemblyNode, Contact};

use crate::{Row, Table, row::rows};

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
