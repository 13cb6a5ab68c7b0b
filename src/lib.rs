//! Heterogeneous objects: bodies whose material varies from point to point.
//!
//! # A tour, in the order a reader works
//! A [`curve::BSpline`] is checked once and then answers questions about its points, normals and arc length:
//!
//! ```
//! use directrix::curve::{BSpline, Form, Scheme, sample};
//! use glam::DVec2;
//!
//! let corners = (0..12).map(|i| 10.0 * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 12.0));
//! let curve = BSpline::new(3, Form::Periodic, corners.collect(), None)?;
//! assert!(curve.signed_area() > 0.0, "counter-clockwise");
//!
//! let samples = sample(&curve, Scheme::ArcLength, 24);
//! let step = samples.arc[1] - samples.arc[0];
//! assert!((step - samples.length / 24.0).abs() < 1e-9, "equal arcs");
//! assert!(samples.normals[0].dot(samples.points[0]) > 0.0, "normals point outwards");
//! # Ok::<(), directrix::curve::CurveError>(())
//! ```
//!
//! Two sampled curves make a [`matching::Problem`]. [`matching::exact()`] joins their samples by the ruling lines of the greatest
//! integral, [`matching::greedy()`] by good ones, and [`matching::Totals`] says what lines are worth and whether they keep the
//! constraints. The shapes here are alike, so that every line runs along both normals and both solvers find the same:
//!
//! ```
//! use directrix::curve::{BSpline, Form, Scheme, sample};
//! use directrix::matching::{Bound, ExactOptions, Outline, Problem, Weights, exact, greedy, measure};
//! # use glam::DVec2;
//! # let corners = |radius: f64| (0..12).map(|i| radius * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 12.0)).collect();
//!
//! let ring = |radius| BSpline::new(3, Form::Periodic, corners(radius), None);
//! let outlines = [ring(10.0)?, ring(30.0)?].map(|curve| {
//!     let samples = sample(&curve, Scheme::ArcLength, 24);
//!     Outline::new(samples.points, samples.normals)
//! });
//! let problem = Problem::new(outlines, Weights::default(), 0.0)?;
//! let best = exact(&problem, ExactOptions::default()).map_err(|reason| reason.obstacle.to_string())?;
//! let totals = measure(&problem, &best.lines, Bound::new(&problem, &best.best));
//! assert_eq!((totals.count, totals.crossings, totals.blocked), (24, 0, 0));
//! assert!(totals.eta.is_some_and(|eta| eta > 0.999));
//! assert_eq!(greedy(&problem).lines, best.lines);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`material::Composition`] is a point of the simplex; fractions are mixed, then coloured. A [`morph::Band`] carries shape
//! and composition from one curve to the other:
//!
//! ```
//! use directrix::curve::{BSpline, Form};
//! use directrix::material::Composition;
//! use directrix::morph::Band;
//! # use glam::DVec2;
//! # let corners = |radius: f64| (0..12).map(|i| radius * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 12.0)).collect();
//!
//! let ring = |radius| BSpline::new(3, Form::Periodic, corners(radius), None);
//! let curves = [ring(10.0)?, ring(30.0)?];
//! let places: Vec<(f64, f64)> = (0..24).map(|i| (f64::from(i) / 24.0, f64::from(i) / 24.0)).collect();
//! let band = Band::new(&curves, &places, |curve, _| Composition::pure(curve, 2), 1);
//!
//! let half = band.in_between(0.5);
//! assert_eq!(half.len(), 24);
//! assert!((half[0] - (curves[0].point(0.0) + curves[1].point(0.0)) / 2.0).length() < 1e-12);
//! let [first, second] = &band.rulings()[0].ends;
//! assert_eq!(first.mix(second, 0.25).fractions(), [0.75, 0.25]);
//! # Ok::<(), directrix::curve::CurveError>(())
//! ```
//!
//! A whole document, from JSON to a picture:
//!
//! ```
//! use directrix::document::{Json, Solve, read_text};
//! use directrix::picture::{PictureOptions, figure, paint};
//!
//! let document = read_text(
//!     r#"{"directrix": 1, "kind": "curves", "matching": {"method": "greedy"}, "curves": [
//!         {"degree": 3, "form": "periodic", "points": [[10, 0], [0, 10], [-10, 0], [0, -10]]},
//!         {"degree": 3, "form": "periodic", "points": [[30, 0], [0, 30], [-30, 0], [0, -30]]}]}"#,
//! )?;
//! let solution = Solve::run(document)?;
//! assert!(solution.is_complete());
//!
//! let options = PictureOptions::read(&Json::parse(r#"{"width": 320, "height": 240}"#)?)?;
//! let viewport = options.viewport(&solution.model);
//! let list = figure(&solution, &options.figure(&solution.model), &viewport);
//! let rgba = paint(&list, &viewport)?;
//! assert_eq!(rgba.len(), 320 * 240 * 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A body of `hyperpatch::Cell`s has a shape and a material in its inside, both polynomials of the same parameters. What is certain
//! about a cell is proven from its coefficients; its volume is their mean (with the feature `hyperpatch`):
//!
//! ```
//! # #[cfg(feature = "hyperpatch")] {
//! use directrix::hyperpatch::composite::{Body, Probe, Sharing};
//! use directrix::hyperpatch::validity::{Verdict, certify};
//! use directrix::hyperpatch::{Axis, Cell, Net, Plane, section};
//! use directrix::material::Composition;
//! use glam::DVec3;
//!
//! let net = Net::cuboid(DVec3::ZERO, DVec3::new(2.0, 1.0, 1.0));
//! let [first, second] = Cell::uniform(net, &Composition::pure(0, 2))?.split(Axis::U, 0.25)?;
//! assert_eq!(certify(first.net()).verdict, Verdict::Regular);
//!
//! let mut body = Body::new(2);
//! body.add(first)?;
//! body.add(Cell::uniform(second.net().clone(), &Composition::pure(1, 2))?)?;
//! assert_eq!(Sharing::new(&body).shared_faces().len(), 1);
//! assert!((body.amounts()[1] - 1.5).abs() < 1e-12);
//! assert_eq!(Probe::new(&body).composition(DVec3::new(0.4, 0.5, 0.5)), Some(Composition::pure(0, 2)));
//! let plane = Plane::new(DVec3::new(1.0, 1.0, 0.0), 1.0)?;
//! assert!((section(&body, plane, 8)?.area() - 2.0_f64.sqrt()).abs() < 1e-12);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//! - Right-handed axes, y up, z the height of a curve's plane. Counter-clockwise means positive area. Angles in degrees.
//! - Normals point to the right of the direction of travel: outwards on a counter-clockwise curve.
//! - Lengths are in the unit of the document; pixels have y down and start at the upper left corner.
//! - Kernels compute in `f64`; `f32` appears in colours and pixels alone.
//! - A composition is a list of volume fractions, none negative, with the sum 1. Fractions are mixed, then coloured.
//! - Library functions do not panic on anything that a document can hold.

pub mod geom;
pub mod material;

#[cfg(feature = "curves")]
pub mod curve;
#[cfg(feature = "curves")]
pub mod document;
#[cfg(feature = "field")]
pub mod field;
#[cfg(feature = "hyperpatch")]
pub mod hyperpatch;
#[cfg(feature = "import")]
pub mod import;
#[cfg(feature = "laplace")]
pub mod laplace;
#[cfg(feature = "curves")]
pub mod matching;
#[cfg(feature = "curves")]
pub mod morph;
#[cfg(feature = "part")]
pub mod part;
#[cfg(feature = "curves")]
pub mod picture;
#[cfg(feature = "solid")]
pub mod solid;

#[cfg(all(feature = "curves", target_arch = "wasm32"))]
mod wasm;
