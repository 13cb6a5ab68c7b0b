//! What a matching carries: ruled band, in-between curves, unit cells, composition.
