//! Figures: points and lines over two axes, as SVG.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::{Axis, Laid};
use crate::cli::compare::colour::{GRID, INK, Marker, PALE, theme};

/// The size of a figure: it is as legible on a phone, whose width it has.
const SIZE: (u32, u32) = (460, 330);

/// How large letters are.
const LETTERS: i32 = 16;

/// What belongs together: points of one colour and shape.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) colour: RGBColor,
    pub(super) marker: Marker,
    /// Whether a line joins the points.
    pub(super) is_joined: bool,
    pub(super) points: Vec<Spot>,
}

/// A point, and what is written beside it.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    pub(super) at: [f64; 2],
    pub(super) label: Option<String>,
    /// Whether it is written below the point rather than above.
    pub(super) is_below: bool,
}

impl Spot {
    /// A point with nothing beside it.
    pub(super) fn new(at: [f64; 2]) -> Self {
        Self {
            at,
            label: None,
            is_below: false,
        }
    }
}

/// A figure.
#[derive(Clone, Debug)]
pub(super) struct Figure {
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) series: Vec<Series>,
    /// The points of the frontier, by the first coordinate.
    pub(super) frontier: Vec<[f64; 2]>,
}

type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Laid, Laid>>;

/// Places on an axis, with ticks where they are wanted.
impl Ranged for Laid {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (start, end): (i32, i32)) -> i32 {
        let part = (place - self.low) / (self.high - self.low);
        start + (part * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Laid {
    fn format_ext(&self, place: &f64) -> String {
        self.text(*place)
    }
}

impl Figure {
    /// The figure as an element of a page.
    pub(super) fn draw(&self) -> String {
        let mut svg = String::new();
        self.draw_into(&mut svg)
            .expect("writing to a string does not fail");
        for_page(&theme(svg))
    }

    fn draw_into(&self, svg: &mut String) -> Result<(), Box<dyn std::error::Error>> {
        let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
        let laid = [&self.x, &self.y].map(Axis::lay_out_for);
        let points = self.series.iter().flat_map(|series| &series.points);
        let points: Vec<_> = points.map(|spot| spot.at).collect();
        let [x, y] = [0, 1].map(|axis| points.iter().map(|at| at[axis]).collect::<Vec<_>>());
        let (x, y) = (laid[0](&x), laid[1](&y));
        let mut chart = ChartBuilder::on(&root)
            .margin(6)
            .margin_right(18)
            .x_label_area_size(46)
            .y_label_area_size(66)
            .build_cartesian_2d(x.clone(), y.clone())?;
        self.mesh(&mut chart).map_err(owned)?;
        strip(&mut chart, &x, &y).map_err(owned)?;
        self.draw_frontier(&mut chart, &x, &y).map_err(owned)?;
        for series in &self.series {
            series.draw(&mut chart, &x, &y).map_err(owned)?;
        }
        root.present()?;
        Ok(())
    }

    fn mesh<'b>(&self, chart: &mut Chart<'_, 'b>) -> Result<(), Failure<'b>> {
        chart
            .configure_mesh()
            .bold_line_style(GRID)
            .light_line_style(TRANSPARENT)
            .axis_style(PALE)
            .label_style(("sans-serif", LETTERS).into_font().color(&INK))
            .axis_desc_style(("sans-serif", LETTERS).into_font().color(&PALE))
            .x_desc(self.x.label.as_str())
            .y_desc(self.y.label.as_str())
            .draw()
    }

    /// Steps: from one point on, its error is to be had at any higher cost.
    fn draw_frontier<'b>(
        &self,
        chart: &mut Chart<'_, 'b>,
        x: &Laid,
        y: &Laid,
    ) -> Result<(), Failure<'b>> {
        let Some(last) = self.frontier.last() else {
            return Ok(());
        };
        let first = self.frontier[0];
        let start = (x.place(first[0]), y.high);
        let steps = self.frontier.windows(2).flat_map(|pair| {
            let (here, there) = (place(x, y, pair[0]), place(x, y, pair[1]));
            [here, (there.0, here.1)]
        });
        let end = place(x, y, *last);
        let path = std::iter::once(start)
            .chain(steps)
            .chain([end, (x.high, end.1)]);
        let line = DashedLineSeries::new(path, 5, 4, PALE.stroke_width(1));
        chart.draw_series(line)?;
        Ok(())
    }
}

impl Axis {
    fn lay_out_for(&self) -> impl Fn(&[f64]) -> Laid + '_ {
        |values| self.lay_out(values)
    }
}

fn owned(failure: Failure<'_>) -> Box<dyn std::error::Error> {
    failure.to_string().into()
}

fn place(x: &Laid, y: &Laid, at: [f64; 2]) -> (f64, f64) {
    (x.place(at[0]), y.place(at[1]))
}

/// The line between the strip of zero and the axis.
fn strip<'b>(chart: &mut Chart<'_, 'b>, x: &Laid, y: &Laid) -> Result<(), Failure<'b>> {
    if let Some(border) = y.border() {
        let ends = [(x.low, border), (x.high, border)];
        chart.draw_series([PathElement::new(ends, PALE)])?;
    }
    if let Some(border) = x.border() {
        let ends = [(border, y.low), (border, y.high)];
        chart.draw_series([PathElement::new(ends, PALE)])?;
    }
    Ok(())
}

impl Series {
    fn draw<'b>(&self, chart: &mut Chart<'_, 'b>, x: &Laid, y: &Laid) -> Result<(), Failure<'b>> {
        let places = || self.points.iter().map(|spot| place(x, y, spot.at));
        if self.is_joined {
            chart.draw_series(LineSeries::new(places(), self.colour.stroke_width(2)))?;
        }
        let fill = self.colour.filled();
        let spots = places();
        match self.marker {
            Marker::Circle => chart.draw_series(spots.map(|at| Circle::new(at, 5, fill)))?,
            Marker::Triangle => {
                chart.draw_series(spots.map(|at| TriangleMarker::new(at, 6, fill)))?
            }
            Marker::Square => chart.draw_series(
                spots.map(|at| EmptyElement::at(at) + Rectangle::new([(-4, -4), (4, 4)], fill)),
            )?,
        };
        self.write_labels(chart, x, y)
    }

    /// Writes beside points, on the side that has room.
    fn write_labels<'b>(
        &self,
        chart: &mut Chart<'_, 'b>,
        x: &Laid,
        y: &Laid,
    ) -> Result<(), Failure<'b>> {
        let labels = self.points.iter().filter_map(|spot| {
            let at = place(x, y, spot.at);
            let is_right = at.0 > (x.low + x.high) / 2.0;
            let (side, shift) = match is_right {
                true => (HPos::Right, -8),
                false => (HPos::Left, 8),
            };
            // Left of the middle there is room below a line that rises.
            let is_below = spot.is_below || self.is_joined && !is_right;
            let (end, drop) = match is_below {
                true => (VPos::Top, 5),
                false => (VPos::Bottom, -4),
            };
            let font = ("sans-serif", LETTERS - 1).into_font().color(&self.colour);
            let style = font.pos(Pos::new(side, end));
            let label = spot.label.clone()?;
            Some(EmptyElement::at(at) + Text::new(label, (shift, drop), style))
        });
        chart.draw_series(labels)?;
        Ok(())
    }
}

/// A figure that is an element of a page, as wide as there is room.
pub(super) fn for_page(svg: &str) -> String {
    let (_, inside) = svg.split_once("viewBox").unwrap_or(("", svg));
    let inside = inside.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
    format!("<svg role=\"img\" viewBox{inside}")
}
