//! Lists in brackets, and lists of tables under headings.

use toml_edit::{Array, ArrayOfTables, Item, RawString, Table, Value};

/// An item with the text around it.
pub(super) struct Element {
    value: Value,
    /// The text before the item on lines of its own, and its indentation; `None` where it follows
    /// on the line of the previous item, or is new.
    lead: Option<String>,
    /// The text after the item on its line.
    tail: String,
    is_new: bool,
}

impl Element {
    /// Returns a new item.
    pub(super) fn new(value: Value) -> Self {
        Self { value, lead: None, tail: String::new(), is_new: true }
    }
}

/// Changes the items of a list.
pub(super) fn change_array(list: &mut Array, change: impl FnOnce(&mut Vec<Element>)) {
    let (head, mut elements, end) = taken_apart(list);
    // New items are laid out like the others.
    let indentation = elements.iter().find_map(|element| {
        let lead = element.lead.as_deref()?;
        Some(lead.rsplit('\n').next().unwrap_or(lead).to_owned())
    });
    change(&mut elements);
    for element in elements.iter_mut().filter(|element| element.is_new) {
        element.lead = indentation.clone();
    }
    put_together(list, head, elements, end);
}

/// Returns the text after the opening bracket, the items, and the text before the closing bracket.
fn taken_apart(list: &Array) -> (String, Vec<Element>, Option<String>) {
    let values: Vec<&Value> = list.iter().collect();
    // The text before each item, and after the last.
    let mut gaps: Vec<String> = values.iter().map(|one| text(one.decor().prefix())).collect();
    let behind = values.last().map(|last| text(last.decor().suffix())).unwrap_or_default();
    gaps.push(behind + &text(Some(list.trailing())));
    let mut gaps = gaps.into_iter().map(|gap| match gap.split_once('\n') {
        Some((tail, lead)) => (tail.to_owned(), Some(lead.to_owned())),
        None => (gap, None),
    });
    let (head, mut lead) = gaps.next().unwrap_or_default();
    let mut elements = Vec::new();
    for (value, (tail, next)) in values.into_iter().zip(gaps) {
        let lead = std::mem::replace(&mut lead, next);
        let tail = if tail.trim().is_empty() { String::new() } else { tail };
        elements.push(Element { value: value.clone(), lead, tail, is_new: false });
    }
    (head.trim_end().to_owned(), elements, lead)
}

fn put_together(list: &mut Array, head: String, elements: Vec<Element>, end: Option<String>) {
    let comma = list.trailing_comma();
    list.clear();
    let mut before = head;
    for (index, element) in elements.into_iter().enumerate() {
        let Element { mut value, lead, tail, .. } = element;
        let prefix = match lead {
            Some(lead) => format!("{before}\n{lead}"),
            // A comment ends with its line.
            None if before.contains('#') => format!("{before}\n"),
            None if index == 0 => String::new(),
            None => " ".to_owned(),
        };
        *value.decor_mut() = toml_edit::Decor::new(prefix, "");
        list.push_formatted(value);
        before = tail;
    }
    list.set_trailing(match end {
        Some(end) => format!("{before}\n{end}"),
        None if before.contains('#') => format!("{before}\n"),
        None => String::new(),
    });
    list.set_trailing_comma(comma && !list.is_empty());
}

fn text(raw: Option<&RawString>) -> String {
    raw.and_then(RawString::as_str).unwrap_or_default().to_owned()
}

// Lists of tables under headings. A document writes its tables by their positions, not by their
// order in a list, so that moving a table means changing its position.

/// Inserts a table.
pub(super) fn insert_table(list: &mut ArrayOfTables, at: usize, mut table: Table) {
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
pub(super) fn move_table(list: &mut ArrayOfTables, from: usize, to: usize) {
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
