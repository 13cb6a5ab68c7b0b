/** What sharing says: the panel Share, links that are opened, and addresses that a person is asked about. */

/** Names of the keys of a link. @type {{[key: string]: string}} */
const KEYS = {
  v: "Link",
  s: "Document",
  preset: "Preset",
  url: "Address",
  view: "View",
  step: "Step",
  controls: "Controls",
  theme: "Theme",
  reveal: "Start",
};

/** The length of a link in words. @param {number} length */
const size = (length) => (length < 1024 ? `${length} characters` : `${(length / 1024).toFixed(1).replace(/\.0$/, "")} kB`);

export const words = {
  heading: "Share",
  tabs: "What to share",
  editor: "Editor",
  view: "View only",
  embed: "Embed",
  about: {
    editor: "Opens this document in the editor, as a copy of the reader’s own.",
    view: "Opens the figure alone, to be looked at and not edited. It leads to the editor.",
    embed: "Puts the live figure into a page of yours.",
  },
  inBar: "It stands in the address bar as well.",
  label: { editor: "Link to the editor", view: "Link to the view only", embed: "Embed code" },
  controls: "Controls",
  allControls: { full: "Full", minimal: "Minimal", none: "None" },
  theme: "Theme",
  allThemes: { auto: "Auto", light: "Light", dark: "Dark" },
  start: "Starts",
  allStarts: { auto: "By itself", interaction: "On a click" },
  code: "Code",
  codes: { element: "Element", iframe: "Iframe" },
  size: "Size",
  sizes: { column: "Column", medium: "640 × 400", small: "400 × 300" },
  copy: "Copy",
  copied: "Copied",
  copiedAll: { editor: "Copied the link to the editor", view: "Copied the link to the view", embed: "Copied the embed code" },
  notCopied: "This browser did not let the page copy. The text is selected: copy it with the keyboard.",
  download: "Download JSON",
  downloaded: (/** @type {string} */ file) => `Downloaded ${file}`,
  failed: (/** @type {string} */ reason) => `It cannot be shared: ${reason}.`,
  whole: (/** @type {number} */ length) => `${size(length)}. The link holds the whole document; nothing is uploaded.`,
  short: (/** @type {number} */ length, /** @type {string} */ title) => `${size(length)}. The link names the preset ${title}.`,
  mode: {
    figure: "",
    steps: (/** @type {number} */ step) => (step > 0 ? `It opens at step ${step}.` : "It opens the steps."),
    compare: "It opens the comparison.",
    solid: "It opens the solid in three dimensions.",
  },
  tooLong: (/** @type {number} */ length, /** @type {number} */ most) =>
    `This document would make a link of ${size(length)}, and mail and chat programs cut links above ${size(most)}. Share the file instead:`,
  host: [
    "Download the document.",
    "Put it on a web server that lets other pages read it (Access-Control-Allow-Origin: *).",
    "Share this link, with the address of the file in it:",
  ],
  place: (/** @type {string} */ file) => `The document stands in ${file}: put that file beside your page.`,
  figure: "Figure",

  opened: (/** @type {string} */ title) => `${title} opened from a link, as an unsaved copy`,
  problem: {
    heading: "The link was not opened",
    about: "What was open before stays as it is.",
    reason: (/** @type {string} */ key, /** @type {string} */ message) => `${KEYS[key] ? `${KEYS[key]}: ` : ""}${message}.`,
    inDocument: (/** @type {string} */ path, /** @type {string} */ message) => `Document: ${path ? `${path}: ` : ""}${message}.`,
    noPreset: (/** @type {string} */ name) => `"${name}" was found, and there is no preset of this name; the gallery has all there are`,
  },
  ask: {
    heading: "Open from another place?",
    about: (/** @type {string} */ host) => `The link leads to a document on ${host}. Nothing has been fetched yet; if you agree, ${host} learns that you ask for it.`,
    address: "Address of the document",
    agree: "Fetch and open",
    again: "Try again",
    decline: "Leave it",
    fetching: "Fetching",
    offline: "This machine is offline. The document can be fetched once it has a connection.",
    status: (/** @type {number} */ status, /** @type {string} */ host) =>
      status === 404 ? `${host} has no file at this address (404).` : `${host} answered with the status ${status} in place of a document.`,
    refused: (/** @type {string} */ host) =>
      `${host} answers, but does not let other pages read this file (CORS): it has to send Access-Control-Allow-Origin. Download the file and open it here instead.`,
    unreachable: (/** @type {string} */ host) => `${host} cannot be reached.`,
    insecure: "A page on https may not fetch from an address on http.",
    late: (/** @type {number} */ seconds) => `It took more than ${seconds} seconds and was given up.`,
    large: "The file is larger than 4 MiB, the most that is fetched.",
    notText: "The file is no text in UTF-8.",
    notJson: "The file is no JSON.",
    notDocument: "The file is no document of Directrix: it has no field directrix.",
    opened: (/** @type {string} */ title, /** @type {string} */ host) => `${title} opened from ${host}, as an unsaved copy`,
  },
  showControls: "Show controls",
};
