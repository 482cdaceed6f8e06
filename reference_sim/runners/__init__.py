"""Where simulator processes run."""
