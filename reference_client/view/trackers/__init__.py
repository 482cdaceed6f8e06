"""Experiment trackers: Weights & Biases, TensorBoard and MLflow receive an evaluation.

`tracking` decides what is sent and when; `tracker_libraries` has one class for each
library, which is imported only when it is chosen.
"""
