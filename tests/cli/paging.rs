//! The page of a comparison.

use super::*;

/// A page, and the report of the same call.
fn page(scenes: &[&str], arguments: &[&str]) -> (String, Value) {
    let scratch = Scratch::new();
    let (html, json) = (scratch.name("page.html"), scratch.name("report.json"));
    let scenes: Vec<_> = scenes.iter().map(|name| scene(name)).collect();
    let scenes: Vec<_> = scenes.iter().map(String::as_str).collect();
    let outputs = ["--html", &html, "--json", &json];
    results(&[&["compare"], &scenes[..], &outputs, arguments].concat());
    let report = serde_json::from_str(&scratch.read("report.json")).expect("JSON");
    (scratch.read("page.html"), report)
}

/// What stands between the first `from` and the next `to`.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    let (_, rest) = text.split_once(from).expect(from);
    rest.split_once(to).expect(to).0
}

/// The row of a candidate in the table of a section.
fn row_of<'a>(section: &'a str, algorithm: &str, arithmetic: &str) -> &'a str {
    let key = format!("data-algorithm=\"{algorithm}\" data-arithmetic=\"{arithmetic}\"");
    between(section, &key, "</tr>")
}

fn section<'a>(page: &'a str, id: &str) -> &'a str {
    between(page, &format!("<section id=\"{id}\">"), "</section>")
}

fn count(row: &str, name: &str) -> u64 {
    let cell = between(row, &format!("data-count=\"{name}\""), "</td>");
    let (_, number) = cell.rsplit_once('>').expect("a cell");
    number.parse().expect("a count")
}

#[test]
fn the_page_has_the_counts_of_the_report() {
    let scenes = ["figure-5.json", "figure-7.json"];
    let (page, report) = page(&scenes, &[]);
    for scene in report["scenes"].as_array().expect("scenes") {
        let section = section(&page, scene["scene"].as_str().expect("a name"));
        for row in scene["rows"].as_array().expect("rows") {
            let parameter = row["passes"].as_u64().or(row["substeps"].as_u64());
            let parameter = parameter.map(|number| format!(" {number}"));
            let [algorithm, arithmetic] =
                ["algorithm", "arithmetic"].map(|key| row[key].as_str().expect("a name"));
            let name = format!("{algorithm}{}", parameter.unwrap_or_default());
            let shown = row_of(section, &name, arithmetic);
            for key in ["matched", "missed", "spurious", "misordered"] {
                assert_eq!(Some(count(shown, key)), row[key].as_u64(), "{name} {key}");
            }
        }
    }
}

/// Of figure 7, where the paper has the numbers: one impact in truth, which a
/// step of a whole frame misses; a single pass leaves the disc 2 behind.
#[test]
fn figure_7_is_on_the_page_as_the_paper_has_it() {
    let (page, _) = page(&["figure-7.json"], &[]);
    let section = section(&page, "figure-7");
    assert!(section.contains("<li><b>1</b>impacts in truth</li>"));
    let counts = |algorithm| {
        let row = row_of(section, algorithm, "exact");
        ["matched", "missed"].map(|name| count(row, name))
    };
    assert_eq!(counts("retroactive 1"), [0, 1]);
    assert_eq!(counts("single"), [1, 0]);
    assert_eq!(counts("timeline"), [1, 0]);
    assert!(row_of(section, "single", "exact").contains("<td>2</td>"));
    // The error of the single pass is the algorithm's, none of it rounding's.
    let parts = between(section, "rounding's part", "</table>");
    let single = between(parts, "<th class=\"name\">single</th>", "</tr>");
    assert_eq!(
        cells(single),
        ["f64", "0", "0", "0", "2", "0", "0", "0", "0", "0"]
    );
}

/// What is written in the cells of a row.
fn cells(row: &str) -> Vec<&str> {
    let cells = row.split("<td").skip(1);
    let texts = cells.map(|cell| between(cell, ">", "</td>"));
    texts.collect()
}

#[test]
fn the_page_needs_nothing_else() {
    let (page, _) = page(&["figure-8.json"], &["--arithmetics", "f64,exact"]);
    for outside in ["http:", "https:", "src=", "@import", "url(", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(page.starts_with("<!DOCTYPE html><html lang=\"en\">"));
    assert!(page.ends_with("</body></html>"));
    let left = unclosed(&without_scripts(&page));
    assert!(left.is_empty(), "{left:?}");
    assert!(page.contains("width=device-width"));
    assert!(between(&page, "<code>", "</code>").starts_with("carom compare "));
}

/// A page without what is between the tags of its scripts.
fn without_scripts(page: &str) -> String {
    let mut parts = page.split("<script");
    let first = parts.next().unwrap_or_default().to_owned();
    let rest = parts.map(|part| part.split_once("</script>").expect("a script ends").1);
    rest.fold(first, |text, part| text + part)
}

/// Elements that are opened and not closed, or closed in another order.
fn unclosed(page: &str) -> Vec<String> {
    let mut open: Vec<String> = Vec::new();
    for tag in page.split('<').skip(1) {
        let (tag, _) = tag.split_once('>').expect("a tag ends");
        let name = tag.split_whitespace().next().unwrap_or_default();
        let is_void = ["!DOCTYPE", "meta", "input"].contains(&name) || tag.ends_with('/');
        match name.strip_prefix('/') {
            Some(closed) if open.last().is_some_and(|last| last == closed) => drop(open.pop()),
            Some(closed) => return vec![format!("/{closed} in {open:?}")],
            None if is_void => {}
            None => open.push(name.to_owned()),
        }
    }
    open
}

/// Even where all is zero, or nothing is.
#[test]
fn figures_have_places_for_all_points() {
    let (page, _) = page(&["figure-7.json", "figure-8.json"], &[]);
    let text = without_scripts(&page);
    for nowhere in ["NaN", "inf,", "\"inf\""] {
        assert!(!text.contains(nowhere), "{nowhere}");
    }
    assert!(page.contains(">\npasses\n</text>"));
}

#[test]
fn a_page_on_standard_output_is_alone_there() {
    let name = scene("figure-4.json");
    let arguments = [
        "--html",
        "-",
        "--algorithms",
        "timeline",
        "--arithmetics",
        "f64",
    ];
    let text = results(&[&["compare", &name], &arguments[..]].concat());
    assert!(text.starts_with("<!DOCTYPE html>"));
}

/// The page's replay is of the multiple collision algorithm, with a mark for each impact
/// that the table counts as wrong.
#[test]
fn the_replay_has_a_mark_for_each_wrong_impact() {
    let arguments = ["--arithmetics", "f64", "--passes", "2"];
    let (page, report) = page(&["timeline-2.json"], &arguments);
    let data = between(&page, "type=\"application/json\">", "</script>");
    let data: Value = serde_json::from_str(data).expect("JSON");
    let run = &data["panes"][0];
    assert_eq!(run["title"], "timeline-2, multiple, f64");
    let rows = report["scenes"][0]["rows"].as_array().expect("rows");
    let row = rows.iter().find(|row| row["algorithm"] == "multiple");
    let row = row.expect("it is compared");
    let faults = run["faults"].as_array().expect("faults");
    for kind in ["missed", "spurious", "misordered"] {
        let marks = faults.iter().filter(|fault| fault["kind"] == kind);
        assert_eq!(Some(marks.count() as u64), row[kind].as_u64(), "{kind}");
    }
}
