"""Pages of the platform, below /hosting: forms of participants and administrators."""
