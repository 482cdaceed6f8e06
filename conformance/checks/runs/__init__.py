"""Checks of runs: lifecycle, stop and resume, episodes, scores, crashes."""
