"""One evaluation: workers, processes, progress, result."""
