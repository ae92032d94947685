package simrobot.camera;

/** Draws upright and horizontal faces with a depth test for each pixel. */
final class FacePainter {
    private final PixelBuffer canvas;
    private final PinholeView eye;

    FacePainter(PixelBuffer canvas, PinholeView eye) {
        this.canvas = canvas;
        this.eye = eye;
    }

    /** Draws an upright face between two points; visible from both sides. */
    void upright(double x1, double y1, double x2, double y2, double low, double high, Texture surface) {
        double a1 = eye.ahead(x1, y1);
        double l1 = eye.left(x1, y1);
        double a2 = eye.ahead(x2, y2);
        double l2 = eye.left(x2, y2);
        if (a1 < PinholeView.NEAR_METERS && a2 < PinholeView.NEAR_METERS) {
            return;
        }
        double length = Math.hypot(x2 - x1, y2 - y1);
        double brightness = FaceBrightness.towards(eye, x1, y1, x2, y2);
        ColumnRange columns = ColumnRange.of(eye, a1, l1, a2, l2);
        for (int c = columns.first(); c <= columns.last(); c++) {
            double share = ColumnRange.share(eye.slope(c), a1, l1, a2, l2);
            double ahead = a1 + share * (a2 - a1);
            if (ahead >= PinholeView.NEAR_METERS) {
                column(c, ahead, share * length, low, high, surface, brightness);
            }
        }
    }

    private void column(
            int c, double ahead, double along, double low, double high, Texture surface, double brightness) {
        int top = Math.max(0, (int) Math.ceil(eye.row(ahead, high) - 0.5));
        int bottom = Math.min(canvas.height - 1, (int) Math.ceil(eye.row(ahead, low) - 0.5) - 1);
        double clear = Shading.clear(ahead);
        for (int r = top; r <= bottom; r++) {
            int colour = surface.at(along, eye.heightAt(r, ahead));
            if (colour != Texture.NOTHING) {
                canvas.set(r * canvas.width + c, Shading.hazed(Shading.shaded(colour, brightness), clear), ahead);
            }
        }
    }

    /**
     * Draws a horizontal convex face below the eye.
     *
     * @param corners x and y of each corner in turn, metres
     */
    void level(double[] corners, double z, Texture surface) {
        double[] seen = NearClip.inFront(eye, corners);
        if (seen.length == 0) {
            return;
        }
        int n = seen.length / 2;
        double[] columns = new double[n];
        double[] rows = new double[n];
        double top = Double.POSITIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < n; i++) {
            columns[i] = eye.column(seen[2 * i], seen[2 * i + 1]);
            rows[i] = eye.row(seen[2 * i], z);
            top = Math.min(top, rows[i]);
            bottom = Math.max(bottom, rows[i]);
        }
        int last = Math.min(canvas.height - 1, (int) Math.ceil(bottom - 0.5) - 1);
        for (int r = Math.max(0, (int) Math.ceil(top - 0.5)); r <= last; r++) {
            row(r, columns, rows, z, surface);
        }
    }

    private void row(int r, double[] columns, double[] rows, double z, Texture surface) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double y = r + 0.5;
        for (int i = 0, j = columns.length - 1; i < columns.length; j = i++) {
            if ((rows[i] <= y) != (rows[j] <= y)) {
                double x = columns[i] + (y - rows[i]) / (rows[j] - rows[i]) * (columns[j] - columns[i]);
                left = Math.min(left, x);
                right = Math.max(right, x);
            }
        }
        double ahead = eye.depthOf(r, z);
        double clear = Shading.clear(ahead);
        int last = (int) Math.min(canvas.width - 1.0, Math.ceil(right - 0.5) - 1);
        for (int c = (int) Math.max(0, Math.ceil(left - 0.5)); c <= last; c++) {
            double beside = eye.slope(c) * ahead;
            int colour = surface.at(eye.worldX(ahead, beside), eye.worldY(ahead, beside));
            if (colour != Texture.NOTHING) {
                canvas.set(r * canvas.width + c, Shading.hazed(colour, clear), ahead);
            }
        }
    }
}
