// mistake "the gap of now: what counts is the gap at the end of the step": C[k] + h * rate[k] ==>
//         C[k] + 0 * h * rate[k]
// mistake "h is missing with the rate: a gap changes by h times it": h * rate[k] ==> rate[k]
// mistake "h is missing with the margin: it is a speed": margin * h ==> margin
// mistake "the margin is missing": margin * h) ==> 0 * margin * h)
// mistake "the sign of the rate: a corner that comes down has a negative one": C[k] + h ==> C[k] -
//         h
// mistake "the other way round: rows are for corners that will be low": < margin ==> > margin
// mistake "all low corners: at most four get rows": live.size() > 4 ==> live.size() > 8
// mistake "the first four: those with the smallest gap at the end get the rows": highest = j; ==>
//         highest = j; highest = live.size() - 1;
// mistake "the last four: those with the smallest gap at the end get the rows": highest = j; ==>
//         highest = 0;
// mistake "the four highest: those with the smallest gap get the rows": later[std::size_t(live[j])]
//         > ==> later[std::size_t(live[j])] <
// mistake "the four with the smallest gap of now: the gap at the end of the step counts":
//         later[std::size_t(live[j])] > later[std::size_t(live[highest])] ==>
//         C[std::size_t(live[j])] > C[std::size_t(live[highest])]
// mistake "the four that come down fastest: the gap at the end of the step counts":
//         later[std::size_t(live[j])] > later[std::size_t(live[highest])] ==>
//         rate[std::size_t(live[j])] > rate[std::size_t(live[highest])]
// mistake "only one corner too many is left out: up to eight may be low": while (live ==> if (live
// mistake "the place in the list in the place of the corner: live[j] is the corner":
//         later[std::size_t(live[j])] > later[std::size_t(live[highest])] ==> later[j] >
//         later[highest]
// mistake "four corners at most, not three": size() > 4 ==> size() > 3
// mistake "four corners at most, not five": size() > 4 ==> size() > 5
// mistake "the corners are counted: return their indices": live.push_back(int(k)) ==>
//         live.push_back(int(live.size()))
// mistake "the last corner is left out": k < C.size() ==> k + 1 < C.size()
// mistake "the first corner is left out: indices begin with 0": if (later[k] < ==> if (k > 0 &&
//         later[k] <
// mistake "only corners in the ground get rows: a corner may come down within the step": if
//         (later[k] < margin * h) ==> if (C[k] < 0)
// mistake "only corners that come down get rows: one that rests or lies in the ground needs them,
//         too": if (later[k] < ==> if (rate[k] < 0 && later[k] <
// right sorted:
  std::vector<int> live;
  for (int k = 0; k < int(C.size()); ++k)
    if (C[k] + h * (rate[k] - margin) < 0) live.push_back(k);
  std::sort(live.begin(), live.end(), [&](int a, int b) {
    return C[a] + h * rate[a] < C[b] + h * rate[b];
  });
  if (live.size() > 4) live.resize(4);
  return live;
// right counted:
  std::vector<int> live;
  const int n = int(C.size());
  std::vector<real> after;
  for (int k = 0; k < n; ++k) after.push_back(C[k] + h * rate[k]);
  for (int k = 0; k < n; ++k) {
    int lower = 0;
    for (int j = 0; j < n; ++j)
      if (after[j] < after[k]) ++lower;
    if (lower < 4 && after[k] < margin * h) live.push_back(k);
  }
  return live;

// region 2
// mistake "the normal row is solved first: the order is t1, t2, n": for (int i = 0; i < 2; ++i) {
//         ==> const real first = row_velocity(corner.J[2], body1, body2) + corner.bias;
//         apply_impulse(corner.J[2], clamp_sum(-first / corner.K[2], corner.sum[2]), body1, body2);
//         for (int i = 0; i < 2; ++i) { ;; const real error = row_velocity(corner.J[2], body1,
//         body2) + corner.bias; apply_impulse(corner.J[2], clamp_sum(-error / corner.K[2],
//         corner.sum[2]), body1, body2); ==>
// mistake "row after row over all corners: each corner is finished before the next one": for
//         (ContactRows& corner : corners) { ==> for (ContactRows& corner : corners) ;; const real
//         error ==> for (ContactRows& corner : corners) { const real error
// mistake "the rates are those before the corner: each solve needs the velocities that the one
//         before has left": for (ContactRows& corner : corners) { ==> for (ContactRows& corner :
//         corners) { const Body one = body1, two = body2; ;; row_velocity(corner.J[i], body1,
//         body2) ==> row_velocity(corner.J[i], one, two) ;; row_velocity(corner.J[2], body1, body2)
//         ==> row_velocity(corner.J[2], one, two)
// mistake "the rates are those before the iteration: each solve needs the velocities that the one
//         before has left": for (ContactRows& corner : corners) { ==> const Body one = body1, two =
//         body2; for (ContactRows& corner : corners) { ;; row_velocity(corner.J[i], body1, body2)
//         ==> row_velocity(corner.J[i], one, two) ;; row_velocity(corner.J[2], body1, body2) ==>
//         row_velocity(corner.J[2], one, two)
// mistake "friction is missing": i < 2 ==> i < 0
// mistake "friction along t2 is missing": i < 2 ==> i < 1
// mistake "friction along t1 is missing": int i = 0 ==> int i = 1
// mistake "the normal row is missing": apply_impulse(corner.J[2], clamp_sum(-error / corner.K[2],
//         corner.sum[2]), body1, body2); ==> (void)error;
// mistake "the bias is missing": + corner.bias ==>
// mistake "the sign of the bias: J V + b = 0": + corner.bias ==> - corner.bias
// mistake "the bias belongs to the normal row alone": corner.J[i], body1, body2) ==> corner.J[i],
//         body1, body2) + corner.bias
// mistake "the sign of the normal impulse: it must remove J V + b": -error / ==> error /
// mistake "times K where it must be divided by K": -error / corner.K[2] ==> -error * corner.K[2]
// mistake "K of another row": error / corner.K[2] ==> error / corner.K[0]
// mistake "K of the normal row in the solve of friction: each row has its own": rate, corner.K[i]
//         ==> rate, corner.K[2]
// mistake "the bound of friction is the sum of its own row: it is that of the normal row": mu,
//         corner.sum[2] ==> mu, std::abs(corner.sum[i])
// mistake "both directions of friction have one sum: each row has its own": corner.sum[i]) ==>
//         corner.sum[0])
// mistake "the normal row is not clamped: the ground only pushes": clamp_sum(-error / corner.K[2],
//         corner.sum[2]), body1 ==> -error / corner.K[2], body1
// mistake "the change is clamped: it is the sum that must not become negative": clamp_sum(-error /
//         corner.K[2], corner.sum[2]) ==> std::max(real(0), -error / corner.K[2])
// mistake "the sum is applied: apply its change": corner.J[i], change ==> corner.J[i],
//         corner.sum[i] + 0 * change
// mistake "the impulse of friction is not applied": apply_impulse(corner.J[i], change, body1,
//         body2); ==> (void)change;
// mistake "the bodies are exchanged: the row belongs to body1, body2": corner.J[i], change, body1,
//         body2 ==> corner.J[i], change, body2, body1
// mistake "only the first corner is solved": for (ContactRows& corner : corners) { ==> for
//         (ContactRows& corner : corners) { if (&corner != &corners[0]) break;
// mistake "a copy of each corner: its sums are lost, use a reference": (ContactRows& corner ==>
//         (ContactRows corner
// mistake "the sums begin with 0: the iteration continues those of the one before": for (int i = 0;
//         i < 2; ++i) { ==> corner.sum = {}; for (int i = 0; i < 2; ++i) {
// mistake "corners that do not push yet are left out": for (int i = 0; i < 2; ++i) { ==> if
//         (corner.sum[2] == 0) continue; for (int i = 0; i < 2; ++i) {
// right with one loop:
  for (std::size_t k = 0; k < corners.size(); ++k) {
    ContactRows& c = corners[k];
    for (const int i : {0, 1, 2}) {
      real rate = row_velocity(c.J[i], body1, body2), before = c.sum[i];
      if (i == 2) rate += c.bias;
      c.sum[i] -= rate / c.K[i];
      const real most = mu * c.sum[2];
      c.sum[i] = i == 2 ? std::max(c.sum[i], real(0)) : std::clamp(c.sum[i], -most, most);
      apply_impulse(c.J[i], c.sum[i] - before, body1, body2);
    }
  }
