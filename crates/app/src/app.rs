//! What all requests share.

use std::{ops::Deref, sync::Arc, thread};

use tokio::sync::Semaphore;

use crate::{jobs::Jobs, limits::Limits, live::EngineRoom, workspace::Workspace};

/// The state of the router: clones are the same.
#[derive(Debug, Clone)]
pub(crate) struct App(Arc<Shared>);

/// What they share.
#[derive(Debug)]
pub(crate) struct Shared {
    /// The folder of the cases.
    pub(crate) workspace: Arc<Workspace>,
    /// How much is taken at once.
    pub(crate) limits: Limits,
    /// Strings in motion.
    pub(crate) live: EngineRoom,
    /// Turns at looking at them.
    pub(crate) live_viewers: Arc<Semaphore>,
    /// Turns at solving a case while it is written: as many as there are cores.
    pub(crate) solving: Arc<Semaphore>,
    /// Work that was started.
    pub(crate) jobs: Arc<Jobs>,
}

impl App {
    pub(crate) fn new(workspace: Workspace, limits: Limits) -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let solving = Arc::new(Semaphore::new(cores));
        let workspace = Arc::new(workspace);
        let live = EngineRoom::new(limits, workspace.clone());
        let live_viewers = Arc::new(Semaphore::new(limits.live_viewers));
        let jobs = Jobs::new(workspace.clone());
        Self(Arc::new(Shared { workspace, limits, live, live_viewers, solving, jobs }))
    }

    /// Ends what goes on in the background, and keeps what it has computed. Called once, after the
    /// last request.
    pub(crate) fn close(&self) {
        self.live.close();
        self.jobs.close();
    }
}

impl Deref for App {
    type Target = Shared;

    fn deref(&self) -> &Shared {
        &self.0
    }
}
