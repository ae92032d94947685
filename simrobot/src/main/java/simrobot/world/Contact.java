package simrobot.world;

/**
 * How far a disc may go along a straight way before it touches something.
 *
 * @param fraction of the way that is free, 0..1; 1 when nothing is touched
 * @param normalX with normalY the unit vector from what is touched to the disc's centre; both 0 when nothing is
 */
public record Contact(double fraction, double normalX, double normalY) {
    public static final Contact NONE = new Contact(1, 0, 0);

    public boolean touches() {
        return this != NONE;
    }

    /** The contact that comes first; on a tie this one. */
    public Contact earlier(Contact other) {
        return other.touches() && (!touches() || other.fraction < fraction) ? other : this;
    }
}
