//! Rings as the boundary of the region between them.

use super::Ring;
use crate::laplace::{LaplaceError, Mesh};
use glam::DVec2;

/// The rings of all curves: the outer one counter-clockwise, the others clockwise, so that the material is on their left.
#[derive(Debug, Clone)]
pub struct Rings {
    list: Vec<Ring>,
    outer: usize,
    /// Number of the first vertex of each ring, and the number of all.
    starts: Vec<usize>,
}

impl Rings {
    /// Rings of which one, `outer`, is known to contain all others.
    #[must_use]
    pub fn new(list: Vec<Ring>, outer: usize) -> Self {
        let mut starts = vec![0];
        starts.extend(list.iter().scan(0, |sum, ring| {
            *sum += ring.len();
            Some(*sum)
        }));
        Self { list, outer, starts }
    }

    /// The rings in the order of the curves.
    #[must_use]
    pub fn list(&self) -> &[Ring] {
        &self.list
    }

    /// Number of the ring round all others.
    #[must_use]
    pub fn outer(&self) -> usize {
        self.outer
    }

    /// Number of vertices, and of segments, of all rings.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts[self.list.len()]
    }

    /// The ring of a vertex or a segment, and its number there.
    #[must_use]
    pub fn place(&self, number: usize) -> (usize, usize) {
        let ring = self.starts.partition_point(|start| *start <= number) - 1;
        (ring, number - self.starts[ring])
    }

    /// Number of the first vertex and of the first segment of a ring.
    #[must_use]
    pub fn start(&self, ring: usize) -> usize {
        self.starts[ring]
    }

    /// The vertex at the end of a segment of a counter-clockwise ring.
    #[must_use]
    pub fn next(&self, number: usize) -> usize {
        let (ring, own) = self.place(number);
        self.starts[ring] + (own + 1) % self.list[ring].len()
    }

    /// All vertices.
    #[must_use]
    pub fn points(&self) -> Vec<DVec2> {
        self.list.iter().flat_map(|ring| &ring.points).copied().collect()
    }

    /// The segments with the material on their left; segment k joins vertex k and the next one of its ring.
    #[must_use]
    pub fn segments(&self) -> Vec<[u32; 2]> {
        let of_ring = |(ring, list): (usize, &Ring)| {
            let (start, count, is_outer) = (self.starts[ring], list.len(), ring == self.outer);
            (0..count).map(move |k| {
                let ends = [start + k, start + (k + 1) % count].map(|vertex| vertex as u32);
                if is_outer { ends } else { [ends[1], ends[0]] }
            })
        };
        self.list.iter().enumerate().flat_map(of_ring).collect()
    }

    /// The boundary for a problem.
    ///
    /// # Errors
    /// When a segment has no length to speak of.
    pub fn mesh(&self) -> Result<Mesh, LaplaceError> {
        Mesh::plane(&self.points(), &self.segments())
    }
}
