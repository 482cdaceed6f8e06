"""The interface of a policy author: `Policy` to implement, `Observation` to read."""
