//! Native Excel charts of the numbers in the sheets.

use rust_xlsxwriter::{
    Chart, ChartFormat, ChartLegendPosition, ChartLine, ChartLineDashType, ChartMarker,
    ChartMarkerType, ChartSolidFill, ChartType, Format, Worksheet, XlsxError,
};

use super::sheet::FIRST_ROW;
use crate::{draw::Ink as Colour, figure::Stroke};

/// Curves down a depth axis.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkbookChart {
    /// Its title.
    pub title: String,
    /// Title of the axis across, unit included.
    pub across: String,
    /// Title of the axis down, unit included.
    pub down: String,
    /// Its curves.
    pub series: Vec<WorkbookSeries>,
}

/// A curve: some rows of two columns of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkbookSeries {
    /// Its name in the legend.
    pub name: String,
    /// Name of the sheet.
    pub sheet: String,
    /// Index of the column that goes across.
    pub across: usize,
    /// Index of the column that goes down.
    pub down: usize,
    /// The rows, counted from zero.
    pub rows: std::ops::Range<usize>,
    /// Place of its colour among those of curves.
    pub colour: usize,
    /// Its stroke; points alone where there is none.
    pub stroke: Option<Stroke>,
}

/// Rows over the charts, and the rows and columns of one.
const TOP: u32 = 2;
const ROWS: u32 = 31;
const COLUMNS: u16 = 11;
const SIZE: [u32; 2] = [680, 600];

pub(super) fn write(
    on: &mut Worksheet,
    title: &str,
    about: &[String],
    charts: &[WorkbookChart],
) -> Result<(), XlsxError> {
    on.set_name("Charts")?;
    // A fixed row height for every program, because charts are measured in rows.
    on.set_default_row_height(15.0);
    on.write_with_format(0, 0, title, &Format::new().set_bold().set_font_size(14))?;
    for (row, line) in (1..).zip(about) {
        on.write_string(row, 0, line)?;
    }
    let top = TOP + about.len() as u32;
    for (place, data) in (0u32..).zip(charts) {
        let (row, column) = (top + place / 2 * ROWS, (place % 2) as u16 * COLUMNS);
        on.insert_chart(row, column, &chart(data))?;
    }
    on.set_landscape().set_print_fit_to_pages(1, 0);
    Ok(())
}

fn chart(data: &WorkbookChart) -> Chart {
    let mut chart = Chart::new(ChartType::ScatterStraight);
    chart.title().set_name(&data.title);
    let mut grid = ChartLine::new();
    grid.set_color(packed(Colour::Grid)).set_width(0.75);
    chart.x_axis().set_name(&data.across).set_major_gridlines_line(&grid);
    // Depth grows down the page, and the axis across is at the top.
    let depth = chart.y_axis().set_name(&data.down);
    depth.set_reverse().set_min(0).set_major_gridlines_line(&grid);
    chart.legend().set_position(ChartLegendPosition::Bottom);
    chart.set_width(SIZE[0]).set_height(SIZE[1]);
    for series in &data.series {
        let rows = [series.rows.start, series.rows.end.saturating_sub(1)];
        let [first, last] = rows.map(|row| FIRST_ROW + row as u32);
        let range = |column: usize| {
            let column = column as u16;
            (series.sheet.as_str(), first, column, last, column)
        };
        let colour = packed(Colour::Line(series.colour));
        let dash = match series.stroke {
            None | Some(Stroke::Solid) => ChartLineDashType::Solid,
            Some(Stroke::Dotted | Stroke::WideDotted) => ChartLineDashType::RoundDot,
            _ => ChartLineDashType::Dash,
        };
        let mut line = ChartLine::new();
        line.set_color(colour).set_width(1.5).set_dash_type(dash);
        let added = chart.add_series();
        if series.stroke.is_none() {
            line.set_hidden(true);
            let mut fill = ChartFormat::new();
            fill.set_solid_fill(ChartSolidFill::new().set_color(colour));
            let mut marker = ChartMarker::new();
            marker.set_type(ChartMarkerType::Diamond).set_size(7).set_format(&mut fill);
            added.set_marker(&marker);
        }
        added
            .set_name(&series.name)
            .set_categories(range(series.across))
            .set_values(range(series.down))
            .set_format(&mut line);
    }
    chart
}

/// A colour in Excel's form.
fn packed(colour: Colour) -> u32 {
    let [red, green, blue] = colour.rgb();
    u32::from_be_bytes([0, red, green, blue])
}
