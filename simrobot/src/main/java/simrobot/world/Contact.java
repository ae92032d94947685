package simrobot.world;

/**
 * The first contact of a disc on a straight path.
 *
 * @param fraction free share of the path, 0..1; 1 without a contact
 * @param normalX with normalY the unit vector from the obstacle to the disc's centre; both 0 without a contact
 */
public record Contact(double fraction, double normalX, double normalY) {
    public static final Contact NONE = new Contact(1, 0, 0);

    public boolean touches() {
        return this != NONE;
    }

    /** The earlier of two contacts; on a tie this one. */
    public Contact earlier(Contact other) {
        return other.touches() && (!touches() || other.fraction < fraction) ? other : this;
    }
}
