"""`proctor replay`: the recorded actions of a record, simulated again."""
