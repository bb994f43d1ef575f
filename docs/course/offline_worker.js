// Answers from the network, or from what the page has kept of the course (offline.js).
"use strict";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", event => event.waitUntil(self.clients.claim()));
self.addEventListener("fetch", event => {
  const {request} = event;
  if (request.method !== "GET" || new URL(request.url).origin !== location.origin) return;
  // What is large and known by its version comes from the cache; a page is asked for anew.
  const packed = /\.xz$/.test(new URL(request.url).pathname);
  const kept = () => caches.match(request, {ignoreSearch: true});
  event.respondWith(packed ? kept().then(found => found || fetch(request))
    : fetch(request).catch(() => kept().then(found => found || Response.error())));
});
