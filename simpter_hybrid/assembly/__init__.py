"""Parts in, the text of a model's flat functions out."""
