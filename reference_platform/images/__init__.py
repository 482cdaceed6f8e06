"""Images and code that people upload: received, reviewed, and unpacked safely."""
