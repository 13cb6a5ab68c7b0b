//! Errors against solutions that are known, and how they fall.

use super::*;
use crate::laplace::cluster::Panels;
use crate::laplace::samples;
use glam::DVec3;

#[test]
fn constants_are_solutions_to_rounding() {
    for mesh in [samples::cube(3), samples::shell(0.4, 1.0, 1), samples::annulus(0.4, 1.0, 40)] {
        let pure = solved(mesh.clone(), |_| Ok(0.3));
        let mixed = solved(mesh.clone(), |panel| if panel.centre.x > 0.2 { Ok(0.3) } else { Err(0.0) });
        for solution in [pure, mixed] {
            assert!(solution.values()[0].iter().all(|value| (value - 0.3).abs() < 1e-15));
            assert!(solution.fluxes()[0].iter().all(|flux| flux.abs() < 1e-15));
            let (low, high) = mesh.bounds();
            let place = (low + high) / 2.0 + DVec3::X * (0.35 * (high.x - low.x));
            assert!((value(&solution, place) - 0.3).abs() < 1e-15);
        }
    }
}

#[test]
fn the_cube_of_the_paper_converges_faster_than_its_panels_shrink() {
    let places = inner(7);
    let exact: Vec<f64> = places.iter().map(|p| known::cube(*p)).collect();
    let error = |m: usize| {
        let solution = cube(m);
        let errors = places.iter().zip(&exact).map(|(p, exact)| (value(&solution, *p) - exact).abs());
        (12 * m * m, errors.fold(0.0, f64::max))
    };
    let found = [4, 8, 12].map(error);
    assert!(found[1].1 <= 4e-3 && found[2].1 <= 1e-3, "{found:?}");
    assert!(slope(&found) <= -1.2, "{found:?}");
}

#[test]
fn harmonic_polynomials_are_found_from_values_and_from_mixed_data() {
    let exact = |p: DVec3| p.x * p.x - p.y * p.y;
    let flux = |panel: &Panel| DVec3::new(2.0 * panel.centre.x, -2.0 * panel.centre.y, 0.0).dot(panel.normal);
    let errors = |mixed: bool| {
        [2, 4, 8].map(|m| {
            let of = |panel: &Panel| {
                if mixed && panel.normal.z.abs() < 0.5 { Err(flux(panel)) } else { Ok(exact(panel.centre)) }
            };
            (12 * m * m, worst(&solved(samples::cube(m), of), &inner(5), exact))
        })
    };
    let (pure, mixed) = (errors(false), errors(true));
    assert!(slope(&pure) <= -1.2 && pure[2].1 < 3e-3, "{pure:?}");
    assert!(slope(&mixed) <= -0.9 && mixed[2].1 < 4e-3, "{mixed:?}");
    let linear = |p: DVec3| 0.3 + p.x - 2.0 * p.y + 0.5 * p.z;
    let slant = DVec3::new(1.0, -2.0, 0.5);
    let of = |panel: &Panel| {
        if panel.centre.x > 0.4 { Ok(linear(panel.centre)) } else { Err(slant.dot(panel.normal)) }
    };
    assert!(worst(&solved(samples::cube(8), of), &inner(4), linear) < 2.5e-2);
}

#[test]
fn the_shell_between_spheres_is_found_with_the_square_of_the_panels_size() {
    let exact = |p: DVec3| (1.0 / p.length() - 1.0) / (1.0 / 0.5 - 1.0);
    let directions = [DVec3::X, DVec3::new(1.0, 2.0, -0.5), DVec3::new(-1.0, 0.3, 0.8), DVec3::NEG_Z];
    let places: Vec<DVec3> =
        directions.iter().flat_map(|d| [0.6, 0.75, 0.88].map(|radius| d.normalize() * radius)).collect();
    for mixed in [false, true] {
        let found = [1, 2, 3].map(|level| {
            let of = |panel: &Panel| {
                let is_inner = panel.centre.length() < 0.7;
                match (is_inner, mixed) {
                    (true, _) => Ok(1.0),
                    (false, false) => Ok(0.0),
                    (false, true) => Err(-1.0),
                }
            };
            // Of (1/r - 1) the flux through the outer sphere of radius 1 is -1.
            let solution = solved(samples::shell(0.5, 1.0, level), of);
            (40 << (2 * level), worst(&solution, &places, exact))
        });
        assert!(slope(&found) <= -0.9 && found[2].1 < 1.2e-2, "{found:?}");
    }
}

#[test]
fn the_annulus_on_the_unit_circle_is_found_in_spite_of_the_degenerate_scale() {
    let exact = |p: DVec3| p.length().ln() / 0.4_f64.ln();
    let places: Vec<DVec3> = (0..24)
        .map(|k| DVec3::new((f64::from(k)).cos(), f64::from(k).sin(), 0.0) * (0.45 + 0.02 * f64::from(k)))
        .collect();
    for scale in [1.0, 1.0001, 2.0, 1e-3, 1e5] {
        let flux = 1.0 / (scale * 0.4_f64.ln());
        let of = |panel: &Panel| if panel.centre.length() < 0.7 * scale { Ok(1.0) } else { Err(flux) };
        let solution = solved(samples::annulus(0.4 * scale, scale, 256), of);
        let error =
            places.iter().map(|p| (value(&solution, *p * scale) - exact(*p)).abs()).fold(0.0, f64::max);
        assert!(error <= 2e-3, "{error} at the scale {scale}");
        let dirichlet = |panel: &Panel| Ok(if panel.centre.length() < 0.7 * scale { 1.0 } else { 0.0 });
        let solution = solved(samples::annulus(0.4 * scale, scale, 256), dirichlet);
        let error =
            places.iter().map(|p| (value(&solution, *p * scale) - exact(*p)).abs()).fold(0.0, f64::max);
        assert!(error <= 2e-3, "{error} at the scale {scale}, values alone");
    }
}

#[test]
fn fine_boundaries_lose_nothing_by_rounding() {
    // The middles of short segments far from the origin are off their lines by more than a small share of their length.
    for count in [900, 3000] {
        let mesh = samples::annulus(0.4, 1.0, count);
        let panels = Panels::new(mesh.space(), mesh.panels());
        for panel in &panels.list {
            assert_eq!(panels.space.layers(panel, panel.centre).double, 0.0);
        }
    }
    let ring = solved(samples::annulus(0.4, 1.0, 900), |panel| Ok(panel.centre.length().ln()));
    assert!(ring.row_closure() < 1e-3, "{}", ring.row_closure());
    for p in [DVec3::X * 0.7, DVec3::Y * -0.45] {
        assert!((value(&ring, p) - p.length().ln()).abs() < 1e-4);
    }
}

#[test]
fn the_square_and_patches_on_it_converge() {
    let places: Vec<DVec3> = inner(6).into_iter().filter(|p| p.z < 0.11).map(|p| p.with_z(0.0)).collect();
    let sides = |panel: &Panel| {
        Ok(if panel.normal.y > 0.5 {
            1.0
        } else if panel.normal.y < -0.5 {
            0.5
        } else {
            0.0
        })
    };
    let found = [8, 16, 32].map(|m| {
        (4 * m, worst(&solved(samples::square(m), sides), &places, |p| known::square(p.truncate())))
    });
    assert!(slope(&found) <= -1.8 && found[2].1 < 1e-3, "{found:?}");
    let exact = |p: DVec3| p.x * p.x - p.y * p.y;
    let mixed = |panel: &Panel| {
        let flux = DVec3::new(2.0 * panel.centre.x, -2.0 * panel.centre.y, 0.0).dot(panel.normal);
        if panel.normal.y.abs() > 0.5 { Ok(exact(panel.centre)) } else { Err(flux) }
    };
    let found = [8, 16, 32].map(|m| (4 * m, worst(&solved(samples::square(m), mixed), &places, exact)));
    assert!(slope(&found) <= -1.5 && found[2].1 < 2e-3, "{found:?}");
}

#[test]
fn fluxes_alone_determine_the_solution_up_to_its_mean() {
    let exact = |p: DVec3| p.x * p.x - p.y * p.y;
    let flux =
        |panel: &Panel| Err(DVec3::new(2.0 * panel.centre.x, -2.0 * panel.centre.y, 0.0).dot(panel.normal));
    let solution = solved(samples::cube(8), flux);
    let mean: f64 = solution.values()[0]
        .iter()
        .zip(solution.problem().mesh().panels())
        .map(|(v, panel)| v * panel.size)
        .sum();
    assert!(mean.abs() < 1e-9);
    let middle = DVec3::splat(0.5);
    let offset = value(&solution, middle) - exact(middle);
    assert!(worst(&solution, &inner(4), |p| exact(p) + offset) < 1.5e-2);
    assert_eq!(solution.ranges(), [None]);
}

#[test]
fn what_flows_in_flows_out_and_a_shell_lets_through_what_is_known() {
    let solution =
        solved(samples::shell(0.5, 1.0, 2), |panel| Ok(f64::from(u8::from(panel.centre.length() < 0.7))));
    assert!(solution.flux_balance()[0].abs() < 1e-2, "{:?}", solution.flux_balance());
    let through: f64 = solution
        .problem()
        .mesh()
        .panels()
        .iter()
        .zip(&solution.fluxes()[0])
        .filter(|(panel, _)| panel.centre.length() > 0.7)
        .map(|(panel, flux)| panel.size * flux)
        .sum();
    // Of 1/r - 1 it is -4 pi.
    assert!((through / (-4.0 * std::f64::consts::PI) - 1.0).abs() < 0.05, "{through}");
}
