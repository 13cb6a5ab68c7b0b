/**
 * Which tab works on which document: a tab holds the lock of a document for as long as it is open there.
 *
 * @typedef {object} Claim
 * @property {boolean} free whether no other tab works on the document
 * @property {boolean} locked whether no other tab can from now on; false where the browser has no locks
 * @property {() => void} release
 */

const PREFIX = "directrix-document-";

/**
 * Claims a document for this tab.
 * @param {string} id
 * @param {number} patience milliseconds to wait for a tab that is just closing; 0 does not wait
 * @returns {Promise<Claim>}
 */
export async function claim(id, patience) {
  /** @type {Claim} */
  const unlocked = { free: true, locked: false, release: () => {} };
  if (!navigator.locks) return unlocked;
  const waiting = new AbortController();
  const timer = setTimeout(() => waiting.abort(), patience);
  const how = patience > 0 ? { signal: waiting.signal } : { ifAvailable: true };
  try {
    return await new Promise((resolve, reject) => {
      const held = navigator.locks.request(`${PREFIX}${id}`, how, (lock) => {
        clearTimeout(timer);
        if (lock === null) return resolve({ ...unlocked, free: false });
        return new Promise((release) => resolve({ free: true, locked: true, release: () => release(undefined) }));
      });
      held.catch(reject);
    });
  } catch (error) {
    // Anything else than the end of the wait means that there are no locks here; what is stored then tells.
    return { ...unlocked, free: !waiting.signal.aborted || !(error instanceof Error && error.name === "AbortError") };
  }
}

/** The documents that some tab has open. @returns {Promise<Set<string>>} */
export async function claimed() {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  const names = held.map(({ name = "" }) => name);
  return new Set(names.filter((name) => name.startsWith(PREFIX)).map((name) => name.slice(PREFIX.length)));
}
