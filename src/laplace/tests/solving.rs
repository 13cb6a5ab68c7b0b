//! Solvers against dense algebra, residuals, iterations, and what is refused.

use super::*;
use crate::laplace::assemble::{Assembly, Equations};
use crate::laplace::cluster::Panels;
use crate::laplace::matrix::{Matrix, norm};
use crate::laplace::precondition::Sweep;
use crate::laplace::{Fault, LaplaceError, LaplaceJob, MOST_LU, Stage};
use glam::DVec3;
use std::rc::Rc;

fn equations(mesh: Mesh, most_dense: usize, of: impl Fn(&Panel) -> Result<f64, f64>) -> Equations {
    let conditions = conditions(&mesh, of);
    let problem = Problem::new(mesh, conditions).unwrap();
    let scaled = |n: usize| problem.mesh.corners(n).map(|corner| problem.scaling.inwards(corner));
    let space = problem.mesh.space();
    let list = (0..problem.mesh.elements().len()).map(|n| space.panel(scaled(n))).collect();
    let mut assembly = Assembly::new(Rc::new(Panels::new(space, list)), problem.given(), most_dense).unwrap();
    assert!(assembly.step(&mut || true).unwrap());
    assembly.finish()
}

/// The matrix, column by column, by products with unit vectors.
fn columns(matrix: &Matrix) -> Vec<Vec<f64>> {
    let n = matrix.len();
    let column = |k: usize| {
        let unit: Vec<f64> = (0..n).map(|row| f64::from(u8::from(row == k))).collect();
        let mut image = vec![0.0; n];
        matrix.multiply(&unit, &matrix.spread(&unit), 0..n, &mut image);
        image
    };
    (0..n).map(column).collect()
}

/// Gauss and Jordan, with a look for the largest pivot in all that is left.
fn eliminated(columns: &[Vec<f64>], side: &[f64]) -> Vec<f64> {
    let n = side.len();
    let mut rows: Vec<Vec<f64>> =
        (0..n).map(|r| columns.iter().map(|column| column[r]).chain([side[r]]).collect()).collect();
    let mut place: Vec<usize> = (0..n).collect();
    for k in 0..n {
        let all = (k..n).flat_map(|r| (k..n).map(move |c| (r, c)));
        let (r, c) = all.max_by(|a, b| rows[a.0][a.1].abs().total_cmp(&rows[b.0][b.1].abs())).unwrap();
        rows.swap(k, r);
        place.swap(k, c);
        rows.iter_mut().for_each(|row| row.swap(k, c));
        let own = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(other, _)| *other != k) {
            let factor = row[k] / own[k];
            row.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= factor * own);
        }
        rows[k] = own.iter().map(|entry| entry / own[k]).collect();
    }
    let mut x = vec![0.0; n];
    for k in 0..n {
        x[place[k]] = rows[k][n];
    }
    x
}

fn mixed(panel: &Panel) -> Result<f64, f64> {
    if panel.normal.x.abs() > 0.5 { Err(0.3 * panel.centre.y) } else { Ok(panel.centre.z * panel.centre.x) }
}

#[test]
fn gmres_and_lu_find_what_elimination_finds() {
    let made = equations(samples::cube(3), usize::MAX, mixed);
    let expected = eliminated(&columns(&made.matrix), &made.sides[0]);
    let kinds =
        [Preconditioner::None, Preconditioner::Jacobi, Preconditioner::Ssor(0.5), Preconditioner::Ssor(1.0)];
    let mut methods: Vec<LaplaceOptions> = kinds.iter().map(|kind| gmres(*kind, 1e-12)).collect();
    methods.push(LaplaceOptions { method: Method::Lu, ..LaplaceOptions::default() });
    for options in methods {
        let mesh = samples::cube(3);
        let given = conditions(&mesh, mixed);
        let solution = solve(Problem::new(mesh, given.clone()).unwrap(), options).unwrap();
        let (scale, size) = (solution.problem().scaling.scale(), solution.problem().sizes[0]);
        let (values, fluxes) = (&solution.values()[0], &solution.fluxes()[0]);
        for (element, is_value) in given.is_value.iter().enumerate() {
            let found = if *is_value {
                fluxes[element] / scale / size
            } else {
                (values[element] - solution.problem().shifts[0]) / size
            };
            assert!(
                (found - expected[element]).abs() < 1e-9,
                "{found}, not {}, by {options:?}",
                expected[element]
            );
        }
    }
}

#[test]
fn ssor_is_the_product_of_its_triangles() {
    let made = equations(samples::cube(2), usize::MAX, mixed);
    let (matrix, omega) = (&made.matrix, 0.7);
    let a = columns(matrix);
    let n = a.len();
    let z: Vec<f64> = (0..n).map(|k| (k as f64).sin()).collect();
    // M z = (D + wL) D^-1 (D + wU) z.
    let upper: Vec<f64> =
        (0..n).map(|r| a[r][r] * z[r] + omega * (r + 1..n).map(|c| a[c][r] * z[c]).sum::<f64>()).collect();
    let scaled: Vec<f64> = (0..n).map(|r| upper[r] / a[r][r]).collect();
    let mut r: Vec<f64> = (0..n)
        .map(|r| a[r][r] * scaled[r] + omega * (0..r).map(|c| a[c][r] * scaled[c]).sum::<f64>())
        .collect();
    let mut sweep = Sweep::new(Preconditioner::Ssor(omega));
    while !sweep.step(matrix, &mut r, &mut || false) {}
    assert!(r.iter().zip(&z).all(|(found, expected)| (found - expected).abs() < 1e-10));
}

#[test]
fn products_without_a_matrix_are_those_of_the_matrix() {
    for (mesh, of) in [
        (samples::cube(7), faces as fn(&Panel) -> Result<f64, f64>),
        (samples::cube(7), mixed),
        (samples::annulus(0.5, 1.0, 200), |panel: &Panel| Ok(panel.centre.x)),
        (samples::cube(5), |panel: &Panel| Err(panel.normal.x)),
        (samples::cube(14), faces),
        (samples::cube(14), mixed),
        (samples::shell(0.5, 1.0, 3), faces),
    ] {
        let [dense, free] = [usize::MAX, 0].map(|most| equations(mesh.clone(), most, of));
        assert!(dense.matrix.row(0).is_some() && free.matrix.row(0).is_none());
        let n = dense.matrix.len();
        let x: Vec<f64> = (0..n).map(|k| (1.0 + k as f64).cos()).collect();
        let [a, b] = [&dense.matrix, &free.matrix].map(|matrix| {
            let mut y = vec![0.0; n];
            matrix.multiply(&x, &matrix.spread(&x), 0..n, &mut y);
            y
        });
        let difference: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
        // Clusters far away are expanded where there are enough of them.
        let bound = if n > 2000 { 1e-5 } else { 2e-6 };
        assert!(norm(&difference) < bound * norm(&a), "{} of {}", norm(&difference), norm(&a));
        assert!(dense.sides[0].iter().zip(&free.sides[0]).all(|(a, b)| (a - b).abs() < 1e-9));
    }
    let mesh = samples::cube(8);
    let given = conditions(&mesh, faces);
    let options = LaplaceOptions { most_dense: 100, ..LaplaceOptions::default() };
    let free = solve(Problem::new(mesh, given).unwrap(), options).unwrap();
    assert!(worst(&free, &inner(4), known::cube) < 4e-3);
}

#[test]
fn both_residuals_are_told_and_are_what_they_say() {
    let run = |preconditioner| {
        let mesh = samples::sliver_cube(4, 1e-4);
        let given = conditions(&mesh, faces);
        let options = GmresOptions { preconditioner, tolerance: 1e-8, restart: 12, most_iterations: 200 };
        let options = LaplaceOptions { method: Method::Gmres(options), ..LaplaceOptions::default() };
        solve(Problem::new(mesh, given).unwrap(), options).unwrap().convergences()[0].clone()
    };
    let none = run(Preconditioner::None);
    for (a, b) in none.residuals.iter().zip(&none.preconditioned) {
        assert!((a - b).abs() <= 1e-6 * a, "without a preconditioner both are one: {a} and {b}");
    }
    let jacobi = run(Preconditioner::Jacobi);
    assert!(jacobi.is_converged && jacobi.residuals.last().is_some_and(|last| *last <= 1e-8));
    assert!(jacobi.residuals.iter().zip(&jacobi.preconditioned).any(|(a, b)| (a - b).abs() > 0.1 * a));
    assert!(
        jacobi.preconditioned.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-9)),
        "{:?}",
        jacobi.preconditioned
    );
    assert_eq!(jacobi.iterations() + 1, jacobi.preconditioned.len());
}

#[test]
fn iterations_stay_few_where_elements_differ_in_size_and_where_walls_are_thin() {
    let iterations = |mesh: Mesh, of: fn(&Panel) -> Result<f64, f64>, kind| {
        let given = conditions(&mesh, of);
        let solution = solve(Problem::new(mesh, given).unwrap(), gmres(kind, 1e-8)).unwrap();
        let found = &solution.convergences()[0];
        (found.iterations(), found.is_converged)
    };
    let (jacobi, is_converged) = iterations(samples::sliver_cube(8, 1e-6), faces, Preconditioner::Jacobi);
    assert!(is_converged && jacobi <= 45, "{jacobi}");
    let (ssor, is_converged) = iterations(samples::sliver_cube(8, 1e-6), faces, Preconditioner::Ssor(0.5));
    assert!(is_converged && ssor <= 45, "{ssor}");
    let (none, is_converged) = iterations(samples::sliver_cube(8, 1e-6), faces, Preconditioner::None);
    assert!(!is_converged || none > 2 * jacobi, "{none}");
    let walls = |panel: &Panel| Ok(f64::from(u8::from((panel.centre - 0.5).abs().max_element() < 0.495)));
    let (thin, is_converged) = iterations(samples::hollow_box(4, 0.01), walls, Preconditioner::Jacobi);
    assert!(is_converged && thin <= 25, "{thin}");
}

#[test]
fn condition_numbers_are_estimated() {
    let made = equations(samples::cube(2), usize::MAX, faces);
    let a = columns(&made.matrix);
    let n = a.len();
    let norm = |columns: &[Vec<f64>]| {
        columns.iter().map(|c| c.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max)
    };
    let unit = |k: usize| (0..n).map(|row| f64::from(u8::from(row == k))).collect::<Vec<_>>();
    let inverse: Vec<Vec<f64>> = (0..n).map(|k| eliminated(&a, &unit(k))).collect();
    let exact = norm(&a) * norm(&inverse);
    let of = |mesh: Mesh| {
        let given = conditions(&mesh, faces);
        let options = LaplaceOptions { with_condition: true, ..LaplaceOptions::default() };
        solve(Problem::new(mesh, given).unwrap(), options).unwrap().condition().unwrap()
    };
    let found = of(samples::cube(2));
    assert!(found <= exact * (1.0 + 1e-9) && found > exact / 3.0, "{found}, exactly {exact}");
    let slivers = of(samples::sliver_cube(6, 1e-6));
    assert!((1e6..1e9).contains(&slivers), "{slivers:e}");
}

#[test]
fn fractions_sum_to_one_and_share_one_matrix() {
    let mesh = samples::shell(0.5, 1.0, 1);
    let panels = mesh.panels();
    let mix = |panel: &Panel| {
        if panel.centre.length() < 0.7 {
            [1.0, 0.0, 0.0]
        } else if panel.centre.z > 0.0 {
            [0.0, 1.0, 0.0]
        } else {
            [0.0, 0.2, 0.8]
        }
    };
    let data = (0..3).map(|k| panels.iter().map(|panel| mix(panel)[k]).collect()).collect();
    let given = Conditions { is_value: vec![true; panels.len()], data, are_fractions: true };
    let solution =
        solve(Problem::new(mesh.clone(), given.clone()).unwrap(), LaplaceOptions::default()).unwrap();
    assert_eq!(solution.convergences().len(), 2, "the last follows from the others");
    let last = solved(mesh.clone(), |panel| Ok(mix(panel)[2]));
    for k in 0..60 {
        let direction = DVec3::new(f64::from(k).sin(), f64::from(k).cos(), (0.7 * f64::from(k)).sin());
        let p = direction.normalize() * (0.55 + 0.006 * f64::from(k));
        let found = solution.at(p).unwrap().values;
        assert!(
            (found.iter().sum::<f64>() - 1.0).abs() < 1e-12 && found.iter().all(|x| (0.0..=1.0).contains(x))
        );
        assert!((found[2] - value(&last, p)).abs() < 1e-4);
    }
    let mut wrong = given;
    wrong.data[1][7] += 0.1;
    let error = Problem::new(mesh, wrong).unwrap_err();
    assert_eq!((error.fault, error.index), (Fault::Sum, Some(7)));
}

#[test]
fn wrong_problems_and_methods_are_refused() {
    let cube = samples::cube(2);
    let refused = |given: Conditions| {
        let LaplaceError { fault, index, .. } = Problem::new(samples::cube(2), given).unwrap_err();
        (fault, index)
    };
    let mut given = conditions(&cube, faces);
    given.data[0][5] = f64::NAN;
    assert_eq!(refused(given.clone()), (Fault::Conditions, Some(5)));
    given.data[0].pop();
    assert_eq!(refused(given.clone()).0, Fault::Conditions);
    given.data.clear();
    assert_eq!(refused(given).0, Fault::Conditions);
    assert_eq!(refused(conditions(&cube, |_| Err(1.0))).0, Fault::Imbalance);
    let slight = conditions(&cube, |panel| Err(panel.normal.x + 0.002));
    let balanced = Problem::new(cube.clone(), slight).unwrap();
    assert!(balanced.imbalance() > 1e-4 && balanced.imbalance() < 0.02);
    let method = |mesh: Mesh, options: LaplaceOptions| {
        let given = conditions(&mesh, faces);
        LaplaceJob::new(Problem::new(mesh, given).unwrap(), options).unwrap_err()
    };
    for omega in [0.0, 2.0, f64::NAN] {
        assert_eq!(method(cube.clone(), gmres(Preconditioner::Ssor(omega), 1e-6)).fault, Fault::Method);
    }
    let few = LaplaceOptions { most_dense: 10, ..gmres(Preconditioner::Ssor(0.5), 1e-6) };
    assert!(method(cube.clone(), few).message.contains("whole matrix"));
    assert!(
        method(samples::cube(13), LaplaceOptions { method: Method::Lu, ..LaplaceOptions::default() })
            .message
            .contains(&MOST_LU.to_string())
    );
    let through = Mesh::solid(
        samples::cube(4)
            .vertices()
            .iter()
            .copied()
            .chain(samples::cube(4).vertices().iter().map(|v| *v * 0.5 + DVec3::splat(0.7)))
            .collect(),
        {
            let count = samples::cube(4).vertices().len() as u32;
            let own = samples::cube(4).elements().to_vec();
            let turned = own.iter().map(|[a, b, c]| [a + count, c + count, b + count]);
            own.iter().copied().chain(turned).collect()
        },
    );
    let through = through.unwrap();
    let given = conditions(&through, |_| Ok(1.0));
    let found = Problem::new(through, given)
        .and_then(|problem| solve(problem, LaplaceOptions::default()))
        .unwrap_err();
    assert!(matches!(found.fault, Fault::Meeting | Fault::Apart) && found.at.is_some(), "{found:?}");
}

#[test]
fn a_job_advances_in_small_steps_and_gives_the_same() {
    for (options, most) in [
        (gmres(Preconditioner::Ssor(0.5), 1e-6), usize::MAX),
        (LaplaceOptions { method: Method::Lu, with_condition: true, most_dense: 8000 }, usize::MAX),
        (LaplaceOptions::default(), 100),
    ] {
        let options = LaplaceOptions { most_dense: options.most_dense.min(most), ..options };
        let mesh = samples::cube(5);
        let given = conditions(&mesh, faces);
        let problem = Problem::new(mesh, given).unwrap();
        let whole = solve(problem.clone(), options).unwrap();
        let mut job = LaplaceJob::new(problem, options).unwrap();
        let (mut steps, mut last) = (0, 0.0);
        let mut stages = Vec::new();
        let found = loop {
            stages.push(job.stage());
            steps += 1;
            if let Some(found) = job.step(&mut || false).unwrap() {
                break found;
            }
            assert!(job.progress() >= last - 1e-9 && job.progress() < 1.0, "{} after {last}", job.progress());
            last = job.progress();
        };
        assert!(steps > 10 && stages[0] == Stage::Assembling && stages.last() == Some(&Stage::Solving));
        assert_eq!(found.fluxes(), whole.fluxes());
        assert_eq!(found.condition(), whole.condition());
    }
}

/// Numbers on elements and inside are held in single precision, which ends at 3e38 and begins at 1e-38.
#[test]
fn data_of_any_size_have_the_same_solution() {
    let data = |size: f64| {
        move |panel: &Panel| {
            if panel.normal.x > 0.5 { Err(size) } else { Ok(size * (panel.centre.z + 0.5)) }
        }
    };
    let place = DVec3::new(0.4, 0.3, 0.6);
    let [one, others @ ..] = [1.0, 1e-90, 1e-30, 1e50, 1e99].map(|size| {
        let solution = solved(samples::cube(3), data(size));
        let (flux, gradient) = (solution.fluxes()[0][0] / size, solution.gradient(place).unwrap()[0] / size);
        let range = solution.ranges()[0].unwrap().map(|end| end / size);
        [value(&solution, place) / size, flux, gradient.x, range[0], range[1]]
    });
    for other in others {
        assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-5), "{other:?}, not {one:?}");
    }
    let mesh = samples::cube(1);
    let wrong = conditions(&mesh, |_| Ok(1e101));
    assert_eq!(Problem::new(mesh, wrong).unwrap_err().fault, Fault::Conditions);
}

/// Fluxes can ask for less than nothing of a material, or for more than all.
#[test]
fn fractions_stay_fractions_whatever_flows() {
    let mesh = samples::cube(3);
    let panels = mesh.panels();
    let made = |data: &dyn Fn(&Panel) -> [f64; 2]| {
        let is_value = panels.iter().map(|panel| panel.normal.z < 0.5).collect();
        let data = [0, 1].map(|k| panels.iter().map(|panel| data(panel)[k]).collect()).into();
        Problem::new(mesh.clone(), Conditions { is_value, data, are_fractions: true })
    };
    for flux in [8.0, -8.0] {
        let problem = made(&|panel| if panel.normal.z < 0.5 { [0.5, 0.5] } else { [flux, -flux] }).unwrap();
        let solution = solve(problem, LaplaceOptions::default()).unwrap();
        let found = solution.at(DVec3::new(0.5, 0.5, 0.95)).unwrap();
        assert!(found.is_clamped && found.values.iter().all(|x| (0.0..=1.0).contains(x)), "{found:?}");
        assert_eq!(found.values.iter().sum::<f64>(), 1.0);
    }
    let error = made(&|_| [1.5, -0.5]).unwrap_err();
    assert_eq!((error.fault, error.message.contains("1.5")), (Fault::Conditions, true));
}
