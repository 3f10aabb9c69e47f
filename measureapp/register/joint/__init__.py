"""All views: their poses by axes and pairs together, how they close around the part, and which contradict."""
