"""Notes on numbers of an answer that a mapping leaves out, or reads twice.

A model may pad its rows, so none of it is refused. But a whole chunk in one row, a
transposed chunk and a mistyped column look the same, and play to a score.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from reference_client.policies.mapping.action_vector import ActionVector
from reference_client.policies.mapping.members import Array, indices_of
from reference_record.texts.counted_text import counted

Rows = Mapping[str | None, Array]


def notes_on_unread(
    vectors: Iterable[ActionVector], source: str | None, rows_by_place: Rows
) -> Iterator[str]:
    """A sentence on each place of the answer that may be read wrongly.

    source: the place of the vectors that name none.
    """
    reads = Counter(
        read for vector in vectors for read in _reads(vector, source, rows_by_place)
    )
    for place, rows in rows_by_place.items():
        actions, width = rows.shape
        read = [column for column in range(width) if reads[place, column]]
        twice = [column for column in read if reads[place, column] > 1]
        unread = [column for column in range(width) if column not in read]
        is_one_row = actions == 1 and read and width % len(read) == 0
        is_turned = actions == len(read) > 1
        is_narrow = 2 * len(read) < width
        if not unread or not (twice or is_one_row or is_turned or is_narrow):
            continue
        where = f"`{place}`" if place else "the answer"
        note = f"each row of {where} has {counted(width, 'number')}; the mapping reads "
        note += f"{len(read)} of them"
        if twice:
            note += f", column {_listed(twice)} more than once, {_listed(unread)} never"
        elif is_one_row:
            note += ". It is one row: a chunk is answered as (actions, numbers)"
        elif is_turned:
            note += f", and there are {actions} rows. A chunk is answered as (actions, "
            note += "numbers); this one may be (numbers, actions)"
        yield f"{note}."


def _reads(
    vector: ActionVector, source: str | None, rows_by_place: Rows
) -> list[tuple[str | None, int]]:
    """The place and the column of each number that the vector is made of."""
    if vector.value is not None:
        return []
    joined = [
        (place, column)
        for place in vector.source or (source,)
        for column in range(rows_by_place[place].shape[1])
    ]
    if vector.columns is None:
        return joined
    return [joined[index] for index in indices_of(vector.columns)]


def _listed(columns: list[int]) -> str:
    first = ", ".join(map(str, columns[:4]))
    return f"{first} …" if len(columns) > 4 else first
