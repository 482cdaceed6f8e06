"""Shared by the MuJoCo benchmarks: physics, rendering, kinematics, tasks.

Import the library itself as `mujoco`: imports are absolute.
"""
