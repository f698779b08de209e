//! Hook load and torque against bit depth.

use std::path::Path;

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_export::{Curve, Log};
use wholestring_results::{Data, PlanSummary, Summary};
use wholestring_units::Dimension;

use crate::{error::Error, results_kinds::kind_of, sweep};

/// Loads at one bit depth.
#[derive(Debug, Clone, Copy)]
struct Point {
    bit_depth_m: f64,
    hook_load_N: Option<f64>,
    torque_N_m: Option<f64>,
    weight_on_bit_N: Option<f64>,
}

/// The logs of a folder: one for each combination of model, operation and other varied keys.
pub(super) fn of_folder(folder: &Path, notes: &mut Vec<String>) -> Result<Vec<Log>, Error> {
    let kind = kind_of(folder)?;
    let points = match kind.noun {
        "a plan" => plan(folder)?,
        "a run" => run(folder)?,
        "a sweep" => swept(folder)?,
        noun => {
            return Err(Error::bad_input(format!(
                "{} holds {noun}, which has no hook load and torque against the depth of the bit; a \
                 plan, a run or a sweep has",
                folder.display()
            )));
        }
    };
    let mut grouped: Vec<(String, Vec<Point>)> = Vec::new();
    for (name, point) in points {
        match grouped.iter_mut().find(|(grouped, _)| *grouped == name) {
            Some((_, points)) => points.push(point),
            None => grouped.push((name, vec![point])),
        }
    }
    if grouped.is_empty() {
        return Err(Error::bad_input(format!("nothing was solved in {}", folder.display())));
    }
    if grouped.iter().all(|(_, points)| points.len() == 1) {
        let noun = kind.noun;
        notes.push(format!(
            "each log has one row, because {noun} has one depth of the bit; a plan has many"
        ));
    }
    let count = grouped.len();
    notes.push(format!("{count} {}", if count == 1 { "log" } else { "logs" }));
    notes.push("the block's weight is not in the hook load".to_owned());
    Ok(grouped.into_iter().map(|(name, points)| log(name, points)).collect())
}

fn log(name: String, mut points: Vec<Point>) -> Log {
    points.sort_by(|a, b| a.bit_depth_m.total_cmp(&b.bit_depth_m));
    let curve = |mnemonic, class, meaning, dimension, point: fn(&Point) -> Option<f64>| Curve {
        mnemonic,
        class,
        meaning,
        dimension,
        values: points.iter().map(point).collect(),
    };
    Log {
        name,
        bit_depths_m: points.iter().map(|point| point.bit_depth_m).collect(),
        curves: vec![
            curve(
                "HKLD",
                "hookload (average)",
                "Tension at the top of the string; block and top drive excluded",
                Dimension::Force,
                |point| point.hook_load_N,
            ),
            curve(
                "TORQUE",
                "torque (average)",
                "Torque at the top of the string",
                Dimension::Torque,
                |point| point.torque_N_m,
            ),
            curve("WOB", "weight on bit (average)", "Weight on bit", Dimension::Force, |point| {
                point.weight_on_bit_N
            }),
        ],
    }
}

fn model_words(model: ModelKind) -> String {
    match model.in_time() {
        true => format!("{model} model"),
        false => format!("{model} string"),
    }
}

fn plan(folder: &Path) -> Result<Vec<(String, Point)>, Error> {
    let summary = PlanSummary::read(&folder.join("summary.json"))?;
    let points = summary.points.iter().map(|row| {
        let name =
            format!("{}, {}, {} friction", row.operation, model_words(row.model), row.friction);
        let scalars = row.scalars.as_ref();
        let point = Point {
            bit_depth_m: row.bit_depth_m,
            hook_load_N: scalars.map(|scalar| scalar.hook_load_N),
            torque_N_m: scalars.map(|scalar| scalar.surface_torque_N_m),
            weight_on_bit_N: scalars.map(|scalar| scalar.weight_on_bit_N),
        };
        (name, point)
    });
    Ok(points.collect())
}

fn run(folder: &Path) -> Result<Vec<(String, Point)>, Error> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    let points = summary.operations.iter().map(|operation| {
        let name = format!("{}, {}", operation.operation, model_words(operation.model));
        let point = Point {
            bit_depth_m: operation.bit_depth_m,
            hook_load_N: Some(operation.scalars.hook_load_N),
            torque_N_m: Some(operation.scalars.surface_torque_N_m),
            weight_on_bit_N: Some(operation.scalars.weight_on_bit_N),
        };
        (name, point)
    });
    Ok(points.collect())
}

/// The cases of a sweep; cases that differ only in bit depth form one log.
fn swept(folder: &Path) -> Result<Vec<(String, Point)>, Error> {
    let (varied, table) = sweep::read(folder)?;
    let number = |name: &str, row: usize| table.numbers(name).and_then(|number| number[row]);
    let word = |name: &str, row: usize| table.words(name).map_or("", |word| word[row].as_str());
    let unknown = |what: &str, name: &str| {
        Error::bad_input(format!("{}: '{name}' is no {what}", folder.join(sweep::FILE).display()))
    };
    let named = |row: usize| {
        let (operation, model) = (word("operation", row), word("model", row));
        let operation =
            OperationKind::from_name(operation).ok_or_else(|| unknown("operation", operation))?;
        Ok((operation, ModelKind::named(model).ok_or_else(|| unknown("model", model))?))
    };
    let rows = (0..table.rows()).filter_map(|row| {
        let bit_depth_m = number("bit_depth_m", row)?;
        let (operation, model) = match named(row) {
            Ok(named) => named,
            Err(error) => return Some(Err(error)),
        };
        let keys = table.columns()[..varied].iter();
        let keys = keys.filter(|column| !column.name.ends_with("bit_depth")).map(|column| {
            let value = match &column.data {
                Data::Number(values) => {
                    values[row].map_or(String::new(), |value| value.to_string())
                }
                Data::Text(words) => words[row].clone(),
            };
            format!("{} {value} {}", column.name, column.unit).trim_end().to_owned()
        });
        let whose = [operation.words().to_owned(), model_words(model)];
        let name = whose.into_iter().chain(keys).collect::<Vec<_>>().join(", ");
        let point = Point {
            bit_depth_m,
            hook_load_N: number("hook_load_N", row),
            torque_N_m: number("surface_torque_N_m", row),
            weight_on_bit_N: number("weight_on_bit_N", row),
        };
        Some(Ok((name, point)))
    });
    rows.collect()
}
