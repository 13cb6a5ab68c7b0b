/** Where things are: absolute paths of the checkout and of what is built. */
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";

/** The checkout. */
export const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");

/** Cargo's folder for what it builds. */
export const target = resolve(root, process.env.CARGO_TARGET_DIR || "target");

/** The generated bindings and the modules beside them. */
export const pkg = resolve(root, "js/pkg");

/** The built page. */
export const dist = resolve(root, "dist");

/** The built documentation. */
export const documentationSite = resolve(root, "dist-docs");

/** What the scripts remember between two runs, and their half-made files. */
export const work = resolve(root, ".build");
