//! A drawing as PNG.

use tiny_skia::{
    Color, FillRule, FilterQuality, LineJoin, Mask, Paint, PathBuilder, Pixmap, PixmapPaint,
    PixmapRef, Rect, Shader, Stroke, StrokeDash, Transform,
};

use super::{
    Anchor, Box, Drawing, Image, Ink, Pen,
    drawing::Item,
    font::{self, HALF_CAPITAL, text_width},
};

impl Drawing {
    /// Returns the drawing as the bytes of a PNG file, with this many dots per inch.
    ///
    /// # Panics
    /// If `dots_per_inch` is not above zero, or makes a picture of more pixels than memory has.
    pub fn png(&self, dots_per_inch: f64) -> Vec<u8> {
        let scale = dots_per_inch / 72.0;
        let pixels = |points: f64| (points * scale).ceil() as u32;
        let mut page =
            Pixmap::new(pixels(self.width), pixels(self.height)).expect("a picture of some size");
        page.fill(Color::WHITE);
        let transform = Transform::from_scale(scale as f32, scale as f32);
        let mut mask = Clipping::default();
        for item in &self.items {
            match item {
                Item::Path { lines, closed, fill, pen, clip } => {
                    let mut path = PathBuilder::new();
                    for line in lines {
                        for (i, (x, y)) in line.iter().enumerate() {
                            let (x, y) = (*x as f32, *y as f32);
                            if i == 0 {
                                path.move_to(x, y);
                            } else {
                                path.line_to(x, y);
                            }
                        }
                        if *closed {
                            path.close();
                        }
                    }
                    let Some(path) = path.finish() else { continue };
                    let clip = mask.of(*clip, &page, transform);
                    if let Some((ink, opacity)) = fill {
                        let paint = paint(*ink, *opacity);
                        page.fill_path(&path, &paint, FillRule::Winding, transform, clip);
                    }
                    if let Some(pen) = pen {
                        let paint = paint(pen.ink, 1.0);
                        page.stroke_path(&path, &paint, &stroke(pen), transform, clip);
                    }
                }
                Item::Text { text, at: (x, y), size, ink, anchor, upright } => {
                    let left = match anchor {
                        Anchor::Start => 0.0,
                        Anchor::Middle => -0.5 * text_width(text, *size),
                        Anchor::End => -text_width(text, *size),
                    };
                    let angle = if *upright { -90.0 } else { 0.0 };
                    let place = transform
                        .pre_translate(*x as f32, *y as f32)
                        .pre_concat(Transform::from_rotate(angle))
                        .pre_translate(left as f32, (HALF_CAPITAL * size) as f32)
                        .pre_scale(*size as f32, -*size as f32);
                    if let Some(path) = letters(text) {
                        page.fill_path(&path, &paint(*ink, 1.0), FillRule::Winding, place, None);
                    }
                }
                Item::Begin { .. } | Item::End | Item::Spots(_) => {}
                Item::Image { image, place } => {
                    let pixels = pixmap(image);
                    let across = place.width / f64::from(pixels.width());
                    let down = place.height / f64::from(pixels.height());
                    page.draw_pixmap(
                        0,
                        0,
                        PixmapRef::from_bytes(pixels.data(), pixels.width(), pixels.height())
                            .expect("its own bytes"),
                        &PixmapPaint { quality: FilterQuality::Nearest, ..PixmapPaint::default() },
                        transform
                            .pre_translate(place.left as f32, place.top as f32)
                            .pre_scale(across as f32, down as f32),
                        None,
                    );
                }
            }
        }
        page.encode_png().expect("memory takes every byte")
    }
}

/// The bytes of an image as a PNG file.
pub(super) fn encoded(image: &Image) -> Vec<u8> {
    pixmap(image).encode_png().expect("memory takes every byte")
}

fn pixmap(image: &Image) -> Pixmap {
    let rows = image.pixels.len() / image.columns;
    let mut pixmap =
        Pixmap::new(image.columns as u32, rows as u32).expect("a picture of some size");
    for (to, pixel) in pixmap.data_mut().chunks_exact_mut(4).zip(&image.pixels) {
        if let Some([r, g, b]) = pixel {
            to.copy_from_slice(&[*r, *g, *b, 255]);
        }
    }
    pixmap
}

fn paint(ink: Ink, opacity: f64) -> Paint<'static> {
    let [r, g, b] = ink.rgb();
    Paint {
        shader: Shader::SolidColor(Color::from_rgba8(r, g, b, (255.0 * opacity).round() as u8)),
        anti_alias: true,
        ..Paint::default()
    }
}

fn stroke(pen: &Pen) -> Stroke {
    Stroke {
        width: pen.width as f32,
        line_join: LineJoin::Round,
        dash: pen
            .dash
            .and_then(|dash| StrokeDash::new(dash.map(|length| length as f32).to_vec(), 0.0)),
        ..Stroke::default()
    }
}

/// The outline of a text of size one, y up.
fn letters(text: &str) -> Option<tiny_skia::Path> {
    let mut path = PathBuilder::new();
    let point = |(x, y): (f64, f64)| (x as f32, y as f32);
    font::outline(text, &mut |stroke| match stroke {
        font::Stroke::Move(at) => {
            let (x, y) = point(at);
            path.move_to(x, y);
        }
        font::Stroke::Line(at) => {
            let (x, y) = point(at);
            path.line_to(x, y);
        }
        font::Stroke::Quadratic(by, at) => {
            let ((x1, y1), (x, y)) = (point(by), point(at));
            path.quad_to(x1, y1, x, y);
        }
        font::Stroke::Close => path.close(),
    });
    path.finish()
}

/// The mask of the rectangle of the last clipping.
#[derive(Default)]
struct Clipping {
    made: Option<(Box, Mask)>,
}

impl Clipping {
    fn of(&mut self, edges: Option<Box>, page: &Pixmap, transform: Transform) -> Option<&Mask> {
        let edges = edges?;
        if self.made.as_ref().is_none_or(|(made, _)| *made != edges) {
            let mut mask = Mask::new(page.width(), page.height())?;
            let rect = Rect::from_xywh(
                edges.left as f32,
                edges.top as f32,
                edges.width as f32,
                edges.height as f32,
            )?;
            let path = PathBuilder::from_rect(rect);
            mask.fill_path(&path, FillRule::Winding, true, transform);
            self.made = Some((edges, mask));
        }
        self.made.as_ref().map(|(_, mask)| mask)
    }
}
