//! `[[figure]]` of study files.

use wholestring_config::prelude::*;

use crate::{
    abscissa::Abscissa,
    chosen::{ChoosingKeys, Chosen, unheeded},
    column::{
        Amount, AmountRule, ColumnName, Quantity, SOURCES, Source, Statistic, StatisticRule,
        check_summarised,
    },
    figure::{Figure, FigureData, Level, Pointing},
    file_name::FileName,
    sweep::Sweep,
    times_and_depths::{MAX, depths, times, two_times, window},
};

table! {
    /// Curves of the cases, and their data as CSV.
    FigureTable in "[[figure]]" {
        /// Its title.
        title: String = required(Text);
        /// Name of its files. Default: `figure-01` and so on.
        name: String = optional(FileName);
        /// Text below it on the page.
        caption: String = optional(Prose);
        ..choosing: ChoosingKeys;
        /// Part of the results that it is drawn from: "summary" (a number for each case), "nodes"
        /// (along the string), "wear" (along the hole), "time" (scalars against time), "frames"
        /// (the whole string against time, where the case records frames), "contact" (over depth
        /// and time, as a map for each case) or "path" (the well down to the bit).
        from: Source = default(SOURCES, Source::Summary);
        /// Quantity of the horizontal axis: a varied key for "summary", otherwise a column. All
        /// other varied keys make a curve for each of their values.
        x: String = required(Text);
        /// Direction of the axis of `x`: "across" the page, or "down" it, as for plots against
        /// depth placed side by side; `y` then points across. Not for "contact".
        x_axis: Pointing = default(POINTING, Pointing::Across);
        /// Columns on the vertical axis, all of one unit; |tension_N| is the magnitude. A depth
        /// points down.
        y: Vec<Spanned<String>> = required(List::or_one(Text, "columns", MAX));
        /// Column whose values give the colours of a map of "contact", over x = "time_s" and y =
        /// "md_m". A sign is a side of the hole, except for the magnitude |side_force_N_per_m|.
        colour: String = optional(Text);
        /// Statistics of a quantity that varies over the window of a dynamic model: "mean", "std",
        /// "mean+std", "min", "max", "p05" or "p95". For "summary". Default: the mean.
        statistic: Vec<Spanned<Statistic>> = optional(List::or_one(StatisticRule, "statistics", 7));
        /// Times of the frames to draw, one curve for each.
        times: Vec<Spanned<f64>> = optional(times());
        /// Measured depths of the nodes whose frames are drawn against time, a curve for each. The
        /// nearest node is used; for contact force and friction, the node within 5 m with the
        /// largest action of the wall.
        depths: Vec<Spanned<f64>> = optional(depths());
        /// First and last time to draw. For "time", "contact", and "frames" at depths. Default: the
        /// whole run.
        window: Vec<Spanned<f64>> = optional(two_times());
        /// Values of `y` to compare the curves with, or to mark on a map.
        level: Vec<Spanned<LevelTable>> = optional(List::tables::<LevelTable>(
            "levels ([[figure.level]])", MAX,
        ));
    }
}

table! {
    /// A value for comparison with the curves.
    LevelTable in "[[figure.level]]" {
        /// Its label.
        label: String = required(Text);
        /// The value, with the unit of `y`'s quantity; a bare number is SI.
        value: Amount = required(AmountRule);
    }
}

const POINTING: Choice<Pointing> = Choice {
    noun: "a direction of an axis",
    words: &[("across", Pointing::Across), ("down", Pointing::Down)],
};

impl FigureTable {
    pub(crate) fn build(
        &self,
        name: String,
        place: Span,
        sweeps: &[Sweep],
        columns: &[ColumnName],
        reader: &mut Reader,
    ) -> Option<Figure> {
        let chosen = self.choosing.within(&Chosen::all(sweeps), sweeps, reader);
        let source = *self.from.get()?;
        let y: Option<Vec<Quantity>> =
            self.y.get()?.iter().map(|at| Quantity::named(at, source, columns, reader)).collect();
        let y = y?;
        let at = self.y.at()?.place;
        let unit = |quantity: &Quantity| quantity.column.dimension;
        if y.iter().any(|other| unit(other) != unit(&y[0])) {
            return Diagnostic::error("the columns of one axis measure different things")
                .at(at, "expected columns of one unit")
                .refuse(reader);
        }
        let chosen = chosen?;
        let data = self.data(source, place, (&chosen, sweeps), columns, reader)?;
        let levels = self.level.optional()?.map_or(&[][..], |at| &at.value);
        Some(Figure {
            name,
            title: self.title.get()?.clone(),
            caption: self.caption.text()?,
            chosen,
            data,
            x_axis: *self.x_axis.get()?,
            levels: levels
                .iter()
                .map(|Spanned { value: table, .. }| {
                    Some(Level {
                        label: table.label.get()?.clone(),
                        value: Amount::si(table.value.at()?, unit(&y[0]), reader)?,
                    })
                })
                .collect::<Option<_>>()?,
            y,
        })
    }

    fn data(
        &self,
        source: Source,
        at: Span,
        (chosen, sweeps): (&Chosen, &[Sweep]),
        columns: &[ColumnName],
        reader: &mut Reader,
    ) -> Option<FigureData> {
        let window_s = window(self.window.optional()?, reader)?;
        let values = |list: Option<&Spanned<Vec<Spanned<f64>>>>| {
            list.map(|at| at.value.iter().map(|at| at.value).collect::<Vec<f64>>())
        };
        let times_s = values(self.times.optional()?);
        let depths_m = values(self.depths.optional()?);
        let statistics = self.statistic.optional()?;
        let x = self.x.at()?;
        let idle = |names: &[&'static str], why: &str, reader: &mut Reader| {
            let all = [
                ("statistic", self.statistic.place()),
                ("times", self.times.place()),
                ("depths", self.depths.place()),
                ("window", self.window.place()),
                ("colour", self.colour.place()),
                ("x_axis", self.x_axis.place()),
            ];
            let idle = all.into_iter().filter(|(name, _)| names.contains(name));
            unheeded(idle, why, reader);
        };
        if source != Source::Contact {
            idle(&["colour"], "used with from = \"contact\"", reader);
        }
        if source == Source::Summary {
            idle(&["times", "depths", "window"], "\"summary\" has a number for each case", reader);
            let statistics = match statistics {
                None => vec![Statistic::Mean],
                Some(at) => {
                    for statistic in &at.value {
                        check_summarised(statistic, reader)?;
                    }
                    at.value.iter().map(|at| at.value).collect()
                }
            };
            let x = Abscissa::named(x, chosen, sweeps, reader)?;
            return Some(FigureData::Summary { x, statistics });
        }
        idle(&["statistic"], "used with from = \"summary\"", reader);
        let x = Quantity::named(x, source, columns, reader)?;
        match source {
            Source::Frames => match (times_s, depths_m) {
                (Some(times_s), None) => {
                    idle(&["window"], "frames at `times` are drawn as they are", reader);
                    Some(FigureData::Times { x, times_s })
                }
                (None, Some(depths_m)) => Some(FigureData::Depths { x, depths_m, window_s }),
                (times, _) => {
                    let (message, label) = match times {
                        None => {
                            ("a figure of frames needs `times` or `depths`", "neither is given")
                        }
                        Some(_) => ("a figure of frames has `times` or `depths`", "both are given"),
                    };
                    let at = self.depths.given().map_or(at, |at| at.place);
                    Diagnostic::error(message)
                        .at(at, label)
                        .help(
                            "such as times = [\"1 s\", \"10 s\"] along the string, or \
                                   depths = \"600 m\" against time",
                        )
                        .refuse(reader)
                }
            },
            Source::Time => {
                idle(&["times", "depths"], "used with from = \"frames\"", reader);
                Some(FigureData::Rows { x, window_s })
            }
            Source::Contact => {
                idle(&["times", "depths"], "used with from = \"frames\"", reader);
                idle(&["x_axis"], "the depth of a map points down the page", reader);
                let colour = self.map_colour(at, columns, reader)?;
                Some(FigureData::Map { colour, window_s })
            }
            _ => {
                idle(&["times", "depths", "window"], "this table has no times", reader);
                Some(FigureData::Rows { x, window_s: None })
            }
        }
    }

    /// The colours of a map, whose axes are time and depth.
    fn map_colour(
        &self,
        at: Span,
        columns: &[ColumnName],
        reader: &mut Reader,
    ) -> Option<Quantity> {
        let [y] = &self.y.get()?[..] else {
            let message = "a map has one vertical axis";
            let at = self.y.at()?.place;
            return Diagnostic::error(message).at(at, "expected \"md_m\"").refuse(reader);
        };
        for (axis, column, expected) in [("x", self.x.at()?, "time_s"), ("y", y, "md_m")] {
            if column.value != expected {
                let message = format!("`{}` is not on `{axis}` of a map", short(&column.value));
                return Diagnostic::error(message)
                    .at(column.place, format!("expected \"{expected}\""))
                    .help(
                        "a map shows contact over time and depth; `colour` is the column \
                               that it shows",
                    )
                    .refuse(reader);
            }
        }
        let Some(colour) = self.colour.optional()? else {
            return Diagnostic::error("a map of contact needs `colour`")
                .at(at, "it is not given")
                .help("such as colour = \"side_force_N_per_m\" or \"contact_force_N_per_m\"")
                .refuse(reader);
        };
        Quantity::named(colour, Source::Contact, columns, reader)
    }
}
