// mistake "the force that the parent's motion needs is missing: U^T times it": link.over_D *
//         (link.k - felt) ==> link.over_D * link.k
// mistake "the sign of U^T times the parent's motion": link.over_D * (link.k - felt) ==>
//         link.over_D * (link.k + felt)
// mistake "k is missing": link.over_D * (link.k - felt) ==> -link.over_D * felt
// mistake "the sign of the whole acceleration": link.over_D * (link.k - felt) ==> link.over_D *
//         (felt - link.k)
// mistake "1/D is missing": link.over_D * (link.k - felt) ==> link.k - felt
// mistake "D in the place of 1/D": link.over_D * (link.k - felt) ==> link.D * (link.k - felt)
// mistake "1/D without `added`: over_D has it": link.over_D * (link.k - felt) ==> (link.k - felt) /
//         link.D
// mistake "tau in the place of k": link.over_D * (link.k - felt) ==> link.over_D * (link.tau -
//         felt)
// mistake "U^T without the linear part": dot(link.Uw, link.alpha) + dot(link.Uv, link.a_A) ==>
//         dot(link.Uw, link.alpha)
// mistake "U^T without the angular part": dot(link.Uw, link.alpha) + dot(link.Uv, link.a_A) ==>
//         dot(link.Uv, link.a_A)
// mistake "the parent's own accelerations in the place of the child's before S": dot(link.Uw,
//         link.alpha) + dot(link.Uv, link.a_A) ==> dot(link.Uw, parent.alpha) + dot(link.Uv,
//         parent.a_A)
// mistake "Uw and Uv are exchanged": dot(link.Uw, link.alpha) + dot(link.Uv, link.a_A) ==>
//         dot(link.Uv, link.alpha) + dot(link.Uw, link.a_A)
// mistake "the acceleration along S is not added": (link.freedom == Freedom::hinge ? link.alpha :
//         link.a_A) += link.acceleration * link.a; ==>
// mistake "it is added with the other sign": link.a_A) += link.acceleration ==> link.a_A) -=
//         link.acceleration
// mistake "hinge and slider are exchanged": link.freedom == Freedom::hinge ? link.alpha : link.a_A
//         ==> link.freedom == Freedom::hinge ? link.a_A : link.alpha
// mistake "the slider's acceleration is added to alpha": (link.freedom == Freedom::hinge ?
//         link.alpha : link.a_A) += ==> link.alpha +=
// mistake "the axis of the parent's space": link.acceleration * link.a; ==> link.acceleration *
//         link.axis_local;
// mistake "the force of a held joint without D times its acceleration": felt + link.D *
//         link.acceleration - link.k ==> felt - link.k
// mistake "the force of a held joint without the parent's motion": felt + link.D * ==> link.D *
// mistake "the force of a held joint without k": + link.D * link.acceleration - link.k ==> + link.D
//         * link.acceleration
// mistake "k has the other sign in the force of a held joint": link.acceleration - link.k ==>
//         link.acceleration + link.k
// mistake "the missing force takes the place of tau: it is added to it": link.tau += felt ==>
//         link.tau = felt
// mistake "tau comes twice: Eq. 11-16 is all of it": link.tau += felt ==> link.tau += link.tau +
//         felt
// mistake "a held joint accelerates as if it were free": if (link.held) { ==> if (false) {
// mistake "held and not held exchanged": if (link.held) ==> if (!link.held)
// mistake "divided by over_D, which is 1/D already": link.over_D * (link.k - felt) ==> (link.k -
//         felt) / link.over_D
// mistake "D divided by the acceleration": link.D * link.acceleration - link.k ==> link.D /
//         link.acceleration - link.k
// right by kind:
  const bool hinge = link.freedom == Freedom::hinge;
  const real missing = link.k - dot(link.Uw, link.alpha) - dot(link.Uv, link.a_A);
  if (!link.held) link.acceleration = missing * link.over_D;
  else link.tau += link.D * link.acceleration - missing;
  if (hinge) link.alpha += link.acceleration * link.a;
  else link.a_A += link.acceleration * link.a;
// right as Eq. 11-16 has it:
  const bool hinge = link.freedom == Freedom::hinge;
  vec3& own = hinge ? link.alpha : link.a_A;
  if (!link.held)
    link.acceleration =
        link.over_D * (link.k - dot(link.Uw, link.alpha) - dot(link.Uv, link.a_A));
  own += link.acceleration * link.a;
  if (link.held)
    link.tau = hinge ? dot(link.a, link.n + link.J * link.alpha + link.H * link.a_A)
                     : dot(link.a, link.f + link.alpha * link.H + link.M * link.a_A);
// wrong units "Units": link.over_D * (link.k - felt) ==> link.k - felt
