// Units of chapter 8.
