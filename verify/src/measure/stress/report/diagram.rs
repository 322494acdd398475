//! Diagrams as SVG: the error of the tangent on the left, errors in spreads on the right.

use std::ops::Range;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::measure::stress::errors::{Measurement, Verdict};
use crate::measure::stress::{Curve, Outcome};
use crate::tolerance::REFERENCE_SPREADS;

type Panel<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Failure = Box<dyn std::error::Error>;

const SIZE: (u32, u32) = (1180, 460);
/// Errors below this are drawn there.
const LEAST_ERROR: f64 = 1e-18;
const ERRORS: Range<f64> = LEAST_ERROR..10.0;
const SPREADS: Range<f64> = 1e-3..1e3;

/// Draws `<sweep>.svg`.
pub fn draw(outcome: &Outcome, folder: &Path) -> Result<(), Failure> {
    let path = folder.join(format!("{}.svg", outcome.sweep.name));
    let root = SVGBackend::new(&path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let (left, right) = root.split_horizontally(SIZE.0 * 11 / 25);
    let errors = |m: &Measurement| m.tangent.map(|d| d.error.max(LEAST_ERROR));
    panel(
        &left,
        outcome,
        "error of K, relative to its largest entry",
        ERRORS,
        errors,
        false,
    )?;
    let spreads = |m: &Measurement| m.spreads();
    panel(
        &right,
        outcome,
        "error / spread (R or K, the larger); limit 8",
        SPREADS,
        spreads,
        true,
    )?;
    root.present()?;
    Ok(())
}

fn panel(
    area: &Panel<'_>,
    outcome: &Outcome,
    caption: &str,
    vertical: Range<f64>,
    of: impl Fn(&Measurement) -> Option<f64>,
    legend: bool,
) -> Result<(), Failure> {
    let [from, to] = outcome.sweep.range;
    let (low, high) = (vertical.start, vertical.end);
    let mut chart = ChartBuilder::on(area)
        .caption(caption, ("sans-serif", 15))
        .margin(8)
        .margin_right(if legend { 250 } else { 12 })
        .x_label_area_size(38)
        .y_label_area_size(58)
        .build_cartesian_2d(
            (from.min(to)..from.max(to)).log_scale(),
            vertical.log_scale(),
        )?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .x_desc(outcome.sweep.parameter)
        .x_labels(8)
        .x_label_formatter(&|v| format!("{v:.0e}"))
        .y_label_formatter(&|v| format!("{v:.0e}"))
        .draw()?;
    if legend {
        let limit = [from, to].map(|x| (x, REFERENCE_SPREADS));
        chart.draw_series(LineSeries::new(limit, BLACK.stroke_width(1)))?;
    }
    for (i, curve) in outcome.curves.iter().enumerate() {
        let color = Palette99::pick(i).to_rgba();
        let shown = |v: f64| v.clamp(low, high);
        let line = worst(curve, &of).into_iter().map(|(x, y)| (x, shown(y)));
        let drawn = chart.draw_series(LineSeries::new(line, color.stroke_width(1)))?;
        if legend {
            drawn.label(curve.series.label()).legend(move |(x, y)| {
                PathElement::new(vec![(x, y), (x + 14, y)], color.stroke_width(2))
            });
        }
        let failed = curve
            .points
            .iter()
            .filter(|(x, m)| *x > 0.0 && matches!(m.verdict, Verdict::Failed(_)));
        let at = |(x, m): &(f64, Measurement)| (*x, shown(of(m).unwrap_or(high)));
        chart.draw_series(failed.map(|point| Cross::new(at(point), 4, RED.stroke_width(2))))?;
    }
    if legend {
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::Coordinate(488, 20))
            .label_font(("sans-serif", 11))
            .draw()?;
    }
    Ok(())
}

/// The larger value of the states at each value of the parameter.
fn worst(curve: &Curve, of: &impl Fn(&Measurement) -> Option<f64>) -> Vec<(f64, f64)> {
    let mut line: Vec<(f64, f64)> = vec![];
    for (x, measured) in curve.points.iter().filter(|(x, _)| *x > 0.0) {
        let Some(y) = of(measured) else { continue };
        match line.last_mut() {
            Some(last) if last.0 == *x => last.1 = last.1.max(y),
            _ => line.push((*x, y)),
        }
    }
    line
}
