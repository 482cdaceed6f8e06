"""What a policy author imports."""
