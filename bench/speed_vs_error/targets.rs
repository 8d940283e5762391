//! What the shipped methods have to reach, set by set. Accuracy only: a time would fail or pass with
//! the machine.

use crate::accuracy::Accuracy;
use crate::methods::Inputs;
use crate::rays::{Group, Set};
use Group::{
    Benign, BenignMoved, Far, FarMoved, Fixed, FixedShort, Graze, GrazeMoved, Huge, Inside,
    InsideMoved, Invalid, NearParallel, PastOrigin, Rim, Sphere, SphereGraze, SphereInside,
    SphereNear, Tiny,
};
use Groups::{AllBut, Only};
use testkit::limits::{
    ELSEWHERE_MAX_IN, ELSEWHERE_MAX_OUT, FIXED_MAX, FIXED_P99, HARD_P99, POINT_F32, POINT_FIXED,
    SHARP_MAX, SHARP_P99,
};
use testkit::ulp::percentiles;

/// Some groups of sets.
#[derive(Clone, Copy)]
enum Groups {
    Only(&'static [Group]),
    AllBut(&'static [Group]),
}

impl Groups {
    fn have(self, group: Group) -> bool {
        match self {
            Only(groups) => groups.contains(&group),
            AllBut(groups) => !groups.contains(&group),
        }
    }
}

/// An upper limit for a figure on every set of some groups.
struct Target {
    what: &'static str,
    groups: Groups,
    figure: fn(&Accuracy) -> f64,
    limit: f64,
}

/// Where no robust class may be wrong.
const JUDGED: Groups = AllBut(&[Rim, Fixed, FixedShort, Invalid]);
/// Where hit points are on the face that is seen, with its ends.
const POINTED: Groups = AllBut(&[Fixed, FixedShort, Invalid]);
const SHARP: Groups = Only(&[Benign, Far, Graze, GrazeMoved, SphereGraze]);
const SHARP_ENOUGH: Groups =
    Only(&[NearParallel, Tiny, Huge, Inside, InsideMoved, PastOrigin, SphereInside, SphereNear]);
/// Where plain sums begin with a difference that is rounded: to an axis or a centre that isn't at 0.
const ELSEWHERE: Groups = Only(&[BenignMoved, FarMoved, Sphere]);

const TARGETS: &[Target] = &[
    Target { what: "wrong robust classes", groups: JUDGED, figure: wrong, limit: 0.0 },
    Target { what: "valid rays not answered", groups: JUDGED, figure: unanswered, limit: 0.0 },
    Target { what: "t_in, p99 ulps", groups: SHARP, figure: |of| p99(of, 0), limit: SHARP_P99 },
    Target { what: "t_out, p99 ulps", groups: SHARP, figure: |of| p99(of, 1), limit: SHARP_P99 },
    Target { what: "t_in, max ulps", groups: SHARP, figure: |of| max(of, 0), limit: SHARP_MAX },
    Target { what: "t_out, max ulps", groups: SHARP, figure: |of| max(of, 1), limit: SHARP_MAX },
    Target {
        what: "t_in, p99 ulps",
        groups: SHARP_ENOUGH,
        figure: |of| p99(of, 0),
        limit: HARD_P99,
    },
    Target {
        what: "t_out, p99 ulps",
        groups: SHARP_ENOUGH,
        figure: |of| p99(of, 1),
        limit: HARD_P99,
    },
    Target { what: "t_in, p99 ulps", groups: ELSEWHERE, figure: |of| p99(of, 0), limit: HARD_P99 },
    Target { what: "t_out, p99 ulps", groups: ELSEWHERE, figure: |of| p99(of, 1), limit: HARD_P99 },
    Target {
        what: "t_in, max ulps",
        groups: ELSEWHERE,
        figure: |of| max(of, 0),
        limit: ELSEWHERE_MAX_IN,
    },
    Target {
        what: "t_out, max ulps",
        groups: ELSEWHERE,
        figure: |of| max(of, 1),
        limit: ELSEWHERE_MAX_OUT,
    },
    Target {
        what: "hit point off the surface, in r",
        groups: POINTED,
        figure: point,
        limit: POINT_F32,
    },
    Target {
        what: "hits of invalid rays, panics",
        groups: Only(&[Invalid]),
        figure: bad,
        limit: 0.0,
    },
];

/// All but invalid rays, rims included: nothing is left out where classes are exact.
const VALID: Groups = AllBut(&[Invalid]);
/// Where a chord is seldom shorter than a unit of the parameter.
const LONG: Groups = AllBut(&[Huge, FixedShort, Invalid]);

/// What fixed point has to reach on every set of which it can hold a ray.
const FIXED: &[Target] = &[
    Target { what: "wrong classes", groups: VALID, figure: wrong, limit: 0.0 },
    Target { what: "valid rays not answered", groups: VALID, figure: unanswered, limit: 0.0 },
    Target { what: "ends not nearest", groups: VALID, figure: misrounded, limit: 0.0 },
    Target { what: "t_in, p99 LSB", groups: LONG, figure: |of| p99(of, 0), limit: FIXED_P99 },
    Target { what: "t_out, p99 LSB", groups: LONG, figure: |of| p99(of, 1), limit: FIXED_P99 },
    Target { what: "t_in, max LSB", groups: VALID, figure: |of| max(of, 0), limit: FIXED_MAX },
    Target { what: "t_out, max LSB", groups: VALID, figure: |of| max(of, 1), limit: FIXED_MAX },
    Target {
        what: "hit point off the surface, LSB",
        groups: VALID,
        figure: point,
        limit: POINT_FIXED,
    },
    Target {
        what: "hits of invalid rays, panics",
        groups: Only(&[Invalid]),
        figure: bad,
        limit: 0.0,
    },
];

/// Sets of which fixed point holds no ray: too far, too large, directions too long.
const OUT_OF_REACH: &[&str] = &["far_1e5", "far_1e6", "huge", "unnorm_ext", "nan", "inf"];

fn wrong(accuracy: &Accuracy) -> f64 {
    (accuracy.false_hits + accuracy.false_misses) as f64
}

fn misrounded(accuracy: &Accuracy) -> f64 {
    accuracy.misrounded as f64
}

fn unanswered(accuracy: &Accuracy) -> f64 {
    accuracy.other() as f64
}

fn bad(accuracy: &Accuracy) -> f64 {
    wrong(accuracy) + unanswered(accuracy)
}

fn p99(accuracy: &Accuracy, end: usize) -> f64 {
    // Nothing to compare is no success.
    percentiles(&accuracy.errors[end]).map_or(f64::INFINITY, |[_, p99, _]| p99)
}

fn max(accuracy: &Accuracy, end: usize) -> f64 {
    percentiles(&accuracy.errors[end]).map_or(f64::INFINITY, |[_, _, max]| max)
}

fn point(accuracy: &Accuracy) -> f64 {
    percentiles(&accuracy.points).map_or(f64::INFINITY, |[_, _, max]| max)
}

/// The targets that a set's accuracy falls short of, in words.
pub fn shortfalls(set: &Set, inputs: &Inputs, accuracy: &Accuracy) -> Vec<String> {
    let is_out_of_reach = inputs.is_exact && OUT_OF_REACH.contains(&set.name);
    if (accuracy.asked == 0) != is_out_of_reach {
        return vec![format!("{:12} {} rays could be asked", set.name, accuracy.asked)];
    }
    if is_out_of_reach {
        return Vec::new();
    }
    let targets = if inputs.is_exact { FIXED } else { TARGETS };
    targets
        .iter()
        .filter(|target| target.groups.have(set.group))
        .filter_map(|target| {
            let figure = (target.figure)(accuracy);
            let reached = figure <= target.limit;
            let text =
                || format!("{:12} {}: {figure:.3e} > {}", set.name, target.what, target.limit);
            (!reached).then(text)
        })
        .collect()
}
