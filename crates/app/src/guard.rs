//! The guard in front of the router: admission of requests.
//!
//! A page of another site can make a browser send requests here (cross-site request forgery), and
//! can make its own name point here (DNS rebinding); other programs of this machine can send
//! requests, too. A request is therefore admitted only if its `Host` is the server's, if any change
//! or socket comes from the app's own page, and if its cookie holds the token of this start, which
//! only the printed address gives.

use axum::{
    http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, Uri, header, request::Parts},
    response::{Html, IntoResponse, Response},
};

use crate::api::error::ApiError;

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
            ours(&head.headers, host)?;
        } else if head.uri.path().starts_with("/api/") {
            not_foreign(&head.headers)?;
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

// Responses in place of the router's.

/// Reason why a request does not reach the router.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// It was addressed to another host.
    ForeignHost,
    /// It comes from a page of another origin.
    ForeignOrigin,
    /// It has neither the cookie nor the token.
    NoToken,
    /// It has the token, and receives the cookie.
    LetIn {
        /// The cookie.
        cookie: String,
    },
}

const NO_TOKEN: &str = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">\
    <title>wholestring</title><h1>wholestring</h1>\
    <p>This page belongs to whoever started the program. Use the address that it printed: \
    it ends in <code>/?token=</code> and a long number, and is new with every start.</p></html>";

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        match self {
            Self::ForeignHost => ApiError::new(
                StatusCode::MISDIRECTED_REQUEST,
                "foreign_host",
                "this server answers to 127.0.0.1 and localhost with its own port alone",
            )
            .into_response(),
            Self::ForeignOrigin => ApiError::new(
                StatusCode::FORBIDDEN,
                "foreign_origin",
                "only a page of this server may send this request",
            )
            .into_response(),
            Self::NoToken => (StatusCode::UNAUTHORIZED, Html(NO_TOKEN)).into_response(),
            Self::LetIn { cookie } => {
                let headers = [(header::LOCATION, "/".to_owned()), (header::SET_COOKIE, cookie)];
                (StatusCode::SEE_OTHER, headers).into_response()
            }
        }
    }
}

// The secret of one start of the server.

/// 256 random bits, known only to readers of the printed address.
struct Token(String);

impl Token {
    fn random() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; 32];
        getrandom::fill(&mut bytes)?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// As hexadecimal digits.
    fn text(&self) -> &str {
        &self.0
    }

    /// Whether the offered token is equal. The comparison takes the same time wherever the two
    /// differ.
    fn is(&self, offered: &[u8]) -> bool {
        let own = self.0.as_bytes();
        let pairs = own.iter().zip(offered);
        let difference = pairs.fold(0, |difference, (one, other)| difference | (one ^ other));
        own.len() == offered.len() && std::hint::black_box(difference) == 0
    }
}

impl std::fmt::Debug for Token {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.write_str("Token(..)")
    }
}

// Origin of a request.

/// The header in which a browser gives the relation of the requesting page to the server.
const FETCH_SITE: &str = "sec-fetch-site";

/// Refuses requests that do not come from the app's own page.
fn ours(headers: &HeaderMap, host: &str) -> Result<(), Refusal> {
    let mut origins = headers.get_all(header::ORIGIN).iter();
    let is_ours = match (origins.next(), origins.next()) {
        (Some(origin), None) => {
            let origin = origin.to_str().ok().and_then(|origin| origin.strip_prefix("http://"));
            origin == Some(host)
        }
        (None, _) => site(headers) == Some("same-origin"),
        _ => false,
    };
    if is_ours { Ok(()) } else { Err(Refusal::ForeignOrigin) }
}

/// Refuses requests that a browser sends for a page of another origin, including other ports of
/// this machine, because they carry the app's cookie.
fn not_foreign(headers: &HeaderMap) -> Result<(), Refusal> {
    match site(headers) {
        None | Some("same-origin" | "none") => Ok(()),
        Some(_) => Err(Refusal::ForeignOrigin),
    }
}

fn site(headers: &HeaderMap) -> Option<&str> {
    headers.get(FETCH_SITE).map(|site| site.to_str().unwrap_or("cross-site"))
}

// Security headers of every response.

/// Default headers of every response.
const EVERYWHERE: [(HeaderName, &str); 5] = [
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (header::CACHE_CONTROL, "no-store"),
];

/// Only scripts, styles and requests of the app itself; no embedding, nothing inline.
const POLICY: &str = "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Adds the headers. `host` is the server's name in the browser: the scheme of a socket differs
/// from the page's, and not every browser treats them as the same origin.
pub(crate) fn put_headers(mut response: Response, host: Option<&HeaderValue>) -> Response {
    let headers = response.headers_mut();
    for (name, value) in EVERYWHERE {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    }
    let host = host.and_then(|host| host.to_str().ok()).filter(|host| is_plain(host));
    let sockets = host.map_or_else(String::new, |host| format!(" ws://{host}"));
    let policy = format!("{POLICY}; connect-src 'self'{sockets}");
    if let Ok(policy) = HeaderValue::try_from(policy) {
        headers.entry(header::CONTENT_SECURITY_POLICY).or_insert(policy);
    }
    response
}

/// Whether it contains only a host and a port.
fn is_plain(host: &str) -> bool {
    host.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".:[]-".contains(&byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_whole_token_is_it() {
        let token = Token::random().unwrap();
        let text = token.text().to_owned();
        assert_eq!(text.len(), 64);
        assert!(token.is(text.as_bytes()));
        assert!(!token.is(&text.as_bytes()[..63]));
        assert!(!token.is(b""));
        assert!(!token.is(format!("{text}0").as_bytes()));
        assert!(!token.is(Token::random().unwrap().text().as_bytes()));
        assert!(!format!("{token:?}").contains(&text));
    }
}
