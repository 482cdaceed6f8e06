"""The actions of the benchmark `calibration`, as spec/calibration.md has them."""

from proctor_client import Action


def act(score: float, **values: list[float]) -> Action:
    """One action of `calibration`; its success is a score above one half."""
    still = {"end": [0.0], "delay_s": [0.0], "fault": [0.0],
             "vector": [0.0] * 8, "clipped": [0.0] * 2}
    return Action(values={**still, "score": [score],
                          "success": [float(score > 0.5)], **values})
