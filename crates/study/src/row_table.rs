//! `[[table.row]]` of study files.

use wholestring::outcome::ModelKind;
use wholestring_case::rules::ModelRule;
use wholestring_config::prelude::*;

use crate::{
    chosen::{ChoosingKeys, Chosen, unheeded},
    column::{
        Amount, AmountRule, ColumnName, Quantity, SOURCES, Source, Statistic, StatisticRule,
        check_positive, check_summarised,
    },
    numbers::{Number, Row, Shape, Wanted},
    selection::{Selection, SelectionRule},
    sweep::Sweep,
    times_and_depths::{depth, time, two_times, window},
};

table! {
    /// One number: its definition, and the accepted values.
    RowTable in "[[table.row]]" {
        /// Its label.
        label: String = required(Text);
        /// Source of the given number.
        source: String = optional(Text);
        ..choosing: ChoosingKeys;
        /// Part of the results that contains it: "summary", "nodes" (along the string), "wear"
        /// (along the hole), "time" (scalars against time), "frames" (the whole string against
        /// time), "contact" (over depth and time) or "path" (the well).
        from: Source = default(SOURCES, Source::Summary);
        /// Column of that part; |tension_N| is the magnitude.
        column: String = required(Text);
        /// Statistic of the values: "mean", "std", "mean+std", "min", "max" or a percentile such as
        /// "p98"; for a summary over the window of a dynamic model, for "time" and for "frames" at
        /// a depth over time, for "contact" over all selected values, otherwise along the string.
        statistic: Statistic = default(StatisticRule, Statistic::Mean);
        /// The value at the node that is nearest to this measured depth; for contact force and
        /// friction in "frames", at the node within 5 m with the largest action of the wall.
        depth: f64 = optional(depth());
        /// The value at the sample or frame that is nearest to this time.
        time: f64 = optional(time());
        /// First and last time of "time", "frames" and "contact". Default: the window of the case,
        /// after it has settled.
        window: Vec<Spanned<f64>> = optional(two_times());
        /// Subtracts the same number of another case, which differs in these keys.
        less: Selection = optional(SelectionRule);
        /// Divides by the same number of another case, which differs in these keys.
        over: Selection = optional(SelectionRule);
        /// Divides by the same number of this model in the same case.
        over_model: ModelKind = optional(ModelRule);
        /// Key whose values give a row of numbers, of which `shape` is reported.
        along: String = optional(Text);
        /// Property of the numbers along a key: "linearity" (share of their variance that a
        /// straight line explains), "growth" (share of the steps from one to the next that
        /// increase), "least" or "most" (the smallest and largest of them).
        shape: Shape = optional(SHAPES);
        /// The given number.
        expected: Amount = optional(AmountRule);
        /// Permitted difference of the computed number from it: "8 %", or a quantity.
        tolerance: Amount = optional(AmountRule);
        /// Smallest accepted number.
        at_least: Amount = optional(AmountRule);
        /// Largest accepted number.
        at_most: Amount = optional(AmountRule);
    }
}

const SHAPES: Choice<Shape> = Choice {
    noun: "a shape",
    words: &[
        ("linearity", Shape::Linearity),
        ("growth", Shape::Growth),
        ("least", Shape::Least),
        ("most", Shape::Most),
    ],
};

impl RowTable {
    pub(crate) fn build(
        &self,
        at: Span,
        outer: &Chosen,
        sweeps: &[Sweep],
        columns: &[ColumnName],
        reader: &mut Reader,
    ) -> Option<Row> {
        let along = self.along(reader)?;
        let mut outer = outer.clone();
        if let Some((key, _)) = &along {
            // A selection of the table for this key would leave one number.
            outer.only = outer.only.without(key);
        }
        let chosen = self.choosing.within(&outer, sweeps, reader);
        let source = *self.from.get()?;
        let quantity = Quantity::named(self.column.at()?, source, columns, reader)?;
        let number = self.number(source, quantity, at, reader)?;
        let chosen = chosen?;
        for sweep in chosen.sweeps.iter().map(|index| &sweeps[*index]) {
            let along = along.as_ref().map(|(key, _)| key.as_str());
            self.check_case(sweep, &chosen.only, along, at, reader)?;
        }
        let [less, over] = [&self.less, &self.over].map(|field| field.optional());
        let other = |selection: Option<&Spanned<Selection>>, reader: &mut Reader| {
            let Some(selection) = selection else {
                return Some(None);
            };
            let other = chosen.only.narrowed(&selection.value);
            for sweep in chosen.sweeps.iter().map(|index| &sweeps[*index]) {
                selection.value.check(&sweep.name, &sweep.vary, reader)?;
                let along = along.as_ref().map(|(key, _)| key.as_str());
                self.check_case(sweep, &other, along, selection.place, reader)?;
            }
            Some(Some(selection.value.clone()))
        };
        let less = other(less?, reader)?;
        let over = other(over?, reader)?;
        let mut row = Row {
            label: self.label.get()?.clone(),
            source: self.source.text()?,
            chosen,
            number,
            less,
            over,
            over_model: self.over_model.optional()?.map(|model| model.value),
            along,
            wanted: Wanted::default(),
        };
        row.wanted = self.wanted(row.dimension(), reader)?;
        Some(row)
    }

    fn number(
        &self,
        source: Source,
        quantity: Quantity,
        at: Span,
        reader: &mut Reader,
    ) -> Option<Number> {
        let window_s = window(self.window.optional()?, reader)?;
        let (depth, time) = (self.depth.optional()?, self.time.optional()?);
        let statistic = self.statistic.at()?;
        let mut idle = |names: &[&'static str], why: &str| {
            let all = [
                ("depth", self.depth.place()),
                ("time", self.time.place()),
                ("window", self.window.place()),
                ("statistic", self.statistic.place()),
            ];
            let idle = all.into_iter().filter(|(name, _)| names.contains(name));
            unheeded(idle, why, reader);
        };
        match source {
            Source::Summary => {
                idle(&["depth", "time", "window"], "a summary has one number");
                check_summarised(statistic, reader)?;
            }
            Source::Nodes | Source::Wear | Source::Path => {
                idle(&["time", "window"], "this table has no times");
                if depth.is_some() {
                    idle(&["statistic"], "there is one value at a depth");
                }
            }
            Source::Time => {
                idle(&["depth"], "used with from = \"nodes\" or \"frames\"");
                if time.is_some() {
                    idle(&["statistic", "window"], "there is one value at a time");
                }
            }
            Source::Contact => {
                if time.is_some() {
                    idle(&["window"], "there is one row at a time");
                }
                if depth.is_some() && time.is_some() {
                    idle(&["statistic"], "there is one value at a depth and a time");
                }
            }
            Source::Frames => {
                if depth.is_none() && time.is_none() {
                    return Diagnostic::error("a number of frames needs `depth` or `time`")
                        .at(at, "neither is given")
                        .help(
                            "depth = \"600 m\" for a statistic over time, time = \"10 s\" \
                                   for one along the string",
                        )
                        .refuse(reader);
                }
                if time.is_some() {
                    idle(&["window"], "there is one frame at a time");
                }
                if depth.is_some() && time.is_some() {
                    idle(&["statistic"], "there is one value at a depth and a time");
                }
            }
        }
        Some(Number {
            quantity,
            statistic: statistic.value,
            depth_m: depth.map(|at| at.value),
            time_s: time.map(|at| at.value),
            window_s,
        })
    }

    fn along(&self, reader: &mut Reader) -> Option<Option<(String, Shape)>> {
        match (self.along.optional()?, self.shape.optional()?) {
            (None, None) => Some(None),
            (Some(key), Some(shape)) => Some(Some((key.value.clone(), shape.value))),
            (key, shape) => {
                let (missing, at) = match key {
                    Some(key) => ("shape", key.place),
                    None => ("along", shape.map_or(Span::default(), |shape| shape.place)),
                };
                Diagnostic::error(format!("`{missing}` is missing"))
                    .at(at, "`along` and `shape` go together")
                    .help("such as along = \"bit_depth\" and shape = \"linearity\"")
                    .refuse(reader)
            }
        }
    }

    /// A number belongs to one case, except along its key.
    fn check_case(
        &self,
        sweep: &Sweep,
        only: &Selection,
        along: Option<&str>,
        at: Span,
        reader: &mut Reader,
    ) -> Option<()> {
        if let (Some(along), Some(field)) = (along, self.along.given())
            && !sweep.keys().any(|key| key == along)
        {
            let message = format!("sweep `{}` does not vary `{}`", sweep.name, short(along));
            let keys: Vec<&str> = sweep.keys().collect();
            return Diagnostic::error(message)
                .at(field.place, "expected a key that it varies")
                .help(format!("keys that it varies: {}", keys.join(", ")))
                .refuse(reader);
        }
        for varied in &sweep.vary {
            if along == Some(varied.key.as_str()) {
                continue;
            }
            let mut left = varied.bare_values().filter(|value| only.has_value(&varied.key, value));
            if let (Some(first), Some(second)) = (left.next(), left.next()) {
                let key = &varied.key;
                let message = format!("`{key}` of sweep `{}` is open", sweep.name);
                return Diagnostic::error(message)
                    .at(at, format!("is it {first}, {second} or another?"))
                    .help(format!("select one, such as only = {{ {key} = \"{first}\" }}"))
                    .refuse(reader);
            }
        }
        Some(())
    }

    fn wanted(&self, dimension: Option<Dimension>, reader: &mut Reader) -> Option<Wanted> {
        let mut si = |amount: Option<&Spanned<Amount>>| match amount {
            None => Some(None),
            Some(at) => Amount::si(at, dimension, reader).map(Some),
        };
        let expected = si(self.expected.optional()?)?;
        let mut least = si(self.at_least.optional()?)?;
        let mut most = si(self.at_most.optional()?)?;
        if let (Some(lower), Some(upper), Some(at)) = (least, most, self.at_most.given())
            && lower > upper
        {
            return Diagnostic::error("no number is both `at_least` and `at_most`")
                .at(at.place, "it is less than `at_least`")
                .help("the two are the ends of an interval: the lesser is `at_least`")
                .refuse(reader);
        }
        if let Some(at) = self.tolerance.optional()? {
            let Some(expected) = expected else {
                unheeded([("tolerance", Some(at.place))], "used with `expected`", reader);
                return Some(Wanted { expected, least, most });
            };
            let within = match at.value.share() {
                Some(share) => share * expected.abs(),
                None => Amount::si(at, dimension, reader)?,
            };
            check_positive(at.value.share().unwrap_or(within), at, reader)?;
            least =
                Some(least.map_or(expected - within, |least: f64| least.max(expected - within)));
            most = Some(most.map_or(expected + within, |most: f64| most.min(expected + within)));
        }
        Some(Wanted { expected, least, most })
    }
}
