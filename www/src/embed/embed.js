/**
 * A figure that fills its window, for an iframe: what it shows stands in the hash, and the page around it talks with it by messages.
 *
 * @import { DirectrixFigure } from "../../../js/element.js"
 * @import { Wish } from "./protocol.js"
 */
import "../../../js/element.js";
import { readLink } from "../../../js/link.js";
import { readMessage, VERSION } from "./protocol.js";
import { words } from "./words.js";

/** Height over width that suits a figure, and a narrow one. */
const SHAPE = 10 / 16;
const NARROW = 480;
const NARROW_SHAPE = 1;

const place = /** @type {HTMLElement} */ (document.querySelector("#place"));
const heading = /** @type {HTMLElement} */ (document.querySelector("#title"));
const figure = document.createElement("directrix-figure");

/** Attributes that a link sets. */
const ATTRIBUTES = /** @type {const} */ (["view", "step", "controls", "theme", "reveal"]);

function start() {
  figure.addEventListener("load", () => {
    const title = figure.document?.title;
    if (title) heading.textContent = title;
    document.title = words.title(heading.textContent ?? "");
    tellState();
  });
  figure.addEventListener("change", tellLater);
  figure.addEventListener("error", (event) => tell("error", /** @type {CustomEvent} */ (/** @type {Event} */ (event)).detail));
  addEventListener("message", (event) => {
    if (event.source !== parent || parent === window) return;
    receive(event.data);
  });
  addEventListener("hashchange", open);
  addEventListener("resize", tellSize);
  open();
  tell("ready", {});
  tellSize();
}

/** Shows what the hash says. */
function open() {
  try {
    const { document: given, preset, url, ...rest } = readLink(location.hash);
    for (const name of ATTRIBUTES) {
      const value = rest[name];
      if (value === undefined) figure.removeAttribute(name);
      else figure.setAttribute(name, String(value));
    }
    dress();
    if (given) {
      figure.document = given;
      put(figure);
    } else if (preset !== undefined) {
      show(preset);
      put(figure);
    } else if (url !== undefined) {
      ask(url);
    } else {
      // The page around may send one.
      put(parent === window ? note(words.empty) : figure);
    }
  } catch (error) {
    const { code = "failed", path = "", message = String(error) } = /** @type {any} */ (error);
    put(note(words.refused, path ? `${path}: ${message}` : message));
    tell("error", { code, path, message });
  }
}

/** An address is not asked for before a person says so. @param {string} address */
function ask(address) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = words.load;
  button.addEventListener("click", () => {
    figure.setAttribute("src", address);
    put(figure);
  });
  const text = document.createElement("p");
  text.textContent = words.ask(address);
  const box = document.createElement("div");
  box.className = "asked";
  box.append(text, button);
  put(box);
}

/** Puts an element where the figure is; one that is there stays as it is. @param {Element} element */
function put(element) {
  if (element.parentNode !== place) place.replaceChildren(element);
}

/** @param {string} preset */
function show(preset) {
  for (const name of ["src", "preset"]) figure.removeAttribute(name);
  figure.setAttribute("preset", preset);
}

/** @param {...string} texts */
function note(...texts) {
  const box = document.createElement("div");
  box.className = "refused";
  box.append(
    ...texts.map((text) => {
      const line = document.createElement("p");
      line.textContent = text;
      return line;
    }),
  );
  return box;
}

/** The window has the scheme of its figure. */
function dress() {
  const theme = figure.getAttribute("theme") ?? "auto";
  document.documentElement.dataset.theme = theme;
}

/** @param {unknown} data */
function receive(data) {
  const read = readMessage(data);
  if (read && "error" in read) tell("error", read.error);
  else if (read) fulfil(read.wish);
}

/** @param {Wish} wish */
function fulfil({ document: given, preset, s, playing, ...attributes }) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined) figure.setAttribute(name, value);
  }
  dress();
  if (preset !== undefined) show(preset);
  if (given !== undefined) figure.document = given;
  if (preset !== undefined || given !== undefined) put(figure);
  const then = () => {
    if (s !== undefined) figure.s = s;
    if (playing !== undefined) playing ? figure.play() : figure.pause();
  };
  if (preset === undefined && given === undefined) then();
  else if (s !== undefined || playing !== undefined) figure.addEventListener("load", then, { once: true });
}

let frame = 0;

/** Tells the state once a frame. */
function tellLater() {
  if (frame === 0) frame = requestAnimationFrame(tellState);
}

function tellState() {
  cancelAnimationFrame(frame);
  frame = 0;
  const { document, s, result, runsIn } = /** @type {DirectrixFigure} */ (figure);
  tell("state", { document, s, result, runsIn });
}

/** The size, and the height that would suit the figure at this width. */
function tellSize() {
  const { innerWidth: width, innerHeight: height } = window;
  tell("resize", { width, height, suits: Math.round(width * (width < NARROW ? NARROW_SHAPE : SHAPE)) });
}

/**
 * Tells the page around. It may be any page, and what it is told is what it shows.
 *
 * @param {string} type
 * @param {object} content
 */
function tell(type, content) {
  if (parent !== window) parent.postMessage({ type: `directrix:${type}`, v: VERSION, ...content }, "*");
}

start();
