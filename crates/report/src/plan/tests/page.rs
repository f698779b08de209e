//! Tables and texts of the page.

use super::{plan, plan_html, plan_with};

/// The page has the pictures, the tables, the findings and the reasons for missing answers, and
/// nothing in it becomes markup.
#[test]
fn the_page_says_everything() {
    let page = plan_html(&plan());
    for expected in [
        "Hook load",
        "Surface torque, kN·m, soft string",
        "trip in 0.1",
        "<td class=\"words level-error\">exceeded</td>",
        "the string &lt;locks&gt; up",
        "plan_broomstick.parquet",
        "href=\"hook_load.csv\"",
        "href=\"plan.xlsx\"",
        "With the bit at 2000 m",
        "<td class=\"level-warning\">1.05\u{a0}below required factor, 0\u{a0}m</td>",
        "<td class=\"words level-note\">marginal</td>",
        "drill &lt;pipe&gt;, 0\u{a0}m",
        "Not checked for want of data: no make-up torque of pipe.",
    ] {
        assert!(page.contains(expected), "{expected}");
    }
    // In three sets of units.
    let narrow = page.matches("<figure class=\"narrow\"").count();
    assert_eq!(page.matches("<svg").count(), 3 * 4 + narrow);
    assert!(page.contains("Surface torque, ft·lbf, soft string"));
    assert!(!page.contains("<Well>") && !page.contains("<locks>"));
}

/// Limits that break something precede the others, whatever their reserve, and are written for each
/// operation.
#[test]
fn what_would_break_first() {
    let page = plan_html(&plan());
    let (_, nearest) = page.split_once("<h2>Nearest limits").expect("a table");
    let place = |kind: &str| nearest.find(kind).unwrap_or_else(|| panic!("{kind}"));
    assert!(place("Tension") < place("Hoist") && place("Hoist") < place("Helical buckling"));
    // The verdict is one table, in the reader's units; its sentences name their check.
    for sentence in ["Lock-up &lt;at&gt; 3\u{a0}kN·m", "Lock-up &lt;at&gt; 2213\u{a0}ft·lbf"] {
        assert!(page.contains(sentence), "{sentence}");
    }
    assert!(!page.contains("<h2>Governing limits") && !page.contains("<th class=\"words\">check"));
    assert!(page.contains("<td class=\"words level-note\">OK, governs</td>"));
}

/// The rig floor reads hook loads with block, in proportion between the plan's depths, and writes
/// its own beside them. The values are those of the made-up plan, which is linear in depth.
#[test]
fn the_roadmap_has_even_depths_and_room_for_readings() {
    let page = plan_html(&plan());
    let (_, roadmap) = page.split_once("<h2>Roadmap</h2>").expect("a roadmap");
    let (si, others) = roadmap.split_once("</section>").expect("an end");
    let rows: Vec<&str> = si.lines().filter(|line| line.starts_with("<tr><td>")).collect();
    let depths = rows.iter().map(|row| &row["<tr><td>".len()..row.find("</td>").unwrap_or(0)]);
    let depths: Vec<&str> = depths.collect();
    assert_eq!(depths[..3], ["500", "600", "750"]);
    assert_eq!(depths[depths.len() - 2..], ["1950", "2000"]);
    // 0.2 kN/m of bit depth, 20 % more and 40 % more by friction, and a block of 200 kN.
    assert!(rows[1].contains("<td>344.0 (320.0 to 368.0)</td><td>320.0</td>"), "{}", rows[1]);
    assert!(rows[1].ends_with("<td></td><td></td><td></td><td></td></tr>"), "{}", rows[1]);
    // The string locks up at 2000 m with high friction: no value between 1000 m and there.
    let row = depths.iter().position(|depth| *depth == "1650").expect("a row");
    assert!(rows[row].contains("<td>464.0 (530.0 to –)</td>"), "{}", rows[row]);
    let (_, field) = others.rsplit_once("<h2>Roadmap</h2>").expect("in field units");
    assert!(field.contains("<tr><td>2000</td>") && field.contains("<tr><td>2500</td>"));
}

/// Whether it can be done comes first, then what the rig floor reads.
#[test]
fn the_most_important_comes_first() {
    let page = plan_html(&plan());
    let place = |title: &str| page.find(&format!("<h2>{title}</h2>")).expect(title);
    let titles = ["Verdict", "Limits", "Hook load", "Surface torque", "Roadmap", "Nearest limits"];
    assert!(titles.windows(2).all(|pair| place(pair[0]) < place(pair[1])));
}

/// The standard table is folded, one for each operation with an answer.
#[test]
fn the_string_is_tabled_along_the_hole() {
    let page = plan_html(&plan());
    let heading = "<details>\n<summary><h2>Along the string, drill</h2></summary>";
    assert_eq!(page.matches(heading).count(), 3, "in each set of units");
    assert_eq!(page.matches("<h2>Along the string").count(), 3);
    let cells = ["990", "900", "28.65", "1.72", "drill &lt;pipe&gt;", "−20.00", "5.000", "−0.150"];
    let cells = cells.into_iter().chain(["200.0", "27 %", "sinusoidal"]);
    let row: String = cells.map(|cell| format!("{cell}</td>")).collect();
    let plain = page.replace("<td>", "").replace("<td class=\"words\">", "");
    assert!(plain.contains(&row), "{row}");
}

/// A used-up life is written as a word, and so is an unknown one; numbers are in the reader's
/// units.
#[test]
fn fatigue_and_wear_stand_on_the_page() {
    let page = plan_html(&plan());
    for text in [
        "120.0 % used up",
        "under 0.001 %",
        "drill &lt;pipe&gt;",
        "section 1",
        "51.70 %",
        "6.200",
        "not known",
        "plan_fatigue.csv",
        "plan_wear.parquet",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let none = plan_with(|summary| {
        summary.fatigue.clear();
        summary.wear.clear();
    });
    assert!(!plan_html(&none).contains("Casing wear"));
}

/// An interrupted plan names its missing points.
#[test]
fn missing_points_are_counted() {
    let page = plan_html(&plan_with(|summary| summary.missing = 4));
    assert!(page.contains("The plan was interrupted: 4 of 40 points are missing."));
}
