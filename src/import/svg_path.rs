//! Paths of SVG as polylines: dense enough that the curve is nowhere farther than a 50 000th of its size.

use super::MOST_POINTS;
use super::outline::Outline;
use glam::DVec2;
use kurbo::{Affine, Arc, BezPath, ParamCurve, PathEl, PathSeg, Point, SvgArc, Vec2};
use svgtypes::{PathParser, PathSegment};

/// Largest distance of a polyline from its curve, relative to the size.
const PRECISION: f64 = 2e-5;
/// The same for the Bezier curves that stand for an arc, relative to its radius.
const ARC_PRECISION: f64 = 1e-7;
/// An open path whose ends are no farther apart than this, relative to its size, is taken for closed.
const NEARLY: f64 = 0.01;
/// Ends this near to each other, relative to the size, are one.
const SAME: f64 = 1e-9;
/// Smallest turn in degrees that is a corner where a curve ends, and where two straight lines meet: lines may stand for
/// a curve that somebody drew with lines.
const CURVE_TURN: f64 = 10.0;
const LINE_TURN: f64 = 30.0;

/// A part of a path between two moves.
#[derive(Debug, Clone, Default)]
pub(super) struct Subpath {
    segments: Vec<PathSeg>,
    closed: bool,
}

/// Reads the data of a path; relative commands, short forms and arcs are resolved.
///
/// # Errors
/// When it breaks off.
pub(super) fn parse(data: &str) -> Result<BezPath, String> {
    let mut path = BezPath::new();
    let (mut start, mut last) = (Point::ORIGIN, Point::ORIGIN);
    // The control point that a short form mirrors.
    let (mut cubic, mut quadratic) = (None, None);
    let mut moved = false;
    for (index, segment) in PathParser::from(data).enumerate() {
        let segment =
            segment.map_err(|error| format!("its path data breaks off at command {}: {error}", index + 1))?;
        let base = if segment.is_abs() { Vec2::ZERO } else { last.to_vec2() };
        let at = |x: f64, y: f64| Point::new(x, y) + base;
        if !moved && !matches!(segment, PathSegment::MoveTo { .. } | PathSegment::ClosePath { .. }) {
            path.move_to(start);
            moved = true;
        }
        let (mut next_cubic, mut next_quadratic) = (None, None);
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                last = at(x, y);
                start = last;
                path.move_to(last);
                moved = true;
            }
            PathSegment::LineTo { x, y, .. } => {
                last = at(x, y);
                path.line_to(last);
            }
            PathSegment::HorizontalLineTo { x, .. } => {
                last = Point::new(x + base.x, last.y);
                path.line_to(last);
            }
            PathSegment::VerticalLineTo { y, .. } => {
                last = Point::new(last.x, y + base.y);
                path.line_to(last);
            }
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                let (a, b) = (at(x1, y1), at(x2, y2));
                last = at(x, y);
                path.curve_to(a, b, last);
                next_cubic = Some(b);
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                let (a, b) = (mirrored(last, cubic), at(x2, y2));
                last = at(x, y);
                path.curve_to(a, b, last);
                next_cubic = Some(b);
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                let a = at(x1, y1);
                last = at(x, y);
                path.quad_to(a, last);
                next_quadratic = Some(a);
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let a = mirrored(last, quadratic);
                last = at(x, y);
                path.quad_to(a, last);
                next_quadratic = Some(a);
            }
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                let to = at(x, y);
                let radii = Vec2::new(rx, ry);
                arc(
                    &mut path,
                    SvgArc {
                        from: last,
                        to,
                        radii,
                        x_rotation: x_axis_rotation.to_radians(),
                        large_arc,
                        sweep,
                    },
                );
                last = to;
            }
            PathSegment::ClosePath { .. } => {
                if moved {
                    path.close_path();
                }
                last = start;
                moved = false;
            }
        }
        (cubic, quadratic) = (next_cubic, next_quadratic);
    }
    Ok(path)
}

fn mirrored(last: Point, control: Option<Point>) -> Point {
    control.map_or(last, |control| last + (last - control))
}

/// Adds an arc as Bezier curves, or as a line when it has no radius; ends exactly where it should.
fn arc(path: &mut BezPath, arc: SvgArc) {
    // Made about the origin and of size one, since the conversion compares with fixed lengths.
    let scale = arc.radii.x.abs().max(arc.radii.y.abs());
    let unit = SvgArc {
        from: Point::ORIGIN,
        to: ((arc.to - arc.from) / scale).to_point(),
        radii: arc.radii / scale,
        ..arc
    };
    let curve = if scale > 0.0 && unit.to.is_finite() && !unit.is_straight_line() {
        Arc::from_svg_arc(&unit)
    } else {
        None
    };
    let Some(curve) = curve else {
        path.line_to(arc.to);
        return;
    };
    let place = |p: Point| arc.from + p.to_vec2() * scale;
    let mut curves = Vec::new();
    let radius = curve.radii.x.max(curve.radii.y);
    curve.to_cubic_beziers(ARC_PRECISION * radius, |a, b, end| curves.push((place(a), place(b), place(end))));
    if let Some(last) = curves.last_mut() {
        last.2 = arc.to;
    }
    for (a, b, end) in curves {
        path.curve_to(a, b, end);
    }
}

/// The parts of a path between moves, transformed; those without segments are left out.
pub(super) fn subpaths(path: &BezPath, transform: Affine) -> Vec<Subpath> {
    let mut found: Vec<Subpath> = Vec::new();
    let mut current = Subpath::default();
    let (mut start, mut last) = (Point::ORIGIN, Point::ORIGIN);
    for element in path.elements() {
        let element = transform * *element;
        match element {
            PathEl::MoveTo(to) => {
                found.push(std::mem::take(&mut current));
                (start, last) = (to, to);
            }
            PathEl::LineTo(to) => {
                current.segments.push(kurbo::Line::new(last, to).into());
                last = to;
            }
            PathEl::QuadTo(a, to) => {
                current.segments.push(kurbo::QuadBez::new(last, a, to).into());
                last = to;
            }
            PathEl::CurveTo(a, b, to) => {
                current.segments.push(kurbo::CubicBez::new(last, a, b, to).into());
                last = to;
            }
            PathEl::ClosePath => {
                if last != start {
                    current.segments.push(kurbo::Line::new(last, start).into());
                }
                current.closed = true;
                found.push(std::mem::take(&mut current));
                last = start;
            }
        }
    }
    found.push(current);
    found.retain(|subpath| !subpath.segments.is_empty());
    found
}

impl Subpath {
    /// Number of segments.
    pub(super) fn count(&self) -> usize {
        self.segments.len()
    }

    /// The outline with y up, and whether it was drawn closed.
    ///
    /// # Errors
    /// When it is open and its ends are apart, or when its coordinates are not finite.
    pub(super) fn outline(&self) -> Result<(Outline, bool), String> {
        let segments: Vec<_> = self.segments.iter().filter(|segment| reach(segment) > 0.0).collect();
        let (Some(first), Some(last)) = (segments.first(), segments.last()) else {
            return Err("it has no length".to_owned());
        };
        let points = segments.iter().flat_map(|segment| controls(segment));
        let (low, high) = points.fold(
            (Point::new(f64::MAX, f64::MAX), Point::new(f64::MIN, f64::MIN)),
            |(low, high), p| {
                (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
            },
        );
        let size = (high - low).hypot();
        if !size.is_finite() {
            return Err("its coordinates are not finite numbers".to_owned());
        }
        let gap = (last.end() - first.start()).hypot();
        let closed = self.closed || gap <= SAME * size;
        if !closed && gap > NEARLY * size {
            let gap = crate::geom::Shown(gap);
            return Err(format!("it is open: its ends are {gap} apart, more than 1 % of its size"));
        }
        let mut tolerance = PRECISION * size;
        // Coarser only for a path of so many segments that it would be too long.
        while segments.iter().map(|segment| parts(segment, tolerance)).sum::<usize>() > MOST_POINTS {
            tolerance *= 4.0;
            if tolerance > size {
                return Err(format!("it has {} segments; at most {MOST_POINTS} are read", segments.len()));
            }
        }
        let mut outline = Outline::default();
        for (i, segment) in segments.iter().enumerate() {
            let before = segments[(i + segments.len() - 1) % segments.len()];
            if is_corner(before, segment) {
                outline.corners.push(outline.points.len());
            }
            let parts = parts(segment, tolerance);
            outline.points.extend((0..parts).map(|k| place(segment.eval(k as f64 / parts as f64))));
        }
        if gap > SAME * size {
            outline.points.push(place(last.end()));
        }
        Ok((outline, closed))
    }
}

/// A place with y up.
fn place(p: Point) -> DVec2 {
    DVec2::new(p.x, 0.0 - p.y)
}

fn controls(segment: &PathSeg) -> impl Iterator<Item = Point> + use<> {
    let cubic = segment.to_cubic();
    [cubic.p0, cubic.p1, cubic.p2, cubic.p3].into_iter()
}

/// How far the control points reach from the first one.
fn reach(segment: &PathSeg) -> f64 {
    let start = segment.start();
    controls(segment).map(|p| (p - start).hypot()).fold(0.0, f64::max)
}

/// Number of equal steps of the parameter that keep the chords within the tolerance: their distance is at most an eighth of
/// the square of the step times the second derivative.
fn parts(segment: &PathSeg, tolerance: f64) -> usize {
    let bend = match *segment {
        PathSeg::Line(_) => return 1,
        PathSeg::Quad(q) => 2.0 * (q.p0.to_vec2() - 2.0 * q.p1.to_vec2() + q.p2.to_vec2()).hypot(),
        PathSeg::Cubic(c) => {
            let first = c.p0.to_vec2() - 2.0 * c.p1.to_vec2() + c.p2.to_vec2();
            let second = c.p1.to_vec2() - 2.0 * c.p2.to_vec2() + c.p3.to_vec2();
            6.0 * first.hypot().max(second.hypot())
        }
    };
    (bend / (8.0 * tolerance)).sqrt().ceil().clamp(1.0, MOST_POINTS as f64) as usize
}

/// Directions at the start and at the end of a segment that has a length.
fn directions(segment: &PathSeg) -> (Vec2, Vec2) {
    let cubic = segment.to_cubic();
    let points = [cubic.p0, cubic.p1, cubic.p2, cubic.p3];
    let least = 1e-9 * reach(segment);
    let leg = |vector: &Vec2| vector.hypot() > least;
    let start = points[1..].iter().map(|p| *p - points[0]).find(leg);
    let end = points[..3].iter().rev().map(|p| points[3] - *p).find(leg);
    (start.unwrap_or(Vec2::ZERO), end.unwrap_or(Vec2::ZERO))
}

fn turn(before: Vec2, after: Vec2) -> f64 {
    before.cross(after).atan2(before.dot(after)).abs().to_degrees()
}

/// Whether the tangent breaks between two segments that follow each other.
fn is_corner(before: &PathSeg, after: &PathSeg) -> bool {
    let straight = matches!((before, after), (PathSeg::Line(_), PathSeg::Line(_)));
    let least = if straight { LINE_TURN } else { CURVE_TURN };
    turn(directions(before).1, directions(after).0) >= least
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outlines(data: &str) -> Vec<Result<(Outline, bool), String>> {
        subpaths(&parse(data).unwrap(), Affine::IDENTITY).iter().map(Subpath::outline).collect()
    }

    fn outline(data: &str) -> Outline {
        outlines(data).remove(0).unwrap().0
    }

    #[test]
    fn every_command_reaches_the_same_corners() {
        let square = outline("M0 0 L10 0 L10 10 L0 10 Z");
        assert_eq!(square.points, [(0.0, 0.0), (10.0, 0.0), (10.0, -10.0), (0.0, -10.0)].map(DVec2::from));
        assert_eq!(square.corners, [0, 1, 2, 3]);
        for data in ["m0 0 10 0 0 10-10 0z", "M0,0H10V10H0Z", "M0 0h10v10h-10z", "M5 5m-5-5l10 0v10H0Z"] {
            assert_eq!(outline(data), square, "{data}");
        }
        // After a close the next command starts where the closed part did.
        let two = outlines("M10 10h5v5h-5z l-5 0 0 -5 5 0z");
        assert_eq!(two.len(), 2);
        assert_eq!(two[1].as_ref().unwrap().0.points[0], DVec2::new(10.0, -10.0));
    }

    #[test]
    fn short_curves_mirror_only_their_own_kind() {
        let smooth = |data: &str| parse(data).unwrap().elements().to_vec();
        assert_eq!(
            smooth("M0 0C1 1 2 1 3 0S5-1 6 0")[2],
            PathEl::CurveTo((4.0, -1.0).into(), (5.0, -1.0).into(), (6.0, 0.0).into())
        );
        assert_eq!(smooth("M0 0Q1 1 2 0T4 0")[2], PathEl::QuadTo((3.0, -1.0).into(), (4.0, 0.0).into()));
        // After a quadratic a short cubic starts in its own direction, and the other way round.
        assert_eq!(
            smooth("M0 0Q1 1 2 0S3 1 4 0")[2],
            PathEl::CurveTo((2.0, 0.0).into(), (3.0, 1.0).into(), (4.0, 0.0).into())
        );
        assert_eq!(smooth("M0 0C1 1 2 1 3 0T4 0")[2], PathEl::QuadTo((3.0, 0.0).into(), (4.0, 0.0).into()));
    }

    #[test]
    fn arcs_are_round_at_every_size() {
        for scale in [1e-6, 1.0, 1e6] {
            let data = format!("M{0} 0A{0} {0} 0 1 1 {1} 0A{0} {0} 0 0 1 {0} 0z", scale, -scale);
            let circle = outline(&data);
            assert!(circle.corners.is_empty(), "{:?}", circle.corners);
            for (a, b) in circle.points.iter().zip(&circle.points[1..]) {
                assert!((a.length() / scale - 1.0).abs() < 1e-7);
                assert!(((*a + *b) / 2.0).length() / scale > 1.0 - 1e-4);
            }
        }
        // Flags may stand without separators, and a radius of zero is a line.
        assert_eq!(outline("M0 0a0 5 0 01 10 0l0 10z").points.len(), 3);
        assert!(outline("M0 0a5 5 0 0110 0z").points.len() > 20);
    }

    #[test]
    fn corners_are_where_the_tangent_breaks() {
        let drop = outline("M0 0C5 10 10 10 10 5 C10 0 5 -5 0 0Z");
        assert_eq!(drop.corners, [0]);
        let rounded = outline("M2 0H8Q10 0 10 2V8Q10 10 8 10H2Q0 10 0 8V2Q0 0 2 0Z");
        assert!(rounded.corners.is_empty());
    }

    #[test]
    fn open_paths_close_when_their_ends_nearly_meet() {
        let (outline, closed) = outlines("M0 0H10V10H0V0.05").remove(0).unwrap();
        assert_eq!((outline.points.len(), outline.corners.len(), closed), (5, 4, false));
        let (outline, closed) = outlines("M0 0H10V10H0V0").remove(0).unwrap();
        assert_eq!((outline.points.len(), closed), (4, true));
        let reason = outlines("M0 0H10V10H0").remove(0).unwrap_err();
        assert!(reason.contains("its ends are 10 apart"), "{reason}");
        assert!(outlines("M0 0Z M3 3 M1 1 1 1").remove(0).unwrap_err().contains("no length"));
        assert!(parse("M0 0 L 1").unwrap_err().contains("breaks off at command 2"));
        assert!(parse("10 10").is_err());
    }
}
