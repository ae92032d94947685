package simrobot.camera;

/** Computes the brightness of the visible side of an upright face. */
final class FaceBrightness {
    private FaceBrightness() {}

    static double towards(PinholeView eye, double x1, double y1, double x2, double y2) {
        double nx = y2 - y1;
        double ny = x1 - x2;
        double length = Math.sqrt(nx * nx + ny * ny);
        if (length == 0) {
            return Shading.on(0, 0);
        }
        double sense = (eye.x() - x1) * nx + (eye.y() - y1) * ny < 0 ? -1 / length : 1 / length;
        return Shading.on(nx * sense, ny * sense);
    }
}
