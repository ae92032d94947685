package simgsm.phone.ui;

/** One line of text with its cursor, in the largest type in which it fits. */
final class LcdLine {
    private static final double[] SIZES = {28, 20, 15};

    private LcdLine() {}

    /** @param pending whether the character before the cursor may still change */
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
        int fits = (int) (room / letter);
        int first = Math.max(0, Math.min(caret, text.length()) - fits);
        String shown = text.substring(first, Math.min(text.length(), first + fits));
        pen.left(shown, font, LcdPen.MARGIN, baseline);
        double x = LcdPen.MARGIN + pen.width(font, shown.substring(0, Math.min(shown.length(), caret - first)));
        if (pending) {
            pen.fill(x - letter, baseline + 3, letter, 2);
        } else {
            pen.fill(x, baseline - size * 0.78, 2, size * 0.95);
        }
    }
}
