// The engine of a live page without a browser: node module.js PAGE, then questions to the worker on
// standard input, a line of JSON each; the answers come out in the same way. The worker's script is
// taken out of the page and runs in a thread, as in a browser: what does not answer within its
// `patience` [ms], or five minutes, is ended.
const fs = require("fs");
const {Worker} = require("worker_threads");

const page = fs.readFileSync(process.argv[2], "utf8");
const part = id => page.match(new RegExp(`<script[^>]*id="${id}"[^>]*>([^]*?)</script>`))[1];
const modules = JSON.parse(part("data")).modules;
const thread = `const {parentPort} = require("worker_threads");
  globalThis.self = {postMessage: answer => parentPort.postMessage(answer)};
  parentPort.on("message", data => self.onmessage({data}));\n`;

let worker, number;
function ask(question) {
  return new Promise(resolve => {
    const clock = setTimeout(() => {
      worker.terminate();
      resolve({ended: true});
    }, question.patience || 300000);
    worker.once("message", answer => {
      clearTimeout(clock);
      resolve(answer);
    });
    worker.postMessage(question);
  });
}
const plain = (_, value) => ArrayBuffer.isView(value) ? Array.from(value) : value;

(async () => {
  for (const line of fs.readFileSync(0, "utf8").split("\n").filter(Boolean)) {
    const question = JSON.parse(line);
    if (question.what === "load") {  // the module of this label, in a fresh worker
      worker?.terminate();
      worker = new Worker(thread + part("worker"), {eval: true});
      const {wasm} = modules.find(each => each.label === question.label);
      question.bytes = Uint8Array.from(Buffer.from(wasm, "base64"));
    }
    console.log(JSON.stringify(await ask(question), plain));
  }
  process.exit(0);
})();
