//! State shared by all requests.

use std::{ops::Deref, sync::Arc, thread};

use tokio::sync::Semaphore;

use crate::{
    jobs::Jobs, limits::Limits, live::EngineRoom, overview::Overviews, results::Verdicts,
    workspace::Workspace,
};

/// The state of the router; clones share it.
#[derive(Debug, Clone)]
pub(crate) struct App(Arc<Shared>);

/// The shared state.
#[derive(Debug)]
pub(crate) struct Shared {
    /// The folder of the cases.
    pub(crate) workspace: Arc<Workspace>,
    /// Limits of the server.
    pub(crate) limits: Limits,
    /// Live strings.
    pub(crate) live: EngineRoom,
    /// Permits for viewing live strings.
    pub(crate) live_viewers: Arc<Semaphore>,
    /// Permits for solving a case while it is edited, one for each core.
    pub(crate) solving: Arc<Semaphore>,
    /// The jobs.
    pub(crate) jobs: Arc<Jobs>,
    /// Overviews of the cases.
    pub(crate) overviews: Overviews,
    /// Verdicts of the results.
    pub(crate) verdicts: Verdicts,
}

impl App {
    pub(crate) fn new(workspace: Workspace, limits: Limits) -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let solving = Arc::new(Semaphore::new(cores));
        let workspace = Arc::new(workspace);
        let live = EngineRoom::new(limits, workspace.clone());
        let live_viewers = Arc::new(Semaphore::new(limits.live_viewers));
        let jobs = Jobs::new(workspace.clone());
        let overviews = Overviews::new(workspace.clone());
        let verdicts = Verdicts::default();
        Self(Arc::new(Shared {
            workspace,
            limits,
            live,
            live_viewers,
            solving,
            jobs,
            overviews,
            verdicts,
        }))
    }

    /// Ends the background work, and keeps its computed results. Called once, after the last
    /// request.
    pub(crate) fn close(&self) {
        self.overviews.close();
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
