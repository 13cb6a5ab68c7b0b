/**
 * A worker of the page's own origin that imports a module from another: what a browser allows where it refuses a worker from there.
 */
export class BlobWorker extends Worker {
  /**
   * @param {string | URL} address
   * @param {WorkerOptions} [options]
   */
  constructor(address, options) {
    const source = new Blob([`import ${JSON.stringify(String(address))};`], { type: "text/javascript" });
    const own = URL.createObjectURL(source);
    super(own, options);
    const release = () => URL.revokeObjectURL(own);
    this.addEventListener("message", release, { once: true });
    this.addEventListener("error", release, { once: true });
  }
}
