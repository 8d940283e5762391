//! The references against exact arithmetic, where `f64` could have lost something: roots of squares and of
//! quartics.

use super::cone::Cone;
use super::measure::drawn;
use super::method::Query;
use super::subject::{GROWTH, Kind, Spans, Subject};
use super::torus::Torus;
use testkit::cone_oracle;
use testkit::number::{coordinates, vector};
use testkit::quartic::Quartic;
use testkit::ulp::{ulp_at, ulps};

/// Rays of each kind.
const RAYS: usize = 64;

/// How far a reference may be off, in ulps of an `f32`, of parameters of 10⁻³ at least.
const MOST: f64 = 0.05;

fn held<Q: Subject>(Query { solid, ray }: Query<Q>) -> Query<Q> {
    let ray = ray.map(|v| coordinates(vector::<f32>(v)));
    Query { solid: solid.rounded::<f32>(), ray }
}

/// The number of rays whose spans agree.
pub fn check_references() -> Result<usize, String> {
    let mut count = 0;
    for (kind, name) in Kind::ALL {
        for Query { solid, ray } in drawn::<Cone>(kind, name, RAYS).into_iter().map(held) {
            let exact = |growth: f64| {
                let growth = (growth * 2f64.powi(40)) as i64;
                cone_oracle::span(&solid.query(ray), growth)
                    .map(|ends| ends.map(|end| cone_oracle::to_f64(&end)))
            };
            let grown = [GROWTH, -GROWTH].map(exact);
            let got = [GROWTH, -GROWTH].map(|growth| solid.spans(ray, growth)[0]);
            let is_same = (0..2).all(|i| grown[i].is_some() == got[i].is_some());
            let is_clear = grown[0].is_some() == grown[1].is_some();
            let off = exact(0.0).zip(solid.spans(ray, 0.0)[0]).map_or(0.0, |(want, got)| {
                (0..2).map(|i| error(got[i], want[i])).fold(0.0, f64::max)
            });
            if !is_same || is_clear && off > MOST {
                return Err(format!("cone {name}: {:?} is {off} off", solid.query(ray)));
            }
            count += 1;
        }
        for Query { solid, ray } in drawn::<Torus>(kind, name, RAYS).into_iter().map(held) {
            let model = solid.model();
            let [exact, more, less] = [0, 1, -1].map(|by| Quartic::new(&model, ray[0], ray[1], by));
            let spans = solid.spans(ray, 0.0);
            let is_clear = more.roots().0 == less.roots().0;
            let is_same = 2 * spans.iter().flatten().count() == exact.roots().0;
            let off = largest_error(&exact, &spans);
            if is_clear && !(is_same && off.is_some_and(|off| off <= MOST)) {
                return Err(format!("torus {name}: {model:?} {ray:?} is {off:?} off"));
            }
            count += 1;
        }
    }
    Ok(count)
}

fn error(got: f64, want: f64) -> f64 {
    ulps(got, want) * ulp_at(want) / ulp_at(want.abs().max(1e-3))
}

/// Of roots, in ulps of an `f32`; `None` if one is far off.
fn largest_error(quartic: &Quartic, spans: &Spans<f64>) -> Option<f64> {
    // The oracle counts in sixteenths of its unit.
    const UNIT: f64 = 1.0 / 64.0;
    let mut largest = 0.0;
    for (t, inwards) in
        spans.iter().flatten().flat_map(|[t_in, t_out]| [(*t_in, true), (*t_out, false)])
    {
        let unit = (UNIT * ulp_at(t.abs().max(1e-3))).log2() as i32;
        largest = quartic.error(t, unit, inwards)?.max(largest);
    }
    Some(UNIT * largest)
}
