"""Families of scenes drawn by seeds: how many of each every setting of the direct solver holds."""
from bench.measuring import prints

PROGRAM = "bench/families"
main = prints("families", PROGRAM, PROGRAM + "_float", words="a scene is held if no joint opens by "
              "1 mm (float: 5 mm) and it gains no 10 %\nof its energy; it is lost beyond 2 cm")
