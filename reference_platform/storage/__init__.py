"""The database of the platform; its state as a whole, retention and backup."""
