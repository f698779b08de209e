//! Contents of a page, before it is written as SVG or painted as PNG.

use super::Ink;

/// A finished picture: it can be written as SVG, or painted as PNG.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// Description for readers who cannot see it.
    pub(super) title: String,
    /// Its size, points.
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) items: Vec<Item>,
    /// Rectangle at whose edges drawing is cut off.
    clip: Option<Box>,
}

/// A rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Box {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Box {
    pub(crate) fn right(&self) -> f64 {
        self.left + self.width
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.top + self.height
    }

    pub(crate) fn corners(&self) -> [(f64, f64); 4] {
        let (right, bottom) = (self.right(), self.bottom());
        [(self.left, self.top), (right, self.top), (right, bottom), (self.left, bottom)]
    }
}

/// Properties of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pen {
    pub(crate) ink: Ink,
    /// Points.
    pub(crate) width: f64,
    /// Lengths of dash and gap; `None` for a full line.
    pub(crate) dash: Option<[f64; 2]>,
}

impl Pen {
    /// A full line.
    pub(crate) fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, dash: None }
    }
}

/// Side of its place on which a text is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// An image of pixels, row after row from the top; `None` where it is transparent.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Image {
    pub(crate) columns: usize,
    pub(crate) pixels: Vec<Option<[u8; 3]>>,
}

#[derive(Debug, Clone)]
pub(super) enum Item {
    Path {
        lines: Vec<Vec<(f64, f64)>>,
        closed: bool,
        /// Colour and opacity.
        fill: Option<(Ink, f64)>,
        pen: Option<Pen>,
        clip: Option<Box>,
    },
    Text {
        text: String,
        /// The place of its middle in height.
        at: (f64, f64),
        size: f64,
        ink: Ink,
        anchor: Anchor,
        /// Whether it reads from the bottom up.
        upright: bool,
    },
    Image {
        image: Image,
        place: Box,
    },
    /// The following items, up to the end, belong to these keys of the legend, or are a key of the
    /// legend themselves. For pages.
    Begin {
        keys: Vec<usize>,
        of_legend: bool,
    },
    End,
    /// Points that show rows of a table, each with its row. For pages.
    Spots(Vec<((f64, f64), usize)>),
}

impl Drawing {
    /// A blank page.
    pub(crate) fn new(title: &str, width: f64, height: f64) -> Self {
        Self { title: title.to_owned(), width, height, items: Vec::new(), clip: None }
    }

    /// Width and height, points.
    pub fn size(&self) -> (f64, f64) {
        (self.width, self.height)
    }

    /// Draws with everything cut off at the edges of a rectangle.
    pub(crate) fn within(&mut self, edges: Box, draw: impl FnOnce(&mut Self)) {
        self.clip = Some(edges);
        draw(self);
        self.clip = None;
    }

    pub(crate) fn line(&mut self, points: &[(f64, f64)], pen: Pen) {
        self.path(vec![points.to_vec()], false, None, Some(pen));
    }

    pub(crate) fn frame(&mut self, edges: Box, pen: Pen) {
        self.path(vec![edges.corners().to_vec()], true, None, Some(pen));
    }

    /// Fills an area with this opacity.
    pub(crate) fn fill(&mut self, corners: Vec<(f64, f64)>, ink: Ink, opacity: f64) {
        self.path(vec![corners], true, Some((ink, opacity)), None);
    }

    pub(crate) fn path(
        &mut self,
        lines: Vec<Vec<(f64, f64)>>,
        closed: bool,
        fill: Option<(Ink, f64)>,
        pen: Option<Pen>,
    ) {
        let clip = self.clip;
        self.items.push(Item::Path { lines, closed, fill, pen, clip });
    }

    pub(crate) fn text(&mut self, text: &str, at: (f64, f64), size: f64, ink: Ink, anchor: Anchor) {
        self.items.push(Item::Text {
            text: text.to_owned(),
            at,
            size,
            ink,
            anchor,
            upright: false,
        });
    }

    /// Text that reads from the bottom up, centred on its place.
    pub(crate) fn upright(&mut self, text: &str, at: (f64, f64), size: f64, ink: Ink) {
        self.items.push(Item::Text {
            text: text.to_owned(),
            at,
            size,
            ink,
            anchor: Anchor::Middle,
            upright: true,
        });
    }

    /// Begins items, up to [`Self::end`], that belong to these keys of the legend, or are one.
    pub(crate) fn begin(&mut self, keys: &[usize], of_legend: bool) {
        self.items.push(Item::Begin { keys: keys.to_vec(), of_legend });
    }

    pub(crate) fn end(&mut self) {
        self.items.push(Item::End);
    }

    /// Points that show rows of a table, each with its row.
    pub(crate) fn spots(&mut self, spots: Vec<((f64, f64), usize)>) {
        self.items.push(Item::Spots(spots));
    }

    pub(crate) fn image(&mut self, image: Image, place: Box) {
        self.items.push(Item::Image { image, place });
    }
}
