"""Draws one picture of a recorded motion as SVG: some of its moments, one over the other.

The camera and the order of painting are those of docs/motion.html, so that the picture looks like
the first sight of the page that plays the motion. The last moment is drawn in full, the earlier
ones pale. Lines of the ground carry the class "ground": the page that holds the picture gives them
a colour, in light and dark.
"""
from math import ceil, cos, hypot, sin

from base.palette import named, rgb
from pictures.solid import (UPRIGHT, clamp, dot, ends_of, ground_of, lines_of, plus, size, sub,
                            things_at, usual_moments)

WIDTH, HEIGHT = 320, 200
FOCAL = 1.6 * WIDTH
PITCH = 0.26
MOVING, EVERY_SECOND, STILL = rgb("solution"), rgb("solution-next"), rgb("still")
LINE = named("line")


# ---- the camera ----------------------------------------------------------------------------------

class View:
    """Looks at all points from the player's first direction."""

    def __init__(self, points):
        low, high = ([choose(p[k] for p in points) for k in range(3)] for choose in (min, max))
        wide, _, deep = sub(high, low)
        yaw = 0.42 if wide >= deep else -1.5708 + 0.42
        sy, cy, sp, cp = sin(yaw), cos(yaw), sin(PITCH), cos(PITCH)
        self.right, self.up, self.back = (cy, 0, -sy), (-sy * sp, cp, -cy * sp), \
            (sy * cp, sp, cy * cp)
        self.centre = tuple((a + b) / 2 for a, b in zip(low, high))
        self.low, self.reach = low[1], 0.75 * hypot(wide, deep) or 1
        self.light = plus(plus((0, 0.85, 0), 0.45, self.back), -0.3, self.right)
        for _ in range(2):  # once for the distance, once with the picture moved to the middle
            away = [sub(p, self.centre) for p in points]
            distance = max(dot(d, self.back) + FOCAL * max(
                abs(dot(d, self.right)) / (0.45 * WIDTH), abs(dot(d, self.up)) / (0.43 * HEIGHT))
                for d in away)
            self.distance = max(distance, 0.01)
            self.eye = plus(self.centre, self.distance, self.back)
            seen = [self.project(p) for p in points]
            for k, axis, sign in ((0, self.right, 1), (1, self.up, -1)):
                middle = (max(p[k] for p in seen) + min(p[k] for p in seen)) / 2
                shift = sign * (middle - (WIDTH, HEIGHT)[k] / 2) * self.distance / FOCAL
                self.centre = plus(self.centre, shift, axis)
        self.eye = plus(self.centre, self.distance, self.back)

    def project(self, p):
        """Where a point stands on the picture, and how far before the camera."""
        d = sub(p, self.eye)
        depth = -dot(d, self.back)
        scale = FOCAL / max(depth, 1e-3 * self.distance)
        return WIDTH / 2 + scale * dot(d, self.right), HEIGHT / 2 - scale * dot(d, self.up), depth


def hides(b, a, eye):
    """Does b hide a? The plane that parts the two best decides, as in the player."""
    if (a.ends and b.ends) or (a.ball and b.ball):
        return size(sub(eye, b.x)) < size(sub(eye, a.x))
    if a.ball:
        return not hides(a, b, eye)
    if b.ball:
        d, nearest = sub(b.x, a.x), a.x
        for n, half in zip(a.axes, a.half):
            nearest = plus(nearest, clamp(dot(n, d), -half, half), n)
        return dot(sub(b.x, nearest), sub(eye, nearest)) > 0
    widest, answer = None, False
    for p, q, q_is_b in ((a, b, True), (b, a, False)):
        for n, half in zip(p.axes, p.half):
            d = dot(n, sub(q.x, p.x))
            reach = sum(abs(dot(axis, n)) * h for axis, h in zip(q.axes, q.half))
            gap = abs(d) - half - reach
            if widest is None or gap > widest:
                widest = gap
                side = (d > 0) - (d < 0)
                answer = (side * dot(n, sub(eye, p.x)) > half) == q_is_b
    return answer


def painters_order(things, eye):
    """Far to near: each thing after all that it hides; a ring is cut where it is entered."""
    things = sorted(things, key=lambda thing: -size(sub(eye, thing.x)))
    under = {id(a): [b for b in things if b is not a and hides(a, b, eye)] for a in things}
    order, seen = [], set()

    def visit(thing):
        if id(thing) not in seen:
            seen.add(id(thing))
            for other in under[id(thing)]:
                visit(other)
            order.append(thing)
    for thing in things:
        visit(thing)
    return order


# ---- painting ------------------------------------------------------------------------------------

def colour(base, light):
    s = 2 * light - 1
    return "#" + "".join(f"{round(c + s * (0.75 * c if s < 0 else 0.55 * (255 - c))):02x}"
                         for c in base)


def path(points, close=True):
    return "M" + "L".join(f"{p[0]:.1f} {p[1]:.1f}" for p in points) + ("z" if close else "")


def faces(body, view, wanted):
    """Outlines of those faces of a box for which wanted(normal, middle) holds."""
    for k in range(3):
        for side in (1, -1):
            n = tuple(side * c for c in body.axes[k])
            x = plus(body.x, body.half[k], n)
            if wanted(n, x):
                i, j = (k + 1) % 3, (k + 2) % 3
                yield n, [plus(plus(x, s * body.half[i], body.axes[i]), t * body.half[j],
                               body.axes[j]) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def draw(thing, view):
    if thing.ends:
        return (f'<path d="{path([view.project(p) for p in thing.ends], False)}" stroke="{LINE}" '
                'stroke-width="1.2" stroke-linecap="round" fill="none"/>')
    base = STILL if thing.still else EVERY_SECOND if thing.odd else MOVING
    if thing.ball:
        x, y, depth = view.project(thing.x)
        r = max(FOCAL * thing.half[0] / depth, 1.5)
        kind = "still" if thing.still else "moving"
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r:.1f}" fill="url(#ball-{kind})"/>'
    parts = []
    for n, points in faces(thing, view, lambda n, x: dot(n, sub(view.eye, x)) > 0):
        light = clamp(0.25 + 0.48 * dot(n, view.light), 0.16, 0.85)
        parts.append(f'<path d="{path([view.project(p) for p in points])}" '
                     f'fill="{colour(base, light)}" stroke="{colour(base, light - 0.1)}"/>')
    return "".join(parts)


def draw_ground(view, slab, ends):
    """A grid of lines that fades outwards, on the slab or as low as anything in the picture."""
    cell = next((c for c in (0.2, 0.5, 1, 2, 5, 10, 20, 50) if view.reach / c < 9), 100)
    n = ceil(1.6 * view.reach / cell) + 2
    if slab:
        k = slab.up()
        i, j = [axis for axis in range(3) if axis != k]
        u, v, origin = slab.axes[i], slab.axes[j], slab.drop(slab.x)
    else:
        u, v, origin = UPRIGHT[0], UPRIGHT[2], (0, view.low, 0)
    from_ = sub(view.centre, origin)
    middle = [round(dot(axis, from_) / cell) * cell for axis in (u, v)]
    fades = [[] for _ in range(5)]
    for a in range(-n, n + 1):
        for b in range(-n, n):
            level = int(5 * (1 - hypot(a, b + 0.5) / n))
            for swap in (False, True) if level >= 0 else ():
                pair = [(a, b), (a, b + 1)] if not swap else [(b, a), (b + 1, a)]
                pair = [(middle[0] + s * cell, middle[1] + t * cell) for s, t in pair]
                if any(abs(s) > ends[0] or abs(t) > ends[1] for s, t in pair):
                    continue
                ab = [view.project(plus(plus(origin, s, u), t, v)) for s, t in pair]
                if min(p[2] for p in ab) > 0.05 * view.distance and any(
                        0 < p[0] < WIDTH and 0 < p[1] < HEIGHT for p in ab):
                    fades[level].append(path(ab, False))
    return "".join(f'<path class="ground" d="{"".join(lines)}" opacity="{0.14 * (k + 1):.2f}"/>'
                   for k, lines in enumerate(fades) if lines)


def draw_shadow(body, view, slab):
    """What a body shades straight below itself, on the ground."""
    def drop(p):
        return slab.drop(p) if slab else (p[0], view.low, p[2])
    if body.ball:
        turns = [i * 0.2618 for i in range(24)]
        outlines = [[plus(plus(body.x, body.half[0] * cos(a), UPRIGHT[2]),
                          body.half[0] * sin(a), UPRIGHT[0]) for a in turns]]
    else:
        outlines = [points for _, points in faces(body, view, lambda n, _: n[1] > 0)]
    return "".join(path([view.project(drop(p)) for p in points]) for points in outlines)


# One for a page that holds pictures: how balls are shaded.
BALLS = '<svg class="balls" width="0" height="0" aria-hidden="true"><defs>' + "".join(
    f'<radialGradient id="ball-{kind}" cx="0.35" cy="0.3" r="0.75">' + "".join(
        f'<stop offset="{i / 3:.2f}" stop-color="{colour(base, light)}"/>'
        for i, light in enumerate((0.9, 0.62, 0.43, 0.22))) + "</radialGradient>"
    for kind, base in (("moving", MOVING), ("still", STILL))) + "</defs></svg>"


# A picture by itself: in light and dark its lines and shadows are seen.
STYLE = (f"<style>.ground{{fill:none;stroke:{named('ground')}}}"
         f".shadow{{fill:{named('shadow')};opacity:0.22}}</style>")


def file_text(run, moments=()):
    """The picture as a file of its own."""
    balls = BALLS[BALLS.index("<defs>"):BALLS.index("</svg>")]
    head, _, rest = picture(run, moments).partition(">")
    return (head.replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"', 1)
            .replace(' aria-hidden="true"', "") + f">{STYLE}{balls}{rest}")


def picture(run, moments=()):
    """The SVG of a run at these moments [s]; of moments of its own choice where none are given."""
    last = len(run["frames"]) - 1
    frames = [min(round(t / run["dt"]), last) for t in moments] or usual_moments(run)
    frames = sorted(set(frames))
    shown = [things_at(run, frame) for frame in frames]
    slab = ground_of(things_at(run, 0))
    slab_at = slab and next(k for k, body in enumerate(things_at(run, 0)) if body.x == slab.x
                            and body.half == slab.half)
    shown = [[body for k, body in enumerate(bodies) if k != slab_at] for bodies in shown]
    points = [p for bodies in shown for body in bodies for p in body.corners()]
    view = View(points + [slab.drop(p) for p in points] if slab else points)
    centres = [body.x for bodies in shown for body in bodies if not body.still]
    layers = [draw_ground(view, slab, ends_of(slab, centres) if slab else (1e9, 1e9))]
    for k, (frame, bodies) in enumerate(zip(frames, shown)):
        whole, final = things_at(run, frame), k == len(frames) - 1
        things = [*[body for body in bodies if final or not body.still], *lines_of(run, whole)]
        shadow = "".join(draw_shadow(body, view, slab) for body in bodies) if final else ""
        layers.append(f'<path class="shadow" d="{shadow}"/>' if shadow else "")
        layers.append(f'<g opacity="{1 if final else 0.3 + 0.2 * k / len(frames):.2f}">' + "".join(
            draw(thing, view) for thing in painters_order(things, view.eye)) + "</g>")
    return (f'<svg class="poster" viewBox="0 0 {WIDTH} {HEIGHT}" stroke-width="0.6" '
            f'stroke-linejoin="round" aria-hidden="true">{"".join(layers)}</svg>')
