//! Work that uses the processor or waits for the disk, outside the threads of the server.

use super::error::ApiError;

/// Runs the work on a thread of its own. After a panic, the response is an error and the server
/// continues.
pub(crate) async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, ApiError> + Send + 'static,
) -> Result<T, ApiError> {
    match tokio::task::spawn_blocking(work).await {
        Ok(done) => done,
        Err(_) => {
            Err(ApiError::failed("internal error of the program; the request was not carried out"))
        }
    }
}
