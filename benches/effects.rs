//! What an effect costs an impact: a gas in a box, event-driven, without effects,
//! under drag, under gravity, and under both.

#![allow(missing_docs, reason = "the macros of criterion make public items")]

use std::hint::black_box;
use std::ops::ControlFlow;

use carom::arithmetic::Arithmetic;
use carom::run::{Options, run};
use carom::scalar::{Exact, Filtered, Number};
use carom::scene::Scene;
use carom::scene::generate::gas;
use carom::simulation::Algorithm;
use carom::support::check_support;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn effects(criterion: &mut Criterion) {
    measure::<f64>(criterion, 100, 10_000);
    measure::<Filtered>(criterion, 100, 2_000);
    measure::<Exact>(criterion, 10, 100);
}

/// So many impacts of so many discs.
fn measure<S: Arithmetic>(criterion: &mut Criterion, discs: u32, impacts: u64) {
    let mut group = criterion.benchmark_group(format!("effects, {}", S::NAME));
    group
        .throughput(Throughput::Elements(impacts))
        .sample_size(10);
    let scene = gas(42, discs, 0.2).expect("a valid scene");
    let calm = || scene.to_builder().frame(1000, 1);
    let scenes = [
        ("none", calm()),
        ("drag", calm().linear_drag("1/1000")),
        ("gravity", calm().gravity(["0", "-1/10"])),
        ("both", calm().gravity(["0", "-1/10"]).linear_drag("1/1000")),
    ];
    for (name, scene) in scenes {
        let scene = scene.build().expect("a valid scene");
        if check_support::<S>(&scene, Algorithm::Timeline).is_ok() {
            group.bench_function(name, |bencher| {
                bencher.iter(|| black_box(follow::<S>(&scene, impacts)));
            });
        }
    }
    group.finish();
}

fn follow<S: Arithmetic>(scene: &Scene, impacts: u64) -> usize {
    let options = Options {
        max_events: impacts,
        until: Some(Number::from(1000)),
        ..Options::default()
    };
    let outcome = run::<S>(scene, Algorithm::Timeline, &options, &mut |_| {
        ControlFlow::Continue(())
    });
    outcome.expect("a supported scene").impacts.len()
}

criterion_group!(benches, effects);
criterion_main!(benches);
