//! What is read, and what the numbers in it mean.

use super::*;

#[test]
fn the_interface_example_loads_exactly() {
    let scene = Scene::from_json(EXAMPLE).expect("the example");
    assert_eq!(scene.id(), "example");
    assert_eq!(scene.notes(), Some("free text"));
    let [first, second] = scene.discs() else {
        panic!("two discs");
    };
    assert_eq!(exact(&first.velocity), point("3/2", "0"));
    assert_eq!(first.mass, Mass::Finite(number(1)));
    assert_eq!(exact(&second.position), point("5", "1/3"));
    assert_eq!(second.mass, Mass::Infinite);
    assert_eq!(exact(&scene.walls()[0].from), point("-1", "-1"));
    assert_eq!(exact(&scene.walls()[0].to), point("10", "-1"));
    assert_eq!(scene.periodic(), None);
    assert_eq!(scene.frame().total(), ratio(10, 1));
    let effects = scene.effects();
    assert_eq!(effects.restitution, Restitution::newton(number("9/10")));
    assert_eq!(
        effects.gravity.as_ref().map(exact),
        Some(point("0", "-9.81"))
    );
    assert_eq!(effects.drag, Some(number("1/10")));
}

#[test]
fn what_is_absent_has_its_default() {
    let scene = with_radius("1").expect("a scene");
    assert_eq!(scene.id(), "scene");
    assert_eq!(scene.notes(), None);
    assert_eq!(exact(&scene.discs()[0].velocity), point("0", "0"));
    assert_eq!(scene.discs()[0].mass, Mass::Finite(number(1)));
    assert!(scene.walls().is_empty());
    assert_eq!(scene.frame().total(), ratio(1, 1));
    assert_eq!(scene.effects().restitution, Restitution::Elastic);
    assert_eq!(scene.effects().gravity, None);
}

#[test]
fn a_bare_number_is_a_binary64_and_a_string_is_exact() {
    let tenth = ratio(1, 10);
    let exact = with_radius(r#""0.1""#).expect("a scene");
    assert_eq!(radius(&exact).to_rational(), tenth);
    let bare = with_radius("0.1").expect("a scene");
    assert_ne!(radius(&bare).to_rational(), tenth);
    assert_eq!(
        radius(&bare).to_rational(),
        ratio(0x0019_9999_9999_999a, 1 << 56)
    );
}

/// The standard library's parser is the reference.
#[test]
fn a_bare_number_is_rounded_correctly() {
    let mut bits = Bits(1);
    for _ in 0..10_000 {
        let [a, b] = [bits.next(), bits.next()];
        let exponent = (b % 600) as i32 - 320;
        for text in [
            format!("{a}"),
            format!("{a}{b}"),
            format!("{a}.{b}"),
            format!("0.{a:020}{b}"),
            format!("{a}.{b}e{exponent}"),
        ] {
            let expected: f64 = text.parse().expect("a number");
            if expected == 0.0 || expected.is_infinite() {
                continue;
            }
            let scene = with_radius(&text).expect(&text);
            assert_eq!(radius(&scene), &number(expected), "{text}");
        }
    }
}

#[test]
fn whole_numbers_beyond_53_bits_round_to_even() {
    for (text, expected) in [
        ("9007199254740993", 9_007_199_254_740_992),
        ("9007199254740995", 9_007_199_254_740_996),
        ("9223372036854775807", 1 << 63),
    ] {
        let scene = with_radius(text).expect(text);
        let expected = BigRational::from_integer(i128::into(expected));
        assert_eq!(radius(&scene).to_rational(), expected, "{text}");
    }
}

#[test]
fn zero_gravity_and_zero_drag_are_none() {
    let text = EXAMPLE
        .replace(r#""-981/100""#, "-0.0")
        .replace(r#""1/10""#, "0");
    let scene = Scene::from_json(&text).expect("a scene");
    assert_eq!(scene.effects().gravity, None);
    assert_eq!(scene.effects().drag, None);
}
