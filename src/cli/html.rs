//! Pages that need nothing else.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// The colours of all pages, by name, in the light and in the dark.
pub(super) const COLOURS: &str = include_str!("colours.css");

/// A page with a title and its own style, in light and dark and for any width.
pub(super) fn page(title: &str, style: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(COLOURS)) (PreEscaped(style)) }
            }
            body { (body) }
        }
    };
    page.into_string()
}
