"""What a right server would answer, computed independently. Sends nothing."""
