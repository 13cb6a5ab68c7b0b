/**
 * The kernel on the main thread, in short turns: for pages that may not start a worker.
 *
 * @import { Kernel } from "./kernel.js"
 */
import { fromModule } from "../errors.js";
import { load } from "../index.js";
import { inTurns } from "../turns.js";

/**
 * Answers one call at a time, as its only user asks.
 *
 * @param {"figure" | "full"} module
 * @returns {Promise<Kernel>}
 */
export async function mainThread(module) {
  const dx = await load({ module });
  return {
    runsIn: "main thread",
    async call(name, args, { signal, onprogress, onsolved } = {}) {
      signal?.throwIfAborted();
      const host = { isWanted: () => !signal?.aborted, onprogress: onprogress ?? (() => {}) };
      const found = await inTurns(dx, { name, args }, host).catch((error) => {
        throw fromModule(error);
      });
      if (!found) throw signal?.reason;
      onsolved?.(found.spent);
      return found.value;
    },
    close() {},
  };
}
