//! What the frame algorithms cost in each broad phase, by the number of discs.
//!
//! A measurement is the first frame of a gas, of which a few discs in a hundred
//! collide, or are near to it.

#![allow(missing_docs, reason = "the macros of criterion make public items")]

use std::convert::Infallible;
use std::hint::black_box;
use std::time::Duration;

use carom::arithmetic::Arithmetic;
use carom::frame::{BroadPhase, Candidates, Frame, Passes, multiple, retroactive};
use carom::impact::Impact;
use carom::scalar::{Filtered, Number};
use carom::scene::generate::gas;
use carom::world::World;
use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};

const PHASES: [(&str, BroadPhase); 3] = [
    ("all-pairs", BroadPhase::AllPairs),
    ("grid", BroadPhase::Grid),
    ("bsp", BroadPhase::Bsp),
];

type Step<S> = fn(&mut World<S>, &Frame<S>, &mut Candidates) -> Vec<Impact<S>>;

fn gases(criterion: &mut Criterion) {
    for count in [150, 1000, 10_000] {
        follow::<f64>(criterion, count);
        follow::<Filtered>(criterion, count);
    }
}

fn follow<S>(criterion: &mut Criterion, count: u32)
where
    S: Arithmetic<Precision = (), Doubt = Infallible>,
{
    let algorithms: [(&str, Step<S>); 2] = [
        ("retroactive", |world, frame, candidates| {
            let Ok(impacts) = retroactive(world, frame, 1, candidates);
            impacts
        }),
        ("multiple 2", |world, frame, candidates| {
            let Ok(impacts) = multiple(world, frame, Passes::Count(2), candidates);
            impacts
        }),
    ];
    let scene = gas(42, count, 0.3).expect("a valid scene");
    let world = World::<S>::new(&scene, ());
    let number = |text: &str| S::from_number(&text.parse::<Number>().expect("a number"), ());
    let frame = Frame {
        number: 0,
        start: number("0"),
        duration: number("1/60"),
    };
    for (name, step) in algorithms {
        let mut group = criterion.benchmark_group(format!("{name}/{}", S::NAME));
        group.sample_size(10);
        group.measurement_time(Duration::from_secs(2));
        for (phase, candidates) in PHASES {
            let mut candidates = Candidates::new(candidates);
            group.bench_function(BenchmarkId::new(phase, count), |bencher| {
                let start = || world.clone();
                let frame = |world: &mut World<S>| black_box(step(world, &frame, &mut candidates));
                bencher.iter_batched_ref(start, frame, BatchSize::LargeInput);
            });
        }
        group.finish();
    }
}

criterion_group!(benches, gases);
criterion_main!(benches);
