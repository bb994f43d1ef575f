"""The experiments that a chapter's text quotes beyond its program: they run on the solution."""
from base import house
from learn import show


def main(chapter, options):
    """Without options their tables are those of the text, and lie beside the program's."""
    if len(chapter.programs) == 1:
        raise house.Trouble(f"bench {chapter.number}: the program of chapter {chapter.number} is "
                            f"all there is: ./wb run {chapter.number}")
    *_, program = chapter.programs
    if {"--help", "-h"} & set(options):
        return house.tell_options(program)
    house.must_build(chapter.programs)
    if not options:
        folder = show.SOLUTIONS / chapter.folder
        show.call_programs(chapter.programs[:1], folder, [], True)
        show.call_program(program, folder, [], False)
        print(f"tables: {house.short(folder)}/   figures: ./wb plot {chapter.number}   "
              f"motion: ./wb see {chapter.number}")
        return 0
    folder = house.OUT / "experiments" / chapter.folder
    show.call_programs([program], folder, options, False)
    print(f"tables: {house.short(folder)}/")
    if any(folder.glob("*.motion.json")):
        print(f"motion: {house.short(show.make_page(chapter, folder, None, '_experiments'))}")
    return 0
