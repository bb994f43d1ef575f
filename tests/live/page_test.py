"""The live page in a browser, with clicks, keys and fingers: page_test.py ROOT BUILD

Skipped, with exit status 77, where Chromium or the packages that make WebAssembly are missing.
"""
import re
import sys
from functools import lru_cache

from made import house, live, page, skip_without

from proofs import main, read

from keep import tied, values
from website import browser

WIDE, PHONE = (1280, 900), (390, 844)


def shown(here):
    """What the page says of its state, without the time that a step took."""
    here.frame()
    return here.text_of("reading").rsplit("·", 1)[0]


def hash_of(here):
    return here.ask("location.hash")


def said(here):
    """What it says once all that has happened so far is painted."""
    here.frame()
    return here.text_of("said")


def go(here, state):
    """The open page, paused, at another state, as where its address is changed."""
    here.ask(f"play(false), history.replaceState(null, '', '#{state}'), onhashchange()")


def starts(text):
    """That the page shows it, as an expression."""
    return f"document.getElementById('reading').textContent.startsWith('{text}')"


def says(words):
    return f"document.getElementById('said').textContent.includes('{words}')"


def it_opens(root, build):
    """ready within 5 s of a processor, wide and light, narrow and dark; silent, no network, no
    panning"""
    page(build, "page")
    address = live.write_page(build / "live" / "alone.html", "alone", [
        ("the solution", build / "live" / "solution.wasm")]).as_uri()
    here = browser.shared()
    for dark, (width, height) in enumerate((WIDE, PHONE)):
        name, before = f"{width} pixels", here.processor_time()
        here.open(f"{address}#scene=bridge&t=1", width, height, dark)
        if (took := here.processor_time() - before) > 5:
            yield f"{name}: ready after {took:.1f} s of a processor"
        if not shown(here).startswith("t = 1.00 s"):
            yield f"{name}: shows {shown(here)}"
        if here.console:
            yield f"{name}: the console says {here.console}"
        if outside := [url for url in here.requests
                       if not url.startswith(("file:", "blob:", "data:"))]:
            yield f"{name}: asks for {outside}"
        if here.ask("document.documentElement.scrollWidth") > width:
            yield f"{name}: pans sideways"
        if here.ask("""(() => { const row = document.getElementById("scenes");
                return row.scrollWidth > row.clientWidth &&
                  !getComputedStyle(row).maskImage.includes("gradient"); })()"""):
            yield f"{name}: the row of scenes ends without a sign"
        if here.ask("document.documentElement.dataset.theme") != ("dark" if dark else "light"):
            yield f"{name}: not in its colours"


def an_address_is_a_state(root, build):
    """an address leads to its state, again and again, and stays the page's address"""
    address = (build / "live" / "alone.html").as_uri()
    here = browser.shared()
    for state in ("scene=chain&beta=2.1&t=3", "scene=pendulum&t=5",
                  "scene=box&iterations=4&view=errors&t=0.5&iteration=3&block=2",
                  "scene=heavy&beta=1&direct=1&newton=8&leapfrog=1&t=2",
                  "scene=chain&own=1&t=2"):
        here.open(f"{address}#{state}")
        readings = [(shown(here), said(here))]
        go(here, state)
        readings.append((shown(here), said(here)))
        if readings[0] != readings[1]:
            yield f"#{state}: {readings[0]}, then {readings[1]}"
        if hash_of(here) != f"#{state}":
            yield f"#{state}: the page calls it {hash_of(here)}"
    go(here, "scene=chain&beta=2.1&t=3")
    if "blown up" not in said(here):
        yield f"beta 2.1 is said to be: {said(here)}"
    here.ask("location.hash = '#scene=pendulum&t=1'")
    here.wait(starts("t = 1.00 s"))


class Shown(values.Tables):
    """Numbers of a text as the page shows them in a browser."""
    UNITS = {"µm": 1e-6, "mm": 1e-3, "m": 1, "km": 1e3}

    def __init__(self, root, build, here):
        super().__init__(root, build)
        self.here = here
        here.open((build / "live" / "alone.html").as_uri() + "#scene=chain&t=0.1")

    @lru_cache(maxsize=None)
    def states(self, state):
        go(self.here, state)
        self.here.frame()
        size, unit, energy = re.search(r"gap (\S+ \S+|\S+) (µm|mm|m|km) · energy (\S+) J",
                                       self.here.text_of("reading")).groups()
        gap = 0.0 if size.startswith("below") else float(size) * self.UNITS[unit]
        errors = re.findall(r"(?:velocity error is|beginning it was) ([\d.e-]+\d)", said(self.here))
        return {"gap": gap, "energy": float(energy),
                **dict(zip(("error", "first_error"), map(float, errors)))}


def texts_say_what_is_shown(root, build):
    """five of the numbers beside the chapters' links are those that the page shows there"""
    found = []
    for chapter in house.chapters():
        found += [tie for _, tie in tied.ties_of(read(chapter.text))
                  if isinstance(tie, tied.Tie) and tied.LIVE.search(tie.expression)]
    of_each_kind = {tied.LIVE.search(tie.expression)[2]: tie for tie in found}.values()
    here = browser.shared()
    tables = Shown(root, build, here)
    for tie in [found[0], found[len(found) // 2], *of_each_kind]:
        value = tables.value(tie.expression, 0)
        if not abs(value - tie.said) <= 0.5000001 * tie.unit + 1e-12 * abs(value):
            yield f"a text says {tie.shown}, the page {value:.4g}: {tie.expression}"


def settings_work(root, build):
    """sliders, numbers, ticks, tabs and curves do what they say; a refusal leaves a working page"""
    address = (build / "live" / "alone.html").as_uri()
    here = browser.shared()
    here.open(f"{address}#scene=chain&t=0.1")
    here.click("summary")
    here.type("[data-name=beta] [type=range]", "0.5")
    here.wait("location.hash.includes('beta=0.5')")
    here.click("[data-name=warm] input")
    here.wait("location.hash.includes('warm=1')")
    here.click("[data-name=direct] input")
    here.wait("location.hash.includes('newton=8')")
    here.type("[data-name=relaxation] [type=number]", "2")
    here.wait(says("below 2"))
    if "Refused: relaxation is 2; must be above 0" not in said(here):
        yield f"relaxation 2: {said(here)}"
    if "relaxation" in hash_of(here):
        yield f"relaxation 2 is in the address: {hash_of(here)}"
    here.click("#one")
    here.wait(starts("t = 0.12 s"))
    here.click("#controls button")
    here.wait("location.hash === '#scene=chain' && !$('said').textContent")
    for view in ("errors", "energy"):
        here.click(f"[data-view={view}]")
        here.wait(f"document.querySelector('[data-view={view}]').ariaPressed === 'true'")
    here.click("#play")
    here.wait("time > 0.5")
    # A new run has samples of its own, from its beginning on.
    fresh = "playing && panels[0].kept.length > 20 && panels[0].samples !== before" \
            " && panels[0].samples[0]?.[0] < 0.1"
    here.ask("window.before = panels[0].samples, 0")
    here.click("#keep")
    here.wait(fresh)
    if here.ask("panels[0].kept_with") != "the scene's own settings":
        yield f"the kept curve is called {here.ask('panels[0].kept_with')}"
    here.wait("time > 0.5")
    here.ask("window.before = panels[0].samples, 0")
    here.type("[data-name=iterations] [type=number]", "5")  # beside a kept curve: a new run
    here.wait(f"settings.iterations === 5 && {fresh}")
    for tab in range(here.ask("document.getElementById('scenes').children.length")):
        here.click(f"#scenes button:nth-child({tab + 1})")
        here.wait("playing && time > 0.1 && "
                  f"entry === about.scenes[{tab}] && !panels[0].stopped")
    if here.console:
        yield f"the console says {here.console}"


def one_looks_into_a_step(root, build):
    """one iteration and one block at a time, with keys too; then the step is done"""
    address = (build / "live" / "alone.html").as_uri()
    here = browser.shared()
    here.open(f"{address}#scene=chain&iterations=2&t=0.5")
    for click, state in (("block", "iteration=0&block=1"), ("iteration", "iteration=1"),
                         ("iteration", "iteration=2"),
                         ("iteration", "t=0.516666667&iteration=1")):
        here.click(f"#{click}")
        here.wait(f"location.hash.endsWith('&{state}')")
    if "arrows: impulses" not in said(here):
        yield f"says {said(here)}"
    here.click("[data-view=errors]")
    here.wait("panels[0].errors")
    if not here.ask("largest_error(panels[0].joints) === panels[0].errors.errors[1]"):
        yield "the sentence and the curve say different errors"
    arrows = """(() => {
        const {painted: {view}, joints} = panels[0], all = arrow_reach(view, joints);
        return joints.every(joint => on_picture(view, project(
          view, plus(joint.place, all, joint.impulse)))); })()"""
    if not here.ask(arrows):
        yield "an arrow leaves the picture"
    here.call("Input.dispatchKeyEvent", type="keyDown", key="i")  # the button has let it go
    here.wait("location.hash.endsWith('&iteration=2')")
    here.ask("document.querySelector('canvas').focus()")
    yaw = here.ask("camera.yaw")
    here.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowLeft", modifiers=8)
    if here.ask("camera.yaw") == yaw:
        yield "shift and an arrow do not turn the picture"
    painted = here.ask("panels[0].joints.filter(joint => joint.error > 1e-6).length")
    if painted < 5:
        yield f"{painted} joints have an error after one iteration"


def causes_are_told_apart(root, build):
    """a blow-up is a setting's, the hand's or the code's; what no step can use is told"""
    folder = build / "live"
    address = (folder / "alone.html").as_uri()
    here = browser.shared()
    here.open(f"{address}#scene=chain&t=0.1")
    for state, words, not_there in (
            ("scene=pendulum&ratio=100&beta=1&t=1.2", "", "blown up"),
            ("scene=piston&ratio=1000&t=2", "", "energy +"),
            ("scene=chain&beta=2.1&t=3", "The setting beta 2.1 does that", "hand"),
            ("beta=abc&t=0.1", "beta=abc, which is no number: it is 0.2", "NaN"),
            ("scene=nowhere&t=0.1", "There is no scene nowhere: this is chain of 12", "NaN"),
            ("scene=chain&t=0.1&iteration=999", "999, which must be from 0 to 30", "after"),
            ("scene=chain&beta=-1&t=0.1", "beta is -1", "stopped")):
        go(here, state)
        if words not in said(here) or not_there in said(here) + shown(here):
            yield f"#{state}: {said(here)}, {shown(here)}"
    for state, words in (("foo=3&t=0.1", "foo, which is no name here"),
                         ("iterations=2.5&t=0.1", "must be a whole number of at most 10000"),
                         ("h=66.7&t=0.1", "must be at most 1000 ms: it is 16.7 ms"),
                         ("t=3", "apart, 8.49 % of the scene's size. The scene's own settings"),
                         ("ratio=1000&iterations=60&t=3", "settings do that: change others"),
                         ("beta=2.1&direct=0&t=3", "The setting beta 2.1 does that")):
        go(here, f"scene={'heavy' if 't=3' in state else 'chain'}&{state}")
        if words not in said(here):
            yield f"#{state}: {said(here)}"
    go(here, "scene=chain&beta=2.1&t=3")
    here.type("[data-name=beta] [type=number]", "0.2")
    here.type("[data-name=iterations] [type=number]", "40")
    here.wait("settings.iterations === 40")
    if "The setting beta 2.1 does that" not in said(here):
        yield f"what did it once it is changed back: {said(here)}"
    go(here, "scene=chain&t=0.1")
    here.type("[data-name=beta] [type=number]", "")
    here.wait(says("must be a number"))
    here.open(f"{address}#scene=chain&beta=2.1")
    here.wait("!playing && panels[0].now[2] > panels[0].scale")  # no run to the moon
    for state, words in (("scene=chain&t=1", "the bodies have gained"),
                         ("scene=chain&beta=1&t=1", "or the setting beta 1 does: press")):
        go(here, state)
        here.ask("hold(panels[0], 12, panels[0].painted.bodies[12].x), pull([-60, 40, 0])")
        told = here.wait("blown_up(panels[0]) && (show(), $('said').textContent)")
        if words not in told or "Your hand did that" not in told:
            yield f"#{state}, a body thrown by hand: {told}"
        if ("blown up" in told) != ("beta" in state):
            yield f"#{state}, too strong or too weak: {told}"
    go(here, "scene=heavy&t=3")
    if not here.ask("""(() => { const {painted, canvas} = panels[0];
            const [x, y] = project(painted.view, painted.bodies.at(-1).x);
            return Math.min(x, y, canvas.clientWidth - x, canvas.clientHeight - y) > 0;
            })()"""):
        yield "the heavy end is not in the picture"
    go(here, "scene=chain&iterations=7&direct=1&t=0.1")
    here.click("#scenes button[name=hinges]")
    here.wait("entry.name === 'hinges'")
    if here.ask("[settings.iterations, settings.direct].join()") != "7,1":
        yield "another scene drops the settings"
    pair = live.write_page(folder / "parting.html", "pair", [
        ("yours", folder / "thrown.wasm"), ("the solution", folder / "solution.wasm")],
        note="your 1.1", chapter=1).as_uri()
    here = browser.shared()
    here.open(pair)
    here.wait(says("too far"))
    if "yours: stopped" not in shown(here) or "gap" in shown(here).split("\n")[1]:
        yield f"of code that has stopped: {shown(here)}"
    if "Your code stops at t = 0.00 s (step 1): too far" not in here.text_of("parted"):
        yield f"where the code matters: {here.text_of('parted')}"
    here.open(live.write_page(folder / "parting.html", "pair", [
        ("yours", folder / "endless.wasm"), ("the solution", folder / "solution.wasm")],
        note="your 1.1", chapter=1).as_uri())
    told = here.wait("(told => told.includes('never to end') && told)($('parted').textContent)")
    if "Your code stops at t = 0.00 s (step 0): no answer" not in told or ".." in told:
        yield f"of code that does not end: {told}"


def a_question_comes_first(root, build):
    """the first question is asked, tried and answered; it can be skipped"""
    address = (build / "live" / "alone.html").as_uri()
    here = browser.shared()
    here.open(address)
    if here.ask("getComputedStyle(document.getElementById('controls')).display") != "none":
        yield "the settings are open before the question"
    here.click("#question button:nth-of-type(2)")
    here.wait("document.getElementById('question').textContent.includes('Right.')")
    if "beta=2.1" not in hash_of(here) or "blown up" not in said(here):
        yield f"after the guess: {hash_of(here)}, {said(here)}"
    here.click("#question button")
    here.wait("getComputedStyle(document.getElementById('controls')).display !== 'none'")
    here.open(address)
    here.click("#question .skip")
    here.wait("getComputedStyle(document.getElementById('controls')).display !== 'none'")


def an_endless_loop_stops_alone(root, build):
    """a reader's loop without end stops after a second; the solution beside it runs on"""
    folder = build / "live"
    address = live.write_page(folder / "pair.html", "pair", [
        ("yours", folder / "endless.wasm"), ("the solution", folder / "solution.wasm")],
        note="your 1.1", chapter=1).as_uri()
    here = browser.shared()
    for _ in range(9):  # a busy machine may let code look endless
        here.open(f"{address}#scene=box&t=1")
        if "never to end" not in said(here):
            break
    if shown(here).count("gap") != 2 or said(here):
        yield f"without the loop: {shown(here)}, {said(here)}"
    here.click("#scenes [name=pendulum]")
    here.wait(says("never to end"))
    here.wait("time > 1 && playing")
    if "yours: stopped at" not in said(here) or here.ask("panels[1].stopped"):
        yield f"with the loop: {said(here)}"
    here.click("#scenes [name=box]")
    here.wait("entry.name === 'box' && (panels[0].stopped ? $('again').click() : time > 0.5)")


def methods_are_compared(root, build):
    """a table of methods, called as by ./wb compare, frames one; a press on a name sets it"""
    here, folder = browser.shared(), build / "live"
    address = live.write_page(folder / "alone.html", "alone", [
        ("the solution", folder / "solution.wasm")]).as_uri()
    here.open(f"{address}#scene=heavy&t=0.1")
    here.click("#compare")
    here.wait("!document.getElementById('compare').disabled")
    names = here.ask("[...document.querySelectorAll('#methods button')].map(b => b.textContent)")
    known = read(root / "comparison" / "compare.cpp")
    if len(names) < 9 or not all(f'("{name}"' in known for name in names):
        yield f"the methods are {names}"
    best = here.ask("document.querySelector('#methods .best')?.textContent")
    if not best or best.startswith(("10 iter", "30 iter", "direct, velocities")):  # these tear
        yield f"the framed one is {best}"
    here.ask("[...document.querySelectorAll('#methods button')].at(-1).click()")
    here.wait("settings.direct === 1 && settings.substeps === 4 && time > 0.1")
    if "direct=1" not in hash_of(here):
        yield f"the address is {hash_of(here)}"


PROOFS = [it_opens, an_address_is_a_state, texts_say_what_is_shown, settings_work,
          one_looks_into_a_step, causes_are_told_apart, a_question_comes_first,
          an_endless_loop_stops_alone, methods_are_compared]

if __name__ == "__main__":
    skip_without("the live page in a browser",
                 live.missing() + ["chromium"] * (browser.there() is None))
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
