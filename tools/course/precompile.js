// Makes the precompiled header of the course with the compiler that will read it:
//   node precompile.js llvm.core.wasm headers.pack.gz OUT [units]
"use strict";
const fs = require("fs"), zlib = require("zlib"), here = `${__dirname}/../../docs/course/`;
const {Compiler} = require(`${here}compiler.js`), {Files} = require(`${here}wasi.js`);
const {add_pack} = require(`${here}pack.js`);

const [program, headers, out, units] = process.argv.slice(2);
const files = new Files();
add_pack(files, zlib.gunzipSync(fs.readFileSync(headers)));
const compiler = new Compiler(new WebAssembly.Module(fs.readFileSync(program)), files);
const {status, printed} = compiler.precompile(units ? "/units.h" : "/course.h", "/course.pch",
                                              Boolean(units));
if (printed) console.error(printed);
if (status === 0) fs.writeFileSync(out, files.bytes("/course.pch"));
process.exit(status ? 1 : 0);
