//! One colour an algorithm and one shape an arithmetic, the same in all figures.
//!
//! Figures are drawn in colours that stand for names; [`theme`] turns them into
//! variables of CSS, which are other ones in the light and in the dark. The
//! palette is that of Okabe and Ito, which the colour-blind tell apart.

use carom::simulation::Algorithm;
use plotters::style::RGBColor;

use crate::cli::choice::ArithmeticName;

/// Text and axes.
pub(super) const INK: RGBColor = RGBColor(1, 0, 0);

/// What all is drawn on.
pub(super) const CARD: RGBColor = RGBColor(1, 0, 4);

/// What explains.
pub(super) const PALE: RGBColor = RGBColor(1, 0, 1);

/// Lines to read values by.
pub(super) const GRID: RGBColor = RGBColor(1, 0, 2);

/// Missed, spurious and misordered impacts.
pub(super) const WRONG: [RGBColor; 3] =
    [RGBColor(1, 0, 10), RGBColor(1, 0, 11), RGBColor(1, 0, 12)];

const RETROACTIVE: RGBColor = RGBColor(1, 0, 20);
const SINGLE: RGBColor = RGBColor(1, 0, 21);
const MULTIPLE: RGBColor = RGBColor(1, 0, 22);
const SYNCHRONISED: RGBColor = RGBColor(1, 0, 23);
const TIMELINE: RGBColor = RGBColor(1, 0, 24);

/// A colour that stands for a name, and what the name is.
const NAMES: [(RGBColor, &str); 12] = [
    (INK, "ink"),
    (CARD, "card"),
    (PALE, "pale"),
    (GRID, "grid"),
    (WRONG[0], "missed"),
    (WRONG[1], "spurious"),
    (WRONG[2], "misordered"),
    (RETROACTIVE, "retroactive"),
    (SINGLE, "single"),
    (MULTIPLE, "multiple"),
    (SYNCHRONISED, "synchronised"),
    (TIMELINE, "timeline"),
];

/// The colour of an algorithm.
pub(super) fn of_algorithm(algorithm: Algorithm) -> RGBColor {
    match algorithm {
        Algorithm::Retroactive { .. } => RETROACTIVE,
        Algorithm::Single => SINGLE,
        Algorithm::Multiple(_) => MULTIPLE,
        Algorithm::Synchronised(_) => SYNCHRONISED,
        Algorithm::Timeline => TIMELINE,
    }
}

/// A colour as CSS has it.
pub(super) fn variable(colour: RGBColor) -> String {
    let name = NAMES.iter().find(|(known, _)| *known == colour);
    let name = name.map_or("ink", |(_, name)| name);
    format!("var(--{name})")
}

/// A shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marker {
    Circle,
    Triangle,
    Square,
}

/// The shape of an arithmetic.
pub(super) fn of_arithmetic(arithmetic: ArithmeticName) -> Marker {
    match arithmetic {
        ArithmeticName::Binary64 => Marker::Circle,
        ArithmeticName::Filtered => Marker::Triangle,
        ArithmeticName::Exact => Marker::Square,
    }
}

/// A figure with its colours by name.
pub(super) fn theme(mut svg: String) -> String {
    for (colour, _) in NAMES {
        let RGBColor(red, green, blue) = colour;
        let code = format!("\"#{red:02X}{green:02X}{blue:02X}\"");
        svg = svg.replace(&code, &format!("\"{}\"", variable(colour)));
    }
    svg
}
