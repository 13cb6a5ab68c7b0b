//! A cone of directions in the plane.

use glam::DVec2;

/// Sine of the angle below which directions count as equal, and of the margin by which a cone must stay below a
/// half turn: far above the rounding error of a cross product, far below any angle that matters.
const MARGIN: f64 = 1e-12;

/// The smallest cone that holds some vectors. Below a half turn, a curve whose velocity stays in it advances
/// strictly along some direction, so it meets itself nowhere.
///
/// # References
/// T. Sederberg and R. Meyers, "Loop detection in surface patch intersections", *Computer Aided Geometric Design* 5
/// (1988), in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cone {
    /// No vector yet.
    Empty,
    /// From `right`, turning left by less than a half turn, to `left`.
    Narrow {
        /// Unit vector at the right end.
        right: DVec2,
        /// Unit vector at the left end.
        left: DVec2,
    },
    /// The vectors span a half turn or more.
    Wide,
}

impl Cone {
    /// The cone of the legs of a control polygon; legs no longer than `noise` have no direction and are left out.
    pub(super) fn of_legs(points: &[DVec2], noise: f64) -> Self {
        let legs = points.windows(2).map(|w| w[1] - w[0]).filter(|leg| leg.length() > noise);
        legs.filter_map(DVec2::try_normalize).fold(Self::Empty, Self::with)
    }

    /// The cone that holds the unit vector `v` as well.
    fn with(self, v: DVec2) -> Self {
        let Self::Narrow { right, left } = self else {
            return if self == Self::Empty { Self::Narrow { right: v, left: v } } else { Self::Wide };
        };
        let (from_right, to_left) = (right.perp_dot(v), v.perp_dot(left));
        let along = |side: DVec2, sine: f64| sine.abs() <= MARGIN && side.dot(v) > 0.0;
        let between = from_right >= 0.0 && to_left >= 0.0 && v.dot(right) + v.dot(left) > 0.0;
        if between || along(right, from_right) || along(left, to_left) {
            self
        } else if to_left < 0.0 && from_right > MARGIN {
            Self::Narrow { right, left: v }
        } else if from_right < 0.0 && to_left > MARGIN {
            Self::Narrow { right: v, left }
        } else {
            Self::Wide
        }
    }

    /// The cone that holds both.
    pub(super) fn union(self, other: Self) -> Self {
        match other {
            Self::Empty => self,
            Self::Narrow { right, left } => self.with(right).with(left),
            Self::Wide => Self::Wide,
        }
    }

    /// Angle in radians between the two ends; a half turn stands for that and more.
    pub(super) fn angle(self) -> f64 {
        match self {
            Self::Empty => 0.0,
            Self::Narrow { right, left } => right.angle_to(left).abs(),
            Self::Wide => std::f64::consts::PI,
        }
    }

    /// Whether the cone stays below a half turn.
    pub(super) fn is_narrow(self) -> bool {
        self != Self::Wide
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone(degrees: &[f64]) -> Cone {
        degrees.iter().map(|d| DVec2::from_angle(d.to_radians())).fold(Cone::Empty, Cone::with)
    }

    #[test]
    fn directions_within_a_half_turn_are_narrow() {
        for angles in
            [&[10.0][..], &[0.0, 0.0], &[0.0, 179.0], &[170.0, -170.0, 90.1, 269.9], &[40.0, -20.0, 20.0]]
        {
            assert!(cone(angles).is_narrow(), "{angles:?}");
        }
        for angles in [&[0.0, 180.0][..], &[0.0, 120.0, 240.0], &[0.0, 100.0, -100.0], &[0.0, 90.0, 180.0]] {
            assert!(!cone(angles).is_narrow(), "{angles:?}");
        }
    }

    #[test]
    fn union_is_that_of_all_directions() {
        assert!(cone(&[0.0, 80.0]).union(cone(&[60.0, 170.0])).is_narrow());
        assert!(!cone(&[0.0, 80.0]).union(cone(&[90.0, 190.0])).is_narrow());
        assert_eq!(cone(&[0.0, 80.0]).union(Cone::Empty), cone(&[0.0, 80.0]));
    }
}
