//! Turns of a survey that pipe does not follow, and stations that are probably slips.

use super::{Station, station::angle_between};

/// Shortest length over which a turn is averaged, m: a joint of range-2 pipe. Over less the pipe, which touches the wall at
/// its tool joints, does not bend as sharply as the hole: a whipstock turns by 3 deg within 6 m.
const JOINT_M: f64 = 9.6;

/// Bending stress that the steel of drill pipe endures any number of times, Pa: 20 000 psi (API RP 7G).
const ENDURED_STRESS_PA: f64 = 137.9e6;

/// Young's modulus of steel, Pa.
const STEEL_PA: f64 = 206.84e9;

/// Dogleg severity above and below a station beyond which a turn and its way back are doubted, rad/m: 6 deg/30 m. Where a
/// surveyed hole turns back, in a survey with a station every 3 m, 3.9 deg/30 m were measured over a joint.
const TURNED_BACK_RAD_PER_M: f64 = 0.2 * std::f64::consts::PI / 180.0;

/// Stations of a survey are no farther apart than this, m; farther apart a hole may turn there and back.
const SURVEYED_M: f64 = 200.0;

/// In a hole that hardly turns otherwise a turn and its way back are doubted from this angle on, rad: 3 deg.
const ALONE_RAD: f64 = 3.0 * std::f64::consts::PI / 180.0;

/// A hole hardly turns where its dogleg severity is less than this part of that of the turn and its way back, over two
/// intervals above and two below.
const QUIET: f64 = 0.25;
const QUIET_INTERVALS: usize = 2;

/// The hole turns back where from neighbour to neighbour it turns by less than this part of the two turns.
const BACK: f64 = 0.5;

/// Dogleg severity up to which a turn is not doubted where nothing is known of the pipe, rad/m: 15 deg/30 m, at which pipe of
/// 5-7/8 in is bent to the stress that its steel endures.
pub const USUAL_DOGLEG_RAD_PER_M: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// A turn of a survey that is hardly the hole's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DoubtfulTurn {
    /// The hole turns away at one station and back below it: its inclination or azimuth is probably wrong.
    Slip {
        /// The station, counted from 0.
        index: usize,
        /// Dogleg severity above it, rad/m.
        above_rad_per_m: f64,
        /// Dogleg severity below it, rad/m.
        below_rad_per_m: f64,
        /// Station at that depth on the arc from its upper neighbour to its lower one.
        expected: Station,
    },
    /// The hole turns more sharply than pipe that rotates in it endures.
    Sharp {
        /// The station above the first such turn, counted from 0.
        first: usize,
        /// The station below the last one.
        last: usize,
        /// The station below the sharpest one.
        sharpest: usize,
        /// Dogleg severity there, rad/m.
        severity_rad_per_m: f64,
    },
}

impl DoubtfulTurn {
    /// The station at which it is pointed out, counted from 0.
    pub fn index(&self) -> usize {
        match *self {
            Self::Slip { index, .. } => index,
            Self::Sharp { sharpest, .. } => sharpest,
        }
    }
}

/// Dogleg severity at which pipe of this outside diameter, m, is bent to the stress that its steel endures, rad/m; never less
/// than [`USUAL_DOGLEG_RAD_PER_M`].
pub fn endured_dogleg_rad_per_m(od_m: f64) -> f64 {
    (2.0 * ENDURED_STRESS_PA / (STEEL_PA * od_m)).max(USUAL_DOGLEG_RAD_PER_M)
}

/// The turns of a survey that are to be doubted, down the hole: sharper than `endured_rad_per_m`, or there and back at one
/// station. Stations whose depths do not grow have none.
pub fn doubtful_turns(stations: &[Station], endured_rad_per_m: f64) -> Vec<DoubtfulTurn> {
    // Each the turn above a station: its angle, its length, and its severity over a joint at least.
    let turns: Vec<(f64, f64, f64)> = stations
        .windows(2)
        .map(|pair| {
            let (turn_rad, length_m) = (pair[0].dogleg_rad(&pair[1]), pair[1].md_m - pair[0].md_m);
            match length_m > 0.0 && turn_rad.is_finite() {
                true => (turn_rad, length_m, turn_rad / length_m.max(JOINT_M)),
                false => (0.0, 1.0, 0.0),
            }
        })
        .collect();
    let mut doubts = Vec::new();
    let mut explained = vec![false; turns.len()];
    for (index, pair) in turns.windows(2).enumerate() {
        let (above, below) = (pair[0], pair[1]);
        let (upper, station, lower) =
            (&stations[index], &stations[index + 1], &stations[index + 2]);
        let turns_back = upper.dogleg_rad(lower) < BACK * (above.0 + below.0);
        let is_sharp = above.2.min(below.2) > TURNED_BACK_RAD_PER_M;
        if turns_back && (is_sharp || is_alone(&turns, index)) {
            (explained[index], explained[index + 1]) = (true, true);
            doubts.push(DoubtfulTurn::Slip {
                index: index + 1,
                above_rad_per_m: above.0 / above.1,
                below_rad_per_m: below.0 / below.1,
                expected: between(upper, lower, station.md_m),
            });
        }
    }
    let is_sharp = |at: usize| !explained[at] && turns[at].2 > endured_rad_per_m;
    let mut at = 0;
    while at < turns.len() {
        if !is_sharp(at) {
            at += 1;
            continue;
        }
        let first = at;
        while at < turns.len() && is_sharp(at) {
            at += 1;
        }
        let sharpest = (first..at).max_by(|a, b| turns[*a].2.total_cmp(&turns[*b].2));
        let sharpest = sharpest.unwrap_or(first);
        doubts.push(DoubtfulTurn::Sharp {
            first,
            last: at,
            sharpest: sharpest + 1,
            severity_rad_per_m: turns[sharpest].0 / turns[sharpest].1,
        });
    }
    doubts.sort_by_key(DoubtfulTurn::index);
    doubts
}

/// Whether the turn above a station, of this index, and the one below it are the only ones far and wide, in a survey.
fn is_alone(turns: &[(f64, f64, f64)], above: usize) -> bool {
    let (first, last) = (above.wrapping_sub(QUIET_INTERVALS), above + 1 + QUIET_INTERVALS);
    let (Some(before), Some(after), Some(pair)) =
        (turns.get(first..above), turns.get(above + 2..=last), turns.get(above..above + 2))
    else {
        return false;
    };
    let least = pair[0].2.min(pair[1].2);
    pair.iter().all(|turn| turn.0 > ALONE_RAD && turn.1 <= SURVEYED_M)
        && before.iter().chain(after).all(|turn| turn.2 < QUIET * least && turn.1 <= SURVEYED_M)
}

/// The station at a depth on the arc from one station to another.
fn between(upper: &Station, lower: &Station, md_m: f64) -> Station {
    let (from, to) = (upper.tangent(), lower.tangent());
    let angle = angle_between(&from, &to);
    let share = (md_m - upper.md_m) / (lower.md_m - upper.md_m);
    let direction = match libm::sin(angle) > 1e-9 {
        true => from * libm::sin((1.0 - share) * angle) + to * libm::sin(share * angle),
        false => from,
    };
    let azimuth_rad = libm::atan2(direction.y, direction.x);
    Station {
        md_m,
        inclination_rad: libm::atan2(libm::hypot(direction.x, direction.y), direction.z),
        azimuth_rad: if azimuth_rad < 0.0 {
            azimuth_rad + std::f64::consts::TAU
        } else {
            azimuth_rad
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn survey(rows: &[[f64; 3]]) -> Vec<Station> {
        let station = |&[md_m, inc, azi]: &[f64; 3]| Station {
            md_m,
            inclination_rad: inc.to_radians(),
            azimuth_rad: azi.to_radians(),
        };
        rows.iter().map(station).collect()
    }

    const PER_30_M: f64 = 180.0 / std::f64::consts::PI * 30.0;

    /// A slipped decimal point between 40 and 41 deg: the angles between the directions by hand, 35.9 and 36.9 deg.
    #[test]
    fn a_slip_is_named_with_what_its_neighbours_make_of_it() {
        let rows =
            [[1200.0, 40.0, 44.0], [1230.0, 4.1, 44.0], [1260.0, 41.0, 44.0], [3000.0, 41.0, 44.0]];
        let doubts = doubtful_turns(&survey(&rows), USUAL_DOGLEG_RAD_PER_M);
        let [DoubtfulTurn::Slip { index, above_rad_per_m, below_rad_per_m, expected }] = doubts[..]
        else {
            panic!("{doubts:?}");
        };
        assert_eq!(index, 1);
        assert!((above_rad_per_m * PER_30_M - 35.9).abs() < 1e-9);
        assert!((below_rad_per_m * PER_30_M - 36.9).abs() < 1e-9);
        assert!((expected.inclination_rad.to_degrees() - 40.5).abs() < 1e-9);
        assert!((expected.azimuth_rad.to_degrees() - 44.0).abs() < 1e-9);
    }

    /// Two digits of an azimuth exchanged, 244 for 224 at 40 deg: each side turns by 12.8 deg.
    #[test]
    fn a_slip_of_the_azimuth_is_one_too() {
        let rows = [[0.0, 40.0, 224.0], [30.0, 40.0, 244.0], [60.0, 40.0, 224.0]];
        let doubts = doubtful_turns(&survey(&rows), USUAL_DOGLEG_RAD_PER_M);
        assert!(matches!(doubts[..], [DoubtfulTurn::Slip { index: 1, .. }]), "{doubts:?}");
    }

    /// Stations 128 m apart in a tangent, one of which reads 87.92 deg for 77.92: 2.3 deg/30 m above and below it, where the
    /// others have 0.3 at most. A plan of few stations may turn there and back.
    #[test]
    fn a_slip_in_a_straight_part_is_found_between_far_stations() {
        let rows = [
            [5718.1, 78.35, 94.6],
            [5846.1, 77.99, 94.08],
            [5974.1, 78.13, 95.47],
            [6102.1, 87.92, 95.43],
            [6230.1, 78.45, 94.98],
            [6358.1, 78.2, 95.03],
            [6486.2, 77.98, 94.9],
        ];
        let doubts = doubtful_turns(&survey(&rows), USUAL_DOGLEG_RAD_PER_M);
        assert!(matches!(doubts[..], [DoubtfulTurn::Slip { index: 3, .. }]), "{doubts:?}");
        let plan = [
            [0.0, 0.0, 0.0],
            [500.0, 0.0, 0.0],
            [1000.0, 0.0, 0.0],
            [1600.0, 40.0, 0.0],
            [2200.0, 0.0, 0.0],
            [2700.0, 0.0, 0.0],
            [3000.0, 0.0, 0.0],
        ];
        assert_eq!(doubtful_turns(&survey(&plan), USUAL_DOGLEG_RAD_PER_M), []);
    }

    /// A whipstock of 3.2 deg within 6.1 m, a build of 9.1 deg/30 m and one of 14 deg/30 m are holes.
    #[test]
    fn common_holes_are_not_doubted() {
        let rows = [
            [2743.2, 40.0, 120.0],
            [2749.3, 42.5, 123.0],
            [2758.4, 44.0, 124.0],
            [2910.8, 90.0, 130.0],
            [2970.8, 90.0, 158.0],
        ];
        assert_eq!(doubtful_turns(&survey(&rows), USUAL_DOGLEG_RAD_PER_M), []);
    }

    #[test]
    fn a_stretch_of_sharp_turns_is_one() {
        let rows = [
            [500.0, 0.0, 0.0],
            [515.0, 15.0, 0.0],
            [530.0, 31.0, 0.0],
            [545.0, 46.0, 0.0],
            [700.0, 46.0, 0.0],
        ];
        let doubts = doubtful_turns(&survey(&rows), USUAL_DOGLEG_RAD_PER_M);
        let [DoubtfulTurn::Sharp { first: 0, last: 3, sharpest: 2, severity_rad_per_m }] =
            doubts[..]
        else {
            panic!("{doubts:?}");
        };
        assert!((severity_rad_per_m * PER_30_M - 32.0).abs() < 1e-9);
        // Pipe of 2-3/8 in endures 38 deg/30 m.
        assert_eq!(doubtful_turns(&survey(&rows), endured_dogleg_rad_per_m(0.060325)), []);
    }

    /// By the formula of a bent beam, stress = E d/2 times the curvature: 18.0 deg/30 m for pipe of 5 in.
    #[test]
    fn thick_pipe_endures_less() {
        assert!((endured_dogleg_rad_per_m(0.127) * PER_30_M - 18.05).abs() < 0.01);
        assert_eq!(endured_dogleg_rad_per_m(0.168275), USUAL_DOGLEG_RAD_PER_M);
    }
}
