//! Materials, compositions (points of the simplex) and the mixing of colours.
