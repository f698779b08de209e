//! Set points of an engine and their recording, its checkpoints and rewinding.

use std::collections::VecDeque;

use wholestring::dynamics::Indicators;
use wholestring_runner::{
    Instant,
    run::{Live, OwnLaws},
};

use super::{
    begin::{controllers, last_controller, refused},
    command::{Command, LiveError},
    engine::Engine,
    live_string::held,
    long_elements,
    recording::{MOST_EVENTS, RecordedEvent},
    set_points::SetPoints,
    watched::Watched,
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
            // Its quantities stay marked until a viewer's units are known.
            Err(LiveError::Refused(sentence)) => self.refused = Some(sentence),
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
        let set_N = self.live.simulation().series().weight_on_bit_set_N.last().copied().flatten();
        let heavier = set
            .weight_on_bit_N
            .filter(|weight_N| *weight_N > set_N.unwrap_or(self.string.operation.weight_on_bit_N));
        if let Some(weight_N) = heavier
            && let Some(element) = self.live.simulation().buckled_element_under(weight_N)
        {
            return Err(LiveError::Refused(long_elements::refused(weight_N, &element)));
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

// Checkpoints of an engine, and rewinding.

impl Engine {
    pub(super) fn put_checkpoint(&mut self) -> Result<u64, LiveError> {
        let bytes = self.live.checkpoint().map_err(refused)?;
        let time_s = self.time_s();
        self.checkpoint.1 = Instant::now();
        Ok(held(&self.string.checkpoints).put(time_s, bytes))
    }

    // If the client has gone, nobody needs the response.
    pub(super) fn command(&mut self, command: Command) {
        match command {
            Command::Rewind { number, replay, reply } => {
                let _ = reply.send(self.rewind(number, replay));
            }
            Command::Checkpoint { reply } => {
                let made = match &self.failed {
                    Some(sentence) => Err(LiveError::Refused(sentence.clone())),
                    None => self.put_checkpoint(),
                };
                let _ = reply.send(made);
            }
        }
    }

    fn rewind(&mut self, number: u64, replay: bool) -> Result<(), LiveError> {
        let found = held(&self.string.checkpoints).get(number);
        let (entry, bytes) = found.ok_or(LiveError::Nothing("checkpoint"))?;
        let laws = OwnLaws::default();
        self.live = Live::resume(self.string.case.clone(), &laws, None, &bytes).map_err(refused)?;
        (self.failed, self.refused, self.step_s) = (None, None, 0.0);
        let (now, time_s) = (Instant::now(), self.time_s());
        let later = held(&self.string.recording).split_from(time_s);
        self.replay = if replay { later.into() } else { VecDeque::new() };
        self.controller = last_controller(&self.string.case, &self.string.events());
        held(&self.string.checkpoints).rewind(entry.number);
        held(&self.string.ring).rewind((time_s / self.sample_s()).round() as u64);
        self.epoch += 1;
        self.watched = Watched::new(self.live.simulation(), &self.string);
        self.indicators = Indicators::default();
        self.rows = self.live.simulation().series().time_s.len();
        self.checkpoint = (time_s, now);
        self.restart_pace(self.pacer.pace());
        self.show();
        Ok(())
    }
}
