//! All pictures of a static BHA analysis.

use super::{Bha, bending, sweeps, varied::Varied, views};
use crate::{Plot, plots::DisplayUnits};

/// Returns every picture of an assembly, in a set of units (`si`, `metric` or `field`): `views`
/// (from the side and from above), `bending` (moment and stress), and a picture of each varied
/// quantity (`toolface`, `weight`, `inclination`); none where nothing was solved.
pub fn bha_plots(bha: &Bha, units: &str) -> Vec<Plot> {
    let display = DisplayUnits::new(&bha.head.dimensions, units);
    if bha.nodes.from_bit_m.len() < 2 {
        return Vec::new();
    }
    let plot = |name: &str, figure| Plot { name: name.into(), figure };
    let mut plots = vec![
        plot("views", views::figure(bha, display)),
        plot("bending", bending::figure(bha, display)),
    ];
    let picture = |varied: Varied<'_>| plot(varied.name, sweeps::figure(bha, &varied, display));
    plots.extend(bha.varied().map(picture));
    plots
}
