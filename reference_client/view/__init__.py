"""The live view: a page with each worker's images, score and times."""
