"""Robot cells: whose turn it is, and what a person does between two attempts."""
