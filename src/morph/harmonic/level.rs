//! Lines on which a quantity of a field has one value.

use super::Field;
use crate::morph::IsoLine;
use glam::DVec2;
use std::collections::HashMap;

impl Field {
    /// Lines that part the vertices with at least the value `level` of a quantity from the others, exact for the quantity that is linear on triangles.
    ///
    /// An open line ends on the boundary.
    #[must_use]
    pub fn iso_lines(&self, quantity: usize, level: f64) -> Vec<IsoLine> {
        let is_above = |vertex: u32| self.value(vertex, quantity) >= level;
        // The edges that the line crosses, each with the places of its one or two triangles in the list.
        let mut crossed: HashMap<[u32; 2], [usize; 2]> = HashMap::new();
        let mut pieces: Vec<[[u32; 2]; 2]> = Vec::new();
        for corners in &self.triangles {
            let [a, b, c] = *corners;
            let edges: Vec<[u32; 2]> = [[a, b], [b, c], [c, a]]
                .into_iter()
                .filter(|[from, to]| is_above(*from) != is_above(*to))
                .map(|[from, to]| [from.min(to), from.max(to)])
                .collect();
            let Ok(ends) = <[[u32; 2]; 2]>::try_from(edges) else { continue };
            for end in ends {
                let of = crossed.entry(end).or_insert([NONE; 2]);
                of[usize::from(of[0] != NONE)] = pieces.len();
            }
            pieces.push(ends);
        }
        let mut is_used = vec![false; pieces.len()];
        let mut lines = Vec::new();
        // Lines that end on the boundary begin there; what is left after them is closed.
        let starts = (0..pieces.len()).filter(|k| pieces[*k].iter().any(|end| crossed[end][1] == NONE));
        for start in starts.chain(0..pieces.len()).collect::<Vec<_>>() {
            if is_used[start] {
                continue;
            }
            let [one, other] = pieces[start];
            let first = if crossed[&other][1] == NONE { other } else { one };
            let (mut edge, mut piece) = (first, start);
            let mut points = vec![self.crossing(edge, quantity, level)];
            let closed = loop {
                is_used[piece] = true;
                let [a, b] = pieces[piece];
                edge = if a == edge { b } else { a };
                if edge == first {
                    break true;
                }
                points.push(self.crossing(edge, quantity, level));
                let [x, y] = crossed[&edge];
                piece = if x == piece { y } else { x };
                if piece == NONE {
                    break false;
                }
            };
            points.dedup();
            if closed && points.len() > 1 && points.first() == points.last() {
                points.pop();
            }
            // What only touches the level is a point.
            if points.len() > 1 {
                lines.push(IsoLine { points, closed });
            }
        }
        lines
    }

    fn crossing(&self, [a, b]: [u32; 2], quantity: usize, level: f64) -> DVec2 {
        let (from, to) = (self.value(a, quantity) - level, self.value(b, quantity) - level);
        let t = (from / (from - to)).clamp(0.0, 1.0);
        self.points[a as usize].lerp(self.points[b as usize], t)
    }
}

/// No triangle.
const NONE: usize = usize::MAX;
