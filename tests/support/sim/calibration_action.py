"""Actions of the benchmark `calibration`."""

SIZES = {
    "score": 1,
    "success": 1,
    "end": 1,
    "delay_s": 1,
    "fault": 1,
    "vector": 8,
    "clipped": 2,
}


def calibration_action(**values: float) -> dict[str, list[float]]:
    """Each part holds its value in every element, 0 without one."""
    assert values.keys() <= SIZES.keys(), values
    return {name: [float(values.get(name, 0))] * size for name, size in SIZES.items()}
