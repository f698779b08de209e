//! Progress of a bit against weight and speed.

use wholestring::rock::TrialOutcome;
use wholestring_units::significant;

use super::{BitTest, TestedPoint};
use crate::{
    BottomPicture, Plot,
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::{DisplayUnits, bottoms_figure},
};

/// A quantity of a point: its name, its dimension, its value and its spread.
struct Quantity {
    title: &'static str,
    dimension: &'static str,
    value: fn(&TrialOutcome) -> f64,
    std: Option<fn(&TrialOutcome) -> f64>,
}

impl Quantity {
    const fn new(
        title: &'static str,
        dimension: &'static str,
        value: fn(&TrialOutcome) -> f64,
    ) -> Self {
        Self { title, dimension, value, std: None }
    }
}

const WEIGHT: Quantity = Quantity {
    std: Some(|outcome| outcome.weight_on_bit_std_N),
    ..Quantity::new("Weight on bit", "force", |outcome| outcome.weight_borne_N)
};
const TORQUE: Quantity = Quantity {
    std: Some(|outcome| outcome.torque_std_N_m),
    ..Quantity::new("Torque", "torque", |outcome| outcome.torque_N_m)
};
const RATE: Quantity = Quantity::new("Rate of penetration", "rate of penetration", |outcome| {
    outcome.rate_of_penetration_m_per_s
});
const DEPTH_OF_CUT: Quantity =
    Quantity::new("Depth of cut per revolution", "diameter", |outcome| outcome.depth_of_cut_m);
const ENERGY: Quantity = Quantity::new("Specific energy", "specific energy", |outcome| {
    outcome.specific_energy_Pa.unwrap_or(f64::NAN)
});

/// Returns every picture of a bit test, in a set of units (`si`, `metric` or `field`): `drill-off`
/// (rate of penetration and torque against weight), `specific-energy` (against depth of cut) and
/// `bottom-hole`; none without points.
pub fn bit_test_plots(test: &BitTest, units: &str) -> Vec<Plot> {
    let drawing = Drawing {
        test,
        display: DisplayUnits::new(&test.head.dimensions, units),
        points: test.sorted(),
    };
    if drawing.points.is_empty() {
        return Vec::new();
    }
    let plot = |name: &str, figure| Plot { name: name.into(), figure };
    let mut plots = vec![
        plot("drill-off", drawing.drill_off()),
        plot("specific-energy", drawing.specific_energy()),
    ];
    plots.extend(drawing.bottoms().map(|figure| plot("bottom-hole", figure)));
    plots
}

/// Drawing of a bit test's pictures.
struct Drawing<'a> {
    test: &'a BitTest,
    display: DisplayUnits<'a>,
    /// By speed, then by weight.
    points: Vec<TestedPoint<'a>>,
}

impl Drawing<'_> {
    /// The points of each speed.
    fn speeds(&self) -> impl Iterator<Item = (usize, &[TestedPoint<'_>])> {
        let speed = |point: &TestedPoint<'_>| point.outcome.rotary_speed_rad_per_s;
        let same = move |a: &TestedPoint<'_>, b: &TestedPoint<'_>| speed(a) == speed(b);
        self.points.chunk_by(same).enumerate()
    }

    fn value(&self, quantity: &Quantity, point: &TestedPoint<'_>) -> f64 {
        self.display.value((quantity.value)(point.outcome), quantity.dimension)
    }

    fn axis(&self, quantity: &Quantity) -> Axis {
        Axis::new(self.display.label(quantity.title, quantity.dimension), Range::Zero)
    }

    /// Spread of the points, and a curve for each speed.
    fn marks(&self, shared: &Quantity, own: &Quantity) -> Vec<Mark> {
        let at = |point: &TestedPoint<'_>| (self.value(shared, point), self.value(own, point));
        let spread = |quantity: &Quantity, point: &TestedPoint<'_>| {
            let std = quantity.std.map_or(0.0, |std| std(point.outcome));
            self.display.value(std, quantity.dimension)
        };
        let mut marks = Vec::new();
        for (index, points) in self.speeds() {
            let bars = points.iter().flat_map(|point| {
                let (x, y) = at(point);
                let (dx, dy) = (spread(shared, point), spread(own, point));
                [[(x - dx, y), (x + dx, y)], [(x, y - dy), (x, y + dy)]]
            });
            marks.push(Mark::Bars { ink: Ink::Line(index), bars: bars.collect() });
        }
        for (index, points) in self.speeds() {
            let points: Vec<(f64, f64)> = points.iter().map(at).collect();
            marks.push(Mark::Curve {
                ink: Ink::Line(index),
                stroke: Stroke::Solid,
                points: points.clone(),
            });
            marks.push(Mark::Points { ink: Ink::Line(index), shape: Shape::of(index), points });
        }
        marks
    }

    fn keys(&self) -> Vec<Key> {
        let key = |(index, points): (usize, &[TestedPoint<'_>])| {
            let speed = points[0].outcome.rotary_speed_rad_per_s;
            Key {
                name: self.display.quantity(speed, "rotary speed"),
                sample: Sample::Point(Ink::Line(index), Shape::of(index)),
            }
        };
        self.speeds().map(key).collect()
    }

    fn panel(&self, shared: &Quantity, own: &Quantity) -> Panel {
        Panel::new(self.axis(own), self.marks(shared, own))
    }

    fn figure(&self, shared: &Quantity, panels: Vec<Panel>, keys: Vec<Key>) -> Figure {
        Figure {
            title: self.test.head.title.clone(),
            subtitle: self.conditions(),
            keys,
            layout: Layout::across(
                panels.len(),
                if panels.len() > 1 { 180.0 } else { 120.0 },
                70.0,
            ),
            shared: self.axis(shared),
            panels,
            hole: Vec::new(),
        }
    }

    /// The conditions: bit and rock.
    fn conditions(&self) -> String {
        let facts = self.test.head.facts.iter();
        let conditions = facts.filter_map(|fact| self.display.fact(fact));
        conditions.collect::<Vec<_>>().join("; ")
    }

    fn drill_off(&self) -> Figure {
        let mut torque = self.panel(&WEIGHT, &TORQUE);
        let mut keys = self.keys();
        let response = &self.test.summary.response;
        let line = response.torque_over_weight_m.zip(response.torque_at_no_weight_N_m);
        if let Some((slope_m, offset_N_m)) = line {
            let weights = || self.points.iter().map(|point| point.outcome.weight_borne_N);
            let ends = [0.0, weights().fold(0.0, f64::max)];
            let line = |weight_N: f64| {
                (
                    self.display.value(weight_N, "force"),
                    self.display.value(offset_N_m + slope_m * weight_N, "torque"),
                )
            };
            torque.marks.insert(
                0,
                Mark::Curve {
                    ink: Ink::Note,
                    stroke: Stroke::Dashed,
                    points: ends.map(line).to_vec(),
                },
            );
            keys.push(Key {
                name: format!(
                    "torque by weight: {:.2} of the bit's radius",
                    slope_m / self.test.summary.bit_radius_m
                ),
                sample: Sample::Line(Ink::Note, Stroke::Dashed),
            });
        }
        keys.push(Key { name: "standard deviation".into(), sample: Sample::Spread(Ink::Note) });
        self.figure(&WEIGHT, vec![self.panel(&WEIGHT, &RATE), torque], keys)
    }

    fn specific_energy(&self) -> Figure {
        let mut panel = self.panel(&DEPTH_OF_CUT, &ENERGY);
        let mut keys = self.keys();
        if self.test.summary.rock_strength_Pa.is_finite() {
            panel.marks.push(Mark::OwnRule {
                at: self.display.value(self.test.summary.rock_strength_Pa, ENERGY.dimension),
                label: String::new(),
            });
            keys.push(Key {
                name: "strength of the rock".into(),
                sample: Sample::Line(Ink::Note, Stroke::Dashed),
            });
        }
        self.figure(&DEPTH_OF_CUT, vec![panel], keys)
    }

    /// The bottoms of the points.
    fn bottoms(&self) -> Option<Figure> {
        let name = |point: &TestedPoint<'_>| {
            let weight =
                self.display.quantity(significant(point.outcome.weight_borne_N, 3), "force");
            let speed = self.display.quantity(point.outcome.rotary_speed_rad_per_s, "rotary speed");
            format!("{weight} at {speed}")
        };
        let bottoms: Vec<(String, &BottomPicture)> =
            self.points.iter().filter_map(|point| Some((name(point), point.bottom?))).collect();
        // A bit tested alone has no high side.
        let sides = ["Across", "Across"];
        let (title, conditions) = (self.test.head.title.clone(), self.conditions());
        (!bottoms.is_empty())
            .then(|| bottoms_figure(title, conditions, &bottoms, sides, self.display))
    }
}
