// A pack: many files in one, packed by xz. It begins with the length of its index and the index, a
// JSON list of [path, size]; then the files follow.
"use strict";

/// The bytes of a packed stream; told(bytes so far) as they come.
async function unpacked(stream, told = () => {}) {
  let count = 0;
  const counted = stream.pipeThrough(new TransformStream({
    transform(part, out) {
      told(count += part.length);
      out.enqueue(part);
    }}));
  const {XzReadableStream} = self["xz-decompress"];
  return new Uint8Array(await new Response(new XzReadableStream(counted)).arrayBuffer());
}

/// Adds the files of a pack to others.
function add_pack(files, bytes) {
  const size = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  let place = 4 + size;
  for (const [path, length] of JSON.parse(new TextDecoder().decode(bytes.subarray(4, place)))) {
    files.add(path, bytes.subarray(place, place + length));
    place += length;
  }
}

if (typeof module !== "undefined") module.exports = {unpacked, add_pack};
