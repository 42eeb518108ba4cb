//! Random scenes under gravity: whatever the log says must follow the laws of
//! motion, and it must not be silent about anything.

#[path = "gravity_laws/case.rs"]
mod case;
#[path = "gravity_laws/law.rs"]
mod law;
#[path = "gravity_laws/mirror.rs"]
mod mirror;
#[path = "gravity_laws/reversal.rs"]
mod reversal;

use carom::arithmetic::{Arithmetic, Budget};
use carom::run::Options;
use carom::scalar::Exact;
use carom::simulation::Algorithm;

use crate::common::attempt;
use case::Family;

const GENERIC: Family = Family {
    grain: 1024.0,
    discs: 4,
    boxed: true,
    walls: 2,
    pegs: 0,
    pistons: false,
    drag: 0.0,
    kept: 1.0,
    elastic_below: None,
    touching: false,
    duration: 3.0,
};

const LATTICE: Family = Family {
    grain: 1.0,
    pegs: 1,
    touching: true,
    ..GENERIC
};

/// Checks the runs of so many scenes of each of some families.
fn check<S: Arithmetic>(families: &[Family], count: u64, options: &Options) {
    for family in families {
        for seed in 0..count {
            let case = family.case(seed);
            let outcome = attempt::<S>(&case.scene(), Algorithm::Timeline, options);
            if let Err(text) = law::check(&case, &outcome) {
                panic!("{text}\n{family:?}, {seed}: {case:?}");
            }
        }
    }
}

/// The same families in binary64, and in short in exact arithmetic.
fn check_both(families: &[Family]) {
    check_some(families, 200, 20);
}

fn check_some(families: &[Family], rounded: u64, exact: u64) {
    let options = Options {
        contacts: true,
        max_events: 500,
        ..Options::default()
    };
    check::<f64>(families, rounded, &options);
    let options = Options {
        max_events: 10,
        budget: Budget {
            most_bits: 512,
            ..Budget::default()
        },
        ..options
    };
    check::<Exact>(families, exact, &options);
}

#[test]
fn elastic_discs() {
    let open = Family {
        boxed: false,
        walls: 4,
        pegs: 2,
        ..GENERIC
    };
    let pegs = Family { pegs: 3, ..GENERIC };
    let lattice = Family { grain: 2.0, ..open };
    check_both(&[GENERIC, pegs, open, lattice]);
}

#[test]
fn elastic_discs_that_start_in_contact() {
    let open = Family {
        boxed: false,
        walls: 3,
        grain: 2.0,
        ..LATTICE
    };
    check_both(&[LATTICE, open]);
}

#[test]
fn pistons() {
    let pistons = |family| Family {
        pistons: true,
        pegs: 2,
        ..family
    };
    check_both(&[GENERIC, LATTICE].map(pistons));
}

#[test]
fn lossy_discs() {
    let lossy = |family| Family {
        kept: 0.5,
        ..family
    };
    let below = |family| Family {
        elastic_below: Some(1.0),
        ..lossy(family)
    };
    check_both(&[GENERIC, LATTICE].map(lossy));
    check_both(&[GENERIC, LATTICE].map(below));
}

#[test]
fn discs_that_do_not_bounce() {
    let dead = |family| Family {
        kept: 0.0,
        ..family
    };
    let alone = |family| Family {
        discs: 1,
        walls: 4,
        ..dead(family)
    };
    check_both(&[GENERIC, LATTICE].map(dead));
    check_both(&[GENERIC, LATTICE].map(alone));
}

/// The same through air, where each impact takes longer to compute.
#[test]
fn with_drag() {
    let through = |drag, family| Family { drag, ..family };
    let open = Family {
        boxed: false,
        walls: 4,
        pegs: 2,
        pistons: true,
        ..LATTICE
    };
    let lossy = Family {
        kept: 0.5,
        elastic_below: Some(1.0),
        ..GENERIC
    };
    let dead = Family {
        kept: 0.0,
        ..LATTICE
    };
    let families = [GENERIC, LATTICE, open].map(|family| through(0.5, family));
    check_some(&families, 40, 4);
    let families = [lossy, dead].map(|family| through(0.125, family));
    check_some(&families, 40, 4);
    check_some(&[through(4.0, GENERIC)], 40, 4);
}
