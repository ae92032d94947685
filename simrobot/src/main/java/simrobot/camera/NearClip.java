package simrobot.camera;

import java.util.Arrays;

/** Clips polygons at the near plane. */
final class NearClip {
    private NearClip() {}

    /** Returns the part of a convex polygon beyond the near plane: ahead and left of each corner, metres. */
    static double[] inFront(PinholeView eye, double[] corners) {
        double[] kept = new double[2 * corners.length];
        int n = 0;
        double a1 = eye.ahead(corners[corners.length - 2], corners[corners.length - 1]);
        double l1 = eye.left(corners[corners.length - 2], corners[corners.length - 1]);
        for (int i = 0; i < corners.length; i += 2) {
            double a2 = eye.ahead(corners[i], corners[i + 1]);
            double l2 = eye.left(corners[i], corners[i + 1]);
            if ((a1 < PinholeView.NEAR_METERS) != (a2 < PinholeView.NEAR_METERS)) {
                double share = (PinholeView.NEAR_METERS - a1) / (a2 - a1);
                kept[n++] = PinholeView.NEAR_METERS;
                kept[n++] = l1 + share * (l2 - l1);
            }
            if (a2 >= PinholeView.NEAR_METERS) {
                kept[n++] = a2;
                kept[n++] = l2;
            }
            a1 = a2;
            l1 = l2;
        }
        return Arrays.copyOf(kept, n);
    }
}
