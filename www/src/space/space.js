/**
 * A picture in three dimensions: renderer, camera and the drawing on demand. It draws when it is asked to and never by itself.
 *
 * @import { Object3D } from "three"
 * @import { Camera, Frame } from "./camera.js"
 * @import { Vector } from "./vector.js"
 *
 * @typedef {object} SpaceOptions
 * @property {HTMLCanvasElement} canvas
 * @property {() => void} [ondraw] called before each picture
 * @property {(isLost: boolean) => void} [oncontext] the graphics context was lost, or is back
 */
import { Matrix4, PerspectiveCamera, Scene, WebGLRenderer } from "three";
import { axesOf, eyeOf, FIELD, unitsPerPixel } from "./camera.js";
import { diagonalOf, middleOf, subtract } from "./vector.js";

/** Device pixels for one of the screen at most: more are not seen in a moving picture. */
const SHARPEST = 2;
/** Milliseconds of a frame above which a drag is drawn with fewer pixels until it rests, slow frames before that, and its share of pixels each way. */
const SLOW = 60;
const PATIENCE = 2;
const COARSE = 0.5;

/** What a browser without WebGL 2 cannot do. */
export class NoWebGl extends Error {
  name = "NoWebGl";
}

/** @type {Camera} */
const ANY = { target: [0, 0, 0], azimuth: 0, elevation: 0, distance: 1 };

export class Space {
  #renderer;
  #scene = new Scene();
  #camera = new PerspectiveCamera(FIELD);
  #canvas;
  #listeners = new AbortController();
  #frame = 0;
  #isLost = false;
  #isDragged = false;
  #slowFrames = 0;
  /** Device pixels for one of the screen at rest. */
  #fullRatio = 1;
  /** The box that has to lie between the planes that bound what is drawn. @type {{min: Vector, max: Vector}} */
  #bounds = { min: [-1, -1, -1], max: [1, 1, 1] };

  /** @type {Camera} */
  camera = ANY;
  /** @type {Frame} */
  frame = { size: { width: 1, height: 1 }, top: 0, bottom: 0 };

  /**
   * @param {SpaceOptions} options
   * @throws {NoWebGl}
   */
  constructor({ canvas, ondraw = () => {}, oncontext = () => {} }) {
    // The renderer would write to the console what this can tell the person.
    const context = canvas.getContext("webgl2", { alpha: true, antialias: true, stencil: true, premultipliedAlpha: true });
    if (!context || context.isContextLost()) throw new NoWebGl("this browser has no WebGL 2");
    this.#canvas = canvas;
    this.ondraw = ondraw;
    this.#renderer = new WebGLRenderer({ canvas, context });
    this.#renderer.localClippingEnabled = true;
    this.#renderer.setClearColor(0x000000, 0);
    this.#camera.matrixAutoUpdate = false;
    const { signal } = this.#listeners;
    const lost = (/** @type {boolean} */ isLost) => {
      this.#isLost = isLost;
      oncontext(isLost);
      this.request();
    };
    canvas.addEventListener("webglcontextlost", () => lost(true), { signal });
    canvas.addEventListener("webglcontextrestored", () => lost(false), { signal });
  }

  /** @param {...Object3D} objects */
  add(...objects) {
    this.#scene.add(...objects);
  }

  /** @param {{min: Vector, max: Vector}} bounds of all that is drawn */
  holds(bounds) {
    this.#bounds = bounds;
  }

  /** The size of what is drawn, in device pixels; smaller than asked for where the graphics card has no room. */
  get drawn() {
    const { drawingBufferWidth: width, drawingBufferHeight: height } = this.#renderer.getContext();
    return { width, height };
  }

  /** The device pixels for one of the screen. */
  get pixelRatio() {
    return this.#renderer.getPixelRatio();
  }

  /** The same while nothing is dragged. */
  get fullRatio() {
    return this.#fullRatio;
  }

  /**
   * Makes the picture as large as its frame.
   * @param {Frame} frame
   * @param {number} [pixelRatio]
   */
  resize(frame, pixelRatio = Math.min(SHARPEST, window.devicePixelRatio || 1)) {
    this.frame = frame;
    this.#fullRatio = pixelRatio;
    this.#renderer.setPixelRatio(pixelRatio);
    this.#renderer.setSize(frame.size.width, frame.size.height, false);
    this.draw();
  }

  /** Draws before the next frame of the screen, however often it is asked to. */
  request() {
    if (this.#frame === 0) {
      this.#frame = requestAnimationFrame(() => this.draw());
    }
  }

  /** A drag goes on: until it rests, the picture may be coarser where it comes too slowly. */
  drag() {
    this.#isDragged = true;
    this.request();
  }

  rest() {
    this.#isDragged = false;
    this.#slowFrames = 0;
    if (this.pixelRatio === this.#fullRatio) return;
    this.#renderer.setPixelRatio(this.#fullRatio);
    this.draw();
  }

  /** Sees how long the screen takes for a picture. */
  #time() {
    const started = performance.now();
    requestAnimationFrame((now) => {
      if (!this.#isDragged || this.#isLost) return;
      this.#slowFrames = now - started > SLOW ? this.#slowFrames + 1 : 0;
      if (this.#slowFrames < PATIENCE || this.pixelRatio < this.#fullRatio) return;
      // Another size empties the picture, so it is drawn at once.
      this.#renderer.setPixelRatio(this.#fullRatio * COARSE);
      this.draw();
    });
  }

  draw() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    if (this.#isLost) return;
    if (this.#isDragged) this.#time();
    this.#place();
    this.ondraw();
    // What is drawn may reach farther now.
    this.#place();
    this.#renderer.render(this.#scene, this.#camera);
    this.#report();
  }

  /** What the picture costs the graphics card, where tests and benches read it. */
  #report() {
    const { calls, triangles } = this.#renderer.info.render;
    const cost = { calls: String(calls), triangles: String(triangles) };
    for (const name of /** @type {const} */ (["calls", "triangles"])) {
      if (this.#canvas.dataset[name] !== cost[name]) this.#canvas.dataset[name] = cost[name];
    }
  }

  #place() {
    const { size, top, bottom } = this.frame;
    const { right, up, back } = axesOf(this.camera);
    const eye = eyeOf(this.camera);
    const camera = this.#camera;
    const away = Math.hypot(...subtract(eye, middleOf(this.#bounds)));
    const half = diagonalOf(this.#bounds) / 2;
    camera.far = away + half * 1.01;
    camera.near = Math.max(away - half * 1.01, camera.far * 1e-4);
    camera.aspect = size.width / size.height;
    if (top === bottom) camera.clearViewOffset();
    else camera.setViewOffset(size.width, size.height, 0, (bottom - top) / 2, size.width, size.height);
    camera.updateProjectionMatrix();
    camera.matrix.copy(new Matrix4().set(right[0], up[0], back[0], eye[0], right[1], up[1], back[1], eye[1], right[2], up[2], back[2], eye[2], 0, 0, 0, 1));
    camera.matrixWorldNeedsUpdate = true;
    const { near, far } = camera;
    this.pixelDepth = ((2 * near * far) / (far - near)) * (unitsPerPixel(this.camera, this.frame) / this.camera.distance);
  }

  /** How much less the third coordinate of a vertex is, before it is divided by the fourth, when it comes nearer by one CSS pixel. */
  pixelDepth = 0;

  /** Gives the graphics context back: browsers allow few of them at a time. */
  close() {
    cancelAnimationFrame(this.#frame);
    this.#isLost = true;
    this.#listeners.abort();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
    this.#canvas.width = 0;
    this.#canvas.height = 0;
  }
}
