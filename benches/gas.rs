//! Impacts of a gas of discs, event-driven, in binary64 and filtered.

#![allow(missing_docs, reason = "the macros of criterion make public items")]

use std::convert::Infallible;
use std::hint::black_box;

use carom::arithmetic::Arithmetic;
use carom::scalar::Filtered;
use carom::scene::generate::gas;
use carom::timeline::Timeline;
use carom::world::World;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// So many impacts are one measurement.
const IMPACTS: u64 = 10_000;

fn gases(criterion: &mut Criterion) {
    for packing in [0.2, 0.5] {
        for count in [150, 1000, 10_000, 100_000] {
            follow::<f64>(criterion, count, packing);
            follow::<Filtered>(criterion, count, packing);
        }
    }
}

fn follow<S>(criterion: &mut Criterion, count: u32, packing: f64)
where
    S: Arithmetic<Precision = (), Doubt = Infallible>,
{
    let mut group = criterion.benchmark_group(format!("gas, packing {packing}"));
    group
        .throughput(Throughput::Elements(IMPACTS))
        .sample_size(10);
    let scene = gas(42, count, packing).expect("a valid scene");
    let end = S::from_integer(i32::MAX);
    let Ok(mut timeline) = Timeline::new(World::<S>::new(&scene, ()), &end);
    group.bench_function(BenchmarkId::new(S::NAME, count), |bencher| {
        bencher.iter(|| {
            for _ in 0..IMPACTS {
                let Ok(impact) = timeline.next_impact(&end);
                black_box(impact);
            }
        });
    });
    group.finish();
}

criterion_group!(benches, gases);
criterion_main!(benches);
