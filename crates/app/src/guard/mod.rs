//! The guard in front of the router: admission of requests.
//!
//! A page of another site can make a browser send requests here (cross-site request forgery), and
//! can make its own name point here (DNS rebinding); other programs of this machine can send
//! requests, too. A request is therefore admitted only if its `Host` is the server's, if any change
//! or socket comes from the app's own page, and if its cookie holds the token of this start, which
//! only the printed address gives.

pub(crate) mod headers;
mod origin;
mod refusal;
mod token;

use axum::http::{HeaderMap, Method, Uri, header, request::Parts};

pub(crate) use refusal::Refusal;
use token::Token;

/// Decides which requests are admitted.
#[derive(Debug)]
pub(crate) struct Guard {
    port: u16,
    token: Token,
}

impl Guard {
    /// A guard with a new token.
    ///
    /// # Errors
    /// A system without random numbers.
    pub(crate) fn new(port: u16) -> Result<Self, getrandom::Error> {
        Ok(Self { port, token: Token::random()? })
    }

    /// The address that admits a browser.
    pub(crate) fn url(&self) -> String {
        format!("http://127.0.0.1:{}/?token={}", self.port, self.token.text())
    }

    /// Whether a request may reach the router.
    pub(crate) fn admit(&self, head: &Parts) -> Result<(), Refusal> {
        let host = self.host(&head.headers, &head.uri)?;
        if is_unsafe(head) {
            origin::ours(&head.headers, host)?;
        } else if head.uri.path().starts_with("/api/") {
            origin::not_foreign(&head.headers)?;
        }
        if let Some(offered) = offered_token(&head.uri)
            && head.method == Method::GET
        {
            return Err(match self.token.is(offered.as_bytes()) {
                true => Refusal::LetIn { cookie: self.new_cookie() },
                false => Refusal::NoToken,
            });
        }
        match self.has_cookie(&head.headers) {
            true => Ok(()),
            false => Err(Refusal::NoToken),
        }
    }

    /// The requested host, if it is this server.
    fn host<'a>(&self, headers: &'a HeaderMap, uri: &Uri) -> Result<&'a str, Refusal> {
        let mut hosts = headers.get_all(header::HOST).iter();
        let (Some(host), None) = (hosts.next(), hosts.next()) else {
            return Err(Refusal::ForeignHost);
        };
        let host = host.to_str().map_err(|_| Refusal::ForeignHost)?;
        let is_other = uri.authority().is_some_and(|authority| authority.as_str() != host);
        match !is_other && self.is_ours(host) {
            true => Ok(host),
            false => Err(Refusal::ForeignHost),
        }
    }

    fn is_ours(&self, host: &str) -> bool {
        let name = host.strip_suffix(&format!(":{}", self.port));
        matches!(name, Some("127.0.0.1" | "localhost" | "[::1]"))
    }

    /// Cookies are shared by all ports of a host, so that the name includes the port.
    fn cookie_name(&self) -> String {
        format!("wholestring_{}", self.port)
    }

    fn new_cookie(&self) -> String {
        format!("{}={}; Path=/; HttpOnly; SameSite=Strict", self.cookie_name(), self.token.text())
    }

    fn has_cookie(&self, headers: &HeaderMap) -> bool {
        let name = self.cookie_name();
        let cookies = headers.get_all(header::COOKIE).iter().filter_map(|one| one.to_str().ok());
        let pairs = cookies.flat_map(|cookies| cookies.split(';'));
        let mut ours = pairs.filter_map(|pair| pair.trim().split_once('='));
        ours.any(|(key, value)| key == name && self.token.is(value.as_bytes()))
    }
}

/// Whether a request changes something, or opens a socket that can.
fn is_unsafe(head: &Parts) -> bool {
    let is_upgrade = head.headers.contains_key(header::UPGRADE);
    is_upgrade || !matches!(head.method, Method::GET | Method::HEAD)
}

/// The token in the address of the page.
fn offered_token(uri: &Uri) -> Option<&str> {
    let query = uri.query().filter(|_| uri.path() == "/")?;
    query.split('&').find_map(|pair| pair.strip_prefix("token="))
}
