package simrobot.bitmap;

/**
 * A picture in shades of grey.
 *
 * @param gray width times height values, row by row from the top, 0 black to 255 white; transparent is white
 */
record GrayPicture(int width, int height, byte[] gray) {
    /** Pixels of a floor of 500 by 500 m in cells of 5 cm. */
    static final int MOST_PIXELS = 100_000_000;

    int at(int column, int row) {
        return gray[row * width + column] & 0xff;
    }
}
