package simrobot.camera;

/** Surface colour of a face, without light and haze. */
interface Texture {
    /** Transparent. */
    int NOTHING = -1;

    /**
     * Returns the colour as RGB, or {@link #NOTHING}.
     *
     * @param along metres: on an upright face from its first end, on a horizontal one along the world's x
     * @param up metres: on an upright face above the floor, on a horizontal one along the world's y
     */
    int at(double along, double up);

    static Texture plain(int rgb) {
        return (along, up) -> rgb;
    }
}
