"""The items of `question_answering`: tasks, seeds, and the values of an answer.

Shared by the manifest and the simulator. Imports nothing.
"""

from __future__ import annotations

# Task → the largest share of items that a constant answer gets right.
CHANCES = {
    "count": 1 / 6,
    "colour": 1 / 4,
    "side": 1 / 2,
    "nearest": 1 / 3,
    "reachable": 1 / 2,
    "point": 1 / 12,
}
TASKS = tuple(CHANCES)
FIRST_SEEDS = {"val": 6000, "test": 7200}  # whole blocks of BLOCK seeds
BLOCK = 12  # a multiple of the number of answers that each task has
CAMERA = "view"
QUALITY = "standard"
NO_ANSWER = -1.0
NUMBER_MAX = 999_999
LETTERS = "ABCD"
