"""The kit for simulators (spec/simulator.md): it starts a program and asks it."""
