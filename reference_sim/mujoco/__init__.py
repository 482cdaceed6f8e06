"""What MuJoCo benchmarks share: the world, cameras, kinematics."""
