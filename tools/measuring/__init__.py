"""Sizes, cycles and times of the library, beside those of the baseline.

All of it is counted by the linker or by the simulated Mega, to the byte and to the cycle:
two runs give the same figures.
"""
