//! Interval between checkpoints.

use std::time::Duration;

use clap::Args;
use wholestring_units::Dimension;

#[derive(Debug, Args)]
pub(crate) struct CheckpointArgs {
    /// Wall-clock time between checkpoints, such as 5min [default: the case's, 30 s]
    #[arg(long = "checkpoint", value_name = "TIME", value_parser = interval)]
    pub(crate) every: Option<Duration>,
}

fn interval(text: &str) -> Result<Duration, String> {
    let seconds = Dimension::Time.parse(text).map_err(|error| error.to_string())?;
    if (0.01..=86_400.0).contains(&seconds) {
        Ok(Duration::from_secs_f64(seconds))
    } else {
        Err("expected 0.01 s to 86400 s".to_owned())
    }
}
