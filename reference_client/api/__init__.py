"""What a policy author implements (`Policy`) and receives (`Observation`)."""
