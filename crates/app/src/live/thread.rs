//! The thread that advances a live string.

use std::time::Duration;

use wholestring_screens::live::{End, Engine};

/// Advances the string until it is stopped, or has had no viewer for this time.
pub(super) fn go_on(mut engine: Engine, idle: Duration) -> End {
    let string = engine.string();
    let mut wait = Duration::ZERO;
    loop {
        let mut requests = string.wanted_within(wait);
        if let Some(end) = requests.end.take() {
            return engine.end(end.sentence, end.keeps);
        }
        wait = engine.turn(requests);
        if string.unseen() > idle {
            let minutes = idle.as_secs() / 60;
            let sentence = format!(
                "without a viewer for {minutes} min, this string was ended; it is saved and can be \
                 continued"
            );
            return engine.end(sentence, true);
        }
    }
}
