package simrobot.camera;

/** Colours in the camera image: directional light, and haze that grows with distance. */
final class Shading {
    /** Haze colour, equal to the sky just above the horizon. */
    static final int HAZE = 0xDCE4EA;

    /** Unit vector towards the light. */
    private static final double FROM_X = 0.28;

    private static final double FROM_Y = 0.96;

    private static final double HAZE_METERS = 20;

    private Shading() {}

    /** Returns the brightness of an upright face with this unit normal. */
    static double on(double normalX, double normalY) {
        return 0.82 + 0.18 * (normalX * FROM_X + normalY * FROM_Y);
    }

    static int shaded(int rgb, double brightness) {
        return channel(rgb >> 16, brightness) << 16 | channel(rgb >> 8, brightness) << 8 | channel(rgb, brightness);
    }

    private static int channel(int value, double brightness) {
        return (int) Math.min(255, (value & 0xFF) * brightness);
    }

    /** Returns the share of a colour that remains after haze at this distance, 0 to 1. */
    static double clear(double meters) {
        return Math.exp(-meters / HAZE_METERS);
    }

    static int hazed(int rgb, double clear) {
        return mixed(rgb, HAZE, clear);
    }

    /** @param share of the first colour, 0 to 1 */
    static int mixed(int rgb, int other, double share) {
        int part = (int) (share * 256);
        int rest = 256 - part;
        int redBlue = ((rgb & 0xFF00FF) * part + (other & 0xFF00FF) * rest) >>> 8 & 0xFF00FF;
        int green = ((rgb & 0x00FF00) * part + (other & 0x00FF00) * rest) >>> 8 & 0x00FF00;
        return redBlue | green;
    }
}
