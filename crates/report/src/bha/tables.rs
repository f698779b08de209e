//! The tables on the page of a static BHA analysis.

use wholestring_results::{BhaState, BhaSummary, BhaVaried};

use crate::{Cell, PageTable, Place};

/// Table whose rows each name a quantity.
fn quantities(title: &str, rows: Vec<Vec<Cell>>) -> PageTable {
    PageTable { place: Place::Results, ..of(title, &["", "Value"], rows) }
}

/// Table whose columns are a quantity each.
fn of(title: &str, heads: &[&str], rows: Vec<Vec<Cell>>) -> PageTable {
    PageTable {
        place: Place::Cases,
        title: title.into(),
        heads: heads.iter().map(|head| (*head).to_owned()).collect(),
        rows,
    }
}

fn words(text: &str) -> Cell {
    Cell::Text(text.to_owned())
}

/// Results as tables: the bit, contacts, sag, bending, accuracy, then the variations.
pub(super) fn page_tables(summary: &BhaSummary) -> Vec<PageTable> {
    let state = &summary.state;
    let mut tables =
        vec![contacts(state), sag(state), largest(state), solved(state), accuracy(state)];
    tables.extend(holding(summary));
    tables.extend(BhaVaried::ALL.iter().filter_map(|varied| sweep(summary, *varied)));
    tables
}

fn contacts(state: &BhaState) -> PageTable {
    let row = |contact: &wholestring::statics::assembly::Contact| {
        vec![
            words(&contact.name),
            words(contact.touching.name()),
            Cell::quantity(contact.from_bit_m[0], "length"),
            Cell::quantity(contact.from_bit_m[1], "length"),
            Cell::quantity(contact.md_m, "length"),
            Cell::quantity(contact.size_N(), "force"),
            Cell::quantity(contact.force_N[0], "force"),
            Cell::quantity(contact.force_N[1], "force"),
            Cell::quantity(contact.side_rad, "angle"),
        ]
    };
    let heads = [
        "Component",
        "Touches with",
        "From the bit",
        "To",
        "MD",
        "Force",
        "High side",
        "Right",
        "Side",
    ];
    of(
        "Forces on the wall, and their angle from the high side, from the bit up",
        &heads,
        state.contacts.iter().map(row).collect(),
    )
}

fn sag(state: &BhaState) -> PageTable {
    let rows: Vec<Vec<Cell>> = state
        .sag
        .iter()
        .map(|sag| {
            vec![
                words(&sag.name),
                Cell::quantity(sag.from_bit_m, "length"),
                Cell::quantity(sag.md_m, "length"),
                Cell::quantity(sag.hole_inclination_rad, "angle"),
                Cell::quantity(sag.inclination_rad, "angle"),
                sag.azimuth_rad
                    .map_or(Cell::Nothing, |azimuth_rad| Cell::quantity(azimuth_rad, "angle")),
            ]
        })
        .collect();
    let heads = [
        "Sensor in",
        "From the bit",
        "Measured depth",
        "Inclination of the hole",
        "Correction of the inclination",
        "Correction of the azimuth",
    ];
    if rows.is_empty() {
        let none = "No component has a survey_sensor: give its distance from the lower end of the \
                    component under [[string]]";
        return quantities("Sag at the survey sensor", vec![vec![words(none), Cell::Nothing]]);
    }
    of("Sag at the survey sensor: measured + correction = hole", &heads, rows)
}

fn largest(state: &BhaState) -> PageTable {
    let largest = [
        ("Largest bending moment", "torque", state.largest_bending_moment_N_m),
        ("Largest bending stress", "stress", state.largest_bending_stress_Pa),
        ("Largest von Mises stress", "stress", state.largest_von_mises_stress_Pa),
    ];
    let rows = largest.into_iter().flat_map(|(name, dimension, largest)| {
        [
            vec![words(name), Cell::quantity(largest.value, dimension)],
            vec![
                words(&format!("{name}: distance from the bit")),
                Cell::quantity(largest.from_bit_m, "length"),
            ],
        ]
    });
    quantities("Bending and stress of the assembly", rows.collect())
}

fn solved(state: &BhaState) -> PageTable {
    let rows = vec![
        vec![words("Length of the assembly"), Cell::quantity(state.length_m, "length")],
        vec![words("Length that was solved"), Cell::quantity(state.solved_m, "length")],
        vec![words("Elements"), Cell::number(state.elements as f64)],
    ];
    quantities("Solved model", rows)
}

fn accuracy(state: &BhaState) -> PageTable {
    let mut rows = Vec::new();
    if let Some(errors) = state.errors {
        rows.extend([
            vec![words("Side force of the bit"), Cell::quantity(errors.side_force_N, "force")],
            vec![words("Tilt of the bit"), Cell::quantity(errors.tilt_rad, "angle")],
            vec![
                words("Largest bending moment"),
                Cell::quantity(errors.largest_moment_N_m, "torque"),
            ],
            vec![
                words("Largest von Mises stress"),
                Cell::quantity(errors.largest_von_mises_Pa, "stress"),
            ],
            vec![
                words("Sag correction of the inclination"),
                Cell::quantity(errors.sag_rad, "angle"),
            ],
        ]);
    }
    quantities("Accuracy: what elements half as long change", rows)
}

fn holding(summary: &BhaSummary) -> Option<PageTable> {
    let mut rows = Vec::new();
    for inclination in &summary.holding_inclinations_rad {
        let value = Cell::quantity(*inclination, "angle");
        rows.push(vec![words("Inclination of a straight hole at which it holds"), value]);
    }
    for weight in &summary.holding_weights_N {
        let value = Cell::quantity(*weight, "force");
        rows.push(vec![words("Weight on bit at which it holds in this hole"), value]);
    }
    if let Some([high_N, right_N]) = summary.mean_side_force_N {
        for (name, force_N) in [
            ("Side force, mean of all tool faces, high side positive", high_N),
            ("Side force, mean of all tool faces, to the right", right_N),
        ] {
            rows.push(vec![words(name), Cell::quantity(force_N, "force")]);
        }
    }
    (!rows.is_empty()).then(|| quantities("Building, holding, dropping", rows))
}

fn sweep(summary: &BhaSummary, varied: BhaVaried) -> Option<PageTable> {
    let (title, head, dimension) = match varied {
        BhaVaried::Toolface => ("At other tool faces", "Tool face", "angle"),
        BhaVaried::Weight => ("Under other weights", "Weight on bit", "force"),
        BhaVaried::Inclination => ("At other inclinations", "Inclination", "angle"),
    };
    let points = summary.sweep.iter().filter(|point| point.varied == varied);
    let rows: Vec<Vec<Cell>> = points
        .map(|point| {
            let found = point.found;
            let number = |optional: Option<f64>, dimension: &str| {
                optional.map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
            };
            vec![
                Cell::quantity(point.value(), dimension),
                number(found.map(|response| response.side_force_N[0]), "force"),
                number(found.map(|response| response.side_force_N[1]), "force"),
                number(found.map(|response| response.tilt_rad[0]), "angle"),
                number(found.map(|response| response.tilt_rad[1]), "angle"),
                number(found.map(|response| response.largest_bending_moment_N_m), "torque"),
                number(found.and_then(|response| response.sag_inclination_rad), "angle"),
            ]
        })
        .collect();
    let heads = [
        head,
        "Side force, high side positive",
        "Side force to the right",
        "Tilt of the bit, high side positive",
        "Tilt of the bit to the right",
        "Largest bending moment",
        "Sag correction of the inclination",
    ];
    (!rows.is_empty()).then(|| of(title, &heads, rows))
}
