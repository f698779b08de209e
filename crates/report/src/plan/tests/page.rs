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
        "<td class=\"level-warning\">1.05\u{a0}below required factor</td>",
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
