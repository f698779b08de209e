//! All modes of a chain from a frequency on, none left out.

use super::{
    chain::Chain,
    krylov::{Krylov, Ritz},
};

/// What may be left over of a mode; the square of its angular frequency errs by the square of this.
const CONVERGED: f64 = 1e-7;

/// Steps between two looks.
const STEPS: usize = 3;

/// Vectors beyond so many for each mode that is wanted, and beyond a number for any, are too many.
const MOST_EACH: usize = 12;
const MOST: usize = 120;

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
/// where frequencies coincide, fewer where there are no more. None where they were not found:
/// the count of Sylvester's law says so.
pub(super) fn above(chain: &Chain, omega: f64, count: usize) -> Option<Vec<RealMode>> {
    let mut space = Krylov::new(chain, omega * omega, &[]);
    let below = space.below();
    let freedoms = chain.freedoms();
    let most = (MOST + MOST_EACH * count).min(freedoms);
    loop {
        let mut fresh = true;
        for _ in 0..STEPS {
            fresh = space.extend();
        }
        let whole = !fresh || space.size() >= freedoms;
        let found: Vec<Ritz> =
            space.ritz().into_iter().filter(|of| of.lambda > space.shift).collect();
        let sure = found.iter().take_while(|of| of.residual < CONVERGED).count();
        // The last that is wanted must stand clear of the next, so that they can be counted.
        let clear = (count..=sure).find(|number| {
            let (Some(last), Some(next)) = (found.get(number - 1), found.get(*number)) else {
                return false;
            };
            *number < sure && next.lambda - last.lambda > APART * last.lambda
        });
        let complete = clear.filter(|number| {
            let between = 0.5 * (found[number - 1].lambda + found[*number].lambda);
            chain.shifted(between).negative == below + number
        });
        let complete = complete.or((whole && sure == freedoms - below).then_some(sure));
        if let Some(number) = complete {
            let mode = |of: &Ritz| RealMode { lambda: of.lambda, motion: space.motion(of) };
            return Some(found[..number].iter().map(mode).collect());
        }
        if clear.is_some() || !fresh {
            // One is missing that the vectors so far have nothing of.
            space.meet_chance();
        }
        if space.size() >= most && whole || space.size() > most {
            return None;
        }
    }
}
