"""The still figures of chapter 04, one function each."""
