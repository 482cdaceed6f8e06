"""The formats that a record is made of, read within bounds: zip, DSSE, JSON."""
