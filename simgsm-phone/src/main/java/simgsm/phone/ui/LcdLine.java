package simgsm.phone.ui;

/** One line of text with its cursor, in the largest type that fits. */
final class LcdLine {
    private static final double[] SIZES = {28, 20, 15};
    /** Marks the ends of a text longer than the line. */
    private static final String CUT = "\u2026";

    private LcdLine() {}

    /** @param pending true if the character before the cursor may still change */
    static void paint(LcdPen pen, String text, int caret, double baseline, boolean pending) {
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN - 4;
        double size = SIZES[SIZES.length - 1];
        for (double each : SIZES) {
            if (pen.width(pen.mono(each, true), text) <= room) {
                size = each;
                break;
            }
        }
        var font = pen.mono(size, true);
        double letter = pen.width(font, "0");
        boolean isCut = pen.width(font, text) > room;
        int fits = (int) (room / letter) - (isCut ? 2 : 0);
        int first = Math.max(0, Math.min(caret, text.length()) - fits);
        int end = Math.min(text.length(), first + fits);
        double left = LcdPen.MARGIN;
        if (first > 0) {
            pen.left(CUT, font, left, baseline);
            left += letter;
        }
        pen.left(text.substring(first, end), font, left, baseline);
        if (end < text.length()) {
            pen.left(CUT, font, left + (end - first + 0.4) * letter, baseline);
        }
        double x = left + pen.width(font, text.substring(first, Math.min(end, caret)));
        if (pending) {
            pen.fill(x - letter, baseline + 3, letter, 2);
        } else {
            pen.fill(x, baseline - size * 0.78, 2, size * 0.95);
        }
    }
}
