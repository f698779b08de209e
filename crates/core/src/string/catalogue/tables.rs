//! The dimensions, in inches as the standards print them.

use super::{
    CatalogueEntry, EntryConnection, JointDimensions, PipeClass, TubularKind, coiled, connections,
    entry::{INCH_M, PSI_PA},
};
use crate::string::ConnectionStrength;

/// Grades of drill pipe and their minimum yield strength, psi (API Spec 5DP).
const GRADES: [(&str, f64); 4] =
    [("E-75", 75_000.0), ("X-95", 95_000.0), ("G-105", 105_000.0), ("S-135", 135_000.0)];

const PIPE_SOURCE: &str = "API Spec 5DP (body, grades), API RP 7G (tool joints, torques), range 2 \
    pipe in stands of 28.8 m";
const PROPRIETARY_SOURCE: &str = "API Spec 5DP (body, grades), XT57 tool joint (proprietary, its \
    torques its maker's), range 2 pipe in stands of 28.8 m";
const HEAVY_WEIGHT_SOURCE: &str =
    "API Spec 7-1 and API RP 7G (body, 55 ksi tube, joints, wear pad), range 2 pipe";
const COLLAR_SOURCE: &str = "API Spec 7-1 (outside diameter, bore, yield strength), API RP 7G \
    (torques; the connection is a usual one)";

/// Distance between joints of range 2 drill pipe, m: a third of a stand, which is 28.8 m. API Spec
/// 5DP lets a range 2 pipe be 8.84 to 9.75 m long with its tool joint.
const PIPE_SPACING_M: f64 = 9.6;
/// Distance between joints of range 2 heavy-weight drill pipe, m (30-1/2 ft).
const HEAVY_WEIGHT_SPACING_M: f64 = 9.3;

/// Drill pipe of one size and weight with its tool joints.
struct Pipe {
    size: &'static str,
    od: f64,
    weight: &'static str,
    wall: f64,
    /// Outside diameter of the upset at the joint.
    upset_od: f64,
    /// Connection, outside and inside diameter, and length (tong spaces of pin and box together) of
    /// the joint, in the order of [`GRADES`]. The light weights are made in E-75 alone.
    joints: &'static [(&'static str, f64, f64, f64)],
}

#[rustfmt::skip]
const PIPES: [Pipe; 24] = [
    Pipe { size: "2-3/8", od: 2.375, weight: "4.85", wall: 0.190, upset_od: 2.5625, joints: &[
        ("NC26", 3.375, 1.75, 15.0)] },
    Pipe { size: "2-3/8", od: 2.375, weight: "6.65", wall: 0.280, upset_od: 2.5625, joints: &[
        ("NC26", 3.375, 1.75, 15.0), ("NC26", 3.375, 1.75, 15.0),
        ("NC26", 3.375, 1.75, 15.0), ("NC26", 3.625, 1.5, 15.0)] },
    Pipe { size: "2-7/8", od: 2.875, weight: "6.85", wall: 0.217, upset_od: 3.1875, joints: &[
        ("NC31", 4.125, 2.125, 16.0)] },
    Pipe { size: "2-7/8", od: 2.875, weight: "10.40", wall: 0.362, upset_od: 3.1875, joints: &[
        ("NC31", 4.125, 2.125, 16.0), ("NC31", 4.125, 2.0, 16.0),
        ("NC31", 4.125, 2.0, 16.0), ("NC31", 4.375, 1.625, 16.0)] },
    Pipe { size: "3-1/2", od: 3.5, weight: "9.50", wall: 0.254, upset_od: 3.875, joints: &[
        ("NC38", 4.75, 2.6875, 18.5)] },
    Pipe { size: "3-1/2", od: 3.5, weight: "13.30", wall: 0.368, upset_od: 3.875, joints: &[
        ("NC38", 4.75, 2.6875, 18.5), ("NC38", 5.0, 2.5625, 18.5),
        ("NC38", 5.0, 2.4375, 18.5), ("NC38", 5.0, 2.125, 18.5)] },
    Pipe { size: "3-1/2", od: 3.5, weight: "15.50", wall: 0.449, upset_od: 3.875, joints: &[
        ("NC38", 5.0, 2.5625, 18.5), ("NC38", 5.0, 2.4375, 18.5),
        ("NC38", 5.0, 2.125, 18.5), ("NC40", 5.5, 2.25, 17.0)] },
    Pipe { size: "4", od: 4.0, weight: "11.85", wall: 0.262, upset_od: 4.5, joints: &[
        ("NC46", 6.0, 3.25, 17.0)] },
    Pipe { size: "4", od: 4.0, weight: "14.00", wall: 0.330, upset_od: 4.1875, joints: &[
        ("NC40", 5.25, 2.8125, 17.0), ("NC40", 5.25, 2.6875, 17.0),
        ("NC40", 5.5, 2.4375, 17.0), ("NC40", 5.5, 2.0, 17.0)] },
    Pipe { size: "4", od: 4.0, weight: "15.70", wall: 0.380, upset_od: 4.5, joints: &[
        ("NC46", 6.0, 3.25, 17.0), ("NC46", 6.0, 3.0, 17.0),
        ("NC46", 6.0, 3.0, 17.0), ("NC46", 6.0, 2.625, 17.0)] },
    Pipe { size: "4-1/2", od: 4.5, weight: "13.75", wall: 0.271, upset_od: 4.6875, joints: &[
        ("NC46", 6.0, 3.375, 17.0)] },
    Pipe { size: "4-1/2", od: 4.5, weight: "16.60", wall: 0.337, upset_od: 4.6875, joints: &[
        ("NC46", 6.25, 3.25, 17.0), ("NC46", 6.25, 3.0, 17.0),
        ("NC46", 6.25, 3.0, 17.0), ("NC46", 6.25, 2.75, 17.0)] },
    Pipe { size: "4-1/2", od: 4.5, weight: "20.00", wall: 0.430, upset_od: 5.0, joints: &[
        ("NC50", 6.625, 3.625, 17.0), ("NC50", 6.625, 3.5, 17.0),
        ("NC50", 6.625, 3.5, 17.0), ("NC50", 6.625, 3.0, 17.0)] },
    Pipe { size: "4-1/2", od: 4.5, weight: "22.82", wall: 0.500, upset_od: 5.0, joints: &[
        ("NC50", 6.625, 3.625, 17.0), ("NC50", 6.625, 3.25, 17.0),
        ("NC50", 6.625, 3.25, 17.0), ("NC50", 6.625, 2.75, 17.0)] },
    Pipe { size: "5", od: 5.0, weight: "16.25", wall: 0.296, upset_od: 5.125, joints: &[
        ("NC50", 6.625, 3.75, 17.0)] },
    Pipe { size: "5", od: 5.0, weight: "19.50", wall: 0.362, upset_od: 5.125, joints: &[
        ("NC50", 6.625, 3.75, 17.0), ("NC50", 6.625, 3.5, 17.0),
        ("NC50", 6.625, 3.25, 17.0), ("NC50", 6.625, 2.75, 17.0)] },
    Pipe { size: "5", od: 5.0, weight: "25.60", wall: 0.500, upset_od: 5.125, joints: &[
        ("5-1/2 FH", 7.0, 3.5, 18.0), ("5-1/2 FH", 7.0, 3.5, 18.0),
        ("5-1/2 FH", 7.25, 3.5, 18.0), ("5-1/2 FH", 7.25, 3.25, 18.0)] },
    Pipe { size: "5-1/2", od: 5.5, weight: "19.20", wall: 0.304, upset_od: 5.6875, joints: &[
        ("5-1/2 FH", 7.0, 4.0, 18.0)] },
    Pipe { size: "5-1/2", od: 5.5, weight: "21.90", wall: 0.361, upset_od: 5.6875, joints: &[
        ("5-1/2 FH", 7.0, 4.0, 18.0), ("5-1/2 FH", 7.0, 3.75, 18.0),
        ("5-1/2 FH", 7.25, 3.5, 18.0), ("5-1/2 FH", 7.5, 3.0, 18.0)] },
    Pipe { size: "5-1/2", od: 5.5, weight: "24.70", wall: 0.415, upset_od: 5.6875, joints: &[
        ("5-1/2 FH", 7.0, 4.0, 18.0), ("5-1/2 FH", 7.25, 3.5, 18.0),
        ("5-1/2 FH", 7.25, 3.5, 18.0), ("5-1/2 FH", 7.5, 3.0, 18.0)] },
    Pipe { size: "5-7/8", od: 5.875, weight: "23.40", wall: 0.361, upset_od: 6.0, joints: &[
        ("XT57", 7.0, 4.25, 25.0); 4] },
    Pipe { size: "5-7/8", od: 5.875, weight: "26.30", wall: 0.415, upset_od: 6.0, joints: &[
        ("XT57", 7.0, 4.25, 25.0); 4] },
    Pipe { size: "6-5/8", od: 6.625, weight: "25.20", wall: 0.330, upset_od: 6.90625, joints: &[
        ("6-5/8 FH", 8.0, 5.0, 19.0), ("6-5/8 FH", 8.0, 5.0, 19.0),
        ("6-5/8 FH", 8.25, 4.75, 19.0), ("6-5/8 FH", 8.5, 4.25, 19.0)] },
    Pipe { size: "6-5/8", od: 6.625, weight: "27.70", wall: 0.362, upset_od: 6.90625, joints: &[
        ("6-5/8 FH", 8.0, 5.0, 19.0), ("6-5/8 FH", 8.25, 4.75, 19.0),
        ("6-5/8 FH", 8.25, 4.75, 19.0), ("6-5/8 FH", 8.5, 4.25, 19.0)] },
];

/// Heavy-weight drill pipe.
struct HeavyWeight {
    size: &'static str,
    od: f64,
    id: f64,
    weight: &'static str,
    connection: &'static str,
    joint_od: f64,
    joint_id: f64,
    pad_od: f64,
}

/// Joints and wear pad of heavy-weight drill pipe: two joints of 24 in, a pad of 24 in.
const HEAVY_WEIGHT_JOINT: f64 = 48.0;
const HEAVY_WEIGHT_PAD: f64 = 24.0;
const HEAVY_WEIGHT_YIELD_PSI: f64 = 55_000.0;

#[rustfmt::skip]
const HEAVY_WEIGHTS: [HeavyWeight; 6] = [
    HeavyWeight { size: "3-1/2", od: 3.5, id: 2.0625, weight: "25.3", connection: "NC38", joint_od: 4.75, joint_id: 2.1875, pad_od: 4.0 },
    HeavyWeight { size: "4", od: 4.0, id: 2.5625, weight: "29.7", connection: "NC40", joint_od: 5.25, joint_id: 2.6875, pad_od: 4.5 },
    HeavyWeight { size: "4-1/2", od: 4.5, id: 2.75, weight: "41.0", connection: "NC46", joint_od: 6.25, joint_id: 2.875, pad_od: 5.0 },
    HeavyWeight { size: "5", od: 5.0, id: 3.0, weight: "49.3", connection: "NC50", joint_od: 6.625, joint_id: 3.0625, pad_od: 5.5 },
    HeavyWeight { size: "5-1/2", od: 5.5, id: 3.375, weight: "57.0", connection: "5-1/2 FH", joint_od: 7.0, joint_id: 3.5, pad_od: 6.0 },
    HeavyWeight { size: "6-5/8", od: 6.625, id: 4.5, weight: "70.8", connection: "6-5/8 FH", joint_od: 8.0, joint_id: 4.625, pad_od: 7.125 },
];

/// Drill collars: outside diameter, bore and the connection that API Spec 7-1 and common practice
/// put on them.
#[rustfmt::skip]
const COLLARS: [(&str, f64, &str, f64, &str); 24] = [
    ("3-1/8", 3.125, "1-1/4", 1.25, "NC23"),
    ("3-1/2", 3.5, "1-1/2", 1.5, "NC26"),
    ("4-1/8", 4.125, "2", 2.0, "NC31"),
    ("4-3/4", 4.75, "2", 2.0, "NC35"),
    ("4-3/4", 4.75, "2-1/4", 2.25, "NC35"),
    ("5", 5.0, "2-1/4", 2.25, "NC38"),
    ("6", 6.0, "2-1/4", 2.25, "NC44"),
    ("6", 6.0, "2-13/16", 2.8125, "NC44"),
    ("6-1/4", 6.25, "2-1/4", 2.25, "NC46"),
    ("6-1/4", 6.25, "2-13/16", 2.8125, "NC46"),
    ("6-1/2", 6.5, "2-1/4", 2.25, "NC46"),
    ("6-1/2", 6.5, "2-13/16", 2.8125, "NC46"),
    ("6-3/4", 6.75, "2-1/4", 2.25, "NC50"),
    ("6-3/4", 6.75, "2-13/16", 2.8125, "NC50"),
    ("7", 7.0, "2-1/4", 2.25, "NC50"),
    ("7", 7.0, "2-13/16", 2.8125, "NC50"),
    ("7-1/4", 7.25, "2-13/16", 2.8125, "NC50"),
    ("7-3/4", 7.75, "2-13/16", 2.8125, "NC56"),
    ("8", 8.0, "2-13/16", 2.8125, "NC56"),
    ("8-1/4", 8.25, "2-13/16", 2.8125, "6-5/8 REG"),
    ("9", 9.0, "2-13/16", 2.8125, "NC61"),
    ("9-1/2", 9.5, "3", 3.0, "7-5/8 REG"),
    ("10", 10.0, "3", 3.0, "NC70"),
    ("11", 11.0, "3", 3.0, "NC77"),
];

/// Minimum yield strength of collars, psi: 110 ksi below 7 in, 100 ksi from there (API Spec 7-1).
fn collar_yield_psi(od: f64) -> f64 {
    if od < 7.0 { 110_000.0 } else { 100_000.0 }
}

/// A connection of the catalogue.
fn connected(name: &'static str, strength: ConnectionStrength) -> Option<EntryConnection> {
    Some(EntryConnection { name: name.into(), strength })
}

pub(super) fn entries() -> Vec<CatalogueEntry> {
    let mut entries = Vec::new();
    for pipe in &PIPES {
        for (&(connection, joint_od, joint_id, joint_length), (grade, yield_psi)) in
            pipe.joints.iter().zip(GRADES)
        {
            let joint = JointDimensions {
                od_m: joint_od * INCH_M,
                id_m: joint_id * INCH_M,
                length_m: joint_length * INCH_M,
                upset_od_m: Some(pipe.upset_od * INCH_M),
                spacing_m: PIPE_SPACING_M,
                pad_m: None,
            };
            let strength = connections::tool_joint(connection, joint.od_m, joint.id_m);
            entries.push(CatalogueEntry {
                designation: format!("{} in {} lb/ft {grade}", pipe.size, pipe.weight),
                kind: TubularKind::DrillPipe,
                class: PipeClass::New,
                od_m: pipe.od * INCH_M,
                id_m: (pipe.od - 2.0 * pipe.wall) * INCH_M,
                joints: Some(joint),
                connection: connected(connection, strength),
                given_mass_kg_per_m: None,
                yield_strength_Pa: yield_psi * PSI_PA,
                source: match connections::connection(connection) {
                    Some(_) => PIPE_SOURCE.into(),
                    None => PROPRIETARY_SOURCE.into(),
                },
            });
        }
    }
    entries.extend(HEAVY_WEIGHTS.iter().map(|pipe| {
        let joint = JointDimensions {
            od_m: pipe.joint_od * INCH_M,
            id_m: pipe.joint_id * INCH_M,
            length_m: HEAVY_WEIGHT_JOINT * INCH_M,
            upset_od_m: None,
            spacing_m: HEAVY_WEIGHT_SPACING_M,
            pad_m: Some((pipe.pad_od * INCH_M, HEAVY_WEIGHT_PAD * INCH_M)),
        };
        let strength = connections::heavy_weight(pipe.connection, joint.od_m, joint.id_m);
        CatalogueEntry {
            designation: format!("HWDP {} in {} lb/ft", pipe.size, pipe.weight),
            kind: TubularKind::HeavyWeight,
            class: PipeClass::New,
            od_m: pipe.od * INCH_M,
            id_m: pipe.id * INCH_M,
            joints: Some(joint),
            connection: connected(pipe.connection, strength),
            given_mass_kg_per_m: None,
            yield_strength_Pa: HEAVY_WEIGHT_YIELD_PSI * PSI_PA,
            source: HEAVY_WEIGHT_SOURCE.into(),
        }
    }));
    entries.extend(COLLARS.iter().map(|&(od_name, od, bore_name, bore, connection)| {
        let (od_m, id_m, yield_psi) = (od * INCH_M, bore * INCH_M, collar_yield_psi(od));
        let strength = connections::collar(connection, od_m, id_m, yield_psi);
        CatalogueEntry {
            designation: format!("{od_name} in x {bore_name} in collar"),
            kind: TubularKind::Collar,
            class: PipeClass::New,
            od_m,
            id_m,
            joints: None,
            connection: connected(connection, strength),
            given_mass_kg_per_m: None,
            yield_strength_Pa: yield_psi * PSI_PA,
            source: COLLAR_SOURCE.into(),
        }
    }));
    entries.extend(coiled::entries());
    entries
}
