"""The clusters that the campaign breaks: links on this machine, or hosts."""
