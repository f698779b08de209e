//! Links that let one browser in, once.
//!
//! The code of a link is exchanged for the cookie of the session, and is worth nothing afterwards:
//! a copy in a terminal's log, a chat or the history of a browser admits nobody.

use std::{
    fmt::{self, Debug, Formatter},
    io,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use super::{entrance, token::Token};
use crate::link_file::LinkFile;

/// Number of letters of a code: 130 bits.
const CODE: usize = 26;

/// Maximum number of unused links; the oldest becomes invalid.
const MOST: usize = 16;

/// Makes links to a server. Clones make links to the same server, from any thread.
#[derive(Clone)]
pub struct Links(Arc<Shared>);

struct Shared {
    /// `http://NAME:PORT`.
    origin: String,
    /// The unused links, the oldest first.
    open: Mutex<Vec<Open>>,
}

/// An unused link, and the work after its use.
struct Open {
    code: Token,
    used: Box<dyn FnOnce() + Send>,
}

impl Links {
    pub(crate) fn new(origin: String) -> Self {
        Self(Arc::new(Shared { origin, open: Mutex::default() }))
    }

    /// A new link as an address: `http://NAME:PORT/enter#CODE`. `used` runs once after its use, on
    /// a thread that may wait.
    ///
    /// The code is in the fragment, which a browser does not send: no log and no header has it.
    ///
    /// # Errors
    /// A system without random numbers.
    pub fn address(&self, used: impl FnOnce() + Send + 'static) -> io::Result<String> {
        let code = Token::random(CODE).map_err(io::Error::other)?;
        let address = format!("{}{}#{}", self.0.origin, entrance::PATH, code.text());
        self.add(code, Box::new(used));
        Ok(address)
    }

    /// A new link as a page that only this user can read, which enters when a browser opens it. The
    /// file is deleted after its use, and by [`Self::close`].
    ///
    /// # Errors
    /// A temporary folder that cannot be written, and a system without random numbers.
    pub fn file(&self) -> io::Result<std::path::PathBuf> {
        let code = Token::random(CODE).map_err(io::Error::other)?;
        let action = format!("{}{}", self.0.origin, entrance::PATH);
        let file = LinkFile::new(&entrance::form(&action, code.text()))?;
        let path = file.path().to_owned();
        self.add(code, Box::new(move || drop(file)));
        Ok(path)
    }

    /// Makes all links invalid, and deletes their files.
    pub fn close(&self) {
        // Dropped outside the lock, because files are deleted.
        let open = std::mem::take(&mut *self.open());
        drop(open);
    }

    fn add(&self, code: Token, used: Box<dyn FnOnce() + Send>) {
        let mut open = self.open();
        if open.len() == MOST {
            open.remove(0);
        }
        open.push(Open { code, used });
    }

    /// Uses up the link with a code. Returns the work that follows, if there is such a link.
    pub(super) fn redeem(&self, code: &str) -> Option<Box<dyn FnOnce() + Send>> {
        let mut open = self.open();
        let place = open.iter().position(|link| link.code.is(code.as_bytes()))?;
        Some(open.remove(place).used)
    }

    fn open(&self) -> MutexGuard<'_, Vec<Open>> {
        // Every change is one step: a panic leaves none half done.
        self.0.open.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Debug for Links {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        to.write_str("Links(..)")
    }
}
