//! The tables of the benchmark against other programs.

use std::fmt::Write as _;

use serde_json::Value;

use crate::command::Failure;

/// Table of each program's time for the same work, and whether its results agree. The others are
/// compared with the first.
pub(super) fn dynamics(measured: &[Value]) -> Result<String, Failure> {
    let per_second = |run: &Value| Ok(number(run, "cpu_s")? / number(run, "simulated_s")?);
    let ours = measured.first().ok_or_else(|| Failure::new("nothing was measured"))?;
    let ours = per_second(ours)?;
    let mut text = String::from(
        "| program | elements | step, µs | simulated, s | CPU s per simulated s | × real time | CPU, \
         wholestring's = 1 | hook load, kN | torque, kN·m |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    let mut notes = String::from("\n| program | its step | left out |\n|---|---|---|\n");
    for run in measured {
        let variant = word(run, "variant")?;
        let comma = if variant.is_empty() { "" } else { ", " };
        let version = word(run, "version")?;
        let name = format!("{} {version}{comma}{variant}", word(run, "program")?);
        let cpu = per_second(run)?;
        let _ = writeln!(
            text,
            "| {name} | {} | {:.0} | {:.0} | {} | {} | {} | {:.1} | {:.2} |",
            number(run, "elements")?,
            number(run, "step_s")? * 1e6,
            number(run, "simulated_s")?,
            digits(cpu),
            digits(1.0 / cpu),
            digits(cpu / ours),
            number(run, "hook_load_N")? / 1e3,
            number(run, "torque_N_m")? / 1e3,
        );
        let (tuned, left_out) = (word(run, "tuned")?, word(run, "leaves_out")?);
        let _ = writeln!(notes, "| {name} | {tuned} | {left_out} |");
    }
    Ok(text + &notes)
}

/// The soft string's results and times, ours and welleng's.
pub(super) fn statics(ours: &Value, theirs: &Value) -> Result<String, Failure> {
    let welleng = format!("welleng {}", word(theirs, "version")?);
    let mut text = format!(
        "| well | answer | closed form | wholestring | {welleng} | apart | closed form, sign turned \
         |\n|---|---|---|---|---|---|---|\n"
    );
    for (well, title) in [("deviated", "NP13-X1042's shape"), ("build", "build"), ("drop", "drop")]
    {
        for (key, name) in [
            ("pick_up_N", "pick-up, kN"),
            ("slack_off_N", "slack-off, kN"),
            ("rotating_N", "rotating, kN"),
            ("torque_N_m", "torque, kN·m"),
        ] {
            // The arcs are present for the side force, the sum of which is the torque.
            if well != "deviated" && key != "torque_N_m" {
                continue;
            }
            let [exact, turned] = ["closed_form", "turned_sign"].map(|form| {
                let known = theirs[format!("{form}_{key}")][well].as_f64();
                known.map_or_else(|| "–".to_owned(), |known| format!("{:.2}", known / 1e3))
            });
            let (our, their) = (number(&ours[well], key)?, number(&theirs[well], key)?);
            let _ = writeln!(
                text,
                "| {title} | {name} | {exact} | {:.2} | {:.2} | {:+.1} % | {turned} |",
                our / 1e3,
                their / 1e3,
                (their / our - 1.0) * 100.0
            );
        }
        for (key, name) in
            [("coarse_s", "all, pieces of 30 m, ms"), ("fine_s", "all, pieces of 1 m, ms")]
        {
            let (our, their) = (number(&ours[well], key)?, number(&theirs[well], key)?);
            let _ = writeln!(
                text,
                "| {title} | {name} | – | {} | {} | {} times | – |",
                digits(our * 1e3),
                digits(their * 1e3),
                digits(their / our)
            );
        }
    }
    Ok(text)
}

fn number(run: &Value, key: &str) -> Result<f64, Failure> {
    run[key].as_f64().ok_or_else(|| Failure::new(format!("no number `{key}` in {run}")))
}

fn word<'a>(run: &'a Value, key: &str) -> Result<&'a str, Failure> {
    run[key].as_str().ok_or_else(|| Failure::new(format!("no text `{key}` in {run}")))
}

/// Two digits for small values, whole numbers for large ones.
fn digits(value: f64) -> String {
    let plain: f64 = format!("{value:.1e}").parse().unwrap_or(value);
    if value < 100.0 { plain.to_string() } else { format!("{value:.0}") }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn of(result: Result<String, Failure>) -> String {
        result.unwrap_or_else(|failure| panic!("{}", failure.reason))
    }

    fn measured(program: &str, variant: &str, step_s: f64, cpu_s: f64) -> Value {
        json!({
            "program": program, "version": "1.2", "variant": variant, "elements": 1345, "step_s": step_s,
            "simulated_s": 4.0, "cpu_s": cpu_s, "hook_load_N": 663_407.7, "torque_N_m": 25_551.4,
            "tuned": "by hand", "leaves_out": "mud",
        })
    }

    #[test]
    fn a_row_for_each_program() {
        let text = of(dynamics(&[
            measured("ours", "", 6e-4, 0.1),
            measured("theirs", "tuned", 38e-6, 41.0),
        ]));
        let rows: Vec<&str> = text.lines().filter(|line| line.contains("1.2")).collect();
        assert_eq!(
            rows,
            [
                "| ours 1.2 | 1345 | 600 | 4 | 0.025 | 40 | 1 | 663.4 | 25.55 |",
                "| theirs 1.2, tuned | 1345 | 38 | 4 | 10 | 0.098 | 410 | 663.4 | 25.55 |",
                "| ours 1.2 | by hand | mud |",
                "| theirs 1.2, tuned | by hand | mud |",
            ]
        );
        assert!(dynamics(&[json!({ "program": "a", "version": "b" })]).is_err());
        assert!(dynamics(&[]).is_err());
    }

    #[test]
    fn answers_side_by_side() {
        let solved = |factor: f64| {
            json!({
                "pick_up_N": 2e6 * factor, "slack_off_N": 1e6, "rotating_N": 1.5e6,
                "torque_N_m": 16e3 * factor, "coarse_s": 1e-4 * factor, "fine_s": 3e-3,
            })
        };
        let ours = json!({ "deviated": solved(1.0), "build": solved(1.0), "drop": solved(1.0) });
        let theirs = json!({
            "version": "0.3", "deviated": solved(1.25), "build": solved(1.25), "drop": solved(0.5),
            "closed_form_torque_N_m": { "build": 16e3, "drop": 16e3 },
            "turned_sign_torque_N_m": { "build": 20e3, "drop": 8e3 },
        });
        let text = of(statics(&ours, &theirs));
        assert!(text.contains(
            "| NP13-X1042's shape | pick-up, kN | – | 2000.00 | 2500.00 | +25.0 % | – |\n"
        ));
        assert!(
            text.contains("| build | torque, kN·m | 16.00 | 16.00 | 20.00 | +25.0 % | 20.00 |\n")
        );
        assert!(text.contains("| drop | torque, kN·m | 16.00 | 16.00 | 8.00 | -50.0 % | 8.00 |\n"));
        assert!(
            text.contains("| drop | all, pieces of 30 m, ms | – | 0.1 | 0.05 | 0.5 times | – |\n")
        );
        assert!(!text.contains("| drop | pick-up"));
    }
}
