//! Declaration of a row.

/// Declares a row of a table once: its structure and the list of its columns, in the order of the
/// file. Entries are, in any order:
///
/// - `name: Type => Kind, "meaning";` a field that is a column of the same name;
/// - `name: Type, "meaning";` a field without a column;
/// - `name: Type, "meaning", columns { .. };` a field whose parts are columns ([`Part`]): a pair, a
///   structure, or an optional one, whose columns are then empty where it is none;
/// - `name = |row| .. => Kind, "meaning";` a column that follows from the fields;
/// - `is_torque = |row| .., loads { .. };` weights or torques, each declared once: a column in N for
///   each, `null` for torques, then one in N·m for each, `null` for weights.
///
/// The kind is one of [`QuantityKind`] or `Words`, and `null_where "condition"` after the meaning
/// gives the rows without a value. The type of a column of numbers is a [`Number`], that of words a
/// [`Word`]. The meaning documents the field. A column that several tables share is `=> Kind as
/// CONSTANT`, whose meaning is that of the constant. Attributes of a field, as for serde, precede
/// it. Within `columns` an entry is `name => Kind, "meaning";` for a part of that name, or
/// `name = |part| .. => Kind, "meaning";`, where the name may be put together of literals:
/// `["hook" "_N"]`.
///
/// Within `loads` an entry is `name: Type, "weight" | "torque";` for a field, or
/// `name = |row| .., "weight" | "torque";`: its name without the unit, and the meaning of the
/// weight and of the torque where that is another; `_` for no torque. `, unanswered` follows it for
/// a value that is missing without an answer, `, unanswered "as .."` with own words for that.
///
/// `pub const LIST;` after the structure names the list of columns. With `pub const LIST, read;`
/// the rows can be read back ([`ReadRow`]), for which each field is a column. With
/// `pub const LIST with name: Type;` a row of the table is a pair of the structure and that value,
/// which the columns may use. `for Type { .. }` in place of the structure declares the columns of
/// an existing type; a column without a value is its field of that name.
///
/// [`Number`]: crate::row::Number
/// [`Part`]: crate::row::Part
/// [`QuantityKind`]: wholestring::outcome::QuantityKind
/// [`ReadRow`]: crate::row::ReadRow
/// [`Word`]: crate::row::Word
macro_rules! rows {
    (
        $(#[$about:meta])*
        pub struct $row:ident {
            $(
                $(#[$attribute:meta])*
                $name:ident $(: $type:ty)? $(= $value:expr)?
                $(=> $kind:ident $(as $shared:ident)?)? $(, $meaning:literal)?
                $(, null_where $none:literal)? $(, columns { $($columns:tt)+ })?
                $(, loads { $($loads:tt)+ })?;
            )+
        }

        $(#[$list_about:meta])*
        pub const $list:ident $(with $context:ident: $context_type:ty)? $(, $read:ident)?;
    ) => {
        $crate::row::rows! {
            @structure { $(#[$about])* pub struct $row } {}
            $({ $(#[$attribute])* $name $(: $type)? $(, $meaning)? $(, loads { $($loads)+ })? })+
        }

        $crate::row::rows! {
            @table { $row } { $($context: $context_type)? }
            { $(#[$list_about])* pub const $list }
            $({
                $name { $($type)? } { $($value)? } { $($kind $(as $shared)?)? } $($meaning)?
                { $($none)? } { $($($columns)+)? } $(loads { $($loads)+ })?
            })+
        }

        $crate::row::rows! {
            @read { $($read)? } $row {}
            $({ $name { $($type)? } { $($kind)? } $(loads { $($loads)+ })? })+
        }
    };

    (
        for $row:ty {
            $(
                $name:ident $(= $value:expr)? => $kind:ident $(as $shared:ident)?, $meaning:literal
                $(, null_where $none:literal)?;
            )+
        }

        $(#[$list_about:meta])*
        pub const $list:ident $(with $context:ident: $context_type:ty)?;
    ) => {
        $crate::row::rows! {
            @table { $row } { $($context: $context_type)? }
            { $(#[$list_about])* pub const $list }
            $({
                $name {} { $($value)? } { $kind $(as $shared)? } $meaning { $($none)? } {}
            })+
        }
    };

    // The structure: its fields are collected one by one.
    (@structure { $($head:tt)+ } { $($fields:tt)* }) => {
        $($head)+ { $($fields)* }
    };
    (
        @structure $head:tt { $($fields:tt)* }
        { $(#[$attribute:meta])* $name:ident: $type:ty, $meaning:literal } $($more:tt)*
    ) => {
        $crate::row::rows! {
            @structure $head
            { $($fields)* $(#[$attribute])* #[doc = $meaning] pub $name: $type, }
            $($more)*
        }
    };
    (@structure $head:tt $fields:tt { $name:ident, $meaning:literal } $($more:tt)*) => {
        $crate::row::rows! { @structure $head $fields $($more)* }
    };
    (
        @structure $head:tt { $($fields:tt)* }
        { $is_torque:ident, loads { $(
            $name:ident $(: $type:ty)? $(= $value:expr)?, $weight:literal $(| $torque:tt)?
            $(, unanswered $($like:literal)?)?;
        )+ } } $($more:tt)*
    ) => {
        $crate::row::rows! {
            @structure $head
            { $($fields)* $($(
                #[doc = concat!($weight, "; N, or N·m of a torque")] pub $name: $type,
            )?)+ }
            $($more)*
        }
    };

    // The columns and the cells.
    (
        @table { $row:ty } { $($context:ident: $context_type:ty)? }
        { $(#[$list_about:meta])* pub const $list:ident }
        $({ $($entry:tt)+ })+
    ) => {
        $(#[$list_about])*
        pub const $list: &[$crate::ColumnSpec] = &{
            const LISTS: &[&[$crate::ColumnSpec]] =
                &[$($crate::row::rows! { @specs $($entry)+ }),+];
            $crate::row::joined::<{ $crate::row::count(LISTS) }>(LISTS)
        };

        impl $crate::row::Row for $crate::row::rows!(@whose $row $(, $context_type)?) {
            const COLUMNS: &'static [$crate::ColumnSpec] = $list;

            fn append(&self, cells: &mut $crate::row::Cells<'_>) {
                let $crate::row::rows!(@pattern row $(, $context)?) = self;
                $($crate::row::rows! { @append cells row $($entry)+ })+
            }
        }
    };
    (@whose $row:ty) => {
        $row
    };
    (@whose $row:ty, $context:ty) => {
        (&$row, $context)
    };
    (@pattern $row:ident) => {
        $row
    };
    (@pattern $row:ident, $context:ident) => {
        &($row, $context)
    };

    // Columns of an entry.
    (
        @specs $is_torque:ident {} { $whether:expr } {} {} {} loads { $(
            $name:ident $(: $type:ty)? $(= $value:expr)?, $weight:literal $(| $torque:tt)?
            $(, unanswered $($like:literal)?)?;
        )+ }
    ) => {{
        const LOADS: &[&[$crate::ColumnSpec]] = &[
            $($crate::row::rows! { @weight $name $weight { $(unanswered $($like)?)? } },)+
            $($crate::row::rows! {
                @torque $name $weight { $($torque)? } { $(unanswered $($like)?)? }
            },)+
        ];
        const COLUMNS: &[$crate::ColumnSpec] =
            &$crate::row::joined::<{ $crate::row::count(LOADS) }>(LOADS);
        COLUMNS
    }};
    (@weight $name:ident $meaning:literal $unanswered:tt) => {
        &[$crate::row::rows! {
            @load [$name "_N"] Force $meaning "for torques" "it is a torque" $unanswered
        }]
    };
    (@torque $name:ident $weight:literal { _ } $unanswered:tt) => {
        &[]
    };
    (@torque $name:ident $weight:literal {} $unanswered:tt) => {
        $crate::row::rows! { @torque $name $weight { $weight } $unanswered }
    };
    (@torque $name:ident $weight:literal { $meaning:literal } $unanswered:tt) => {
        &[$crate::row::rows! {
            @load [$name "_N_m"] Torque $meaning "for weights" "it is a weight" $unanswered
        }]
    };
    (@load $name:tt $kind:ident $meaning:literal $others:literal $none:literal {}) => {
        $crate::row::rows! { @spec $name $kind concat!($meaning, "; `null` ", $others) }
            .null_where($none)
    };
    (@load $name:tt $kind:ident $meaning:literal $others:literal $none:literal { unanswered }) => {
        $crate::row::rows! {
            @load $name $kind $meaning $others $none
            { unanswered concat!($others, " and without an answer") }
        }
    };
    (
        @load $name:tt $kind:ident $meaning:literal $others:literal $none:literal
        { unanswered $like:expr }
    ) => {
        $crate::row::rows! { @spec $name $kind concat!($meaning, "; `null` ", $like) }
            .null_where(concat!($none, ", or there is no answer"))
    };
    (@specs $name:ident $type:tt {} {} $meaning:literal {} {}) => {
        &[]
    };
    (
        @specs $name:ident $type:tt {} {} $meaning:literal {}
        { $(
            $column:tt $(= $value:expr)? => $kind:ident, $column_meaning:expr
            $(, null_where $none:literal)?;
        )+ }
    ) => {
        &[$($crate::row::rows!(@spec $column $kind $column_meaning) $(.null_where($none))?),+]
    };
    (
        @specs $name:ident $type:tt $value:tt { $kind:ident as $shared:ident } $meaning:literal
        {} {}
    ) => {
        &[$crate::row::shared($shared, $crate::row::rows!(@spec $name $kind $meaning))]
    };
    (
        @specs $name:ident { $type:ty } {} { Words } $meaning:literal { $($none:literal)? } {}
    ) => {
        &[$crate::row::words::<$type>(
            $crate::row::rows!(@spec $name Words $meaning) $(.null_where($none))?,
        )]
    };
    (
        @specs $name:ident { $type:ty } {} { $kind:ident } $meaning:literal { $($none:literal)? } {}
    ) => {
        &[$crate::row::numbers::<$type>(
            $crate::row::rows!(@spec $name $kind $meaning) $(.null_where($none))?,
        )]
    };
    (
        @specs $name:ident {} $value:tt { $kind:ident } $meaning:literal { $($none:literal)? } {}
    ) => {
        &[$crate::row::rows!(@spec $name $kind $meaning) $(.null_where($none))?]
    };
    (@spec $name:tt Words $meaning:expr) => {
        $crate::ColumnSpec::text($crate::row::rows!(@name $name), $meaning)
    };
    (@spec $name:tt $kind:ident $meaning:expr) => {
        $crate::ColumnSpec::number(
            $crate::row::rows!(@name $name),
            ::wholestring::outcome::QuantityKind::$kind,
            $meaning,
        )
    };

    (@name [$name:ident $unit:literal]) => {
        concat!(stringify!($name), $unit)
    };
    (@name [$($part:literal)+]) => {
        concat!($($part),+)
    };
    (@name $name:ident) => {
        stringify!($name)
    };

    // Cells of an entry.
    (
        @append $cells:ident $row:ident $is_torque:ident {} { $whether:expr } {} {} {} loads { $(
            $name:ident $(: $type:ty)? $(= $value:expr)?, $weight:literal $(| $torque:tt)?
            $(, unanswered $($like:literal)?)?;
        )+ }
    ) => {
        let $is_torque = Some($row).is_some_and($whether);
        $(
            let load = $crate::row::rows! { @value $row $name { $($value)? } };
            $cells.number(&(!$is_torque).then_some(load));
        )+
        $($crate::row::rows! {
            @torque_cell $cells $row $is_torque $name { $($value)? } { $($torque)? }
        })+
    };
    (@torque_cell $cells:ident $row:ident $is_torque:ident $name:ident $value:tt { _ }) => {};
    (
        @torque_cell $cells:ident $row:ident $is_torque:ident $name:ident $value:tt
        { $($torque:literal)? }
    ) => {
        let load = $crate::row::rows! { @value $row $name $value };
        $cells.number(&$is_torque.then_some(load));
    };
    (@value $row:ident $name:ident { $value:expr }) => {
        Some($row).map($value)
    };
    (@value $row:ident $name:ident {}) => {
        &$row.$name
    };
    (@append $cells:ident $row:ident $name:ident $type:tt {} {} $meaning:literal {} {}) => {};
    (
        @append $cells:ident $row:ident $name:ident $type:tt {} {} $meaning:literal {}
        { $(
            $column:tt $(= $value:expr)? => $kind:ident, $column_meaning:expr
            $(, null_where $none:literal)?;
        )+ }
    ) => {
        let part = $crate::row::Part::whole(&$row.$name);
        $($crate::row::rows! { @part $cells part $column { $($value)? } $kind })+
    };
    (
        @append $cells:ident $row:ident $name:ident $type:tt { $value:expr }
        { $kind:ident $(as $shared:ident)? } $($about:tt)+
    ) => {
        $crate::row::rows! { @cell $cells $kind (Some($row).map($value)) }
    };
    (
        @append $cells:ident $row:ident $name:ident $type:tt {} { $kind:ident $(as $shared:ident)? }
        $($about:tt)+
    ) => {
        $crate::row::rows! { @cell $cells $kind $row.$name }
    };
    (@part $cells:ident $part:ident $column:tt { $value:expr } $kind:ident) => {
        $crate::row::rows! { @cell $cells $kind $part.map($value) }
    };
    (@part $cells:ident $part:ident $column:ident {} $kind:ident) => {
        $crate::row::rows! { @cell $cells $kind $part.map(|part| &part.$column) }
    };
    (@cell $cells:ident Words $value:expr) => {
        $cells.word(&$value);
    };
    (@cell $cells:ident $kind:ident $value:expr) => {
        $cells.number(&$value);
    };

    // Rows that are read back: their fields are collected one by one.
    (@read {} $row:ident $($entries:tt)+) => {};
    (
        @read { read } $row:ident { $($fields:tt)* }
        { $name:ident { $type:ty } { $kind:ident } } $($more:tt)*
    ) => {
        $crate::row::rows! {
            @read { read } $row { $($fields)* [$name { $type } $kind] } $($more)*
        }
    };
    (
        @read { read } $row:ident { $($fields:tt)* }
        { $is_torque:ident {} {} loads { $(
            $name:ident: $type:ty, $weight:literal $(| $torque:literal)?;
        )+ } } $($more:tt)*
    ) => {
        $crate::row::rows! {
            @read { read } $row { $($fields)* $([$name { $type } load])+ } $($more)*
        }
    };
    (@read { read } $row:ident { $([$name:ident $type:tt $kind:ident])+ }) => {
        impl $crate::row::ReadRow for $row {
            fn read(
                table: &$crate::Table,
                path: &::std::path::Path,
            ) -> Result<Vec<Self>, $crate::ResultsError> {
                let reader = $crate::row::Reader::new(table, path);
                $(let mut $name = $crate::row::rows! { @column reader $name $type $kind };)+
                let mut rows = Vec::with_capacity(table.rows());
                for _ in 0..table.rows() {
                    $(let Some($name) = $name.next() else { break };)+
                    rows.push(Self { $($name),+ });
                }
                Ok(rows)
            }
        }
    };
    (@column $reader:ident $name:ident { $type:ty } Words) => {
        $reader.words::<$type>(stringify!($name))?.into_iter()
    };
    (@column $reader:ident $name:ident { $type:ty } load) => {
        $reader
            .loads::<$type>(
                concat!(stringify!($name), "_N"),
                concat!(stringify!($name), "_N_m"),
            )?
            .into_iter()
    };
    (@column $reader:ident $name:ident { $type:ty } $kind:ident) => {
        $reader.numbers::<$type>(stringify!($name))?.into_iter()
    };
}
pub(crate) use rows;
