//! All modes of a chain from a frequency on, none left out.

use super::{
    chain::Chain,
    krylov::{Krylov, Ritz},
};

/// Tolerance of a mode's residual; the square of its angular frequency errs by the square of this.
const CONVERGED: f64 = 1e-7;

/// Modes that are looked for at a time.
const SLICE: usize = 16;

/// Steps between two looks.
const STEPS: usize = 3;

/// Vectors beyond so many for each mode that is wanted, and beyond a number for any, are too many.
const MOST_EACH: usize = 12;
const MOST: usize = 120;

/// Steps that find about where so many modes end.
const BISECTIONS: usize = 12;

/// Frequencies closer than this part of their square are one for the count.
const APART: f64 = 1e-7;

/// A real mode: of a chain that does not rotate.
#[derive(Debug, Clone)]
pub(super) struct RealMode {
    /// Square of its angular frequency, rad²/s².
    pub(super) lambda: f64,
    /// Its motion, six numbers a node, of unit modal mass.
    pub(super) motion: Vec<f64>,
}

/// The first `count` modes of a chain above a frequency, rad/s, by rising frequency; a few more
/// where frequencies coincide, fewer where there are no more. None where they were not found: as
/// shown by the count of Sylvester's law.
pub(super) fn above(chain: &Chain, omega: f64, count: usize) -> Option<Vec<RealMode>> {
    let mut found = Vec::new();
    let mut least = omega * omega;
    // A few at a time: the cost of orthogonalisation grows with the square of the number of
    // vectors.
    while found.len() < count {
        let slice_count = (count - found.len()).min(SLICE);
        let slice = slice(chain, least, slice_count)?;
        let whole = slice.modes.len() < slice_count;
        found.extend(slice.modes);
        least = slice.end;
        if whole {
            break;
        }
    }
    Some(found)
}

/// Some modes, and a square of angular frequency between the last and the next.
struct Slice {
    modes: Vec<RealMode>,
    end: f64,
}

fn slice(chain: &Chain, least: f64, count: usize) -> Option<Slice> {
    let below = chain.shifted(least).negative;
    let mut space = Krylov::new(chain, shift(chain, least, below, count), &[]);
    let freedoms = chain.freedoms();
    let most = (MOST + MOST_EACH * count).min(freedoms);
    loop {
        let mut fresh = true;
        for _ in 0..STEPS {
            fresh = space.extend();
        }
        let whole = !fresh || space.size() >= freedoms;
        let mut found = space.ritz();
        found.retain(|ritz| ritz.residual < CONVERGED && ritz.lambda > least);
        found.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
        // The last that is requested must be separated from the next, so that they can be counted.
        let clear = (count..=found.len()).find_map(|number| {
            let last = found[number - 1].lambda;
            let next = found.get(number).map_or(last * (1.0 + 2.0 * APART), |ritz| ritz.lambda);
            (next - last > APART * last).then_some((number, 0.5 * (last + next)))
        });
        let complete = clear
            .filter(|(number, between)| chain.shifted(*between).negative == below + number)
            .or((whole && found.len() == freedoms - below).then_some((found.len(), least)));
        if let Some((number, end)) = complete {
            let mode = |ritz: &Ritz| RealMode { lambda: ritz.lambda, motion: space.motion(ritz) };
            return Some(Slice { modes: found[..number].iter().map(mode).collect(), end });
        }
        if clear.is_some() || !fresh {
            // One is missing that the vectors so far have nothing of, or little.
            space.meet_chance();
        }
        if space.size() >= most && whole || space.size() > most {
            return None;
        }
    }
}

/// Shift of the search for this many modes: at the lowest, or among them where other modes are
/// below.
fn shift(chain: &Chain, least: f64, below: usize, count: usize) -> f64 {
    if below == 0 {
        return least;
    }
    let (mut low, mut high) = (least, 2.0 * least);
    for _ in 0..BISECTIONS {
        let inside = chain.shifted(high).negative - below;
        if inside < count {
            (low, high) = (high, high + 2.0 * (high - low));
        } else if inside > 2 * count {
            high = 0.5 * (low + high);
        } else {
            break;
        }
    }
    0.5 * (least + high)
}
