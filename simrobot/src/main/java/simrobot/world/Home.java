package simrobot.world;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A robot's start.
 *
 * @param name the name in the file, may be empty
 * @param headingRadians anticlockwise from +X
 * @param area the home's rectangle if the file gives one
 */
public record Home(String name, Position position, double headingRadians, Optional<Area> area) implements WorldItem {
    /** Distance of the turning handle from the home's middle. */
    private static final double HEADING_HANDLE_METERS = 0.6;

    public static final ItemKind<Home> KIND = new ItemKind<>("home", Home.class)
            .text("name", Home::name)
            .number("x", ItemField.Unit.METERS, home -> home.position.xMeters())
            .number("y", ItemField.Unit.METERS, home -> home.position.yMeters())
            .number("heading", ItemField.Unit.DEGREES, Home::headingRadians)
            .cairn(Set.of("robothome"), Home::read, Home::cairn)
            .edited(
                    ItemKind.Shape.PLACE,
                    values -> new Home(
                            (String) values.get("name"),
                            new Position((Double) values.get("x"), (Double) values.get("y")),
                            (Double) values.get("heading")),
                    (world, from, to) -> new Home(freeName(world), from, towards(from, to)));

    public Home {
        FiniteCheck.check("heading", headingRadians);
    }

    /** A home without a rectangle. */
    public Home(String name, Position position, double headingRadians) {
        this(name, position, headingRadians, Optional.empty());
    }

    private static Home read(Cairn cairn) {
        Optional<Area> area = cairn.area();
        Position at = cairn.position();
        boolean isOutside = area.isPresent() && !area.get().contains(at.xMeters(), at.yMeters());
        return new Home(cairn.name(), isOutside ? area.get().center() : at, cairn.headingRadians(), area);
    }

    /** The format rotates a home's area by the home's heading; areas with another rotation are omitted. */
    private Cairn cairn() {
        double[] corners = area.filter(here -> here.rotationRadians() == headingRadians)
                .map(Area::ends)
                .orElse(new double[0]);
        return new Cairn("RobotHome", position, headingRadians, name, corners);
    }

    /** A free name: Home1, Home2 ... */
    private static String freeName(World world) {
        List<String> taken = world.items(Home.class).stream().map(Home::name).toList();
        int number = taken.size() + 1;
        while (taken.contains("Home" + number)) {
            number++;
        }
        return "Home" + number;
    }

    /** The direction in whole degrees; 0 if both positions are equal. */
    private static double towards(Position from, Position to) {
        double radians = Math.atan2(to.yMeters() - from.yMeters(), to.xMeters() - from.xMeters());
        return Math.toRadians(Math.rint(Math.toDegrees(radians)));
    }

    @Override
    public ItemKind<Home> kind() {
        return KIND;
    }

    @Override
    public Home movedBy(double dxMeters, double dyMeters) {
        return new Home(
                name,
                position.movedBy(dxMeters, dyMeters),
                headingRadians,
                area.map(here -> here.movedBy(dxMeters, dyMeters)));
    }

    @Override
    public List<Position> handles() {
        return List.of(new Position(
                position.xMeters() + HEADING_HANDLE_METERS * Math.cos(headingRadians),
                position.yMeters() + HEADING_HANDLE_METERS * Math.sin(headingRadians)));
    }

    @Override
    public List<Position> outline() {
        return List.of(position);
    }

    /** The home turned towards a position, in whole degrees; a turned home has no area. */
    @Override
    public Home pulled(int handle, Position to) {
        return new Home(name, position, towards(position, to));
    }
}
