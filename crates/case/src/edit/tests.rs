//! Text that is preserved, and places of new items.

use serde_json::json;

use super::*;

const CASE: &str = r#"# A slant well.
name = "slant"   # of ours

[well]
stations = [            # md, inclination, azimuth
    [0, 0, 0],          # vertical
    # the build
    [300, 0, 0],        # kick-off
    [600, 30, 0],
]

# from the surface down
[[well.hole]]   # cased
kind = "casing"
friction = { kinetic = 0.2, around = 0.1 }

[[well.hole]]
kind = "open"
friction = 0.3  # a guess

[mud]
density = "1.2 sg"

# from the bit up
[[string]]
component = "bit"       # PDC

[[string]]
component = "collar"
[string.joints]
od = "170 mm"

# the rest
[[string]]
component = "drill pipe"

[operation]
kind = ["drill", "slide"] # both
"#;

fn set(key: &str, to: Json) -> Edit {
    Edit::Set { key: key.to_owned(), to }
}

fn remove(key: &str) -> Edit {
    Edit::Remove { key: key.to_owned() }
}

fn insert(list: &str, at: usize, value: Json) -> Edit {
    Edit::Insert { list: list.to_owned(), at, value }
}

fn moved(list: &str, from: usize, to: usize) -> Edit {
    Edit::Move { list: list.to_owned(), from, to }
}

/// Asserts that the changed text is the original with these parts replaced.
#[track_caller]
fn check(changes: &[Edit], replaced: &[(&str, &str)]) {
    let mut expected = CASE.to_owned();
    for (from, to) in replaced {
        assert_eq!(expected.matches(from).count(), 1, "{from}");
        expected = expected.replace(from, to);
    }
    let edited = edit(CASE, changes).unwrap();
    assert!(edited == expected, "{edited}\n--- instead of ---\n{expected}");
}

#[test]
fn without_a_change_the_text_is_the_same() {
    check(&[], &[]);
}

#[test]
fn a_key_is_set_where_it_stands() {
    check(
        &[set("well.hole.1.friction", json!(0.25)), set("name", json!("a \"new\" one"))],
        &[
            ("friction = 0.3  # a guess", "friction = 0.25  # a guess"),
            ("name = \"slant\"   # of ours", "name = 'a \"new\" one'   # of ours"),
        ],
    );
    check(
        &[set("well.hole.0.friction.around", json!(0.15))],
        &[("around = 0.1 }", "around = 0.15 }")],
    );
    check(
        &[set("string.1.joints.od", json!("6-5/8 in")), set("string.0.length", json!("0.3 m"))],
        &[
            ("od = \"170 mm\"", "od = \"6-5/8 in\""),
            ("\"bit\"       # PDC\n", "\"bit\"       # PDC\nlength = \"0.3 m\"\n"),
        ],
    );
    check(&[set("well.stations.1.0", json!(310))], &[("[300, 0, 0]", "[310, 0, 0]")]);
    let friction = json!({"kinetic": 0.2, "static": 0.3});
    check(
        &[set("well.hole.0.friction", friction)],
        &[("{ kinetic = 0.2, around = 0.1 }", "{ kinetic = 0.2, static = 0.3 }")],
    );
}

#[test]
fn a_list_of_lists_has_a_line_for_each() {
    let stations = set("well.stations", json!([[0, 0, 0], ["1000 ft", 3.5, 45]]));
    let edited = edit("[well]\nsurvey = \"a.csv\"  # ours\n", &[stations]).unwrap();
    let list = "stations = [\n    [0, 0, 0],\n    [\"1000 ft\", 3.5, 45],\n]\n";
    assert_eq!(edited, format!("[well]\nsurvey = \"a.csv\"  # ours\n{list}"));
    // A further item is inserted on a line of its own.
    let edited = edit(&edited, &[insert("well.stations", 1, json!([100, 0, 0]))]).unwrap();
    assert!(edited.contains("    [0, 0, 0],\n    [100, 0, 0],\n    [\"1000 ft\""), "{edited}");
}

#[test]
fn missing_tables_are_made() {
    check(
        &[set("rig.block_weight", json!("200 kN")), set("rig.hoist.sheaves", json!(12))],
        &[(
            "# both\n",
            "# both\n\n[rig]\nblock_weight = \"200 kN\"\n\n[rig.hoist]\nsheaves = 12\n",
        )],
    );
}

#[test]
fn keys_and_items_go() {
    check(&[remove("well.hole.1.friction")], &[("friction = 0.3  # a guess\n", "")]);
    check(
        &[remove("string.1")],
        &[("\n[[string]]\ncomponent = \"collar\"\n[string.joints]\nod = \"170 mm\"\n", "")],
    );
    check(&[remove("well.stations.0")], &[("    [0, 0, 0],          # vertical\n", "")]);
    check(&[remove("well.stations.2")], &[("    [600, 30, 0],\n", "")]);
    check(&[remove("operation.kind.0")], &[("[\"drill\", \"slide\"]", "[\"slide\"]")]);
    let none = edit("[[string]]\na = 1\n[mud]\nb = 2\n", &[remove("string.0")]).unwrap();
    assert_eq!(none, "[mud]\nb = 2\n");
}

#[test]
fn items_are_put_in() {
    let collar = json!({"component": "stabilizer", "bodies": [{"od": "8 in"}]});
    let text = "[[string]]\ncomponent = \"stabilizer\"\nbodies = [{ od = \"8 in\" }]\n\n";
    check(
        &[insert("string", 1, collar.clone())],
        &[(
            "[[string]]\ncomponent = \"collar\"",
            &format!("{text}[[string]]\ncomponent = \"collar\""),
        )],
    );
    check(
        &[insert("string", 0, collar.clone())],
        &[("[[string]]\ncomponent = \"bit\"", &format!("{text}[[string]]\ncomponent = \"bit\""))],
    );
    check(&[insert("string", 3, collar)], &[("\n[operation]", &format!("\n{text}[operation]"))]);
    check(
        &[insert("well.stations", 1, json!([200, 0, 0]))],
        &[("# vertical\n", "# vertical\n    [200, 0, 0],\n")],
    );
    check(
        &[insert("well.stations", 3, json!([900, 30, 0.5]))],
        &[("    [600, 30, 0],\n", "    [600, 30, 0],\n    [900, 30, 0.5],\n")],
    );
    check(
        &[insert("operation.kind", 1, json!("ream"))],
        &[("[\"drill\", \"slide\"]", "[\"drill\", \"ream\", \"slide\"]")],
    );
    check(
        &[insert("plan.rows", 0, json!({"a": 1})), insert("modes.weights", 0, json!("1 kN"))],
        &[(
            "# both\n",
            "# both\n\n[plan]\n\n[[plan.rows]]\na = 1\n\n[modes]\nweights = [\"1 kN\"]\n",
        )],
    );
}

#[test]
fn items_move_with_what_belongs_to_them() {
    check(
        &[moved("string", 1, 0)],
        &[
            ("[[string]]\ncomponent = \"collar\"\n[string.joints]\nod = \"170 mm\"\n\n", ""),
            (
                "# from the bit up\n",
                "[[string]]\ncomponent = \"collar\"\n[string.joints]\nod = \"170 mm\"\n\n\
                 # from the bit up\n",
            ),
        ],
    );
    check(
        &[moved("well.stations", 1, 2)],
        &[
            ("    # the build\n    [300, 0, 0],        # kick-off\n", ""),
            (
                "    [600, 30, 0],\n",
                "    [600, 30, 0],\n    # the build\n    [300, 0, 0],        # kick-off\n",
            ),
        ],
    );
    let there_and_back = [moved("string", 0, 2), moved("string", 2, 0)];
    check(&there_and_back, &[]);
    check(
        &[moved("operation.kind", 0, 1)],
        &[("[\"drill\", \"slide\"]", "[\"slide\", \"drill\"]")],
    );
}

/// A table between the items of a list keeps its position.
#[test]
fn positions_of_other_tables_stay() {
    let text = "[[a]]\nx = 1\n\n[b]\ny = 2\n\n[[a]]\nx = 3\n";
    let edited = edit(text, &[moved("a", 0, 1)]).unwrap();
    assert_eq!(edited, "\n[[a]]\nx = 3\n\n[b]\ny = 2\n[[a]]\nx = 1\n");
}

#[test]
fn what_cannot_be_is_said() {
    let why = |change: Edit| edit(CASE, &[change]).unwrap_err().to_string();
    assert_eq!(
        why(set("well.hole.7.friction", json!(1))),
        "`well.hole.7.friction` cannot be changed: there is no `7`"
    );
    assert_eq!(
        why(set("well.hole.2", json!({}))),
        "`well.hole.2` cannot be changed: there is no `2`"
    );
    assert!(why(set("name.first", json!(1))).ends_with("the parent of `first` is not a table"));
    assert!(why(set("name", Json::Null)).ends_with("TOML has no null; remove the key"));
    assert!(why(set("well..hole", json!(1))).ends_with("it has an empty part"));
    assert!(why(remove("mud.friction")).ends_with("there is no `friction`"));
    assert!(why(remove("string.3")).ends_with("there is no `3`"));
    assert!(why(remove("name.0")).ends_with("there is no `0`"));
    assert!(why(insert("string", 4, json!({}))).ends_with("it has 3 items: there is no place 4"));
    assert!(why(insert("string", 0, json!(1))).ends_with("its items are tables"));
    assert!(why(insert("name", 0, json!(1))).ends_with("it is not a list"));
    assert!(why(moved("string", 0, 3)).ends_with("it has 3 items: there is no place 3"));
    assert!(why(moved("rig", 0, 1)).ends_with("there is no `rig`"));
    assert!(matches!(edit("name = ", &[]), Err(EditError::NotToml(_))));
}
