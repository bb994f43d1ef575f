// The course without a network: a service worker answers from a cache, and the page fills it, since
// the worker misses what was loaded before it was there.

const root = new URL("../", import.meta.url);

/// Keeps all files of the course, once the compiler was asked for.
export async function keep_offline(manifest) {
  if (!("serviceWorker" in navigator)) return;
  try {
    await navigator.serviceWorker.register(new URL("offline_worker.js", root));
    const cache = await caches.open(manifest.cache);
    const there = new Set((await cache.keys()).map(request => request.url));
    const wanted = manifest.files.map(name => new URL(name, root).href)
      .filter(url => !there.has(url));
    for (let k = 0; k < wanted.length; k += 20) await cache.addAll(wanted.slice(k, k + 20));
    for (const name of await caches.keys())
      if (name !== manifest.cache && name.startsWith("joint-workbook-")) await caches.delete(name);
    document.documentElement.dataset.offline = "ready";
  } catch (error) {
    document.documentElement.dataset.offline = `not kept: ${error}`;
    console.warn("The course cannot be kept for use without a network:", error.message);
  }
}
