package simgsm.draw;

/** The shape of a lamp. Each state has its own shape and is readable without the colour. */
public enum StatusMark {
    /** Steady: stopped, idle. */
    SQUARE(true, "M-.82 -.82L.82 -.82L.82 .82L-.82 .82Z"),
    /** Going: moving, sending. */
    ARROW(true, "M-.75 -.95L1 0L-.75 .95L-.35 0Z"),
    /** Collision, failure: a star of eight points. */
    BURST(true, star(8, 1.1, 0.55)),
    /** Present but empty: no motors, off. */
    RING(false, "O0 0 .8"),
    /** Cut off: disconnected. */
    SLASHED_RING(false, "O0 0 .8M-.88 .88L.88 -.88"),
    /** In order: linked, attached. */
    DISC(true, "O0 0 .92"),
    /** Under way: searching, alerting. */
    HALF_DISC(true, "A-.86 -.86 1.72 1.72 -90 180Z"),
    /** Ringing or waiting. */
    DIAMOND(true, "M0 -1L1 0L0 1L-1 0Z"),
    /** Ciphered: a padlock. */
    LOCK(
            true,
            "M-.75 -.05L.75 -.05L.75 .95L-.75 .95Z"
                    + "M-.55 -.05L-.55 -.55L-.3 -.95L.3 -.95L.55 -.55L.55 -.05L.3 -.05L.3 -.45L.15 -.65L-.15 -.65L-.3 -.45L-.3 -.05Z"),
    /** Done. */
    TICK(false, "M-.8 .1L-.25 .65L.85 -.6"),
    /** Refused. */
    CROSS(false, "M-.65 -.65L.65 .65M.65 -.65L-.65 .65");

    private final boolean filled;
    private final Outline outline;

    StatusMark(boolean filled, String outline) {
        this(filled, Outline.parse(outline));
    }

    /** @param outline in a circle of radius 1 about the origin */
    StatusMark(boolean filled, Outline outline) {
        this.filled = filled;
        this.outline = outline;
    }

    private static Outline star(int points, double far, double near) {
        double[] xy = new double[4 * points];
        for (int i = 0; i < 2 * points; i++) {
            double angle = Math.PI * i / points - Math.PI / 2;
            xy[2 * i] = (i % 2 == 0 ? far : near) * Math.cos(angle);
            xy[2 * i + 1] = (i % 2 == 0 ? far : near) * Math.sin(angle);
        }
        return Outline.polygon(xy);
    }

    /** Draws the mark in a circle with that radius in pixels. */
    public void draw(Canvas g, double x, double y, double radius, Ink ink) {
        g.ink(ink);
        g.pen(Math.max(1.4, radius / g.px(1) * 0.34));
        Outline placed = outline.placed(x, y, radius);
        if (filled) {
            g.fill(placed);
        } else {
            g.draw(placed);
        }
        if (this == HALF_DISC) {
            g.pen(1.4);
            g.draw(Outline.circle(x, y, radius * 0.86));
        }
    }
}
