//! An independent soft string for the well of S4: vertical, one build, a tangent; and a minimiser.

use serde_json::Value;

/// The content of the file.
pub struct Oracle {
    /// Length, m, buoyed weight, N/m, contact radius, m, from the bit up.
    pub string: Vec<(f64, f64, f64)>,
    pub casing_to_m: f64,
    pub mud_kg_per_m3: f64,
    errors: [f64; 4],
}

const KICK_OFF_M: f64 = 500.0;
const END_OF_BUILD_M: f64 = 1150.0;
const INCLINATION_DEG: f64 = 65.0;

fn text(name: &str) -> String {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification");
    std::fs::read_to_string(folder.join(name)).expect(name)
}

impl Oracle {
    pub fn read() -> Self {
        let value: Value =
            serde_json::from_str(&text("S4_friction_calibration.json")).expect("JSON");
        let inputs = &value["inputs"];
        let number = |value: &Value| value.as_f64().expect("a number");
        assert_eq!(number(&inputs["well"]["kop_m"]), KICK_OFF_M);
        assert_eq!(number(&inputs["well"]["eob_m"]), END_OF_BUILD_M);
        assert_eq!(number(&inputs["well"]["inc_deg"]), INCLINATION_DEG);
        let part = |part: &Value| {
            let length = part["length_m"].as_f64().unwrap_or(f64::INFINITY);
            (length, number(&part["w_buoyed_N_m"]), number(&part["contact_radius_m"]))
        };
        let noise = &inputs["noise_sigma"];
        Self {
            string: inputs["string_from_bit_up"]
                .as_array()
                .expect("a list")
                .iter()
                .map(part)
                .collect(),
            casing_to_m: number(&inputs["casing_to_m"]),
            mud_kg_per_m3: number(&inputs["mud_kg_m3"]),
            errors: ["PU_N", "SO_N", "ROB_N", "torque_Nm"].map(|key| number(&noise[key])),
        }
    }

    /// Depth, pick-up, slack-off, rotating, torque, SI.
    pub fn data() -> Vec<[f64; 5]> {
        let text = text("S4_field_data.csv");
        let row = |line: &str| {
            let numbers: Vec<f64> =
                line.split(',').map(|cell| cell.parse().expect("a number")).collect();
            let [depth, weights @ ..] = &numbers[..] else { panic!("a row") };
            let mut row = [*depth, 0.0, 0.0, 0.0, 0.0];
            for (row, weight) in row[1..].iter_mut().zip(weights) {
                *row = 1e3 * weight;
            }
            row
        };
        text.lines().skip(1).map(row).collect()
    }

    pub fn depths() -> Vec<f64> {
        Self::data().iter().map(|row| row[0]).collect()
    }

    /// Readings without noise.
    pub fn rows(&self, depths_m: &[f64], parameters: [f64; 3]) -> Vec<[f64; 5]> {
        let row = |&depth: &f64| {
            let [a, b, c, d] = self.predict(depth, parameters);
            [depth, a, b, c, d]
        };
        depths_m.iter().map(row).collect()
    }

    /// Pick-up, slack-off, rotating weight and torque with the bit at a depth.
    pub fn predict(&self, depth_m: f64, [cased, open, block_N]: [f64; 3]) -> [f64; 4] {
        let pull = |sense: f64| self.integrate(depth_m, cased, open, sense);
        let (rotating, torque) = pull(0.0);
        [pull(1.0).0 + block_N, pull(-1.0).0 + block_N, rotating + block_N, torque]
    }

    pub fn chi2(&self, rows: &[[f64; 5]], p: &[f64]) -> f64 {
        let squares = |row: &[f64; 5]| -> f64 {
            let predicted = self.predict(row[0], [p[0], p[1], p[2]]);
            let parts = predicted.iter().zip(&row[1..]).zip(&self.errors);
            parts.map(|((predicted, read), error)| ((read - predicted) / error).powi(2)).sum()
        };
        rows.iter().map(squares).sum()
    }

    /// Returns the standard errors of the parameters, from differences of the predictions.
    pub fn standard_errors(&self, rows: &[[f64; 5]], p: &[f64]) -> [f64; 3] {
        let mut normal = [[0.0; 3]; 3];
        let steps = [1e-4, 1e-4, 100.0];
        for row in rows {
            let slopes: Vec<[f64; 4]> = (0..3)
                .map(|index| {
                    let at = |sign: f64| {
                        let mut p = [p[0], p[1], p[2]];
                        p[index] += sign * steps[index];
                        self.predict(row[0], p)
                    };
                    let (high, low) = (at(1.0), at(-1.0));
                    std::array::from_fn(|k| {
                        (high[k] - low[k]) / (2.0 * steps[index] * self.errors[k])
                    })
                })
                .collect();
            for a in 0..3 {
                for b in 0..3 {
                    normal[a][b] += (0..4).map(|k| slopes[a][k] * slopes[b][k]).sum::<f64>();
                }
            }
        }
        // The inverse's diagonal by cofactors.
        let minor = |a: usize, b: usize, c: usize, d: usize| {
            normal[a][b] * normal[c][d] - normal[a][d] * normal[c][b]
        };
        let determinant = normal[0][0] * minor(1, 1, 2, 2) - normal[0][1] * minor(1, 0, 2, 2)
            + normal[0][2] * minor(1, 0, 2, 1);
        [minor(1, 1, 2, 2), minor(0, 0, 2, 2), minor(0, 0, 1, 1)]
            .map(|cofactor| (cofactor / determinant).sqrt())
    }

    /// Tension and torque at the surface; axial friction in the sense of a pull, or around
    /// it where that is zero.
    fn integrate(&self, depth_m: f64, cased: f64, open: f64, sense: f64) -> (f64, f64) {
        let mut ends = vec![0.0, KICK_OFF_M, END_OF_BUILD_M, self.casing_to_m];
        let mut above = depth_m;
        for (length, ..) in &self.string {
            above -= length;
            ends.push(above);
        }
        ends.retain(|end| *end >= 0.0 && *end < depth_m);
        ends.sort_by(|a, b| b.total_cmp(a));
        let (mut tension, mut torque, mut lower) = (0.0, 0.0, depth_m);
        for upper in ends {
            if upper == lower {
                continue;
            }
            let middle = 0.5 * (upper + lower);
            let mut from_bit = depth_m - middle;
            let part = self.string.iter().find(|(length, ..)| {
                let here = from_bit < *length;
                from_bit -= length;
                here
            });
            let &(_, weight, radius) = part.expect("the last has no end");
            let friction = if middle < self.casing_to_m { cased } else { open };
            let build = INCLINATION_DEG.to_radians() / (END_OF_BUILD_M - KICK_OFF_M);
            let (curvature, inclination) = if middle < KICK_OFF_M {
                (0.0, 0.0)
            } else if middle > END_OF_BUILD_M {
                (0.0, INCLINATION_DEG.to_radians())
            } else {
                (build, 0.0)
            };
            let rate = |depth: f64, tension: f64| {
                let inclination =
                    if curvature > 0.0 { build * (depth - KICK_OFF_M) } else { inclination };
                let press = (tension * curvature - weight * inclination.sin()).abs();
                let around = if sense == 0.0 { friction * press * radius } else { 0.0 };
                (weight * inclination.cos() + sense * friction * press, around)
            };
            let steps = if curvature > 0.0 { ((lower - upper) / 5.0).ceil().max(1.0) } else { 1.0 };
            let step = (lower - upper) / steps;
            for k in 0..steps as usize {
                let depth = lower - step * k as f64;
                let first = rate(depth, tension);
                let second = rate(depth - 0.5 * step, tension + 0.5 * step * first.0);
                let third = rate(depth - 0.5 * step, tension + 0.5 * step * second.0);
                let fourth = rate(depth - step, tension + step * third.0);
                tension += step / 6.0 * (first.0 + 2.0 * (second.0 + third.0) + fourth.0);
                torque += step / 6.0 * (first.1 + 2.0 * (second.1 + third.1) + fourth.1);
            }
            lower = upper;
        }
        (tension, torque)
    }
}

/// The least of a function, by Nelder and Mead's simplex (1965).
pub fn nelder_mead(function: impl Fn(&[f64]) -> f64, from: &[f64], scale: &[f64]) -> Vec<f64> {
    let count = from.len();
    let mut corners: Vec<(f64, Vec<f64>)> = (0..=count)
        .map(|corner| {
            let mut at = from.to_vec();
            if corner > 0 {
                at[corner - 1] += scale[corner - 1];
            }
            (function(&at), at)
        })
        .collect();
    for _ in 0..400 {
        corners.sort_by(|a, b| a.0.total_cmp(&b.0));
        if corners[count].0 - corners[0].0 < 1e-9 {
            break;
        }
        let centre: Vec<f64> = (0..count)
            .map(|k| corners[..count].iter().map(|(_, at)| at[k]).sum::<f64>() / count as f64)
            .collect();
        let worst = corners[count].clone();
        let towards = |part: f64| {
            let at: Vec<f64> = centre
                .iter()
                .zip(&worst.1)
                .map(|(centre, worst)| centre + part * (centre - worst))
                .collect();
            (function(&at), at)
        };
        let reflected = towards(1.0);
        if reflected.0 < corners[0].0 {
            let expanded = towards(2.0);
            corners[count] = if expanded.0 < reflected.0 { expanded } else { reflected };
        } else if reflected.0 < corners[count - 1].0 {
            corners[count] = reflected;
        } else {
            let contracted = towards(if reflected.0 < worst.0 { 0.5 } else { -0.5 });
            if contracted.0 < worst.0.min(reflected.0) {
                corners[count] = contracted;
            } else {
                let best = corners[0].1.clone();
                for corner in &mut corners[1..] {
                    let at: Vec<f64> =
                        corner.1.iter().zip(&best).map(|(at, best)| 0.5 * (at + best)).collect();
                    *corner = (function(&at), at);
                }
            }
        }
    }
    corners.sort_by(|a, b| a.0.total_cmp(&b.0));
    corners.swap_remove(0).1
}
