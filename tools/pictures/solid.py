"""Bodies of a recorded motion as solid things: where they are at a moment, what is the ground."""
from math import hypot, sqrt

UPRIGHT = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]


# ---- small vectors -------------------------------------------------------------------------------

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def plus(a, s, b):
    """a + s b"""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


def size(a):
    return sqrt(dot(a, a))


def clamp(x, low, high):
    return min(max(x, low), high)


# ---- what is recorded ----------------------------------------------------------------------------

class Thing:
    """A body at one moment, or a line between two of them (then `ends` are its ends)."""

    def __init__(self, x, axes, half, ball=False, still=False, odd=False, ends=None):
        self.x, self.axes, self.half = x, axes, half
        self.ball, self.still, self.odd, self.ends = ball, still, odd, ends

    def corners(self):
        for bits in range(8):
            p = self.x
            for k, n in enumerate(UPRIGHT if self.ball else self.axes):
                p = plus(p, self.half[k] if bits >> k & 1 else -self.half[k], n)
            yield p

    def world(self, local):
        p = self.x
        for s, n in zip(local, self.axes):
            p = plus(p, s, n)
        return p

    def up(self):
        """Which axis of a box points up, or -1."""
        return next((k for k, n in enumerate(self.axes) if abs(n[1]) > 0.7), -1)

    def drop(self, p):
        """The place straight below p on the upper face of this slab."""
        k = self.up()
        n = self.axes[k]
        top = plus(self.x, (1 if n[1] > 0 else -1) * self.half[k], n)
        return p[0], top[1] - (n[0] * (p[0] - top[0]) + n[2] * (p[2] - top[2])) / n[1], p[2]


def turned(w, x, y, z):
    return [(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
            (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
            (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))]


def things_at(run, frame):
    """All bodies in one frame of a run."""
    poses, found = run["frames"][frame], []
    for k, body in enumerate(run["bodies"]):
        q = poses[7 * k + 3:7 * k + 7]
        length = hypot(*q) or 1
        found.append(Thing(tuple(poses[7 * k:7 * k + 3]), turned(*(c / length for c in q)),
                           [edge / 2 for edge in body["size"]], body["kind"] == "ball",
                           is_still(run, k), k % 2 == 1))
    return found


def is_still(run, k):
    first = run["frames"][0][7 * k:7 * k + 7]
    return all(frame[7 * k:7 * k + 7] == first for frame in run["frames"][::4])


def way_out(body, p, q):
    """How much of the way from p, which may lie inside the body, to q leads out of it: 0 .. 1."""
    m, d = sub(p, body.x), sub(q, p)
    if body.ball:
        a, b, c = dot(d, d), dot(m, d), dot(m, m) - body.half[0] ** 2
        return 0 if c > 0 or a == 0 else clamp((sqrt(b * b - a * c) - b) / a, 0, 1)
    ways = []
    for n, half in zip(body.axes, body.half):
        start, step = dot(n, m), dot(n, d)
        if abs(start) > 1.001 * half:
            return 0
        ways.append(1 if step == 0 else ((half if step > 0 else -half) - start) / step)
    return clamp(min(ways), 0, 1)


def lines_of(run, bodies):
    for one, anchor1, two, anchor2 in run["lines"]:
        p, q = bodies[one].world(anchor1), bodies[two].world(anchor2)
        d = sub(q, p)
        begin, end, length = way_out(bodies[one], p, q), 1 - way_out(bodies[two], q, p), size(d)
        if begin < end and length > 0:
            yield Thing(plus(p, (begin + end) / 2, d), [tuple(c / length for c in d)],
                        [(end - begin) / 2 * length], ends=[plus(p, begin, d), plus(p, end, d)])


def ground_of(bodies):
    """The thin static slab beside which all else is small, or None."""
    moving = [p for body in bodies if not body.still for p in body.corners()]
    if not moving:
        return None
    extent = max(max(p[k] for p in moving) - min(p[k] for p in moving) for k in (0, 2))
    for body in bodies:
        k = body.up() if body.still and not body.ball else -1
        across = min(half for i, half in enumerate(body.half) if i != k)
        if k >= 0 and body.half[k] <= 0.1 * across and 2 * across >= 0.6 * extent:
            return body
    return None


def ends_of(slab, points):
    """How far a slab reaches along its two sides; where points lie beyond and above, it goes on."""
    sides = [k for k in range(3) if k != slab.up()]
    beyond = [p for p in points if any(
        abs(dot(slab.axes[k], sub(p, slab.x))) > slab.half[k] for k in sides)]
    if beyond and all(p[1] > slab.drop(p)[1] for p in beyond):
        return 1e9, 1e9
    return tuple(slab.half[k] for k in sides)


def usual_moments(run):
    """Three frames: the first, the farthest that all has moved, and half-way between.

    What travels out of the neighbourhood of the first frame counts until it leaves it.
    """
    first = run["frames"][0]
    bodies = range(len(run["bodies"]))
    solid = things_at(run, 0)
    ground = ground_of(solid)
    points = [p for body in solid if body is not ground for p in body.corners()]
    scale = max(max(p[k] for p in points) - min(p[k] for p in points) for k in range(3))
    moved = []
    for frame in run["frames"]:
        ways = [size(sub(frame[7 * k:7 * k + 3], first[7 * k:7 * k + 3])) for k in bodies]
        if max(ways) > 2.5 * scale:
            break
        moved.append(sum(ways))
    last = moved.index(max(moved))
    return [0, next(i for i, way in enumerate(moved) if way >= moved[last] / 2), last]
