//! Single numbers of nodes and elements by the names of their fields.

/// One number of a node by the name of its field: `node!(chain, index, radius)` reads it,
/// `node!(chain, index, radius = r)` and `+=` write it.
macro_rules! node {
    ($chain:expr, $index:expr, spin $($write:tt)*) => {
        $crate::dynamics::kernel::chain::number!($chain, $index, states, spin $($write)*)
    };
    ($chain:expr, $index:expr, $field:ident $($write:tt)*) => {
        $crate::dynamics::kernel::chain::number!($chain, $index, node_blocks, $field $($write)*)
    };
}

/// One number of an element by the name of its field, read and written like that of a [`node!`].
macro_rules! element {
    ($chain:expr, $index:expr, $field:ident $($write:tt)*) => {
        $crate::dynamics::kernel::chain::number!($chain, $index, element_blocks, $field $($write)*)
    };
}

/// One number of a row: read, or written with an assignment.
macro_rules! number {
    ($chain:expr, $index:expr, $blocks:ident, $field:ident) => {{
        let (row, lane) = $chain.place($index);
        $crate::simd::number::Real::to_f64($chain.$blocks[row].$field.0[lane])
    }};
    ($chain:expr, $index:expr, $blocks:ident, $field:ident = $value:expr) => {{
        let value: f64 = $value;
        let (row, lane) = $chain.place($index);
        $chain.$blocks[row].$field.0[lane] = $crate::simd::number::Real::from_f64(value);
    }};
    ($chain:expr, $index:expr, $blocks:ident, $field:ident $assign:tt $value:expr) => {{
        let value: f64 = $value;
        let mut number: f64 = $crate::dynamics::kernel::chain::number!($chain, $index, $blocks, $field);
        number $assign value;
        $crate::dynamics::kernel::chain::number!($chain, $index, $blocks, $field = number);
    }};
}
pub(crate) use {element, node, number};
