//! The browser boundary: conversions only.
