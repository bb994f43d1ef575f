"""Who does not use the direct solver does not carry it: direct_solver_test.py ROOT BUILD"""
import re
import sys

from proofs import main, programs_that_carry

SYMBOLS = re.compile(
    r"joints::(?:DirectSolver|JointIslands|JointSystem|elimination_order)\b")
CHAPTER = 9  # where all that is found


def earlier_programs_carry_no_direct_solver(root, build):
    """no program of an earlier chapter carries the direct solver, this chapter's does"""
    yield from programs_that_carry(build, CHAPTER, SYMBOLS,
                                   {"joints::DirectSolver", "joints::elimination_order"})


PROOFS = [earlier_programs_carry_no_direct_solver]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
