package simgsm.draw;

import java.util.Arrays;
import java.util.StringTokenizer;

/** A shape of straight lines and cubic curves. Must not change after it has been drawn. */
public final class Outline {
    /** An empty outline. */
    public Outline() {}

    /** Handle length of the cubic for a quarter of a unit circle. */
    private static final double QUARTER = 0.5522847498;

    /** M, L, C or Z a step, as in SVG. */
    private final StringBuilder steps = new StringBuilder();
    /** The coordinates of all steps, x and y in turn: one place for M and L, three for C. */
    private double[] places = new double[16];

    private int count;

    public Outline move(double x, double y) {
        return step('M', x, y);
    }

    public Outline line(double x, double y) {
        return step('L', x, y);
    }

    public Outline curve(double x1, double y1, double x2, double y2, double x, double y) {
        return step('C', x1, y1, x2, y2, x, y);
    }

    public Outline close() {
        return step('Z');
    }

    private Outline step(char kind, double... xy) {
        steps.append(kind);
        if (count + xy.length > places.length) {
            places = Arrays.copyOf(places, 2 * places.length);
        }
        System.arraycopy(xy, 0, places, count, xy.length);
        count += xy.length;
        return this;
    }

    // ---- shapes ----------------------------------------------------------------------------------------------------

    public static Outline line(double x1, double y1, double x2, double y2) {
        return new Outline().move(x1, y1).line(x2, y2);
    }

    /** Open; x and y in turn. */
    public static Outline polyline(double... xy) {
        Outline outline = new Outline().move(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
            outline.line(xy[i], xy[i + 1]);
        }
        return outline;
    }

    public static Outline polygon(double... xy) {
        return polyline(xy).close();
    }

    public static Outline circle(double x, double y, double radius) {
        return round(x - radius, y - radius, 2 * radius, 2 * radius, radius);
    }

    public static Outline box(double x, double y, double width, double height) {
        return new Outline().addBox(x, y, width, height);
    }

    public static Outline round(double x, double y, double width, double height, double radius) {
        return new Outline().addRound(x, y, width, height, radius);
    }

    public Outline addBox(double x, double y, double width, double height) {
        return move(x, y)
                .line(x + width, y)
                .line(x + width, y + height)
                .line(x, y + height)
                .close();
    }

    private Outline addRound(double x, double y, double width, double height, double radius) {
        double r = Math.min(radius, Math.min(width, height) / 2);
        double near = r * (1 - QUARTER);
        double right = x + width;
        double low = y + height;
        move(x + r, y).line(right - r, y).curve(right - near, y, right, y + near, right, y + r);
        line(right, low - r).curve(right, low - near, right - near, low, right - r, low);
        line(x + r, low).curve(x + near, low, x, low - near, x, low - r);
        return line(x, y + r).curve(x, y + near, x + near, y, x + r, y).close();
    }

    /** Part of the ellipse in a box, anticlockwise from an angle; 0 degrees is to the right. */
    private Outline addArc(double x, double y, double width, double height, double startDegrees, double degrees) {
        int parts = (int) Math.ceil(Math.abs(degrees) / 90);
        double turn = Math.toRadians(degrees) / parts;
        double handle = 4.0 / 3 * Math.tan(turn / 4);
        double rx = width / 2;
        double ry = height / 2;
        for (int i = 0; i <= parts; i++) {
            double angle = Math.toRadians(startDegrees) + i * turn;
            double px = x + rx + rx * Math.cos(angle);
            double py = y + ry - ry * Math.sin(angle);
            double dx = -rx * Math.sin(angle) * handle;
            double dy = -ry * Math.cos(angle) * handle;
            if (i == 0) {
                move(px, py);
            } else {
                places[count - 4] = px - dx;
                places[count - 3] = py - dy;
                places[count - 2] = px;
                places[count - 1] = py;
            }
            if (i < parts) {
                curve(px + dx, py + dy, 0, 0, 0, 0);
            }
        }
        return this;
    }

    /**
     * Reads a shape: SVG's absolute M, L, C and Z, and for closed forms and arcs
     * {@code O x y radius}, {@code R x y width height corner}, {@code A x y width height start-degrees degrees}.
     */
    public static Outline parse(String text) {
        Outline outline = new Outline();
        int from = 0;
        while (from < text.length()) {
            int to = from + 1;
            while (to < text.length() && !Character.isUpperCase(text.charAt(to))) {
                to++;
            }
            outline.add(text.charAt(from), numbers(text.substring(from + 1, to)));
            from = to;
        }
        return outline;
    }

    private static double[] numbers(String text) {
        StringTokenizer words = new StringTokenizer(text);
        double[] numbers = new double[words.countTokens()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = Double.parseDouble(words.nextToken());
        }
        return numbers;
    }

    private void add(char kind, double... n) {
        switch (kind) {
            case 'O' -> addRound(n[0] - n[2], n[1] - n[2], 2 * n[2], 2 * n[2], n[2]);
            case 'R' -> addRound(n[0], n[1], n[2], n[3], n[4]);
            case 'A' -> addArc(n[0], n[1], n[2], n[3], n[4], n[5]);
            default -> step(kind, n);
        }
    }

    // ---- changes and readings --------------------------------------------------------------------------------------

    /** Enlarged by a factor about the origin, then moved. */
    public Outline placed(double x, double y, double factor) {
        Outline moved = new Outline();
        moved.steps.append(steps);
        moved.places = Arrays.copyOf(places, count);
        moved.count = count;
        for (int i = 0; i < count; i += 2) {
            moved.places[i] = moved.places[i] * factor + x;
            moved.places[i + 1] = moved.places[i + 1] * factor + y;
        }
        return moved;
    }

    public boolean isEmpty() {
        return count == 0;
    }

    /** One of M, L, C and Z for each step. */
    public CharSequence steps() {
        return steps;
    }

    /** The coordinate at an index; M and L have two, C six, Z none. */
    public double coordinate(int index) {
        return places[index];
    }

    /** The outline as SVG, to a hundredth of a pixel. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(8 * count);
        int at = 0;
        for (int i = 0; i < steps.length(); i++) {
            char kind = steps.charAt(i);
            text.append(kind);
            int numbers = kind == 'Z' ? 0 : kind == 'C' ? 6 : 2;
            for (int k = 0; k < numbers; k++) {
                text.append(k == 0 ? "" : " ").append(SvgCanvas.number(places[at++]));
            }
        }
        return text.toString();
    }
}
