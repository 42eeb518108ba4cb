//! A run as a Chrome trace, which opens in Perfetto: a track for each body, a slice for each
//! leg of a disc between its impacts, and arrows between the bodies that collide.
//!
//! A second of simulated time is a second of the trace.

use std::collections::HashMap;

use carom::arithmetic::Arithmetic;
use carom::body::BodyId;
use carom::run::Outcome;
use carom::scalar::Scalar;
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
        let mut begun: HashMap<BodyId, (f64, String)> = HashMap::new();
        for (number, impact) in outcome.impacts.iter().enumerate() {
            let times = [
                &impact.time,
                impact.other_time.as_ref().unwrap_or(&impact.time),
            ];
            let bodies = [impact.pair.a, impact.pair.b];
            let name = impact.pair.to_string();
            for (body, time) in bodies.into_iter().zip(times.map(Scalar::to_f64)) {
                let leg = begun.insert(body, (time, format!("after {name}")));
                events.extend(tracks.leg(body, leg, time));
            }
            let [one, other] = times.map(Scalar::to_f64);
            events.extend(tracks.arrow(number, &name, [(bodies[0], one), (bodies[1], other)]));
        }
        let end = outcome.time.to_f64();
        for index in 0..tracks.discs as u32 {
            let disc = BodyId::Disc(index);
            let leg = begun.remove(&disc);
            events.extend(tracks.leg(disc, leg, end));
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

    /// What a disc does up to a time, since the start or its impact before. Walls do
    /// nothing.
    fn leg(&self, body: BodyId, since: Option<(f64, String)>, until: f64) -> Option<TraceEvent> {
        let (begun, name) = since.unwrap_or_else(|| (0.0, String::from("start")));
        matches!(body, BodyId::Disc(_)).then(|| TraceEvent {
            dur: Some((until - begun) * MICROSECONDS),
            ..self.event(&name, Phase::Slice, body, begun)
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
