//! A survey as a WITSML trajectory.

use std::io;

use wholestring_units::Dimension;

use super::{
    Version,
    xml::{Xml, uid},
};
use crate::{
    look::{Look, number},
    survey::Row,
};

const NAME: &str = "Survey of the case";
const METHOD: &str = "minimum curvature";

/// The trajectory through these stations.
///
/// # Errors
/// None for valid stations.
pub fn trajectory(look: &Look, rows: &[Row], version: Version) -> io::Result<String> {
    match version {
        Version::V1411 => v1411(look, rows),
        Version::V20 => v20(look, rows),
        Version::V21 => v21(look, rows),
    }
}

fn v1411(look: &Look, rows: &[Row]) -> io::Result<String> {
    let (length, angle) = (look.uom(Dimension::Length), look.uom(Dimension::Angle));
    let severity = look.uom(Dimension::DoglegSeverity);
    let well = uid(&look.name);
    let mut xml = Xml::new()?;
    xml.open_series_1("trajectorys")?;
    let uids = [("uidWell", well.as_str()), ("uidWellbore", &well), ("uid", "survey")];
    xml.open("trajectory", &uids)?;
    xml.leaf("nameWell", &[], &look.name)?;
    xml.leaf("nameWellbore", &[], &look.name)?;
    xml.leaf("name", &[], NAME)?;
    if let (Some(first), Some(last)) = (rows.first(), rows.last()) {
        xml.quantity("mdMn", length, first.md_m)?;
        xml.quantity("mdMx", length, last.md_m)?;
    }
    for (place, row) in rows.iter().enumerate() {
        xml.open("trajectoryStation", &[("uid", &(place + 1).to_string())])?;
        xml.leaf("typeTrajStation", &[], kind(place))?;
        xml.leaf("calcAlgorithm", &[], METHOD)?;
        xml.quantity("md", length, row.md_m)?;
        xml.quantity("tvd", length, row.tvd_m)?;
        xml.quantity("incl", angle, row.inclination_rad)?;
        xml.quantity("azi", angle, row.azimuth_rad)?;
        xml.quantity("dispNs", length, row.north_m)?;
        xml.quantity("dispEw", length, row.east_m)?;
        xml.quantity("dls", severity, row.dogleg_severity_rad_per_m)?;
        xml.close("trajectoryStation")?;
    }
    xml.open("commonData", &[])?;
    xml.leaf("sourceName", &[], &look.program)?;
    xml.leaf("dTimCreation", &[], &look.created)?;
    xml.close("commonData")?;
    xml.close("trajectory")?;
    xml.close("trajectorys")?;
    xml.finish()
}

fn v20(look: &Look, rows: &[Row]) -> io::Result<String> {
    let length = look.uom(Dimension::Length);
    let datum = [("datum", "unknown")];
    let mut xml = Xml::new()?;
    xml.open_series_2("Trajectory", look, NAME, Version::V20)?;
    xml.leaf("GrowingStatus", &[], "closed")?;
    if let (Some(first), Some(last)) = (rows.first(), rows.last()) {
        xml.quantity_with("MdMn", length, &datum, first.md_m)?;
        xml.quantity_with("MdMx", length, &datum, last.md_m)?;
    }
    for (place, row) in rows.iter().enumerate() {
        xml.open("TrajectoryStation", &[("uid", &(place + 1).to_string())])?;
        xml.leaf("TypeTrajStation", &[], kind(place))?;
        xml.leaf("CalcAlgorithm", &[], METHOD)?;
        xml.quantity_with("Md", length, &datum, row.md_m)?;
        xml.quantity_with("Tvd", length, &datum, row.tvd_m)?;
        direction_and_place(&mut xml, look, row)?;
        xml.close("TrajectoryStation")?;
    }
    xml.wellbore(look, Version::V20)?;
    xml.close("Trajectory")?;
    xml.finish()
}

fn v21(look: &Look, rows: &[Row]) -> io::Result<String> {
    let length = look.uom(Dimension::Length);
    let mut xml = Xml::new()?;
    xml.open_series_2("Trajectory", look, NAME, Version::V21)?;
    xml.inactive()?;
    xml.open("eml:Index", &[])?;
    xml.leaf("eml:IndexKind", &[], "measured depth")?;
    xml.leaf("eml:Uom", &[], length.symbol)?;
    xml.leaf("eml:Direction", &[], "increasing")?;
    xml.close("eml:Index")?;
    if let (Some(first), Some(last)) = (rows.first(), rows.last()) {
        xml.open("eml:MdInterval", &[])?;
        for (name, row) in [("eml:MdMin", first), ("eml:MdMax", last)] {
            xml.leaf(name, &[], &number(length.of(row.md_m)).unwrap_or_default())?;
        }
        xml.leaf("eml:Uom", &[], length.symbol)?;
        xml.close("eml:MdInterval")?;
    }
    let depth_kind = [("xsi:type", "eml:DatumVerticalDepth")];
    for (place, row) in rows.iter().enumerate() {
        xml.open("TrajectoryStation", &[("uid", &(place + 1).to_string())])?;
        xml.leaf("eml:Creation", &[], &look.created)?;
        xml.leaf("eml:LastUpdate", &[], &look.created)?;
        xml.open("eml:Md", &[])?;
        xml.quantity("eml:MeasuredDepth", length, row.md_m)?;
        xml.close("eml:Md")?;
        xml.leaf("TypeTrajStation", &[], kind(place))?;
        xml.leaf("CalcAlgorithm", &[], METHOD)?;
        xml.open("Tvd", &depth_kind)?;
        xml.quantity("eml:VerticalDepth", length, row.tvd_m)?;
        xml.close("Tvd")?;
        direction_and_place(&mut xml, look, row)?;
        xml.close("TrajectoryStation")?;
    }
    xml.wellbore(look, Version::V21)?;
    xml.close("Trajectory")?;
    xml.finish()
}

/// Elements of a station that both versions of WITSML 2 share.
fn direction_and_place(xml: &mut Xml, look: &Look, row: &Row) -> io::Result<()> {
    let (length, angle) = (look.uom(Dimension::Length), look.uom(Dimension::Angle));
    let severity = look.uom(Dimension::DoglegSeverity).of_series_2();
    xml.quantity("Incl", angle, row.inclination_rad)?;
    xml.quantity("Azi", angle, row.azimuth_rad)?;
    xml.quantity("DispNs", length, row.north_m)?;
    xml.quantity("DispEw", length, row.east_m)?;
    xml.quantity("Dls", severity, row.dogleg_severity_rad_per_m)
}

/// Type of a station: the tie-in, or one whose type, measured or planned, a case does not contain.
fn kind(place: usize) -> &'static str {
    if place == 0 { "tie in point" } else { "unknown" }
}
