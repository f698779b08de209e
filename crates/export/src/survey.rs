//! A survey in the usual form: stations with their positions by minimum curvature.

use wholestring::well::{Interpolation, Path, PathError, Station, TieIn};

/// A station and its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Measured depth, m.
    pub md_m: f64,
    /// Inclination, rad.
    pub inclination_rad: f64,
    /// Azimuth, rad, from 0 to 2π.
    pub azimuth_rad: f64,
    /// True vertical depth, m.
    pub tvd_m: f64,
    /// North, m.
    pub north_m: f64,
    /// East, m.
    pub east_m: f64,
    /// Dogleg severity from the preceding station, rad/m; zero at the first.
    pub dogleg_severity_rad_per_m: f64,
}

/// The rows of stations that begin at a tie-in. Positions are by minimum curvature, whichever curve
/// the case uses between the stations, because readers of surveys assume it.
///
/// # Errors
/// There is no path through the stations.
pub fn rows(stations: &[Station], tie_in: TieIn) -> Result<Vec<Row>, PathError> {
    let path = Path::new(stations, Interpolation::MinimumCurvature, tie_in)?;
    let points: Vec<_> = stations.iter().map(|station| path.at(station.md_m)).collect();
    let rows = stations.iter().enumerate().map(|(place, station)| {
        let above = place.checked_sub(1);
        let severity = above.map_or(0.0, |above| {
            points[above].dogleg_rad(&points[place]) / (station.md_m - stations[above].md_m)
        });
        let [north_m, east_m, tvd_m] = points[place].position_m.into();
        Row {
            md_m: station.md_m,
            inclination_rad: station.inclination_rad,
            azimuth_rad: station.azimuth_rad.rem_euclid(std::f64::consts::TAU),
            tvd_m,
            north_m,
            east_m,
            dogleg_severity_rad_per_m: severity,
        }
    });
    Ok(rows.collect())
}
