//! Numbers as people write them.

/// Seconds, in the unit that suits them, with three digits.
pub(super) fn duration(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs")];
    let unit = units.into_iter().find(|(size, _)| seconds >= size * 0.9999);
    let (size, name) = unit.unwrap_or((1e-9, "ns"));
    format!("{} {name}", digits(seconds / size, 3))
}

/// A number of moderate size with so many digits, and no zeros at its end.
pub(super) fn digits(value: f64, count: i32) -> String {
    if value == 0.0 {
        return String::from("0");
    }
    let before = value.abs().log10().floor() as i32 + 1;
    let after = (count - before).clamp(0, 9) as usize;
    let text = format!("{value:.after$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// An error: moderate ones as they are, small ones with a power of ten.
pub(super) fn error(size: f64) -> String {
    if size == 0.0 || !size.is_finite() || (1e-3..1e5).contains(&size) {
        return match size.is_infinite() {
            true => String::from("∞"),
            false => digits(size, 2),
        };
    }
    let decade = size.log10().floor();
    let front = size / 10_f64.powf(decade);
    format!("{front:.1} · {}", power_of_ten(decade as i32))
}

/// A power of ten.
pub(super) fn power_of_ten(exponent: i32) -> String {
    let raised = exponent.to_string();
    let raised = raised.chars().map(|digit| match digit.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    });
    format!("10{}", raised.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_have_units_that_suit() {
        let table = [
            (0.0, "0 ns"),
            (2.5e-8, "25 ns"),
            (1.25e-4, "125 µs"),
            (4.3287e-5, "43.3 µs"),
            (1e-6, "1 µs"),
            (0.5, "500 ms"),
            (90.0, "90 s"),
        ];
        for (seconds, expected) in table {
            assert_eq!(duration(seconds), expected);
        }
    }

    #[test]
    fn errors_keep_two_digits() {
        let table = [
            (0.0, "0"),
            (2.0, "2"),
            (8.906, "8.9"),
            (0.0151, "0.015"),
            (614.0, "614"),
            (1.04e-12, "1.0 · 10⁻¹²"),
            (f64::INFINITY, "∞"),
        ];
        for (size, expected) in table {
            assert_eq!(error(size), expected);
        }
    }
}
