import java.util.Locale;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Place;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Drives five times round a square of 1 m, and knows where it is by its wheels only. What it believes is drawn in green; its
 * trail is the truth. Wheels slip: with --noise 3 the two part, and at each corner it writes how far.
 */
public class DeadReckoning implements Behaviour {
    private static final double SIDE = 1;
    private static final int CORNERS = 5 * 4;

    private Place start;
    private Place last;
    private int corner = 1;

    @Override
    public Steering decide(Senses senses) {
        Place believed = senses.odometry();
        if (start == null) {
            start = believed;
            last = believed;
        }
        if (distance(believed, last.xMeters(), last.yMeters()) > 0.05) {
            drawLine(last.xMeters(), last.yMeters(), believed.xMeters(), believed.yMeters());
            last = believed;
        }

        double dx = cornerX() - believed.xMeters();
        double dy = cornerY() - believed.yMeters();
        if (Math.hypot(dx, dy) < 0.03) {
            report(believed, senses);
            corner++;
            return Steering.STOP;
        }
        double error = Math.IEEEremainder(Math.atan2(dy, dx) - believed.headingRadians(), 2 * Math.PI);
        return Math.abs(error) > 0.2 ? new Steering(0, Math.signum(error) * 0.8) : new Steering(0.25, 2 * error);
    }

    /** Corners 0, 1, 2, 3 are passed clockwise; 4 is 0 again. */
    private double cornerX() {
        return along(corner % 4 == 1 || corner % 4 == 2, Math.cos(start.headingRadians()), start.xMeters())
                + along(corner % 4 == 2 || corner % 4 == 3, Math.sin(start.headingRadians()), 0);
    }

    private double cornerY() {
        return along(corner % 4 == 1 || corner % 4 == 2, Math.sin(start.headingRadians()), start.yMeters())
                - along(corner % 4 == 2 || corner % 4 == 3, Math.cos(start.headingRadians()), 0);
    }

    private static double along(boolean isFar, double direction, double from) {
        return isFar ? from + SIDE * direction : from;
    }

    private static double distance(Place place, double x, double y) {
        return Math.hypot(place.xMeters() - x, place.yMeters() - y);
    }

    private void report(Place believed, Senses senses) {
        double off = distance(believed, senses.xMeters(), senses.yMeters());
        drawText(senses.xMeters(), senses.yMeters(), String.format(Locale.ROOT, "%.2f", off));
        System.out.printf(Locale.ROOT, "corner %d: off by %.2f m%n", corner, off);
    }

    @Override
    public boolean isDone() {
        return corner > CORNERS;
    }
}
