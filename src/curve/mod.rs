//! Closed B-spline curves: basis, evaluation, arc length, sampling, checks.
