"""Sessions that go on in another process, after the end of the one that had them."""
