//! The place of a point in a stack, and lines of equal composition through it.

use super::StackBlend;
use crate::material::Composition;
use crate::morph::IsoLine;
use glam::DVec2;
use std::collections::HashMap;

/// Where a point lies in a stack.
#[derive(Debug, Clone, PartialEq)]
pub struct StackPlace {
    /// Number of the span.
    pub span: usize,
    /// Place in the whole stack, from 0 on the first curve to 1 on the last one.
    pub s: f64,
    /// Parameter of its thread on the first curve of the span.
    pub u: f64,
    /// Parameter on the second curve of the span.
    pub v: f64,
    /// Composition at the point.
    pub composition: Composition,
}

impl StackBlend {
    /// Returns the place of a point in the plane, or `None` when it lies outside. A cubic blend is taken for bilinear between strands and the rows that cut
    /// each span into eight. Where spans lie over each other, the highest one counts, of equal ones the last.
    #[must_use]
    pub fn locate(&self, point: DVec2) -> Option<StackPlace> {
        self.from_below().into_iter().rev().find_map(|span| {
            self.strips(span).find_map(|strip| {
                let place = strip.band.locate(point)?;
                let share = strip.from + place.s * (strip.to - strip.from);
                let (s, composition) = (self.s_at(span, share), place.composition);
                Some(StackPlace { span, s, u: place.u, v: place.v, composition })
            })
        })
    }

    /// The spans in the order in which a look from above covers them: by the mean of their heights, then as they are numbered.
    #[must_use]
    pub fn from_below(&self) -> Vec<usize> {
        let mut spans: Vec<usize> = (0..self.spans()).collect();
        let middle = |span: &usize| self.heights[*span] / 2.0 + self.heights[span + 1] / 2.0;
        spans.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
        spans
    }

    /// Lines that part the places with at least the fraction `level` of a material from the others, from span to span in one piece.
    ///
    /// # Panics
    /// When there is no such material.
    #[must_use]
    pub fn iso_lines(&self, material: usize, level: f64) -> Vec<IsoLine> {
        let spans = 0..self.spans();
        let strips = spans.flat_map(|span| self.strips(span).map(|strip| strip.band).collect::<Vec<_>>());
        joined(strips.flat_map(|band| band.iso_lines(material, level)).collect())
    }
}

/// Joins open lines whose ends are the same point.
fn joined(lines: Vec<IsoLine>) -> Vec<IsoLine> {
    let key = |point: DVec2| [point.x, point.y].map(|x| (x + 0.0).to_bits());
    let mut found = Vec::new();
    // Open lines by number, and which one ends at a place.
    let mut open: Vec<Option<Vec<DVec2>>> = Vec::new();
    let mut ends: HashMap<[u64; 2], usize> = HashMap::new();
    for line in lines {
        if line.closed {
            found.push(line);
            continue;
        }
        let mut points = line.points;
        // Each end of the new line may continue another one.
        for _ in 0..2 {
            let last = points[points.len() - 1];
            if let Some(other) = ends.remove(&key(last))
                && let Some(mut more) = open[other].take()
            {
                if more[0] != last {
                    more.reverse();
                }
                ends.remove(&key(more[more.len() - 1]));
                points.extend(more.drain(1..));
            }
            points.reverse();
            if points.len() > 3 && points[0] == points[points.len() - 1] {
                break;
            }
        }
        if points.len() > 3 && points[0] == points[points.len() - 1] {
            points.pop();
            found.push(IsoLine { points, closed: true });
            continue;
        }
        ends.insert(key(points[0]), open.len());
        ends.insert(key(points[points.len() - 1]), open.len());
        open.push(Some(points));
    }
    found.extend(open.into_iter().flatten().map(|points| IsoLine { points, closed: false }));
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn pieces_join_whichever_way_they_run() {
        let line = |points: &[(f64, f64)]| IsoLine {
            points: points.iter().map(|&(x, y)| dvec2(x, y)).collect(),
            closed: false,
        };
        let pieces = vec![
            line(&[(0.0, 0.0), (1.0, 0.0)]),
            line(&[(2.0, 0.0), (3.0, 0.0)]),
            line(&[(2.0, 0.0), (1.0, 0.0)]),
            line(&[(9.0, 9.0), (8.0, 8.0)]),
        ];
        let mut found = joined(pieces);
        found.sort_by_key(|line| line.points.len());
        assert_eq!(found.iter().map(|line| line.points.len()).collect::<Vec<_>>(), [2, 4]);
        let ring = joined(vec![
            line(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]),
            line(&[(0.0, 0.0), (0.0, 1.0), (1.0, 1.0)]),
        ]);
        assert!(ring.len() == 1 && ring[0].closed && ring[0].points.len() == 4);
    }
}
