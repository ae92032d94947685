package simrobot.world;

import java.util.List;

/** An item with the shape of a rectangle. */
public interface AreaItem extends WorldItem {
    Area area();

    /** The same item with another rectangle. */
    AreaItem over(Area newArea);

    @Override
    default AreaItem movedBy(double dxMeters, double dyMeters) {
        return over(area().movedBy(dxMeters, dyMeters));
    }

    @Override
    default List<Position> handles() {
        return area().corners();
    }

    @Override
    default AreaItem pulled(int handle, Position to) {
        return over(area().pulled(handle, to));
    }
}
