package simrobot.world;

import java.util.Set;

/**
 * A belt in the floor that moves every robot whose centre of rotation is on it. An addition to the map format: wheels slip on
 * it, so that the paper's "infinite loop" can occur.
 *
 * @param area not rotated
 * @param speedMetersPerSecond along the direction; negative runs against it
 * @param directionRadians anticlockwise from +X
 */
public record Treadmill(Area area, double speedMetersPerSecond, double directionRadians) implements Surface {
    private static final double DRAWN_METERS_PER_SECOND = 0.3;

    public static final ItemKind<Treadmill> KIND = new ItemKind<>("treadmill", Treadmill.class)
            .corners(belt -> belt.area.ends())
            .field("rotation", ItemField.Unit.DEGREES, belt -> belt.area.rotationRadians(), false)
            .number("speed", ItemField.Unit.METERS_PER_SECOND, Treadmill::speedMetersPerSecond)
            .number("direction", ItemField.Unit.DEGREES, Treadmill::directionRadians)
            .cairn(
                    Set.of("sim.treadmill"),
                    cairn -> new Treadmill(
                            cairn.requiredUprightArea(),
                            // the name of a belt is its speed, v=-300, in mm/s
                            cairn.thousandth("v", "a belt speed \"v=...\" in mm/s", 10),
                            cairn.headingRadians()),
                    Treadmill::cairn)
            .edited(
                    ItemKind.Shape.AREA,
                    values -> new Treadmill(
                            ItemKind.area(values), (Double) values.get("speed"), (Double) values.get("direction")),
                    (world, from, to) -> new Treadmill(Area.between(from, to), DRAWN_METERS_PER_SECOND, 0));

    public Treadmill {
        FiniteCheck.check("belt speed", speedMetersPerSecond);
        FiniteCheck.check("direction", directionRadians);
    }

    private Cairn cairn() {
        String speed = "v=" + MapWriter.millimeters(speedMetersPerSecond);
        return new Cairn("Sim.Treadmill", area.center(), directionRadians, speed, area.ends());
    }

    @Override
    public ItemKind<Treadmill> kind() {
        return KIND;
    }

    @Override
    public Treadmill over(Area newArea) {
        return new Treadmill(newArea, speedMetersPerSecond, directionRadians);
    }

    @Override
    public double velocityX() {
        return speedMetersPerSecond * Math.cos(directionRadians);
    }

    @Override
    public double velocityY() {
        return speedMetersPerSecond * Math.sin(directionRadians);
    }

    @Override
    public int cameraColour() {
        return 0x4A4F57;
    }
}
