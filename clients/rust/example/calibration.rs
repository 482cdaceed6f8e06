//! What `spec/calibration.md` says of actions.

use std::collections::HashMap;

use proctor_client::models::Action;

/// One action of `calibration`; its success is a score above one half.
pub fn act(score: f64) -> Action {
    let success = if score > 0.5 { 1.0 } else { 0.0 };
    let mut values = HashMap::from([("vector".to_owned(), vec![0.0; 8]), ("clipped".to_owned(), vec![0.0; 2])]);
    for (name, value) in [("score", score), ("success", success), ("end", 0.0), ("delay_s", 0.0), ("fault", 0.0)] {
        values.insert(name.to_owned(), vec![value]);
    }
    Action::new(values)
}
