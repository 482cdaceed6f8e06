"""A Proctor server as a Gymnasium environment."""
