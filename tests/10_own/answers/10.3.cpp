// mistake "the lead is the travel of a whole turn: divide it by 2 pi": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead
// mistake "the lead is multiplied by 2 pi: divide it": lead / (2 * std::numbers::pi_v<real>) ==>
//         lead * (2 * std::numbers::pi_v<real>)
// mistake "the lead is the travel of a whole turn, 2 pi and not pi": (2 * std::numbers::pi_v<real>)
//         ==> std::numbers::pi_v<real>
// mistake "the sign of the angle: a positive lead moves the nut forward in a positive turn": s -
//         lead ==> s + lead
// mistake "C is an angle: it is to be in metres": s - lead / (2 * std::numbers::pi_v<real>) * theta
//         ==> s * (2 * std::numbers::pi_v<real>) / lead - theta
// mistake "the angle is missing": s - lead / (2 * std::numbers::pi_v<real>) * theta ==> s
// mistake "divided by 360: angles are in radians": (2 * std::numbers::pi_v<real>) ==> 360
// right the angle in turns: s - lead / (2 * std::numbers::pi_v<real>) * theta ==> s - lead * (theta
//         / (2 * std::numbers::pi_v<real>))
// mistake "lead / 2 * pi is a half of the lead times pi: put 2 pi in brackets": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead / 2 * std::numbers::pi_v<real>
// mistake "the sign: C grows with the displacement": s - lead / (2 * std::numbers::pi_v<real>) *
//         theta ==> lead / (2 * std::numbers::pi_v<real>) * theta - s
// mistake "C is an angle: it is to be in metres": s - lead / (2 * std::numbers::pi_v<real>) * theta
//         ==> theta - s * (2 * std::numbers::pi_v<real>) / lead
// mistake "the displacement is missing": s - lead / (2 * std::numbers::pi_v<real>) ==> -lead / (2 *
//         std::numbers::pi_v<real>)
// mistake "the lead is missing": lead / (2 * std::numbers::pi_v<real>) ==> 1 / (2 *
//         std::numbers::pi_v<real>)

// region 2
// mistake "the lead is the travel of a whole turn: divide it by 2 pi": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead
// mistake "the sign of the angle's row": along.w1 - p * ==> along.w1 + p * ;; along.w2 - p * ==>
//         along.w2 + p *
// mistake "the row of the angle is missing": {along.v1, along.w1 - p * about.w1, along.v2, along.w2
//         - p * about.w2} ==> along
// mistake "the levers are missing: w1 and w2 of the displacement belong to the row, too": along.w1
//         - p * about.w1 ==> -p * about.w1 ;; along.w2 - p * about.w2 ==> -p * about.w2
// mistake "the angle of body 1 is missing: the screw turns as well": along.w1 - p * about.w1 ==>
//         along.w1
// mistake "the row of the angle stands in v1 and v2: a turn has the blocks w1 and w2": {along.v1,
//         along.w1 - p * about.w1, along.v2, along.w2 - p * about.w2} ==> {along.v1 - p * about.w1,
//         along.w1, along.v2 - p * about.w2, along.w2}
// mistake "the row of an angle: C is in metres, and so is its slope": {along.v1, along.w1 - p *
//         about.w1, along.v2, along.w2 - p * about.w2} ==> {along.v1 / p, along.w1 / p - about.w1,
//         along.v2 / p, along.w2 / p - about.w2}
// right all four blocks: {along.v1, along.w1 - p * about.w1, along.v2, along.w2 - p * about.w2} ==>
//         {along.v1 - p * about.v1, along.w1 - p * about.w1, along.v2 - p * about.v2, along.w2 - p
//         * about.w2}
// mistake "lead / 2 * pi is a half of the lead times pi: put 2 pi in brackets": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead / 2 * std::numbers::pi_v<real>
// mistake "the lead is multiplied by 2 pi: divide it": lead / (2 * std::numbers::pi_v<real>) ==>
//         lead * (2 * std::numbers::pi_v<real>)
// mistake "the lead is the travel of a whole turn, 2 pi and not pi": lead / (2 *
//         std::numbers::pi_v<real>) ==> lead / std::numbers::pi_v<real>
// mistake "the sign of the whole row": {along.v1, along.w1 - p * about.w1, along.v2, along.w2 - p *
//         about.w2} ==> {-along.v1, p * about.w1 - along.w1, -along.v2, p * about.w2 - along.w2}
// mistake "the sign of the angle's row in w1 alone: both blocks are combined alike": along.w1 - p *
//         ==> along.w1 + p *
// mistake "the sign of the angle's row in w2 alone: both blocks are combined alike": along.w2 - p *
//         ==> along.w2 + p *
// mistake "the angle of body 2 is missing": along.w2 - p * about.w2 ==> along.w2
// mistake "the lead is missing": lead / (2 * std::numbers::pi_v<real>) ==> 1
// mistake "the row of the displacement is missing: C has both": {along.v1, along.w1 - p * about.w1,
//         along.v2, along.w2 - p * about.w2} ==> {vec3(0), -p * about.w1, vec3(0), -p * about.w2}
// mistake "the lever of body 1 is missing: w1 of the displacement belongs to the row, too":
//         along.w1 - p ==> -p
// mistake "the lever of body 2 is missing: w2 of the displacement belongs to the row, too":
//         along.w2 - p ==> -p
