package simrobot.world;

import java.util.Set;

/** An area that planners do not enter; wheels can. */
public record ForbiddenArea(Area area) implements AreaItem {
    public static final ItemKind<ForbiddenArea> KIND = new ItemKind<>("forbidden-area", ForbiddenArea.class)
            .corners(item -> item.area.ends())
            .field("rotation", ItemField.Unit.DEGREES, item -> item.area.rotationRadians(), false)
            .cairn(
                    Set.of("forbiddenarea"),
                    cairn -> new ForbiddenArea(cairn.requiredArea()),
                    item -> new Cairn("ForbiddenArea", item.area, ""));

    @Override
    public ItemKind<ForbiddenArea> kind() {
        return KIND;
    }

    @Override
    public ForbiddenArea over(Area newArea) {
        return new ForbiddenArea(newArea);
    }
}
