"""Texts that all programs write alike: counts, times, texts within a length."""
