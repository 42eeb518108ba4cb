//! Axes: where values stand, and what is written at them.
//!
//! A logarithmic axis has no place for zero: values of zero stand in a strip of
//! their own below it.

use crate::cli::compare::units::power_of_ten;

/// How values become places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    Linear,
    Logarithmic,
}

/// What an axis shows.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// With the unit.
    pub(super) label: String,
    pub(super) scale: Scale,
    /// The values to write at the axis, where they are not the usual ones.
    pub(super) ticks: Option<Vec<f64>>,
    pub(super) format: fn(f64) -> String,
}

/// An axis that has been laid out for values.
#[derive(Clone, Debug)]
pub(super) struct Laid {
    scale: Scale,
    format: fn(f64) -> String,
    pub(super) low: f64,
    pub(super) high: f64,
    /// The places of the ticks.
    pub(super) ticks: Vec<f64>,
    /// Where zero stands, if it has a strip of its own.
    pub(super) zero: Option<f64>,
}

/// How far below the axis the strip of zero is, in parts of its length.
const STRIP: f64 = 0.12;

impl Axis {
    pub(super) fn new(label: impl Into<String>, scale: Scale, format: fn(f64) -> String) -> Self {
        Self {
            label: label.into(),
            scale,
            ticks: None,
            format,
        }
    }

    /// The same with ticks at these values.
    pub(super) fn with_ticks(self, ticks: impl IntoIterator<Item = f64>) -> Self {
        Self {
            ticks: Some(ticks.into_iter().collect()),
            ..self
        }
    }

    /// Lays the axis out for values that are not negative.
    pub(super) fn lay_out(&self, values: &[f64]) -> Laid {
        match self.scale {
            Scale::Linear => self.linear(values),
            Scale::Logarithmic => self.logarithmic(values),
        }
    }

    fn linear(&self, values: &[f64]) -> Laid {
        let shown = self.ticks.iter().flatten();
        let values = || values.iter().chain(shown.clone()).copied();
        let largest = values().fold(0.0, f64::max);
        // An axis for zeros alone.
        let high = if largest > 0.0 { largest } else { 1.0 };
        let low = match &self.ticks {
            Some(_) => values().fold(high, f64::min),
            None => 0.0,
        };
        let step = round_step(high - low);
        let usual = || (0..=8).map(|count| f64::from(count) * step);
        let ticks = self.ticks.clone();
        let margin = 0.06 * (high - low);
        let bottom = low - if self.ticks.is_some() { margin } else { 0.0 };
        let top = high + margin;
        Laid {
            scale: self.scale,
            format: self.format,
            low: bottom,
            high: top,
            ticks: ticks.unwrap_or_else(|| usual().filter(|tick| *tick <= top).collect()),
            zero: None,
        }
    }

    fn logarithmic(&self, values: &[f64]) -> Laid {
        let shown = self.ticks.iter().flatten();
        let values_and_ticks = || values.iter().chain(shown.clone()).copied();
        let positive = || values_and_ticks().filter(|value| *value > 0.0);
        let least = positive().fold(f64::INFINITY, f64::min);
        let (least, most) = match least.is_finite() {
            true => (least.log10(), positive().fold(0.0, f64::max).log10()),
            false => (0.0, 1.0),
        };
        let middle = (least + most) / 2.0;
        let half = (0.54 * (most - least)).max(0.2);
        let (bottom, high) = (middle - half, middle + half);
        let has_zero = values.contains(&0.0);
        let low = bottom
            - if has_zero {
                2.0 * STRIP * 2.0 * half
            } else {
                0.0
            };
        let zero = has_zero.then_some(bottom - STRIP * 2.0 * half);
        let usual = || usual_ticks(bottom, high);
        let ticks = self.ticks.as_ref();
        let ticks = ticks.map(|ticks| ticks.iter().map(|tick| tick.log10()).collect());
        Laid {
            scale: self.scale,
            format: self.format,
            low,
            high,
            ticks: ticks
                .unwrap_or_else(usual)
                .into_iter()
                .chain(zero)
                .collect(),
            zero,
        }
    }
}

impl Laid {
    /// Where a value stands.
    pub(super) fn place(&self, value: f64) -> f64 {
        match (self.scale, self.zero) {
            (Scale::Linear, _) => value,
            (Scale::Logarithmic, Some(zero)) if value == 0.0 => zero,
            (Scale::Logarithmic, _) => value.log10(),
        }
    }

    /// Where the strip of zero ends and the axis begins.
    pub(super) fn border(&self) -> Option<f64> {
        self.zero.map(|zero| 2.0 * zero - self.low)
    }

    /// What is written at a place.
    pub(super) fn text(&self, place: f64) -> String {
        match self.scale {
            _ if self.zero == Some(place) => String::from("0"),
            Scale::Linear => (self.format)(place),
            Scale::Logarithmic => (self.format)(10_f64.powf(place)),
        }
    }
}

/// The powers of ten in a range of logarithms, thinned out where there are many;
/// twice and five times them, too, where there are few.
fn usual_ticks(low: f64, high: f64) -> Vec<f64> {
    let decades = low.floor() as i32..=high.ceil() as i32;
    let between: &[f64] = match high - low {
        span if span < 0.9 => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0],
        span if span < 2.2 => &[1.0, 2.0, 5.0],
        _ => &[1.0],
    };
    let every = (((high - low) / 7.0).ceil() as i32).max(1);
    let ticks = decades
        .filter(|decade| decade % every == 0)
        .flat_map(|decade| {
            let factors = between.iter();
            factors.map(move |factor| f64::from(decade) + factor.log10())
        });
    ticks.filter(|tick| (low..=high).contains(tick)).collect()
}

/// A step of 1, 2 or 5 times a power of ten, of which four to eight fit.
fn round_step(length: f64) -> f64 {
    let rough = length / 4.0;
    let power = 10_f64.powf(rough.log10().floor());
    let factors = [5.0, 2.0, 1.0].into_iter();
    let mut fitting = factors.filter(|factor| factor * power <= rough);
    fitting.next().unwrap_or(1.0) * power
}

/// A count or a size, as a power of ten where it is very large or small.
pub(super) fn plain(value: f64) -> String {
    let decade = value.log10();
    let is_moderate = value == 0.0 || (1e-2..1e5).contains(&value);
    if !is_moderate && (decade - decade.round()).abs() < 1e-6 {
        return power_of_ten(decade.round() as i32);
    }
    let rounded = (value * 1e4).round() / 1e4;
    rounded.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(scale: Scale) -> Axis {
        Axis::new("x", scale, plain)
    }

    #[test]
    fn zero_stands_below_a_logarithmic_axis() {
        let laid = axis(Scale::Logarithmic).lay_out(&[0.0, 1.0, 1000.0]);
        let zero = laid.place(0.0);
        let border = laid.border().expect("a strip");
        assert!(laid.low < zero && zero < border && border < laid.place(1.0));
        assert_eq!(laid.text(zero), "0");
        assert_eq!(laid.text(3.0), "1000");
    }

    #[test]
    fn without_a_zero_there_is_no_strip() {
        let laid = axis(Scale::Logarithmic).lay_out(&[1e-12, 10.0]);
        assert_eq!(laid.border(), None);
        assert_eq!(laid.place(100.0), 2.0);
        let laid = axis(Scale::Linear).lay_out(&[0.0, 6.0]);
        assert_eq!((laid.border(), laid.place(0.0)), (None, 0.0));
        assert_eq!(laid.ticks, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    }

    #[test]
    fn nothing_but_zeros_has_an_axis_too() {
        let laid = axis(Scale::Logarithmic).lay_out(&[0.0, 0.0]);
        assert!(laid.low.is_finite() && laid.low < laid.high);
        let laid = axis(Scale::Linear).lay_out(&[]);
        assert!(laid.low < laid.high);
    }

    #[test]
    fn steps_are_round() {
        let table = [(4.0, 1.0), (6.0, 1.0), (9.0, 2.0), (30.0, 5.0), (0.9, 0.2)];
        for (length, step) in table {
            approx::assert_relative_eq!(round_step(length), step, max_relative = 1e-12);
        }
    }
}
