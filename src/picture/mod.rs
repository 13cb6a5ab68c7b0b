//! Pictures: a display list, painted on pixels or written as SVG.
