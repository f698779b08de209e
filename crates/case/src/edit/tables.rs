//! Lists of tables under headings. A document writes its tables by their positions, not by their
//! order in a list, so that moving a table means changing its position.

use toml_edit::{ArrayOfTables, Item, Table};

/// Inserts a table.
pub(super) fn insert(list: &mut ArrayOfTables, at: usize, mut table: Table) {
    // Without a position of its own a table follows the previous one in the list; the first would
    // follow the text before the list, wherever that is.
    if at == 0
        && let Some(first) = list.get(0)
    {
        table.set_position(first.position());
        let prefix = first.decor().prefix().cloned();
        // The comment above the first heading remains above the list.
        if let (Some(prefix), Some(first)) = (prefix, list.get_mut(0)) {
            first.decor_mut().set_prefix("\n");
            table.decor_mut().set_prefix(prefix);
        }
    }
    list.insert(at, table);
}

/// Moves a table, with all tables in it.
pub(super) fn move_one(list: &mut ArrayOfTables, from: usize, to: usize) {
    let mut positions = Vec::new();
    let mut last = None;
    for table in list.iter_mut() {
        each(table, &mut |table| {
            last = table.position().or(last);
            table.set_position(last);
            positions.extend(last);
        });
    }
    positions.sort_unstable();
    let table = list.remove(from);
    list.insert(to, table);
    let mut positions = positions.into_iter();
    for table in list.iter_mut() {
        each(table, &mut |table| {
            if table.position().is_some() {
                table.set_position(positions.next());
            }
        });
    }
}

/// Visits a table and the tables in it, in the order in which they are written.
fn each(table: &mut Table, visit: &mut impl FnMut(&mut Table)) {
    visit(table);
    for (_, item) in table.iter_mut() {
        match item {
            Item::Table(inner) => each(inner, visit),
            Item::ArrayOfTables(inner) => inner.iter_mut().for_each(|inner| each(inner, visit)),
            _ => {}
        }
    }
}
