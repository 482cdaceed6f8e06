"""GR00T's policy servers as policies: ZeroMQ, MessagePack, arrays as .npy files."""
