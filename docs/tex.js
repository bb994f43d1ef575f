// Turns TeX into SVG without a browser: node tex.js FOLDER_OF_MATHJAX < formulas > drawings
//
// The formulas are a JSON list of [TeX, true for a display]. The answer is a JSON object:
// "drawings", for each formula an <svg>, or what is wrong with it as {"error": words}; and "glyphs",
// the letters that the drawings refer to, {id: its <path>}. MathJax 2 asks for a page: the few
// things that it asks of one are here, and none of them measures anything.
"use strict";
const fs = require("fs"), path = require("path"), vm = require("vm");
const folder = process.argv[2], formulas = JSON.parse(fs.readFileSync(0, "utf8"));

const run = file => vm.runInThisContext(fs.readFileSync(file, "utf8"), file);

// -------------------------------------------------------------------------------- what a page is
class Node {
  constructor(name, text) {
    Object.assign(this, {nodeName: name.toUpperCase(), tagName: name, localName: name,
                         childNodes: [],
                         attributes: {}, parentNode: null, nodeType: text === undefined ? 1 : 3,
                         nodeValue: text, style: {}, className: "", ownerDocument: document,
                         offsetWidth: 480, offsetHeight: 480, clientWidth: 480, scrollWidth: 0});
    if (name === "style") this.styleSheet = {cssText: ""};  // it counts as loaded at once
  }
  get firstChild() { return this.childNodes[0] || null; }
  get lastChild() { return this.childNodes.at(-1) || null; }
  get place() { return this.parentNode ? this.parentNode.childNodes.indexOf(this) : -1; }
  beside(k) { return this.parentNode && this.parentNode.childNodes[this.place + k] || null; }
  get nextSibling() { return this.beside(1); }
  get previousSibling() { return this.beside(-1); }
  get id() { return this.attributes.id || ""; }
  set id(id) { this.attributes.id = id; }
  get text() {
    return this.nodeType === 3 ? this.nodeValue : this.childNodes.map(c => c.text).join("");
  }
  set text(text) { this.childNodes = []; this.appendChild(new Node("#text", text)); }
  get innerHTML() { return this.text; }
  set innerHTML(text) { this.text = text; }
  get textContent() { return this.text; }
  set textContent(text) { this.text = text; }
  insertBefore(node, next) {
    if (node.parentNode) node.parentNode.removeChild(node);
    this.childNodes.splice(next ? next.place : this.childNodes.length, 0, node);
    node.parentNode = this;
    if (node.nodeName === "SCRIPT" && node.src)
      setTimeout(() => run(node.src.replace(/\?.*/, "")), 0);
    return node;
  }
  appendChild(node) { return this.insertBefore(node, null); }
  removeChild(node) { this.childNodes.splice(node.place, 1); node.parentNode = null; return node; }
  replaceChild(node, old) { this.insertBefore(node, old); return this.removeChild(old); }
  cloneNode(deep) {
    const copy = new Node(this.tagName, this.nodeValue);
    Object.assign(copy, {attributes: {...this.attributes}, style: {...this.style},
                         className: this.className});
    if (deep) for (const child of this.childNodes) copy.appendChild(child.cloneNode(true));
    return copy;
  }
  setAttribute(name, value) { this.attributes[name] = String(value); }
  setAttributeNS(_, name, value) { this.setAttribute(name, value); }
  getAttribute(name) { return name in this.attributes ? this.attributes[name] : null; }
  removeAttribute(name) { delete this.attributes[name]; }
  hasAttribute(name) { return name in this.attributes; }
  addEventListener() {}
  getBBox() { return {x: 0, y: 0, width: 0, height: 0}; }
  getBoundingClientRect() { return {left: 0, right: 0, top: 0, bottom: 0, width: 0, height: 0}; }
  find(wanted) {  // the first of those in it
    for (const child of this.childNodes) {
      const found = wanted(child) ? child : child.find(wanted);
      if (found) return found;
    }
    return null;
  }
  all() { return this.childNodes.flatMap(child => [child, ...child.all()]); }
  getElementsByTagName(name) {
    return this.all().filter(node => node.nodeName === name.toUpperCase());
  }
  get markup() {
    const safe = text => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");
    if (this.nodeType === 3) return safe(this.nodeValue);
    const all = {...this.attributes, ...(this.className ? {class: this.className} : {})};
    const style = Object.entries(this.style).map(([key, value]) =>
      `${key.replace(/[A-Z]/g, c => "-" + c.toLowerCase())}: ${value}`).join("; ");
    if (style && this.tagName === "svg") all.style = style;
    return `<${this.tagName}${Object.entries(all).map(([k, v]) => ` ${k}="${safe(v)}"`).join("")}>`
      + this.childNodes.map(child => child.markup).join("") + `</${this.tagName}>`;
  }
}

var document = {};
document = new Node("#document");
Object.assign(document, {documentElement: new Node("html"), head: new Node("head"),
                         body: new Node("body"), location: {}, readyState: "complete", title: "",
                         ownerDocument: null, defaultView: globalThis, compatMode: "CSS1Compat",
                         createElement: name => new Node(name),
                         createElementNS: (_, name) => new Node(name),
                         createTextNode: text => new Node("#text", text),
                         createDocumentFragment: () => new Node("div"),
                         getElementById: id => document.find(node => node.id === id)});
document.appendChild(document.documentElement);
document.documentElement.appendChild(document.head);
document.documentElement.appendChild(document.body);
Object.defineProperty(globalThis, "navigator", {configurable: true, value: {
  userAgent: "node", appVersion: "5.0", platform: "", vendor: "", language: "en"}});
Object.assign(globalThis, {document, window: globalThis, addEventListener() {}, parent: globalThis,
                           location: {href: "file:///", protocol: "file:", host: "", pathname: "/",
                                      search: "", hash: ""}});

// ----------------------------------------------------------------------------------- the drawings
const places = formulas.map(([tex, display]) => {
  const script = new Node("script");
  script.type = "math/tex" + (display ? "; mode=display" : "");
  script.text = tex;
  const place = new Node(display ? "div" : "span");
  place.appendChild(script);
  return document.body.appendChild(place);
});

function answer() {
  const drawings = places.map((place, k) => {
    const svg = place.all().find(node => node.nodeName === "SVG");
    const wrong = place.all().find(node => /merror|MathJax_Error/.test(
      node.className + node.getAttribute("class"))) || place.all().find(
        node => node.nodeName === "TEXT" || node.getAttribute("fill") === "red");
    if (!svg || wrong) return {error: `${formulas[k][0]}: ${wrong ? wrong.text : "not drawn"}`};
    return svg.markup;
  });
  const store = document.getElementById("MathJax_SVG_glyphs");
  const glyphs = Object.fromEntries(store.childNodes.map(node => [node.id, node.markup]));
  process.stdout.write(JSON.stringify({drawings, glyphs}));
}

globalThis.MathJax = {
  root: folder, showProcessingMessages: false, messageStyle: "none", skipStartupTypeset: true,
  jax: ["input/TeX", "output/SVG"], extensions: [],
  TeX: {extensions: ["AMSmath.js", "AMSsymbols.js"]}, showMathMenu: false, positionToHash: false,
  SVG: {font: "TeX", scale: 100, useGlobalCache: true, matchFontHeight: false},
  AuthorInit: () => globalThis.MathJax.Hub.Register.StartupHook("End", () =>
    globalThis.MathJax.Callback.Queue(["Process", globalThis.MathJax.Hub, document.body], answer))};
run(path.join(folder, "MathJax.js"));
