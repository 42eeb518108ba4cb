//! A verdict in words.

use std::fmt::Write;

use carom::judge::{Decision, Margin, Standing};
use carom::log::{FirstDifference, Judgement};

/// What a log comes to, some lines of text.
pub(super) fn text(judgement: &Judgement) -> String {
    let Judgement {
        scene,
        matched,
        impacts,
        ..
    } = judgement;
    let mut text = format!("{scene}: {}\n", headline(judgement.verdict));
    let mut line = |words: String| {
        // A String takes all that is written to it.
        let _ = writeln!(text, "  {words}");
    };
    line(format!(
        "{matched} of {impacts} impacts as they truly happen"
    ));
    if *matched > 0 {
        let (error, ulps) = (judgement.time_error, judgement.time_error_ulps);
        line(format!("times wrong by up to {error:.2e}, {ulps:.2e} ulps"));
    }
    if judgement.repeats > 0 {
        line(format!(
            "lines that only repeat a contact: {}",
            judgement.repeats
        ));
    }
    if let Some(difference) = &judgement.difference {
        told(difference).into_iter().for_each(line);
    }
    text
}

/// How a log stands to the truth, in a few words.
pub(super) fn headline(standing: Standing) -> &'static str {
    match standing {
        Standing::Follows => "follows the truth",
        Standing::Simultaneous => {
            "differs where simultaneous impacts share a disc, which is a matter of convention"
        }
        Standing::Tangent => "differs by a tangent pass, which is a matter of convention",
        Standing::Beyond => "follows the truth for as long as binary64 carries the order",
        Standing::Close => "differs by what is closer than binary64 resolves",
        Standing::Differs => "differs from the truth",
    }
}

/// The first difference, line by line.
pub(in crate::cli) fn told(difference: &FirstDifference) -> Vec<String> {
    let FirstDifference { disc, time, .. } = difference;
    let mut lines = vec![format!("{disc} leaves the truth at t = {time}")];
    lines.push(match &difference.truth {
        Some(truth) => format!(
            "truth: {} and {} meet at {}, between {} and {}",
            truth.a, truth.b, truth.time, truth.lo, truth.hi
        ),
        None => format!("truth: {disc} meets nothing more"),
    });
    lines.push(match &difference.log {
        Some(log) => format!("log:   {} and {} meet at {}", log.a, log.b, log.time),
        None => format!("log:   {disc} meets nothing more"),
    });
    lines.extend(difference.margin.as_ref().map(close));
    lines
}

fn close(margin: &Margin) -> String {
    let Margin {
        value,
        ulps,
        resolution,
        ..
    } = margin;
    let what = match margin.of {
        Decision::Order => "the two are apart in time",
        Decision::End => "the impact is apart from the end of the run",
        Decision::Meeting => "the bodies miss or enter each other",
    };
    format!("{what} by {value:.3e}, {ulps:.3e} ulps; binary64 resolves {resolution:.1e} there")
}
