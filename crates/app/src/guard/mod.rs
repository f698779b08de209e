//! The guard in front of the router: admission of requests.
//!
//! A page of another site can make a browser send requests here (cross-site request forgery), and
//! can make its own name point here (DNS rebinding); other programs of this machine can send
//! requests, too. A request is therefore admitted only if its `Host` is the server's, if any change
//! or socket comes from the app's own page, and if its cookie holds the secret of this session,
//! which a browser gets in exchange for a link.

mod entrance;
mod headers;
mod host;
mod links;
mod origin;
mod refusal;
mod token;

use axum::{
    http::{HeaderMap, Method, header, request::Parts},
    response::Response,
};

pub(crate) use entrance::LONGEST_FORM;
pub(crate) use headers::put_headers;
pub use host::Address;
pub(crate) use host::Host;
pub use links::Links;
use refusal::Refusal;
use token::Token;

/// Number of letters of the cookie: 260 bits.
const SESSION: usize = 52;

/// Decides which requests are admitted.
#[derive(Debug)]
pub(crate) struct Guard {
    port: u16,
    host: Host,
    session: Token,
    links: Links,
}

/// The destination of an admitted request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Admission {
    /// The router: the request has the cookie.
    Session,
    /// [`Guard::exchange`], with the body.
    Exchange,
}

impl Guard {
    /// A guard with new secrets.
    ///
    /// # Errors
    /// A system without random numbers.
    pub(crate) fn new(address: Address, port: u16) -> Result<Self, getrandom::Error> {
        let host = Host::new(address, port)?;
        let links = Links::new(host.origin());
        Ok(Self { port, host, session: Token::random(SESSION)?, links })
    }

    pub(crate) fn host(&self) -> &Host {
        &self.host
    }

    pub(crate) fn links(&self) -> &Links {
        &self.links
    }

    /// The destination of a request.
    pub(crate) fn admit(&self, head: &Parts) -> Result<Admission, Refusal> {
        let host = self.host.requested(&head.headers, &head.uri)?;
        match (head.uri.path(), &head.method) {
            (entrance::PATH, &Method::GET | &Method::HEAD) => return Err(Refusal::Entrance),
            (entrance::SCRIPT_PATH, &Method::GET | &Method::HEAD) => return Err(Refusal::Script),
            // The code alone decides: the file on disk has no origin that could be checked.
            (entrance::PATH, &Method::POST) => return Ok(Admission::Exchange),
            _ => {}
        }
        if is_unsafe(head) {
            origin::ours(&head.headers, host)?;
        } else if head.uri.path().starts_with("/api/") {
            origin::not_foreign(&head.headers)?;
        }
        match self.has_cookie(&head.headers) {
            true => Ok(Admission::Session),
            false => Err(Refusal::NoCookie),
        }
    }

    /// Exchanges the code in a form for the cookie. A browser that has the cookie is sent on with
    /// any code, because it may load the page of a link twice.
    pub(crate) fn exchange(&self, head: &Parts, form: &[u8]) -> Response {
        let used = entrance::code(form).and_then(|code| self.links.redeem(code));
        match used {
            Some(used) => {
                drop(tokio::task::spawn_blocking(used));
                entrance::admitted(Some(self.new_cookie()))
            }
            None if self.has_cookie(&head.headers) => entrance::admitted(None),
            None => entrance::used(),
        }
    }

    /// The port is in the name because a plain host shares its cookies among all ports.
    fn cookie_name(&self) -> String {
        format!("wholestring_{}", self.port)
    }

    fn new_cookie(&self) -> String {
        let (name, value) = (self.cookie_name(), self.session.text());
        // Without `Domain` it is sent to this host alone, and not to names below it.
        format!("{name}={value}; Path=/; HttpOnly; SameSite=Strict")
    }

    fn has_cookie(&self, headers: &HeaderMap) -> bool {
        let name = self.cookie_name();
        let cookies = headers.get_all(header::COOKIE).iter().filter_map(|one| one.to_str().ok());
        let pairs = cookies.flat_map(|cookies| cookies.split(';'));
        let mut ours = pairs.filter_map(|pair| pair.trim().split_once('='));
        ours.any(|(key, value)| key == name && self.session.is(value.as_bytes()))
    }
}

/// Whether a request changes something, or opens a socket that can.
fn is_unsafe(head: &Parts) -> bool {
    let is_upgrade = head.headers.contains_key(header::UPGRADE);
    is_upgrade || !matches!(head.method, Method::GET | Method::HEAD)
}
