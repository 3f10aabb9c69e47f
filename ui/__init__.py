"""The Qt application: views, controllers, workers and the viewport."""
