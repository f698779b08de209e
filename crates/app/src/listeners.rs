//! The sockets of the server: the port on both loopback addresses.
//!
//! Browsers resolve names under `localhost` to `::1` as well as to `127.0.0.1`. If the server had
//! the port on one of them alone, another user's program could open it on the other, and receive
//! the requests of the browser with their cookie.

use std::{
    io,
    net::{Ipv4Addr, Ipv6Addr, SocketAddr, TcpListener},
};

use tokio::net::TcpStream;

/// Attempts to find a port that is free on both addresses.
const ATTEMPTS: usize = 20;

/// Opened sockets of one port.
#[derive(Debug)]
pub(crate) struct Listeners {
    v4: TcpListener,
    /// None on a system without IPv6.
    v6: Option<TcpListener>,
    pub(crate) port: u16,
}

impl Listeners {
    /// Opens a port; 0: a free one.
    ///
    /// # Errors
    /// A port that another program has on either address.
    pub(crate) fn bind(port: u16) -> io::Result<Self> {
        let mut attempt = 1;
        loop {
            match Self::bind_both(port) {
                Err(error)
                    if port == 0
                        && error.kind() == io::ErrorKind::AddrInUse
                        && attempt < ATTEMPTS =>
                {
                    attempt += 1;
                }
                result => return result,
            }
        }
    }

    fn bind_both(port: u16) -> io::Result<Self> {
        let v4 = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port)))?;
        v4.set_nonblocking(true)?;
        let port = v4.local_addr()?.port();
        let v6 = match TcpListener::bind(SocketAddr::from((Ipv6Addr::LOCALHOST, port))) {
            Ok(listener) => {
                listener.set_nonblocking(true)?;
                Some(listener)
            }
            // Whoever cannot use the address cannot be misled by it.
            Err(error) if is_lacking(&error) => None,
            Err(error) => return Err(error),
        };
        Ok(Self { v4, v6, port })
    }

    /// Makes them the runtime's.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn into_tokio(self) -> io::Result<Accepting> {
        let tokio = tokio::net::TcpListener::from_std;
        Ok(Accepting { v4: tokio(self.v4)?, v6: self.v6.map(tokio).transpose()? })
    }
}

/// Whether the system has no such address.
fn is_lacking(error: &io::Error) -> bool {
    let kinds = [io::ErrorKind::AddrNotAvailable, io::ErrorKind::Unsupported];
    // The address family is not supported: Linux, macOS, Windows.
    let family = [Some(97), Some(47), Some(10_047)];
    kinds.contains(&error.kind()) || family.contains(&error.raw_os_error())
}

/// Sockets that accept connections.
#[derive(Debug)]
pub(crate) struct Accepting {
    v4: tokio::net::TcpListener,
    v6: Option<tokio::net::TcpListener>,
}

impl Accepting {
    /// The next connection on either address.
    ///
    /// # Errors
    /// Errors of the system, for example too many open files.
    pub(crate) async fn accept(&self) -> io::Result<TcpStream> {
        let v6 = async {
            match &self.v6 {
                Some(listener) => listener.accept().await,
                None => std::future::pending().await,
            }
        };
        let accepted = tokio::select! {
            accepted = self.v4.accept() => accepted,
            accepted = v6 => accepted,
        };
        accepted.map(|(stream, _)| stream)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_of_another_program_is_refused_on_either_address() {
        let Ok(other) = TcpListener::bind((Ipv6Addr::LOCALHOST, 0)) else { return };
        let port = other.local_addr().unwrap().port();
        let refused = Listeners::bind(port).unwrap_err();
        assert_eq!(refused.kind(), io::ErrorKind::AddrInUse);
        let free = Listeners::bind(0).unwrap();
        assert_eq!(free.v6.unwrap().local_addr().unwrap().port(), free.port);
    }
}
