"""The moving picture of README.md: a crate falls onto a bridge of hinged planks.

    moving.py --motion bridge.motion.json --result FILE.svg

Chapter 8's program records the bridge; the result is kept as plots/moving.svg. The outline of every
face is animated through the frames of the recording by elements of SVG itself (SMIL), so it plays
wherever a page shows an image, without a script. Readers who ask their system for less motion see
one moment, and so do those whose program cannot play it.
"""
import json

import files
import style

from base.palette import named, rgb
from pictures import poster, solid

SECONDS, STILL = 4, 0.7  # how much is played; the moment of the still picture [s]
FADE = 8  # frames in which the last moment fades out, and as many in which the first fades in
SCALE = 5  # units of the picture in a unit of the poster
TOP, WIDTH, HEIGHT = 55, 1600, 890  # the window, in units of the picture
CELL, CELLS = 1, 9  # of the grid on the ground: edge [m], and how many on each side of the middle


def place(point):
    """A point of the poster in whole units of the picture."""
    return round(SCALE * point[0]), round(SCALE * point[1])


def path(points, closed=True):
    """A path through projected points, in steps from one to the next."""
    spots = [place(p) for p in points]
    steps = " ".join(f"{x - a} {y - b}" for (a, b), (x, y) in zip(spots, spots[1:]))
    return f"M{spots[0][0]} {spots[0][1]}l{steps}".replace(" -", "-") + "z" * closed


def animated(attribute, values):
    """The element that takes an attribute through these values, again and again."""
    return (f'<animate attributeName="{attribute}" dur="{SECONDS}s" repeatCount="indefinite" '
            f'values="{";".join(values)}"/>')


class Scene:
    """The recorded frames, seen from one place."""

    def __init__(self, run):
        self.run, self.now = run, round(STILL / run["dt"])
        count = round(SECONDS / run["dt"])
        frames = [*range(count - FADE), *[0] * (FADE + 1)]
        self.shots = [solid.things_at(run, k)[1:] for k in frames]  # without the ground
        self.fading = [1 - FADE * k / count for k in (2, 1.2, 1)]
        self.view = poster.View([p for bodies in self.shots for body in bodies
                                 for p in body.corners()])

    def faces(self, body):
        """The faces of a body that are seen: in each frame its light and its outline."""
        shown = [list(poster.faces(bodies[body], self.view, lambda n, x: solid.dot(
            n, solid.sub(self.view.eye, x)) > 0)) for bodies in self.shots]
        if len({len(faces) for faces in shown}) != 1:
            style.trouble(f"body {body} turns another side to the eye")
        for frames in zip(*shown):
            yield [(solid.clamp(0.25 + 0.48 * solid.dot(n, self.view.light), 0.16, 0.85),
                    path([self.view.project(p) for p in points])) for n, points in frames]

    def drawn(self, body, plays):
        """A body's faces, at the moment of the still picture or through all frames."""
        crate, still = len(self.shots[0]) - 1, self.shots[0][body].still
        base = (poster.STILL if still else rgb("orange") if body == crate else
                poster.EVERY_SECOND if body % 2 else poster.MOVING)
        for frames in self.faces(body):
            light, outline = frames[self.now]
            lights = [poster.colour(base, light) for light, _ in frames[::6]]
            inside = animated("d", [outline for _, outline in frames]) + animated(
                "fill", lights) if plays and not still else ""
            yield (f'<path d="{outline}" fill="{poster.colour(base, light)}"'
                   + (f">{inside}</path>" if inside else "/>"))

    def hinges(self, plays):
        """A dot for every hinge, at the front edge of its plank."""
        def dots(bodies):
            return "".join("M{} {}h0".format(*place(self.view.project(bodies[body - 1].world(
                (x, y, bodies[body - 1].half[2]))))) for _, _, body, (x, y, _) in ends)
        ends = self.run["lines"][1::2]
        inside = animated("d", map(dots, self.shots)) if plays else ""
        return f'<path class="hinge" d="{dots(self.shots[self.now])}">{inside}</path>'

    def layers(self):
        """Bodies from far to near: static ones behind, moving ones, static ones in front."""
        now = self.shots[self.now]
        order = [now.index(thing) for thing in poster.painters_order(now, self.view.eye)]
        moving = [body for body in order if not now[body].still]
        at = order.index(moving[0])
        return order[:at], moving, [body for body in order[at:] if now[body].still]

    def group(self, bodies, name, plays=False):
        return "".join(f'<g id="{name}-{body}">{"".join(self.drawn(body, plays))}</g>'
                       for body in bodies)

    def floor(self):
        """A grid that fades outwards, and the shadow of the bridge."""
        def on_ground(x, z):
            return self.view.project((x, self.view.low, z))
        x, _, z = self.view.centre
        ends = [((a * CELL, -CELLS * CELL), (a * CELL, CELLS * CELL))
                for a in range(-CELLS, CELLS + 1)]
        grid = "".join(path([on_ground(x + a, z + b) for a, b in pair], False)
                       for line in ends for pair in (line, [end[::-1] for end in line]))
        corners = [p for body in self.shots[self.now][:-1] for p in body.corners()]
        (left, _, far), (right, _, near) = ([choose(p[k] for p in corners) for k in range(3)]
                                            for choose in (min, max))
        shadow = path([on_ground(*p) for p in ((left, far), (right, far), (right, near),
                                               (left, near))])
        middle = place(on_ground(x, z))
        stops = "".join(f'<stop offset="{at}" stop-color="{named("ground")}" '
                        f'stop-opacity="{opacity}"/>' for at, opacity in ((0, 0.8), (1, 0)))
        return (f'<radialGradient id="fade" gradientUnits="userSpaceOnUse" cx="0" cy="0" '
                f'r="{WIDTH // 2}" '
                'gradientTransform="translate({} {}) scale(1.1 .5)">'.format(*middle) + stops +
                f'</radialGradient><path class="grid" d="{grid}"/>'
                f'<path class="shadow" d="{shadow}"/>')


def picture(run):
    """The SVG."""
    scene = Scene(run)
    behind, moves, front = scene.layers()
    window = f'x="1" y="{TOP + 1}" width="{WIDTH - 2}" height="{HEIGHT - 2}" rx="26"'
    sheet = (f".card{{fill:{named('card')};stroke:{named('card-edge')};stroke-width:2}}"
             ".grid{fill:none;stroke:url(#fade);stroke-width:2}"
             f".shadow{{fill:{named('shadow')};opacity:.2}}"
             f".body{{stroke:{named('shadow')};stroke-opacity:.35;stroke-width:2;"
             "stroke-linejoin:round}"
             f".hinge{{fill:none;stroke:{named('yellow')};stroke-width:17;"
             "stroke-linecap:round;stroke-opacity:1}"
             ".still{display:none}"
             "@media(prefers-reduced-motion:reduce){.plays{display:none}.still{display:inline}}")
    moving = "".join(
        f'<g id="{name}" class="{name}">{scene.group(moves, name, plays)}{scene.hinges(plays)}'
        + (f'<animate attributeName="opacity" dur="{SECONDS}s" repeatCount="indefinite" '
           'values="1;1;0;0;1" keyTimes="0;{:.3f};{:.3f};{:.3f};1"/>'.format(*scene.fading)
           if plays else "") + "</g>"
        for name, plays in (("plays", True), ("still", False)))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH // 2}" height="{HEIGHT // 2}" '
            f'viewBox="0 {TOP} {WIDTH} {HEIGHT}"><style>{sheet}</style>'
            f'<clipPath id="window"><rect {window}/></clipPath><rect class="card" {window}/>'
            f'<g id="scene" class="body" clip-path="url(#window)">{scene.floor()}'
            f'{scene.group(behind, "static")}{moving}{scene.group(front, "static")}</g></svg>')


def main():
    asked = style.arguments(__doc__.split("\n")[0], motion="the recorded bridge",
                            result="file of the picture")
    run = json.loads(asked.motion.read_text(encoding="utf-8"))
    asked.result.write_text(files.compact(picture(run)), encoding="utf-8")


style.run(main)
