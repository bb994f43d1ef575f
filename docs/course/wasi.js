// A small operating system for programs in WebAssembly, in the page's workers and in node: files in
// memory, arguments, and what a program prints. Only what compiler, linker and tests call.
"use strict";

const ERRNO = {badf: 8, exist: 20, inval: 28, isdir: 31, noent: 44, notsup: 58};
const DIRECTORY = 3, REGULAR = 4, TERMINAL = 2, ROOT = 3;  // kinds of files; the open root folder

/// How a program ends that calls exit().
class Exit extends Error {
  constructor(status) {
    super(`exit ${status}`);
    this.status = status;
  }
}

/// "/a/./b/../c" as "a/c": a folder's name begins and ends without a slash.
function plain(path) {
  const parts = [];
  for (const part of path.split("/"))
    if (part === "..") parts.pop();
    else if (part && part !== ".") parts.push(part);
  return parts.join("/");
}

/// Files by their paths. A file of given bytes is not copied until somebody writes to it.
class Files {
  constructor() {
    this.nodes = new Map([["", {number: 1, folder: true}]]);
    this.next = 2;
  }
  add(path, bytes, given = true) {
    path = plain(path);
    for (let end = path.indexOf("/"); end >= 0; end = path.indexOf("/", end + 1)) {
      const folder = path.slice(0, end);
      if (!this.nodes.has(folder)) this.nodes.set(folder, {number: this.next++, folder: true});
    }
    const node = {number: this.next++, bytes, size: bytes.length, given};
    this.nodes.set(path, node);
    return node;
  }
  node(path) { return this.nodes.get(plain(path)); }
  bytes(path) {
    const node = this.node(path);
    return node?.bytes?.subarray(0, node.size);
  }
  remove(path) { return this.nodes.delete(plain(path)); }
  rename(from, to) {
    const node = this.node(from);
    this.remove(from);
    this.nodes.set(plain(to), node);
  }
}

function write_at(node, place, bytes) {
  const end = place + bytes.length;
  if (node.given || end > node.bytes.length) {
    const more = new Uint8Array(Math.max(end, node.size, 2 * node.size));
    more.set(node.bytes.subarray(0, node.size));
    node.bytes = more;
    node.given = false;
  }
  node.bytes.set(bytes, place);
  node.size = Math.max(node.size, end);
}

/// The functions of wasi_snapshot_preview1 for one run of one program.
/// \param print called with (1 or 2, bytes)
/// \param memory a function that returns the program's memory
/// \param variables of the environment, such as "A=1"
function wasi(files, args, print, memory, variables = []) {
  const open = [{kind: TERMINAL}, {kind: TERMINAL}, {kind: TERMINAL}, {path: "", kind: DIRECTORY}];
  const view = () => new DataView(memory().buffer);
  const part = (from, size) => new Uint8Array(memory().buffer, from, size);
  const text = (from, size) => new TextDecoder().decode(part(from, size).slice());
  const path_at = (fd, from, size) => plain(`${open[fd].path}/${text(from, size)}`);
  function stat(node, to) {
    part(to, 64).fill(0);
    const at = view();
    at.setBigUint64(to + 8, BigInt(node.number || 0), true);
    at.setUint8(to + 16, node.folder ? DIRECTORY : REGULAR);
    at.setBigUint64(to + 24, 1n, true);
    at.setBigUint64(to + 32, BigInt(node.size || 0), true);
    return 0;
  }
  // Calls each(part of the program's memory) for a list of them; each returns how much it used.
  function vectors(list, count, out, each) {
    let sum = 0;
    for (let k = 0; k < count; ++k) {
      const from = view().getUint32(list + 8 * k, true);
      const size = view().getUint32(list + 8 * k + 4, true);
      const used = each(part(from, size), sum);
      sum += used;
      if (used < size) break;
    }
    view().setUint32(out, sum, true);
    return 0;
  }
  function read(file, place, list, count, out) {
    return vectors(list, count, out, (to, sum) => {
      const left = file.node.size - place - sum, size = Math.max(0, Math.min(left, to.length));
      to.set(file.node.bytes.subarray(place + sum, place + sum + size));
      return size;
    });
  }
  // A list of texts: how many and how long, and themselves.
  function listed(texts) {
    const words = texts.map(one => new TextEncoder().encode(one + "\0"));
    return [(count, size) => {
      view().setUint32(count, words.length, true);
      view().setUint32(size, words.reduce((sum, word) => sum + word.length, 0), true);
      return 0;
    }, (pointers, buffer) => {
      words.forEach((word, k) => {
        view().setUint32(pointers + 4 * k, buffer, true);
        part(buffer, word.length).set(word);
        buffer += word.length;
      });
      return 0;
    }];
  }
  const [args_sizes_get, args_get] = listed(args);
  const [environ_sizes_get, environ_get] = listed(variables);
  const known = {
    args_sizes_get, args_get, environ_sizes_get, environ_get,
    clock_time_get(_, __, to) {
      view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    random_get(to, size) {
      part(to, size).fill(4);  // the same in every run
      return 0;
    },
    proc_exit(status) { throw new Exit(status); },
    fd_prestat_get(fd, to) {
      if (fd !== ROOT) return ERRNO.badf;
      view().setUint32(to, 0, true);
      view().setUint32(to + 4, 1, true);
      return 0;
    },
    fd_prestat_dir_name(fd, to) {
      part(to, 1)[0] = "/".charCodeAt(0);
      return 0;
    },
    fd_fdstat_get(fd, to) {
      if (!open[fd]) return ERRNO.badf;
      part(to, 24).fill(0);
      view().setUint8(to, open[fd].kind);
      view().setBigUint64(to + 8, (1n << 62n) - 1n, true);
      view().setBigUint64(to + 16, (1n << 62n) - 1n, true);
      return 0;
    },
    fd_filestat_get(fd, to) {
      if (!open[fd]) return ERRNO.badf;
      return stat(open[fd].node || files.node(open[fd].path || "") || {}, to);
    },
    fd_filestat_set_size(fd, size) {
      const {node} = open[fd];
      if (Number(size) > node.size) write_at(node, Number(size) - 1, new Uint8Array(1));
      node.size = Number(size);
      return 0;
    },
    fd_close(fd) {
      delete open[fd];
      return 0;
    },
    fd_seek(fd, offset, whence, to) {
      const file = open[fd];
      if (!file?.node) return ERRNO.badf;
      file.place = Number(offset) + [0, file.place, file.node.size][whence];
      view().setBigUint64(to, BigInt(file.place), true);
      return 0;
    },
    fd_read(fd, list, count, out) {
      const file = open[fd];
      if (file?.kind === TERMINAL) return vectors(list, 0, out, () => 0);
      if (!file?.node || file.node.folder) return ERRNO.badf;
      read(file, file.place, list, count, out);
      file.place += view().getUint32(out, true);
      return 0;
    },
    fd_pread(fd, list, count, offset, out) {
      return open[fd]?.node ? read(open[fd], Number(offset), list, count, out) : ERRNO.badf;
    },
    fd_write(fd, list, count, out) {
      const file = open[fd];
      if (!file) return ERRNO.badf;
      return vectors(list, count, out, from => {
        if (file.kind === TERMINAL) {
          print(fd, from.slice());
        } else {
          write_at(file.node, file.place, from);
          file.place += from.length;
        }
        return from.length;
      });
    },
    path_filestat_get(fd, _, from, size, to) {
      const node = files.node(path_at(fd, from, size));
      return node ? stat(node, to) : ERRNO.noent;
    },
    path_open(fd, _, from, size, how, __, ___, ____, to) {
      const path = path_at(fd, from, size);
      let node = files.node(path);
      if (!node && !(how & 1)) return ERRNO.noent;
      if (node && (how & 4)) return ERRNO.exist;
      if (node && !node.folder && (how & 2)) return ERRNO.inval;
      if (!node || (how & 8)) node = files.add(path, new Uint8Array(0), false);
      open.push({path, node, place: 0, kind: node.folder ? DIRECTORY : REGULAR});
      view().setUint32(to, open.length - 1, true);
      return 0;
    },
    path_unlink_file: (fd, from, size) =>
      files.remove(path_at(fd, from, size)) ? 0 : ERRNO.noent,
    path_rename(fd, from, size, to_fd, to, to_size) {
      files.rename(path_at(fd, from, size), path_at(to_fd, to, to_size));
      return 0;
    },
    path_readlink: () => ERRNO.inval,
  };
  return new Proxy(known, {get: (all, name) => all[name] || (() => ERRNO.notsup)});
}

/// Runs a whole program: {status, printed}. A trap of the program's is thrown.
function run_program(module, files, args) {
  let printed = "", instance = null;
  const decoder = new TextDecoder();
  const system = wasi(files, args, (_, bytes) => { printed += decoder.decode(bytes); },
                      () => instance.exports.memory);
  instance = new WebAssembly.Instance(module, {wasi_snapshot_preview1: system});
  try {
    instance.exports._start();
    return {status: 0, printed};
  } catch (error) {
    if (error instanceof Exit) return {status: error.status, printed};
    throw Object.assign(error, {printed});
  }
}

if (typeof module !== "undefined") module.exports = {Exit, Files, wasi, run_program};
