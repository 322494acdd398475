//! Diagrams as SVG: the error of the tangent on the left, errors in spreads in the middle, the legend on the right.

use std::ops::Range;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::measure::stress::errors::{Measurement, Verdict};
use crate::measure::stress::{Curve, Outcome};
use crate::tolerance::REFERENCE_SPREADS;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Failure = Box<dyn std::error::Error>;

const SIZE: (u32, u32) = (1180, 460);
/// Right ends of the left and of the middle panel.
const LEFT: u32 = 519;
const MIDDLE: u32 = 936;
/// Errors below this are drawn there.
const LEAST_ERROR: f64 = 1e-18;
const ERRORS: Range<f64> = LEAST_ERROR..10.0;
const SPREADS: Range<f64> = 1e-3..1e3;

/// A diagram of one quantity against the parameter.
struct Panel<F> {
    caption: &'static str,
    vertical: Range<f64>,
    /// The quantity.
    of: F,
    /// A horizontal line.
    limit: Option<f64>,
}

/// Draws `<sweep>.svg`.
pub fn draw(outcome: &Outcome, folder: &Path) -> Result<(), Failure> {
    let path = folder.join(format!("{}.svg", outcome.sweep.name));
    let root = SVGBackend::new(&path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let (panels, right) = root.split_horizontally(MIDDLE);
    let (left, middle) = panels.split_horizontally(LEFT);
    let errors = Panel {
        caption: "error of K, relative to its largest entry",
        vertical: ERRORS,
        of: |m: &Measurement| m.tangent.map(|d| d.error.max(LEAST_ERROR)),
        limit: None,
    };
    errors.draw(&left, outcome)?;
    let spreads = Panel {
        caption: "error / spread (R or K, the larger); limit 8",
        vertical: SPREADS,
        of: Measurement::spreads,
        limit: Some(REFERENCE_SPREADS),
    };
    spreads.draw(&middle, outcome)?;
    legend(&right, outcome)?;
    root.present()?;
    Ok(())
}

/// Color of a curve.
fn color(number: usize) -> RGBAColor {
    Palette99::pick(number).to_rgba()
}

impl<F: Fn(&Measurement) -> Option<f64>> Panel<F> {
    fn draw(&self, area: &Area<'_>, outcome: &Outcome) -> Result<(), Failure> {
        let [from, to] = outcome.sweep.range;
        let mut chart = ChartBuilder::on(area)
            .caption(self.caption, ("sans-serif", 15))
            .margin(8)
            .x_label_area_size(38)
            .y_label_area_size(58)
            .build_cartesian_2d(
                (from.min(to)..from.max(to)).log_scale(),
                self.vertical.clone().log_scale(),
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
        if let Some(limit) = self.limit {
            let line = [from, to].map(|x| (x, limit));
            chart.draw_series(LineSeries::new(line, BLACK.stroke_width(1)))?;
        }
        let shown = |v: f64| v.clamp(self.vertical.start, self.vertical.end);
        for (number, curve) in outcome.curves.iter().enumerate() {
            let line = worst(curve, &self.of).into_iter();
            let line = line.map(|(x, y)| (x, shown(y)));
            chart.draw_series(LineSeries::new(line, color(number).stroke_width(1)))?;
            let failed = curve
                .points
                .iter()
                .filter(|(x, m)| *x > 0.0 && matches!(m.verdict, Verdict::Failed(_)));
            let at = |(x, m): &(f64, Measurement)| {
                (*x, shown((self.of)(m).unwrap_or(self.vertical.end)))
            };
            chart.draw_series(failed.map(|point| Cross::new(at(point), 4, RED.stroke_width(2))))?;
        }
        Ok(())
    }
}

/// Color and name of every curve, one below the other.
fn legend(area: &Area<'_>, outcome: &Outcome) -> Result<(), Failure> {
    for (number, curve) in outcome.curves.iter().enumerate() {
        let y = 36 + 16 * number as i32;
        let line = [(4, y), (22, y)];
        area.draw(&PathElement::new(line, color(number).stroke_width(3)))?;
        let at = (28, y - 5);
        area.draw(&Text::new(curve.series.label(), at, ("sans-serif", 11)))?;
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
