//! What the paper's experiment costs: 150 discs for 600 frames.
//!
//! Every time is that of the whole run; a frame takes a 600th of it.

#![allow(missing_docs, reason = "the macros of criterion make public items")]

use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::Duration;

use carom::arithmetic::Arithmetic;
use carom::frame::Passes;
use carom::run::{Options, run};
use carom::scalar::Exact;
use carom::scene::Scene;
use carom::simulation::Algorithm;
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};

const ALGORITHMS: [(&str, Algorithm); 5] = [
    ("retroactive", Algorithm::Retroactive { substeps: 1 }),
    ("single", Algorithm::Single),
    ("multiple, 2 passes", Algorithm::Multiple(Passes::Count(2))),
    (
        "synchronised, 2 passes",
        Algorithm::Synchronised(Passes::Count(2)),
    ),
    ("timeline", Algorithm::Timeline),
];

fn measure<S: Arithmetic>(group: &mut BenchmarkGroup<'_, WallTime>, scene: &Scene) {
    for (name, algorithm) in ALGORITHMS {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let watch = &mut |_| ControlFlow::Continue(());
                run::<S>(black_box(scene), algorithm, &Options::default(), watch)
            });
        });
    }
}

fn table1(criterion: &mut Criterion) {
    for size in ["full", "third"] {
        let scene = Scene::read(format!("scenes/table1-{size}.json")).expect("the scene is there");
        let mut group = criterion.benchmark_group(format!("table1-{size}/f64"));
        group
            .sample_size(20)
            .measurement_time(Duration::from_secs(5));
        measure::<f64>(&mut group, &scene);
        group.finish();
        let mut group = criterion.benchmark_group(format!("table1-{size}/exact"));
        group
            .sample_size(10)
            .measurement_time(Duration::from_secs(10));
        measure::<Exact>(&mut group, &scene);
        group.finish();
    }
}

criterion_group!(benches, table1);
criterion_main!(benches);
