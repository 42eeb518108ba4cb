//! Pictures and traces, held against what follows by hand.

use super::*;

/// How many elements of a class a picture has.
fn count(svg: &str, class: &str) -> usize {
    svg.matches(&format!("class=\"{class}\"")).count()
}

/// Three discs and two impacts of two discs each; all three end elsewhere.
#[test]
fn figure_5_is_drawn() {
    let svg = results(&["run", &scene("figure-5.json"), "--svg", "-"]);
    assert!(
        svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""),
        "{svg}"
    );
    let counts = ["start", "end", "struck", "number"].map(|class| count(&svg, class));
    assert_eq!(counts, [3, 3, 4, 2]);
    assert!(svg.contains("figure-5: timeline, f64"), "{svg}");
}

#[test]
fn a_frame_alone_is_drawn() {
    let name = scene("figure-7.json");
    let frame = |frame| results(&["run", &name, "--svg", "-", "--svg-frame", frame]);
    assert_eq!(count(&frame("0"), "struck"), 2);
    assert_eq!(count(&frame("1"), "struck"), 0);
    let (status, message) = ending(&["run", &name, "--svg", "-", "--svg-frame", "3"]);
    assert!(
        status == 2 && message.contains("expected less than 3"),
        "{message}"
    );
}

/// All nine, each with a panel for what the paper draws, and one for the truth where that
/// differs: figure 2 tunnels, and figure 8 is right.
#[test]
fn the_papers_figures_are_drawn() {
    let scratch = Scratch::new();
    let directory = scratch.name("figures");
    results(&["figures", &directory]);
    let figure = |name: &str| scratch.read(&format!("figures/{name}.svg"));
    let panels = |name: &str| figure(name).matches("<g transform").count();
    assert_eq!((panels("figure-2"), panels("figure-8")), (2, 1));
    assert_eq!(count(&figure("figure-2"), "struck"), 2);
    let page = scratch.read("figures/index.html");
    for name in [2, 3, 4, 5, 6, 7, 8].map(|number| format!("figure-{number}.svg")) {
        assert!(page.contains(&name), "{name}");
    }
    assert!(page.contains("timeline-1.svg") && page.contains("timeline-2.svg"));
    assert!(!page.contains("http"), "it takes nothing from elsewhere");
}

/// Impacts at 4/10 and 7/10 of the only frame, d0 with d1 and then with d2: seven legs,
/// two arrows with two ends each.
#[test]
fn figure_5_is_traced() {
    let text = results(&["run", &scene("figure-5.json"), "--trace", "-"]);
    let trace: Value = serde_json::from_str(&text).expect("JSON");
    let events = trace["traceEvents"].as_array().expect("events");
    let of = |phase: &str| {
        events
            .iter()
            .filter(|event| event["ph"] == phase)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        ["M", "X", "s", "f"].map(|phase| of(phase).len()),
        [3, 7, 2, 2]
    );
    let legs = of("X").into_iter().filter(|leg| leg["tid"] == 0);
    let legs: Vec<_> = legs
        .map(|leg| (leg["ts"].as_f64(), leg["dur"].as_f64()))
        .collect();
    let micros = |seconds: f64| (seconds * 1e6).round();
    let rounded: Vec<_> = legs
        .into_iter()
        .map(|(at, long)| (at.map(f64::round), long.map(f64::round)))
        .collect();
    let expected = [(0.0, 0.4), (0.4, 0.3), (0.7, 0.3)];
    let expected = expected.map(|(at, long)| (Some(micros(at)), Some(micros(long))));
    assert_eq!(rounded, expected);
    assert_eq!(of("s")[1]["id"], of("f")[1]["id"]);
    assert_eq!(of("M")[2]["args"]["name"], "d2");
}

#[test]
fn no_two_results_go_to_one_file() {
    let name = scene("figure-5.json");
    let refused = |arguments: &[&str], options: &str| {
        let (status, message) = ending(arguments);
        let expected = format!("out: expected only one of {options}");
        assert!(status == 2 && message.contains(&expected), "{message}");
    };
    let outputs = ["run", &name, "--svg", "out", "--trace", "out"];
    refused(&outputs, "--svg and --trace");
    let outputs = ["compare", &name, "--json", "out", "--html", "out"];
    refused(&outputs, "--json and --html");
    let outputs = [
        "check", &name, "--events", "-", "--json", "out", "--junit", "out",
    ];
    refused(&outputs, "--json and --junit");
}

/// The data of a replay.
fn replay(arguments: &[&str]) -> Value {
    let text = results(&[&["run"], arguments, &["--html", "-"]].concat());
    assert!(!text.contains("http"), "it takes nothing from elsewhere");
    replay_data(&text)
}

/// The data of the replay on a page.
pub(super) fn replay_data(page: &str) -> Value {
    let data = page
        .split("type=\"application/json\">")
        .nth(1)
        .expect("data");
    let data = data.split("</script>").next().expect("data");
    serde_json::from_str(data).expect("JSON")
}

/// With one impact a frame the disc waits at 2 from 1/2 to 1: legs of speed 4, 0, -4.
#[test]
fn a_replay_stands_beside_the_truth() {
    let data = replay(&[&scene("figure-7.json"), "--algorithm", "single"]);
    let panes = data["panes"].as_array().expect("panes");
    assert_eq!(panes.len(), 2);
    let legs = |pane: usize| {
        let legs = panes[pane]["motion"]["discs"][0]["legs"]
            .as_array()
            .expect("legs");
        let legs = legs.iter().map(|leg| (leg[0].as_f64(), leg[3].as_f64()));
        legs.map(|(time, speed)| (time.expect("a time"), speed.expect("a speed")))
            .collect::<Vec<_>>()
    };
    assert_eq!(legs(0)[..3], [(0.0, 4.0), (0.5, 0.0), (1.0, -4.0)]);
    assert_eq!(legs(1), [(0.0, 4.0), (0.5, -4.0)]);
    assert_eq!(data["difference"], Value::Null);
}

/// What steps of a frame miss is where the two part.
#[test]
fn a_replay_has_the_first_difference() {
    let data = replay(&[&scene("figure-7.json"), "--algorithm", "retroactive"]);
    assert_eq!(data["difference"]["time"], 0.5);
    // In truth the disc turns half way through the frame, 2 from where it starts: there is
    // the mark.
    let faults = data["panes"][0]["faults"].as_array().expect("faults");
    let starts = &data["panes"][0]["motion"]["discs"][0]["legs"][0];
    let [fault] = &faults[..] else {
        panic!("{faults:?}");
    };
    assert_eq!(
        (&fault["kind"], &fault["time"]),
        (&"missed".into(), &0.5.into())
    );
    let x = |value: &Value| value.as_f64().expect("a number");
    assert_eq!(x(&fault["places"][0][1]), x(&starts[1]) + 2.0);
    assert_eq!(data["panes"][1]["faults"], serde_json::json!([]));
    let alone = replay(&[&scene("figure-7.json"), "--arithmetic", "exact"]);
    assert_eq!(alone["panes"].as_array().map(Vec::len), Some(1));
}

#[test]
fn the_log_does_not_depend_on_pictures() {
    let scratch = Scratch::new();
    let arguments = ["run", &scene("timeline-2.json"), "--algorithm", "multiple"];
    let files = ["run.svg", "run.html", "run.json"].map(|name| scratch.name(name));
    let pictures = [
        "--svg", &files[0], "--html", &files[1], "--trace", &files[2],
    ];
    assert_eq!(
        results(&[&arguments[..], &pictures].concat()),
        results(&arguments)
    );
}

#[test]
fn what_cannot_be_pictured_is_refused() {
    let (status, message) = ending(&["run", &scene("around.json"), "--html", "-"]);
    assert!(status == 2 && message.contains("not periodic"), "{message}");
    let figure = scene("figure-7.json");
    let timed = ["--algorithm", "multiple", "--frame-budget", "5"];
    let (status, message) = ending(&[&["run", &figure, "--svg", "-"], &timed[..]].concat());
    assert!(
        status == 2 && message.contains("instead of --frame-budget"),
        "{message}"
    );
}
