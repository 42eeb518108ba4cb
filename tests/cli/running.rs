//! Runs: the algorithms and their options, held against what follows by hand.

use super::*;

/// The disc meets the fixed one at 1/2, at x = 2, and goes back at speed 4
/// for 5/2: to 2 - 10 = -8.
#[test]
fn figure_7_comes_back_from_its_impact() {
    for arithmetic in ["f64", "exact"] {
        let log = run(&[&scene("figure-7.json"), "--arithmetic", arithmetic]);
        assert_eq!(meetings(&log), [(0.5, "d0 d1".into())]);
        let header = log.header.expect("a header");
        assert_eq!(header.scene, "figure-7");
        assert_eq!(header.algorithm, "timeline");
        assert_eq!(header.arithmetic, arithmetic);
        assert_eq!(header.simultaneous.as_deref(), Some("sequential"));
        assert_eq!(header.carom, env!("CARGO_PKG_VERSION"));
        assert_eq!(header.bits.is_some(), arithmetic == "exact");
        let summary = log.summary.expect("a summary");
        assert_eq!([summary.events, summary.grazes, summary.resting], [1, 0, 0]);
        assert_eq!(summary.until, 3.0);
        assert_eq!(summary.energy, [8.0, 8.0]);
        assert_eq!(summary.momentum, [[4.0, 0.0], [-4.0, 0.0]]);
        assert_eq!(end_of(&["figure-7.json", arithmetic]), [-8.0, 0.0]);
    }
}

fn end_of([name, arithmetic]: &[&str; 2]) -> [f64; 2] {
    let name = scene(name);
    let text = results(&["run", &name, "--arithmetic", arithmetic, "--state", "-"]);
    let state = State::from_json(&text).expect("a state");
    numbers(&state.discs[0].position)
}

/// With one impact a frame it stays at 2 until the frame ends, and moves on
/// for two frames: to 2 - 8 = -6.
#[test]
fn the_single_algorithm_loses_what_is_left_of_the_frame() {
    let name = scene("figure-7.json");
    let log = run(&[&name, "--algorithm", "single"]);
    assert_eq!(meetings(&log), [(0.5, "d0 d1".into())]);
    assert_eq!(
        (log.events[0].frame, log.events[0].pass),
        (Some(0), Some(1))
    );
    let header = log.header.expect("a header");
    assert_eq!((header.passes, header.simultaneous), (None, None));
    let text = results(&["run", &name, "--algorithm", "single", "--state", "-"]);
    let state = State::from_json(&text).expect("a state");
    assert_eq!(numbers(&state.discs[0].position), [-6.0, 0.0]);
}

/// The disc that is hit second is at rest: its clock still shows 0, so that
/// it is met 7/10 - 4/10 later on it.
#[test]
fn passes_have_clocks() {
    let name = scene("figure-5.json");
    let arguments = [&name, "--algorithm", "multiple", "--arithmetic", "exact"];
    let log = run(&arguments);
    assert_eq!(
        meetings(&log),
        [(0.4, "d0 d1".into()), (0.7, "d0 d2".into())]
    );
    let passes: Vec<_> = log.events.iter().map(|event| event.pass).collect();
    assert_eq!(passes, [Some(1), Some(2)]);
    let others: Vec<_> = log.events.iter().map(|event| event.time_b).collect();
    assert_eq!(others, [None, Some(0.3)]);
    assert_eq!(log.header.expect("a header").passes, Some(2));
}

#[test]
fn one_pass_finds_one_impact() {
    let name = scene("figure-5.json");
    for [option, value] in [["--passes", "1"], ["--frame-budget", "0"]] {
        let exactly = ["--algorithm", "multiple", "--arithmetic", "exact"];
        let log = run(&[&[&*name], &exactly[..], &[option, value]].concat());
        assert_eq!(meetings(&log), [(0.4, "d0 d1".into())], "{option}");
        let header = log.header.expect("a header");
        assert_eq!(header.passes, (option == "--passes").then_some(1));
        assert_eq!(header.frame_budget, (option != "--passes").then_some(0.0));
    }
}

/// The discs overlap from 2/5 on for about 2/10: at the end of the frame no
/// more. Steps of 1/20 find them apart at 2/5, (1, 1/4) from each other, where
/// the radii add up to 1; at 9/20 they are (1/2, 1/4) from each other.
#[test]
fn steps_that_are_too_long_tunnel() {
    let name = scene("figure-2.json");
    let retroactive = |substeps| {
        let arguments = ["--algorithm", "retroactive", "--substeps", substeps];
        let log = run(&[&[&*name], &arguments[..]].concat());
        let substeps = substeps.parse().ok();
        assert_eq!(log.header.as_ref().expect("a header").substeps, substeps);
        meetings(&log)
    };
    assert_eq!(retroactive("1"), []);
    assert_eq!(retroactive("20")[0], (0.45, "d0 d1".into()));
}

/// Two pairs head on, 2 apart at a relative speed of 1.
#[test]
fn simultaneous_impacts_are_tied_where_that_is_proven() {
    let scratch = Scratch::new();
    let disc =
        |x, y, vx| format!(r#"{{"position": [{x}, {y}], "velocity": [{vx}, 0], "radius": 1}}"#);
    let discs = [disc(0, 0, 1), disc(4, 0, 0), disc(0, 9, 1), disc(4, 9, 0)].join(",");
    let text =
        format!(r#"{{"schema": "carom/scene/1", "discs": [{discs}], "frame": {{"duration": 4}}}}"#);
    let name = scratch.write("ties.json", text);
    let expected = [(2.0, "d0 d1".into()), (2.0, "d2 d3".into())];
    for (arithmetic, tie) in [("f64", None), ("exact", Some(0))] {
        let log = run(&[&name, "--arithmetic", arithmetic]);
        assert_eq!(meetings(&log), expected);
        assert!(log.events.iter().all(|event| event.tie == tie));
    }
}

/// The rim of the disc gets to the wall's end after 4 - 1 at speed 1.
#[test]
fn the_end_of_a_wall_is_named() {
    let scratch = Scratch::new();
    let rest = r#""walls": [{"from": [0, 0], "to": [5, 0]}], "frame": {"duration": 4},"#;
    let text = one_disc(r#""position": [-4, 0], "velocity": [1, 0]"#, rest);
    let name = scratch.write("end.json", text);
    for arithmetic in ["f64", "exact"] {
        let text = results(&["run", &name, "--arithmetic", arithmetic, "--contact"]);
        assert!(text.contains(r#""b":"w0","end":"from""#));
        let log = log(&text);
        assert_eq!(meetings(&log), [(3.0, "d0 w0".into())]);
        let contact = log.events[0].contact.as_ref().expect("a contact");
        assert_eq!(numbers(&contact.point), [0.0, 0.0]);
        assert_eq!(numbers(&contact.normal), [1.0, 0.0]);
        assert_eq!(numbers(&contact.velocity_a), [-1.0, 0.0]);
        assert_eq!(contact.velocity_b, None);
    }
}

/// Walls are two-sided: whichever side the disc is on, the normal goes from
/// it to the wall.
#[test]
fn contacts_with_walls_point_to_the_wall() {
    let name = scene("timeline-1.json");
    let log = run(&[&name, "--contact", "--arithmetic", "exact"]);
    let contacts: Vec<_> = log.events.iter().flat_map(|event| &event.contact).collect();
    assert_eq!(numbers(&contacts[0].point), [0.0, 1.5]);
    assert_eq!(numbers(&contacts[0].normal), [-1.0, 0.0]);
    assert_eq!(numbers(&contacts[0].velocity_a), [8.0, -12.0]);
    assert_eq!(numbers(&contacts[1].point), [4.0 / 3.0, 0.0]);
    assert_eq!(numbers(&contacts[1].normal), [0.0, -1.0]);
    assert_eq!(numbers(&contacts[1].velocity_a), [8.0, 12.0]);
}

/// At (20 - √15) / 40 the centres are (√15, 1) / 4 apart, the sum of the
/// radii 1/2 each.
#[test]
fn contacts_of_discs_lie_between_them() {
    let root = 15f64.sqrt();
    for arithmetic in ["f64", "exact"] {
        let name = scene("figure-2.json");
        let log = run(&[&name, "--contact", "--arithmetic", arithmetic]);
        let contact = log.events[0].contact.as_ref().expect("a contact");
        let expected = [
            (&contact.point, [5.0 - root / 8.0, 0.125]),
            (&contact.normal, [root / 4.0, 0.25]),
            (&contact.velocity_a, [-8.75, -1.25 * root]),
        ];
        for (found, expected) in expected {
            for (found, expected) in numbers(found).into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-14, "{found}, not {expected}");
            }
        }
        let other = contact.velocity_b.as_ref().expect("a disc's velocity");
        assert_eq!(numbers(other), [0.0, 0.0]);
    }
}

/// It passes above the fixed disc at a distance of just both radii.
#[test]
fn grazes_are_counted() {
    let scratch = Scratch::new();
    let text = r#"{"schema": "carom/scene/1", "frame": {"duration": 10}, "discs": [
        {"position": [0, 2], "velocity": [1, 0], "radius": 1},
        {"position": [5, 0], "radius": 1, "mass": "infinite"}]}"#;
    let name = scratch.write("graze.json", text);
    let summary = run(&[&name, "--arithmetic", "exact"]).summary;
    let summary = summary.expect("a summary");
    assert_eq!([summary.events, summary.grazes], [0, 1]);
}

#[test]
fn overlaps_are_counted() {
    let name = scene("figure-6-still-still.json");
    let log = run(&[&name]);
    assert_eq!(log.header.expect("a header").overlaps, Some(1));
    assert_eq!(log.events, []);
}

/// Both ends of the time belong to the run.
#[test]
fn runs_end_when_they_are_told_to() {
    let name = scene("figure-7.json");
    for (until, events, place) in [("1/4", 0, 1.0), ("0.5", 1, 2.0), ("0x1p3", 1, -28.0)] {
        let scratch = Scratch::new();
        let end = scratch.name("end.json");
        let log = run(&[&name, "--until", until, "--events", "-", "--state", &end]);
        assert_eq!(log.events.len(), events);
        let summary = log.summary.expect("a summary");
        assert_eq!(summary.reached, None);
        let state = State::from_json(&scratch.read("end.json")).expect("a state");
        assert_eq!(state.time, Quantity::Computed(summary.until));
        assert_eq!(numbers(&state.discs[0].position), [place, 0.0]);
    }
}

#[test]
fn frame_algorithms_finish_their_frame() {
    let name = scene("figure-7.json");
    let log = run(&[&name, "--until", "3/2", "--algorithm", "single"]);
    let summary = log.summary.expect("a summary");
    assert_eq!((summary.until, summary.reached), (1.5, Some(2.0)));
}

#[test]
fn bodies_are_those_of_the_scene() {
    let log = run(&[&scene("timeline-2.json")]);
    let expected = [
        (0.25, "d0 d1".into()),
        (0.375, "d2 d3".into()),
        (0.5, "d0 d2".into()),
        (0.75, "d1 d3".into()),
    ];
    assert_eq!(meetings(&log), expected);
    assert_eq!(log.events[3].b, BodyId::Disc(3));
    let numbers: Vec<_> = log.events.iter().map(|event| event.n).collect();
    assert_eq!(numbers, [Some(0), Some(1), Some(2), Some(3)]);
}

/// To the last character, with enclosures.
#[test]
fn a_broad_phase_changes_nothing() {
    let name = scene("table1-full.json");
    for algorithm in ["retroactive", "single", "multiple", "synchronised"] {
        let log = |phase: &str| {
            let algorithm = ["--algorithm", algorithm, "--arithmetic", "exact"];
            let end = ["--until", "1/4", "--contact", "--broad-phase", phase];
            results(&[&["run", &name], &algorithm[..], &end[..]].concat())
        };
        let all = log("all-pairs");
        assert!(all.lines().count() > 10, "{algorithm}");
        assert!(log("grid") == all && log("bsp") == all, "{algorithm}");
    }
}

#[test]
fn the_timeline_has_no_space_partition() {
    let name = scene("figure-7.json");
    for phase in ["all-pairs", "grid"] {
        let log = run(&[&name, "--broad-phase", phase]);
        assert_eq!(meetings(&log), [(0.5, "d0 d1".into())]);
    }
    let (code, message) = ending(&["run", &name, "--broad-phase", "bsp"]);
    assert_eq!(code, 2);
    assert!(message.contains("--broad-phase bsp: expected all-pairs or grid"));
}

/// Two discs on their way around a cell: see the notes of the scene.
#[test]
fn around_a_plane_that_repeats() {
    for arithmetic in ["f64", "filtered", "exact"] {
        let log = run(&[&scene("around.json"), "--arithmetic", arithmetic]);
        let met = [(2.0, "d0 d1".into()), (10.0, "d0 d1".into())];
        assert_eq!(meetings(&log), met);
        let images = log.events.iter().map(|event| event.image);
        assert!(images.eq([Some([-1, 0]), Some([0, 0])]));
    }
    let generated = results(&["generate", "gas", "--periodic", "--count", "9"]);
    let scratch = Scratch::new();
    let log = run(&[&scratch.write("gas.json", generated)]);
    assert!(log.events.iter().all(|event| event.image.is_some()));
}
