// One thing to predict before the settings open.
"use strict";

const question = {
  scene: "chain", set: {beta: 2.1}, seconds: 5,
  asks: "In every step each joint removes the fraction <b>beta</b> of its gap: 0.2 as the chain swings " +
    "now. What will beta = 2.1 do?",
  answers: ["The gaps close ten times as fast.", "The gaps grow from step to step.",
            "Nothing more than beta = 1: a gap can only be closed."],
  right: 1,
  says: "A step multiplies a gap by 1 − beta. With 2.1 that is −1.1: every gap changes its sign " +
    "and grows by a tenth, sixty times a second. The gaps begin so small that this takes a " +
    "second or two to be seen. Chapter 6 derives it.",
};

// Shows the question; try_it(scene, settings) runs what was asked, then() opens the settings.
function ask_question(place, try_it, then) {
  document.body.classList.add("asked");
  place.innerHTML = `<p><b>First a guess.</b> ${question.asks}</p>`;
  let over = false;  // whoever chooses another scene has ended it
  const done = () => {
    over = true;
    document.body.classList.remove("asked");
    then();
  };
  const button = (words, action, kind = "") => {
    const one = Object.assign(document.createElement("button"),
                              {type: "button", textContent: words, className: kind});
    one.onclick = action;
    place.append(one);
  };
  question.answers.forEach((words, k) => button(words, async () => {
    place.innerHTML = `<p>Your guess: ${words} Look …</p>`;
    await try_it(question.scene, question.set, question.seconds);
    if (over) return;
    place.innerHTML = `<p><b>${k === question.right ? "Right." : "No."}</b> ${question.says}</p>`;
    button("back to beta 0.2, and on to the settings", () => {
      place.innerHTML = "";
      done();
      try_it(question.scene, {}, 0);
    });
  }));
  const skip = () => { place.innerHTML = ""; done(); };
  button("skip", skip, "skip");
  return skip;
}
