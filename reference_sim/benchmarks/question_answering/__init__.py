"""Questions about pictures of the tabletop scene, answered by a vector of numbers."""
