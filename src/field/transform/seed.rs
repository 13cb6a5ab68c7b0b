//! What a voxel knows of the nearest feature.

/// The squared distance to the nearest voxel of a feature so far, with whatever goes along with it.
pub trait Seed: Copy + PartialEq {
    /// No feature is known.
    const NONE: Self;

    /// A voxel of a feature by its index.
    fn feature(index: u32) -> Self;

    /// The squared distance; infinite without a feature.
    fn level(self) -> f64;

    /// The same feature at another squared distance.
    fn at(self, level: f64) -> Self;
}

/// In voxels: every sum of squares below 2^24 is exact.
impl Seed for f32 {
    const NONE: Self = f32::INFINITY;

    fn feature(_: u32) -> Self {
        0.0
    }

    fn level(self) -> f64 {
        f64::from(self)
    }

    fn at(self, level: f64) -> Self {
        level as f32
    }
}

impl Seed for f64 {
    const NONE: Self = f64::INFINITY;

    fn feature(_: u32) -> Self {
        0.0
    }

    fn level(self) -> f64 {
        self
    }

    fn at(self, level: f64) -> Self {
        level
    }
}

/// A squared distance with the voxel that it leads to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// The squared distance; infinite without a feature.
    pub level: f64,
    /// Index of the nearest voxel of a feature; `u32::MAX` without one.
    pub feature: u32,
}

impl Seed for Near {
    const NONE: Self = Self { level: f64::INFINITY, feature: u32::MAX };

    fn feature(index: u32) -> Self {
        Self { level: 0.0, feature: index }
    }

    fn level(self) -> f64 {
        self.level
    }

    fn at(self, level: f64) -> Self {
        Self { level, ..self }
    }
}
