// mistake "this is the impulse: a force is the impulse over the step h": {push / h ==> {push ;;
//         couple / h ==> couple
// mistake "this is the impulse: a force is the impulse over the step h (force)": {push / h ==>
//         {push
// mistake "this is the impulse: a force is the impulse over the step h (torque)": couple / h ==>
//         couple
// mistake "times h where it must be divided by h": {push / h ==> {push * h ;; couple / h ==> couple
//         * h
// mistake "times h where it must be divided by h (force)": {push / h ==> {push * h
// mistake "times h where it must be divided by h (torque)": couple / h ==> couple * h
// mistake "the sign: return the load on body 2, on which +lambda acts": {push / h ==> {push / -h ;;
//         couple / h ==> couple / -h
// mistake "the sign: return the load on body 2, on which +lambda acts (force)": {push / h ==> {push
//         / -h
// mistake "the sign: return the load on body 2, on which +lambda acts (torque)": couple / h ==>
//         couple / -h
// mistake "divided by h twice": {push / h ==> {push / h / h ;; couple / h ==> couple / h / h
// mistake "divided by h twice (force)": {push / h ==> {push / h / h
// mistake "divided by h twice (torque)": couple / h ==> couple / h / h
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s": {push / h ==> {push
//         * real(60) ;; couple / h ==> couple * real(60)
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s (force)": {push / h
//         ==> {push * real(60)
// mistake "60 in the place of 1/h: a step may have another length than 1/60 s (torque)": couple / h
//         ==> couple * real(60)
// mistake "1/h is cut to a whole number: an int has no fraction": return ==> const real rate =
//         int(1 / h); return ;; {push / h ==> {push * rate ;; couple / h ==> couple * rate
// mistake "1/h is cut to a whole number: an int has no fraction (force)": return ==> const real
//         rate = int(1 / h); return ;; {push / h ==> {push * rate
// mistake "1/h is cut to a whole number: an int has no fraction (torque)": return ==> const real
//         rate = int(1 / h); return ;; couple / h ==> couple * rate
// mistake "the two threes are exchanged: the point's rows come first": couple ==> push ;; push ==>
//         couple
// mistake "every second number: the point has the first three and the lock the rest": impulse[0],
//         impulse[1], impulse[2] ==> impulse[0], impulse[2], impulse[4] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[1], impulse[3], impulse[5]
// mistake "the impulses from the last to the first: those of the point come first": impulse[0],
//         impulse[1], impulse[2] ==> impulse[5], impulse[4], impulse[3] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[2], impulse[1], impulse[0]
// mistake "the torque begins with impulse[0]: the three of the point are impulse[0] to impulse[2],
//         those of the lock impulse[3] to impulse[5]": couple(impulse[3], impulse[4], impulse[5]
//         ==> couple(impulse[0], impulse[1], impulse[2]
// mistake "the torque begins with impulse[1]: the three of the point are impulse[0] to impulse[2],
//         those of the lock impulse[3] to impulse[5]": couple(impulse[3], impulse[4], impulse[5]
//         ==> couple(impulse[1], impulse[2], impulse[3]
// mistake "the torque begins with impulse[2]: the three of the point are impulse[0] to impulse[2],
//         those of the lock impulse[3] to impulse[5]": couple(impulse[3], impulse[4], impulse[5]
//         ==> couple(impulse[2], impulse[3], impulse[4]
// mistake "the force begins with impulse[1], the torque with impulse[0]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[1], impulse[2], impulse[3] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[0], impulse[1], impulse[2]
// mistake "the force begins with impulse[1], the torque with impulse[1]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[1], impulse[2], impulse[3] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[1], impulse[2], impulse[3]
// mistake "the force begins with impulse[1], the torque with impulse[2]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[1], impulse[2], impulse[3] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[2], impulse[3], impulse[4]
// mistake "the force begins with impulse[1]: the three of the point are impulse[0] to impulse[2],
//         those of the lock impulse[3] to impulse[5]": impulse[0], impulse[1], impulse[2] ==>
//         impulse[1], impulse[2], impulse[3]
// mistake "the force begins with impulse[2], the torque with impulse[0]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[2], impulse[3], impulse[4] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[0], impulse[1], impulse[2]
// mistake "the force begins with impulse[2], the torque with impulse[1]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[2], impulse[3], impulse[4] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[1], impulse[2], impulse[3]
// mistake "the force begins with impulse[2], the torque with impulse[2]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[2], impulse[3], impulse[4] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[2], impulse[3], impulse[4]
// mistake "the force begins with impulse[2]: the three of the point are impulse[0] to impulse[2],
//         those of the lock impulse[3] to impulse[5]": impulse[0], impulse[1], impulse[2] ==>
//         impulse[2], impulse[3], impulse[4]
// mistake "the force begins with impulse[3], the torque with impulse[1]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[3], impulse[4], impulse[5] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[1], impulse[2], impulse[3]
// mistake "the force begins with impulse[3], the torque with impulse[2]: the three of the point are
//         impulse[0] to impulse[2], those of the lock impulse[3] to impulse[5]": impulse[0],
//         impulse[1], impulse[2] ==> impulse[3], impulse[4], impulse[5] ;; couple(impulse[3],
//         impulse[4], impulse[5] ==> couple(impulse[2], impulse[3], impulse[4]
// mistake "the force begins with impulse[3]: the three of the point are impulse[0] to impulse[2],
//         those of the lock impulse[3] to impulse[5]": impulse[0], impulse[1], impulse[2] ==>
//         impulse[3], impulse[4], impulse[5]
// mistake "force and torque are added up: each has its own three numbers": {push / h, couple / h}
//         ==> {(push + couple) / h, (push + couple) / h}
// mistake "the torque has a cross product in it: about the anchor the lock's own three are the
//         whole torque": couple / h ==> cross(push, couple) / h
// wrong drawn-threshold: return ==> if (length(push) < real(1e-9)) return {vec3(0), couple / h};
//         return
// wrong "force.y holds the value of force.z; force.z holds the value of force.y": impulse[1], impulse[2]
//         ==> impulse[2], impulse[1]
// wrong "an index outside an array of 6 numbers": impulse[3], impulse[4], impulse[5] ==>
//         impulse[4], impulse[5], impulse[6]
// wrong "force.z and torque.z are zero in every case": impulse[2] ==> 0 ;; impulse[5] ==> 0
// wrong never-set: const vec3 push(impulse[0], impulse[1], impulse[2]), couple(impulse[3],
//         impulse[4], impulse[5]); return {push / h, couple / h} ==> std::array<real, 6> sums; for
//         (int i = 0; i < 6; ++i) sums[i] += impulse[i] / h; return {vec3(sums[0], sums[1],
//         sums[2]), vec3(sums[3], sums[4], sums[5])}
// wrong units "the force is in kg m/s and should be in kg m/s^2: a time too many: is a division by h missing?":
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};

// region 2
// mistake "the sign of the new term, (from - to) x F: from and to are exchanged, or the two sides
//         of the cross product": from - to ==> to - from
// mistake "the torque is as it was: a force beside the point turns, too": + cross(from - to,
//         load.force) ==>
// mistake "`to` is forgotten: the lever runs from `to` to `from`": from - to ==> from
// mistake "`to` is forgotten, and the sign of the new term": from - to ==> -from
// mistake "`from` is forgotten: the lever runs from `to` to `from`": from - to ==> -to
// mistake "`from` is forgotten, and the sign of the new term": from - to ==> to
// mistake "the lever is a difference: from - to": from - to ==> from + to
// mistake "a short lever is ignored: it gives a torque, too": return ==> if (length(from - to) <
//         real(0.1)) return load; return
// expects: points close together
// mistake "the lever is made a unit vector: it keeps its length": from - to ==> normalize(from -
//         to)
// mistake "the new term is added twice": from - to ==> real(2) * (from - to)
// mistake "the force has the lever, not the torque: (from - to) x F": cross(from - to, load.force)
//         ==> cross(from - to, load.torque)
// mistake "the force has the lever, not the torque: (from - to) x F; and the old torque is lost:
//         the new term is added to it": load.torque + cross(from - to, load.force) ==> cross(from -
//         to, load.torque)
// mistake "the old torque is lost: the new term is added to it": load.torque + ==>
// mistake "the sign of the old torque: the new term is added to it": load.torque ==> -load.torque
// mistake "entry times entry: the lever and the force have a cross product, cross(from - to, F)":
//         cross(from - to, load.force) ==> (from - to) * load.force
// mistake "the length of the lever times the force: they have a cross product, cross(from - to,
//         F)": cross(from - to, load.force) ==> length(from - to) * load.force
// mistake "the force is lost: it stays the same": {load.force ==> {vec3(0)
// mistake "the sign of the force: it stays the same": {load.force ==> {-load.force
// mistake "the new term belongs to the torque: the force stays": {load.force ==> {load.force +
//         cross(from - to, load.force)
// mistake "a term is added to the force: it stays the same": {load.force ==> {load.force +
//         cross(from - to, load.torque)
// mistake "force and torque are added up: the force stays the same": {load.force ==> {load.force +
//         load.torque
// mistake "the force is the torque: it stays the same": {load.force ==> {load.torque
// mistake "force and torque are exchanged: {force, torque}": load.force, load.torque + cross(from -
//         to, load.force) ==> load.torque + cross(from - to, load.force), load.force
// wrong drawn-threshold: return ==> if (length(from - to) < real(1e-6)) return load; return
// wrong few-digits: cross(from - to, load.force) ==> vec3(cross(glm::vec3(from - to),
//         glm::vec3(load.force)))
// right about by a matrix: + cross(from - to, load.force) ==> - skew(load.force) * (from - to)
// right about with the force first: return {load.force, load.torque + cross(from - to,
//         load.force)}; ==> Reaction moved = load; moved.torque += cross(load.force, to - from);
//         return moved;

// region 3
// mistake "`and` where `or` belongs: one of the two is enough to break a weld": force || ==> force
//         &&
// expects: 12 N of 10, 0 N m of 2
// mistake "one of the two and not the other: it breaks with both as well, || and not !=":
//         length(load.force) > strength.force || length(load.torque) > strength.torque ==>
//         (length(load.force) > strength.force) != (length(load.torque) > strength.torque)
// mistake "the torque is ignored": || length(load.torque) > strength.torque ==>
// mistake "the force is ignored": length(load.force) > strength.force || ==>
// mistake "the other way round: true means that it breaks": length(load.force) > strength.force ||
//         length(load.torque) > strength.torque ==> !(length(load.force) > strength.force ||
//         length(load.torque) > strength.torque)
// mistake "the comparison is turned round: a load above its bound breaks a weld": > strength ==> <
//         strength ;; > strength ==> < strength
// mistake "force and torque are exchanged: each has a bound of its own": strength.force ==>
//         strength.torque ;; > strength.torque; ==> > strength.force;
// mistake "the torque is compared with the bound of the force": > strength.torque ==> >
//         strength.force
// mistake "the force is compared with the bound of the torque": > strength.force ==> >
//         strength.torque
// mistake "newtons and newton metres do not add up: each has a bound of its own":
//         length(load.force) > strength.force || length(load.torque) > strength.torque ==>
//         length(load.force) + length(load.torque) > strength.force + strength.torque
// mistake "the fractions of the two bounds are added up: each is compared separately": >
//         strength.force || ==> / strength.force + ;; > strength.torque ==> / strength.torque > 1
// mistake "force times torque is compared: each has a bound of its own": > strength.force || ==> *
//         ;; torque; ==> force * strength.torque;
// mistake "it never breaks": length(load.force) > strength.force || length(load.torque) >
//         strength.torque ==> false
// mistake "it always breaks": length(load.force) > strength.force || length(load.torque) >
//         strength.torque ==> true
// mistake "at its bound a weld still holds: > and not >=": > strength ==> >= strength ;; > strength
//         ==> >= strength
// expects: 10 N of 10, at the bound
// mistake "at its bound a weld still holds: > and not >= (force)": > strength.force ==> >=
//         strength.force
// mistake "at its bound a weld still holds: > and not >= (torque)": > strength.torque ==> >=
//         strength.torque
// mistake "the largest entry where the length belongs: the strength of a weld is independent of the
//         world's axes": return ==> const auto size = [](const vec3& a) { return
//         glm::max(std::abs(a.x), glm::max(std::abs(a.y), std::abs(a.z))); }; return ;;
//         length(load.force) ==> size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "the largest entry where the length belongs: the strength of a weld is independent of the
//         world's axes (force)": return ==> const auto size = [](const vec3& a) { return
//         glm::max(std::abs(a.x), glm::max(std::abs(a.y), std::abs(a.z))); }; return ;;
//         length(load.force) ==> size(load.force)
// mistake "the largest entry where the length belongs: the strength of a weld is independent of the
//         world's axes (torque)": return ==> const auto size = [](const vec3& a) { return
//         glm::max(std::abs(a.x), glm::max(std::abs(a.y), std::abs(a.z))); }; return ;;
//         length(load.torque) ==> size(load.torque)
// mistake "the largest entry where the length belongs, and entries may be negative": return ==>
//         const auto size = [](const vec3& a) { return glm::max(a.x, glm::max(a.y, a.z)); }; return
//         ;; length(load.force) ==> size(load.force) ;; length(load.torque) ==> size(load.torque)
// expects: 12 N of 10 downwards
// mistake "the largest entry where the length belongs, and entries may be negative (force)": return
//         ==> const auto size = [](const vec3& a) { return glm::max(a.x, glm::max(a.y, a.z)); };
//         return ;; length(load.force) ==> size(load.force)
// mistake "the largest entry where the length belongs, and entries may be negative (torque)":
//         return ==> const auto size = [](const vec3& a) { return glm::max(a.x, glm::max(a.y,
//         a.z)); }; return ;; length(load.torque) ==> size(load.torque)
// mistake "the sum of the entries where the length belongs": return ==> const auto size = [](const
//         vec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }; return ;;
//         length(load.force) ==> size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "the sum of the entries where the length belongs (force)": return ==> const auto size =
//         [](const vec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }; return ;;
//         length(load.force) ==> size(load.force)
// mistake "the sum of the entries where the length belongs (torque)": return ==> const auto size =
//         [](const vec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }; return ;;
//         length(load.torque) ==> size(load.torque)
// mistake "the sum of the entries where the length belongs, and entries may be negative": return
//         ==> const auto size = [](const vec3& a) { return a.x + a.y + a.z; }; return ;;
//         length(load.force) ==> size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "the sum of the entries where the length belongs, and entries may be negative (force)":
//         return ==> const auto size = [](const vec3& a) { return a.x + a.y + a.z; }; return ;;
//         length(load.force) ==> size(load.force)
// mistake "the sum of the entries where the length belongs, and entries may be negative (torque)":
//         return ==> const auto size = [](const vec3& a) { return a.x + a.y + a.z; }; return ;;
//         length(load.torque) ==> size(load.torque)
// mistake "the square of the length beside the bound itself: take length(...)": return ==> const
//         auto size = [](const vec3& a) { return dot(a, a); }; return ;; length(load.force) ==>
//         size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "the square of the length beside the bound itself: take length(...) (force)": return ==>
//         const auto size = [](const vec3& a) { return dot(a, a); }; return ;; length(load.force)
//         ==> size(load.force)
// mistake "the square of the length beside the bound itself: take length(...) (torque)": return ==>
//         const auto size = [](const vec3& a) { return dot(a, a); }; return ;; length(load.torque)
//         ==> size(load.torque)
// mistake "the length is cut to a whole number: an int has no fraction": return ==> const auto size
//         = [](const vec3& a) { return real(int(length(a))); }; return ;; length(load.force) ==>
//         size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "the length is cut to a whole number: an int has no fraction (force)": return ==> const
//         auto size = [](const vec3& a) { return real(int(length(a))); }; return ;;
//         length(load.force) ==> size(load.force)
// mistake "the length is cut to a whole number: an int has no fraction (torque)": return ==> const
//         auto size = [](const vec3& a) { return real(int(length(a))); }; return ;;
//         length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs": return ==> const auto size = [](const vec3& a) {
//         return a.x; }; return ;; length(load.force) ==> size(load.force) ;; length(load.torque)
//         ==> size(load.torque)
// mistake "one entry where the length belongs (force)": return ==> const auto size = [](const vec3&
//         a) { return a.x; }; return ;; length(load.force) ==> size(load.force)
// mistake "one entry where the length belongs (torque)": return ==> const auto size = [](const
//         vec3& a) { return a.x; }; return ;; length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs": return ==> const auto size =
//         [](const vec3& a) { return std::abs(a.x); }; return ;; length(load.force) ==>
//         size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs (force)": return ==> const auto
//         size = [](const vec3& a) { return std::abs(a.x); }; return ;; length(load.force) ==>
//         size(load.force)
// mistake "one entry where the length belongs (torque)": return ==> const auto
//         size = [](const vec3& a) { return std::abs(a.x); }; return ;; length(load.torque) ==>
//         size(load.torque)
// mistake "one entry where the length belongs": return ==> const auto size = [](const vec3& a) {
//         return a.y; }; return ;; length(load.force) ==> size(load.force) ;; length(load.torque)
//         ==> size(load.torque)
// mistake "one entry where the length belongs (force)": return ==> const auto size = [](const vec3&
//         a) { return a.y; }; return ;; length(load.force) ==> size(load.force)
// mistake "one entry where the length belongs (torque)": return ==> const auto size = [](const
//         vec3& a) { return a.y; }; return ;; length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs": return ==> const auto size =
//         [](const vec3& a) { return std::abs(a.y); }; return ;; length(load.force) ==>
//         size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs (force)": return ==> const auto
//         size = [](const vec3& a) { return std::abs(a.y); }; return ;; length(load.force) ==>
//         size(load.force)
// mistake "one entry where the length belongs (torque)": return ==> const auto
//         size = [](const vec3& a) { return std::abs(a.y); }; return ;; length(load.torque) ==>
//         size(load.torque)
// mistake "one entry where the length belongs": return ==> const auto size = [](const vec3& a) {
//         return a.z; }; return ;; length(load.force) ==> size(load.force) ;; length(load.torque)
//         ==> size(load.torque)
// mistake "one entry where the length belongs (force)": return ==> const auto size = [](const vec3&
//         a) { return a.z; }; return ;; length(load.force) ==> size(load.force)
// mistake "one entry where the length belongs (torque)": return ==> const auto size = [](const
//         vec3& a) { return a.z; }; return ;; length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs": return ==> const auto size =
//         [](const vec3& a) { return std::abs(a.z); }; return ;; length(load.force) ==>
//         size(load.force) ;; length(load.torque) ==> size(load.torque)
// mistake "one entry where the length belongs (force)": return ==> const auto
//         size = [](const vec3& a) { return std::abs(a.z); }; return ;; length(load.force) ==>
//         size(load.force)
// mistake "one entry where the length belongs (torque)": return ==> const auto
//         size = [](const vec3& a) { return std::abs(a.z); }; return ;; length(load.torque) ==>
//         size(load.torque)
// wrong drawn-side: length(load.force) > strength.force ==> length(load.force) > strength.force +
//         real(1e-6)
// right breaks by squares:
  // Squares in the place of lengths: no root is drawn.
  const auto over = [](const vec3& a, real bound) { return dot(a, a) > bound * bound; };
  return over(load.force, strength.force) || over(load.torque, strength.torque);
// right breaks by the greater share:
  return std::max(length(load.force) / strength.force, length(load.torque) / strength.torque) > 1;
