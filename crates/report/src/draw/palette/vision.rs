//! Difference of two colours to eyes of every kind, and their contrast.

use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];
type Matrix = [Vector; 3];

/// Eyes with all cones, and without those for long, middle and short waves: matrices for linear
/// sRGB at severity 1 of Machado, Oliveira and Fernandes, "A physiologically-based model for
/// simulation of color vision deficiency", IEEE Transactions on Visualization and Computer Graphics
/// 15(6), 2009.
const EYES: [Matrix; 4] = [
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
];

/// Linear sRGB to CIE XYZ (IEC 61966-2-1).
const XYZ: Matrix = [
    [0.412_456_4, 0.357_576_1, 0.180_437_5],
    [0.212_672_9, 0.715_152_2, 0.072_175_0],
    [0.019_333_9, 0.119_192_0, 0.950_304_1],
];

fn times(matrix: &Matrix, vector: Vector) -> Vector {
    matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
}

fn linear(rgb: [u8; 3]) -> Vector {
    rgb.map(|channel| {
        let value = f64::from(channel) / 255.0;
        if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    })
}

/// CIE L*a*b* of a colour in linear sRGB, against the white of the same space.
fn lab(linear: Vector) -> Vector {
    let white = XYZ.map(|row| row.iter().sum::<f64>());
    let xyz = times(&XYZ, linear.map(|value| value.clamp(0.0, 1.0)));
    let [x, y, z] = std::array::from_fn(|i| {
        let part: f64 = xyz[i] / white[i];
        if part > 216.0 / 24_389.0 { part.cbrt() } else { (24_389.0 / 27.0 * part + 16.0) / 116.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// The least difference, of CIEDE2000, that any kind of eye sees.
pub(super) fn min_difference(a: [u8; 3], b: [u8; 3]) -> f64 {
    let seen = |eye: &Matrix, rgb| lab(times(eye, linear(rgb)));
    let differences = EYES.iter().map(|eye| ciede2000(seen(eye, a), seen(eye, b)));
    differences.fold(f64::INFINITY, f64::min)
}

/// Contrast of two colours as WCAG 2.2 defines it.
pub(super) fn contrast(a: [u8; 3], b: [u8; 3]) -> f64 {
    let light = |rgb| {
        let [red, green, blue] = linear(rgb);
        0.05 + 0.2126 * red + 0.7152 * green + 0.0722 * blue
    };
    let (a, b) = (light(a), light(b));
    a.max(b) / a.min(b)
}

/// The difference of two colours: Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula",
/// Color Research and Application 30(1), 2005, with its numbers of equations.
fn ciede2000([l1, a1, b1]: Vector, [l2, a2, b2]: Vector) -> f64 {
    let seventh = |chroma: f64| (chroma.powi(7) / (chroma.powi(7) + 25_f64.powi(7))).sqrt();
    // (2) to (7)
    let g = 0.5 * (1.0 - seventh(0.5 * (a1.hypot(b1) + a2.hypot(b2))));
    let (a1, a2) = ((1.0 + g) * a1, (1.0 + g) * a2);
    let (c1, c2) = (a1.hypot(b1), a2.hypot(b2));
    let (h1, h2) = (b1.atan2(a1).rem_euclid(TAU), b2.atan2(a2).rem_euclid(TAU));
    // (8) to (11)
    let grey = c1 * c2 == 0.0;
    let turn = match h2 - h1 {
        _ if grey => 0.0,
        turn if turn > PI => turn - TAU,
        turn if turn < -PI => turn + TAU,
        turn => turn,
    };
    let hue = 2.0 * (c1 * c2).sqrt() * (0.5 * turn).sin();
    // (12) to (14)
    let (l, c) = (0.5 * (l1 + l2), 0.5 * (c1 + c2));
    let h = match h1 + h2 {
        sum if grey => sum,
        sum if (h1 - h2).abs() <= PI => 0.5 * sum,
        sum if sum < TAU => 0.5 * (sum + TAU),
        sum => 0.5 * (sum - TAU),
    };
    // (15) to (22)
    let degrees = f64::to_radians;
    let t = 1.0 - 0.17 * (h - degrees(30.0)).cos()
        + 0.24 * (2.0 * h).cos()
        + 0.32 * (3.0 * h + degrees(6.0)).cos()
        - 0.20 * (4.0 * h - degrees(63.0)).cos();
    let off = (l - 50.0).powi(2);
    let s_l = 1.0 + 0.015 * off / (20.0 + off).sqrt();
    let s_c = 1.0 + 0.045 * c;
    let s_h = 1.0 + 0.015 * c * t;
    let around = ((h.to_degrees() - 275.0) / 25.0).powi(2);
    let r = -2.0 * seventh(c) * degrees(60.0 * (-around).exp()).sin();
    let (l, c, h) = ((l2 - l1) / s_l, (c2 - c1) / s_c, hue / s_h);
    (l * l + c * c + h * h + r * c * h).sqrt()
}

/// Pairs 1, 7, 17, 20 and 31 of table 1 of the article, which prints four decimals.
#[test]
fn the_difference_is_that_of_its_authors() {
    for (a, b, expected) in [
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
        ([50.0, 2.5, 0.0], [58.0, 24.0, 15.0], 19.4535),
        ([22.7233, 20.0904, -46.694], [23.0331, 14.9730, -42.5619], 2.0373),
    ] {
        let found = ciede2000(a, b);
        assert!((found - expected).abs() < 5.1e-5, "{found} for {expected}");
    }
}

/// Black on white is 21 to 1 by definition; a grey is a grey to every eye, because each row of a
/// matrix sums to one.
#[test]
fn white_and_grey_are_the_same_to_every_eye() {
    assert!((contrast([0; 3], [255; 3]) - 21.0).abs() < 1e-12);
    for eye in &EYES {
        for row in eye {
            // Their sixth decimal is rounded.
            assert!((row.iter().sum::<f64>() - 1.0).abs() < 2e-6);
        }
    }
}
