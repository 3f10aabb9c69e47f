"""What real rigs do and the measuring program's model lacks: one small model an effect, with a magnitude, drawn from the seed."""
