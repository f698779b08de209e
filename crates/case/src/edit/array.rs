//! Lists in brackets. A comment after an item belongs to the item and moves with it; the document
//! stores it in front of the next one.

use toml_edit::{Array, RawString, Value};

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
pub(super) fn change(list: &mut Array, change: impl FnOnce(&mut Vec<Element>)) {
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
