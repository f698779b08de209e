//! Curves of linear vibration, grouped from the columns of its tables.

use wholestring_results::Table;

/// The shape of a mode along the string, from the top down.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ModeShape {
    /// `lateral`, `axial` or `torsional`.
    pub(super) family: String,
    /// Number within the family, from 1.
    pub(super) number: usize,
    /// Measured depths, m.
    pub(super) md_m: Vec<f64>,
    /// Displacement towards the high side and to the right of it, and both a quarter of a period
    /// later, m.
    pub(super) across_m: [Vec<f64>; 4],
    /// Axial displacement, m.
    pub(super) along_m: Vec<f64>,
    /// Turn about the axis, rad.
    pub(super) turn_rad: Vec<f64>,
}

/// A natural frequency against rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ModeBranch {
    /// `lateral`, `axial` or `torsional`.
    pub(super) family: String,
    /// Number within the family, from 1.
    pub(super) number: usize,
    /// Direction of its whirl; empty for families that are not lateral.
    pub(super) whirl: String,
    /// Rotary speeds, rad/s.
    pub(super) rotary_rad_per_s: Vec<f64>,
    /// Natural frequency at each, Hz.
    pub(super) frequency_Hz: Vec<f64>,
}

/// Response of the string to its excitation, against rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AnswerCurve {
    /// Rotary speeds, rad/s.
    pub(super) rotary_rad_per_s: Vec<f64>,
    /// Largest displacement of a node, m.
    pub(super) amplitude_m: Vec<f64>,
    /// Largest bending stress that it adds, Pa.
    pub(super) bending_stress_Pa: Vec<f64>,
}

fn numbers(table: &Table, name: &str) -> Vec<f64> {
    let column = table.numbers(name).unwrap_or_default();
    column.iter().map(|value| value.unwrap_or(f64::NAN)).collect()
}

/// Ranges of consecutive rows with equal values in a text column and a numeric column.
fn stretches(table: &Table, words: &str, number: &str) -> Vec<std::ops::Range<usize>> {
    let (words, numbers) = (table.words(words).unwrap_or_default(), numbers(table, number));
    let mut found: Vec<std::ops::Range<usize>> = Vec::new();
    for row in 0..words.len().min(numbers.len()) {
        match found.last_mut() {
            Some(last)
                if words[last.start] == words[row] && numbers[last.start] == numbers[row] =>
            {
                last.end = row + 1;
            }
            _ => found.push(row..row + 1),
        }
    }
    found
}

/// Shapes of `mode_shapes.parquet`.
pub(super) fn shapes(table: &Table) -> Vec<ModeShape> {
    let family = table.words("family").unwrap_or_default();
    let column = |name| numbers(table, name);
    let (number, md_m, turn) = (column("number"), column("md_m"), column("turn_rad"));
    let across = ["high_m", "right_m", "high_later_m", "right_later_m"].map(column);
    let along = column("along_m");
    let shape = |rows: std::ops::Range<usize>| ModeShape {
        family: family[rows.start].clone(),
        number: number[rows.start] as usize,
        md_m: md_m[rows.clone()].to_vec(),
        across_m: across.each_ref().map(|column| column[rows.clone()].to_vec()),
        along_m: along[rows.clone()].to_vec(),
        turn_rad: turn[rows].to_vec(),
    };
    stretches(table, "family", "number").into_iter().map(shape).collect()
}

/// Branches of `campbell.parquet`.
pub(super) fn branches(table: &Table) -> Vec<ModeBranch> {
    let words = |name| table.words(name).unwrap_or_default();
    let (family, whirl) = (words("family"), words("whirl"));
    let (number, speed) = (numbers(table, "number"), numbers(table, "rotary_speed_rad_per_s"));
    let frequency = numbers(table, "frequency_Hz");
    let branch = |rows: std::ops::Range<usize>| ModeBranch {
        family: family[rows.start].clone(),
        number: number[rows.start] as usize,
        whirl: whirl[rows.start].clone(),
        rotary_rad_per_s: speed[rows.clone()].to_vec(),
        frequency_Hz: frequency[rows].to_vec(),
    };
    stretches(table, "family", "branch").into_iter().map(branch).collect()
}

/// Response curve of `response.parquet`.
pub(super) fn answer(table: &Table) -> AnswerCurve {
    AnswerCurve {
        rotary_rad_per_s: numbers(table, "rotary_speed_rad_per_s"),
        amplitude_m: numbers(table, "amplitude_m"),
        bending_stress_Pa: numbers(table, "bending_stress_Pa"),
    }
}
