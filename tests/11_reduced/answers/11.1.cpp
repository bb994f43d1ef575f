// mistake "the start is missing: at x = 0 the child has the orientation `start` in its parent":
//         std::cos(half) * link.start + std::sin(half) * link.start_axis ==> std::cos(half) *
//         quat(1, 0, 0, 0) + std::sin(half) * quat(0, link.axis_local.x, link.axis_local.y,
//         link.axis_local.z)
// mistake "the angle in the place of its half: a quaternion has half the angle": link.x / 2 ==>
//         link.x
// mistake "the sign of the angle": link.x / 2 ==> -link.x / 2
// mistake "the parent's orientation is missing: x and start are relative to it": link.q = parent.q
//         * turned ==> link.q = turned
// mistake "the parent's orientation on the right: the first rotation stands on the right": parent.q
//         * turned ==> turned * parent.q
// mistake "the three rotations in reverse: the parent's stands on the left, the first on the right":
//         link.q = parent.q * turned ==> link.q = link.start * rotation(link.x * link.axis_local) *
//         parent.q
// mistake "the rotation by x on the right of start: the axis is that of the parent": const quat
//         turned = std::cos(half) * link.start + std::sin(half) * link.start_axis; ==> const quat
//         turned = link.start * rotation(link.x * link.axis_local);
// mistake "the axis in the world where that of the parent belongs": const quat turned =
//         std::cos(half) * link.start + std::sin(half) * link.start_axis; ==> const quat turned =
//         rotation(link.x * link.a) * link.start;
// mistake "the slider does not slide: its x is a displacement along a": link.d += link.x * link.a;
//         ==>
// mistake "the slider's displacement takes the place of d: it is added to it": link.d += link.x *
//         link.a ==> link.d = link.x * link.a
// mistake "the sign of the slider's displacement": link.d += link.x ==> link.d -= link.x
// mistake "the slider's displacement along the axis of the parent's space: d is in the world":
//         link.d += link.x * link.a ==> link.d += link.x * link.axis_local
// mistake "the slider has the parent's orientation alone, without its start": link.q = parent.q *
//         link.start; link.d ==> link.q = parent.q; link.d
// mistake "the weld is forgotten: it is placed as its parent is, with its start": else if
//         (link.freedom == Freedom::weld) { link.q = parent.q * link.start; } ==>
// mistake "a ball joint is placed like a weld: its q is a coordinate, which stays": else if
//         (link.freedom == Freedom::weld) ==> else
// mistake "the slider is rotated by x as well": link.d += link.x * link.a; ==> link.d += link.x *
//         link.a; link.q = rotation(link.x * link.a) * link.q;
// wrong "the line of link.q is missing": if (link.freedom == Freedom::hinge) ==> if (false)
// mistake "a slider's orientations in the wrong order: the first rotation stands on the right":
//         link.q = parent.q * link.start; link.d ==> link.q = link.start * parent.q; link.d
// mistake "the sine is missing: half the angle itself is right for small angles only":
//         std::sin(half) * link.start_axis ==> half * link.start_axis
// mistake "the cosine is missing": std::cos(half) * link.start ==> link.start
// right by the rotation of the axis: const real half = link.x / 2; ==> ;; const quat turned =
//         std::cos(half) * link.start + std::sin(half) * link.start_axis; ==> const quat turned =
//         rotation(link.x * link.axis_local) * link.start;
// right by the axis in the world: const real half = link.x / 2; ==> ;; const quat turned =
//         std::cos(half) * link.start + std::sin(half) * link.start_axis; link.q = parent.q *
//         turned; ==> link.q = rotation(link.x * link.a) * parent.q * link.start;
// wrong units "adding a pure number to m": link.d += link.x * link.a ==> link.d += link.a

// region 2
// mistake "gamma points outwards: w x (w x d) points to the axis": link.gamma = cross(w, cross(w,
//         link.d)) ==> link.gamma = -cross(w, cross(w, link.d))
// mistake "gamma has one w: an acceleration has two": cross(w, cross(w, link.d)) ==> cross(w,
//         link.d)
// mistake "gamma with the child's w: d is fixed in the parent": link.gamma = cross(w, cross(w,
//         link.d)); ==> link.gamma = cross(w + link.rate * link.a, cross(w + link.rate * link.a,
//         link.d));
// mistake "gamma with the child's w: d is fixed in the parent": link.gamma = cross(w, cross(w,
//         link.d)); ==> const vec3 own = link.freedom == Freedom::hinge ? w + link.rate * link.a :
//         w; link.gamma = cross(own, cross(own, link.d));
// mistake "gamma to the centre in the place of the anchor": cross(w, cross(w, link.d)) ==> cross(w,
//         cross(w, link.d + link.c))
// mistake "gamma is missing": link.gamma = cross(w, cross(w, link.d)) ==> link.gamma = vec3(0)
// mistake "the hinge's own rotation is missing in w": link.w = w + relative ==> link.w = w
// mistake "the parent's rotation is missing in w": link.w = w + relative ==> link.w = relative
// mistake "the sign of the hinge's own rotation": link.w = w + relative ==> link.w = w - relative
// mistake "w with the angle in the place of its rate": link.rate * link.a; ==> link.x * link.a;
// mistake "the rate about the axis of the parent's space: w is in the world": link.rate * link.a;
//         ==> link.rate * link.axis_local;
// mistake "the sign of zeta: w x (a rate), in this order": cross(w, relative) ==> cross(relative,
//         w)
// mistake "zeta is missing: the axis rotates with the parent": link.zeta = cross(w, relative) ==>
//         link.zeta = vec3(0)
// mistake "zeta twice: the factor 2 belongs to the slider": link.zeta = cross(w, relative) ==>
//         link.zeta = real(2) * cross(w, relative)
// mistake "half of the slider's term: it comes twice, once from the axis and once from the lever":
//         += 2 * link.rate ==> += link.rate
// mistake "the slider's term is missing": link.gamma += 2 * link.rate * cross(w, link.a) ==> ;
// mistake "the sign of the slider's term": link.gamma += 2 ==> link.gamma -= 2
// mistake "a slider has w of its own: it does not rotate in its parent": link.w = w; ==> link.w = w
//         + link.rate * link.a;
// mistake "a ball joint gets the parent's w: its own is a coordinate, which stays": else if
//         (link.freedom != Freedom::ball) ==> else
// mistake "the w of slider and weld is not set": link.w = w; if ==> if
// mistake "a slider is treated as a hinge: it does not rotate in its parent": if (link.freedom ==
//         Freedom::hinge) ==> if (link.freedom == Freedom::hinge || link.freedom ==
//         Freedom::slider)
// right with the child's w in zeta: link.zeta = cross(w, relative) ==> link.zeta = cross(w, link.w)
// right with a switch:
  link.gamma = dot(w, link.d) * w - dot(w, w) * link.d;
  switch (link.freedom) {
    case Freedom::hinge:
      link.w = w + link.rate * link.a;
      link.zeta = link.rate * cross(w, link.a);
      break;
    case Freedom::slider:
      link.w = w;
      link.gamma += cross(w, link.a) * (2 * link.rate);
      break;
    case Freedom::ball: break;
    default: link.w = w;
  }
// wrong units "zeta is in 1/s": cross(w, relative) ==> cross(w, link.a)
