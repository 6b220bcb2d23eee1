"""The still figures of chapter 08, one function each, and what they are drawn from."""
