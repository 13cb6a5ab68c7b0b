//! Planar B-spline curves, from the outside: values, lengths, nearest points, meetings, refusals, random curves.

mod adaptive;
mod lengths;
mod meetings;
mod nearest;
mod random;
mod refusals;
mod support;
mod values;
