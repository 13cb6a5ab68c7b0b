/** What the bench takes from the package `nurbs`, which comes without types: a spline of any dimension. */
declare const nurbs: (options: { points: any[]; degree: number[]; boundary: string[] }) => {
  domain: [number, number][];
  evaluate(out: number[], ...parameters: number[]): number[];
};
export default nurbs;
