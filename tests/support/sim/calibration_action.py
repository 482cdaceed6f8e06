"""Actions of the benchmark `calibration`."""

SIZES = {"score": 1, "success": 1, "end": 1, "delay_s": 1, "fault": 1}
SIZES |= {"vector": 8, "clipped": 2}


def calibration_action(**values: float | list[float]) -> dict[str, list[float]]:
    """Each part holds its list, or its number in every element; 0 without a value."""
    assert values.keys() <= SIZES.keys(), values
    given = {name: values.get(name, 0) for name in SIZES}
    return {
        name: value if isinstance(value, list) else [float(value)] * SIZES[name]
        for name, value in given.items()
    }
