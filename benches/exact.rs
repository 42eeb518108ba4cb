//! What the truth costs: whole runs of the exact timeline.

#![allow(missing_docs, reason = "the macros of criterion make public items")]

use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::Duration;

use carom::run::{Options, run};
use carom::scalar::{Exact, Number};
use carom::scene::Scene;
use carom::scene::generate::{galperin, gas, ring};
use carom::simulation::Algorithm;
use criterion::{Criterion, criterion_group, criterion_main};

/// So many impacts, or the whole of a scene.
fn follow(scene: &Scene, impacts: Option<u64>) -> usize {
    let options = Options {
        until: impacts.map(|_| Number::from(1_000_000)),
        max_events: impacts.unwrap_or(u64::MAX),
        ..Options::default()
    };
    let go_on = &mut |_| ControlFlow::Continue(());
    let outcome = run::<Exact>(scene, Algorithm::Timeline, &options, go_on);
    outcome.expect("the scene is supported").impacts.len()
}

fn exact(criterion: &mut Criterion) {
    let ten = gas(42, 10, 0.3).expect("a gas");
    let table1 = Scene::read("scenes/table1-full.json").expect("the scene is there");
    let runs = [
        ("10 discs, 1000 impacts", &ten, Some(1000)),
        ("10 discs, 8000 impacts", &ten, Some(8000)),
        ("Table 1, 600 frames", &table1, None),
        (
            "Galperin, 3141 impacts",
            &galperin(3).expect("a scene"),
            None,
        ),
        (
            "1000 discs, 5000 impacts",
            &gas(1, 1000, 0.3).expect("a gas"),
            Some(5000),
        ),
        (
            "a ring of 40, 200 impacts",
            &ring(40).expect("a ring"),
            Some(200),
        ),
    ];
    let mut group = criterion.benchmark_group("exact");
    group
        .sample_size(10)
        .warm_up_time(Duration::from_secs(1))
        .measurement_time(Duration::from_secs(5));
    for (name, scene, impacts) in runs {
        group.bench_function(name, |bencher| {
            bencher.iter(|| follow(black_box(scene), impacts));
        });
    }
    group.finish();
}

criterion_group!(benches, exact);
criterion_main!(benches);
