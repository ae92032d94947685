import java.util.Locale;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Drives five times round a square of 1 m, and knows where it is by its wheels only. What it believes is drawn in green; its
 * trail is the truth. Wheels slip: with --noise 3 the two part, and after each round it writes on the floor how far.
 */
public class DeadReckoning implements Behaviour {
    private static final double SIDE = 1;
    private static final int CORNERS = 5 * 4;

    private OdometryPose last;
    private double sideHeading;
    private double cornerX;
    private double cornerY;
    private int passed = -1;

    @Override
    public Steering decide(Senses senses) {
        OdometryPose believed = senses.odometry();
        if (last == null) {
            last = believed;
            sideHeading = believed.headingRadians() + Math.PI / 2;
            cornerX = believed.xMeters();
            cornerY = believed.yMeters();
        }
        if (distance(believed, last.xMeters(), last.yMeters()) > 0.05) {
            drawLine(last.xMeters(), last.yMeters(), believed.xMeters(), believed.yMeters());
            last = believed;
        }
        if (distance(believed, cornerX, cornerY) < 0.03) {
            report(believed, senses);
            sideHeading -= Math.PI / 2;
            cornerX += SIDE * Math.cos(sideHeading);
            cornerY += SIDE * Math.sin(sideHeading);
        }
        double direction = Math.atan2(cornerY - believed.yMeters(), cornerX - believed.xMeters());
        double error = Math.IEEEremainder(direction - believed.headingRadians(), 2 * Math.PI);
        return Math.abs(error) > 0.2 ? new Steering(0, Math.signum(error) * 0.8) : new Steering(0.25, 2 * error);
    }

    private static double distance(OdometryPose place, double x, double y) {
        return Math.hypot(place.xMeters() - x, place.yMeters() - y);
    }

    private void report(OdometryPose believed, Senses senses) {
        passed++;
        double off = distance(believed, senses.xMeters(), senses.yMeters());
        System.out.printf(Locale.ROOT, "corner %d: off by %.2f m%n", passed, off);
        if (passed % 4 == 0) {
            drawText(senses.xMeters(), senses.yMeters(), String.format(Locale.ROOT, "%.2f m", off));
        }
    }

    @Override
    public boolean isDone() {
        return passed == CORNERS;
    }
}
