package simrobot.world;

import java.util.List;
import java.util.Set;

/** A piece of furniture: its four sides are obstacles (MobileSim's {@code Sim.BoxObstacle}). */
public record Box(String name, Area area) implements AreaItem {
    public static final ItemKind<Box> KIND = new ItemKind<>("box", Box.class)
            .text("name", Box::name)
            .corners(box -> box.area.ends())
            .field("rotation", ItemField.Unit.DEGREES, box -> box.area.rotationRadians(), false)
            .cairn(
                    Set.of("sim.boxobstacle"),
                    cairn -> new Box(cairn.name(), cairn.requiredArea()),
                    box -> new Cairn("Sim.BoxObstacle", box.area, box.name))
            .edited(
                    ItemKind.Shape.AREA,
                    values -> new Box((String) values.get("name"), ItemKind.area(values)),
                    (world, from, to) -> new Box("", Area.between(from, to)));

    @Override
    public ItemKind<Box> kind() {
        return KIND;
    }

    @Override
    public Box over(Area newArea) {
        return new Box(name, newArea);
    }

    @Override
    public List<Segment> obstacles() {
        return area.sides();
    }
}
