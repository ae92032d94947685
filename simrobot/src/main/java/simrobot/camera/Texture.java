package simrobot.camera;

/** What a face looks like, without light and haze. */
interface Texture {
    /** Nothing is there; one looks through. */
    int NOTHING = -1;

    /**
     * A colour, or {@link #NOTHING}.
     *
     * @param along metres: of an upright face from its first end, of a level one along the world's x
     * @param up metres: of an upright face above the floor, of a level one along the world's y
     */
    int at(double along, double up);

    static Texture plain(int rgb) {
        return (along, up) -> rgb;
    }
}
