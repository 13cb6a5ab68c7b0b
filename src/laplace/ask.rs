//! Values and gradients at many points, in steps.

use super::error::{Fault, LaplaceError};
use super::solution::Solution;
use glam::DVec3;
use std::rc::Rc;

/// Most points of one question.
pub const MOST_POINTS: usize = 1 << 22;

/// What is asked for at points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The value of each material.
    Values,
    /// The gradient of each material, with as many numbers as the space has dimensions.
    Gradients,
}

/// What was found at points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Found {
    /// The numbers of each point, one point after the other; no numbers outside.
    pub numbers: Vec<f64>,
    /// Points where a value was out of the range that the boundary allows, and was taken back to it.
    pub clamped: usize,
    /// Points outside.
    pub outside: usize,
}

/// A question about points being answered.
#[derive(Debug)]
pub struct PointsJob {
    solution: Rc<Solution>,
    points: Vec<DVec3>,
    quantity: Quantity,
    refuses_outside: bool,
    found: Found,
    next: usize,
}

impl PointsJob {
    /// A question about points; with `refuses_outside` one that is outside is an error, else it has no numbers.
    ///
    /// # Errors
    /// When there are more than [`MOST_POINTS`], or one is not finite.
    pub fn new(
        solution: Rc<Solution>,
        points: Vec<DVec3>,
        quantity: Quantity,
        refuses_outside: bool,
    ) -> Result<Self, LaplaceError> {
        if points.len() > MOST_POINTS {
            let message = format!("{} points were found; expected {MOST_POINTS} at most", points.len());
            return Err(LaplaceError::new(Fault::Points, message));
        }
        if let Some(wrong) = points.iter().position(|point| !point.is_finite()) {
            let message = format!("{} was found; expected finite coordinates", points[wrong]);
            return Err(LaplaceError::new(Fault::Points, message).of(wrong));
        }
        Ok(Self { solution, points, quantity, refuses_outside, found: Found::default(), next: 0 })
    }

    /// Goes on while `may_go_on` says so, at least by a point; returns whether all are done.
    ///
    /// # Errors
    /// When a point is outside and that is refused, with its place.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Result<bool, LaplaceError> {
        while let Some(point) = self.points.get(self.next).copied() {
            if !self.answer(point) {
                let [x, y, z] = point.to_array();
                let place =
                    if self.dimension() == 2 { format!("({x}, {y})") } else { format!("({x}, {y}, {z})") };
                let message =
                    format!("{place} is outside of the body; expected a point inside or on its boundary");
                return Err(LaplaceError::new(Fault::Outside, message).of(self.next).at(point));
            }
            self.next += 1;
            if !may_go_on() {
                break;
            }
        }
        Ok(self.next == self.points.len())
    }

    /// Dimensions of the space: 2 or 3.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.solution.problem().mesh().space().dimension()
    }

    /// Share of the points that are done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.next as f64 / self.points.len().max(1) as f64
    }

    /// What was found, once all points are done.
    #[must_use]
    pub fn found(self) -> Found {
        self.found
    }

    /// Answers for a point; returns false when it is outside and that is refused.
    fn answer(&mut self, point: DVec3) -> bool {
        let materials = self.solution.materials();
        let dimension = self.dimension();
        let width = match self.quantity {
            Quantity::Values => materials,
            Quantity::Gradients => materials * dimension,
        };
        let numbers = &mut self.found.numbers;
        let is_inside = match self.quantity {
            Quantity::Values => self.solution.at(point).is_some_and(|value| {
                self.found.clamped += usize::from(value.is_clamped);
                numbers.extend(value.values);
                true
            }),
            Quantity::Gradients => self.solution.gradient(point).is_some_and(|gradients| {
                numbers.extend(
                    gradients.iter().flat_map(|gradient| gradient.to_array().into_iter().take(dimension)),
                );
                true
            }),
        };
        if !is_inside {
            self.found.outside += 1;
            numbers.extend(std::iter::repeat_n(f64::NAN, width));
        }
        is_inside || !self.refuses_outside
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::{Conditions, LaplaceOptions, Problem, samples, solve};

    #[test]
    fn points_outside_are_refused_with_their_place_or_left_empty() {
        let mesh = samples::annulus(0.5, 1.0, 40);
        let conditions = Conditions::single(mesh.panels().iter().map(|panel| Ok(panel.centre.x)));
        let solution =
            Rc::new(solve(Problem::new(mesh, conditions).unwrap(), LaplaceOptions::default()).unwrap());
        let points = vec![DVec3::X * 0.7, DVec3::ZERO, DVec3::Y * 0.8];
        let mut job = PointsJob::new(Rc::clone(&solution), points.clone(), Quantity::Values, true).unwrap();
        let error = job.step(&mut || true).unwrap_err();
        assert_eq!((error.fault, error.index, error.at), (Fault::Outside, Some(1), Some(DVec3::ZERO)));
        let mut job = PointsJob::new(Rc::clone(&solution), points, Quantity::Gradients, false).unwrap();
        let mut steps = 1;
        while !job.step(&mut || false).unwrap() {
            steps += 1;
        }
        let found = job.found();
        assert_eq!((steps, found.outside, found.numbers.len()), (3, 1, 6));
        assert!(found.numbers[2].is_nan() && (found.numbers[0] - 1.0).abs() < 0.05);
        assert_eq!(
            PointsJob::new(solution, vec![DVec3::NAN], Quantity::Values, true).unwrap_err().fault,
            Fault::Points
        );
    }
}
