//! Recorded actions of the driller's seat as the schedule of a case.

use std::f64::consts::PI;

use serde_json::{Value, json};
use wholestring_case::{Case, Edit, EditError, edit};
use wholestring_config::node::{self, Value as Node};
use wholestring_units::{number_text, significant};

use super::{recording::RecordedEvent, set_points::SetPoints};

/// A channel of a schedule line: at most one line sets each at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Channel {
    RotarySpeed,
    Hoist,
    Flow,
}

/// A line of the schedule that sets one value.
#[derive(Debug, Clone, PartialEq)]
struct Line {
    at_s: f64,
    ramp_s: f64,
    channel: Channel,
    key: &'static str,
    value: Value,
}

/// A text with the schedule.
#[derive(Debug)]
pub struct WithSchedule {
    pub text: String,
    /// Number of added lines.
    pub lines: usize,
    /// Actions that no schedule can express, in sentences.
    pub left_out: Vec<String>,
}

/// Digits of a set point.
const DIGITS: usize = 9;

fn quantity(value: f64, unit: &str) -> Value {
    json!(format!("{} {unit}", significant(value, DIGITS)))
}

/// The values of set points, as channel, key and value.
fn values(points: &SetPoints) -> impl Iterator<Item = (Channel, &'static str, Value)> {
    let speed = points
        .rotary_speed_rad_per_s
        .map(|speed| (Channel::RotarySpeed, "rpm", json!(significant(speed * 30.0 / PI, DIGITS))));
    let block = points
        .block_velocity_m_per_s
        .map(|speed| (Channel::Hoist, "block_velocity", quantity(speed, "m/s")));
    let weight =
        points.weight_on_bit_N.map(|force| (Channel::Hoist, "wob", quantity(force / 1e3, "kN")));
    let flow = points
        .flow_rate_m3_per_s
        .map(|flow| (Channel::Flow, "flow_rate", quantity(flow * 6e4, "L/min")));
    [speed, block, weight, flow].into_iter().flatten()
}

/// The lines of the recorded events. A set point that was still ramping at the next event reaches
/// its value at that time when the event begins.
fn lines(events: &[RecordedEvent]) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for event in events {
        for (channel, key, value) in values(&event.set) {
            let last = lines.iter_mut().rev().find(|line| line.channel == channel);
            if let Some(last) = last
                && last.at_s + last.ramp_s > event.at_s
            {
                last.ramp_s = event.at_s - last.at_s;
                let there = values(&event.before).find(|(_, key, _)| *key == last.key);
                if let Some((_, _, value)) = there {
                    last.value = value;
                }
            }
            let (at_s, ramp_s) = (event.at_s, event.set.ramp_s);
            lines.push(Line { at_s, ramp_s, channel, key, value });
        }
    }
    lines
}

/// The key of the list in a text: an operation may be a table, or the only item of a list.
fn list_key(text: &str) -> &'static str {
    let entries = node::parse_text(text, 0).ok();
    match entries.as_ref().and_then(|all| all.get("operation")).map(|found| &found.value) {
        Some(Node::List(_)) => "operation.0.schedule",
        _ => "operation.schedule",
    }
}

/// Writes the recorded events into the schedule of a text, between its existing lines. `case` is
/// the case of the text.
///
/// # Errors
/// A text that cannot be changed in this way.
pub fn with_schedule(
    text: &str,
    case: &Case,
    events: &[RecordedEvent],
) -> Result<WithSchedule, EditError> {
    let mut there: Vec<f64> = case.dynamics.schedule.steps.iter().map(|step| step.at_s).collect();
    let list = list_key(text);
    let lines = lines(events);
    let mut edits = Vec::new();
    for line in &lines {
        let at = there.partition_point(|at_s| *at_s <= line.at_s);
        there.insert(at, line.at_s);
        let mut value = json!({ "at": format!("{} s", significant(line.at_s, DIGITS)) });
        if line.ramp_s > 0.0 {
            value["ramp"] = json!(format!("{} s", significant(line.ramp_s, DIGITS)));
        }
        value[line.key] = line.value.clone();
        edits.push(Edit::Insert { list: list.to_owned(), at, value });
    }
    Ok(WithSchedule { text: edit(text, &edits)?, lines: lines.len(), left_out: left_out(events) })
}

fn left_out(events: &[RecordedEvent]) -> Vec<String> {
    let mut sentences = Vec::new();
    for event in events {
        let at = number_text(event.at_s);
        if let Some(friction) = event.set.friction {
            let friction = number_text(friction);
            sentences.push(format!(
                "a friction of {friction} from {at} s on: a schedule does not change the hole"
            ));
        }
        if let Some(controller) = &event.set.controller {
            sentences.push(format!(
                "the controller `{controller}` from {at} s on: a schedule does not change the \
                 top drive"
            ));
        }
    }
    sentences
}

#[cfg(test)]
mod tests {
    use wholestring_case::{InMemory, parse};

    use super::super::set_points::{
        MAX_BLOCK_VELOCITY_M_PER_S, MAX_FLOW_RATE_M3_PER_S, MAX_ROTARY_SPEED_RAD_PER_S,
        MAX_WEIGHT_ON_BIT_N,
    };
    use super::*;

    const TEXT: &str = wholestring_cases::VERTICAL.text;

    fn case_of(text: &str) -> Case {
        let parsed = parse("case.toml", text.as_bytes(), &InMemory::default(), &[]);
        parsed.unwrap_or_else(|report| panic!("{}\n{text}", report.render(false)))
    }

    /// A drilling case, made from a self-contained one.
    fn text() -> String {
        let operation = TEXT.find("[operation]").or(TEXT.find("[[operation]]"));
        let head = &TEXT[..operation.expect("an operation")];
        let head = head.replace("[\"soft\"]", "[\"dynamic\"]");
        format!(
            "{head}[operation]\nkind = \"drill\"\nrpm = 60\nwob = \"20 kN\"\nrop = \"10 m/h\"\n\
             # the plan\n[[operation.schedule]]\nat = \"5 s\"\nrpm = 90\n"
        )
    }

    fn event(at_s: f64, set: SetPoints) -> RecordedEvent {
        RecordedEvent { at_s, set, before: SetPoints::default() }
    }

    #[test]
    fn what_was_done_is_read_back_as_it_was() {
        let (text, speed) = (text(), 12.345_678_9);
        let set = SetPoints { rotary_speed_rad_per_s: Some(speed), ..SetPoints::default() };
        let weight = SetPoints { weight_on_bit_N: Some(31_500.0), ramp_s: 4.0, ..set.clone() };
        let friction = SetPoints { friction: Some(0.4), ..SetPoints::default() };
        let events = [event(2.0, set), event(7.25, weight), event(9.0, friction)];
        let made = with_schedule(&text, &case_of(&text), &events).expect("a text");
        assert!(made.text.contains("# the plan"));
        assert_eq!((made.lines, made.left_out.len()), (3, 1));
        let steps = case_of(&made.text).dynamics.schedule.steps;
        let times: Vec<f64> = steps.iter().map(|step| step.at_s).collect();
        assert_eq!(times, [2.0, 5.0, 7.25, 7.25]);
        // Nine digits are written.
        let read = steps[0].rotary_speed_rad_per_s.expect("a speed");
        assert!((read / speed - 1.0).abs() < 1e-8);
        assert_eq!((steps[3].ramp_s, steps[2].ramp_s), (4.0, 4.0));
    }

    /// If the second of two ramps begins before the end of the first, the first ends there, at the
    /// value of its set point at that time.
    #[test]
    fn a_ramp_that_was_taken_over_ends_there() {
        let speed = |speed, ramp_s| SetPoints {
            rotary_speed_rad_per_s: Some(speed),
            ramp_s,
            ..SetPoints::default()
        };
        let events = [
            event(10.0, speed(4.0 * PI, 8.0)),
            RecordedEvent { at_s: 12.0, set: speed(PI, 1.0), before: speed(2.5 * PI, 0.0) },
        ];
        let found = lines(&events);
        assert_eq!((found[0].ramp_s, &found[0].value), (2.0, &json!(75.0)));
        assert_eq!((found[1].ramp_s, &found[1].value), (1.0, &json!(30.0)));
        let text = text();
        let made = with_schedule(&text, &case_of(&text), &events).expect("a text");
        assert_eq!(case_of(&made.text).dynamics.schedule.steps.len(), 3);
    }

    /// The bounds of the knobs are those of the schedule: a line is accepted at them and refused
    /// beyond.
    #[test]
    fn the_bounds_of_the_knobs_are_those_of_the_schedule() {
        let text = text();
        for set in [
            |factor: f64| SetPoints {
                rotary_speed_rad_per_s: Some(factor * MAX_ROTARY_SPEED_RAD_PER_S),
                ..SetPoints::default()
            },
            |factor: f64| SetPoints {
                block_velocity_m_per_s: Some(-factor * MAX_BLOCK_VELOCITY_M_PER_S),
                ..SetPoints::default()
            },
            |factor: f64| SetPoints {
                weight_on_bit_N: Some(factor * MAX_WEIGHT_ON_BIT_N),
                ..SetPoints::default()
            },
            |factor: f64| SetPoints {
                flow_rate_m3_per_s: Some(factor * MAX_FLOW_RATE_M3_PER_S),
                ..SetPoints::default()
            },
        ] {
            for (factor, is_sound) in [(1.0, true), (1.01, false)] {
                let events = [event(6.0, set(factor))];
                let made = with_schedule(&text, &case_of(&text), &events).expect("a text");
                let read = parse("case.toml", made.text.as_bytes(), &InMemory::default(), &[]);
                assert_eq!(read.is_ok(), is_sound, "{}", made.text);
            }
        }
    }
}
