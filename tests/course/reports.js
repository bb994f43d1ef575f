// Runs tests as the page does: reads a job as JSON and writes a line for each answer. The job: the
// module, the chapter as the page knows it, and which tests of which known answers are asked for.
"use strict";
const fs = require("fs"), docs = `${__dirname}/../../docs/course/`;
const {Files} = require(`${docs}wasi.js`), {Runner} = require(`${docs}runner.js`);
const {graded, told} = require(`${docs}report.js`);

const {wasm, chapter, drawing, jobs} = JSON.parse(fs.readFileSync(0));
const module_ = new WebAssembly.Module(fs.readFileSync(wasm));
const solution = new Runner(module_, new Files(), drawing);
console.log(JSON.stringify(solution.list("[").map(({k}) => solution.run(k).printed).join("")));
for (const {id, answer} of jobs) {
  const files = new Files();
  files.add(chapter.path, new TextEncoder().encode(chapter.stub));
  const runner = new Runner(module_, files, [`WORKBOOK_ANSWER=${answer}`]), results = [];
  for (const {k, name} of runner.list(`[${id}]`)) {
    results.push({name, ...runner.run(k)});
    if (["crash", "exit"].includes(results.at(-1).ended)) break;
  }
  const grade = graded(id, results, chapter, chapter.stub);
  console.log(JSON.stringify({...grade, told: told(grade, chapter, chapter.stub)}));
}
