//! The verdict on a cell, with what it rests on.

use super::{Certificate, Finding, Injectivity, REGULAR_MARGIN, Sign, margin};
use crate::hyperpatch::{Axis, Jacobian, Net};
use glam::DVec3;

/// What is known of a cell, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// The cone condition holds: the cell is injective, and its points are spread regularly.
    Regular,
    /// The determinant is positive and the cell injective, though not regular. The paper's condition rejects such a
    /// cell (Fig. 6).
    Valid,
    /// The determinant is positive; whether the cell meets itself has not been decided.
    LocallyValid,
    /// The determinant touches zero within the tolerance, or comes too close to it to be decided.
    Degenerate,
    /// There is a witness that the cell is turned inside out in a place, or meets itself.
    Invalid,
}

impl Verdict {
    /// The verdict as it is written in results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Regular => "regular",
            Self::Valid => "valid",
            Self::LocallyValid => "locally-valid",
            Self::Degenerate => "degenerate",
            Self::Invalid => "invalid",
        }
    }
}

/// Places that show what is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Witness {
    /// The determinant has the wrong sign, or is zero, at these parameters.
    Folded {
        /// Parameters.
        at: DVec3,
        /// The determinant there; of a mirrored cell that of the reoriented one.
        jacobian: f64,
    },
    /// Two parameters have one point.
    Meeting {
        /// Parameters of the one.
        first: DVec3,
        /// Parameters of the other.
        second: DVec3,
    },
}

/// The verdict on a cell, with what it rests on.
///
/// A mirrored cell has the verdict of its reoriented self: the one with an axis
/// [reversed](super::super::Cell::reversed).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Report {
    /// What is known.
    pub verdict: Verdict,
    /// Whether the volume is negative, so that one axis has to be reversed for the cell to be the right way round.
    pub is_mirrored: bool,
    /// How regular the cell is, from -1 to 1; see [`margin`].
    pub margin: f64,
    /// Bounds of the least determinant.
    pub certificate: Certificate,
    /// What is wrong with a cell that is invalid or degenerate.
    pub witness: Option<Witness>,
}

impl Report {
    /// The report after the job on injectivity: of a locally valid cell, and of the same shape, or the badge would be
    /// stale.
    #[must_use]
    pub fn with(self, finding: Finding) -> Self {
        match (self.verdict, finding) {
            (Verdict::LocallyValid, Finding::Injective) => Self { verdict: Verdict::Valid, ..self },
            (Verdict::LocallyValid, Finding::Meeting { first, second }) => {
                Self { verdict: Verdict::Invalid, witness: Some(Witness::Meeting { first, second }), ..self }
            }
            _ => self,
        }
    }

    /// Whether the job on injectivity can say more.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.verdict == Verdict::LocallyValid
    }
}

/// The certificates of a cell, quick enough for every edit: cone condition and sign of the determinant.
#[must_use]
pub fn certify(net: &Net) -> Report {
    let jacobian = Jacobian::new(net);
    let is_mirrored = jacobian.volume() < -jacobian.error();
    let certificate = Certificate::new(&jacobian, is_mirrored);
    let margin = if is_mirrored { margin(&net.reversed(Axis::U)) } else { margin(net) };
    let witness = Witness::Folded { at: certificate.at, jacobian: certificate.upper };
    let (verdict, witness) = match certificate.sign {
        Sign::Positive if margin > REGULAR_MARGIN => (Verdict::Regular, None),
        Sign::Positive => (Verdict::LocallyValid, None),
        Sign::Undecided => (Verdict::Degenerate, Some(witness)),
        Sign::Negative => (Verdict::Invalid, Some(witness)),
    };
    Report { verdict, is_mirrored, margin, certificate, witness }
}

/// The verdict on a cell with every check run to its end.
#[must_use]
pub fn verdict(net: &Net) -> Report {
    let report = certify(net);
    if report.is_open() { report.with(Injectivity::new(net, report.is_mirrored).run()) } else { report }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{crossing_bar, folded, quarter_ring, random_net, ring_cell, twisted};

    #[test]
    fn verdicts_of_known_cells() {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        let pinched = Net(cube.0.map(|p| DVec3::new(p.x * p.z, p.y * p.z, p.z)));
        let cells = [
            (cube.clone(), Verdict::Regular, Verdict::Regular),
            (ring_cell(5, 2, 1.0, 2.0, 1.0), Verdict::Regular, Verdict::Regular),
            (quarter_ring(1.0, 2.0, 1.0), Verdict::LocallyValid, Verdict::Valid),
            (twisted(89.0), Verdict::Regular, Verdict::Regular),
            (twisted(90.0), Verdict::LocallyValid, Verdict::Valid),
            (twisted(150.0), Verdict::LocallyValid, Verdict::Valid),
            (folded(1.1), Verdict::LocallyValid, Verdict::Valid),
            (folded(1.3), Verdict::Invalid, Verdict::Invalid),
            (crossing_bar(), Verdict::LocallyValid, Verdict::Invalid),
            (pinched, Verdict::Degenerate, Verdict::Degenerate),
            (cube.map(|_| DVec3::X), Verdict::Degenerate, Verdict::Degenerate),
        ];
        for (n, (net, quick, whole)) in cells.into_iter().enumerate() {
            for (net, is_mirrored) in [(net.clone(), false), (net.reversed(Axis::V), true)] {
                let report = certify(&net);
                assert_eq!(report.verdict, quick, "cell {n}: {report:?}");
                assert_eq!(verdict(&net).verdict, whole, "cell {n}");
                assert_eq!(report.is_mirrored, is_mirrored && n < 10, "cell {n}: a point has no side");
                assert_eq!(
                    verdict(&net).witness.is_some(),
                    matches!(whole, Verdict::Invalid | Verdict::Degenerate)
                );
            }
        }
    }

    /// Regular implies valid implies positive on a dense sample; no state says more than the samples do.
    #[test]
    fn verdicts_agree_with_dense_samples() {
        let mut seen = [0; 3];
        for seed in 0..80 {
            let net = random_net(seed, 0.05 + 0.2 * seed as f64 / 80.0);
            let report = verdict(&net);
            let least =
                (0..1331).map(|n| DVec3::new((n / 121) as f64, (n / 11 % 11) as f64, (n % 11) as f64) / 10.0);
            let least = least.map(|at| net.jacobian(at)).fold(f64::INFINITY, f64::min);
            match report.verdict {
                Verdict::Regular => {
                    seen[0] += 1;
                    assert!(report.margin > 0.0 && least > 0.0);
                }
                Verdict::Valid => {
                    seen[1] += 1;
                    assert!(report.margin <= REGULAR_MARGIN && least > 0.0);
                }
                Verdict::Invalid => {
                    seen[2] += 1;
                    match report.witness.expect("a witness") {
                        Witness::Folded { at, jacobian } => assert!(jacobian < 0.0 && net.jacobian(at) < 0.0),
                        Witness::Meeting { first, second } => {
                            assert!((net.point(first) - net.point(second)).length() < 1e-9);
                        }
                    }
                }
                other => panic!("seed {seed}: {other:?}"),
            }
        }
        assert!(seen.iter().all(|&count| count > 3), "{seen:?}");
    }

    /// The shape of a cell that lies far away, or is huge or tiny, has the same verdict.
    #[test]
    fn verdicts_do_not_depend_on_place_and_scale() {
        for net in [folded(1.1), folded(1.3), twisted(120.0)] {
            let expected = verdict(&net).verdict;
            for (scale, shift) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1e5)] {
                let moved = net.map(|p| p * scale + DVec3::splat(shift));
                assert_eq!(verdict(&moved).verdict, expected, "{scale} {shift}");
            }
        }
    }
}
