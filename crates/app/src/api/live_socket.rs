//! A live string as it moves: a socket for frames and samples down, and for set points up.

use std::{sync::Arc, time::Duration};

use axum::{
    extract::{
        Path, State, WebSocketUpgrade,
        ws::{Message, Utf8Bytes, WebSocket},
    },
    response::Response,
};
use futures_util::{SinkExt, StreamExt, stream::SplitSink};
use serde::{Deserialize, Serialize};
use tokio::{sync::watch, time::timeout};
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::error::ApiError;
use crate::{
    app::App,
    live::{Layout, LiveError, LiveString, Pace, SetPoints, Status, frame_packet, samples_packet},
};

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(socket))
}

/// What the server says, as text; samples and frames are binary.
#[derive(Debug, Serialize, ToSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub(crate) enum Told<'a> {
    /// What a viewer has to know first.
    Layout(&'a Layout),
    /// How the string is doing.
    Status(&'a Status),
    /// What was asked cannot be.
    Refused {
        /// Why.
        message: String,
    },
}

/// What a page asks, as text.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub(crate) enum Asked {
    /// The samples that the page has already: those of this epoch up to this number. Said first, or
    /// all that is kept is sent.
    Have {
        /// The epoch.
        epoch: u32,
        /// The number of the next sample.
        next: u64,
    },
    /// Sets something.
    Set(SetPoints),
    /// Takes another pace.
    Pace(Pace),
    /// Goes on, or waits.
    Run(bool),
    /// Goes on by so many seconds, and waits then.
    Step(f64),
}

/// What a page may send at once, bytes: no request of it is longer.
const LONGEST: usize = 16 << 10;

/// A page that takes nothing for so long is gone.
const PATIENCE: Duration = Duration::from_secs(30);

/// Samples in a message at most: the rest follows in the next.
const MOST_SAMPLES: usize = 4096;

/// Between two messages at least, for a page that draws no faster.
const BETWEEN: Duration = Duration::from_millis(15);

/// A live string as it moves, over a WebSocket.
///
/// Text is JSON. The server begins with `{"type": "layout", ...}`, and says `{"type": "status",
/// ...}` where something changes and a few times a second, and `{"type": "refused", "message":
/// "..."}`. The page says `{"have": {"epoch": 0, "next": 0}}` first, then as it likes `{"set":
/// {"rotary_speed_rad_per_s": 12.5}}`, `{"pace": 10}`, `{"pace": "max"}`, `{"run": true}`,
/// `{"step": 0.1}`.
///
/// Binary is little-endian: a head of 24 bytes with the kind (u32: 1 samples, 2 a frame), the
/// count of rows or nodes (u32), the epoch (u32), nothing (u32), and the number of the first sample
/// or the time of the frame in s (f64); then the numbers (f32), of samples row after row, of a frame
/// column after column, in the columns of the layout. What has no value is not a number. Sample `n`
/// is that of the time `(n + 1)` sample intervals. A rewind begins another epoch, whose samples take
/// the place of those of their numbers and after. Nothing is queued: a page that reads slowly gets
/// the latest frame, and misses samples that are no longer kept.
#[utoipa::path(
    get,
    path = "/api/live/{id}/socket",
    responses(
        (status = 101, description = "what the server says as text", body = Told),
        (status = 404, body = ApiError),
        (status = 410, body = ApiError)
    )
)]
async fn socket(
    State(app): State<App>,
    Path(id): Path<String>,
    upgrade: WebSocketUpgrade,
) -> Result<Response, ApiError> {
    let string = app.live.string(&id)?;
    let turn = app.live_viewers.clone().try_acquire_owned().map_err(|_| {
        let most = app.limits.live_viewers;
        LiveError::TooMany(format!("{most} pages look at live strings already: close one"))
    })?;
    let upgrade = upgrade.max_message_size(LONGEST).max_frame_size(LONGEST);
    Ok(upgrade.on_upgrade(move |socket| async move {
        let _turn = turn;
        let _viewer = string.view();
        attend(socket, &string).await;
    }))
}

/// What a viewer has been given.
struct Given {
    string: Arc<LiveString>,
    epoch: u32,
    next: u64,
}

type Sink = SplitSink<WebSocket, Message>;

/// Whether the page took it.
async fn send(sink: &mut Sink, message: Message) -> bool {
    matches!(timeout(PATIENCE, sink.send(message)).await, Ok(Ok(())))
}

async fn tell(sink: &mut Sink, told: &Told<'_>) -> bool {
    let text = serde_json::to_string(told).unwrap_or_default();
    send(sink, Message::Text(Utf8Bytes::from(text))).await
}

/// Serves a page until it goes, or the string does.
async fn attend(socket: WebSocket, string: &Arc<LiveString>) {
    let (mut sink, mut stream) = socket.split();
    let (mut frames, mut status) = (string.frames(), string.status());
    let mut given = Given { string: string.clone(), epoch: u32::MAX, next: 0 };
    if !tell(&mut sink, &Told::Layout(&string.layout)).await {
        return;
    }
    // What is there is news to who comes.
    frames.mark_changed();
    status.mark_changed();
    loop {
        tokio::select! {
            asked = stream.next() => {
                let Some(Ok(message)) = asked else { return };
                let refused = match message {
                    Message::Text(text) => given.hear(&text),
                    Message::Close(_) => return,
                    _ => None,
                };
                if let Some(message) = refused
                    && !tell(&mut sink, &Told::Refused { message }).await
                {
                    return;
                }
            }
            changed = status.changed() => {
                if changed.is_err() || !give_status(&mut sink, &mut status).await {
                    return;
                }
            }
            changed = frames.changed() => {
                if changed.is_err() {
                    return;
                }
                let frame = frames.borrow_and_update().clone();
                let bytes = frame_packet(frame.epoch, frame.time_s, &frame.columns);
                // A string that is about to begin has no frame yet.
                let is_frame = !frame.columns.is_empty();
                if !given.give_samples(&mut sink).await
                    || is_frame && !send(&mut sink, Message::Binary(bytes.into())).await
                {
                    return;
                }
                tokio::time::sleep(BETWEEN).await;
            }
        }
        if string.has_ended() {
            give_status(&mut sink, &mut status).await;
            let _ = timeout(PATIENCE, sink.close()).await;
            return;
        }
    }
}

async fn give_status(sink: &mut Sink, status: &mut watch::Receiver<Arc<Status>>) -> bool {
    let now = status.borrow_and_update().clone();
    tell(sink, &Told::Status(&now)).await
}

impl Given {
    /// Gives the samples that are new, as many as there are now.
    async fn give_samples(&mut self, sink: &mut Sink) -> bool {
        loop {
            let samples = self.string.samples(self.epoch, self.next, MOST_SAMPLES);
            let Some(samples) = samples else { return true };
            let is_all = samples.values.is_empty() || samples.end() - samples.first < 4096;
            (self.epoch, self.next) = (samples.epoch, samples.end());
            if !send(sink, Message::Binary(samples_packet(&samples).into())).await {
                return false;
            }
            if is_all {
                return true;
            }
        }
    }

    /// Does what a page asks; why not, where it cannot be.
    fn hear(&mut self, text: &str) -> Option<String> {
        let asked: Asked = match serde_json::from_str(text) {
            Ok(asked) => asked,
            Err(error) => return Some(format!("this is not understood: {error}")),
        };
        let string = &self.string;
        let done = match asked {
            Asked::Have { epoch, next } => {
                (self.epoch, self.next) = (epoch, next);
                Ok(())
            }
            Asked::Set(set) => string.set(set),
            Asked::Pace(pace) => string.pace(pace),
            Asked::Run(runs) => {
                string.run(runs);
                Ok(())
            }
            Asked::Step(seconds) => string.step(seconds),
        };
        done.err().map(|error| error.to_string())
    }
}
