// Compiles a reader's file and links it, in a worker of the page and in node. The compiler is clang
// as a program of WebAssembly; the headers are those with which the other objects were made.
"use strict";
if (typeof module !== "undefined") Object.assign(globalThis, require("./wasi.js"));

const FLAGS = ["clang++", "-cc1", "-triple", "wasm32-unknown-wasi", "-mrelocation-model", "static",
  "-mframe-pointer=none", "-ffp-contract=off", "-fno-rounding-math", "-mconstructor-aliases",
  "-target-cpu", "generic", "-fvisibility=hidden", "-ffunction-sections", "-fdata-sections",
  "-nostdsysteminc", "-nobuiltininc", "-internal-isystem", "/wasi/c++/v1", "-internal-isystem",
  "/clang", "-internal-isystem", "/wasi", "-internal-isystem", "/glm", "-I", "/", "-std=c++20",
  "-fcxx-exceptions", "-fexceptions", "-ftrivial-auto-var-init=pattern", "-fno-finite-loops",
  "-D_LIBCPP_DEBUG=0", "-DGLM_FORCE_EXPLICIT_CTOR", "-Wall", "-Wextra", "-Werror=return-type",
  "-Werror=uninitialized", "-Wno-unused-parameter", "-Wno-unused-variable",
  "-Wno-unused-but-set-variable", "-ferror-limit", "3"];
const UNITS = ["-DJOINTS_REAL=joints::Quantity", '-DJOINTS_REAL_HEADER="tests/checker/quantity.h"'];
const LIBRARIES = ["/lib/libc++.a", "/lib/libc++abi.a", "/lib/libc.a", "/lib/builtins.a"];
const MOST_MEMORY = 1 << 29;  // of a test [bytes]

class Compiler {
  /// \param program the compiled module of clang and lld \param files what it reads
  constructor(program, files) {
    this.program = program;
    this.files = files;
  }
  run(args) {
    try {
      return run_program(this.program, this.files, args);
    } catch (error) {
      return {status: -1,
              printed: `${error.printed || ""}\nThe compiler stopped: ${error.message}`};
    }
  }
  /// A precompiled header of a header. Templates are instantiated in it, but not for numbers with
  /// units, for which not all of them can be.
  precompile(header, out, units = false) {
    return this.run([...FLAGS, ...(units ? UNITS : ["-fpch-instantiate-templates"]), "-O0",
                     "-emit-pch", "-fno-pch-timestamp", "-x", "c++-header", header, "-o", out]);
  }
  /// An object of a source, with a precompiled header.
  compile(source, header, out, more = []) {
    return this.run([...FLAGS, ...more, "-O0", "-emit-obj", "-include-pch", header,
                     "-fno-validate-pch", "-x", "c++", source, "-o", out]);
  }
  /// A module of objects; `maybe` are those of which only what is called is taken.
  link(objects, maybe, out) {
    return this.run(["wasm-ld", "-m", "wasm32", "--entry", "_initialize", "--gc-sections",
                     "--strip-all", "--stack-first", "-z", "stack-size=1048576",
                     `--max-memory=${MOST_MEMORY}`, "--export-if-defined=__stack_pointer",
                     "/lib/crt1-reactor.o", ...objects, "--start-lib", ...maybe, "--end-lib",
                     ...LIBRARIES, "-o", out]);
  }
}

if (typeof module !== "undefined") module.exports = {Compiler};
