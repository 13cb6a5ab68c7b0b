//! Remarks on a document whose fields are all valid.

use crate::geom::ShownPlace;
use crate::matching::Obstacle;
use glam::DVec2;
use std::fmt;

/// Something about the geometry that a person should know: a remark on the result, or why there is none.
///
/// Curves are numbered as in the document, vertices along the counter-clockwise curve.
#[derive(Debug, Clone, PartialEq)]
pub enum Diagnostic {
    /// A drawing in progress: fewer than two curves.
    Incomplete {
        /// Number of curves that are there, 0 or 1.
        curves: usize,
    },
    /// A curve has a corner; the normal there is the bisector of the two sides.
    Corner {
        /// Number of the curve.
        curve: usize,
        /// Parameter on the counter-clockwise curve.
        parameter: f64,
        /// Where it lies.
        at: DVec2,
        /// Turn of the tangent in degrees, positive to the left.
        turn: f64,
        /// The bisector that stands in for the normal, a unit vector to the right of the counter-clockwise curve.
        normal: DVec2,
    },
    /// A curve would need more than 1000 adaptive samples: it has 1000, where they help most.
    SampleLimit {
        /// Number of the curve.
        curve: usize,
    },
    /// Lines whose ends have opposed normals; with signed products such a line is less bad when longer.
    OpposedNormals {
        /// Indices of the lines.
        lines: Vec<usize>,
    },
    /// Vertices that see no vertex of the other curve.
    Orphan {
        /// Number of the curve.
        curve: usize,
        /// Indices of the vertices.
        vertices: Vec<usize>,
    },
    /// Vertices that see the other curve but got no line, because earlier lines are in the way.
    Stuck {
        /// Number of the curve.
        curve: usize,
        /// Indices of the vertices.
        vertices: Vec<usize>,
    },
    /// Neighbouring vertices each of which sees the other curve, but which cannot all have lines at once.
    Jammed {
        /// Number of the curve.
        curve: usize,
        /// Indices of the vertices, in order round the curve.
        vertices: Vec<usize>,
    },
    /// Greedy lines left vertices bare although another method reaches all of them.
    Solvable,
    /// Pins that cannot be kept.
    Pins {
        /// Indices of the pins.
        pins: Vec<usize>,
        /// Why.
        obstacle: Obstacle,
    },
    /// The lines that join the ends of open curves cannot be kept.
    Ends {
        /// Why.
        obstacle: Obstacle,
    },
    /// Samples of open curves with free ends that lie beyond the first or the last line.
    LeftOut {
        /// Number of the curve.
        curve: usize,
        /// Indices of the vertices.
        vertices: Vec<usize>,
    },
    /// Lines that are not visible, added to reach every vertex.
    Occluded {
        /// Indices of the lines.
        lines: Vec<usize>,
    },
    /// One-to-one lines that meet a curve or cross another line.
    Unverified {
        /// Indices of the pairs.
        lines: Vec<usize>,
    },
    /// A gap between two lines in which inserted lines meet a polygon or another line; it keeps the lines it had.
    UnverifiedGap {
        /// Indices of the pairs from one side of the gap to the other.
        lines: Vec<usize>,
        /// Where an inserted line failed.
        at: DVec2,
    },
    /// Neither curve lies inside the other.
    Disjoint,
    /// Curves at different heights whose projections cross.
    Crossing {
        /// A place where they do.
        at: DVec2,
    },
    /// The curves keep apart but their sampled polygons do not.
    CoarseSampling {
        /// A place where they meet.
        at: Option<DVec2>,
    },
    /// A remark on one span of a stack; curves and pins are numbered as in the document, lines and vertices as in the span.
    #[cfg(feature = "stack")]
    InSpan {
        /// Number of the span.
        span: usize,
        /// The remark.
        remark: Box<Diagnostic>,
    },
    /// A curve of a stack does not lie between its neighbours, which have the same height.
    #[cfg(feature = "stack")]
    Order {
        /// Number of the curve.
        curve: usize,
        /// A point where that shows.
        at: DVec2,
    },
    /// A cubic blend of curves of one height lies over itself or over a curve.
    #[cfg(feature = "stack")]
    Overlap {
        /// Number of the span.
        span: usize,
        /// Where.
        at: DVec2,
    },
    /// No thread leads through all curves of an open stack: free ends leave nothing that all spans cover.
    #[cfg(feature = "stack")]
    NoThread,
    /// Several curves lie side by side in one: ruling lines join a curve with one other.
    #[cfg(feature = "harmonic")]
    SeveralInner {
        /// Number of the curve that contains the others.
        outer: usize,
        /// Numbers of the others.
        curves: Vec<usize>,
    },
    /// Curves of a harmonic blend that are open.
    #[cfg(feature = "harmonic")]
    OpenCurves {
        /// Their numbers.
        curves: Vec<usize>,
    },
    /// Two curves of a harmonic blend meet.
    #[cfg(feature = "harmonic")]
    CurvesMeet {
        /// Their numbers.
        curves: [usize; 2],
        /// Where.
        at: DVec2,
    },
    /// No curve of a harmonic blend contains all others.
    #[cfg(feature = "harmonic")]
    NoOuter {
        /// Numbers of those that lie in no other.
        curves: Vec<usize>,
        /// A point of the second one.
        at: DVec2,
    },
    /// A curve inside of a harmonic blend contains another.
    #[cfg(feature = "harmonic")]
    Nested {
        /// Number of the curve inside the other, and of the other.
        curves: [usize; 2],
        /// A point of the first of them.
        at: DVec2,
    },
    /// Curves of a harmonic blend whose height is not that of the outer one, which does not count.
    #[cfg(feature = "harmonic")]
    HeightsIgnored {
        /// Their numbers.
        curves: Vec<usize>,
    },
    /// Laplace's equation could not be solved between the curves of a harmonic blend.
    #[cfg(feature = "harmonic")]
    NoField {
        /// Why.
        reason: String,
        /// A place, where there is one.
        at: Option<DVec2>,
    },
    /// Lines along the gradient that did not come to the outer curve and are left out.
    #[cfg(feature = "harmonic")]
    LostLines {
        /// How many.
        count: usize,
    },
    /// The ruled blend with which a harmonic one is compared is not complete.
    #[cfg(feature = "harmonic")]
    NoRuledBlend,
}

impl Diagnostic {
    /// Name of the kind, stable across releases.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Incomplete { .. } => "incomplete",
            Self::Corner { .. } => "corner",
            Self::SampleLimit { .. } => "sample-limit",
            Self::OpposedNormals { .. } => "opposed-normals",
            Self::Orphan { .. } => "orphan",
            Self::Stuck { .. } => "stuck",
            Self::Jammed { .. } => "jammed",
            Self::Solvable => "solvable",
            Self::Pins { .. } => "pins",
            Self::Ends { .. } => "ends",
            Self::LeftOut { .. } => "left-out",
            Self::Occluded { .. } => "occluded",
            Self::Unverified { .. } => "unverified",
            Self::UnverifiedGap { .. } => "unverified-gap",
            Self::Disjoint => "disjoint",
            Self::Crossing { .. } => "crossing",
            Self::CoarseSampling { .. } => "coarse-sampling",
            #[cfg(feature = "stack")]
            Self::InSpan { remark, .. } => remark.code(),
            #[cfg(feature = "stack")]
            Self::Order { .. } => "order",
            #[cfg(feature = "stack")]
            Self::Overlap { .. } => "overlap",
            #[cfg(feature = "stack")]
            Self::NoThread => "no-thread",
            #[cfg(feature = "harmonic")]
            Self::SeveralInner { .. } => "several-inner",
            #[cfg(feature = "harmonic")]
            Self::OpenCurves { .. } => "open-curves",
            #[cfg(feature = "harmonic")]
            Self::CurvesMeet { .. } => "curves-meet",
            #[cfg(feature = "harmonic")]
            Self::NoOuter { .. } => "no-outer",
            #[cfg(feature = "harmonic")]
            Self::Nested { .. } => "nested",
            #[cfg(feature = "harmonic")]
            Self::HeightsIgnored { .. } => "heights-ignored",
            #[cfg(feature = "harmonic")]
            Self::NoField { .. } => "no-field",
            #[cfg(feature = "harmonic")]
            Self::LostLines { .. } => "lost-lines",
            #[cfg(feature = "harmonic")]
            Self::NoRuledBlend => "no-ruled-blend",
        }
    }
}

#[cfg(feature = "stack")]
impl Diagnostic {
    /// A remark on a span with the numbers of the stack; `pins` are those of the pins of the span.
    pub(super) fn in_stack(&self, span: usize, pins: &[usize]) -> Self {
        let mut remark = self.clone();
        match &mut remark {
            Self::Orphan { curve, .. }
            | Self::Stuck { curve, .. }
            | Self::Jammed { curve, .. }
            | Self::LeftOut { curve, .. } => *curve += span,
            Self::Pins { pins: own, obstacle } => {
                let name = |number: &mut usize| *number = pins.get(*number).copied().unwrap_or(*number);
                own.iter_mut().for_each(name);
                match obstacle {
                    Obstacle::NoSuchVertex { pin } | Obstacle::PinBlocked { pin } => name(pin),
                    Obstacle::PinsCross { pins } | Obstacle::NoRoom { pins } => {
                        pins.iter_mut().for_each(name)
                    }
                    _ => {}
                }
            }
            _ => {}
        }
        remark
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let near = |f: &mut fmt::Formatter<'_>, at: &DVec2| write!(f, " near {}", ShownPlace(*at));
        match self {
            Self::Incomplete { curves: 0 } => {
                write!(
                    f,
                    "0 of 2 curves are there; draw or import two closed curves, one inside the other, or two open ones"
                )
            }
            Self::Incomplete { curves } => {
                write!(f, "{curves} of 2 curves is there; draw or import a second one")
            }
            Self::Corner { curve, at, turn, .. } => {
                write!(f, "curve {curve} has a corner of {} degrees", turn.round())?;
                near(f, at)
            }
            Self::SampleLimit { curve } => {
                write!(
                    f,
                    "curve {curve} has the most samples allowed, 1000, and would need more; raise the tolerance or the turn"
                )
            }
            Self::OpposedNormals { lines } => {
                write!(f, "{} lines join points with opposed normals", lines.len())
            }
            Self::Orphan { curve, vertices } => {
                write!(f, "{} vertices of curve {curve} see no vertex of the other curve", vertices.len())
            }
            Self::Stuck { curve, vertices } => {
                write!(
                    f,
                    "{} vertices of curve {curve} got no line: better lines are in the way",
                    vertices.len()
                )
            }
            Self::UnverifiedGap { at, .. } => {
                write!(f, "no one-to-one lines fit into a gap")?;
                near(f, at)?;
                write!(f, "; it keeps the lines it had")
            }
            Self::Disjoint => write!(f, "neither curve lies inside the other; move one curve into the other"),
            Self::Jammed { curve, vertices } => write!(
                f,
                "{} neighbouring vertices of curve {curve} cannot all have lines at once",
                vertices.len()
            ),
            Self::Solvable => write!(f, "the method `exact` reaches every vertex"),
            Self::Pins { obstacle, .. } | Self::Ends { obstacle } => write!(f, "{obstacle}"),
            Self::LeftOut { curve, vertices } => write!(
                f,
                "{} vertices of curve {curve} lie beyond the first or the last line",
                vertices.len()
            ),
            Self::Occluded { lines } => {
                write!(f, "{} lines were added that pass through a curve", lines.len())
            }
            Self::Unverified { lines } => {
                write!(f, "{} one-to-one lines meet a curve or cross another", lines.len())
            }
            Self::Crossing { at } => {
                write!(f, "the curves cross in projection")?;
                near(f, at)
            }
            Self::CoarseSampling { at } => {
                write!(f, "the sampled polygons meet although the curves do not")?;
                at.iter().try_for_each(|at| near(f, at))?;
                write!(f, "; take more samples")
            }
            #[cfg(feature = "stack")]
            Self::InSpan { span, remark } => write!(f, "between curves {span} and {}: {remark}", span + 1),
            #[cfg(feature = "stack")]
            Self::Order { curve, at } => {
                write!(
                    f,
                    "curve {curve} is out of order: curves of one height have to lie one inside the next, or side by side, as the stack lists them; it does not"
                )?;
                near(f, at)
            }
            #[cfg(feature = "stack")]
            Self::Overlap { span, at } => {
                write!(f, "between curves {span} and {} the cubic blend lies over itself", span + 1)?;
                near(f, at)?;
                write!(f, "; the blend `ruled` does not, and curves that are farther apart may help")
            }
            #[cfg(feature = "stack")]
            Self::NoThread => {
                write!(f, "no line leads through all curves; `ends` that are `tied` leave no curve out")
            }
            #[cfg(feature = "harmonic")]
            Self::SeveralInner { outer, curves } => write!(
                f,
                "{} lie side by side in curve {outer}: ruling lines join a curve with one other; the blend `harmonic` takes several inner curves",
                Curves(curves)
            ),
            #[cfg(feature = "harmonic")]
            Self::OpenCurves { curves } => {
                let verb = if curves.len() == 1 { "is" } else { "are" };
                write!(f, "{} {verb} open; expected closed curves for the blend `harmonic`", Curves(curves))
            }
            #[cfg(feature = "harmonic")]
            Self::CurvesMeet { curves, at } => {
                write!(f, "{} meet", Curves(curves))?;
                near(f, at)?;
                write!(f, "; expected curves that keep apart, whatever their heights")
            }
            #[cfg(feature = "harmonic")]
            Self::NoOuter { curves, at } => {
                write!(
                    f,
                    "{} lie in no other curve; expected one curve that contains all others: see",
                    Curves(curves)
                )?;
                near(f, at)
            }
            #[cfg(feature = "harmonic")]
            Self::Nested { curves: [inner, outer], at } => {
                write!(f, "curve {inner} lies inside curve {outer}, which lies inside another")?;
                near(f, at)?;
                write!(f, "; expected inner curves side by side")
            }
            #[cfg(feature = "harmonic")]
            Self::HeightsIgnored { curves } => write!(
                f,
                "the heights of {} do not count: the blend `harmonic` takes all curves in one plane",
                Curves(curves)
            ),
            #[cfg(feature = "harmonic")]
            Self::NoField { reason, at } => {
                write!(f, "there is no harmonic blend: {reason}")?;
                at.iter().try_for_each(|at| near(f, at))
            }
            #[cfg(feature = "harmonic")]
            Self::LostLines { count } => {
                write!(
                    f,
                    "{count} lines along the gradient did not come to the outer curve; take more segments"
                )
            }
            #[cfg(feature = "harmonic")]
            Self::NoRuledBlend => write!(
                f,
                "the ruled blend of these curves is not complete, so that there is nothing to compare with"
            ),
        }
    }
}

/// Numbers of curves as a person reads them.
#[cfg(feature = "harmonic")]
struct Curves<'a>(&'a [usize]);

#[cfg(feature = "harmonic")]
impl fmt::Display for Curves<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            [one] => write!(f, "curve {one}"),
            [first @ .., last] => {
                let names: Vec<String> = first.iter().map(usize::to_string).collect();
                write!(f, "curves {} and {last}", names.join(", "))
            }
            [] => f.write_str("no curves"),
        }
    }
}
