//! Random expressions against fixed-point integers of many digits.

use std::cmp::Ordering;

use carom::algebra::{Expression, Limits};
use carom::scalar::Scalar;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use super::whole;

/// A way to make a number.
#[derive(Clone, Debug)]
enum Recipe {
    Fraction(i64, i64),
    Sum(Box<[Recipe; 2]>),
    Difference(Box<[Recipe; 2]>),
    Product(Box<[Recipe; 2]>),
    Quotient(Box<[Recipe; 2]>),
    /// Of the magnitude.
    Root(Box<Recipe>),
}

use Recipe::{Difference, Fraction, Product, Quotient, Root, Sum};

/// The bits after the binary point.
const PLACES: u32 = 4000;

/// Numbers below 2^-SMALL are taken for zero: these recipes make none but
/// zero. Errors are below.
const SMALL: u32 = 1600;

fn is_small(n: &BigInt) -> bool {
    n.bits() < u64::from(PLACES - SMALL)
}

impl Recipe {
    /// The number times 2^PLACES, nearly; none where a divisor or a radicand
    /// is zero.
    fn fixed(&self) -> Option<BigInt> {
        Some(match self {
            Fraction(n, d) => (BigInt::from(*n) << PLACES) / d,
            Sum(parts) => parts[0].fixed()? + parts[1].fixed()?,
            Difference(parts) => parts[0].fixed()? - parts[1].fixed()?,
            Product(parts) => (parts[0].fixed()? * parts[1].fixed()?) >> PLACES,
            Quotient(parts) => {
                let divisor = parts[1].fixed().filter(|n| !is_small(n))?;
                (parts[0].fixed()? << PLACES) / divisor
            }
            Root(radicand) => {
                let radicand = radicand.fixed().filter(|n| !is_small(n))?;
                (radicand.abs() << PLACES).sqrt()
            }
        })
    }

    /// As its caller must, each radicand's sign is decided before its root.
    fn build(&self, limits: Limits) -> Expression {
        match self {
            Fraction(n, d) => {
                Expression::from_rational(BigRational::new((*n).into(), (*d).into()), limits)
            }
            Sum(parts) => parts[0].build(limits) + parts[1].build(limits),
            Difference(parts) => parts[0].build(limits) - parts[1].build(limits),
            Product(parts) => parts[0].build(limits) * parts[1].build(limits),
            Quotient(parts) => parts[0].build(limits) / parts[1].build(limits),
            Root(radicand) => {
                let radicand = radicand.build(limits);
                match radicand.sign().unwrap() {
                    Ordering::Less => (-radicand).sqrt(),
                    _ => radicand.sqrt(),
                }
            }
        }
    }

    fn roots(&self) -> usize {
        match self {
            Fraction(..) => 0,
            Root(radicand) => 1 + radicand.roots(),
            Sum(parts) | Difference(parts) | Product(parts) | Quotient(parts) => {
                parts.iter().map(Recipe::roots).sum()
            }
        }
    }
}

fn sign_of_fixed(n: &BigInt) -> Ordering {
    if is_small(n) {
        Ordering::Equal
    } else {
        n.cmp(&BigInt::zero())
    }
}

fn pair(a: Recipe, b: Recipe) -> Box<[Recipe; 2]> {
    Box::new([a, b])
}

fn recipe(most_roots: usize) -> impl Strategy<Value = Recipe> {
    let leaf = (-9..10_i64, 1..5_i64).prop_map(|(n, d)| Fraction(n, d));
    let any = leaf.prop_recursive(6, 32, 2, |inner| {
        let two = (inner.clone(), inner.clone());
        prop_oneof![
            1 => two.clone().prop_map(|(a, b)| Sum(pair(a, b))),
            1 => two.clone().prop_map(|(a, b)| Difference(pair(a, b))),
            1 => two.clone().prop_map(|(a, b)| Product(pair(a, b))),
            1 => two.prop_map(|(a, b)| Quotient(pair(a, b))),
            4 => inner.prop_map(|a| Root(Box::new(a))),
        ]
    });
    any.prop_filter("few roots, and a number", move |recipe| {
        recipe.roots() <= most_roots && recipe.fixed().is_some()
    })
}

/// Ways to write zero with two numbers, neither zero.
fn zeros(x: &Expression, y: &Expression) -> Vec<Expression> {
    let (two, sum) = (whole(2), x.clone() + y);
    let size = if x.sign() == Ok(Ordering::Less) {
        -x.clone()
    } else {
        x.clone()
    };
    let root = size.sqrt();
    vec![
        sum.square() - x.square() - two.clone() * x * y - y.square(),
        (x.square() - y.square()) - sum.clone() * (x.clone() - y),
        x.clone() / y - whole(1) / (y.clone() / x),
        (sum.clone() / y - whole(1)) * y - x,
        x.square().sqrt() - root.square(),
        // √(|x| + y² + 2 y √|x|) = |y + √|x||, squared.
        (size.clone() + y.square() + two * y * &root)
            .sqrt()
            .square()
            - (root.clone() + y).square(),
        (root.clone() + whole(1)) * (root - whole(1)) - size + whole(1),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn signs_are_those_of_fixed_point(recipe in recipe(4)) {
        let expected = sign_of_fixed(&recipe.fixed().unwrap());
        prop_assert_eq!(recipe.build(Limits::default()).sign(), Ok(expected));
    }

    #[test]
    fn orders_are_those_of_fixed_point(a in recipe(3), b in recipe(2)) {
        let build = |recipe: &Recipe| recipe.build(Limits::default());
        let expected = sign_of_fixed(&(a.fixed().unwrap() - b.fixed().unwrap()));
        prop_assert_eq!(build(&a).compare(&build(&b)), Ok(expected));
    }

    #[test]
    fn constructed_zeros_are_zero(a in recipe(3), b in recipe(2)) {
        let (x, y) = (a.build(Limits::default()), b.build(Limits::default()));
        prop_assume!([&x, &y].iter().all(|n| n.sign().unwrap().is_ne()));
        for (place, zero) in zeros(&x, &y).into_iter().enumerate() {
            prop_assert_eq!(zero.sign(), Ok(Ordering::Equal), "{}", place);
        }
    }

    /// Where either way is closed, the other one gives the same answer, or
    /// none.
    #[test]
    fn each_way_alone_makes_no_mistake(a in recipe(2), b in recipe(1)) {
        let tower = Limits { bound_bits: 0, ..Limits::default() };
        let bound = Limits { radicals: 0, ..Limits::default() };
        for limits in [tower, bound] {
            let (x, y) = (a.build(limits), b.build(limits));
            prop_assume!([&x, &y].iter().all(|n| n.sign().is_ok_and(Ordering::is_ne)));
            for (place, zero) in zeros(&x, &y).into_iter().enumerate() {
                let proven = zero.sign() == Ok(Ordering::Equal);
                prop_assert!(proven || (limits == bound && zero.sign().is_err()), "{}", place);
            }
        }
    }
}
