"""The picture of the live page, in a browser: hands, joints, a frame of another page, the pace:
picture_test.py ROOT BUILD

Skipped, with exit status 77, where Chromium or the packages that make WebAssembly are missing.
"""
import sys
from functools import cache

from made import live, page, skip_without

from page_test import PHONE, WIDE, hash_of, said, says
from proofs import main
from website import browser


@cache
def address_of(build):
    """The page with the solution alone."""
    page(build, "page")
    return live.write_page(build / "live" / "picture.html", "alone", [
        ("the solution", build / "live" / "solution.wasm")]).as_uri()


def bodies_are_dragged(root, build):
    """mouse and finger take a body along; beside the bodies they turn the picture"""
    address = address_of(build)
    here = browser.shared()
    for finger, (width, height) in ((False, WIDE), (True, PHONE)):
        here.open(f"{address}#scene=chain&t=3", width, height)
        if finger:
            here.call("Emulation.setTouchEmulationEnabled", enabled=True)
        here.ask("scrollTo(0, 0)")
        x, y = here.ask("""(() => { const {painted, canvas} = panels[0];
            const b = canvas.getBoundingClientRect();
            const [x, y] = project(painted.view, painted.bodies[12].x);
            return [b.left + x, b.top + y]; })()""")
        x0, yaw = here.ask("[panels[0].painted.bodies[12].x, camera.yaw]")
        # Towards the middle of the picture, and held there until the body follows.
        here.drag([(x + 2 * k, y - 3 * k) for k in range(30)], finger, f"""held?.body === 12 &&
            size(sub(held.point, {x0})) > 0.5 && size(sub(held.point, {x0})) >
            2 * size(sub(held.point, panels[0].painted.bodies[12].x))""")
        name = "the finger" if finger else "the mouse"
        if here.ask("camera.yaw") != yaw:
            yield f"{name} turns the picture as well"
        here.wait("held === null")
        if "t=" in hash_of(here):
            yield f"after a drag the address has a time: {hash_of(here)}"
        here.click("#play")
        here.wait("!playing")
        here.ask("scrollTo(0, 0)")
        x, y = here.ask("""(() => { const box = panels[0].canvas.getBoundingClientRect();
            return [1, 2, 3, 4, 5].map(k => [box.x + k / 6 * box.width, box.y + box.height / 2])
              .find(([x, y]) => !under_finger(panels[0], {clientX: x, clientY: y})); })()""")
        here.drag([(x + 3 * k, y) for k in range(10)], finger, f"camera.yaw !== {yaw}")
        if here.console:
            yield f"the console says {here.console}"
        here.call("Emulation.setTouchEmulationEnabled", enabled=False)


def keys_take_a_body(root, build):
    """enter takes a body, tab the next one, arrows pull it, escape lets go; all of it is said"""
    address = address_of(build)
    here = browser.shared()
    def press(key, **more):
        here.call("Input.dispatchKeyEvent", type="keyDown", key=key, **more)
        here.call("Input.dispatchKeyEvent", type="keyUp", key=key, **more)

    here.open(f"{address}#scene=chain&t=2")
    here.ask("document.querySelector('canvas').focus()")
    press("Enter")
    here.wait(says("body 1 of 12"))
    press("Tab", code="Tab", windowsVirtualKeyCode=9)
    here.wait(says("body 2 of 12"))
    before = here.ask("panels[0].painted.bodies[2].x[1]")
    for _ in range(30):
        press("ArrowUp")
    here.wait(f"panels[0].painted.bodies[2].x[1] > {before} + 0.5")
    if not here.ask("document.activeElement === panels[0].canvas"):
        yield "the picture has lost the keys while a body was held"
    press("Escape")
    here.wait("held === null")
    if "hold" in said(here):
        yield f"after letting go: {said(here)}"
    here.ask("document.querySelector('canvas').focus()")
    press("Tab", code="Tab", windowsVirtualKeyCode=9)
    here.wait("document.activeElement !== panels[0].canvas")
    if here.console:
        yield f"the console says {here.console}"


def joints_are_drawn(root, build):
    """anchors, axes, limits, motors and, if asked, forces are in the picture"""
    address = address_of(build)
    # Pixels that have these colours, about: lines are thin, and their edges are mixed.
    count = """((...names) => names.map(name => { const c = panels[0].canvas, of = parts(name),
        all = c.getContext("2d").getImageData(0, 0, c.width, c.height).data; let sum = 0;
        for (let k = 0; k < all.length; k += 4)
          sum += [0, 1, 2].every(i => Math.abs(all[k + i] - of[i]) < 30); return sum; }))"""
    here = browser.shared()
    for dark in (False, True):
        for state, names in (("scene=chain&t=0.1", ("--joint",)),
                             ("scene=door&t=0.1", ("--limit", "--motor")),
                             ("scene=hinges&t=0.1", ("--joint",)),
                             ("scene=piston&t=0.1", ("--limit", "--motor"))):
            here.open(f"{address}#{state}", *WIDE, dark)
            found = here.ask(f"{count}(...{list(names)})")
            for name, pixels in zip(names, found):
                if pixels < 20:
                    yield f"#{state}, {'dark' if dark else 'light'}: {pixels} pixels of {name}"
    here.open(f"{address}#scene=door&t=0.1")
    door = here.ask("panels[0].driven[0]")
    if abs(door["upper"] - 110 * 3.14159265 / 180) > 1e-6 or door["speed"] != -1:
        yield f"the door's limit and motor are drawn at {door}"
    here.ask("change('strength', 0).then(show)")
    here.wait("panels[0].driven[0].strength === 0")
    if here.ask(f"{count}('--motor')")[0] > 20:
        yield "a motor without strength is drawn"
    before = here.ask(f"{count}('--ink')")[0]
    here.click("#forces")
    here.wait("panels[0].forces?.length")
    here.frame()
    if (after := here.ask(f"{count}('--ink')")[0]) < before + 20:
        yield f"forces: {after} pixels of arrows, {before} without"


# Of the picture that three.js has drawn: [bodies, joints too, of all pixels; the canvas, of the
# window; pixels of the floor in a shadow], each in percent.
COVERED = """(() => {
  const {stage, ground, renderer, eye, canvas} = lit, {background} = stage;
  const copy = document.createElement("canvas"), pen = copy.getContext("2d");
  Object.assign(copy, {width: canvas.width, height: canvas.height});
  const count = is => {
    renderer.render(stage, eye);
    pen.drawImage(canvas, 0, 0);
    const {data} = pen.getImageData(0, 0, copy.width, copy.height);
    let sum = 0;
    for (let k = 0; k < data.length; k += 4) sum += is(data[k], data[k + 1], data[k + 2]);
    return 400 * sum / data.length;
  };
  const shadow = count(
    (r, g, b) => Math.max(r, g, b) - Math.min(r, g, b) < 12 && r > 90 && r < 160);
  stage.overrideMaterial = new THREE.MeshBasicMaterial({color: 0xff00ff, fog: false});
  Object.assign(stage, {background: new THREE.Color(0)});
  ground.visible = false;
  const bodies = count((r, g) => r > 100 && g < 50);
  Object.assign(stage, {background, overrideMaterial: null});
  ground.visible = true;
  const box = panels[0].canvas.getBoundingClientRect();
  return [bodies, 100 * box.width * box.height / innerWidth / innerHeight, shadow]; })()"""
# At 1 s bodies must cover as much of the picture [percent], also in the scenes of the thinnest.
LEAST = 8
THIN = ("pendulum", "chain", "heavy", "piston", "bridge", "door", "ropes")


def bodies_are_lit(root, build):
    """with WebGL bodies fill the picture and throw shadows, and the canvas fills the first screen;
    without, a sentence says that it is flat"""
    address = address_of(build)
    with browser.Browser(webgl=True) as here:
        for scene in THIN:
            for size in ((1280, 800), PHONE):
                here.open(f"{address}#scene={scene}&t=1&lit=1", *size)
                bodies, canvas, shadow = here.ask(COVERED)
                name = f"#{scene}, {size[0]} pixels"
                if bodies < LEAST:
                    yield f"{name}: bodies cover {bodies:.1f} % of the picture"
                if canvas < 60:
                    yield f"{name}: the canvas covers {canvas:.0f} % of the screen"
                if scene == "piston" and shadow < 0.1:
                    yield f"{name}: {shadow:.2f} % of the floor is in a shadow"
                if wrong := [words for words in here.console if "rror" in words]:
                    yield f"{name}: the console says {wrong}"
    here = browser.shared()
    here.open(f"{address}#scene=chain&t=1")
    if "Drawn flat" not in here.ask("panels[0].note.textContent"):
        yield "without WebGL nothing says that the picture is flat"


def one_setting_in_a_frame(root, build):
    """within another page the scene has the one setting that the sentence is about, and its gap"""
    address_of(build)
    folder = build / "live"
    here = browser.shared()
    for width, setting, state in ((700, "beta", "scene=chain&beta=1&t=1"),
                                  (360, "direct", "scene=heavy&t=1"),
                                  (360, "strength", "scene=door&strength=20&t=1"),
                                  (320, "beta", "scene=chain&t=1")):
        outer = folder / "framed.html"
        outer.write_text(
            f'<!DOCTYPE html><iframe src="picture.html#{state}&amp;only={setting}" '
            f'width="{width}" height="500"></iframe><script>const one = setInterval(() => {{'
            'const page = document.querySelector("iframe").contentDocument;'
            'if (page?.documentElement.dataset.ready) { clearInterval(one);'
            'document.documentElement.dataset.ready = "yes"; } }, 20);</script>')
        here.open(outer.as_uri())
        inner = "document.querySelector('iframe').contentDocument"
        shown_ = here.ask(f"""[...{inner}.querySelectorAll('#controls label')]
            .filter(one => one.checkVisibility()).map(one => one.dataset.name).join()""")
        if shown_ != setting:
            yield f"{state}: the settings {shown_} are shown, not {setting}"
        cut = here.ask(f"""['#stage', '#gap', '#reading', '#controls label']
            .filter(name => {{ const b = {inner}.querySelector(name).getBoundingClientRect();
              return b.height < 20 || b.bottom > 501 || b.right > {width} + 1; }}).join()""")
        if cut:
            yield f"{state}, {width} pixels: {cut} is not to be seen"
        if here.ask(f"""[...{inner}.querySelectorAll('[type=range]')].some(one =>
                one.checkVisibility() && one.clientWidth < 120)"""):
            yield f"{state}, {width} pixels: too little of the slider"
        if "gap" not in here.ask(f"{inner}.getElementById('reading').textContent"):
            yield f"{state}: no gap is told"


def a_slow_run_is_told(root, build):
    """where a second takes longer than a second, the page says so"""
    address = address_of(build)
    here = browser.shared()
    here.open(f"{address}#scene=chain")
    here.ask("panels[0].engine.ask = (ask => async (...all) => { "  # a slow engine
             "await new Promise(done => setTimeout(done, 300)); return ask(...all); })"
             "(panels[0].engine.ask.bind(panels[0].engine))")
    here.wait("document.getElementById('reading').textContent.includes('of real time')")
    real, rates = here.ask("""(async () => {
      const rates = [], now = () => [time, performance.now() / 1000], begun = now();
      while (rates.length < 4) {  // one is shown for each second or more
        const {wall} = pace;
        while (wall === pace.wall) await new Promise(requestAnimationFrame);
        rates.push(pace.rate);
      }
      const [went, took] = now().map((one, k) => one - begun[k]);
      return [went / took, rates]; })()""")
    if not (max(rates) < 0.97 and min(rates) / 2 < real < 2 * max(rates)):
        yield f"a run at {real:.2f} of real time is said to be at {rates}"


PROOFS = [bodies_are_dragged, keys_take_a_body, joints_are_drawn, bodies_are_lit,
          one_setting_in_a_frame, a_slow_run_is_told]

if __name__ == "__main__":
    skip_without("the live page's picture in a browser",
                 live.missing() + ["chromium"] * (browser.there() is None))
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
