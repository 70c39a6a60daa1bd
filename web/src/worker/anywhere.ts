/** Starts a worker whose file may lie elsewhere than the page: of another origin browsers start none, but modules that are imported may be of any. */

export function startAnywhere(address: URL): Worker {
  if (address.origin === globalThis.origin) return new Worker(address, { type: "module" });
  const bootstrap = URL.createObjectURL(
    new Blob([`import ${JSON.stringify(address.href)};`], { type: "text/javascript" }),
  );
  const worker = new Worker(bootstrap, { type: "module" });
  // The browser has read it by the time that the worker says anything, and reads it only once.
  const forget = () => URL.revokeObjectURL(bootstrap);
  worker.addEventListener("message", forget, { once: true });
  worker.addEventListener("error", forget, { once: true });
  return worker;
}
