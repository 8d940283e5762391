//! Every error, and compile-time use.

use scancsg::constant;
use scancsg::geom::{Vec3, vec3};
use scancsg::scalar::I16F16;
use scancsg::spline::{
    Baked, Curve, CurveError, EvaluateError, FlattenError, KnotError, Knots, Outside,
};

type Quadratic = Knots<f32, 3, 8>;

#[test]
fn bad_knots() {
    let error = |knots: &[f32]| Quadratic::new(knots).unwrap_err();
    assert_eq!(error(&[]), KnotError::TooFew);
    assert_eq!(error(&[0.0, 1.0, 2.0]), KnotError::TooFew);
    assert_eq!(error(&[0.0; 9]), KnotError::TooMany);
    assert_eq!(error(&[0.0, 1.0, 0.5, 2.0]), KnotError::Decreasing);
    assert_eq!(error(&[0.0, 1.0, f32::NAN, 2.0]), KnotError::NotFinite);
    assert_eq!(error(&[0.0, 1.0, 2.0, f32::INFINITY]), KnotError::NotFinite);
    assert_eq!(error(&[f32::NEG_INFINITY, 1.0, 2.0, 3.0]), KnotError::NotFinite);
    assert_eq!(error(&[0.0, 1.0, 1.0, 1.0, 1.0]), KnotError::Multiplicity);
    assert_eq!(error(&[-f32::MAX, 0.0, 1.0, f32::MAX]), KnotError::TooFar);
    assert!(Quadratic::new(&[0.0, 1.0, 1.0, 1.0, 2.0]).is_ok());

    assert_eq!(Quadratic::uniform(6, 0.0, 1.0).unwrap_err(), KnotError::TooMany);
    assert_eq!(Quadratic::uniform(usize::MAX, 0.0, 1.0).unwrap_err(), KnotError::TooMany);
    assert_eq!(Quadratic::uniform(0, 0.0, 1.0).unwrap_err(), KnotError::TooFew);
    assert_eq!(Quadratic::uniform(4, 0.0, -1.0).unwrap_err(), KnotError::Decreasing);
    assert_eq!(Quadratic::uniform(4, 0.0, 0.0).unwrap_err(), KnotError::Multiplicity);
    assert_eq!(Quadratic::uniform(4, 0.0, f32::NAN).unwrap_err(), KnotError::NotFinite);
    assert_eq!(Quadratic::uniform(4, 0.0, f32::MAX).unwrap_err(), KnotError::TooFar);
    assert_eq!(Quadratic::clamped_uniform(2, 0.0, 1.0).unwrap_err(), KnotError::TooFew);
    assert_eq!(Quadratic::clamped_uniform(6, 0.0, 1.0).unwrap_err(), KnotError::TooMany);
    assert_eq!(Quadratic::clamped_uniform(4, 1.0, 1.0).unwrap_err(), KnotError::Decreasing);
    assert_eq!(Quadratic::clamped_uniform(4, 1.0, f32::NAN).unwrap_err(), KnotError::NotFinite);
    assert_eq!(Quadratic::periodic(&[1.0]).unwrap_err(), KnotError::TooFew);
    assert_eq!(Quadratic::periodic(&[1.0, f32::NAN]).unwrap_err(), KnotError::NotFinite);
    assert_eq!(Quadratic::periodic(&[0.0; 5]).unwrap_err(), KnotError::TooMany);
    assert_eq!(Quadratic::periodic(&[1.0, 0.0]).unwrap_err(), KnotError::Decreasing);

    let [low, high] = [I16F16::MIN, I16F16::MAX];
    let ends = Knots::<I16F16, 1, 2>::new(&[low, high]).unwrap();
    assert_eq!(ends.basis(0, high), I16F16::ONE);
    assert_eq!(Knots::<I16F16, 2, 4>::uniform(2, high, high).unwrap_err(), KnotError::TooFar);
}

#[test]
fn knots_as_described() {
    assert_eq!(
        Quadratic::uniform(3, -1.0, 0.5).unwrap().as_slice(),
        [-1.0, -0.5, 0.0, 0.5, 1.0, 1.5]
    );
    let clamped = Quadratic::clamped_uniform(5, 0.0, 3.0).unwrap();
    assert_eq!(clamped.as_slice(), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0]);
    assert_eq!((clamped.len(), clamped.points(), clamped.spans()), (8, 5, 3));
    // A period shorter than the degree: knots are taken from further periods.
    let short = Knots::<f32, 4, 9>::periodic(&[0.0, 1.0, 3.0]).unwrap();
    assert_eq!(short.as_slice(), [-5.0, -3.0, -2.0, 0.0, 1.0, 3.0, 4.0, 6.0, 7.0]);
}

#[test]
fn bad_curves() {
    let knots = Quadratic::clamped_uniform(4, 0.0, 1.0).unwrap();
    type Path = Curve<[f32; 2], 3, 4, 8>;
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let with = |point| {
        let mut points = points;
        points[2] = point;
        Path::new(knots, points).unwrap_err()
    };
    assert_eq!(with([f32::NAN, 0.0]), CurveError::NotFinite);
    assert_eq!(with([0.0, f32::NEG_INFINITY]), CurveError::NotFinite);
    assert_eq!(with([0.0, 1e16]), CurveError::TooFar);
    assert_eq!(Path::from_slice(knots, &points[..3]).unwrap_err(), CurveError::PointCount);
    assert_eq!(Path::closed(knots, &points).unwrap_err(), CurveError::PointCount);
    let more = Quadratic::clamped_uniform(5, 0.0, 1.0).unwrap();
    assert_eq!(Path::new(more, points).unwrap_err(), CurveError::PointCount);
    let fewer = Quadratic::clamped_uniform(3, 0.0, 1.0).unwrap();
    assert_eq!(Path::new(fewer, points).unwrap_err(), CurveError::PointCount);
    // No basis functions add up to one, or not over any length.
    let short = Quadratic::uniform(2, 0.0, 1.0).unwrap();
    let short = Curve::<f32, 3, 2, 8>::new(short, [1.0, 2.0]);
    assert_eq!(short.unwrap_err(), CurveError::Empty);
    let closed = Quadratic::new(&[0.0, 0.0, 1.0, 1.0, 1.0, 2.0]).unwrap();
    let closed = Curve::<f32, 3, 3, 8>::new(closed, [1.0, 2.0, 3.0]);
    assert_eq!(closed.unwrap_err(), CurveError::Empty);

    let mut path = Path::new(knots, points).unwrap();
    assert_eq!(path.bake::<1>().unwrap_err(), CurveError::SpanCount);
    assert_eq!(path.bake::<3>().unwrap_err(), CurveError::SpanCount);
    assert!(path.bake::<2>().is_ok() && path.bake::<4>().is_ok());
    assert_eq!(path.set_point(4, [0.0; 2]), Err(CurveError::PointCount));
    assert_eq!(path.set_point(0, [0.0, f32::NAN]), Err(CurveError::NotFinite));
    assert_eq!(path.set_point(0, [0.0, -1e16]), Err(CurveError::TooFar));
    assert_eq!(path.points(), points);
    assert_eq!(path.set_point(3, [5.0, 6.0]), Ok(()));
    assert_eq!(path.value(1.0, Outside::Error), Ok([5.0, 6.0]));

    assert_eq!(path.value(f32::NAN, Outside::Clamp), Err(EvaluateError::NotFinite));
    assert_eq!(path.value(1.5, Outside::Error), Err(EvaluateError::Outside));
    assert_eq!(path.value(1.5, Outside::Clamp), Ok([5.0, 6.0]));
    assert_eq!(path.value(-1.5, Outside::Clamp), Ok([0.0, 0.0]));
    assert_eq!(path.value(1e30, Outside::Extrapolate), Err(EvaluateError::Overflow));
    assert_eq!(path.insert(f32::NAN), Err(KnotError::NotFinite));
    assert_eq!(path.insert(2.0), Err(KnotError::Outside));
    assert_eq!(path.insert(0.5), Err(KnotError::TooMany));
    for tolerance in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(path.flatten(tolerance).err(), Some(FlattenError::Tolerance));
        assert_eq!(path.lengths(tolerance).err(), Some(FlattenError::Tolerance));
    }
    let mut roomy = Curve::<[f32; 2], 3, 5, 8>::from_slice(knots, &points).unwrap();
    assert_eq!(roomy.insert(0.0), Err(KnotError::Multiplicity));
    assert_eq!(roomy.insert(0.5), Ok(()));
}

/// Knots 1.7·10⁻⁵ apart at 1,163 are the same number in `f32`, and the message says how that can be.
#[test]
fn knots_that_are_rounded_to_the_same_number() {
    let knots = [0.0, 1163.0, 1_163.000_017, 1_163.000_034, 1200.0];
    let error = Knots::<f32, 2, 5>::new(&knots.map(|knot| knot as f32)).unwrap_err();
    assert_eq!(error, KnotError::Multiplicity);
    assert!(error.to_string().contains("rounds them to the same number"), "{error}");
    assert!(Knots::<f64, 2, 5>::new(&knots).is_ok());

    let knots = Knots::<f32, 2, 7>::new(&[0.0, 1163.0, 1163.0, 1200.0, 1201.0]).unwrap();
    let mut curve = Curve::<f32, 2, 5, 7>::from_slice(knots, &[0.0; 3]).unwrap();
    let error = curve.insert(1_163.000_017).unwrap_err();
    assert_eq!(error, KnotError::Multiplicity);
    assert!(error.to_string().contains("rounds them to the same number"), "{error}");
}

#[test]
fn extrapolation_continues_the_polynomial() {
    // x² on [0, 1]: control points 0, 0, 1.
    let knots = Knots::<f64, 3, 6>::clamped_uniform(3, 0.0, 1.0).unwrap();
    let parabola = Curve::<f64, 3, 3, 6>::new(knots, [0.0, 0.0, 1.0]).unwrap();
    assert_eq!(parabola.value(3.0, Outside::Extrapolate), Ok(9.0));
    assert_eq!(parabola.value(-2.0, Outside::Extrapolate), Ok(4.0));
    assert_eq!(parabola.bake::<1>().unwrap().value(3.0, Outside::Extrapolate), Ok(9.0));
    assert_eq!(parabola.derivative(1, 3.0, Outside::Extrapolate), Ok(6.0));
    let fixed = |x: i32| I16F16::from_num(x);
    let knots = Knots::<I16F16, 3, 6>::clamped_uniform(3, fixed(0), fixed(1)).unwrap();
    let parabola = Curve::<I16F16, 3, 3, 6>::new(knots, [fixed(0), fixed(0), fixed(1)]).unwrap();
    assert_eq!(parabola.value(fixed(3), Outside::Extrapolate), Ok(fixed(9)));
    assert_eq!(parabola.value(fixed(-20), Outside::Extrapolate), Ok(fixed(400)));
    let baked = parabola.bake::<1>().unwrap();
    assert_eq!(baked.value(fixed(3), Outside::Extrapolate), Ok(fixed(9)));
    assert_eq!(baked.value(fixed(-20), Outside::Extrapolate), Ok(fixed(400)));
    assert_eq!(baked.derivative(1, fixed(3), Outside::Extrapolate), Ok(fixed(6)));
}

const KNOTS: Knots<I16F16, 4, 9> =
    constant!(Knots::<I16F16, 4, 9>::clamped_uniform(5, I16F16::lit("0"), I16F16::lit("2")));
const FLAT: Vec3<I16F16> = vec3(I16F16::lit("1"), I16F16::lit("2"), I16F16::lit("3"));
const PATH: Curve<Vec3<I16F16>, 4, 5, 9> =
    constant!(Curve::<Vec3<I16F16>, 4, 5, 9>::new(KNOTS, [FLAT; 5]));
static BAKED: Baked<Vec3<I16F16>, 4, { KNOTS.spans() }> = constant!(PATH.bake());

#[test]
fn fixed_point_in_constants() {
    let t = I16F16::from_num(0.7);
    assert_eq!(BAKED.value(t, Outside::Error), Ok(FLAT));
    assert_eq!(PATH.value(t, Outside::Error), Ok(FLAT));
    assert_eq!(PATH.tangent(t, Outside::Error), Err(EvaluateError::Stationary));
}

#[test]
fn tangents_have_length_one() {
    let knots = Knots::<f32, 3, 6>::clamped_uniform(3, 0.0, 1.0).unwrap();
    let points = [vec3(0.0, 0.0, 0.0), vec3(3.0, 4.0, 0.0), vec3(6.0, 8.0, 0.0)];
    let line = Curve::<Vec3<f32>, 3, 3, 6>::new(knots, points).unwrap();
    let tangent = line.tangent(0.4, Outside::Error).unwrap();
    assert!((tangent.x - 0.6).abs() < 1e-6 && (tangent.y - 0.8).abs() < 1e-6);
}

/// The smallest numbers there are, and the largest.
#[test]
fn extreme_numbers() {
    let tiny = f32::from_bits(1);
    let knots = Knots::<f32, 3, 7>::new(&[0.0, 0.0, 0.0, tiny, 1.0, 1.0, 1.0]).unwrap();
    let points = [1e15, -1e15, 1e15, -1e15];
    let curve = Curve::<f32, 3, 4, 7>::new(knots, points).unwrap();
    let baked = curve.bake::<2>().unwrap();
    for t in [0.0, tiny, 2.0 * tiny, 1e-30, 0.5, 1.0] {
        assert!(curve.value(t, Outside::Error).unwrap().is_finite());
        assert!(baked.value(t, Outside::Error).unwrap().is_finite(), "{t}");
        for order in 0..4 {
            if let Ok(x) = curve.derivative(order, t, Outside::Error) {
                assert!(x.is_finite());
            }
            for i in 0..4 {
                assert!(knots.basis_derivative(i, order, t).is_finite(), "N_{i} {order} {t}");
            }
        }
    }
    assert_eq!(curve.flatten(1e14).unwrap().count(), curve.lengths(1e14).unwrap().count());
    assert!(curve.lengths(1e14).unwrap().all(|(t, length)| t.is_finite() && length.is_finite()));
}
