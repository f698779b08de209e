//! The hole's axis as a curve through survey stations.

use nalgebra::Vector3;
use serde::{Serialize, Serializer, ser::SerializeStruct};

use super::{
    Interpolation, Station,
    curve::{self, Piece},
    kick_off,
    station::angle_between,
    vertical::NearVertical,
};

/// Stations nearer than this are one station, m.
const MIN_SPACING_M: f64 = 1e-3;

/// Directions whose sum is shorter than this are opposite; the direction of the hole's turn is then
/// undefined.
const REVERSAL: f64 = 1e-6;

/// Below this sine of the inclination a point has no high side of its own.
const VERTICAL: f64 = 1e-9;

/// Position of the first station.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct TieIn {
    /// North of the first station, m.
    pub north_m: f64,
    /// East of the first station, m.
    pub east_m: f64,
    /// True vertical depth of the first station, m.
    pub tvd_m: f64,
}

impl TieIn {
    /// Farther than this from its origin a position is one of a map, m: 100 km.
    pub const MAP_M: f64 = 1e5;

    /// Whether north and east are coordinates of a map rather than distances from a slot.
    pub fn is_on_map(&self) -> bool {
        self.north_m.abs() > Self::MAP_M || self.east_m.abs() > Self::MAP_M
    }
}

/// A point of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Position: north, east, down, m.
    pub position_m: Vector3<f64>,
    /// Unit tangent, towards the bit.
    pub tangent: Vector3<f64>,
    /// Curvature vector, the derivative of the tangent along the path, 1/m.
    pub curvature_per_m: Vector3<f64>,
}

/// Direction and curvature of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Heading {
    /// Unit tangent, towards the bit.
    pub(crate) tangent: Vector3<f64>,
    /// Curvature vector, 1/m.
    pub(crate) curvature_per_m: Vector3<f64>,
}

impl PathPoint {
    /// Inclination from vertical, rad, 0 to π.
    pub fn inclination_rad(&self) -> f64 {
        libm::atan2(libm::hypot(self.tangent.x, self.tangent.y), self.tangent.z)
    }

    /// Azimuth from north, clockwise seen from above, rad, 0 to 2π; zero where the hole is
    /// vertical.
    pub fn azimuth_rad(&self) -> f64 {
        let azimuth = libm::atan2(self.tangent.y, self.tangent.x);
        if azimuth < 0.0 { azimuth + std::f64::consts::TAU } else { azimuth }
    }

    /// Dogleg between two points, rad: the angle between their directions, 0 to π.
    pub fn dogleg_rad(&self, other: &Self) -> f64 {
        angle_between(&self.tangent, &other.tangent)
    }

    /// High side: the unit vector across the hole that points up; `None` where the hole is vertical
    /// within 1e-9 rad. [`Path::high_side_at`] has an answer there too.
    pub fn high_side(&self) -> Option<Vector3<f64>> {
        high_side(&self.tangent)
    }

    /// Right side looking towards the bit with the high side up: tangent × high side.
    pub fn right_side(&self) -> Option<Vector3<f64>> {
        self.high_side().map(|high| self.tangent.cross(&high))
    }
}

/// Why stations make no path. Stations count from zero.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PathError {
    /// Fewer than two stations.
    #[error("a path needs at least two survey stations, got {0}")]
    TooFewStations(usize),
    /// A number that is NaN or infinite.
    #[error("the station at {md_m} m: {quantity} is not a finite number")]
    NotFinite {
        /// Which station.
        index: usize,
        /// Its measured depth, m.
        md_m: f64,
        /// Which of its numbers.
        quantity: &'static str,
    },
    /// The tie-in has a number that is NaN or infinite.
    #[error("the tie-in position is not finite")]
    TieInNotFinite,
    /// The measured depth does not grow, or by less than a millimetre.
    #[error(
        "the station at {md_m} m: measured depth must grow, but the station above is at \
         {previous_md_m} m"
    )]
    DepthNotIncreasing {
        /// Which station.
        index: usize,
        /// Its measured depth, m.
        md_m: f64,
        /// Measured depth of the station above, m.
        previous_md_m: f64,
    },
    /// An inclination below 0 or above π.
    #[error(
        "the station at {md_m} m: inclination {:.4} deg is not between 0 and 180 deg",
        inclination_rad.to_degrees()
    )]
    Inclination {
        /// Which station.
        index: usize,
        /// Its measured depth, m.
        md_m: f64,
        /// Its inclination, rad.
        inclination_rad: f64,
    },
    /// The hole points back along itself: no curve between the two stations is more likely than
    /// another.
    #[error(
        "the station at {md_m} m: the hole turns by 180 deg from the station above at \
         {previous_md_m} m"
    )]
    Reversal {
        /// Which station.
        index: usize,
        /// Its measured depth, m.
        md_m: f64,
        /// Measured depth of the station above, m.
        previous_md_m: f64,
    },
}

impl PathError {
    /// The station that it is about, counted from zero, where it is one.
    pub fn index(&self) -> Option<usize> {
        match self {
            Self::NotFinite { index, .. }
            | Self::DepthNotIncreasing { index, .. }
            | Self::Inclination { index, .. }
            | Self::Reversal { index, .. } => Some(*index),
            Self::TooFewStations(_) | Self::TieInNotFinite => None,
        }
    }
}

/// The hole's axis: position, direction and curvature at any measured depth.
///
/// Measured depth is the arc length, and at every station the direction is the survey's. Beyond the
/// last station, and above the first, the hole continues straight: surveys usually end some metres
/// above the bit, and may start below the surface.
///
/// ```
/// use wholestring::well::{Interpolation, Path, Station, TieIn};
///
/// let station = |md_m, inclination: f64| Station {
///     md_m,
///     inclination_rad: inclination.to_radians(),
///     azimuth_rad: 0.0,
/// };
/// let stations = [station(0.0, 0.0), station(300.0, 0.0), station(330.0, 3.0)];
/// let path = Path::new(&stations, Interpolation::Spline, TieIn::default())?;
/// assert!((path.at(300.0).position_m.z - 300.0).abs() < 1e-9);
/// assert!((path.at(350.0).inclination_rad().to_degrees() - 3.0).abs() < 1e-9);
///
/// let backwards = [station(330.0, 0.0), station(300.0, 3.0)];
/// assert_eq!(
///     Path::new(&backwards, Interpolation::Spline, TieIn::default()).unwrap_err().to_string(),
///     "the station at 300 m: measured depth must grow, but the station above is at 330 m"
/// );
/// # Ok::<(), wholestring::well::PathError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Path {
    stations: Vec<Station>,
    interpolation: Interpolation,
    pieces: Vec<Piece>,
    end: PathPoint,
    near_vertical: NearVertical,
}

/// Inputs of a path: stations, interpolation and tie-in. The rest follows from them.
impl Serialize for Path {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        // Every field is named: a new one either follows from these or is written.
        let Self { stations, interpolation, pieces: _, end: _, near_vertical: _ } = self;
        let mut path = to.serialize_struct("Path", 3)?;
        path.serialize_field("stations", stations)?;
        path.serialize_field("interpolation", interpolation)?;
        path.serialize_field("tie_in", &self.tie_in())?;
        path.end()
    }
}

impl Path {
    /// The curve through `stations` that begins at `tie_in`.
    ///
    /// # Errors
    /// Fewer than two stations, a number that is not finite, a measured depth that does not grow,
    /// an inclination outside 0 to π, or a reversal by π between two stations.
    pub fn new(
        stations: &[Station],
        interpolation: Interpolation,
        tie_in: TieIn,
    ) -> Result<Self, PathError> {
        check(stations)?;
        let start_m = Vector3::new(tie_in.north_m, tie_in.east_m, tie_in.tvd_m);
        if !start_m.iter().all(|number| number.is_finite()) {
            return Err(PathError::TieInNotFinite);
        }
        let pieces = curve::pieces(stations, interpolation, start_m);
        let last_md_m = stations[stations.len() - 1].md_m;
        let last = &pieces[pieces.len() - 1];
        let end = PathPoint {
            position_m: last.position_m(last_md_m - last.md_m),
            tangent: stations[stations.len() - 1].tangent(),
            curvature_per_m: Vector3::zeros(),
        };
        let near_vertical = NearVertical::find(&pieces, last_md_m);
        Ok(Self { stations: stations.to_vec(), interpolation, pieces, end, near_vertical })
    }

    /// The survey.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Interpolation of the curve between stations.
    pub fn interpolation(&self) -> Interpolation {
        self.interpolation
    }

    /// Position of the first station.
    pub fn tie_in(&self) -> TieIn {
        let start_m = self.pieces[0].position_m(0.0);
        TieIn { north_m: start_m.x, east_m: start_m.y, tvd_m: start_m.z }
    }

    /// Measured depth of the first station, m.
    pub fn first_md_m(&self) -> f64 {
        self.stations[0].md_m
    }

    /// Measured depth of the last station, m.
    pub fn last_md_m(&self) -> f64 {
        self.stations[self.stations.len() - 1].md_m
    }

    /// The point at a measured depth; straight on beyond the last station and above the first.
    ///
    /// At a jump of the curvature (a station of a minimum-curvature path) the value below it is
    /// returned.
    pub fn at(&self, md_m: f64) -> PathPoint {
        let beyond = md_m - self.last_md_m();
        if beyond >= 0.0 {
            let mut point = self.end;
            point.position_m += point.tangent * beyond;
            return point;
        }
        let above = md_m - self.first_md_m();
        if above < 0.0 {
            let tangent = self.stations[0].tangent();
            return PathPoint {
                position_m: self.pieces[0].position_m(0.0) + tangent * above,
                tangent,
                curvature_per_m: Vector3::zeros(),
            };
        }
        let piece = &self.pieces[self.piece_index(md_m)];
        let x = md_m - piece.md_m;
        let (tangent, curvature_per_m) = piece.heading(x);
        PathPoint { position_m: piece.position_m(x), tangent, curvature_per_m }
    }

    /// Tangent and curvature of [`Self::at`], without the position, which costs six times as much.
    pub(crate) fn heading_at(&self, md_m: f64) -> Heading {
        if md_m >= self.last_md_m() || md_m < self.first_md_m() {
            let PathPoint { tangent, curvature_per_m, .. } = self.at(md_m);
            return Heading { tangent, curvature_per_m };
        }
        let piece = &self.pieces[self.piece_index(md_m)];
        let (tangent, curvature_per_m) = piece.heading(md_m - piece.md_m);
        Heading { tangent, curvature_per_m }
    }

    /// The same at the end of a stretch in which the path has no kink: the limit from a measured
    /// depth in that stretch. Where the curvature jumps the two sides differ.
    pub(crate) fn heading_beside(&self, md_m: f64, inside_md_m: f64) -> Heading {
        if inside_md_m >= self.last_md_m() || inside_md_m < self.first_md_m() {
            let PathPoint { tangent, curvature_per_m, .. } = self.at(inside_md_m);
            return Heading { tangent, curvature_per_m };
        }
        let piece = &self.pieces[self.piece_index(inside_md_m)];
        let (tangent, curvature_per_m) = piece.heading(md_m - piece.md_m);
        Heading { tangent, curvature_per_m }
    }

    /// Measured depths where the curvature or its slope may jump, m, in no order: the stations, and
    /// of a spline the ends of its transitions besides.
    pub(crate) fn kinks_m(&self) -> impl Iterator<Item = f64> {
        let between = match self.interpolation {
            Interpolation::MinimumCurvature => [None; 2],
            Interpolation::Spline => [Some(curve::TRANSITION), Some(1.0 - curve::TRANSITION)],
        };
        let stations = self.stations.iter().map(|station| station.md_m);
        let inside = self.stations.windows(2).flat_map(move |pair| {
            let length_m = pair[1].md_m - pair[0].md_m;
            between.into_iter().flatten().map(move |part| pair[0].md_m + part * length_m)
        });
        stations.chain(inside)
    }

    /// Dogleg severity: the magnitude of the curvature, rad/m.
    pub fn dogleg_severity_rad_per_m(&self, md_m: f64) -> f64 {
        self.at(md_m).curvature_per_m.norm()
    }

    /// High side at any measured depth, continuous along the hole: a unit vector across it.
    ///
    /// In a hole inclined by more than 0.001 rad this is [`PathPoint::high_side`]. In a vertical
    /// part it keeps the bearing that it takes below (just under a kick-off the high side faces the
    /// way the hole deviates), or, down to the end of the well, the one that it had above; between
    /// two inclined parts its bearing turns evenly with depth from one to the other, the short way.
    /// In a wholly vertical well it is north.
    pub fn high_side_at(&self, md_m: f64) -> Vector3<f64> {
        self.high_side_of(md_m, &self.heading_at(md_m).tangent)
    }

    /// [`Self::high_side_at`] where the tangent is known already.
    pub(crate) fn high_side_of(&self, md_m: f64, tangent: &Vector3<f64>) -> Vector3<f64> {
        let bearing = match self.near_vertical.bearing_rad(md_m) {
            Some(bearing) => bearing,
            None => match high_side(tangent) {
                Some(high_side) => return high_side,
                None => 0.0,
            },
        };
        let across = Vector3::new(libm::cos(bearing), libm::sin(bearing), 0.0);
        (across - tangent * tangent.dot(&across)).normalize()
    }

    /// Measured depth of the kick-off, m: where the hole first leaves its straight course.
    ///
    /// Of the survey, thinned to stations at least 25 m apart, this takes the first station whose
    /// direction is more than 3° off the first one's, and goes up from there as long as each
    /// interval turns away at least a quarter as sharply as the one that crossed the 3°. So neither
    /// the wander of a nominally vertical hole nor a slow start of the build moves it far. A
    /// station left out counts again if the hole reaches it straight from there. `None` for a hole
    /// that stays within 3° of its first direction.
    pub fn kick_off_md_m(&self) -> Option<f64> {
        kick_off::kick_off_md_m(&self.stations)
    }

    /// Measured depth where the build that begins at the kick-off ends, m.
    ///
    /// Of the same thinned survey, the first station below the kick-off from which the inclination
    /// rises, over the next 90 m and over the next interval, by less than a quarter of the build's
    /// mean rate up to there, or a station left out above it, if the hole did not build between the
    /// two. `None` without a kick-off, or where the hole does not build at it.
    pub fn build_end_md_m(&self) -> Option<f64> {
        kick_off::build_end_md_m(&self.stations)
    }

    /// Index of the piece that holds `md_m`, the first one for depths above it.
    fn piece_index(&self, md_m: f64) -> usize {
        self.pieces.partition_point(|piece| piece.md_m <= md_m).saturating_sub(1)
    }
}

/// The unit vector across a direction that points up; none where it is vertical.
fn high_side(tangent: &Vector3<f64>) -> Option<Vector3<f64>> {
    let t = tangent;
    let sin_inc = libm::hypot(t.x, t.y);
    (sin_inc > VERTICAL).then(|| Vector3::new(t.z * t.x / sin_inc, t.z * t.y / sin_inc, -sin_inc))
}

fn check(stations: &[Station]) -> Result<(), PathError> {
    if stations.len() < 2 {
        return Err(PathError::TooFewStations(stations.len()));
    }
    for (index, station) in stations.iter().enumerate() {
        let md_m = station.md_m;
        for (number, quantity) in [
            (md_m, "measured depth"),
            (station.inclination_rad, "inclination"),
            (station.azimuth_rad, "azimuth"),
        ] {
            if !number.is_finite() {
                return Err(PathError::NotFinite { index, md_m, quantity });
            }
        }
        // Half a circle in degrees, converted, may come out a rounding error above π.
        if !(0.0..=std::f64::consts::PI + 1e-12).contains(&station.inclination_rad) {
            return Err(PathError::Inclination {
                index,
                md_m,
                inclination_rad: station.inclination_rad,
            });
        }
        let Some(previous) = index.checked_sub(1).map(|above| &stations[above]) else {
            continue;
        };
        if md_m - previous.md_m < MIN_SPACING_M {
            return Err(PathError::DepthNotIncreasing {
                index,
                md_m,
                previous_md_m: previous.md_m,
            });
        }
        if (station.tangent() + previous.tangent()).norm() < REVERSAL {
            return Err(PathError::Reversal { index, md_m, previous_md_m: previous.md_m });
        }
    }
    Ok(())
}
