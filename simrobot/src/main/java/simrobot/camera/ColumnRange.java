package simrobot.camera;

/** Columns with their centres covered by an upright face; empty if first is greater than last. */
record ColumnRange(int first, int last) {
    private static final ColumnRange NONE = new ColumnRange(1, 0);

    /** Returns the columns of a face between two points in the eye's coordinates. */
    static ColumnRange of(PinholeView eye, double a1, double l1, double a2, double l2) {
        if (a1 < PinholeView.NEAR_METERS && a2 < PinholeView.NEAR_METERS) {
            return NONE;
        }
        double one = edge(eye, a1, l1, a2, l2);
        double other = edge(eye, a2, l2, a1, l1);
        int first = (int) Math.max(0, Math.ceil(Math.min(one, other) - 0.5));
        int last = (int) Math.min(eye.width() - 1.0, Math.ceil(Math.max(one, other) - 0.5) - 1);
        return new ColumnRange(first, last);
    }

    /** Returns the column of the first point, or of the face's intersection with the near plane. */
    private static double edge(PinholeView eye, double ahead, double left, double otherAhead, double otherLeft) {
        if (ahead >= PinholeView.NEAR_METERS) {
            return eye.column(ahead, left);
        }
        double share = (PinholeView.NEAR_METERS - ahead) / (otherAhead - ahead);
        return eye.column(PinholeView.NEAR_METERS, left + share * (otherLeft - left));
    }

    /** Returns the intersection of the ray of this slope with the face: 0 at the first point, 1 at the second. */
    static double share(double slope, double a1, double l1, double a2, double l2) {
        double across = (l2 - l1) - slope * (a2 - a1);
        double share = across == 0 ? 0 : (slope * a1 - l1) / across;
        return Math.max(0, Math.min(1, share));
    }
}
