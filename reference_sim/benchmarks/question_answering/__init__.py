"""Questions about images of the tabletop scene, answered by one action."""
