package simrobot.world;

import java.util.List;

/** An object in a world that can be added, moved, changed and removed; immutable. */
public interface WorldItem {
    /** The declaration of its kind. */
    ItemKind<?> kind();

    /** The item shifted on the floor, its coordinates rounded to 1 nm against floating-point error. */
    WorldItem movedBy(double dxMeters, double dyMeters);

    /** The positions at which its shape can be changed: a wall's ends, an area's corners, a home's heading. */
    List<Position> handles();

    /**
     * The item with one of its handles moved.
     *
     * @param handle index in {@link #handles}
     */
    WorldItem pulled(int handle, Position to);

    /** The corners of its shape on the floor. */
    default List<Position> outline() {
        return handles();
    }

    /** Its straight edges that stop robots and sonar. */
    default List<Segment> obstacles() {
        return List.of();
    }
}
