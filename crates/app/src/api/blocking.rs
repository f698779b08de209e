//! Work that takes the processor or waits for the disk, beside the threads that talk.

use super::error::ApiError;

/// Does it on a thread of its own. Where it panics, the answer says so and the server goes on.
pub(crate) async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, ApiError> + Send + 'static,
) -> Result<T, ApiError> {
    match tokio::task::spawn_blocking(work).await {
        Ok(done) => done,
        Err(_) => Err(ApiError::failed(
            "the program has met a mistake of its own; what was asked is not done",
        )),
    }
}
