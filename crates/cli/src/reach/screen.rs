//! Output of a reach on the screen.

use wholestring_results::ReachSummary;
use wholestring_runner::reach::{answers, notes, scatter, uncertain_notes};
use wholestring_units::{Dimension, UnitSet};

use crate::screen_table::Table;

/// The governing limit, each limit with its depth and margins, and warnings.
pub(crate) fn text(summary: &ReachSummary, units: UnitSet) -> String {
    let length = Dimension::Length.unit_in(units);
    let depth = |depth_m: f64| format!("{:.0}", length.from_si(depth_m));
    let mut text = format!("{}: reach\n\n", summary.case);
    for (answer, friction) in answers(summary, units).iter().zip(&summary.frictions) {
        let headings = [
            "operation".to_owned(),
            "limit".to_owned(),
            format!("met at, {}", length.symbol),
            format!("margin at {}, %", depth(summary.from_m)),
            format!("at {}, %", depth(summary.to_m)),
            format!("worst at MD, {}", length.symbol),
        ];
        let mut table = Table::new(answer, 2, &headings.each_ref().map(String::as_str));
        for limit in &friction.limits {
            let met = match limit.depth_m {
                Some(_) if limit.already => format!("{} already", depth(summary.from_m)),
                Some(depth_m) => depth(depth_m),
                None if limit.margin_at_from.is_none() => "no answer: locked up".to_owned(),
                None => format!("none to {}", depth(summary.to_m)),
            };
            table.row(vec![
                limit.operation.words().to_owned(),
                limit.title.clone(),
                met,
                percent(limit.margin_at_from),
                percent(limit.margin_at_to),
                limit.at_md_m.map_or_else(|| "–".to_owned(), depth),
            ]);
        }
        text += &table.text();
        text.push('\n');
        for check in summary.checks.iter().filter(|check| check.friction == friction.friction) {
            text += &format!("{}.\n", check.check.sentence_in(units));
        }
        text.push('\n');
    }
    if let Some(uncertain) = &summary.uncertain {
        for sentence in uncertain_notes(uncertain).into_iter().chain(scatter(uncertain, units)) {
            text += &format!("{sentence}\n");
        }
    }
    for note in notes(summary, units) {
        text += &format!("{note}\n");
    }
    text
}

fn percent(margin: Option<f64>) -> String {
    margin.map_or_else(|| "locked up".to_owned(), |margin| format!("{:.1}", 100.0 * margin))
}
