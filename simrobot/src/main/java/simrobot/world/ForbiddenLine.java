package simrobot.world;

import java.util.List;
import java.util.Set;

/** A line that planners do not cross; wheels can. */
public record ForbiddenLine(Segment line) implements WorldItem {
    public static final ItemKind<ForbiddenLine> KIND = new ItemKind<>("forbidden-line", ForbiddenLine.class)
            .corners(item -> item.line.ends())
            .cairn(
                    Set.of("forbiddenline"),
                    cairn -> new ForbiddenLine(cairn.requiredLine()),
                    item -> new Cairn("ForbiddenLine", item.line.middle(), 0, "", item.line.ends()));

    @Override
    public ItemKind<ForbiddenLine> kind() {
        return KIND;
    }

    @Override
    public ForbiddenLine movedBy(double dxMeters, double dyMeters) {
        return new ForbiddenLine(line.movedBy(dxMeters, dyMeters));
    }

    @Override
    public List<Position> handles() {
        return line.handles();
    }

    @Override
    public ForbiddenLine pulled(int handle, Position to) {
        return new ForbiddenLine(line.pulled(handle, to));
    }
}
