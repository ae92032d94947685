package simrobot.world;

import java.util.List;
import java.util.Set;

/**
 * A named destination for robots.
 *
 * @param type Goal, GoalWithHeading or Dock, as spelled in the map
 * @param headingRadians anticlockwise from +X; unused for the type Goal
 */
public record Goal(String type, String name, Position position, double headingRadians) implements WorldItem {
    public static final ItemKind<Goal> KIND = new ItemKind<>("goal", Goal.class)
            .text("type", Goal::type)
            .text("name", Goal::name)
            .number("x", ItemField.Unit.METERS, goal -> goal.position.xMeters())
            .number("y", ItemField.Unit.METERS, goal -> goal.position.yMeters())
            .number("heading", ItemField.Unit.DEGREES, Goal::headingRadians)
            .cairn(
                    Set.of("goal", "goalwithheading", "dock"),
                    cairn -> new Goal(cairn.type(), cairn.name(), cairn.position(), cairn.headingRadians()),
                    goal -> new Cairn(goal.type, goal.position, goal.headingRadians, goal.name));

    public Goal {
        FiniteCheck.check("heading", headingRadians);
    }

    @Override
    public ItemKind<Goal> kind() {
        return KIND;
    }

    @Override
    public Goal movedBy(double dxMeters, double dyMeters) {
        return pulled(0, position.movedBy(dxMeters, dyMeters));
    }

    @Override
    public List<Position> handles() {
        return List.of(position);
    }

    @Override
    public Goal pulled(int handle, Position to) {
        return new Goal(type, name, to, headingRadians);
    }
}
