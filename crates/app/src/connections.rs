//! Connections: so many at once, each with a head of so many bytes in so many seconds.

use std::{convert::Infallible, sync::Arc, time::Duration};

use axum::{
    Router,
    body::Body,
    extract::Request,
    http::StatusCode,
    response::{IntoResponse, Response},
};
use hyper::{body::Incoming, server::conn::http1, service::service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::{
    net::{TcpListener, TcpStream},
    sync::Semaphore,
    time::{sleep, timeout},
};
use tower::ServiceExt;

use crate::{api::error::ApiError, guard::Guard, limits::Limits, stop::Stop};

/// What answers on a port.
#[derive(Debug, Clone)]
pub(crate) struct Connections {
    router: Router,
    guard: Arc<Guard>,
    limits: Limits,
}

impl Connections {
    pub(crate) fn new(router: Router, guard: Guard, limits: Limits) -> Self {
        Self { router, guard: Arc::new(guard), limits }
    }

    /// Takes connections until it is asked to stop, then waits a bounded time for open answers.
    pub(crate) async fn serve(self, listener: TcpListener, stop: &Stop) {
        let places = Arc::new(Semaphore::new(self.limits.connections));
        let accept = async {
            loop {
                // Without a free place nobody is taken: those who come wait with the system.
                let Ok(place) = places.clone().acquire_owned().await else { return };
                let Ok((stream, _)) = listener.accept().await else {
                    // Out of file descriptors, for one: they come back as connections end.
                    sleep(Duration::from_millis(50)).await;
                    continue;
                };
                let (this, stop) = (self.clone(), stop.clone());
                tokio::spawn(async move {
                    this.attend(stream, &stop).await;
                    drop(place);
                });
            }
        };
        tokio::select! {
            () = accept => {}
            () = stop.requested() => {}
        }
        drop(listener);
        let all = u32::try_from(self.limits.connections).unwrap_or(u32::MAX);
        let _ = timeout(self.limits.closing_time, places.acquire_many(all)).await;
    }

    /// One connection, request after request.
    async fn attend(&self, stream: TcpStream, stop: &Stop) {
        let _ = stream.set_nodelay(true);
        let service =
            service_fn(|request| async { Ok::<_, Infallible>(self.answer(request).await) });
        let connection = http1::Builder::new()
            .timer(TokioTimer::new())
            .header_read_timeout(self.limits.head_time)
            .max_headers(self.limits.header_fields)
            .max_header_size(self.limits.head_bytes)
            .serve_connection(TokioIo::new(stream), service)
            .with_upgrades();
        tokio::pin!(connection);
        tokio::select! {
            _ = connection.as_mut() => return,
            () = stop.requested() => connection.as_mut().graceful_shutdown(),
        }
        // What fails here is the other side's: it has gone, or spoke no HTTP.
        let _ = connection.await;
    }

    /// One request: the guard, then the router, under the clock.
    async fn answer(&self, request: Request<Incoming>) -> Response {
        let (head, body) = request.into_parts();
        let authority = head.headers.get("host").cloned();
        let response = match self.guard.admit(&head) {
            Err(refusal) => refusal.into_response(),
            Ok(()) => {
                let request = Request::from_parts(head, Body::new(body));
                let answered = self.router.clone().oneshot(request);
                match timeout(self.limits.request_time, answered).await {
                    Ok(Ok(response)) => response,
                    Ok(Err(never)) => match never {},
                    Err(_) => ApiError::new(
                        StatusCode::SERVICE_UNAVAILABLE,
                        "timeout",
                        format!("no answer in {} s", self.limits.request_time.as_secs()),
                    )
                    .into_response(),
                }
            }
        };
        crate::guard::headers::put(response, authority.as_ref())
    }
}
