//! Boxes, half-spaces and polyhedra: against slabs, against the brute-force caster, and in pictures.

use crate::caster::{self, Ray as ModelRay, Solid as ModelSolid, V};
use crate::number::{Tested, coordinates, spans, vector};
use crate::pictures::{SIZE, UP, compare, config, direction, held, orthographic, perspective};
use proptest::prelude::*;
use scancsg::geom::{Axis, Ray, Vec3, vec3};
use scancsg::solid::{
    Bounds, Cuboid, CuboidError, Cylinder, HalfSpace, HalfSpaceError, Polyhedron, PolyhedronError,
    Slab, Solid,
};

for_every_number!(
    a_box_is_three_slabs,
    a_box_is_a_polyhedron,
    rays_at_boxes,
    rays_at_polyhedra,
    pictures_of_boxes,
    pictures_of_polyhedra,
    pictures_of_half_spaces,
    pictures_along_faces,
    flush_with_a_cylinder,
    bounds_hold_all_corners,
    flat_solids_are_seen,
    bad_boxes,
    bad_half_spaces,
    bad_polyhedra,
);

/// Everything below an offset; a slab that begins far below.
fn below(normal: V, offset: f64) -> ModelSolid {
    ModelSolid::Slab { normal, low: -1e9, high: offset }
}

fn cuboid<S: Tested>() -> impl Strategy<Value = (Cuboid<S>, ModelSolid)> {
    use prop::array::uniform3;
    let size = prop_oneof![uniform3(0.2..2.0), uniform3(1..4i32).prop_map(|n| n.map(f64::from))];
    let low = prop_oneof![
        uniform3(-2.0..1.0),
        uniform3(-4..2i32).prop_map(|n| n.map(|half| f64::from(half) / 2.0)),
    ];
    (low, size).prop_map(|(low, size)| {
        let (low, high) = (held::<S>(low), held::<S>(caster::add(low, size)));
        let solid = Cuboid::between(vector(low), vector(high)).unwrap();
        let slab = |i: usize| ModelSolid::Slab {
            normal: std::array::from_fn(|k| if k == i { 1.0 } else { 0.0 }),
            low: low[i],
            high: high[i],
        };
        (solid, ModelSolid::All((0..3).map(slab).collect()))
    })
}

/// A polyhedron in both worlds: a prism, a frustum, or what random half-spaces have in common.
fn polyhedron<S: Tested>() -> impl Strategy<Value = (Polyhedron<S, 9>, ModelSolid)> {
    prop_oneof![prism(), frustum(), common()]
}

fn prism<S: Tested>() -> impl Strategy<Value = (Polyhedron<S, 9>, ModelSolid)> {
    (0..3usize, 0.0..6.3, 0.4..1.8, -1.5..0.5, 0.2..2.0).prop_map(|(axis, turn, r, low, long)| {
        let polygon: [[S; 2]; 5] = std::array::from_fn(|i| {
            let angle: f64 = turn + std::f64::consts::TAU * i as f64 / 5.0;
            [angle.cos(), angle.sin()].map(|x| S::near(r * x))
        });
        let [low, high] = [low, low + long].map(S::near);
        let solid = Polyhedron::extruded(Axis::ALL[axis], polygon, low, high).unwrap();
        let placed = |along: f64, [u, v]: [f64; 2]| match axis {
            0 => [along, u, v],
            1 => [u, along, v],
            _ => [u, v, along],
        };
        let mut faces = vec![below(placed(1.0, [0.0; 2]), high.to_f64())];
        faces.push(below(placed(-1.0, [0.0; 2]), -low.to_f64()));
        for i in 0..5 {
            let [[a, b], [c, d]] = [polygon[i], polygon[(i + 1) % 5]].map(|p| p.map(S::to_f64));
            let normal = caster::unit(placed(0.0, [d - b, a - c]));
            faces.push(below(normal, caster::dot(normal, placed(0.0, [a, b]))));
        }
        (solid, ModelSolid::All(faces))
    })
}

/// A frustum of a pyramid, sheared.
fn frustum<S: Tested>() -> impl Strategy<Value = (Polyhedron<S, 9>, ModelSolid)> {
    (0.2..1.5, 0.0..1.5, -0.5..0.5, -1.0..0.5, 0.3..2.0, prop::bool::ANY).prop_map(
        |(below_half, above_half, shear, low, long, mirrored)| {
            let corner = |i: usize| {
                let sign = |bit: usize| if i & bit == 0 { -1.0 } else { 1.0 };
                let (half, z) = match i & 4 {
                    0 => (below_half, low),
                    _ => (above_half, low + long),
                };
                let x = if mirrored { -sign(1) } else { sign(1) };
                let at = [half * x + shear * z, half * sign(2), z];
                held::<S>(at)
            };
            let corners: [V; 8] = std::array::from_fn(corner);
            let solid = Polyhedron::with_corners(corners.map(vector)).unwrap();
            let mut faces = Vec::new();
            // Any three corners whose plane has all others on one side are on a face.
            for i in 0..8 {
                for j in 0..i {
                    for k in 0..j {
                        let [a, b, c] = [corners[i], corners[j], corners[k]];
                        let normal = caster::cross(caster::sub(b, a), caster::sub(c, a));
                        if caster::length(normal) < 1e-3 {
                            continue;
                        }
                        let normal = caster::unit(normal);
                        for normal in [normal, caster::times(normal, -1.0)] {
                            let offset = caster::dot(normal, a);
                            let is_within =
                                |p: &V| caster::dot(normal, *p) <= offset + 4.0 * S::UNIT;
                            if corners.iter().all(is_within) {
                                let most = corners.iter().map(|p| caster::dot(normal, *p));
                                faces.push(below(normal, most.fold(f64::MIN, f64::max)));
                            }
                        }
                    }
                }
            }
            (solid, ModelSolid::All(faces))
        },
    )
}

fn common<S: Tested>() -> impl Strategy<Value = (Polyhedron<S, 9>, ModelSolid)> {
    prop::array::uniform9((direction::<S>(), 0.3..1.5)).prop_filter_map("open", |faces| {
        let faces = faces.map(|(normal, offset)| (normal, S::near(offset)));
        let solid = Polyhedron::bounded_by(
            faces.map(|(normal, offset)| HalfSpace::facing(vector(normal), offset).unwrap()),
        );
        let model = faces.map(|(normal, offset)| below(caster::unit(normal), offset.to_f64()));
        let solid = solid.ok()?;
        let Bounds::Box { low, high } = solid.bounds() else { return None };
        // A needle may end far away.
        let is_near = low.max_abs().max(high.max_abs()) < S::from_int(20);
        is_near.then_some((solid, ModelSolid::All(model.to_vec())))
    })
}

/// A ray of one of several kinds at a solid of about the size 1.
fn rays<S: Tested>() -> impl Strategy<Value = (Ray<S>, ModelRay)> {
    let distance = if S::IS_FIXED { 3.0..100.0 } else { 3.0..1e6 };
    let around = || prop::array::uniform3(-2.0..2.0);
    prop_oneof![
        // From outside, from far away, and from inside.
        (around(), around()).prop_map(|(from, to)| (caster::times(from, 3.0), to)),
        (direction::<S>(), distance, around())
            .prop_map(|(way, distance, to)| { (caster::times(caster::unit(way), distance), to) }),
        (around(), around()),
        // Nearly along a coordinate axis.
        (around(), 0..3usize, around(), 1..6i32).prop_map(|(from, axis, off, power)| {
            let mut to = caster::add(from, caster::times(off, 10f64.powi(-power)));
            to[axis] += 1.0;
            (from, to)
        }),
    ]
    .prop_filter_map("no ray", |(from, to)| {
        let way = caster::sub(to, from);
        let way = caster::times(way, 1.0 / way.into_iter().fold(0.0, |m, x| x.abs().max(m)));
        let model = ModelRay { origin: held::<S>(from), direction: held::<S>(way) };
        Some((Ray::new(vector(from), vector(way)).ok()?, model))
    })
}

/// The class of a ray is that of the caster where the solid grown and shrunk by a millionth, or two units,
/// agree. Then the ends of the span agree as well.
fn check_ray<S: Tested, T: Solid<Scalar = S>>(
    (solid, model): (&T, &ModelSolid),
    (ray, model_ray): &(Ray<S>, ModelRay),
) -> Result<(), TestCaseError> {
    let by = if S::IS_FIXED { 4.0 * S::UNIT } else { 1e-6 };
    let [less, more] = [-by, by].map(|by| model.grown(by).spans(model_ray));
    let got = spans(solid, ray);
    if less.len() == more.len() {
        prop_assert_eq!(got.len(), less.len());
        for (got, (less, more)) in got.iter().zip(less.iter().zip(&more)) {
            let slack = |t: f64| 4.0 * S::UNIT * t.abs().max(1.0);
            let is_between = more[0].t - slack(got.0) <= got.0
                && got.0 <= less[0].t + slack(got.0)
                && less[1].t - slack(got.1) <= got.1
                && got.1 <= more[1].t + slack(got.1);
            prop_assert!(is_between, "{:?} is not {:?}", got, less);
        }
    }
    Ok(())
}

fn rays_at_boxes<S: Tested>() {
    proptest!(ProptestConfig::with_cases(2000), |(part in cuboid::<S>(), ray in rays::<S>())| {
        check_ray((&part.0, &part.1), &ray)?;
    });
}

fn rays_at_polyhedra<S: Tested>() {
    proptest!(ProptestConfig::with_cases(2000), |(part in polyhedron::<S>(), ray in rays::<S>())| {
        check_ray((&part.0, &part.1), &ray)?;
    });
}

/// Bit for bit; but in fixed point a box is there for a unit where what three slabs share rounds to nothing.
fn a_box_is_three_slabs<S: Tested>() {
    proptest!(ProptestConfig::with_cases(2000), |(part in cuboid::<S>(), (ray, _) in rays::<S>())| {
        let [low, high] = part.0.corners();
        let slab = |axis| {
            let along = |v: Vec3<S>| v.to_array()[axis as usize];
            Slab::across(axis, along(low), along(high)).unwrap()
        };
        let slabs = slab(Axis::X) & slab(Axis::Y) & slab(Axis::Z);
        let (got, want) = (spans(&part.0, &ray), spans(&slabs, &ray));
        match (got.as_slice(), want.as_slice()) {
            ([(enter, exit)], []) if S::IS_FIXED => prop_assert!(exit - enter <= S::UNIT),
            _ => prop_assert_eq!(got, want),
        }
    });
}

fn a_box_is_a_polyhedron<S: Tested>() {
    proptest!(ProptestConfig::with_cases(1000), |(part in cuboid::<S>(), (ray, _) in rays::<S>())| {
        let [low, high] = part.0.corners();
        let corners = std::array::from_fn(|i| {
            let pick = |bit: usize, low: S, high: S| if i & bit == 0 { low } else { high };
            vec3(pick(1, low.x, high.x), pick(2, low.y, high.y), pick(4, low.z, high.z))
        });
        let frustum = Polyhedron::<S, 6>::with_corners(corners).unwrap();
        prop_assert_eq!(spans(&part.0, &ray), spans(&frustum, &ray));
        let polygon = [[low.x, low.y], [high.x, low.y], [high.x, high.y], [low.x, high.y]];
        let prism = Polyhedron::<S, 8>::extruded(Axis::Z, polygon, low.z, high.z).unwrap();
        prop_assert_eq!(spans(&part.0, &ray), spans(&prism, &ray));
        // Redundant faces change nothing, and a shared slice is as good as an array.
        let half = |axis, offset: S| HalfSpace::below(axis, offset).unwrap();
        let more = half(Axis::X, high.x.plus(S::ONE));
        let mut faces = frustum.faces().to_vec();
        faces.insert(3, more);
        faces.push(*frustum.faces().last().unwrap());
        let over = Polyhedron::<S, 8, &[_]>::bounded_by(faces.as_slice()).unwrap();
        prop_assert_eq!(spans(&part.0, &ray), spans(&over, &ray));
    });
}

fn check_pictures<S, T>(part: &(T, ModelSolid), way: V, distance: f64) -> Result<(), TestCaseError>
where
    S: Tested,
    T: Solid<Scalar = S>
        + scancsg::solid::Scan<scancsg::geom::OrthographicRays<S>>
        + scancsg::solid::Scan<scancsg::geom::PerspectiveRays<S>>,
{
    let target = [0.25, -0.125, 0.5];
    let up = if way[1].abs() > 0.9 * caster::length(way) { [1.0, 0.0, 0.0] } else { UP };
    let (camera, view) = orthographic::<S>(way, target, up, 6.0);
    compare((&part.0, &part.1), (&camera, &view), SIZE)?;
    let eye = caster::sub(target, caster::times(way, distance / caster::length(way)));
    let (camera, view) = perspective::<S>([eye, target], up, 0.9);
    compare((&part.0, &part.1), (&camera, &view), SIZE)?;
    Ok(())
}

fn pictures_of_boxes<S: Tested>() {
    proptest!(config::<S>(), |(
        part in cuboid::<S>(), way in direction::<S>(), distance in 0.5..12.0,
    )| {
        check_pictures(&part, way, distance)?;
    });
}

fn pictures_of_polyhedra<S: Tested>() {
    proptest!(config::<S>(), |(
        part in polyhedron::<S>(), way in direction::<S>(), distance in 0.5..12.0,
    )| {
        check_pictures(&part, way, distance)?;
    });
}

/// Half of a box, cut by a plane through it.
fn pictures_of_half_spaces<S: Tested>() {
    proptest!(config::<S>(), |(
        part in cuboid::<S>(), normal in direction::<S>(), offset in -1.0..1.0,
        way in direction::<S>(), distance in 0.5..12.0,
    )| {
        let offset = S::near(offset);
        let half = HalfSpace::facing(vector(normal), offset).unwrap();
        let cut = below(caster::unit(normal), offset.to_f64());
        let model = ModelSolid::All(vec![part.1.clone(), cut.clone()]);
        check_pictures(&(part.0 & half, model), way, distance)?;
        let model = ModelSolid::Minus(Box::new(part.1), Box::new(cut));
        check_pictures(&(part.0 - half, model), way, distance)?;
    });
}

/// Exactly along a coordinate axis, and nearly so: some faces are seen edge-on.
fn pictures_along_faces<S: Tested>() {
    proptest!(config::<S>(), |(
        (cuboid, prism) in (cuboid::<S>(), prism::<S>()), axis in 0..3usize, back: bool,
        off in prop::array::uniform3(-1.0..1.0), power in prop_oneof![Just(99), 1..6i32],
    )| {
        let sign = if back { -1.0 } else { 1.0 };
        let off = off.map(|k: f64| k * 10f64.powi(-power));
        let way = std::array::from_fn(|i| if i == axis { sign } else { off[i] });
        check_pictures(&cuboid, way, 8.0)?;
        check_pictures(&prism, way, 8.0)?;
    });
}

/// A box under a cylinder that stands on it, and a bore through both: no ray sees a film between them.
fn flush_with_a_cylinder<S: Tested>() {
    proptest!(ProptestConfig::with_cases(500), |(
        [x, y, z] in prop::array::uniform3(-1.0..1.0), (ray, model) in rays::<S>(),
    )| {
        // From afar, parameters are too coarse for a gap.
        prop_assume!(caster::length(model.origin) < 20.0);
        let [x, y, z] = [x, y, z].map(S::near);
        let two = S::from_int(2);
        let plate = Cuboid::between(vec3(x.minus(two), y.minus(two), z.minus(S::ONE)), vec3(x.plus(two), y.plus(two), z));
        let rod = |radius, low, high| Cylinder::along(Axis::Z, [x, y], radius, low, high).unwrap();
        let boss = rod(S::ONE, z, z.plus(S::ONE));
        let part = plate.unwrap() | boss;
        let bored = part - rod(S::from_ratio(1, 2), z.minus(S::ONE), z.plus(S::ONE));
        let pairs = spans(&part, &ray);
        prop_assert!(pairs.windows(2).all(|pair| pair[0].1 < pair[1].0), "{:?}", pairs);
        // Straight down the bore, nothing is left.
        let down = Ray::new(vec3(x, y, S::from_int(5)), vec3(S::ZERO, S::ZERO, S::ONE.negated()));
        prop_assert_eq!(spans(&bored, &down.unwrap()), vec![]);
    });
}

fn bounds_hold_all_corners<S: Tested>() {
    proptest!(ProptestConfig::with_cases(300), |(part in common::<S>(), to in prop::array::uniform3(-3.0..3.0))| {
        let Bounds::Box { low, high } = part.0.bounds() else { panic!("no box") };
        // A point of the solid lies in its bounds.
        let p = coordinates(vector::<S>(to));
        if part.1.grown(-4.0 * S::UNIT).contains(p) {
            let [low, high] = [low, high].map(coordinates);
            prop_assert!((0..3).all(|i| low[i] <= p[i] && p[i] <= high[i]), "{:?}", p);
        }
    });
}

/// A slab under a roof of four faces, and a pyramid: flatter and flatter, as far as the number type knows them.
fn flat_solids_are_seen<S: Tested>() {
    let mut seen = 0;
    for power in 1..9 {
        let slope = 0.7 * 10f64.powi(-power);
        let (roof, thin) = (S::near(slope), slope.min(0.01));
        // The apex must be several units above the eaves.
        if roof.to_f64() < 64.0 * S::UNIT {
            continue;
        }
        let half =
            |normal: [S; 3], offset: S| HalfSpace::facing(Vec3::from(normal), offset).unwrap();
        let (o, one) = (S::ZERO, S::ONE);
        let down = roof.negated();
        let faces = [
            half([roof, o, one], roof),
            half([down, o, one], roof),
            half([o, roof, one], roof),
            half([o, down, one], roof),
            half([one, o, o], one),
            half([one.negated(), o, o], one),
            half([o, one, o], one),
            half([o, one.negated(), o], one),
            half([o, o, one.negated()], S::near(thin)),
        ];
        let solid = Polyhedron::<S, 9>::bounded_by(faces).unwrap();
        let Bounds::Box { low, high } = solid.bounds() else { panic!("no box") };
        // The normals are rounded, so the roof's height is known to their units only.
        let apex = slope - 4.0 * S::UNIT.max(1e-9);
        assert!(high.z.to_f64() >= apex && low.z.to_f64() <= -thin, "{slope}: {low:?} {high:?}");
        assert!(low.x.to_f64() <= -0.99 && high.y.to_f64() >= 0.99, "{slope}: {low:?} {high:?}");
        let h = S::near(slope);
        let corner = |i: usize| match i & 4 {
            0 => {
                let sign = |bit| if i & bit == 0 { one.negated() } else { one };
                vec3(sign(1), sign(2), o)
            }
            _ => vec3(o, o, h),
        };
        let pyramid = Polyhedron::<S, 6>::with_corners(std::array::from_fn(corner)).unwrap();
        let Bounds::Box { low, high } = pyramid.bounds() else { panic!("no box") };
        // Offsets are rounded: that moves the eaves by as much more as the faces are flat.
        let reach = 1.0 - 2.0 * S::UNIT / slope;
        let [apex, east, south] = [high.z, high.x, low.y].map(S::to_f64);
        assert!(
            apex >= 0.9 * slope && east >= reach && south <= -reach,
            "{slope}: {low:?} {high:?}"
        );
        seen += 1;
    }
    assert!(seen >= 1, "{seen}");
}

fn bad_boxes<S: Tested>() {
    let at = |x: f64| vector::<S>([x; 3]);
    assert_eq!(Cuboid::between(at(1.0), at(1.0)), Err(CuboidError::Empty));
    assert_eq!(Cuboid::between(at(1.0), at(-1.0)), Err(CuboidError::Empty));
    assert_eq!(Cuboid::of_size(vector::<S>([1.0, 0.0, 1.0])), Err(CuboidError::Empty));
    assert_eq!(Cuboid::around(at(0.0), vector::<S>([1.0, -1.0, 1.0])), Err(CuboidError::Empty));
    let beyond = S::MAX_COORDINATE.up();
    let far = vec3(S::ZERO, beyond, S::ZERO);
    assert_eq!(Cuboid::between(at(-1.0), vec3(S::ONE, beyond, S::ONE)), Err(CuboidError::TooFar));
    for &none in S::NO_NUMBERS {
        assert_eq!(
            Cuboid::between(at(-1.0), vec3(none, S::ONE, S::ONE)),
            Err(CuboidError::NotFinite)
        );
    }
    assert!(Cuboid::between(at(-1.0), far).is_err());
    let [low, high] = Cuboid::around(at(1.0), at(0.5)).unwrap().corners();
    assert_eq!([low, high], [at(0.5), at(1.5)]);
}

fn bad_half_spaces<S: Tested>() {
    let up = vector::<S>([0.0, 0.0, 1.0]);
    assert_eq!(HalfSpace::facing(Vec3::ZERO, S::ONE), Err(HalfSpaceError::ZeroNormal));
    assert_eq!(HalfSpace::facing(up, S::MAX_COORDINATE.up()), Err(HalfSpaceError::TooFar));
    for &none in S::NO_NUMBERS {
        assert_eq!(HalfSpace::facing(up, none), Err(HalfSpaceError::NotFinite));
        assert_eq!(
            HalfSpace::facing(vec3(none, S::ZERO, S::ONE), S::ONE),
            Err(HalfSpaceError::NotFinite)
        );
    }
}

fn bad_polyhedra<S: Tested>() {
    use PolyhedronError::{Empty, NotConvex, NotFinite, TooManyFaces, Unbounded};
    let half = |normal: V, offset| HalfSpace::<S>::facing(vector(normal), S::near(offset)).unwrap();
    let of = |faces: &[HalfSpace<S>]| Polyhedron::<S, 8, &[_]>::bounded_by(faces).map(|_| ());
    let mut faces = vec![
        half([1.0, 0.0, 0.0], 1.0),
        half([-1.0, 0.0, 0.0], 1.0),
        half([0.0, 1.0, 0.0], 1.0),
        half([0.0, -1.0, 0.0], 1.0),
    ];
    for count in 0..=4 {
        assert_eq!(of(&faces[..count]), Err(Unbounded));
    }
    faces.push(half([0.0, 0.0, 1.0], 1.0));
    assert_eq!(of(&faces), Err(Unbounded));
    for (offset, want) in [(1.0, Ok(())), (-0.5, Ok(())), (-1.0, Err(Empty)), (-2.0, Err(Empty))] {
        let mut faces = faces.clone();
        faces.push(half([0.0, 0.0, -1.0], offset));
        assert_eq!(of(&faces), want);
    }
    // An open prism with a roof, and a needle that nearly closes.
    assert_eq!(of(&[faces[0], faces[1], faces[2], half([0.0, -0.5, 1.0], 1.0)]), Err(Unbounded));
    assert_eq!(of(&[faces[0]; 9]), Err(TooManyFaces));

    let prism = |polygon: [[f64; 2]; 4], low, high| {
        let polygon = polygon.map(|p| p.map(S::near));
        Polyhedron::<S, 6>::extruded(Axis::Y, polygon, S::near(low), S::near(high)).map(|_| ())
    };
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    assert_eq!(prism(square, 0.0, 1.0), Ok(()));
    assert_eq!(prism(square, 1.0, 1.0), Err(Empty));
    assert_eq!(prism(square, 1.0, 0.0), Err(Empty));
    assert_eq!(
        prism([[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]], 0.0, 1.0),
        Err(NotConvex)
    );
    assert_eq!(
        prism([[-1.0, -1.0], [0.0, -0.5], [1.0, -1.0], [0.0, 1.0]], 0.0, 1.0),
        Err(NotConvex)
    );
    assert!(prism([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]], 0.0, 1.0).is_err());
    assert_eq!(prism([[0.0; 2]; 4], 0.0, 1.0), Err(NotConvex));
    let few =
        Polyhedron::<S, 5>::extruded(Axis::Y, square.map(|p| p.map(S::near)), S::ZERO, S::ONE);
    assert_eq!(few, Err(TooManyFaces));
    for &none in S::NO_NUMBERS {
        let mut polygon = square.map(|p| p.map(S::near));
        let ends = Polyhedron::<S, 6>::extruded(Axis::X, polygon, S::ZERO, none);
        assert_eq!(ends.map(|_| ()), Err(NotFinite));
        polygon[2][1] = none;
        let points = Polyhedron::<S, 6>::extruded(Axis::X, polygon, S::ZERO, S::ONE);
        assert_eq!(points.map(|_| ()), Err(NotFinite));
        let mut corners = [Vec3::ZERO; 8];
        corners[3].x = none;
        assert!(Polyhedron::<S, 6>::with_corners(corners).is_err());
    }
    assert!(Polyhedron::<S, 6>::with_corners([Vec3::ZERO; 8]).is_err());
    // A box with one corner lifted: its faces aren't flat.
    let corner = |i: usize| vector::<S>([1, 2, 4].map(|bit| if i & bit == 0 { -1.0 } else { 1.0 }));
    let mut corners = std::array::from_fn(corner);
    assert!(Polyhedron::<S, 6>::with_corners(corners).is_ok());
    corners[7].z = S::near(1.25);
    assert_eq!(Polyhedron::<S, 6>::with_corners(corners).map(|_| ()), Err(NotConvex));
}
