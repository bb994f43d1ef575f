"""Stacks of boxes: which of them stand for a minute, with which solver and setting."""
from bench.measuring import prints

PROGRAM = "bench/stacks"
main = prints("stacks", PROGRAM)
