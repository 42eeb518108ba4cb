//! Table 1 as a picture.

use carom::simulation::Algorithm;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::cli::compare::colour::{CARD, GRID, INK, PALE, WRONG, theme};
use crate::cli::compare::row::Row;
use crate::cli::compare::units::digits;
use crate::cli::html::COLOURS;

/// One of the paper's two scenes.
pub(super) struct Column<'a> {
    pub(super) title: &'a str,
    pub(super) rows: Vec<&'a Row>,
    /// The paper's milliseconds a frame.
    pub(super) paper: [(Algorithm, f64); 2],
}

const WIDTH: i32 = 1070;
const MARGIN: i32 = 20;
/// The height of a row.
const ROW: i32 = 32;
/// Where the rows begin.
const TOP: i32 = 132;
const BELOW: i32 = 56;
/// The width of the names of the rows.
const NAMES: i32 = 180;
/// The width of a scene's part.
const PART: i32 = (WIDTH - 2 * MARGIN - NAMES) / 2;
/// The width of the longest bar.
const BAR: i32 = 84;
/// Where the numbers of missed, spurious and misordered impacts end.
const COUNTS: [i32; 3] = [134, 168, 202];
/// Where, within a scene's part, the times end.
const TIME: i32 = 268;
/// Where the ratios to one pass end.
const RATIO: i32 = 318;
/// Where the paper's times end.
const PAPER: i32 = 405;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

/// The picture, as an SVG file that has its own colours for light and dark.
pub(super) fn picture(columns: &[Column<'_>; 2]) -> String {
    let count = columns[0].rows.len() as i32;
    let height = TOP + count * ROW + BELOW;
    let mut svg = String::new();
    let size = (WIDTH as u32, height as u32);
    let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    draw(&area, columns)
        .and_then(|()| area.present())
        .expect("writing to a string does not fail");
    drop(area);
    theme(with_style(&svg))
}

fn with_style(svg: &str) -> String {
    let (opening, rest) = svg.split_once('>').unwrap_or((svg, ""));
    format!("{opening}>\n<style>{COLOURS}</style>{rest}")
}

fn draw<'b>(area: &Area<'b>, columns: &[Column<'_>; 2]) -> Drawn<'b> {
    area.fill(&CARD)?;
    write(
        area,
        (MARGIN, 20),
        "The paper's Table 1, redone",
        26,
        INK,
        HPos::Left,
    )?;
    let about = "150 discs in a box, 600 frames; one pass (single), more passes (multiple), and \
                 every impact in its order (timeline)";
    write(area, (MARGIN, 50), about, 17, PALE, HPos::Left)?;
    let most = columns.iter().flat_map(|column| &column.rows);
    let most = most.map(|row| row.tally.wrong()).max().unwrap_or(0).max(1);
    names(area, &columns[0].rows)?;
    for (column, left) in columns.iter().zip([MARGIN + NAMES, MARGIN + NAMES + PART]) {
        column.draw(area, left, most)?;
    }
    let count = columns[0].rows.len() as i32;
    legend(area, TOP + count * ROW + 26)
}

fn names<'b>(area: &Area<'b>, rows: &[&Row]) -> Drawn<'b> {
    for (row, top) in rows.iter().zip(tops()) {
        area.draw(&PathElement::new(
            [(MARGIN, top), (WIDTH - MARGIN, top)],
            GRID,
        ))?;
        write(
            area,
            (MARGIN, top + ROW / 2),
            &name(row),
            18,
            INK,
            HPos::Left,
        )?;
    }
    Ok(())
}

fn name(row: &Row) -> String {
    let parameter = row.candidate.parameter();
    match (row.candidate.algorithm, parameter) {
        (Algorithm::Timeline, _) => format!("timeline {}", row.candidate.arithmetic_name()),
        (Algorithm::Retroactive { substeps: 1 }, _) => String::from("retroactive"),
        (Algorithm::Retroactive { substeps }, _) => format!("retroactive, {substeps} steps"),
        (algorithm, Some(passes)) => format!("{algorithm}, {passes} passes"),
        (algorithm, None) => algorithm.to_string(),
    }
}

fn tops() -> impl Iterator<Item = i32> {
    (0..).map(|row| TOP + row * ROW)
}

impl Column<'_> {
    fn draw<'b>(&self, area: &Area<'b>, left: i32, most: u64) -> Drawn<'b> {
        let right = HPos::Right;
        write(area, (left, 88), self.title, 20, INK, HPos::Left)?;
        write(area, (left, 114), "wrong impacts", 16, PALE, HPos::Left)?;
        write(area, (left + TIME, 114), "ms a frame", 16, PALE, right)?;
        write(area, (left + RATIO, 114), "ratio", 16, PALE, right)?;
        write(area, (left + PAPER, 114), "the paper", 16, PALE, right)?;
        for (row, top) in self.rows.iter().zip(tops()) {
            self.wrong(area, (left, top), row, most)?;
            self.times(area, (left, top + ROW / 2), row)?;
        }
        Ok(())
    }

    /// Missed, spurious and misordered impacts, as a bar and in numbers.
    fn wrong<'b>(
        &self,
        area: &Area<'b>,
        (left, top): (i32, i32),
        row: &Row,
        most: u64,
    ) -> Drawn<'b> {
        let tally = &row.tally;
        let part = |count: u64| count as f64 / most as f64 * f64::from(BAR);
        let place = |count| left + part(count).round() as i32;
        let counts = [tally.missed, tally.spurious, tally.misordered];
        let mut sum = 0;
        for ((count, colour), end) in counts.into_iter().zip(WRONG).zip(COUNTS) {
            let corners = [(place(sum), top + 8), (place(sum + count), top + ROW - 8)];
            if count > 0 {
                area.draw(&Rectangle::new(corners, colour.filled()))?;
            }
            sum += count;
            let shade = if count > 0 { colour } else { PALE };
            let middle = (left + end, top + ROW / 2);
            write(area, middle, &count.to_string(), 17, shade, HPos::Right)?;
        }
        Ok(())
    }

    fn times<'b>(&self, area: &Area<'b>, (left, middle): (i32, i32), row: &Row) -> Drawn<'b> {
        let right = HPos::Right;
        let time = digits(1e3 * row.seconds_a_frame(), 2);
        write(area, (left + TIME, middle), &time, 17, INK, right)?;
        if let Some(ratio) = self.ratio(row) {
            write(area, (left + RATIO, middle), &ratio, 17, INK, right)?;
        }
        if let Some(paper) = self.paper_text(row) {
            write(area, (left + PAPER, middle), &paper, 17, PALE, right)?;
        }
        Ok(())
    }

    /// A row's time relative to one pass.
    fn ratio(&self, row: &Row) -> Option<String> {
        let [(single, _), _] = self.paper;
        let mut found = self
            .rows
            .iter()
            .filter(|row| row.candidate.algorithm == single);
        let ratio = row.seconds_a_frame() / found.next()?.seconds_a_frame();
        Some(format!("{ratio:.2}"))
    }

    /// The paper's time, and how it relates to one pass.
    fn paper_text(&self, row: &Row) -> Option<String> {
        let [(_, single), _] = self.paper;
        let mut found = self.paper.iter();
        let (_, time) = found.find(|(algorithm, _)| *algorithm == row.candidate.algorithm)?;
        Some(format!("{time:.2} ({:.2})", time / single))
    }
}

fn legend<'b>(area: &Area<'b>, middle: i32) -> Drawn<'b> {
    let names = ["missed", "spurious", "misordered"];
    for ((name, colour), left) in names.into_iter().zip(WRONG).zip([0, 95, 200]) {
        let left = MARGIN + NAMES + left;
        let ends = [(left, middle - 6), (left + 12, middle + 6)];
        area.draw(&Rectangle::new(ends, colour.filled()))?;
        write(area, (left + 18, middle), name, 16, PALE, HPos::Left)?;
    }
    let paper = "ratio: to one pass. The paper: ms (ratio), Java 6 on a Core 2 Duo E6600, 2009";
    write(area, (WIDTH - MARGIN, middle), paper, 16, PALE, HPos::Right)
}

fn write<'b>(
    area: &Area<'b>,
    at: (i32, i32),
    text: &str,
    size: i32,
    colour: RGBColor,
    side: HPos,
) -> Drawn<'b> {
    let font = ("sans-serif", size).into_font().color(&colour);
    area.draw(&Text::new(
        text.to_owned(),
        at,
        font.pos(Pos::new(side, VPos::Center)),
    ))
}
