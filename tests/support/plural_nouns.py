"""Finds `1 episodes` in what people read."""

import re

ONE_OF_MANY = re.compile(
    r"(?<![\d.,])1(</b>)? ?"
    r"(actions|attempts|entries|episodes|failures|faults|pages|runs|steps|turns|videos)\b"
)
