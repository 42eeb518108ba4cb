//! What is written reads back as the same scene.

use super::*;

fn again(scene: &Scene) -> Scene {
    Scene::from_json(&scene.to_json()).expect("what was written")
}

#[test]
fn the_example_round_trips() {
    let scene = Scene::from_json(EXAMPLE).expect("the example");
    assert_eq!(again(&scene), scene);
    let compact = serde_json::to_string(&scene).expect("text");
    assert_eq!(Scene::from_json(&compact).expect("a scene"), scene);
}

#[test]
fn every_binary64_round_trips() {
    let mut bits = Bits(2);
    let numbers: Vec<f64> = (0..10_000).map(|_| bits.positive()).collect();
    let extremes = [5e-324, f64::MIN_POSITIVE, f64::MAX, 2_f64.powi(53), 0.1];
    let all = numbers.iter().chain(&extremes);
    let discs = all.clone().map(|&x| Disc::at([x, -x], x));
    let scene = Scene::builder("random")
        .discs(discs)
        .build()
        .expect("a scene");
    for (disc, &expected) in again(&scene).discs().iter().zip(all) {
        let radius = disc.radius.to_f64();
        assert_eq!(radius.to_bits(), expected.to_bits());
        assert_eq!(disc.position, [number(expected), number(-expected)]);
    }
}

#[test]
fn every_exact_number_round_trips() {
    let mut bits = Bits(3);
    for _ in 0..10_000 {
        let [a, b] = [bits.next() | 1, bits.next() | 1];
        let exponent = (b % 200) as i32 - 100;
        for text in [
            format!("{a}"),
            format!("{a}/{b}"),
            format!("{a}.{b}"),
            format!("{a}e{exponent}"),
            format!("0x{a:x}.{b:x}p{exponent}"),
        ] {
            let scene = with_radius(&format!("\"{text}\"")).expect(&text);
            assert_eq!(radius(&again(&scene)), radius(&scene), "{text}");
        }
    }
}

#[test]
fn every_kind_of_restitution_round_trips() {
    for restitution in [
        r#"{"newton": 1}"#,
        r#"{"newton": 0, "walls": "1/3"}"#,
        r#"{"newton": "0.9", "walls": 1, "elastic_below": 1e-6}"#,
        r#"{"paper": "1/3"}"#,
    ] {
        let text = EXAMPLE.replace(r#"{"newton": "9/10"}"#, restitution);
        let scene = Scene::from_json(&text).expect(restitution);
        assert_eq!(again(&scene), scene);
    }
}

#[test]
fn a_disc_has_a_line() {
    let scene = with_radius(r#""1/3""#).expect("a scene");
    let lines = [
        r#"{"#,
        r#"  "schema": "carom/scene/1","#,
        r#"  "id": "scene","#,
        r#"  "discs": ["#,
        r#"    {"position": [0, 0], "velocity": [0, 0], "radius": "1/3", "mass": 1}"#,
        r#"  ],"#,
        r#"  "frame": {"duration": 1, "count": 1}"#,
        r#"}"#,
        "",
    ];
    assert_eq!(scene.to_json(), lines.join("\n"));
}
