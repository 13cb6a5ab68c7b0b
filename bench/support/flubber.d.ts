/** What the comparison takes from the package `flubber`, which comes without types. */
declare const flubber: {
  /** The ring between two rings of points at a time from 0 to 1. */
  interpolate(
    from: [number, number][],
    to: [number, number][],
    options: { string: false; maxSegmentLength: number },
  ): (time: number) => [number, number][];
};
export default flubber;
