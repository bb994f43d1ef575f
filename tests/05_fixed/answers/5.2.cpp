// wrong drawn-threshold: return ==> if (length(push) < real(1e-9)) return {vec3(0), couple / h};
//         return
// wrong "force.y holds the value of force.z; force.z holds the value of force.y": impulse[1], impulse[2]
//         ==> impulse[2], impulse[1]
// wrong impulse-for-force:
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};
// wrong "the force begins with impulse[1]: the three of the point are impulse[0]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[1], impulse[2], impulse[3]
// wrong "an index outside an array of 6 numbers": impulse[3], impulse[4], impulse[5] ==>
//         impulse[4], impulse[5], impulse[6]
// wrong threes-exchanged: couple ==> push ;; push ==> couple
// wrong impulse-for-force (torque): couple / h ==> couple
// wrong "the torque begins with impulse[2]": [3] ==> [2], impulse[3] ;; [4], impulse[5] ==> [4]
// wrong "in force.z and torque.z alone: 0 in every case": impulse[2] ==> 0 ;; impulse[5] ==> 0
// wrong never-set: const vec3 push(impulse[0], impulse[1], impulse[2]), couple(impulse[3],
//         impulse[4], impulse[5]); return {push / h, couple / h} ==> std::array<real, 6> sums; for
//         (int i = 0; i < 6; ++i) sums[i] += impulse[i] / h; return {vec3(sums[0], sums[1],
//         sums[2]), vec3(sums[3], sums[4], sums[5])}
// wrong "1/h is cut to a whole number":
// expects: holds at h = 0.25
  const int rate = 1 / h;
  return {real(rate) * vec3(impulse[0], impulse[1], impulse[2]),
          real(rate) * vec3(impulse[3], impulse[4], impulse[5])};
// wrong units "the force is in kg m/s and should be in kg m/s^2: a time too many: is a division by h missing?":
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};

// region 2
// wrong drawn-threshold: return ==> if (length(from - to) < real(1e-6)) return load; return
// wrong by-entries: cross(from - to, load.force) ==> (from - to) * load.force
// wrong exchanged: load.force, load.torque + cross(from - to, load.force) ==> load.torque +
//         cross(from - to, load.force), load.force
// wrong few-digits: cross(from - to, load.force) ==> vec3(cross(glm::vec3(from - to),
//         glm::vec3(load.force)))
// wrong lever-torque: cross(from - to, load.force) ==> cross(from - to, load.torque)
// wrong lever-torque + without-old-torque: load.torque + cross(from - to, load.force) ==>
//         cross(from - to, load.torque)
// wrong "a short lever is ignored": return ==> if (length(from - to) < real(0.1)) return load;
//         return
// expects: points close together
// wrong sign-new-share-x: from - to ==> to - from
// wrong unit-lever: from - to ==> normalize(from - to)
// wrong without-old-torque: load.torque + ==>
// right about by a matrix: + cross(from - to, load.force) ==> - skew(load.force) * (from - to)
// right about with the force first: return {load.force, load.torque + cross(from - to,
//         load.force)}; ==> Reaction moved = load; moved.torque += cross(load.force, to - from);
//         return moved;

// region 3
// wrong drawn-side: length(load.force) > strength.force ==> length(load.force) > strength.force +
//         real(1e-6)
// wrong "at its bound a weld still holds: > and not >=": > strength ==> >= strength ;; > strength
//         ==> >= strength
// expects: 10 N of 10, at the bound
// wrong by-one-entry: length(load.force) ==> load.force.x ;; length(load.torque) ==> load.torque.x
// wrong by-shares: > strength.force || ==> / strength.force + ;; > strength.torque ==> /
//         strength.torque > 1
// wrong bound-force: > strength.torque ==> > strength.force
// wrong "the largest entry where the length belongs, and entries may be negative": return length
//         ==> const auto largest = [](const vec3& a) { return glm::max(a.x, glm::max(a.y, a.z)); };
//         return largest ;; length ==> largest
// expects: 12 N of 10 downwards
// wrong by-the-product: > strength.force || ==> * ;; torque; ==> force * strength.torque;
// wrong in-whole-numbers: return ==> const int force = ;; > strength.force || ==> , torque = ;; >
//         strength ==> ; return force > strength.force || torque > strength
// wrong "`and` where `or` belongs: one of the two is enough to break a weld": force || ==> force &&
// expects: 12 N of 10, 0 N m of 2
// right breaks by squares:
  // Squares in the place of lengths: no root is drawn.
  const auto over = [](const vec3& a, real bound) { return dot(a, a) > bound * bound; };
  return over(load.force, strength.force) || over(load.torque, strength.torque);
// right breaks by the greater share:
  return std::max(length(load.force) / strength.force, length(load.torque) / strength.torque) > 1;
