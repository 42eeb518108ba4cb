//! A picture as SVG: stories side by side, all to the same scale.

use maud::{Markup, html};

use super::story::{Hit, Story, Way};
use super::view::View;
use crate::cli::motion::Point;

/// The colours of bodies, told apart by most who see colours otherwise, too.
const COLOURS: [&str; 6] = [
    "#2e8b57", "#1f5fbf", "#b5179e", "#c0392b", "#0f8b8d", "#7a5c00",
];

/// So many impacts get numbers.
const MOST_NUMBERS: usize = 60;

/// The longest arrow, as a part of the picture's width.
const LONGEST: f64 = 0.3;

/// Room for a title.
const TITLE: f64 = 28.0;

const STYLE: &str = "
text { font: 14px sans-serif; fill: #222; }
.number { font-size: 12px; fill: #a34700; }
.wall { stroke: #222; stroke-width: 2.5; }
.start { stroke-width: 3; fill-opacity: 0.25; }
.way { fill: none; stroke-width: 1.25; }
.speed { stroke: #1f5fbf; stroke-width: 1.5; }
.struck { fill: none; stroke: #e06c00; stroke-width: 2; }
.after { stroke: #e06c00; stroke-width: 2; }
.rest { fill: none; stroke: #8a8a8a; stroke-width: 1.5; stroke-dasharray: 5 3; }
.swept { stroke: #1f5fbf; stroke-opacity: 0.12; stroke-linecap: round; }
.end { fill: none; stroke: #8a8a8a; stroke-width: 1.5; }
";

/// So many panels are side by side.
const COLUMNS: usize = 2;

/// A story, and what is written above it.
pub(in crate::cli) struct Panel {
    pub(in crate::cli) title: String,
    pub(in crate::cli) story: Story,
    /// Whether what discs would sweep is drawn, if nothing collided.
    pub(in crate::cli) swept: bool,
}

/// A picture of panels.
pub(in crate::cli) fn picture(panels: &[Panel]) -> String {
    let view = View::of(panels.iter().map(|panel| &panel.story));
    let [width, height] = view.size();
    let (columns, rows) = (panels.len().min(COLUMNS), panels.len().div_ceil(COLUMNS));
    let total = [columns as f64 * width, rows as f64 * (height + TITLE)];
    let place = |number: usize| {
        let (column, row) = (number % COLUMNS, number / COLUMNS);
        let place = [column as f64 * width, row as f64 * (height + TITLE) + TITLE];
        format!("translate({})", pair(place))
    };
    let titles: Vec<_> = panels.iter().map(|panel| panel.title.as_str()).collect();
    let svg = html! {
        svg xmlns="http://www.w3.org/2000/svg" viewBox=(format!("0 0 {}", pair(total)))
            width=(fixed(total[0])) height=(fixed(total[1])) role="img" {
            title { (titles.join("; ")) }
            style { (maud::PreEscaped(STYLE)) }
            rect width="100%" height="100%" fill="#ffffff" {}
            defs { (arrow("blue", "#1f5fbf")) (arrow("orange", "#e06c00")) }
            @for (number, panel) in panels.iter().enumerate() {
                g transform=(place(number)) {
                    text x="24" y="-6" { (panel.title) }
                    (Drawn { panel, view: &view }.markup())
                }
            }
        }
    };
    svg.into_string()
}

/// The head of an arrow.
fn arrow(name: &str, colour: &str) -> Markup {
    html! {
        marker id=(name) viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7"
            markerUnits="userSpaceOnUse" orient="auto" {
            path d="M 0 0 L 8 4 L 0 8 z" fill=(colour) {}
        }
    }
}

/// A panel in a view.
struct Drawn<'a> {
    panel: &'a Panel,
    view: &'a View,
}

impl Drawn<'_> {
    fn markup(&self) -> Markup {
        let numbered = self.panel.story.impacts.len() <= MOST_NUMBERS;
        html! {
            @if self.panel.swept { @for way in &self.panel.story.ways { (self.swept(way)) } }
            @for [from, to] in &self.panel.story.walls { (self.line("wall", *from, *to, None)) }
            @for (way, colour) in self.panel.story.ways.iter().zip(COLOURS.iter().cycle()) {
                (self.way(way, colour))
            }
            @for (number, impact) in (1..).zip(&self.panel.story.impacts) {
                @for struck in impact { (self.struck(struck)) }
                @if numbered && let Some(struck) = impact.first() { (self.number(number, struck)) }
            }
        }
    }

    /// What a disc would sweep: a thick line with round ends.
    fn swept(&self, way: &Way) -> Markup {
        let start = way.points[0];
        let end = [0, 1].map(|axis| start[axis] + way.velocity[axis] * self.panel.story.duration);
        let ([x, y], [end_x, end_y]) = (self.view.point(start), self.view.point(end));
        html! {
            line class="swept" x1=(fixed(x)) y1=(fixed(y)) x2=(fixed(end_x)) y2=(fixed(end_y))
                stroke-width=(fixed(self.view.length(2.0 * way.radius))) {}
        }
    }

    /// A disc where it starts, the way to its last impact, and in grey what is left.
    fn way(&self, way: &Way, colour: &str) -> Markup {
        let turn = way.last.unwrap_or(0);
        let (before, after) = (&way.points[..=turn], &way.points[turn..]);
        let end = after[after.len() - 1];
        html! {
            (self.circle("start", way.points[0], way.radius, Some(colour)))
            @if before.len() > 1 { (self.path("way", before, Some(colour))) }
            @if after.len() > 1 { (self.path("rest", after, None)) }
            (self.circle("end", end, way.radius, None))
            (self.arrow("speed", "blue", way.points[0], way.velocity))
        }
    }

    fn struck(&self, struck: &Hit) -> Markup {
        html! {
            (self.circle("struck", struck.centre, struck.radius, None))
            (self.arrow("after", "orange", struck.centre, struck.velocity))
        }
    }

    fn number(&self, number: usize, struck: &Hit) -> Markup {
        let [x, y] = self.view.point(struck.centre);
        html! {
            text.number x=(fixed(x + 5.0)) y=(fixed(y - 5.0)) { (number) }
        }
    }

    fn circle(&self, class: &str, centre: Point, radius: f64, colour: Option<&str>) -> Markup {
        let [x, y] = self.view.point(centre).map(fixed);
        let radius = fixed(self.view.length(radius));
        html! {
            circle class=(class) cx=(x) cy=(y) r=(radius) stroke=[colour] fill=[colour] {}
        }
    }

    fn path(&self, class: &str, points: &[Point], colour: Option<&str>) -> Markup {
        let points = points.iter().map(|point| pair(self.view.point(*point)));
        let points: Vec<_> = points.collect();
        html! {
            polyline class=(class) points=(points.join(" ")) stroke=[colour] {}
        }
    }

    fn line(&self, class: &str, from: Point, to: Point, head: Option<&str>) -> Markup {
        let ([x, y], [end_x, end_y]) = (self.view.point(from), self.view.point(to));
        let head = head.map(|name| format!("url(#{name})"));
        html! {
            line class=(class) x1=(fixed(x)) y1=(fixed(y)) x2=(fixed(end_x)) y2=(fixed(end_y))
                marker-end=[head] {}
        }
    }

    /// A velocity: as far as it leads in the time that is drawn, unless that is too
    /// far; nothing for what rests.
    fn arrow(&self, class: &str, head: &str, from: Point, velocity: Point) -> Markup {
        let way = velocity.map(|part| part * self.reach());
        let to = [from[0] + way[0], from[1] + way[1]];
        html! {
            @if velocity != [0.0; 2] { (self.line(class, from, to, Some(head))) }
        }
    }

    /// The time for which arrows are drawn, the same for all.
    fn reach(&self) -> f64 {
        let starts = self.panel.story.ways.iter().map(|way| way.velocity);
        let struck = self.panel.story.impacts.iter().flatten();
        let speeds = starts.chain(struck.map(|struck| struck.velocity));
        let fastest = speeds.map(|[x, y]| x.hypot(y)).fold(0.0, f64::max);
        let longest = LONGEST * self.view.size()[0] / self.view.length(1.0);
        self.panel.story.duration.min(longest / fastest)
    }
}

/// A number in pixels.
fn fixed(number: f64) -> String {
    format!("{number:.2}")
}

fn pair([x, y]: Point) -> String {
    format!("{} {}", fixed(x), fixed(y))
}
