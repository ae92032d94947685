package simgsm.draw;

/**
 * A drawing surface: a window, an image, an SVG document. Coordinates are pixels, y down; pen widths and text sizes
 * are in design units, which {@link #px} converts to pixels. Ink and pen persist until set again; settings made
 * inside {@link #moved}, {@link #clipped} or {@link #group} end with it.
 */
public interface Canvas {
    /** The pixels of a length in units of the design: units times the zoom. */
    double px(double units);

    /** @param opacity 0 (invisible) to 1 */
    void ink(Ink ink, double opacity);

    default void ink(Ink ink) {
        ink(ink, 1);
    }

    /**
     * The pen of {@link #draw}.
     *
     * @param width in units
     * @param dash length of each dash and gap in units; 0 for a solid line with round ends
     */
    void pen(double width, double dash);

    default void pen(double width) {
        pen(width, 0);
    }

    /** Strokes an outline with the pen. */
    void draw(Outline outline);

    default void line(double x1, double y1, double x2, double y2) {
        draw(Outline.line(x1, y1, x2, y2));
    }

    void fill(Outline outline);

    /** Fills a rectangle with its edges moved to whole device pixels. */
    void bar(double x, double y, double width, double height);

    /** Writes a text centred on a point, horizontally by its width and vertically by the height of its capitals. */
    void text(String text, Face face, double x, double y);

    /** The width of a text in pixels. */
    double width(String text, Face face);

    /** Draws in a coordinate system that is moved and then turned clockwise. */
    void moved(double x, double y, double radians, Runnable inside);

    /** Draws only inside an outline. */
    void clipped(Outline edge, Runnable inside);

    /** Draws a group under a name for a document's scripts and styles; a screen ignores the name. */
    void group(String name, Runnable inside);
}
