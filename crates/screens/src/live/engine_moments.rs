//! Checkpoints of an engine, and rewinding.

use std::collections::VecDeque;

use wholestring_runner::{
    Instant,
    run::{Live, OwnLaws},
};

use super::{
    begin::{last_controller, refused},
    command::{Command, LiveError},
    engine::{Engine, watched},
    live_string::held,
};

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
        self.watched = watched(&self.live, &self.string);
        self.rows = self.live.simulation().series().time_s.len();
        self.checkpoint = (time_s, now);
        self.restart_pace(self.pacer.pace());
        self.show();
        Ok(())
    }
}
