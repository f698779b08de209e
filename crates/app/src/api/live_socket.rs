//! WebSocket of a live string: frames and samples to the page, set points from it.

use std::{sync::Arc, time::Duration};

use axum::{
    extract::{
        Path, State, WebSocketUpgrade,
        ws::{Message, Utf8Bytes, WebSocket},
    },
    response::Response,
};
use futures_util::{SinkExt, StreamExt, stream::SplitSink};
use tokio::{sync::watch, time::timeout};
use utoipa_axum::{router::OpenApiRouter, routes};

use wholestring_screens::live::{LiveError, LiveString, Status, Told, Viewing, frame_packet};

use super::error::ApiError;
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(socket))
}

/// Maximum size of a message from a page, bytes: no request is longer.
const LONGEST: usize = 16 << 10;

/// A page that receives nothing for this time is considered gone.
const PATIENCE: Duration = Duration::from_secs(30);

/// Minimum time between two messages; pages draw no faster.
const BETWEEN: Duration = Duration::from_millis(15);

/// A live string over a WebSocket.
///
/// Text is JSON. The server begins with `{"type": "layout", ...}`, and sends `{"type": "status",
/// ...}` at changes and a few times a second, and `{"type": "refused", "message": "..."}`. The page
/// sends `{"have": {"epoch": 0, "next": 0}}` first, then at any time `{"set":
/// {"rotary_speed_rad_per_s": 12.5}}`, `{"pace": 10}`, `{"pace": "max"}`, `{"run": true}`,
/// `{"step": 0.1}`, `{"units": "field"}`.
///
/// Binary is little-endian: a head of 24 bytes with the kind (u32: 1 samples, 2 a frame), the count
/// of rows or nodes (u32), the epoch (u32), a reserved field (u32), and the number of the first
/// sample or the time of the frame in s (f64); then the numbers (f32), of samples by rows, of a
/// frame by columns, in the columns of the layout. Missing values are NaN. Sample `n` is that of
/// the time `(n + 1)` sample intervals. A rewind begins another epoch, whose samples replace those
/// with the same and later numbers. Nothing is queued: a page that reads slowly gets the latest
/// frame, and misses samples that are no longer kept.
#[utoipa::path(
    get,
    path = "/api/live/{id}/socket",
    responses(
        (status = 101, description = "text messages of the server", body = Told),
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
        attend(socket, &string).await;
    }))
}

type Sink = SplitSink<WebSocket, Message>;

/// Returns whether the page received it.
async fn send(sink: &mut Sink, message: Message) -> bool {
    matches!(timeout(PATIENCE, sink.send(message)).await, Ok(Ok(())))
}

async fn tell(sink: &mut Sink, message: &Told<'_>) -> bool {
    send(sink, Message::Text(Utf8Bytes::from(message.text()))).await
}

/// Serves a page until it disconnects or the string ends.
async fn attend(socket: WebSocket, string: &Arc<LiveString>) {
    let (mut sink, mut stream) = socket.split();
    let (mut frames, mut status) = (string.frames(), string.status());
    let mut viewing = Viewing::of(string);
    if !tell(&mut sink, &Told::Layout(&string.layout)).await {
        return;
    }
    // A new page receives the present frame as a change.
    frames.mark_changed();
    status.mark_changed();
    loop {
        tokio::select! {
            incoming = stream.next() => {
                let Some(Ok(message)) = incoming else { return };
                let refused = match message {
                    Message::Text(text) => viewing.hear(&text),
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
                if changed.is_err() || !give_status(&mut sink, &viewing, &mut status).await {
                    return;
                }
            }
            changed = frames.changed() => {
                if changed.is_err() {
                    return;
                }
                let frame = frames.borrow_and_update().clone();
                let bytes = frame_packet(frame.epoch, frame.time_s, &frame.columns);
                // A string that is being initialised has no frame yet.
                let is_frame = !frame.columns.is_empty();
                if !give_samples(&mut sink, &mut viewing).await
                    || is_frame && !send(&mut sink, Message::Binary(bytes.into())).await
                {
                    return;
                }
                tokio::time::sleep(BETWEEN).await;
            }
        }
        if string.has_ended() {
            give_status(&mut sink, &viewing, &mut status).await;
            let _ = timeout(PATIENCE, sink.close()).await;
            return;
        }
    }
}

async fn give_status(
    sink: &mut Sink,
    viewing: &Viewing,
    status: &mut watch::Receiver<Arc<Status>>,
) -> bool {
    let now = viewing.status(&status.borrow_and_update().clone());
    tell(sink, &Told::Status(&now)).await
}

/// Sends all samples that are new at this time.
async fn give_samples(sink: &mut Sink, viewing: &mut Viewing) -> bool {
    let mut more = true;
    while more && let Some((bytes, others)) = viewing.samples() {
        if !send(sink, Message::Binary(bytes.into())).await {
            return false;
        }
        more = others;
    }
    true
}
