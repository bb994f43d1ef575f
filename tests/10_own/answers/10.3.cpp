// wrong "the lead is the travel of a whole turn: divide it by 2 pi": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead
// wrong "the lead is multiplied by 2 pi: divide it": lead / (2 * std::numbers::pi_v<real>) ==>
//         lead * (2 * std::numbers::pi_v<real>)
// wrong "the lead is the travel of a whole turn, 2 pi and not pi": (2 * std::numbers::pi_v<real>)
//         ==> std::numbers::pi_v<real>
// wrong "the sign of the angle: a positive lead moves the nut": s - lead ==> s + lead
// wrong "C is an angle: it is to be in metres": s - lead / (2 * std::numbers::pi_v<real>) * theta
//         ==> s * (2 * std::numbers::pi_v<real>) / lead - theta
// wrong "the angle is missing": s - lead / (2 * std::numbers::pi_v<real>) * theta ==> s
// wrong "divided by 360: angles are in radians": (2 * std::numbers::pi_v<real>) ==> 360
// right the angle in turns: s - lead / (2 * std::numbers::pi_v<real>) * theta ==> s - lead *
//         (theta / (2 * std::numbers::pi_v<real>))

// region 2
// wrong "the lead is the travel of a whole turn: divide it by 2 pi": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead
// wrong "the sign of the angle's row": along.w1 - p * ==> along.w1 + p * ;; along.w2 - p * ==>
//         along.w2 + p *
// wrong "the row of the angle is missing": {along.v1, along.w1 - p * about.w1, along.v2, along.w2
//         - p * about.w2} ==> along
// wrong "the levers are missing: w1 and w2 of the displacement": along.w1 - p * about.w1 ==> -p *
//         about.w1 ;; along.w2 - p * about.w2 ==> -p * about.w2
// wrong "the angle of body 1 is missing: the screw turns as well": along.w1 - p * about.w1 ==>
//         along.w1
// wrong "the row of the angle stands in v1 and v2: a turn has the": {along.v1, along.w1 - p *
//         about.w1, along.v2, along.w2 - p * about.w2} ==> {along.v1 - p * about.w1, along.w1,
//         along.v2 - p * about.w2, along.w2}
// wrong "the row of an angle: C is in metres, and so is its slope": {along.v1, along.w1 - p *
//         about.w1, along.v2, along.w2 - p * about.w2} ==> {along.v1 / p, along.w1 / p -
//         about.w1, along.v2 / p, along.w2 / p - about.w2}
// right all four blocks: {along.v1, along.w1 - p * about.w1, along.v2, along.w2 - p * about.w2}
//         ==> {along.v1 - p * about.v1, along.w1 - p * about.w1, along.v2 - p * about.v2,
//         along.w2 - p * about.w2}
