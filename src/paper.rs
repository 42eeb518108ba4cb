#![doc = include_str!("paper.md")]
