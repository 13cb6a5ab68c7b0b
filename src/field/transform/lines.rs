//! Lines of voxels along an axis, in blocks that lie together in the cache.

/// Lines of a block: as many as numbers stand side by side in a cache line.
pub(super) const BLOCK: usize = 16;

/// Where lines along an axis start and how far their voxels are apart, in a layer that is fixed along one of the other axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layer {
    /// Index of the first voxel of the first line.
    pub(super) start: usize,
    /// Number of lines; they start side by side.
    pub(super) lines: usize,
    /// From one voxel of a line to the next.
    pub(super) stride: usize,
    /// Voxels of a line.
    pub(super) length: usize,
}

impl Layer {
    /// Lines along y in the layer k, or along z in the layer j.
    pub(super) fn new([nx, ny, nz]: [usize; 3], axis: usize, at: usize) -> Self {
        match axis {
            1 => Self { start: at * nx * ny, lines: nx, stride: nx, length: ny },
            _ => Self { start: at * nx, lines: nx, stride: nx * ny, length: nz },
        }
    }

    /// Number of blocks.
    pub(super) fn blocks(&self) -> usize {
        self.lines.div_ceil(BLOCK)
    }

    /// Hands the lines of a block to `change`, one after the other, and puts back what it made of them.
    pub(super) fn change<S: Copy>(
        &self,
        data: &mut [S],
        block: usize,
        scratch: &mut Vec<S>,
        mut change: impl FnMut(&mut [S]),
    ) {
        let first = block * BLOCK;
        let count = BLOCK.min(self.lines - first);
        let Some(&filler) = data.first() else { return };
        scratch.clear();
        scratch.resize(count * self.length, filler);
        for n in 0..self.length {
            let row = &data[self.start + first + n * self.stride..][..count];
            for (line, value) in row.iter().enumerate() {
                scratch[line * self.length + n] = *value;
            }
        }
        for line in scratch.chunks_exact_mut(self.length) {
            change(line);
        }
        for n in 0..self.length {
            let row = &mut data[self.start + first + n * self.stride..][..count];
            for (line, value) in row.iter_mut().enumerate() {
                *value = scratch[line * self.length + n];
            }
        }
    }
}
