//! Plots as SVG, inside the page.

use maud::{Markup, PreEscaped, html};
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::proof::statistics::{CLASSES, Histogram, Reached};
use crate::tolerance::RANDOM;

/// A plot that could not be drawn.
pub(super) type PlotError = Box<dyn std::error::Error>;

/// An error that a curve shows.
type Of = fn(&Reached) -> f64;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const SIZE: (u32, u32) = (460, 280);
const RESIDUAL: RGBColor = RGBColor(0x1f, 0x77, 0xb4);
const TANGENT: RGBColor = RGBColor(0xe0, 0x7b, 0x00);

/// How many states have which error; the tolerance is a dashed line.
pub(super) fn distribution(
    status: &str,
    residuals: &Histogram,
    tangents: &Histogram,
) -> Result<Markup, PlotError> {
    let svg = draw(|area| {
        let most = residuals.counts.iter().chain(&tangents.counts).max();
        let top = *most.unwrap_or(&1) as f64 * 1.08;
        let range = Histogram::lower_end(0)..Histogram::lower_end(CLASSES);
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(26)
            .x_label_area_size(36)
            .y_label_area_size(52)
            .build_cartesian_2d(range, 0.0..top)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_desc("relative error")
            .y_desc("states")
            .x_labels(7)
            .x_label_formatter(&|exponent| format!("1e{exponent:.0}"))
            .y_label_formatter(&|states| format!("{states:.0}"))
            .draw()?;
        for (histogram, color, name) in [(residuals, RESIDUAL, "R"), (tangents, TANGENT, "K")] {
            if histogram.is_empty() {
                continue;
            }
            chart
                .draw_series(LineSeries::new(steps(histogram), color.stroke_width(2)))?
                .label(name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 16, y)], color.stroke_width(2))
                });
        }
        let limit = RANDOM.log10();
        let line = DashedLineSeries::new([(limit, 0.0), (limit, top)], 5, 4, BLACK.into());
        chart.draw_series(line)?;
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .border_style(BLACK.mix(0.3))
            .background_style(WHITE)
            .draw()?;
        Ok(())
    })?;
    Ok(figure(
        &svg,
        &format!("{status}: states by relative error; dashed: the tolerance"),
    ))
}

/// The outline of a histogram.
fn steps(histogram: &Histogram) -> Vec<(f64, f64)> {
    let counts = histogram.counts.iter().enumerate();
    let ends = |(class, &count): (usize, &u64)| {
        let (from, to) = (Histogram::lower_end(class), Histogram::lower_end(class + 1));
        [(from, count as f64), (to, count as f64)]
    };
    counts.flat_map(ends).collect()
}

/// The largest errors against the number of states.
pub(super) fn growth(growth: &[Reached]) -> Result<Markup, PlotError> {
    let (Some(first), Some(last)) = (growth.first(), growth.last()) else {
        return Ok(html! {});
    };
    let svg = draw(|area| {
        let states = first.states as f64..(last.states as f64).max(first.states as f64 + 1.0);
        let errors = 1e-15..1e-11;
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(26)
            .x_label_area_size(36)
            .y_label_area_size(52)
            .build_cartesian_2d(states.log_scale(), errors.log_scale())?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_desc("states per element and status")
            .x_labels(4)
            .y_desc("largest relative error")
            .x_label_formatter(&|states| format!("{states:.0}"))
            .y_label_formatter(&|error| format!("{error:.0e}"))
            .draw()?;
        let residual = |reached: &Reached| reached.residual;
        let tangent = |reached: &Reached| reached.tangent;
        let curves: [(Of, RGBColor, &str); 2] =
            [(residual, RESIDUAL, "R"), (tangent, TANGENT, "K")];
        for (of, color, name) in curves {
            let at = |reached: &Reached| (reached.states as f64, of(reached).clamp(1e-15, 1e-11));
            let line = LineSeries::new(growth.iter().map(at), color.stroke_width(2)).point_size(3);
            chart.draw_series(line)?.label(name).legend(move |(x, y)| {
                PathElement::new([(x, y), (x + 16, y)], color.stroke_width(2))
            });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerRight)
            .border_style(BLACK.mix(0.3))
            .background_style(WHITE)
            .draw()?;
        Ok(())
    })?;
    Ok(figure(
        &svg,
        "largest relative error over all elements, before the recorded hardest states",
    ))
}

/// Draws a plot on a white ground.
fn draw(plot: impl FnOnce(&Area<'_>) -> Result<(), PlotError>) -> Result<String, PlotError> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        plot(&area)?;
        area.present()?;
    }
    Ok(svg.replacen("<svg ", "<svg class=\"plot\" ", 1))
}

fn figure(svg: &str, caption: &str) -> Markup {
    html! { figure { (PreEscaped(svg)) figcaption { (caption) } } }
}
