//! One comparison of a result with its limit.

use std::cmp::Ordering;

use serde::{Deserialize, Deserializer, Serialize};

use wholestring_units::UnitSet;

use crate::{CheckKind, Wording, strength::SurfaceStress};

/// Severity of a check. Worse ones are greater.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// The limit is met.
    Ok,
    /// Worth knowing when the result is read.
    Note,
    /// A limit is not met by the required factor, the string buckles, or a number is less certain
    /// than it looks.
    Warning,
    /// The operation cannot be carried out, or the result must not be used.
    Error,
}

impl Severity {
    /// Every severity, in increasing order.
    pub const ALL: [Self; 4] = [Self::Ok, Self::Note, Self::Warning, Self::Error];

    /// Name in results and on the screen.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// The verdict of a check in words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Verdict {
    /// The factor is met.
    #[serde(rename = "OK", alias = "kept")]
    Ok,
    /// The factor is met by less than a tenth.
    #[serde(rename = "marginal", alias = "near")]
    Marginal,
    /// The load is less than the capacity, but not by the required factor.
    #[serde(rename = "below required factor", alias = "short")]
    BelowRequired,
    /// The load is larger than the capacity.
    #[serde(rename = "exceeded", alias = "passed")]
    Exceeded,
    /// No limit, but a state that is reported as a note.
    #[serde(rename = "note")]
    Note,
    /// No limit, but a state that is warned of.
    #[serde(rename = "warning")]
    Warning,
    /// No limit, but a state that forbids the operation or its result.
    #[serde(rename = "error")]
    Error,
}

impl Verdict {
    /// The word shown to users.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Ok => "OK",
            Self::Marginal => "marginal",
            Self::BelowRequired => "below required factor",
            Self::Exceeded => "exceeded",
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }

    const fn of_severity(severity: Severity) -> Self {
        match severity {
            Severity::Ok => Self::Ok,
            Severity::Note => Self::Note,
            Severity::Warning => Self::Warning,
            Severity::Error => Self::Error,
        }
    }
}

/// A factor that is less than this above the required one is marginal.
pub(crate) const MARGINAL: f64 = 1.1;

/// The same of tension: beyond 80 % of the yield, where 90 % is allowed (API RP 7G).
const MARGINAL_TENSION: f64 = 0.9 / 0.8;

/// One comparison of a result with its limit, in SI units, and its verdict.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct Check {
    /// Quantity that is compared, or state that is reported: `lock_up`, `top_drive`, `von_mises`.
    pub kind: CheckKind,
    /// Its severity: `ok`, `note`, `warning` or `error`.
    pub severity: Severity,
    /// The verdict in words: `OK`, `marginal`, `below required factor`, `exceeded`; the severity
    /// where there is no limit.
    #[cfg_attr(feature = "openapi", schema(value_type = String))]
    pub verdict: Verdict,
    /// The component; none for the rig and for the whole string.
    pub component: Option<String>,
    /// Measured depth of the place, or of the upper end of its interval, m; none without a place.
    pub md_m: Option<f64>,
    /// Measured depth of the lower end of its interval, m; none for a point and without a place.
    pub to_md_m: Option<f64>,
    /// The value, for a limit the load, in `unit`; none where it is not a number.
    pub value: Option<f64>,
    /// Number that the value is compared with, for a limit the capacity; none where there is no
    /// such number.
    pub limit: Option<f64>,
    /// Capacity over load; none for a kind that is not a limit.
    pub factor: Option<f64>,
    /// The required factor; none for a kind that is not a limit.
    pub required: Option<f64>,
    /// SI unit of value and limit; empty for a ratio.
    pub unit: String,
    /// The check as a sentence in the user's units.
    pub sentence: String,
    /// The sentence with its quantities, from which it is rendered in other units; empty in files
    /// of earlier versions and where no quantity is in it.
    #[serde(rename = "parts")]
    #[cfg_attr(feature = "openapi", schema(value_type = Vec<Value>))]
    pub wording: Wording,
    /// The point of the body and its stresses, for a von Mises stress; not written.
    #[serde(skip)]
    pub stress: Option<SurfaceStress>,
}

/// A check as stored in a file. Files of earlier versions store a finding (`level`, `message`) or a
/// limit (`load`, `capacity`, `standing`).
#[derive(Deserialize)]
struct Stored {
    kind: CheckKind,
    #[serde(default, alias = "level")]
    severity: Option<Severity>,
    #[serde(default, alias = "standing")]
    verdict: Option<Verdict>,
    #[serde(default)]
    component: Option<String>,
    #[serde(default)]
    md_m: Option<f64>,
    #[serde(default)]
    to_md_m: Option<f64>,
    #[serde(default, alias = "load")]
    value: Option<f64>,
    #[serde(default, alias = "capacity")]
    limit: Option<f64>,
    #[serde(default)]
    factor: Option<f64>,
    #[serde(default)]
    required: Option<f64>,
    #[serde(default)]
    unit: String,
    #[serde(default, alias = "message")]
    sentence: String,
    #[serde(default, rename = "parts")]
    wording: Wording,
}

/// A check as stored in a checkpoint: the fields of [`Check`] in their order, without names.
#[derive(Deserialize)]
struct Packed {
    kind: CheckKind,
    severity: Severity,
    verdict: Verdict,
    component: Option<String>,
    md_m: Option<f64>,
    to_md_m: Option<f64>,
    value: Option<f64>,
    limit: Option<f64>,
    factor: Option<f64>,
    required: Option<f64>,
    unit: String,
    sentence: String,
    wording: Wording,
}

impl<'de> Deserialize<'de> for Check {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        if deserializer.is_human_readable() {
            return Stored::deserialize(deserializer).map(Self::from);
        }
        let packed = Packed::deserialize(deserializer)?;
        Ok(Self {
            kind: packed.kind,
            severity: packed.severity,
            verdict: packed.verdict,
            component: packed.component,
            md_m: packed.md_m,
            to_md_m: packed.to_md_m,
            value: packed.value,
            limit: packed.limit,
            factor: packed.factor,
            required: packed.required,
            unit: packed.unit,
            sentence: packed.sentence,
            wording: packed.wording,
            stress: None,
        })
    }
}

impl From<Stored> for Check {
    fn from(stored: Stored) -> Self {
        let severity = stored.severity.unwrap_or(match stored.verdict {
            Some(Verdict::Ok) | None => Severity::Ok,
            Some(Verdict::Marginal | Verdict::Note) => Severity::Note,
            Some(Verdict::BelowRequired | Verdict::Warning) => Severity::Warning,
            Some(Verdict::Exceeded | Verdict::Error) => Severity::Error,
        });
        Self {
            kind: stored.kind,
            severity,
            verdict: stored.verdict.unwrap_or(Verdict::of_severity(severity)),
            component: stored.component,
            md_m: stored.md_m,
            to_md_m: stored.to_md_m,
            value: stored.value,
            limit: stored.limit,
            factor: stored.factor,
            required: stored.required,
            unit: stored.unit,
            sentence: stored.sentence,
            wording: stored.wording,
            stress: None,
        }
    }
}

impl Check {
    /// A state that is reported, without place or number.
    pub(crate) fn reported(kind: CheckKind, severity: Severity) -> Self {
        Self {
            kind,
            severity,
            verdict: Verdict::of_severity(severity),
            component: None,
            md_m: None,
            to_md_m: None,
            value: None,
            limit: None,
            factor: None,
            required: None,
            unit: kind.unit().to_owned(),
            sentence: String::new(),
            wording: Wording::default(),
            stress: None,
        }
    }

    /// A load compared with a capacity that must be larger by a factor; `None` where there is no
    /// load.
    pub(crate) fn load(kind: CheckKind, load: f64, capacity: f64, required: f64) -> Option<Self> {
        if load.is_nan() || load <= 0.0 || !capacity.is_finite() {
            return None;
        }
        let factor = capacity / load;
        let marginal = if kind == CheckKind::Tension { MARGINAL_TENSION } else { MARGINAL };
        let (verdict, severity) = match () {
            () if factor < 1.0 && kind == CheckKind::Overpull => {
                (Verdict::BelowRequired, Severity::Warning)
            }
            () if factor < 1.0 && kind.stops() => (Verdict::Exceeded, Severity::Error),
            () if factor < 1.0 => (Verdict::Exceeded, Severity::Warning),
            () if factor < required => (Verdict::BelowRequired, Severity::Warning),
            () if factor < marginal * required => (Verdict::Marginal, Severity::Note),
            () => (Verdict::Ok, Severity::Ok),
        };
        Some(Self {
            verdict,
            value: Some(load),
            limit: Some(capacity),
            factor: Some(factor),
            required: Some(required),
            ..Self::reported(kind, severity)
        })
    }

    /// A state that is reported on reading or fitting, with its sentence, in which quantities are
    /// marked ([`Quantity`](crate::Quantity)); it is in SI units until [`Self::in_units`].
    pub fn of_readings(
        kind: CheckKind,
        severity: Severity,
        [value, limit]: [Option<f64>; 2],
        sentence: String,
    ) -> Self {
        Self { value, limit, ..Self::reported(kind, severity) }.worded(sentence)
    }

    /// The same with a sentence in which quantities are marked.
    pub(crate) fn worded(self, sentence: String) -> Self {
        let wording = Wording::from(sentence);
        match wording.is_plain() {
            true => Self { sentence: wording.to_string(), wording: Wording::default(), ..self },
            false => Self { sentence: wording.in_units(UnitSet::Si), wording, ..self },
        }
    }

    /// The same with a further text after its sentence.
    pub(crate) fn continued(self, more: &str) -> Self {
        let text = match self.wording.is_empty() {
            true => self.sentence.clone(),
            false => self.wording.to_string(),
        };
        self.worded(text + more)
    }

    /// The sentence in these units; that of the file for a check of an earlier version.
    pub fn sentence_in(&self, units: UnitSet) -> String {
        match self.wording.is_empty() {
            true => self.sentence.clone(),
            false => self.wording.in_units(units),
        }
    }

    /// The same with its sentence in these units.
    #[must_use]
    pub fn in_units(self, units: UnitSet) -> Self {
        Self { sentence: self.sentence_in(units), ..self }
    }

    /// The same with its number.
    pub(crate) fn value(self, value: f64) -> Self {
        Self { value: Some(value), ..self }
    }

    /// The same with the number that the value is compared with.
    pub(crate) fn limit(self, limit: f64) -> Self {
        Self { limit: Some(limit), ..self }
    }

    /// The same at a measured depth, m.
    pub(crate) fn at(self, md_m: f64) -> Self {
        Self { md_m: Some(md_m.max(0.0)), ..self }
    }

    /// The same over an interval of measured depth, m.
    pub(crate) fn over(self, [from_md_m, to_md_m]: [f64; 2]) -> Self {
        Self { md_m: Some(from_md_m.max(0.0)), to_md_m: Some(to_md_m.max(0.0)), ..self }
    }

    /// The same of a component.
    pub(crate) fn of_component(self, name: &str) -> Self {
        Self { component: Some(name.to_owned()), ..self }
    }

    /// The same with its severity limited to `most`. The verdict in words is unchanged: an exceeded
    /// limit is exceeded, for however short a time.
    pub(crate) fn at_most(self, most: Severity) -> Self {
        Self { severity: self.severity.min(most), ..self }
    }

    /// Factor over the required one, by which the load may still grow; less than one where the
    /// required factor is not met. Infinite for a kind that is not a limit.
    pub fn reserve(&self) -> f64 {
        match (self.factor, self.required) {
            (Some(factor), Some(required)) => factor / required,
            _ => f64::INFINITY,
        }
    }

    /// Order of severity among checks of one kind: severity, then the lower reserve, then the value
    /// that is farther on the wrong side of the number that it is compared with.
    pub fn cmp_severity(&self, other: &Self) -> Ordering {
        let excess = |check: &Self| {
            let excess = check.value.unwrap_or(0.0) - check.limit.unwrap_or(0.0);
            if check.kind.is_worse_below() { -excess } else { excess }
        };
        let reserve = other.reserve().total_cmp(&self.reserve());
        let severity = self.severity.cmp(&other.severity).then(reserve);
        severity.then_with(|| excess(self).total_cmp(&excess(other)))
    }

    /// Whether it needs no attention: a limit that is met.
    pub fn is_ok(&self) -> bool {
        self.severity == Severity::Ok
    }
}
