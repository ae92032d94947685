package simrobot.world;

import java.util.ArrayList;
import java.util.List;

/** Collects what a reader finds. */
final class WorldBuilder {
    final List<Segment> segments = new ArrayList<>();
    final List<Position> points = new ArrayList<>();
    final List<Box> boxes = new ArrayList<>();
    final List<Home> homes = new ArrayList<>();
    final List<Segment> forbiddenLines = new ArrayList<>();
    final List<Area> forbiddenAreas = new ArrayList<>();
    final List<Treadmill> treadmills = new ArrayList<>();
    final List<Goal> goals = new ArrayList<>();

    /** ARIA's usual {@code Resolution: 20}, in metres. */
    double pointDiameterMeters = 0.02;

    World build(String name) {
        return new World(
                name,
                segments,
                points,
                pointDiameterMeters,
                boxes,
                homes,
                forbiddenLines,
                forbiddenAreas,
                treadmills,
                goals);
    }
}
