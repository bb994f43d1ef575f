"""Of page_test.py: the scene below an exercise that was checked."""
import json

from reader import RIGHT, STUB, WRONG, Exercise, lacks, solution, tab

from website.browser import Browser


def wrong_code_moves_beside_the_solution(root, build):
    """both motions of wrong code are seen, until its bodies leave the picture; when and where they
    part is said, and that those of right code do not; no scene marks anything as done"""
    exercise, *_ = tab(Browser)
    frame = f"{exercise.place}.querySelector('.scene iframe').contentWindow"
    exercise.take_in(json.dumps(STUB))
    exercise.write(WRONG)
    exercise.check()
    said = exercise.scene("document.documentElement.dataset.ready && "
                          "(rested || playing || play(true), rested && !playing)")
    yield from lacks(said, "your 1.1; the solution's 1.2 1.3", "Your code parts from the solution "
                     "at t = 0.48 s (step 29), at the ringed joint: the error of its one-sided row",
                     "It is shown up to t = ", "likely mistake: the sign of the block v1")
    seen = exercise.browser.ask(f"""(() => {{
      const canvas = {frame}.document.querySelector("canvas"), pen = canvas.getContext("2d");
      const {{data}} = pen.getImageData(0, 0, canvas.width, canvas.height), counts = [0, 0];
      [[213, 94, 0], [0, 114, 178]].forEach((colour, which) => {{  // yours, the outline
        for (let k = 0; k < data.length; k += 4)
          counts[which] += colour.every((c, i) => Math.abs(data[k + i] - c) < 40);
      }});
      return counts; }})()""")
    if min(seen) < 100:
        yield f"pixels of the reader's bodies and of the outline: {seen}"
    if exercise.is_done():
        yield "wrong code is done"
    exercise.write(WRONG.replace(";", "", 1))
    exercise.check()
    if exercise.ask(".querySelector('.scene iframe')"):
        yield "code that does not compile has a scene"
    exercise.write(RIGHT)
    exercise.check()
    yield from lacks(exercise.scene(),
                     "Your code moves the bodies of every scene as the solution does.")
    yield from exercise.browser.console


def a_rope_moves_a_rope(root, build):
    """the scene below exercise 1.5, the rope's, is the bridge on ropes"""
    exercise = Exercise(tab(Browser)[0].browser, "1.5")
    exercise.take_in(solution())
    yield from lacks(exercise.check(), "done")
    exercise.scene()
    shown = exercise.ask(".querySelector('.scene iframe').contentDocument"
                         ".querySelector('#scenes [aria-pressed=true]').textContent")
    if shown != "rope bridge":
        yield f"the scene is: {shown}"
    exercise.ask(".querySelector('.scene').replaceChildren()")
