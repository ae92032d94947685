package simrobot.camera;

/**
 * Position and axis of a pinhole camera with a horizontal axis. In its coordinates {@code ahead} is the depth along the
 * axis and {@code left} the distance to the left of it; metres, pixels.
 *
 * @param cos with sin the unit vector of the axis
 * @param width with height the size of the image, pixels
 * @param focal focal length, pixels
 */
record PinholeView(double x, double y, double z, double cos, double sin, int width, int height, double focal) {
    /** Near plane: nothing nearer is drawn. */
    static final double NEAR_METERS = 0.03;

    static PinholeView at(
            double x, double y, double z, double headingRadians, int width, int height, double openingRadians) {
        double focal = width / 2.0 / Math.tan(openingRadians / 2);
        return new PinholeView(x, y, z, Math.cos(headingRadians), Math.sin(headingRadians), width, height, focal);
    }

    double ahead(double px, double py) {
        return (px - x) * cos + (py - y) * sin;
    }

    double left(double px, double py) {
        return (py - y) * cos - (px - x) * sin;
    }

    double column(double ahead, double left) {
        return width / 2.0 - focal * left / ahead;
    }

    double row(double ahead, double pz) {
        return height / 2.0 - focal * (pz - z) / ahead;
    }

    /** Returns left / ahead of the ray through a column's centre. */
    double slope(int column) {
        return (width / 2.0 - column - 0.5) / focal;
    }

    /** Returns the height of the ray through a row's centre at this depth. */
    double heightAt(int row, double ahead) {
        return z + (height / 2.0 - row - 0.5) * ahead / focal;
    }

    /** Returns the depth at which the ray through a row's centre reaches this height; infinite if it never does. */
    double depthOf(int row, double pz) {
        double drop = row + 0.5 - height / 2.0;
        double depth = (z - pz) * focal / drop;
        return depth > 0 ? depth : Double.POSITIVE_INFINITY;
    }

    double worldX(double ahead, double left) {
        return x + ahead * cos - left * sin;
    }

    double worldY(double ahead, double left) {
        return y + ahead * sin + left * cos;
    }

    /** True if a disc on the floor may be visible. */
    boolean mayShow(double px, double py, double radius, double range) {
        double ahead = ahead(px, py);
        double edge = (width / 2.0 / focal) * Math.max(0, ahead) + 2 * radius;
        return ahead > -radius && ahead < range + radius && Math.abs(left(px, py)) <= edge;
    }
}
