use super::*;
use crate::curve::{BSpline, Form};
use crate::material::Composition;
use glam::{DVec2, dvec2};
use std::f64::consts::TAU;
use std::time::Instant;

/// A closed curve through the control points of a circle: one to a few parts in a hundred thousand.
fn circle(centre: DVec2, radius: f64) -> BSpline {
    let count = 64;
    let angle = TAU / f64::from(count);
    // A uniform cubic with control points at this radius has its knots on the circle.
    let control = radius * 3.0 / (2.0 + angle.cos());
    let points = (0..count).map(|k| centre + control * DVec2::from_angle(angle * f64::from(k)));
    BSpline::new(3, Form::Periodic, points.collect(), None).expect("a curve")
}

fn pure(outer: usize) -> impl Fn(usize, f64) -> Composition {
    move |curve, _| Composition::pure(usize::from(curve == outer), 2)
}

const FINE: Fineness = Fineness { segments: 200, lines: 44, tolerance: 1e-3 };

fn blend(curves: Vec<BSpline>, outer: usize, compose: &Compose<'_>) -> HarmonicBlend {
    HarmonicWork::new(curves, outer, compose, FINE).expect("a boundary").run().expect("a solution")
}

#[test]
fn between_concentric_circles_the_potential_is_a_logarithm() {
    let curves = vec![circle(DVec2::ZERO, 1.0), circle(DVec2::ZERO, 3.0)];
    let began = Instant::now();
    let found = blend(curves, 1, &pure(1));
    eprintln!("{:?}, {} vertices, {} triangles", began.elapsed(), found.field().points.len(), found.field().triangles.len());
    assert!((found.flux() * 3.0_f64.ln() / TAU - 1.0).abs() < 1e-3, "{}", found.flux());
    for k in 0..50 {
        let radius = 1.05 + 1.9 * f64::from(k) / 50.0;
        let at = radius * DVec2::from_angle(f64::from(k));
        let place = found.locate(at).expect("inside");
        let exact = radius.ln() / 3.0_f64.ln();
        assert!((place.potential - exact).abs() < 3e-4, "{} at {radius}, not {exact}", place.potential);
        let steep = 1.0 / (radius * 3.0_f64.ln());
        assert!((place.gradient - steep * at.normalize()).length() < 2e-3 * steep);
        assert!((place.composition.fractions()[1] - place.potential).abs() < 1e-12);
    }
    for level in [0.2, 0.5, 0.8] {
        let loops = found.level(level);
        assert_eq!(loops.len(), 1);
        let radius = 3.0_f64.powf(level);
        assert!(loops[0].iter().all(|point| (point.length() / radius - 1.0).abs() < 5e-4));
    }
    assert_eq!((found.lines().len(), found.crossings(), found.lost()), (44, 0, 0));
    for line in found.lines() {
        let first = line.points[0].normalize();
        assert!(line.points.iter().all(|point| point.normalize().distance(first) < 2e-3));
    }
    let gaps = found.lines().windows(2).map(|pair| {
        pair[0].points[0].normalize().dot(pair[1].points[0].normalize()).acos() * 44.0 / TAU
    });
    assert!(gaps.into_iter().all(|gap| (gap - 1.0).abs() < 0.02));
    assert!(found.locate(DVec2::ZERO).is_none() && found.locate(dvec2(3.1, 0.0)).is_none());
}
