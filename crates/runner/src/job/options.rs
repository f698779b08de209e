//! Options as users write them, read with their units and checked.

use std::{num::NonZeroUsize, time::Duration};

use serde::{Deserialize, Deserializer};
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Override, Variation, operation_named, read_values};
use wholestring_units::Dimension;

use super::work::{BhaOptions, CalibrateOptions, ReachOptions, Varied};
use crate::{
    bha::Sweeps,
    calibrate::{CheckDynamics, Fit, option},
    error::Error,
    keep::Keep,
    shard::Shard,
};

/// The error of an option's value.
pub(super) fn refused(name: &str, reason: impl std::fmt::Display) -> Error {
    Error::BadInput(format!("`{name}`: {reason}"))
}

/// Values of an option, SI; none if it is missing or empty.
fn values(
    name: &str,
    text: Option<&String>,
    dimension: Dimension,
) -> Result<Option<Vec<f64>>, Error> {
    let text = text.map(|text| text.trim()).filter(|text| !text.is_empty());
    Ok(text.map(|text| read_values(name, text, dimension)).transpose()?)
}

/// The single value of an option, SI; none if it is missing.
fn value(name: &str, text: Option<&String>, dimension: Dimension) -> Result<Option<f64>, Error> {
    match values(name, text, dimension)?.as_deref() {
        None => Ok(None),
        Some([value]) => Ok(Some(*value)),
        Some(values) => Err(refused(name, format!("{} values; expected one", values.len()))),
    }
}

/// Wall-clock time between checkpoints.
pub(super) fn checkpoint_interval(text: Option<&String>) -> Result<Option<Duration>, Error> {
    let Some(text) = text else { return Ok(None) };
    let seconds = Dimension::Time.parse(text).map_err(|error| refused("checkpoint", error))?;
    if !(0.01..=86_400.0).contains(&seconds) {
        return Err(refused("checkpoint", format!("`{text}`: expected 0.01 s to 86400 s")));
    }
    Ok(Some(Duration::from_secs_f64(seconds)))
}

/// A share of many cases; all of them by default.
pub(super) fn shard(text: Option<&String>) -> Result<Shard, Error> {
    let shard = text.map(|text| text.parse().map_err(|reason| refused("shard", reason)));
    Ok(shard.transpose()?.unwrap_or_default())
}

/// The varied keys of a sweep, at least one.
pub(super) fn variations(vary: &[Varied]) -> Result<Vec<Variation>, Error> {
    let text = |varied: &Varied| match varied {
        Varied::Text(text) => Some(text.clone()),
        Varied::List { .. } => None,
    };
    let texts: Vec<String> = vary.iter().filter_map(text).collect();
    let mut of_texts = Variation::read_all(&texts)?.into_iter();
    let all = vary.iter().filter_map(|varied| match varied {
        Varied::Text(_) => of_texts.next(),
        Varied::List { key, values } => Some(Variation::of_values(key, values)),
    });
    let all: Vec<Variation> = all.collect();
    if all.is_empty() {
        let reason = "nothing is varied: give a key with its values";
        return Err(Error::BadInput(reason.to_owned()));
    }
    for (index, variation) in all.iter().enumerate() {
        if all[..index].iter().any(|other| other.key == variation.key) {
            return Err(refused("vary", format!("`{}` is varied twice", variation.key)));
        }
    }
    Ok(all)
}

/// The depths of a reach, first and last, m.
pub(super) fn depths(options: &ReachOptions) -> Result<[Option<f64>; 2], Error> {
    let depth = |name: &str, text: &Option<String>| value(name, text.as_ref(), Dimension::Length);
    Ok([depth("from", &options.from)?, depth("to", &options.to)?])
}

/// The variations of a static BHA analysis.
pub(super) fn sweeps(options: &BhaOptions) -> Result<Sweeps, Error> {
    let build = value("build", options.build.as_ref(), Dimension::DoglegSeverity)?;
    Ok(Sweeps {
        toolfaces_rad: values("toolface", options.toolface.as_ref(), Dimension::Angle)?,
        weights_N: values("weight", options.weight.as_ref(), Dimension::Force)?,
        inclinations_rad: values("inclination", options.inclination.as_ref(), Dimension::Angle)?,
        build_rate_rad_per_m: build.unwrap_or(0.0),
    })
}

/// Standard errors beyond which a residual is an outlier, and confidence of the bands in per cent,
/// where a calibration gives none.
const OUTLIER: &str = "3";
const BAND: &str = "90";

/// The parameters that a calibration fits.
pub(super) fn fit(options: &CalibrateOptions) -> Result<Fit, Error> {
    type Parse = fn(&str) -> Result<f64, String>;
    let read = |name: &str, text: &str, parse: Parse| {
        parse(text).map_err(|reason| refused(name, format!("`{text}`: {reason}")))
    };
    let error = |name: &str, text: &Option<String>, parse: Parse| {
        text.as_ref().map(|text| read(name, text, parse)).transpose()
    };
    let hold = options.hold.iter().map(|text| {
        option::held(text).map_err(|reason| refused("hold", format!("`{text}`: {reason}")))
    });
    let model = options.model.unwrap_or(ModelKind::Soft);
    if ModelKind::any_in_time(&[model]) {
        let reason = format!("`{model}` makes no predictions: expected soft or stiff");
        return Err(refused("model", reason));
    }
    if options.one_factor && options.by_section {
        let reason = "`one_factor` and `by_section` exclude each other".to_owned();
        return Err(Error::BadInput(reason));
    }
    Ok(Fit {
        one_factor: options.one_factor,
        by_section: options.by_section,
        friction_around: options.friction_around,
        block_weight: options.block_weight,
        bit_torque: options.bit_torque,
        hold: hold.collect::<Result<_, _>>()?,
        errors: [
            error("weight_error", &options.weight_error, option::force)?,
            error("rotating_error", &options.rotating_error, option::force)?,
            error("torque_error", &options.torque_error, option::torque)?,
        ],
        outlier_beyond: read(
            "outlier",
            options.outlier.as_deref().unwrap_or(OUTLIER),
            option::beyond,
        )?,
        without_outliers: options.without_outliers,
        band_confidence: read("band", options.band.as_deref().unwrap_or(BAND), option::confidence)?,
        model,
    })
}

/// The dynamic check of a calibration, if it is requested.
pub(super) fn dynamic_check(
    options: &CalibrateOptions,
    jobs: Option<NonZeroUsize>,
) -> Result<Option<CheckDynamics>, Error> {
    if !options.check_dynamics {
        if !options.check_depths.is_empty() {
            return Err(refused("check_depths", "they need `check_dynamics`"));
        }
        return Ok(None);
    }
    let depth = |text: &String| {
        option::depth(text).map_err(|reason| refused("check_depths", format!("`{text}`: {reason}")))
    };
    let bit_depths_m = options.check_depths.iter().map(depth).collect::<Result<_, _>>()?;
    Ok(Some(CheckDynamics { bit_depths_m, jobs }))
}

/// The operation with a name, or with a driller's word for it.
///
/// # Errors
/// No operation has this name.
pub fn operation(name: &str) -> Result<OperationKind, String> {
    operation_named(name).ok_or_else(|| {
        let names = OperationKind::ALL.map(OperationKind::name).join(", ");
        format!("`{name}` is no operation: expected one of {names}")
    })
}

pub(super) fn one_operation<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<Option<OperationKind>, D::Error> {
    let name = Option::<String>::deserialize(from)?.filter(|name| !name.trim().is_empty());
    name.map(|name| operation(&name).map_err(in_option("operation"))).transpose()
}

pub(super) fn operations<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<Vec<OperationKind>, D::Error> {
    let names = Vec::<String>::deserialize(from)?;
    names.iter().map(|name| operation(name).map_err(in_option("operation"))).collect()
}

pub(super) fn kept<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Keep>, D::Error> {
    let name = Option::<String>::deserialize(from)?;
    name.map(|name| {
        let refused = || format!("`{name}`: expected \"summary\", \"tables\" or \"all\"");
        Keep::named(&name).ok_or_else(refused).map_err(in_option("keep"))
    })
    .transpose()
}

/// Error of the value of an option, with its name.
fn in_option<R: std::fmt::Display, E: serde::de::Error>(name: &str) -> impl Fn(R) -> E {
    move |reason| E::custom(format!("`{name}`: {reason}"))
}

/// Unit sets by name.
pub(super) mod unit_set {
    use serde::{Deserialize, Deserializer, Serializer};
    use wholestring_units::UnitSet;

    use super::in_option;

    pub(in super::super) fn serialize<S: Serializer>(
        units: &Option<UnitSet>,
        to: S,
    ) -> Result<S::Ok, S::Error> {
        match units {
            Some(units) => to.serialize_some(units.name()),
            None => to.serialize_none(),
        }
    }

    pub(in super::super) fn deserialize<'de, D: Deserializer<'de>>(
        from: D,
    ) -> Result<Option<UnitSet>, D::Error> {
        let name = Option::<String>::deserialize(from)?;
        name.map(|name| name.parse().map_err(in_option("units"))).transpose()
    }
}

/// Changes as an object of texts by key, in the order of the object.
pub(super) mod changes {
    use std::fmt;

    use serde::{
        Deserializer, Serializer,
        de::{Error as _, MapAccess, Visitor},
        ser::SerializeMap,
    };

    use super::Override;

    pub(in super::super) fn serialize<S: Serializer>(
        changes: &[Override],
        to: S,
    ) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(Some(changes.len()))?;
        for change in changes {
            map.serialize_entry(&change.key, &change.value)?;
        }
        map.end()
    }

    pub(in super::super) fn deserialize<'de, D: Deserializer<'de>>(
        from: D,
    ) -> Result<Vec<Override>, D::Error> {
        from.deserialize_map(Pairs)
    }

    struct Pairs;

    impl<'de> Visitor<'de> for Pairs {
        type Value = Vec<Override>;

        fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(to, "an object of texts by key")
        }

        fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<Self::Value, M::Error> {
            let mut changes = Vec::new();
            while let Some((key, value)) = map.next_entry::<String, String>()? {
                changes.push(format!("{key}={value}").parse().map_err(M::Error::custom)?);
            }
            Ok(changes)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Job, Work};

    fn varied(vary: &str) -> Result<Vec<Variation>, Error> {
        let text = format!(r#"{{"work": {{"kind": "sweep", "vary": {vary}}}}}"#);
        let job: Job = serde_json::from_str(&text).map_err(Error::bad_input)?;
        let Work::Sweep(options) = &job.work else { unreachable!("it is a sweep") };
        variations(&options.vary)
    }

    /// The values of a job are texts or lists in any order, and equal values of a list are kept.
    #[test]
    fn values_of_a_job_are_texts_or_lists() {
        let all = varied(
            r#"["rpm=60,70", {"key": "friction", "values": ["0.2", "0.2"]}, "wob=1kN..3kN/1kN"]"#,
        );
        let all = all.expect("variations");
        let values = |variation: &Variation| -> Vec<String> {
            variation.values.iter().map(|value| value.value.clone()).collect()
        };
        let all: Vec<_> = all.iter().map(|one| (one.key.as_str(), values(one).join(" "))).collect();
        let expected = [("rpm", "60 70"), ("friction", "0.2 0.2"), ("wob", "1kN 2kN 3kN")];
        assert_eq!(all, expected.map(|(key, values)| (key, values.to_owned())));
    }

    #[test]
    fn values_without_a_key_and_of_a_key_twice_are_refused() {
        let list = r#"{"key": "rpm", "values": ["60"]}"#;
        for (vary, reason) in [
            ("[]".to_owned(), "nothing is varied"),
            (format!(r#"["rpm=70", {list}]"#), "`vary`: `rpm` is varied twice"),
            ("[3]".to_owned(), "`vary`: expected a text such as friction=0.1,0.2"),
            (r#"[{"key": "rpm", "values": [], "step": 1}]"#.to_owned(), "`vary`: expected a text"),
        ] {
            let error = varied(&vary).expect_err(&vary).to_string();
            assert!(error.contains(reason), "{vary}: {error}");
        }
    }

    /// The options of cases are among those of the work, and no others are.
    #[test]
    fn an_unknown_option_of_a_sweep_is_refused() {
        let job = |option: &str| {
            let text = r#"{"work": {"kind": "sweep", "vary": ["rpm=60"], "keep": "all", OPTION}}"#;
            serde_json::from_str::<Job>(&text.replace("OPTION", option))
        };
        let known = job(r#""csv": true"#).expect("a job");
        let Work::Sweep(options) = &known.work else { unreachable!("it is a sweep") };
        assert_eq!((options.cases.keep, options.cases.csv), (Some(Keep::All), true));
        let unknown = job(r#""cvs": true"#).expect_err("an unknown option");
        assert!(unknown.to_string().contains("unknown field `cvs`"), "{unknown}");
        let written = serde_json::to_value(&known.work).expect("JSON");
        assert_eq!((&written["kind"], &written["keep"]), (&"sweep".into(), &"all".into()));
    }
}
