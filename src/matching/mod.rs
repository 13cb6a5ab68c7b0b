//! Matching of two closed curves by ruling lines.
