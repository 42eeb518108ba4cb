//! A run as a Chrome trace, which opens in Perfetto: a track for each body, a slice for each
//! leg of a disc between its impacts, and arrows between the bodies that collide.
//!
//! A second of simulated time is a second of the trace.

use carom::arithmetic::Arithmetic;
use carom::body::BodyId;
use carom::impact::Impact;
use carom::run::Outcome;
use serde::Serialize;

/// Microseconds in a second, the unit of traces.
const MICROSECONDS: f64 = 1e6;

/// A trace, in the form of an object.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Trace {
    trace_events: Vec<TraceEvent>,
    display_time_unit: &'static str,
}

/// An event of a trace: a slice, the end of an arrow, or the name of a track.
#[derive(Serialize)]
struct TraceEvent {
    name: String,
    cat: &'static str,
    ph: Phase,
    ts: f64,
    pid: u32,
    tid: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    dur: Option<f64>,
    /// What the two ends of an arrow have in common.
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<usize>,
    /// An arrow ends at the slice around it.
    #[serde(skip_serializing_if = "Option::is_none")]
    bp: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    args: Option<Named>,
}

#[derive(Clone, Copy, Serialize)]
enum Phase {
    #[serde(rename = "X")]
    Slice,
    #[serde(rename = "s")]
    Start,
    #[serde(rename = "f")]
    Finish,
    #[serde(rename = "M")]
    Metadata,
}

#[derive(Serialize)]
struct Named {
    name: String,
}

/// The bodies of an impact, and when it happens on the clock of each.
fn ends<S: Arithmetic>(impact: &Impact<S>) -> [(BodyId, f64); 2] {
    let time = impact.time.to_f64();
    let other = impact.other_time.as_ref().map_or(time, S::to_f64);
    [(impact.pair.a, time), (impact.pair.b, other)]
}

/// The tracks of discs, with those of walls after them.
struct Tracks {
    discs: usize,
}

impl Trace {
    /// The trace of a run with so many walls.
    pub(super) fn of<S: Arithmetic>(outcome: &Outcome<S>, walls: usize) -> Self {
        let tracks = Tracks {
            discs: outcome.start.len(),
        };
        let mut events = tracks.names(walls);
        let mut turns = vec![Vec::new(); tracks.discs];
        for (number, impact) in outcome.impacts.iter().enumerate() {
            let name = impact.pair.to_string();
            let ends = ends(impact);
            for (body, time) in ends {
                if let BodyId::Disc(disc) = body {
                    turns[disc as usize].push((time, format!("after {name}")));
                }
            }
            events.extend(tracks.arrow(number, &name, ends));
        }
        let end = outcome.time.to_f64();
        for (disc, turns) in (0..).map(BodyId::Disc).zip(turns) {
            events.extend(tracks.legs(disc, turns, end));
        }
        Self {
            trace_events: events,
            display_time_unit: "ms",
        }
    }
}

impl Tracks {
    fn of(&self, body: BodyId) -> u32 {
        match body {
            BodyId::Disc(index) => index,
            BodyId::Wall(index) => self.discs as u32 + index,
        }
    }

    /// The names of all tracks.
    fn names(&self, walls: usize) -> Vec<TraceEvent> {
        let discs = (0..self.discs as u32).map(BodyId::Disc);
        let bodies = discs.chain((0..walls as u32).map(BodyId::Wall));
        let names = bodies.map(|body| TraceEvent {
            args: Some(Named {
                name: body.to_string(),
            }),
            ..self.event("thread_name", Phase::Metadata, body, 0.0)
        });
        names.collect()
    }

    /// What a disc does between its impacts, up to the end. Those of a frame algorithm
    /// need not stand in the order of its clock.
    fn legs(
        &self,
        disc: BodyId,
        mut turns: Vec<(f64, String)>,
        end: f64,
    ) -> impl Iterator<Item = TraceEvent> {
        turns.insert(0, (0.0, String::from("start")));
        turns.sort_by(|one, other| one.0.total_cmp(&other.0));
        let times: Vec<f64> = turns.iter().map(|(time, _)| *time).collect();
        let ends = times.into_iter().skip(1).chain([end]);
        turns
            .into_iter()
            .zip(ends)
            .map(move |((begun, name), end)| TraceEvent {
                dur: Some((end - begun) * MICROSECONDS),
                ..self.event(&name, Phase::Slice, disc, begun)
            })
    }

    /// The arrow of an impact, from the leg that it ends to that which it begins.
    fn arrow(&self, number: usize, name: &str, ends: [(BodyId, f64); 2]) -> [TraceEvent; 2] {
        let [(one, time), (other, other_time)] = ends;
        let id = Some(number);
        [
            TraceEvent {
                id,
                ..self.event(name, Phase::Start, one, time)
            },
            TraceEvent {
                id,
                bp: Some("e"),
                ..self.event(name, Phase::Finish, other, other_time)
            },
        ]
    }

    fn event(&self, name: &str, ph: Phase, body: BodyId, time: f64) -> TraceEvent {
        TraceEvent {
            name: name.to_owned(),
            cat: "impact",
            ph,
            ts: time * MICROSECONDS,
            pid: 0,
            tid: self.of(body),
            dur: None,
            id: None,
            bp: None,
            args: None,
        }
    }
}
