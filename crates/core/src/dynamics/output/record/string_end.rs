//! The ends of the string, where moment distribution takes one step more than elsewhere, because an
//! end that is free to turn has no moment.

use serde::{Deserialize, Serialize};

use super::{
    deflection::Ends,
    end_stiffness::EndStiffness,
    lane::{Lane, at, put},
    shape_block::Moments,
};
use crate::{
    dynamics::kernel::layout::Layout,
    simd::{
        lanes::DOUBLES,
        number::{Doubles, Real},
    },
};

/// Block and lane of an element, or of a node.
pub type Place = (usize, usize);

/// Where the top or the bit is free to tilt, the moment is released that the first or the last
/// element would have there if it were held, and carried over to its other end. The difference
/// between that end and the next element is then carried over to the next element's far end.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct StringEnd {
    /// Whether it is the top.
    pub is_upper: bool,
    /// The node at the string's end.
    node: Place,
    /// The first or last element; that of both regions has two places.
    pub own: Vec<CarryOver>,
    /// The same for the element next to it.
    pub next: Vec<CarryOver>,
}

/// Moment that an element carries over from one of its ends.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct CarryOver {
    element: Place,
    /// Whether it carries from its upper end.
    from_upper: bool,
    /// Part of that end's moment that stays there; all in the lanes of other elements.
    stays: Lane,
    /// Fraction carried over to the other end.
    carried: Lane,
    /// Loss at the middle.
    half_way: Lane,
}

impl StringEnd {
    /// Both ends of a string of so many elements.
    pub fn both(layout: Layout, elements: usize) -> Vec<Self> {
        let Some(last) = elements.checked_sub(1) else {
            return Vec::new();
        };
        let at = |index: Option<usize>, from_upper: bool| {
            let Some(index) = index.filter(|index| *index <= last) else {
                return Vec::new();
            };
            let twin = layout.shared().filter(|(shared, _)| *shared == index);
            let places = [Some(layout.place(index)), twin.map(|(_, place)| place)];
            places.into_iter().flatten().map(|place| CarryOver::none(place, from_upper)).collect()
        };
        let end = |is_upper: bool, node: usize, own: usize, next: Option<usize>| Self {
            is_upper,
            node: layout.place(node),
            own: at(Some(own), is_upper),
            next: at(next, is_upper),
        };
        vec![end(true, 0, 0, Some(1)), end(false, elements, last, last.checked_sub(1))]
    }

    /// Whether a stored one is of this layout.
    pub fn is_of(&self, layout: Layout) -> bool {
        let fits = |(block, lane): Place| block < layout.blocks() && lane < DOUBLES;
        fits(self.node) && self.carry_overs().all(|carry_over| fits(carry_over.element))
    }

    /// All that is carried over.
    pub fn carry_overs(&self) -> impl Iterator<Item = &CarryOver> {
        self.own.iter().chain(&self.next)
    }

    /// Whether nothing holds it from turning.
    pub fn is_free(&self, ends: &Ends<'_, impl Real>) -> bool {
        let (block, lane) = self.node;
        ends.tilts::<f64>(block, lane) > 0.0
    }

    /// Updates the rotational end stiffness of elements at lanes of a block. The first and the last
    /// element are less stiff at their other ends where they are free: three quarters without
    /// tension.
    #[cold]
    #[inline(always)]
    pub fn look<N: Doubles>(
        &mut self,
        ends: &Ends<'_, impl Real>,
        (block, lane): Place,
        stiffness: &EndStiffness<N>,
        held: &mut [N; 2],
    ) {
        let is_free = self.is_free(ends);
        let is_upper = self.is_upper;
        for carry_over in
            self.own.iter_mut().filter(|carry_over| carry_over.is_at::<N>(block, lane))
        {
            let mut here: Lane = [0.0; DOUBLES];
            here[carry_over.element.1] = f64::from(u8::from(is_free));
            carry_over.stays = here.map(|part| 1.0 - part);
            let here = at::<N, f64>(&here, lane);
            let carried = here * stiffness.carry_over();
            put(&mut carry_over.carried, lane, carried);
            let held_with = stiffness.held().max(N::splat(N::TINY));
            put(&mut carry_over.half_way, lane, here * stiffness.half_way / held_with);
            let other = &mut held[usize::from(is_upper)];
            *other = *other * (N::splat(1.0) - carried * carried);
        }
    }
}

impl CarryOver {
    fn none(element: Place, from_upper: bool) -> Self {
        let [none, all] = [0.0, 1.0].map(|part| [part; DOUBLES]);
        Self { element, from_upper, stays: all, carried: none, half_way: none }
    }

    /// Block of the element.
    pub fn block(&self) -> usize {
        self.element.0
    }

    /// Its lane.
    pub fn lane(&self) -> usize {
        self.element.1
    }

    /// Whether its element is at lanes of a block.
    #[inline(always)]
    pub fn is_at<N: Doubles>(&self, block: usize, lane: usize) -> bool {
        self.element.0 == block && (lane..lane + N::WIDTH).contains(&self.element.1)
    }

    /// Carries this fraction of the end's moment over, and leaves the end's own moment unchanged.
    pub fn carry_on(&mut self, part: f64) {
        self.carried[self.element.1] = part;
    }

    /// Carries moments over.
    #[inline(always)]
    pub fn act<N: Doubles>(&self, moments: &mut Moments<N>, lane: usize) {
        let Moments { upper, lower, half_way } = moments;
        let (own, other) = if self.from_upper { (upper, lower) } else { (lower, upper) };
        *other = *other + own.scaled(at(&self.carried, lane));
        *half_way = *half_way - own.scaled(at(&self.half_way, lane));
        *own = own.scaled(at(&self.stays, lane));
    }
}
