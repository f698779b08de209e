//! Numbers of a picture: a table, and the values drawn next to its rows.

use wholestring_results::{Column, Data, Table};

/// Value of a row in a column.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Entry {
    Number(f64),
    Word(String),
}

/// A row by its columns.
pub(crate) type Row<'a> = Vec<(&'a str, Entry)>;

/// The table with one more column for each value that is drawn across all of its rows.
pub(crate) fn with_lines(table: &Table, lines: &[(String, f64)]) -> Table {
    let mut columns = table.columns().to_vec();
    for (name, value) in lines {
        columns.push(Column::numbers(name.clone(), vec![Some(*value); table.rows()]));
    }
    Table::new(columns)
}

/// The table with additional rows, and an additional column for each new name. Cells without a
/// value are empty.
pub(crate) fn with_rows(table: &Table, rows: &[Row<'_>]) -> Table {
    let mut columns = table.columns().to_vec();
    for (name, entry) in rows.iter().flatten() {
        if columns.iter().any(|column| column.name == *name) {
            continue;
        }
        columns.push(match entry {
            Entry::Number(_) => Column::numbers(*name, vec![None; table.rows()]),
            Entry::Word(_) => Column::words(*name, vec![String::new(); table.rows()]),
        });
    }
    for column in &mut columns {
        for row in rows {
            let entry = row.iter().find(|(name, _)| *name == column.name).map(|(_, entry)| entry);
            match (&mut column.data, entry) {
                (Data::Number(values), Some(Entry::Number(value))) => {
                    values.push(Some(*value).filter(|value| value.is_finite()));
                }
                (Data::Number(values), _) => values.push(None),
                (Data::Text(words), Some(Entry::Word(word))) => words.push(word.clone()),
                (Data::Text(words), _) => words.push(String::new()),
            }
        }
    }
    Table::new(columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_below_with_columns_of_their_own() {
        let table = Table::new(vec![
            Column::words("of", vec!["curve".to_owned()]),
            Column::numbers("depth_m", vec![Some(1.0)]),
        ]);
        let rows = [
            vec![("depth_m", Entry::Number(2.0)), ("read_N", Entry::Number(3.0))],
            vec![("of", Entry::Word("point".to_owned())), ("read_N", Entry::Number(f64::NAN))],
        ];
        let found = with_lines(&with_rows(&table, &rows), &[("limit_N".to_owned(), 9.0)]);
        assert_eq!(found.words("of").unwrap(), ["curve", "", "point"]);
        assert_eq!(found.numbers("depth_m").unwrap(), [Some(1.0), Some(2.0), None]);
        assert_eq!(found.numbers("read_N").unwrap(), [None, Some(3.0), None]);
        assert_eq!(found.numbers("limit_N").unwrap(), [Some(9.0); 3]);
    }
}
