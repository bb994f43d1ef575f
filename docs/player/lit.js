// What three.js draws of a scene: lit bodies, their shadows on a ground, and joints as what they
// are. Where it cannot (no three.js, no WebGL, or one without a graphics card, unless the address
// says lit=1) `lit` is null and paint.js draws flat, at a tenth of the cost.
"use strict";

let lit = begin_lit();

function begin_lit() {
  const canvas = document.createElement("canvas");
  const context = window.THREE && canvas.getContext("webgl", {antialias: true, alpha: false});
  const card = context?.getExtension("WEBGL_debug_renderer_info");
  const name = card ? context.getParameter(card.UNMASKED_RENDERER_WEBGL) : "";
  const none = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  if (!context || (none && query.get("lit") !== "1")) return null;
  canvas.addEventListener("webglcontextlost", () => { lit = null; ask(); });
  const renderer = new THREE.WebGLRenderer({canvas, context});
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.PCFShadowMap;
  const stage = new THREE.Scene(), eye = new THREE.PerspectiveCamera();
  const sun = new THREE.DirectionalLight(0xffffff, 0.42);
  Object.assign(sun, {castShadow: true});
  Object.assign(sun.shadow, {bias: -0.003, radius: 2.5});
  sun.shadow.mapSize.set(1024, 1024);
  eye.add(new THREE.DirectionalLight(0xffffff, 0.28));  // from beside the reader, onto what is seen
  eye.children[0].position.set(-0.4, 0.3, 1);
  stage.add(new THREE.HemisphereLight(0xffffff, 0xd8d4cc, 0.56), sun, sun.target, eye,
            eye.children[0].target);
  const tile = document.createElement("canvas");
  tile.width = tile.height = 256;
  const grid = Object.assign(new THREE.CanvasTexture(tile), {
    wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, anisotropy: 4});
  const ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(2, 2),
                                new THREE.MeshLambertMaterial({map: grid}));
  Object.assign(ground, {matrixAutoUpdate: false, receiveShadow: true});
  stage.add(ground);
  const box = new THREE.BoxBufferGeometry(2, 2, 2);
  const shapes = {box, edges: new THREE.EdgesGeometry(box),
                  ball: new THREE.SphereBufferGeometry(1, 32, 20),
                  rod: new THREE.CylinderBufferGeometry(1, 1, 2, 14)};
  renderer.debug.checkShaderErrors = false;  // it would wait for each
  return {canvas, renderer, stage, eye, sun, tile, grid, ground, shapes, pools: new Map(),
          theme: ""};
}

// A piece of a shape and colour, from those that there are or a new one: a unit shape that these
// axes stretch and turn, at x.
function piece(shape, colour, axes, x) {
  const key = shape + colour;
  if (!lit.pools.has(key)) {
    const material = shape === "edges"
      ? new THREE.LineBasicMaterial({color: colour, transparent: true, opacity: 0.45, fog: false})
      : new THREE.MeshLambertMaterial({color: colour, fog: false});
    lit.pools.set(key, {material, used: 0, pieces: []});
  }
  const pool = lit.pools.get(key);
  if (pool.used === pool.pieces.length) {
    const one = shape === "edges" ? new THREE.LineSegments(lit.shapes.edges, pool.material)
      : new THREE.Mesh(lit.shapes[shape], pool.material);
    Object.assign(one, {matrixAutoUpdate: false, frustumCulled: false,
                        castShadow: shape !== "edges", receiveShadow: shape !== "edges"});
    pool.pieces.push(one);
    lit.stage.add(one);
  }
  const one = pool.pieces[pool.used++];
  one.visible = true;
  one.matrix.set(axes[0][0], axes[1][0], axes[2][0], x[0], axes[0][1], axes[1][1], axes[2][1], x[1],
                 axes[0][2], axes[1][2], axes[2][2], x[2], 0, 0, 0, 1);
}
const ball = (x, radius, colour) => piece("ball", colour, upright.map(n => times(radius, n)), x);
// A round bar from p to q.
function bar(p, q, radius, colour) {
  const half = times(0.5, sub(q, p)), length = size(half);
  if (length < 1e-9) return;
  const side = unit(cross(half, Math.abs(half[0]) < 0.7 * length ? upright[0] : upright[1]));
  piece("rod", colour, [times(radius, side), half, times(radius / length, cross(side, half))],
        plus(p, 1, half));
}
// A rope of this length between p and q: a parabola of that length where it is slack.
function rope(p, q, length, radius, colour) {
  const d = sub(q, p), slack = Math.max(length - size(d), 0);
  const count = slack > 0.01 * length ? 12 : 1;
  const sag = Math.min(Math.sqrt(0.375 * Math.max(size(d), length / 3) * slack), length / 2);
  const at = s => plus(plus(p, s, d), -4 * sag * s * (1 - s), upright[1]);
  for (let k = 0; k < count; ++k) bar(at(k / count), at((k + 1) / count), radius, colour);
}

// The lines of a run: arms of bodies to their joints, rods and ropes between bodies; where two arms
// meet, a pin, an axle along the joint's axis, or the block of a weld.
function lit_lines(run, bodies, colour_of) {
  const thin = k => Math.min(...bodies[k].half.filter(half => half > 0));
  const joint = style("--joint"), line = style("--line");
  let before = null;
  run.lines.forEach(([one, anchor1, two, anchor2, length], k) => {
    const [p, q] = [world(bodies[one], anchor1), world(bodies[two], anchor2)];
    if (one !== two) {
      const radius = 0.25 * Math.min(...[one, two].map(thin));
      return length ? rope(p, q, length, 0.7 * radius, line) : bar(p, q, radius, line);
    }
    const radius = 0.45 * thin(one);
    bar(p, q, radius, colour_of(bodies[one]));
    const mark = run.marks?.[k >> 1], end = {at: q, body: bodies[one], radius};
    if (before) {
      const wide = 1.3 * Math.min(radius, before.radius);
      const axis = mark && unit(along(before.body, mark[4]));
      bar(before.at, q, 0.4 * wide, joint);  // a gap is seen
      if (axis) {
        const reach = 1.12 * Math.min(reach_along(before.body, axis), reach_along(end.body, axis));
        bar(plus(q, -reach, axis), plus(q, reach, axis), 0.6 * wide, joint);
      } else if (mark?.[5]) piece("box", joint, end.body.axes.map(n => times(wide, n)), q);
      else ball(q, wide, joint);
    }
    before = before ? null : end;
  });
}

// The ground: the top of a slab that is recorded as one, else as low as anything ever gets.
function lit_ground(view, scene, run, bodies) {
  const slab = grounds(bodies)[0], {ground, grid} = lit;
  const cell = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500].find(
    c => view.reach / c < 9) || 1000;
  let origin = [0, scene.low[1], 0], axes = [upright[0], upright[2]], ends = [Infinity, Infinity];
  if (slab) {
    const sides = [0, 1, 2].filter(k => k !== slab.up);
    origin = drop(slab, slab.x);
    axes = sides.map(k => slab.axes[k]);
    if (!run.endless) ends = sides.map(k => slab.half[k]);
  }
  if (cross(axes[1], axes[0])[1] < 0) axes = [axes[0], times(-1, axes[1])];
  const far = cell * Math.ceil(Math.max(5 * view.reach, 3 * view.distance) / cell);
  const half = ends.map(one => Math.min(one, far));
  const from = sub(view.centre, origin);
  const at = axes.reduce((p, n, k) => isFinite(ends[k]) && ends[k] <= far ? p
    : plus(p, cell * Math.round(dot(n, from) / cell), n), origin);
  const [u, v] = axes.map((n, k) => times(half[k], n)), n = cross(unit(v), unit(u));
  ground.matrix.set(u[0], -v[0], n[0], at[0], u[1], -v[1], n[1], at[1], u[2], -v[2], n[2], at[2],
                    0, 0, 0, 1);
  grid.repeat.set(2 * half[0] / cell, 2 * half[1] / cell);
  grid.offset.set(-half[0] / cell, -half[1] / cell);
}

// The colours of the page, in light and dark.
function dress_lit() {
  const theme = document.documentElement.dataset.theme;
  if (lit.theme === theme) return;
  lit.theme = theme;
  const pen = lit.tile.getContext("2d"), edge = lit.tile.width, {stage} = lit;
  pen.fillStyle = style("--floor");
  pen.fillRect(0, 0, edge, edge);
  pen.strokeStyle = style("--grid");
  pen.globalAlpha = 0.55;
  pen.lineWidth = 5;
  pen.strokeRect(0, 0, edge, edge);
  lit.grid.needsUpdate = true;
  stage.background = new THREE.Color(style("--panel"));
  stage.fog = new THREE.Fog(stage.background, 1, 2);
}

function render(view, scene, run, bodies, colour_of) {
  const {renderer, stage, eye, sun, pools, canvas} = lit, ratio = devicePixelRatio;
  dress_lit();
  for (const pool of pools.values()) pool.used = 0;
  const edges = bodies.length < 200;
  for (const body of bodies) {
    if (body.up >= 0) continue;
    if (body.ball) ball(body.x, body.half[0], colour_of(body));
    else {
      const axes = body.axes.map((n, k) => times(Math.max(body.half[k], 1e-4), n));
      piece("box", colour_of(body), axes, body.x);
      if (edges) piece("edges", style("--shadow"), axes, body.x);
    }
  }
  if (bodies.length) lit_lines(run, bodies, colour_of);
  for (const {pieces, used} of pools.values())
    pieces.forEach((one, k) => { one.visible = k < used; });
  lit_ground(view, scene, run, bodies);
  const reach = view.reach || 1;
  Object.assign(stage.fog, {near: view.distance + 0.8 * reach, far: view.distance + 4 * reach});
  sun.position.set(...plus(view.centre, 3 * reach, [-0.2, 0.95, 0.24]));
  sun.target.position.set(...view.centre);
  Object.assign(sun.shadow.camera, {left: -reach, right: reach, top: reach, bottom: -reach,
                                    near: 0.5 * reach, far: 6 * reach});
  sun.shadow.camera.updateProjectionMatrix();
  Object.assign(eye, {fov: 2 * Math.atan(view.height / 2 / view.focal) * 180 / Math.PI,
                      aspect: view.width / view.height, near: 0.02 * view.distance,
                      far: view.distance + 12 * reach});
  eye.up.set(...view.up);
  eye.position.set(...view.eye);
  eye.lookAt(...view.centre);
  eye.updateProjectionMatrix();
  const [width, height] = [view.width, view.height].map(edge => Math.round(edge * ratio));
  if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
  renderer.render(stage, eye);
}
