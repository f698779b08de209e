//! Time of the clock: that of the system, and in a browser that of the page, because the standard
//! library has no clock there.

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
pub use std::time::Instant;

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use page::Instant;

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
mod page {
    use std::{
        ops::{Add, Sub},
        time::Duration,
    };

    #[link(wasm_import_module = "page")]
    unsafe extern "C" {
        /// Milliseconds since an arbitrary moment, as returned by `performance.now()`.
        safe fn now_ms() -> f64;
    }

    /// A moment on the page's clock.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub struct Instant(Duration);

    impl Instant {
        /// The current moment.
        pub fn now() -> Self {
            Self(Duration::try_from_secs_f64(1e-3 * now_ms()).unwrap_or_default())
        }

        /// Time since then.
        pub fn elapsed(&self) -> Duration {
            Self::now() - *self
        }
    }

    impl Sub for Instant {
        type Output = Duration;

        /// Time from the other moment to this one; zero if the other is later.
        fn sub(self, earlier: Self) -> Duration {
            self.0.saturating_sub(earlier.0)
        }
    }

    impl Add<Duration> for Instant {
        type Output = Self;

        fn add(self, time: Duration) -> Self {
            Self(self.0 + time)
        }
    }
}
