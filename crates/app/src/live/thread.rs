//! What a thread does for the string that it takes forward.

use std::time::Duration;

use wholestring_screens::live::{End, Engine};

/// Goes on until the string is to end: because somebody wants it to, or since nobody has looked at
/// it for this time.
pub(super) fn go_on(mut engine: Engine, idle: Duration) -> End {
    let string = engine.string();
    let mut wait = Duration::ZERO;
    loop {
        let mut asked = string.wanted_within(wait);
        if let Some(end) = asked.end.take() {
            return engine.end(end.sentence, end.keeps);
        }
        wait = engine.turn(asked);
        if string.unseen() > idle {
            let minutes = idle.as_secs() / 60;
            let sentence = format!(
                "nobody has looked at this string for {minutes} min, so it was ended; it is kept \
                 as it was and can be continued"
            );
            return engine.end(sentence, true);
        }
    }
}
