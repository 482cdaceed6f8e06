"""Submissions go through a host whose programs fail at random; each is judged."""
