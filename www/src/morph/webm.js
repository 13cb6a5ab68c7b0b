/**
 * A WebM file of encoded frames.
 *
 * References: RFC 8794 (EBML), RFC 9559 (Matroska), and the WebM container guidelines.
 *
 * @typedef {object} Chunk One encoded frame.
 * @property {number} time milliseconds
 * @property {boolean} isKey
 * @property {Uint8Array} data
 *
 * @typedef {object} Track
 * @property {"V_VP8" | "V_VP9"} codec
 * @property {number} width
 * @property {number} height
 * @property {number} rate frames a second
 * @property {number} seconds
 * @property {VideoColorSpaceInit | undefined} color as the encoder names it
 */

/** Names of elements. */
const ID = {
  ebml: 0x1a45dfa3, version: 0x4286, readVersion: 0x42f7, idLength: 0x42f2, sizeLength: 0x42f3,
  docType: 0x4282, docVersion: 0x4287, docReadVersion: 0x4285,
  segment: 0x18538067, info: 0x1549a966, timeScale: 0x2ad7b1, duration: 0x4489, muxer: 0x4d80, writer: 0x5741,
  tracks: 0x1654ae6b, track: 0xae, number: 0xd7, uid: 0x73c5, type: 0x83, lacing: 0x9c, codec: 0x86, frameDuration: 0x23e383,
  video: 0xe0, width: 0xb0, height: 0xba, color: 0x55b0, matrix: 0x55b1, range: 0x55b9, transfer: 0x55ba, primaries: 0x55bb,
  cluster: 0x1f43b675, time: 0xe7, block: 0xa3,
  cues: 0x1c53bb6b, cue: 0xbb, cueTime: 0xb3, cuePlace: 0xb7, cueTrack: 0xf7, cueCluster: 0xf1,
};

/** Numbers of colour spaces (ITU-T H.273). @type {Record<string, number>} */
const COLORS = { rgb: 0, bt709: 1, bt470bg: 5, smpte170m: 6, "iec61966-2-1": 13, "bt2020-ncl": 9, bt2020: 9 };

/**
 * @param {Track} track
 * @param {Chunk[]} chunks in the order of their times; the first is a key frame
 * @returns {Blob}
 */
export function webm({ codec, width, height, rate, seconds, color }, chunks) {
  const head = element(ID.ebml, [
    element(ID.version, uint(1)),
    element(ID.readVersion, uint(1)),
    element(ID.idLength, uint(4)),
    element(ID.sizeLength, uint(8)),
    element(ID.docType, text("webm")),
    element(ID.docVersion, uint(4)),
    element(ID.docReadVersion, uint(2)),
  ]);
  const info = element(ID.info, [
    element(ID.timeScale, uint(1_000_000)),
    element(ID.duration, float(seconds * 1000)),
    element(ID.muxer, text("Directrix")),
    element(ID.writer, text("Directrix")),
  ]);
  const tracks = element(ID.tracks, [
    element(ID.track, [
      element(ID.number, uint(1)),
      element(ID.uid, uint(1)),
      element(ID.type, uint(1)),
      element(ID.lacing, uint(0)),
      element(ID.codec, text(codec)),
      element(ID.frameDuration, uint(Math.round(1e9 / rate))),
      element(ID.video, [element(ID.width, uint(width)), element(ID.height, uint(height)), ...colors(color)]),
    ]),
  ]);
  const starts = chunks.flatMap(({ isKey }, i) => (isKey ? [i] : []));
  const clusters = starts.map((start, k) => cluster(chunks.slice(start, starts[k + 1])));
  const cues = (/** @type {number} */ before) => {
    let place = before;
    return element(ID.cues, starts.map((start, k) => {
      const cue = element(ID.cue, [
        element(ID.cueTime, uint(chunks[start]?.time ?? 0)),
        element(ID.cuePlace, [element(ID.cueTrack, uint(1)), element(ID.cueCluster, uint(place, 6))]),
      ]);
      place += length(clusters[k] ?? []);
      return cue;
    }));
  };
  // Places take the same room whatever they are, so that the list that comes before the clusters can be measured first.
  const before = length(info) + length(tracks) + length(cues(0));
  const body = [info, tracks, cues(before), ...clusters];
  return new Blob(flat([head, element(ID.segment, body)]), { type: "video/webm" });
}

/**
 * Bytes, in parts that are only joined at the end.
 * @typedef {Uint8Array | Bytes[]} Bytes
 */

/** @param {Chunk[]} chunks from one key frame up to the next */
function cluster(chunks) {
  const [{ time: start } = { time: 0 }] = chunks;
  return element(ID.cluster, [
    element(ID.time, uint(start)),
    ...chunks.map(({ time, isKey, data }) => {
      const after = time - start;
      return element(ID.block, [new Uint8Array([0x81, after >> 8, after & 255, isKey ? 0x80 : 0]), data]);
    }),
  ]);
}

/** @param {VideoColorSpaceInit | undefined} space */
function colors(space) {
  const { matrix, transfer, primaries, fullRange } = space ?? {};
  const known = [
    [ID.matrix, matrix],
    [ID.transfer, transfer],
    [ID.primaries, primaries],
  ].flatMap(([id, name]) => {
    const number = COLORS[String(name)];
    return number === undefined ? [] : [element(Number(id), uint(number))];
  });
  const range = typeof fullRange === "boolean" ? [element(ID.range, uint(fullRange ? 2 : 1))] : [];
  return known.length + range.length === 0 ? [] : [element(ID.color, [...known, ...range])];
}

/** @param {number} id @param {Bytes} content @returns {Bytes} */
function element(id, content) {
  return [uint(id), size(length(content)), content];
}

/** The length of an element as a number of eight bytes. @param {number} value */
function size(value) {
  const bytes = uint(value, 8);
  bytes[0] = 1;
  return bytes;
}

/** @param {number} value @param {number} [least] bytes */
function uint(value, least = 1) {
  const bytes = [];
  for (let rest = value; rest > 0 || bytes.length < least; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
  return new Uint8Array(bytes);
}

/** @param {number} value */
function float(value) {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return bytes;
}

/** @param {string} value */
const text = (value) => new TextEncoder().encode(value);

/** @param {Bytes} bytes @returns {number} */
function length(bytes) {
  return bytes instanceof Uint8Array ? bytes.length : bytes.reduce((sum, part) => sum + length(part), 0);
}

/** @param {Bytes} bytes @returns {Uint8Array<ArrayBuffer>[]} */
function flat(bytes) {
  return bytes instanceof Uint8Array ? [/** @type {Uint8Array<ArrayBuffer>} */ (bytes)] : bytes.flatMap(flat);
}
