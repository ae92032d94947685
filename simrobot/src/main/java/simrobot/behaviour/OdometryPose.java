package simrobot.behaviour;

/** A place and a heading in the world: metres, and radians anticlockwise from +X. */
public record OdometryPose(double xMeters, double yMeters, double headingRadians) {}
