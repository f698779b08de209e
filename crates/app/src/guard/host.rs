//! The name under which the server is reached.

use std::net::ToSocketAddrs;

use axum::http::{HeaderMap, Uri, header};

use super::{refusal::Refusal, token::Token};

/// Number of letters of a server's own name: 80 bits.
const NAME: usize = 16;

/// The name under which the server is reached.
///
/// Browsers send a cookie to all ports of a host: one of `127.0.0.1` reaches every server of this
/// machine that the user visits, also those of other users. The server therefore has a host of its
/// own, `RANDOM.localhost`, new with every start. Browsers resolve names under `localhost` to the
/// loopback address themselves (RFC 6761: Chrome, Edge, Firefox, and curl); Safari asks the system,
/// which knows them from macOS 26 on. A secret in a header would not do: frames of reports,
/// downloads, event streams and WebSockets cannot send one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Address {
    /// A name of its own, except on a system whose own browser could not resolve it.
    #[default]
    Automatic,
    /// `127.0.0.1`, for browsers that do not resolve names under `localhost`. Servers on other
    /// ports receive the cookie.
    Plain,
}

/// The server's host and port, as a browser sends them.
#[derive(Debug, Clone)]
pub(crate) struct Host {
    /// `NAME:PORT`.
    authority: String,
    is_plain: bool,
}

impl Host {
    /// # Errors
    /// A system without random numbers.
    pub(crate) fn new(address: Address, port: u16) -> Result<Self, getrandom::Error> {
        let own = format!("{}.localhost:{port}", Token::random(NAME)?.text());
        let is_plain = match address {
            Address::Plain => true,
            // Safari, the browser of the system, depends on the system.
            Address::Automatic => cfg!(target_os = "macos") && !is_resolved(&own),
        };
        let authority = if is_plain { format!("127.0.0.1:{port}") } else { own };
        Ok(Self { authority, is_plain })
    }

    /// `http://NAME:PORT`.
    pub(crate) fn origin(&self) -> String {
        format!("http://{}", self.authority)
    }

    /// Whether it is `127.0.0.1`, whose cookies all ports share.
    pub(crate) fn is_plain(&self) -> bool {
        self.is_plain
    }

    /// The requested host, if it is this server.
    pub(super) fn requested<'a>(
        &self,
        headers: &'a HeaderMap,
        uri: &Uri,
    ) -> Result<&'a str, Refusal> {
        let mut hosts = headers.get_all(header::HOST).iter();
        let (Some(host), None) = (hosts.next(), hosts.next()) else {
            return Err(Refusal::ForeignHost);
        };
        let host = host.to_str().map_err(|_| Refusal::ForeignHost)?;
        let is_other = uri.authority().is_some_and(|authority| authority.as_str() != host);
        match !is_other && host == self.authority {
            true => Ok(host),
            false => Err(Refusal::ForeignHost),
        }
    }
}

/// Whether the system resolves a name to loopback addresses alone.
fn is_resolved(authority: &str) -> bool {
    let Ok(addresses) = authority.to_socket_addrs() else { return false };
    let addresses: Vec<_> = addresses.collect();
    !addresses.is_empty() && addresses.iter().all(|address| address.ip().is_loopback())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_start_has_a_name_of_its_own() {
        let host = || Host::new(Address::Automatic, 80).unwrap();
        let plain = Host::new(Address::Plain, 80).unwrap();
        assert_eq!(plain.origin(), "http://127.0.0.1:80");
        assert!(plain.is_plain());
        if !cfg!(target_os = "macos") {
            assert_ne!(host().origin(), host().origin());
            assert!(host().origin().ends_with(".localhost:80") && !host().is_plain());
        }
    }

    #[test]
    fn loopback_is_resolved() {
        assert!(is_resolved("127.0.0.1:80") && is_resolved("localhost:80"));
        assert!(!is_resolved("no such name:80"));
    }
}
