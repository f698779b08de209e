//! Set points of an engine, and their recording.

use super::{
    begin::{controllers, refused},
    command::LiveError,
    engine::Engine,
    live_string::held,
    recording::{MOST_EVENTS, RecordedEvent},
    set_points::SetPoints,
};

impl Engine {
    /// Applies set points now, and records them.
    pub(super) fn set(&mut self, set: SetPoints) {
        let at_s = self.time_s();
        if held(&self.string.recording).events().len() >= MOST_EVENTS {
            self.refused = Some(format!(
                "{MOST_EVENTS} changes are recorded: rewind, or start again, to make more"
            ));
            return;
        }
        let before = self.standing();
        match self.apply(&set, at_s) {
            Ok(()) => {
                self.refused = None;
                held(&self.string.recording).add(RecordedEvent { at_s, set, before });
            }
            Err(error) => self.refused = Some(error.to_string()),
        }
    }

    fn apply(&mut self, set: &SetPoints, at_s: f64) -> Result<(), LiveError> {
        if let Some(word) = &set.controller {
            let known = controllers(&self.string.case);
            let found = known.iter().find(|(known_word, _)| known_word == word);
            let (word, controller) = found.ok_or_else(|| {
                let words: Vec<&str> = known.iter().map(|(word, _)| *word).collect();
                LiveError::Refused(match words[..] {
                    [] => "the top drive of this case has no controller".to_owned(),
                    _ => format!("no controller is called `{word}`: {}", words.join(", ")),
                })
            })?;
            self.live.set_speed_controller(*controller).map_err(refused)?;
            self.controller = Some(word);
        }
        if let Some(friction) = set.friction {
            self.live.set_friction(&[friction], set.ramp_s).map_err(refused)?;
        }
        match set.line(at_s) {
            Some(line) => self.live.add_to_schedule(line).map_err(refused),
            None => Ok(()),
        }
    }

    /// The present values of the set points, from the last sample.
    fn standing(&self) -> SetPoints {
        let series = self.live.simulation().series();
        SetPoints {
            rotary_speed_rad_per_s: series.rotary_speed_set_rad_per_s.last().copied(),
            block_velocity_m_per_s: series.block_velocity_set_m_per_s.last().copied().flatten(),
            weight_on_bit_N: series.weight_on_bit_set_N.last().copied().flatten(),
            flow_rate_m3_per_s: series.flow_rate_m3_per_s.last().copied(),
            ..SetPoints::default()
        }
    }
}
