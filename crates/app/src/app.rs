//! What all requests share.

use std::{ops::Deref, sync::Arc, thread};

use tokio::sync::Semaphore;

use crate::{limits::Limits, workspace::Workspace};

/// The state of the router: clones are the same.
#[derive(Debug, Clone)]
pub(crate) struct App(Arc<Shared>);

/// What they share.
#[derive(Debug)]
pub(crate) struct Shared {
    /// The folder of the cases.
    pub(crate) workspace: Workspace,
    /// How much is taken at once.
    pub(crate) limits: Limits,
    /// Turns at solving a case while it is written: as many as there are cores.
    pub(crate) solving: Arc<Semaphore>,
}

impl App {
    pub(crate) fn new(workspace: Workspace, limits: Limits) -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let solving = Arc::new(Semaphore::new(cores));
        Self(Arc::new(Shared { workspace, limits, solving }))
    }

    /// Ends what goes on in the background, and keeps what it has computed. Called once, after the
    /// last request.
    pub(crate) fn close(&self) {}
}

impl Deref for App {
    type Target = Shared;

    fn deref(&self) -> &Shared {
        &self.0
    }
}
