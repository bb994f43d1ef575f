// The course without a network: a service worker answers from a cache. The page fills it, since the
// worker misses what was loaded before it was there; and before it asks for the worker: in Firefox,
// filling through a worker that has just begun, an answer now and then never comes.

const root = new URL("../", import.meta.url);
const PATIENCE = [30, 120, 600];  // with a handful of files, before they are asked for again [s]

async function fetch_into(cache, addresses) {
  for (const limit of PATIENCE) {
    const signal = AbortSignal.timeout(1000 * limit);
    try {
      return await cache.addAll(addresses.map(address => new Request(address, {signal})));
    } catch (error) {
      if (!signal.aborted || limit === PATIENCE.at(-1)) throw error;  // no room, or not there
    }
  }
}

/// Keeps all files of the course, once the compiler was asked for.
export async function keep_offline(manifest) {
  if (!("serviceWorker" in navigator)) return;
  try {
    const cache = await caches.open(manifest.cache);
    const there = new Set((await cache.keys()).map(request => request.url));
    const wanted = manifest.files.map(name => new URL(name, root).href)
      .filter(url => !there.has(url));
    for (let k = 0; k < wanted.length; k += 20)
      await fetch_into(cache, wanted.slice(k, k + 20));
    await navigator.serviceWorker.register(new URL("offline_worker.js", root));
    await navigator.serviceWorker.ready;  // from now on it is asked, at the next reload, too
    for (const name of await caches.keys())
      if (name !== manifest.cache && name.startsWith("joint-workbook-")) await caches.delete(name);
    document.documentElement.dataset.offline = "ready";
  } catch (error) {
    document.documentElement.dataset.offline = `not kept: ${error}`;
    console.warn("The course cannot be kept for use without a network:", error.message);
  }
}
