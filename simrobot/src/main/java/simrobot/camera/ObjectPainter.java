package simrobot.camera;

import java.util.List;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.world.Box;
import simrobot.world.Position;

/** Draws objects lower than a wall: furniture, and robots as red octagons with a black deck and a camera. */
final class ObjectPainter {
    private static final int FURNITURE = 0xB98F5E;
    private static final int FURNITURE_RIM = 0x8A6740;
    private static final double FURNITURE_METERS = 0.5;
    private static final double RIM_METERS = 0.03;

    private static final int RED = 0xC8171E;
    private static final int BLACK = 0x26282C;
    private static final int DISC = 0xD8A93A;
    private static final int TYRE = 0x1C1D20;
    private static final int HUB = 0x6A6F78;
    private static final int WHITE = 0xF2F2F2;
    private static final int LENS = 0x5C86B8;

    private static final double GROUND_CLEARANCE_METERS = 0.045;
    private static final double RING_LOW_METERS = 0.155;
    private static final double RING_HIGH_METERS = 0.205;
    private static final double DECK_METERS = 0.22;
    private static final double DISC_SPACING_METERS = 0.085;
    private static final double DISC_RADIUS_METERS = 0.019;
    private static final double MAST_METERS = 0.33;
    private static final double MAST_X = 0.06;
    private static final double MAST_HALF = 0.035;
    private static final double RANGE_METERS = 40;
    private static final double REACH_METERS = 0.3;

    private static final double[][] OCTAGON = Pioneer2Dx.octagon();

    private final FacePainter painter;
    private final PinholeView eye;

    ObjectPainter(PixelBuffer canvas, PinholeView eye) {
        painter = new FacePainter(canvas, eye);
        this.eye = eye;
    }

    void furniture(Box box) {
        List<Position> corners = box.area().corners();
        for (int i = 0; i < corners.size(); i++) {
            Position from = corners.get(i);
            Position to = corners.get((i + 1) % corners.size());
            double length = Math.hypot(to.xMeters() - from.xMeters(), to.yMeters() - from.yMeters());
            painter.upright(
                    from.xMeters(),
                    from.yMeters(),
                    to.xMeters(),
                    to.yMeters(),
                    0,
                    FURNITURE_METERS,
                    (along, up) ->
                            up > FURNITURE_METERS - RIM_METERS || Math.min(along, length - along) < RIM_METERS / 2
                                    ? FURNITURE_RIM
                                    : FURNITURE);
        }
    }

    void robot(RobotSnapshot robot) {
        if (!eye.mayShow(robot.xMeters(), robot.yMeters(), REACH_METERS, RANGE_METERS)) {
            return;
        }
        Frame frame = new Frame(robot);
        double[] deck = new double[2 * OCTAGON.length];
        double[] from = OCTAGON[OCTAGON.length - 1];
        for (int i = 0; i < OCTAGON.length; i++) {
            double[] to = OCTAGON[i];
            side(frame, from, to);
            deck[2 * i] = frame.x(to[0], to[1]);
            deck[2 * i + 1] = frame.y(to[0], to[1]);
            from = to;
        }
        painter.level(deck, DECK_METERS, (x, y) -> onDeck(frame.ahead(x, y), frame.left(x, y)));
        wheel(frame, Pioneer2Dx.WIDTH_METERS / 2 + 0.006);
        wheel(frame, -Pioneer2Dx.WIDTH_METERS / 2 - 0.006);
        camera(frame);
    }

    private void side(Frame frame, double[] from, double[] to) {
        double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
        upright(frame, from, to, GROUND_CLEARANCE_METERS, DECK_METERS, (along, up) -> onSide(along, length, up));
    }

    /** Returns the colour of a robot's side: red, with a black sonar ring and a black deck edge above it. */
    private static int onSide(double along, double length, double up) {
        if (up < RING_LOW_METERS) {
            return RED;
        }
        if (up > RING_HIGH_METERS) {
            return BLACK;
        }
        double middle = (RING_LOW_METERS + RING_HIGH_METERS) / 2;
        int discs = (int) (length / DISC_SPACING_METERS);
        double shift = discs % 2 == 0 ? DISC_SPACING_METERS / 2 : 0;
        double fromDisc = Math.IEEEremainder(along - length / 2 + shift, DISC_SPACING_METERS);
        return Math.hypot(fromDisc, up - middle) < DISC_RADIUS_METERS ? DISC : BLACK;
    }

    /** Returns the colour of the deck: black, with a white arrowhead pointing ahead. */
    private static int onDeck(double ahead, double left) {
        double fromTip = 0.15 - ahead;
        return fromTip >= 0 && fromTip <= 0.07 && Math.abs(left) <= fromTip * 0.8 ? WHITE : BLACK;
    }

    private void wheel(Frame frame, double left) {
        double radius = Pioneer2Dx.WHEEL_DIAMETER_METERS / 2;
        upright(frame, new double[] {-radius, left}, new double[] {radius, left}, 0, 2 * radius, (along, up) -> {
            double middle = Math.hypot(along - radius, up - radius);
            return middle > radius ? Texture.NOTHING : middle > 0.5 * radius ? TYRE : HUB;
        });
    }

    private void camera(Frame frame) {
        double[][] corners = {
            {MAST_X + MAST_HALF, -MAST_HALF},
            {MAST_X + MAST_HALF, MAST_HALF},
            {MAST_X - MAST_HALF, MAST_HALF},
            {MAST_X - MAST_HALF, -MAST_HALF}
        };
        Texture front = (along, up) -> Math.hypot(along - MAST_HALF, up - (MAST_METERS - 0.045)) < 0.022 ? LENS : BLACK;
        for (int i = 0; i < corners.length; i++) {
            Texture surface = i == 0 ? front : Texture.plain(BLACK);
            upright(frame, corners[i], corners[(i + 1) % corners.length], DECK_METERS, MAST_METERS, surface);
        }
    }

    private void upright(Frame frame, double[] from, double[] to, double low, double high, Texture surface) {
        painter.upright(
                frame.x(from[0], from[1]),
                frame.y(from[0], from[1]),
                frame.x(to[0], to[1]),
                frame.y(to[0], to[1]),
                low,
                high,
                surface);
    }

    /** A robot's coordinate frame: ahead and left of its centre of rotation. */
    private static final class Frame {
        private final double originX;
        private final double originY;
        private final double cos;
        private final double sin;

        Frame(RobotSnapshot robot) {
            originX = robot.xMeters();
            originY = robot.yMeters();
            cos = Math.cos(robot.headingRadians());
            sin = Math.sin(robot.headingRadians());
        }

        double x(double ahead, double left) {
            return originX + ahead * cos - left * sin;
        }

        double y(double ahead, double left) {
            return originY + ahead * sin + left * cos;
        }

        double ahead(double x, double y) {
            return (x - originX) * cos + (y - originY) * sin;
        }

        double left(double x, double y) {
            return (y - originY) * cos - (x - originX) * sin;
        }
    }
}
