//! Diagrams as SVG.

use std::ops::Range;
use std::path::Path;

use plotters::prelude::*;

use crate::Failure;

/// A line or a set of points.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Data.
    pub points: Vec<(f64, f64)>,
    connected: bool,
}

impl Series {
    /// Points joined by a line.
    pub fn line(name: String, points: Vec<(f64, f64)>) -> Self {
        Self {
            name,
            points,
            connected: true,
        }
    }

    /// Points alone.
    pub fn points(name: &str, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.into(),
            points,
            connected: false,
        }
    }
}

/// A diagram; the vertical axis is logarithmic, the horizontal one where its data span more than a decade.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Name of the file.
    pub name: String,
    /// Caption.
    pub caption: String,
    /// Horizontal axis.
    pub x: String,
    /// Vertical axis.
    pub y: String,
    /// Data.
    pub series: Vec<Series>,
}

const SIZE: (u32, u32) = (860, 440);
/// Room for the legend.
const LEGEND: u32 = 270;
/// Data that span more are drawn on a logarithmic axis.
const DECADE: f64 = 10.5;

/// Least and largest coordinate.
fn range(chart: &Chart, of: fn(&(f64, f64)) -> f64) -> Range<f64> {
    let all = chart
        .series
        .iter()
        .flat_map(|series| &series.points)
        .map(of);
    let (low, high) = all.fold((f64::INFINITY, 0.0), |(low, high), v| {
        (f64::min(low, v), f64::max(high, v))
    });
    low..high
}

/// Draws `<name>.svg`.
pub fn draw(chart: &Chart, folder: &Path) -> Result<(), Failure> {
    let path = folder.join(format!("{}.svg", chart.name));
    let (x, y) = (range(chart, |p| p.0), range(chart, |p| p.1));
    let y = (y.start / 3.0..y.end * 3.0).log_scale();
    if x.start > 0.0 && x.end > DECADE * x.start {
        let x = (x.start / 1.3..x.end * 1.3).log_scale();
        panel(&path, chart, x, y, |x| format!("{x}"))
    } else {
        let margin = 0.03 * (x.end - x.start);
        panel(&path, chart, x.start - margin..x.end + margin, y, |x| {
            format!("{x:.0}")
        })
    }
}

fn panel<X, Y>(
    path: &Path,
    chart: &Chart,
    x: X,
    y: Y,
    label: impl Fn(&f64) -> String,
) -> Result<(), Failure>
where
    X: plotters::coord::ranged1d::AsRangedCoord<Value = f64>,
    Y: plotters::coord::ranged1d::AsRangedCoord<Value = f64>,
    X::CoordDescType: plotters::coord::ranged1d::ValueFormatter<f64>,
    Y::CoordDescType: plotters::coord::ranged1d::ValueFormatter<f64>,
{
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut drawn = ChartBuilder::on(&root)
        .caption(&chart.caption, ("sans-serif", 15))
        .margin(8)
        .margin_right(LEGEND)
        .x_label_area_size(38)
        .y_label_area_size(62)
        .build_cartesian_2d(x, y)?;
    drawn
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .x_desc(&chart.x)
        .y_desc(&chart.y)
        .x_label_formatter(&label)
        .y_label_formatter(&|v| format!("{v:.0e}"))
        .draw()?;
    for (i, series) in chart.series.iter().enumerate() {
        let color = Palette99::pick(i).to_rgba();
        if series.connected {
            let line = LineSeries::new(series.points.iter().copied(), color.stroke_width(1));
            drawn.draw_series(line)?;
        }
        let points = series.points.iter();
        drawn.draw_series(points.map(|&point| Circle::new(point, 3, color.filled())))?;
        // the chart's own labels are clipped to the plot
        let (x, y) = ((SIZE.0 - LEGEND) as i32, 44 + 14 * i as i32);
        root.draw(&Circle::new((x, y), 3, color.filled()))?;
        let font = ("sans-serif", 11);
        root.draw(&Text::new(series.name.clone(), (x + 12, y - 4), font))?;
    }
    root.present()?;
    Ok(())
}
