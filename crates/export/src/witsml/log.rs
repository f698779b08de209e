//! Results against bit depth as WITSML logs.

use std::io;

use wholestring_units::Dimension;

use super::{
    Version,
    xml::{Xml, uid, uuid},
};
use crate::look::{Look, Uom, number};

/// The index curve: measured depth of the bit.
const INDEX: &str = "DBTM";
const INDEX_MEANING: &str = "Measured depth of the bit";

/// Title of logs of WITSML 2.
const TITLE: &str = "Results against the depth of the bit";

/// Value for a missing number.
const NULL: &str = "-999.25";

/// Logs, one or several in a file: in 1.4.1.1 each by itself, in 2 each as a set of channels.
///
/// # Errors
/// None for valid logs.
pub fn logs(look: &Look, logs: &[Log], version: Version) -> io::Result<String> {
    match version {
        Version::V1411 => v1411(look, logs),
        Version::V20 => v20(look, logs),
        Version::V21 => v21(look, logs),
    }
}

/// First and last depth.
fn ends(log: &Log) -> Option<[f64; 2]> {
    Some([*log.bit_depths_m.first()?, *log.bit_depths_m.last()?])
}

fn v1411(look: &Look, logs: &[Log]) -> io::Result<String> {
    let well = uid(&look.name);
    let length = look.uom(Dimension::Length);
    let mut xml = Xml::new()?;
    xml.open_series_1("logs")?;
    for (place, log) in logs.iter().enumerate() {
        let uid = (place + 1).to_string();
        xml.open("log", &[("uidWell", &well), ("uidWellbore", &well), ("uid", &uid)])?;
        xml.leaf("nameWell", &[], &look.name)?;
        xml.leaf("nameWellbore", &[], &look.name)?;
        xml.leaf("name", &[], &log.name)?;
        xml.leaf("serviceCompany", &[], &look.program)?;
        xml.leaf("creationDate", &[], &look.created)?;
        xml.leaf("description", &[], "Computed, with the bit at each depth")?;
        xml.leaf("indexType", &[], "measured depth")?;
        if let Some([first_m, last_m]) = ends(log) {
            xml.quantity("startIndex", length, first_m)?;
            xml.quantity("endIndex", length, last_m)?;
        }
        xml.leaf("direction", &[], "increasing")?;
        xml.leaf("indexCurve", &[], INDEX)?;
        xml.leaf("nullValue", &[], NULL)?;
        let index = (INDEX, "measured depth of bit", INDEX_MEANING, length);
        let curves = log
            .curves
            .iter()
            .map(|curve| (curve.mnemonic, curve.class, curve.meaning, look.uom(curve.dimension)));
        let curves: Vec<_> = [index].into_iter().chain(curves).collect();
        for (mnemonic, class, meaning, uom) in &curves {
            xml.open("logCurveInfo", &[("uid", mnemonic)])?;
            xml.leaf("mnemonic", &[], mnemonic)?;
            xml.leaf("classWitsml", &[], class)?;
            xml.leaf("unit", &[], uom.symbol)?;
            if let Some([first_m, last_m]) = ends(log) {
                xml.quantity("minIndex", length, first_m)?;
                xml.quantity("maxIndex", length, last_m)?;
            }
            xml.leaf("curveDescription", &[], meaning)?;
            xml.leaf("typeLogData", &[], "double")?;
            xml.close("logCurveInfo")?;
        }
        xml.open("logData", &[])?;
        let listed = |texts: Vec<&str>| texts.join(",");
        xml.leaf("mnemonicList", &[], &listed(curves.iter().map(|curve| curve.0).collect()))?;
        xml.leaf("unitList", &[], &listed(curves.iter().map(|curve| curve.3.symbol).collect()))?;
        for (row, &depth_m) in log.bit_depths_m.iter().enumerate() {
            let values = log.curves.iter().map(|curve| {
                shown(look.uom(curve.dimension), curve.values.get(row).copied().flatten())
                    .unwrap_or_else(|| NULL.to_owned())
            });
            let depth = shown(length, Some(depth_m)).unwrap_or_else(|| NULL.to_owned());
            let cells: Vec<String> = [depth].into_iter().chain(values).collect();
            xml.leaf("data", &[], &cells.join(","))?;
        }
        xml.close("logData")?;
        xml.close("log")?;
    }
    xml.close("logs")?;
    xml.finish()
}

fn v20(look: &Look, logs: &[Log]) -> io::Result<String> {
    let length = look.uom(Dimension::Length);
    let mut xml = Xml::new()?;
    xml.open_series_2("Log", look, TITLE, Version::V20)?;
    xml.leaf("TimeDepth", &[], "measured depth")?;
    xml.wellbore(look, Version::V20)?;
    for log in logs {
        let about =
            |kind: &str| uuid(&format!("{kind} {} {} {}", log.name, look.name, look.created));
        let set = [("schemaVersion", "2.0"), ("uuid", &about("ChannelSet"))];
        xml.open("ChannelSet", &set)?;
        xml.citation(look, &log.name)?;
        index(&mut xml, length, "IndexType")?;
        for curve in &log.curves {
            let channel = [("schemaVersion", "2.0"), ("uuid", &about(curve.mnemonic))];
            xml.open("Channel", &channel)?;
            xml.citation(look, curve.meaning)?;
            xml.leaf("Mnemonic", &[], curve.mnemonic)?;
            xml.leaf("DataType", &[], "double")?;
            xml.leaf("Uom", &[], look.uom(curve.dimension).symbol)?;
            xml.leaf("GrowingStatus", &[], "closed")?;
            xml.leaf("TimeDepth", &[], "measured depth")?;
            if let Some(ends) = ends(log) {
                for (name, depth_m) in ["StartIndex", "EndIndex"].into_iter().zip(ends) {
                    xml.open(name, &[("xsi:type", "DepthIndexValue")])?;
                    let depth = shown(length, Some(depth_m)).unwrap_or_default();
                    xml.leaf("Depth", &[], &depth)?;
                    xml.close(name)?;
                }
            }
            index(&mut xml, length, "IndexType")?;
            xml.close("Channel")?;
        }
        data(&mut xml, look, log)?;
        xml.close("ChannelSet")?;
    }
    xml.close("Log")?;
    xml.finish()
}

fn v21(look: &Look, logs: &[Log]) -> io::Result<String> {
    let length = look.uom(Dimension::Length);
    let mut xml = Xml::new()?;
    xml.open_series_2("Log", look, TITLE, Version::V21)?;
    xml.inactive()?;
    for log in logs {
        let about =
            |kind: &str| uuid(&format!("{kind} {} {} {}", log.name, look.name, look.created));
        let version = ("schemaVersion", Version::V21.number());
        xml.open("ChannelSet", &[version, ("uuid", &about("ChannelSet"))])?;
        xml.citation(look, &log.name)?;
        xml.inactive()?;
        index(&mut xml, length, "IndexKind")?;
        for curve in &log.curves {
            xml.open("Channel", &[version, ("uuid", &about(curve.mnemonic))])?;
            xml.citation(look, curve.meaning)?;
            xml.inactive()?;
            xml.leaf("Mnemonic", &[], curve.mnemonic)?;
            xml.leaf("GlobalMnemonic", &[], curve.mnemonic)?;
            xml.leaf("DataKind", &[], "double")?;
            xml.leaf("Uom", &[], look.uom(curve.dimension).symbol)?;
            xml.reference("ChannelPropertyKind", "eml23.PropertyKind", curve.class)?;
            xml.reference("LoggingCompany", "eml23.BusinessAssociate", &look.program)?;
            xml.leaf("Derivation", &[], "simulated")?;
            index(&mut xml, length, "IndexKind")?;
            xml.close("Channel")?;
        }
        data(&mut xml, look, log)?;
        xml.close("ChannelSet")?;
    }
    xml.wellbore(look, Version::V21)?;
    xml.close("Log")?;
    xml.finish()
}

/// The rows of a set of channels.
fn data(xml: &mut Xml, look: &Look, log: &Log) -> io::Result<()> {
    let text = |number: Option<String>| number.unwrap_or_else(|| "null".to_owned());
    let rows = log.bit_depths_m.iter().enumerate().map(|(row, &depth_m)| {
        let values = log.curves.iter().map(|curve| {
            let value = curve.values.get(row).copied().flatten();
            text(shown(look.uom(curve.dimension), value))
        });
        let values: Vec<String> = values.collect();
        let depth = text(shown(look.uom(Dimension::Length), Some(depth_m)));
        format!("[[{depth}],[{}]]", values.join(","))
    });
    xml.open("Data", &[])?;
    xml.leaf("Data", &[], &format!("[{}]", rows.collect::<Vec<_>>().join(",")))?;
    xml.close("Data")
}

/// Index of a set of channels; its kind has different names in the versions.
fn index(xml: &mut Xml, length: Uom, kind: &str) -> io::Result<()> {
    xml.open("Index", &[])?;
    xml.leaf(kind, &[], "measured depth")?;
    xml.leaf("Uom", &[], length.symbol)?;
    xml.leaf("Direction", &[], "increasing")?;
    xml.leaf("Mnemonic", &[], INDEX)?;
    xml.close("Index")
}

fn shown(uom: Uom, si: Option<f64>) -> Option<String> {
    number(uom.of(si?))
}

// A log against bit depth.

/// Curves against the measured depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// Its name: `trip out, soft string, expected friction`.
    pub name: String,
    /// Measured depths of the bit, m, ascending.
    pub bit_depths_m: Vec<f64>,
    /// Results at each depth.
    pub curves: Vec<Curve>,
}

/// A curve of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its short name: `HKLD`.
    pub mnemonic: &'static str,
    /// Its class in WITSML 1.4.1.1: `hookload (average)`.
    pub class: &'static str,
    /// Its meaning, in a sentence.
    pub meaning: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Its values, SI; none if there is no result.
    pub values: Vec<Option<f64>>,
}
