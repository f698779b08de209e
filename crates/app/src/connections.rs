//! Connections: a limited number at once, each with limits on the size and the time of its request,
//! until the server is asked to stop.

use std::{convert::Infallible, sync::Arc, time::Duration};

use axum::{
    Router,
    body::Body,
    extract::Request,
    http::{HeaderValue, StatusCode, header, request::Parts},
    response::{IntoResponse, Response},
};
use hyper::{
    body::{Body as _, Incoming},
    server::conn::http1,
    service::service_fn,
};
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::{
    net::TcpStream,
    sync::{Semaphore, watch},
    time::{sleep, timeout},
};
use tower::ServiceExt;

use crate::{
    api::error::ApiError,
    guard::{self, Admission, Guard},
    limits::Limits,
    listeners::Accepting,
    places::{Place, Places},
};

/// The services on a port.
#[derive(Debug, Clone)]
pub(crate) struct Connections {
    router: Router,
    guard: Arc<Guard>,
    limits: Limits,
    /// Permits for requests with large bodies.
    large_bodies: Arc<Semaphore>,
}

impl Connections {
    pub(crate) fn new(router: Router, guard: Guard, limits: Limits) -> Self {
        let large_bodies = Arc::new(Semaphore::new(limits.large_bodies));
        Self { router, guard: Arc::new(guard), limits, large_bodies }
    }

    /// Accepts connections until it is stopped, then waits a bounded time for open responses.
    pub(crate) async fn serve(self, listeners: Accepting, stop: &Stop) {
        let places = Places::new(self.limits.connections, self.limits.silent_time);
        let accept = async {
            loop {
                let Ok(stream) = listeners.accept().await else {
                    // Out of file descriptors, for example, which are freed as connections end.
                    sleep(Duration::from_millis(50)).await;
                    continue;
                };
                let place = places.take().await;
                let (this, stop) = (self.clone(), stop.clone());
                tokio::spawn(async move { this.attend(stream, &place, &stop).await });
            }
        };
        tokio::select! {
            () = accept => {}
            () = stop.requested() => {}
        }
        drop(listeners);
        let _ = timeout(self.limits.closing_time, places.all_free()).await;
    }

    /// Serves one connection, request after request.
    async fn attend(&self, stream: TcpStream, place: &Place, stop: &Stop) {
        let _ = stream.set_nodelay(true);
        let service =
            service_fn(|request| async { Ok::<_, Infallible>(self.answer(request, place).await) });
        let connection = http1::Builder::new()
            .timer(TokioTimer::new())
            .header_read_timeout(self.limits.head_time)
            .max_headers(self.limits.header_fields)
            .max_header_size(self.limits.head_bytes)
            .serve_connection(TokioIo::new(stream), service)
            .with_upgrades();
        tokio::pin!(connection);
        tokio::select! {
            // The connection first: a request that is here already keeps its place.
            biased;
            _ = connection.as_mut() => return,
            () = place.replaced() => return,
            () = stop.requested() => connection.as_mut().graceful_shutdown(),
        }
        // A failure here is the client's: it has disconnected, or did not send HTTP.
        let _ = connection.await;
    }

    /// One request: the guard, then the router.
    async fn answer(&self, request: Request<Incoming>, place: &Place) -> Response {
        let (head, body) = request.into_parts();
        let host = head.headers.get(header::HOST).cloned();
        let response = match self.guard.admit(&head) {
            Err(refusal) => last(refusal.into_response()),
            Ok(Admission::Exchange) => last(self.exchange(&head, body).await),
            Ok(Admission::Session) => {
                place.admit();
                let request = Request::from_parts(head, Body::new(body));
                match timeout(self.limits.request_time, self.route(request)).await {
                    Ok(response) => response,
                    Err(_) => self.too_late(),
                }
            }
        };
        guard::put_headers(response, host.as_ref())
    }

    /// Exchanges the code in a short form for the cookie.
    async fn exchange(&self, head: &Parts, body: Incoming) -> Response {
        let form = axum::body::to_bytes(Body::new(body), guard::LONGEST_FORM);
        match timeout(self.limits.head_time, form).await {
            Ok(Ok(form)) => self.guard.exchange(head, &form),
            _ => self.guard.exchange(head, b""),
        }
    }

    /// Routes an admitted request, after a permit if its body is large.
    async fn route(&self, request: Request) -> Response {
        let body = request.body().size_hint();
        if body.lower() > self.limits.body_bytes as u64 {
            return self.too_long();
        }
        let is_large = body.upper().is_none_or(|most| most > self.limits.small_body_bytes as u64);
        // The semaphore is never closed.
        let _place = if is_large { self.large_bodies.acquire().await.ok() } else { None };
        match self.router.clone().oneshot(request).await {
            Ok(response) => response,
            Err(never) => match never {},
        }
    }

    fn too_long(&self) -> Response {
        let most = self.limits.body_bytes >> 20;
        let message = format!("a request is limited to {most} MB");
        ApiError::new(StatusCode::PAYLOAD_TOO_LARGE, "too_long", message).into_response()
    }

    fn too_late(&self) -> Response {
        let message = format!("no answer in {} s", self.limits.request_time.as_secs());
        ApiError::new(StatusCode::SERVICE_UNAVAILABLE, "timeout", message).into_response()
    }
}

/// The last response of a connection: whoever was not admitted keeps no place.
fn last(mut response: Response) -> Response {
    response.headers_mut().insert(header::CONNECTION, HeaderValue::from_static("close"));
    response
}

// A request to stop the server.

/// Stops a server. Its clones stop the same server, from any thread.
#[derive(Debug, Clone)]
pub struct Stop(Arc<watch::Sender<bool>>);

impl Stop {
    pub(crate) fn new() -> Self {
        Self(Arc::new(watch::Sender::new(false)))
    }

    /// Requests the stop, and returns whether it had been requested before.
    pub fn stop(&self) -> bool {
        self.0.send_replace(true)
    }

    /// Waits for a request to stop.
    pub(crate) async fn requested(&self) {
        let mut receiver = self.0.subscribe();
        // The sender is owned here, so that it cannot be closed.
        let _ = receiver.wait_for(|is_requested| *is_requested).await;
    }
}
