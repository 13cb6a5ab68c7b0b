/**
 * The morph as a WebM film. Frames are encoded one by one with times of their own, so that a film does not depend on how fast the
 * machine is.
 *
 * @import { App } from "../state/app.js"
 * @import { Size } from "../types.js"
 * @import { Sequence, Working } from "./frames.js"
 * @import { Chunk } from "./webm.js"
 */
import { imageData } from "../kernel.js";
import { painted } from "./frames.js";
import { round } from "./motion.js";
import { webm } from "./webm.js";
import { words } from "./words.js";

/** Most frames of a film, and most frames a second. */
const MOST_FILM_FRAMES = 1800;
export const RATES = /** @type {const} */ (["12", "24", "30", "60"]);
/** Longest side of a film in pixels. */
export const LARGEST_FILM = 1920;
/** Frames from one key frame to the next. */
const KEY = 48;
/** Frames that wait for the encoder at most. */
const QUEUE = 4;
/** Bits for each pixel of each frame: flat areas and sharp lines need few. */
const BITS = 0.15;

/** Encoders in the order in which they are tried. */
const CODECS = /** @type {const} */ ([
  ["vp09.00.41.08", "V_VP9"],
  ["vp8", "V_VP8"],
]);

/**
 * The encoder that this browser has for WebM, or null.
 * @param {Size} size
 * @param {number} rate
 */
export async function encoderFor({ width, height }, rate) {
  if (typeof VideoEncoder === "undefined") return null;
  for (const [codec, name] of CODECS) {
    const config = { codec, width, height, framerate: rate, bitrate: Math.ceil(BITS * width * height * rate) + 200_000 };
    const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
    if (supported) return { name, config };
  }
  return null;
}

/**
 * @param {App} app
 * @param {Omit<Sequence, "count" | "transparent"> & {rate: number}} wanted
 * @param {Working} working
 * @returns {Promise<Blob>}
 */
export async function film(app, { rate, ...wanted }, working) {
  const count = Math.max(2, Math.round(round(wanted.motion) * rate));
  if (count > MOST_FILM_FRAMES) throw new RangeError(words.tooLong(count, MOST_FILM_FRAMES));
  // Colour is encoded for blocks of two by two pixels.
  const [width, height] = [wanted.width, wanted.height].map((side) => Math.max(2, side - (side % 2)));
  const found = await encoderFor({ width, height }, rate);
  if (!found) throw new Error(words.noVideo);
  /** @type {Chunk[]} */
  const chunks = [];
  /** @type {VideoColorSpaceInit | undefined} */
  let color;
  /** @type {unknown} */
  let failure = null;
  const encoder = new VideoEncoder({
    output(chunk, metadata) {
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      chunks.push({ time: Math.round(chunk.timestamp / 1000), isKey: chunk.type === "key", data });
      color ??= metadata?.decoderConfig?.colorSpace ?? undefined;
    },
    error: (error) => {
      failure = error;
    },
  });
  try {
    encoder.configure(found.config);
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d");
    const sequence = { ...wanted, width, height, transparent: false, count };
    let number = 0;
    for await (const picture of painted(app, sequence, working)) {
      if (failure) throw failure;
      context?.putImageData(imageData(picture), 0, 0);
      const [timestamp, next] = [number, number + 1].map((frame) => Math.round((frame * 1e6) / rate));
      const frame = new VideoFrame(canvas, { timestamp, duration: next - timestamp });
      encoder.encode(frame, { keyFrame: number % KEY === 0 });
      frame.close();
      number += 1;
      while (encoder.encodeQueueSize > QUEUE && !failure) await new Promise((done) => setTimeout(done, 5));
    }
    await encoder.flush();
    if (failure) throw failure;
  } finally {
    if (encoder.state !== "closed") encoder.close();
  }
  return webm({ codec: found.name, width, height, rate, seconds: count / rate, color }, chunks);
}
