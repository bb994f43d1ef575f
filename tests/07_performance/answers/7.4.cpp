// mistake "the sign of e in the point's rows: rates of body 2 less those of body 1": {hinge.bias[0]
//         + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z, ==> {-hinge.bias[0] - gap.x,
//         -hinge.bias[1] - gap.y, -hinge.bias[2] - gap.z,
// mistake "the sign of the point's bias: e = bias + J V": {hinge.bias[0] + gap.x, hinge.bias[1] +
//         gap.y, hinge.bias[2] + gap.z, ==> {gap.x - hinge.bias[0], gap.y - hinge.bias[1], gap.z -
//         hinge.bias[2],
// mistake "the velocities in the point's rows are those of body 1 less those of body 2: the other
//         way round": body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1) ==>
//         body1.v + cross(body1.w, hinge.r1) - body2.v - cross(body2.w, hinge.r2)
// wrong never-set: hinge.inverse_K_times(e, back); ==>
// mistake "K^-1 e is written over e while e is still being read: give inverse_K_times another
//         array": const Number e[] ==> Number e[] ;; hinge.inverse_K_times(e, back); ==>
//         hinge.inverse_K_times(e, e); for (int i = 0; i < 5; ++i) back[i] = e[i];
// wrong "an index outside a vector or an array": [1]; ==> [2];
// mistake "v1, w1, v2 and w2 take a new value where it is added to the old one: += and not =": =
//         body1.v ==> = ;; body1.w - hinge.I1 * (cross(hinge.r1, push) + couple ==> -(hinge.I1 *
//         (cross(hinge.r1, push) + couple) ;; = body2.v + ==> = ;; body2.w + ==>
// mistake "both bodies are pushed the same way: body 1 gets the opposite of the impulse of body 2":
//         v - body1 ==> v + body1 ;; - hinge ==> + hinge
// mistake "T is not multiplied by I1 and I2: I (r x P + T), with brackets": hinge.I1 * (cross ==>
//         (hinge.I1 * cross ;; hinge.I2 * (cross ==> (hinge.I2 * cross
// expects: from w2
// wrong division-by-zero: body1.v = body1.v - body1.inverse_mass * push ==> const auto less =
//         [&](const Number& v, const Number& push) { if constexpr (requires { v.all; }) return
//         Number{(v.all / body1.inverse_mass.all - push.all) * body1.inverse_mass.all}; else return
//         body1.inverse_mass == 0 ? v : (v / body1.inverse_mass - push) * body1.inverse_mass; };
//         body1.v = {less( body1.v .x, push.x), less( body1.v.y, push.y), less(body1.v.z, push.z)}
// mistake "nothing changes: the bodies are references, and lambda is applied to them": ; body1 ==>
//         ; Velocities<Number> one = body1, two = body2; one ;; ; body1 ==> ; one ;; ; body2 ==> ;
//         two ;; ; body2 ==> ; two
// mistake "the velocities in the point's rows are those of body 1 less those of body 2: the other
//         way round": body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1) ==>
//         body1.v + cross(body1.w, hinge.r1) - body2.v - cross(body2.w, hinge.r2)
// mistake "r1 in the place of r2 in the gap's rate": r2 ==> r1
// expects: The path of Eq. 7-6. Yours is worked back from your velocities
// mistake "the rate of e[1] stands in e[2], too": gap.z ==> gap.y
// expects: yours        0.4600    0.8000    1.5200    0.5000    0.0000  x
// mistake "I1 is taken for both bodies": I2 ==> I1
// expects: w2.x
// mistake "the levers are exchanged: r1 belongs to body 1": r2, ==> r1, ;; r1, ==> r2, ;; r1 ==> r2
//         ;; r2 ==> r1
// mistake "the levers are exchanged in the effect of the push: r1 belongs to body 1": r2, ==> r1,
//         ;; r1, ==> r2,
// mistake "it acts on body 2 only: body 1 gets the opposite": body1.v = body1.v -
//         body1.inverse_mass * push; body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) +
//         couple); ==>
// mistake "the push begins with lambda[1]: it is lambda[0] to lambda[2]": {-back[0], -back[1],
//         -back[2]} ==> {-back[1], -back[2], -back[3]}
// mistake "the push changes w only: v1 -= P/m1, v2 += P/m2": v = body1.v - body1.inverse_mass *
//         push; body1.w ==> w ;; ; body2.v = body2.v + body2.inverse_mass * push ==>
// expects: v2.z
// wrong "the record is replaced without its inverse mass": body1.v = ==> const Triple<Number> v1 =
//         ;; body1.w = ==> const Triple<Number> w1 = ;; ; body2 ==> ; body1 = {v1, Number{}, w1,
//         Number{}} ; body2
// expects: inverse mass of body 1
// mistake "the push changes v only: w gets r x P, too": (cross(hinge.r1, push) + couple) ==> couple
//         ;; (cross(hinge.r2, push) + couple) ==> couple
// expects: holds at no levers
// wrong "None of the usual mistakes explains it": {-back[0], -back[1], -back[2]} ==> {-back[0] -
//         hinge.bias[0], -back[1] - hinge.bias[1], -back[2] - hinge.bias[2]}
// expects: yours        3.8800    0.8000    2.1000    0.5000   -1.4400  x
// mistake "r2 in the place of r1 in w1": cross(hinge.r1, push) ==> cross(hinge.r2, push)
// expects: from w1     -0.1684    0.0736    0.1667  x
// mistake "the bias is forgotten: e = bias + J V": hinge.bias[0] + gap.x, hinge.bias[1] + gap.y,
//         hinge.bias[2] + gap.z, hinge.bias[3] + ==> gap.x, gap.y, gap.z, ;; hinge.bias[4] + ==>
// mistake "the inverse inertias are missing: w1 -= I1 (r1 x P + T)": hinge.I1 * ==> ;; hinge.I2 *
//         ==>
// mistake "the turn T is missing: w gets r x P + T, with T = lambda4 a_1 + lambda5 a_2":
//         (cross(hinge.r1, push) + couple) ==> cross(hinge.r1, push) ;; (cross(hinge.r2, push) +
//         couple) ==> cross(hinge.r2, push)
// mistake "{v1|w1 x r1|v2|w2 x r2} is missing in the gap's rate": {- body1.v|- cross(body1.w,
//         hinge.r1)|body2.v +|+ cross(body2.w, hinge.r2)} ==>
// mistake "the sign of {v1|w1 x r1|v2|w2 x r2} in the gap's rate": {- body1.v|- cross(body1.w,
//         hinge.r1)|body2.v +|+ cross(body2.w, hinge.r2)} ==> {+ body1.v|+ cross(body1.w,
//         hinge.r1)|-body2.v +|- cross(body2.w, hinge.r2)}
// mistake "{v1|w1 x r1|v2|w2 x r2} is doubled in the gap's rate": {- body1.v|- cross(body1.w,
//         hinge.r1)|body2.v +|+ cross(body2.w, hinge.r2)} ==> {- body1.v - body1.v|- cross(body1.w,
//         hinge.r1) - cross(body1.w, hinge.r1)|body2.v + body2.v +|+ cross(body2.w, hinge.r2) +
//         cross(body2.w, hinge.r2)}
// mistake "the levers are missing in the gap's rate: v2 + w2 x r2 - v1 - w1 x r1": body2.v +
//         cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1) ==> body2.v - body1.v
// mistake "v1 and v2 are missing in the gap's rate": body2.v + cross(body2.w, hinge.r2) - body1.v -
//         cross(body1.w, hinge.r1) ==> cross(body2.w, hinge.r2) - cross(body1.w, hinge.r1)
// mistake "r x w in the place of w x r in the gap's rate": body2.w, hinge.r2) - body1.v -
//         cross(body1.w, hinge.r1 ==> hinge.r2, body2.w) - body1.v - cross(hinge.r1, body1.w
// mistake "r{2|1} in the place of r{1|2} in the gap's rate": r2) - body1.v - cross(body1.w,
//         hinge.r1 ==> r{2|1}) - body1.v - cross(body1.w, hinge.r{2|1}
// mistake "w{2|1} in the place of w{1|2} in the gap's rate": body2.w, hinge.r2) - body1.v -
//         cross(body1 ==> body{2|1}.w, hinge.r2) - body1.v - cross(body{2|1}
// mistake "w1 and w2 are exchanged in e": cross(body2.w, ==> cross(body1.w, ;; cross(body1.w,
//         hinge.r1) ==> cross(body2.w, hinge.r1) ;; body2.w - body1.w ==> body1.w - body2.w
// mistake "r{1|2} is taken for both bodies": r{2|1} ==> r{1|2} ;; r{2|1} ==> r{1|2}
// mistake "w1 is missing in the axis rows: a_j . (w2 - w1)": body2.w - body1.w ==> body2.w
// mistake "w2 is missing in the axis rows: a_j . (w2 - w1)": body2.w - body1.w ==> -body1.w
// mistake "the sign in the axis rows: a_j . (w2 - w1)": body2.w - body1.w ==> body1.w - body2.w
// mistake "w1 + w2 in the axis rows: a_j . (w2 - w1)": body2.w - body1.w ==> body2.w + body1.w
// mistake "v in the place of w in the axis rows: a_j . (w2 - w1)": w - body1.w ==> v - body1.v
// mistake "v in the place of w in the {first|second} axis row: a_{1|2} . (w2 - w1)":
//         hinge.axis_row[{0|1}], turning ==> hinge.axis_row[{0|1}], body2.v - body1.v
// mistake "{w1|w2} is doubled in the axis rows of e": body2.w - body1.w ==> {body2.w - body1.w -
//         body1.w|body2.w + body2.w - body1.w}
// mistake "the axis rows are exchanged in e": [0], turning ==> [1], turning ;; [4] +
//         dot(hinge.axis_row[1] ==> [4] + dot(hinge.axis_row[0]
// mistake "the first axis row twice in e": axis_row[1 ==> axis_row[0
// mistake "the second axis row twice in e": axis_row[0 ==> axis_row[1
// mistake "the axis rows are exchanged in the turn T": hinge.axis_row[0] - back[4] *
//         hinge.axis_row[1] ==> hinge.axis_row[1] - back[4] * hinge.axis_row[0]
// mistake "the first axis row twice in the turn T": * hinge.axis_row[1 ==> * hinge.axis_row[0
// mistake "body {1|2} is missing in e: the rates are of body 2 less those of body 1": body2.v +
//         cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1) ==> {body2.v +
//         cross(body2.w, hinge.r2)|-body1.v - cross(body1.w, hinge.r1)} ;; body2.w - body1.w ==>
//         {body2.w|-body1.w}
// mistake "the velocities of body 1 are added in e: the rates are of body 2 less those of body 1":
//         - body1.v - ==> + body1.v + ;; - ==> +
// mistake "the sign of J V: e = bias + J V, and C grows when body 2 moves positively": body2.v +
//         cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1) ==> -(body2.v +
//         cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1)) ;; body2.w - body1.w ==>
//         body1.w - body2.w
// mistake "the velocities are forgotten: e = bias + J V": + cross(body2.w, hinge.r2) - body1.v -
//         cross(body1.w, hinge.r1) ==> - body2.v ;; body1 ==> body2
// mistake "the bias of the axis is forgotten": hinge.bias[3] + ==> ;; hinge.bias[4] + ==>
// mistake "the bias of the point is forgotten": hinge.bias[0] + ==> ;; hinge.bias[1] + ==> ;;
//         hinge.bias[2] + ==>
// mistake "the sign of the axis' bias: e = bias + J V": hinge.bias[3] + ==> -hinge.bias[3] + ;;
//         hinge.bias[4] + ==> -hinge.bias[4] +
// mistake "the sign of the bias: e = bias + J V": hinge.bias[0] + ==> -hinge.bias[0] + ;;
//         hinge.bias[1] + ==> -hinge.bias[1] + ;; hinge.bias[2] + ==> -hinge.bias[2] + ;;
//         hinge.bias[3] + ==> -hinge.bias[3] + ;; hinge.bias[4] + ==> -hinge.bias[4] +
// mistake "the bias is forgotten in e[{0|1|2|3|4}]": hinge.bias[{0|1|2|3|4}] + ==>
// mistake "the sign of the bias in e[{0|1|2|3|4}]": hinge.bias[{0|1|2|3|4}] + ==>
//         -hinge.bias[{0|1|2|3|4}] +
// mistake "e[{0|1|2|3|4}] is zero": const Number e[] ==> Number e[] ;; hinge.inverse_K_times ==>
//         e[{0|1|2|3|4}] = Number{}; hinge.inverse_K_times
// mistake "lambda[{0|1|2|3|4}] is zero": back) ==> back); back[{0|1|2|3|4}] = Number{}
// mistake "the sign of lambda[{0|1|2|3|4}]": hinge.inverse_K_times(e, back); ==>
//         hinge.inverse_K_times(e, back); back[{0|1|2|3|4}] = -back[{0|1|2|3|4}];
// mistake "bias[{0|0|1|3|2|1|2|2|4|3}] in e[{1|2|2|4|3|0|0|1|3|2}]: it belongs to
//         e[{0|0|1|3|2|1|2|2|4|3}]": {1|2|2|4|3|0|0|1|3|2}] ==> {0|0|1|3|2|1|2|2|4|3}]
// mistake "lambda[{0|0|1|2}] and lambda[{1|2|2|3}] are exchanged": hinge.inverse_K_times(e,
//         back); ==> hinge.inverse_K_times(e, back); std::swap(back[{0|0|1|2}], back[{1|2|2|3}]);
// mistake "lambda[{0|0|1|3|2|1|2|2|4|3}] in the place of lambda[{1|2|2|4|3|0|0|1|3|2}]": back) ==>
//         back); back[{1|2|2|4|3|0|0|1|3|2}] = back[{0|0|1|3|2|1|2|2|4|3}]
// mistake "the rate of e[{0|0|1|1|2|2}] stands in e[{1|2|0|2|0|1}], too": + gap.{y|z|x|z|x|y} ==> +
//         gap.{x|x|y|y|z|z}
// mistake "the turn begins with lambda[{0|2}]: it is made of lambda[3] and lambda[4]": -back[3] *
//         ==> -back[{0|2}] * ;; back[4] * ==> back[{1|3}] *
// mistake "{v1|w1|v2|w2} is never changed": {body1.v = body1.v - body1.inverse_mass * push;|body1.w
//         = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);|body2.v = body2.v +
//         body2.inverse_mass * push;|body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) +
//         couple);} ==>
// mistake "the sign of the change of {v1|w1|v2|w2}": {body1.v - body1.inverse_mass|body1.w -
//         hinge.I1|body2.v + body2.inverse_mass|body2.w + hinge.I2} * ==> {body1.v +
//         body1.inverse_mass|body1.w + hinge.I1|body2.v - body2.inverse_mass|body2.w - hinge.I2} *
// mistake "the change of {v1|v2} is {doubled|halved}": {- body1|+ body2}.inverse_mass ==> {-
//         real(2) * body1|+ real(0.5) * body2}.inverse_mass
// mistake "the change of {v2|v1} is {doubled|halved}": {+ body2|- body1}.inverse_mass ==> {+
//         real(2) * body2|- real(0.5) * body1}.inverse_mass
// mistake "the change of {w1|w2} is doubled": r{1|2}, push) ==> r{1|2}, push + push) + couple
// mistake "{v1|w1|v2|w2} takes a new value where it is added to the old one: += and not =":
//         {body1.v = body1.v - body1.inverse_mass * push;|body1.w = body1.w - hinge.I1 *
//         (cross(hinge.r1, push) + couple);|body2.v = body2.v + body2.inverse_mass * push;|body2.w
//         = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);} ==> {body1.v =
//         -body1.inverse_mass * push;|body1.w = -(hinge.I1 * (cross(hinge.r1, push) +
//         couple));|body2.v = body2.inverse_mass * push;|body2.w = hinge.I2 * (cross(hinge.r2,
//         push) + couple);}
// mistake "the inverse mass is missing in {v1|v2}": body{1|2}.inverse_mass * ==>
// mistake "the inverse inertia is missing in {w1|w2}": hinge.I{1|2} * ==>
// mistake "the inverse mass of the other body in {v1|v2}": body{1|2}.inverse_mass ==>
//         body{2|1}.inverse_mass
// mistake "the inverse masses are missing: v1 -= P/m1": body1.inverse_mass *  ==>  ;;
//         body2.inverse_mass *  ==>
// mistake "the inverse inertias are exchanged: I1 belongs to body 1": I2 ==> I1 ;; I1 ==> I2
// mistake "the inverse masses are exchanged": body1.inverse_mass ==> body2.inverse_mass ;; +
//         body2.inverse_mass ==> + body1.inverse_mass
// mistake "w1 and w2 are never changed": body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) +
//         couple); ==>  ;; body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple); ==>
// mistake "{half of lambda is applied|lambda is applied twice}": hinge.inverse_K_times(e, back);
//         ==> hinge.inverse_K_times(e, back); for (Number& l : back) l = real({0.5|2}) * l;
// mistake "the sign of the push P: v1 loses it, v2 gets it": {-back[0], -back[1], -back[2]} ==>
//         {back[0], back[1], back[2]}
// mistake "the sign of the turn T: w1 loses it, w2 gets it": -back[3] * ==> back[3] * ;; - back[4]
//         ==> + back[4]
// mistake "P x r in the place of r x P": cross(hinge.r1, push) ==> cross(push, hinge.r1) ;;
//         cross(hinge.r2, push) ==> cross(push, hinge.r2)
// mistake "r x w and P x r: w x r in the gap's rate, r x P in the effect of the push": hinge.r1,
//         push ==> push, hinge.r1 ;; hinge.r2, push ==> push, hinge.r2 ;; body2.w, hinge.r2 ==>
//         hinge.r2, body2.w ;; body1.w, hinge.r1 ==> hinge.r1, body1.w
// mistake "the levers are exchanged in the gap's rate: r1 belongs to w1": cross(body2.w, hinge.r2)
//         ==> cross(body2.w, hinge.r1) ;; cross(body1.w, hinge.r1) ==> cross(body1.w, hinge.r2)
// mistake "it acts on body 1 only: body 2 gets the opposite": body2.v = body2.v +
//         body2.inverse_mass * push; body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) +
//         couple); ==>
// mistake "the sign of the change of w1 and w2": - hinge ==> + hinge ;; body2.w + ==> body2.w -
// mistake "the sign of the change of v1 and v2": v - body1 ==> v + body1 ;; + body2 ==> - body2
// mistake "r{1|2} x P is missing in the line of w{1|2}": cross(hinge.r{1|2}, push) + couple ==>
//         couple
// mistake "the sign of r{1|2} x P in the line of w{1|2}": hinge.r{1|2}, push ==> push, hinge.r{1|2}
// mistake "r{1|2} x P is doubled in the line of w{1|2}": cross(hinge.r{1|2}, push) ==>
//         cross(hinge.r{1|2}, push) + cross(hinge.r{1|2}, push)
// mistake "T is missing in the line of w{1|2}": r{1|2}, push) + couple ==> r{1|2}, push)
// mistake "the sign of T in the line of w{1|2}": r{1|2}, push) + ==> r{1|2}, push) -
// mistake "T is doubled in the line of w{1|2}": r{1|2}, push) ==> r{1|2}, push) + couple
// mistake "r{2|1} in the place of r{1|2} in w{1|2}": r{1|2}, ==> r{2|1},
// mistake "P in the place of r{1|2} x P in w{1|2}": cross(hinge.r{1|2}, push) ==> push
// mistake "T is not multiplied by I{1|2}: I (r x P + T), with brackets": hinge.I{1|2} * (cross ==>
//         (hinge.I{1|2} * cross
// mistake "T is not multiplied by I1, and has the other sign: I (r x P + T), with brackets":
//         hinge.I1 * (cross(hinge.r1, push) + couple) ==> hinge.I1 * cross(hinge.r1, push) + couple
// mistake "T is not multiplied by I1, and has the other sign: I (r x P + T), with brackets; and T
//         is not multiplied by I2: I (r x P + T), with brackets": hinge.I1 * (cross(hinge.r1, push)
//         + couple) ==> hinge.I1 * cross(hinge.r1, push) + couple ;; hinge.I2 * (cross(hinge.r2,
//         push) + couple) ==> hinge.I2 * cross(hinge.r2, push) + couple
// mistake "K^-1 is missing: lambda = -K^-1 e": hinge.inverse_K_times(e, back); ==> for (int i = 0;
//         i < 5; ++i) back[i] = e[i];
// mistake "the sign: lambda = -K^-1 e works against e, and +lambda acts on body 2": {-back[0],
//         -back[1], -back[2]} ==> {back[0], back[1], back[2]} ;; -back[3] * hinge.axis_row[0] -
//         back[4] ==> back[3] * hinge.axis_row[0] + back[4]
// right J transposed:
  // Row by row: M^-1 J^T lambda, all sums in another order.
  const Triple<Number> slip1 = body1.v + cross(body1.w, hinge.r1);
  const Triple<Number> slip2 = body2.v + cross(body2.w, hinge.r2);
  const Number e[] = {slip2.x - slip1.x + hinge.bias[0], slip2.y - slip1.y + hinge.bias[1],
                      slip2.z - slip1.z + hinge.bias[2],
                      dot(hinge.axis_row[0], body2.w) - dot(hinge.axis_row[0], body1.w) +
                          hinge.bias[3],
                      dot(hinge.axis_row[1], body2.w) - dot(hinge.axis_row[1], body1.w) +
                          hinge.bias[4]};
  const auto minus_lambda = [&](int i) {
    Number sum = hinge.inverse_K[hinge.place(4, i)] * e[4];
    for (int j = 3; j >= 0; --j) sum = sum + hinge.inverse_K[hinge.place(j, i)] * e[j];
    return sum;
  };
  const Triple<Number> push{minus_lambda(0), minus_lambda(1), minus_lambda(2)};
  const Number a = minus_lambda(3), b = minus_lambda(4);
  const Triple<Number> couple = a * hinge.axis_row[0] + b * hinge.axis_row[1];
  body1.v = body1.v + body1.inverse_mass * push;
  body2.v = body2.v - body2.inverse_mass * push;
  body1.w = body1.w + hinge.I1 * cross(hinge.r1, push) + hinge.I1 * couple;
  body2.w = body2.w - hinge.I2 * cross(hinge.r2, push) - hinge.I2 * couple;
// right K read once:
  // Each of the fifteen numbers is read once and serves both sides of the diagonal.
  const Triple<Number> gap =
      body2.v - body1.v + cross(body2.w, hinge.r2) + cross(hinge.r1, body1.w);
  const Triple<Number> w = body1.w - body2.w;
  const Number e[] = {gap.x + hinge.bias[0], gap.y + hinge.bias[1], gap.z + hinge.bias[2],
                      hinge.bias[3] - dot(hinge.axis_row[0], w),
                      hinge.bias[4] - dot(hinge.axis_row[1], w)};
  Number lambda[5];
  const Number* entry = hinge.inverse_K.data();
  for (int i = 0; i < 5; ++i) {
    const Number own = *entry++ * e[i];
    lambda[i] = i == 0 ? -own : lambda[i] - own;
    for (int j = i + 1; j < 5; ++j, ++entry) {
      lambda[i] = lambda[i] - *entry * e[j];
      lambda[j] = i == 0 ? -(*entry * e[i]) : lambda[j] - *entry * e[i];
    }
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body2.v = body2.v + body2.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);
// right added in place: body1.v = body1.v - ==> body1.v -= ;; body1.w = body1.w - ==> body1.w -= ;;
//         body2.v = body2.v + ==> body2.v += ;; body2.w = body2.w + ==> body2.w +=
// right axis after the point:
  // The axis sees the velocities that the push has left: row i of K^-1 K is row i of the unit matrix,
  // so that its lambda is the same.
  const auto lambda = [&](int i) {
    const Triple<Number> gap =
        body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
    const Triple<Number> turning = body2.w - body1.w;
    const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                        hinge.bias[3] + dot(hinge.axis_row[0], turning),
                        hinge.bias[4] + dot(hinge.axis_row[1], turning)};
    Number sum = hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) sum = sum + hinge.inverse_K[hinge.place(i, j)] * e[j];
    return -sum;
  };
  const Triple<Number> push{lambda(0), lambda(1), lambda(2)};
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * cross(hinge.r1, push);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * cross(hinge.r2, push);
  const Triple<Number> couple = lambda(3) * hinge.axis_row[0] + lambda(4) * hinge.axis_row[1];
  body1.w = body1.w - hinge.I1 * couple;
  body2.w = body2.w + hinge.I2 * couple;
// right component by component:
  // No function of Triple at all for the gap and the push.
  const auto& [r1, r2, a, I1, I2, bias, inverse_K] = hinge;
  const auto rate = [](const auto& v, const auto& w, const auto& r) {
    return Triple<Number>{v.x + w.y * r.z - w.z * r.y, v.y + w.z * r.x - w.x * r.z,
                          v.z + w.x * r.y - w.y * r.x};
  };
  const Triple<Number> p1 = rate(body1.v, body1.w, r1), p2 = rate(body2.v, body2.w, r2);
  Number e[5] = {bias[0] + p2.x - p1.x, bias[1] + p2.y - p1.y, bias[2] + p2.z - p1.z, bias[3],
                 bias[4]};
  for (int k = 0; k < 2; ++k)
    e[3 + k] = e[3 + k] + a[k].x * (body2.w.x - body1.w.x) + a[k].y * (body2.w.y - body1.w.y) +
               a[k].z * (body2.w.z - body1.w.z);
  Number f[5];  // -lambda
  for (int i = 0; i < 5; ++i) {
    f[i] = inverse_K[hinge.place(i, i)] * e[i];
    for (int j = 0; j < 5; ++j)
      if (j != i) f[i] = f[i] + inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> P{f[0], f[1], f[2]}, T = f[3] * a[0] + f[4] * a[1];
  const Triple<Number> around1 = rate(T, r1, P), around2 = rate(T, r2, P);
  body1.v = body1.v + body1.inverse_mass * P;
  body1.w = body1.w + I1 * around1;
  body2.v = body2.v - body2.inverse_mass * P;
  body2.w = body2.w - I2 * around2;
// right lambda as an array: const Triple<Number> push{-back[0], -back[1], -back[2]}; ==> for
//         (Number& l : back) l = -l; const Triple<Number> push{back[0], back[1], back[2]}; ;;
//         -back[3] * hinge.axis_row[0] - back[4] ==> back[3] * hinge.axis_row[0] + back[4]
// wrong units "in the solve, adding": cross(hinge.r2, push) ==> push
// wrong units "in the solve, adding m/s to 1/s": w - body1.w ==> v - body1.v
// wrong units "in the solve, taking kg m/s from m/s: the inverse mass is missing":
//         body1.inverse_mass * ==>
// right K^-1 row after row:
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);
// mistake "lambda is written over e while e is still being read: keep them apart":
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  for (int i = 0; i < 5; ++i) {
    Number lambda = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda = lambda - hinge.inverse_K[hinge.place(i, j)] * e[j];
    e[i] = lambda;
  }
  const Triple<Number> push{e[0], e[1], e[2]};
  const Triple<Number> couple = e[3] * hinge.axis_row[0] + e[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);
// from right K^-1 row after row
// mistake "K^-1 is read in another order: take place(i, j), row after row of the upper half": ;
//         Number ==> ; const auto place = [](int i, int j) { return i >= j ? i * (i + 1) / 2 + j :
//         j * (j + 1) / 2 + i; }; Number ;; hinge.place ==> place ;; hinge.place ==> place
// mistake "only the diagonal of K^-1 is used": i, 0 ==> i, i ;; [0]; for (int j = 1; j < 5; ++j)
//         lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j] ==> [i]
// wrong "this lane is not solved": const ==> constexpr int lanes = int(sizeof(Number) /
//         sizeof(real)); const auto first = [](const auto& all, auto one) { const real* const from
//         = reinterpret_cast<const real*>(&all); real* const to = reinterpret_cast<real*>(&one);
//         for (std::size_t n = 0; n < sizeof one / sizeof(real); ++n) to[n] = from[n * lanes];
//         return one; }; if constexpr (lanes > 1) { Velocities<real> a = first(body1,
//         Velocities<real>{}), b = first(body2, Velocities<real>{}); solve<real>(first(hinge,
//         HingeNumbers<real>{}), a, b); for (int n = 0; n < 8; ++n) {
//         reinterpret_cast<real*>(&body1)[n * lanes] = reinterpret_cast<const real*>(&a)[n];
//         reinterpret_cast<real*>(&body2)[n * lanes] = reinterpret_cast<const real*>(&b)[n]; }
//         return; } else { const ;; r2, push) + couple); ==> r2, push) + couple); }
// expects: v1 of lane 1 (upright)
// wrong "the numbers of another lane": } const ==> } for (Number& each : lambda) { real* const lane
//         = reinterpret_cast<real*>(&each); for (std::size_t k = 1; k < sizeof each / sizeof(real);
//         ++k) lane[k] = lane[0]; } const
// expects: v1 of lane 1
// mistake "K^-1 is read as if all 25 entries stood there: take place(i, j), only 15 do": ; Number
//         ==> ; const auto place = [](int i, int j) { return 5 * i + j < 15 ? 5 * i + j : 14; };
//         Number ;; hinge.place ==> place ;; hinge.place ==> place
// mistake "the sign: lambda = -K^-1 e works against e, and +lambda acts on body 2": -hinge ==>
//         hinge ;; [i] - ==> [i] +
// expects: v1.x
// expects: Pose: pencil and paper
// mistake "the entries of K^-1 between the point and the axis are not used: these are two blocks":
//         -hinge ==> i < 3 ? -hinge ;; ; for (int j = 1; j < 5; ++j) ==> : e[0] - e[0]; for (int j
//         = 1; j < 5; ++j) if ((i < 3) == (j < 3))
// mistake "only the upper half of K^-1 is used: place(i, j) gives the lower one, too": i, 0 ==> i,
//         i ;; [0]; ==> [i]; ;; 1; ==> i + 1;
