//! The server on a port of the loopback address.

use std::{io, path::PathBuf};

use crate::{
    api,
    app::App,
    connections::{Connections, Stop},
    guard::{Address, Guard, Links},
    limits::Limits,
    listeners::Listeners,
    workspace::{Workspace, WorkspaceError},
};

/// Folder and port of a server.
#[derive(Debug, Clone)]
pub struct Options {
    /// The folder of the cases, which confines all access.
    pub folder: PathBuf,
    /// The port of the loopback addresses; 0: a free one.
    pub port: u16,
    /// The name in the address.
    pub address: Address,
}

/// Reason why a server cannot start.
#[derive(Debug, thiserror::Error)]
pub enum ServerError {
    /// The folder cannot be used.
    #[error("{0}")]
    Folder(String),
    /// The port is in use, or not permitted.
    #[error("port {port} of 127.0.0.1 and [::1] cannot be opened: {source}")]
    Port {
        /// The port.
        port: u16,
        /// The error of the system.
        source: io::Error,
    },
    /// The system provided no random numbers or no threads.
    #[error("the server cannot be started: {0}")]
    System(String),
}

impl From<WorkspaceError> for ServerError {
    fn from(error: WorkspaceError) -> Self {
        Self::Folder(error.to_string())
    }
}

/// A server with its port and its folder, ready to run.
#[derive(Debug)]
pub struct Server {
    listeners: Listeners,
    guard: Guard,
    app: App,
    stop: Stop,
}

impl Server {
    /// Opens the folder and the port.
    ///
    /// # Errors
    /// A missing or unreadable folder, and a port that cannot be opened.
    pub fn bind(options: &Options) -> Result<Self, ServerError> {
        let workspace = Workspace::open(&options.folder)?;
        let port = options.port;
        let refused = |source| ServerError::Port { port, source };
        let listeners = Listeners::bind(port).map_err(refused)?;
        let guard = Guard::new(options.address, listeners.port)
            .map_err(|error| ServerError::System(error.to_string()))?;
        workspace.remove_leftovers();
        let app = App::new(workspace, Limits::default());
        Ok(Self { listeners, guard, app, stop: Stop::new() })
    }

    /// Makes links that let browsers in.
    pub fn links(&self) -> Links {
        self.guard.links().clone()
    }

    /// Whether the address is `127.0.0.1`, whose cookies reach servers on other ports.
    pub fn is_plain(&self) -> bool {
        self.guard.host().is_plain()
    }

    /// Handle that stops it.
    pub fn stop(&self) -> Stop {
        self.stop.clone()
    }

    /// Serves until it is stopped.
    ///
    /// # Errors
    /// The system provides no threads.
    pub fn run(self) -> Result<(), ServerError> {
        let Self { listeners, guard, app, stop } = self;
        let links = guard.links().clone();
        let failed = |error: io::Error| ServerError::System(error.to_string());
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .enable_all()
            .build()
            .map_err(failed)?;
        let served = runtime.block_on(async {
            let listeners = listeners.into_tokio()?;
            let router = api::router(app.clone());
            Connections::new(router, guard, app.limits).serve(listeners, &stop).await;
            Ok(())
        });
        links.close();
        app.close();
        runtime.shutdown_background();
        served.map_err(failed)
    }
}
