//! The solver against solutions that are known, and against algebra that is not ours to optimise.

mod accuracy;
mod evaluation;
mod known;
mod solving;

use super::{
    Conditions, GmresOptions, LaplaceOptions, Mesh, Method, Panel, Preconditioner, Problem, Solution,
    samples, solve,
};
use glam::DVec3;

/// Conditions from a function of the panel.
fn conditions(mesh: &Mesh, of: impl Fn(&Panel) -> Result<f64, f64>) -> Conditions {
    Conditions::single(mesh.panels().iter().map(of))
}

/// The solution with defaults, to a tolerance far below the error of the method.
fn solved(mesh: Mesh, of: impl Fn(&Panel) -> Result<f64, f64>) -> Solution {
    let conditions = conditions(&mesh, of);
    let solution = solve(Problem::new(mesh, conditions).unwrap(), LaplaceOptions::default()).unwrap();
    assert!(solution.convergences().iter().all(|found| found.is_converged));
    solution
}

/// Values of the paper's cube on its faces.
fn faces(panel: &Panel) -> Result<f64, f64> {
    Ok(samples::cube_values(panel))
}

fn cube(m: usize) -> Solution {
    solved(samples::cube(m), faces)
}

fn value(solution: &Solution, p: DVec3) -> f64 {
    solution.at(p).unwrap_or_else(|| panic!("{p} is inside")).values[0]
}

/// Places between 0.1 and 0.9 along each axis.
fn inner(steps: usize) -> Vec<DVec3> {
    let place = |k: usize| 0.1 + 0.8 * k as f64 / (steps - 1) as f64;
    let places = |n: usize| DVec3::new(place(n % steps), place(n / steps % steps), place(n / steps / steps));
    (0..steps * steps * steps).map(places).collect()
}

/// Largest error at places.
fn worst(solution: &Solution, places: &[DVec3], exact: impl Fn(DVec3) -> f64) -> f64 {
    places.iter().map(|p| (value(solution, *p) - exact(*p)).abs()).fold(0.0, f64::max)
}

/// The power of the first numbers in which the second ones fall, from the first to the last.
fn slope(list: &[(usize, f64)]) -> f64 {
    let [(n, first), (m, last)] = [list[0], list[list.len() - 1]];
    (last / first).ln() / (m as f64 / n as f64).ln()
}

fn gmres(preconditioner: Preconditioner, tolerance: f64) -> LaplaceOptions {
    let options = GmresOptions { preconditioner, tolerance, restart: 300, most_iterations: 300 };
    LaplaceOptions { method: Method::Gmres(options), ..LaplaceOptions::default() }
}
