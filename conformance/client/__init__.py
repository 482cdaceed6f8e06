"""What a check talks to the server with; every exchange is logged."""
