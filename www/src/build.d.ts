/** The version in package.json, written in by Vite. */
declare const __DIRECTRIX_VERSION__: string;
