//! Angles at the ends of a ruling line.

use glam::DVec3;

/// Angle in degrees by which the second curve is turned against the first one at the ends of a ruling line: from the tangent of the
/// first to that of the second about `axis`, positive counter-clockwise, in (-180, 180].
///
/// It is 0 where the normals of the curves agree, which is what a matching looks for.
#[must_use]
pub fn twist_angle(tangents: [DVec3; 2], axis: DVec3) -> f64 {
    let [first, second] = tangents.map(|tangent| tangent - axis * tangent.dot(axis));
    let angle = axis.dot(first.cross(second)).atan2(first.dot(second)).to_degrees();
    // A rounding error must not decide between a half turn to the left and one to the right.
    if angle <= 1e-9 - 180.0 { 180.0 } else { angle }
}

/// Angle in degrees, 0 to 180, between the normals of the ruled surface at the two ends of a ruling line: n = T x r with the tangent T of the
/// curve there and the direction r of the line. 0 where the surface is developable along the line; else a cylindrical cutter
/// that touches it along the line errs by an amount that grows with the angle (section 3 of the paper, after Senatore et al. and others).
///
/// Where a curve runs along the ruling line the surface has no normal, and the angle is not a number.
#[must_use]
pub fn flank_angle(tangents: [DVec3; 2], ruling: DVec3) -> f64 {
    let [first, second] = tangents.map(|tangent| tangent.cross(ruling).normalize_or_zero());
    if first == DVec3::ZERO || second == DVec3::ZERO {
        return f64::NAN;
    }
    first.cross(second).length().atan2(first.dot(second)).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    #[test]
    fn twist_is_the_angle_about_the_axis() {
        let turned = |degrees: f64| {
            let (y, x) = degrees.to_radians().sin_cos();
            twist_angle([dvec3(2.0, 0.0, 0.3), dvec3(x, y, -0.4)], DVec3::Z)
        };
        for degrees in [0.0, 30.0, -75.0, 179.0, 180.0] {
            assert!((turned(degrees) - degrees).abs() < 1e-12, "{degrees}");
        }
        assert!(turned(-180.0) > 0.0);
    }

    #[test]
    fn flank_is_the_angle_of_the_normals_and_not_of_the_tangents() {
        // Tangents of different lengths of slope in one plane with the ruling: the surface is flat along it.
        let ruling = dvec3(1.0, 0.0, 4.0);
        let flat = flank_angle([dvec3(0.0, 1.0, 0.0), dvec3(0.0, 3.0, 0.0) + 0.5 * ruling], ruling);
        assert!(flat < 1e-6, "{flat}");
        let right = flank_angle([DVec3::X, DVec3::Y], DVec3::Z);
        assert!((right - 90.0).abs() < 1e-12);
        assert!((flank_angle([DVec3::X, -DVec3::X], DVec3::Z) - 180.0).abs() < 1e-12);
        assert!(flank_angle([DVec3::X, DVec3::Z], DVec3::Z).is_nan(), "no normal");
    }
}
