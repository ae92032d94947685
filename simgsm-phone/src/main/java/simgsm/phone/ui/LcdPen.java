package simgsm.phone.ui;

import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;

/**
 * Writes on the phone's display, a drawing of 280 by 180 units with its origin at the top left. Every y is a baseline or a
 * top edge in units.
 */
final class LcdPen {
    static final double WIDTH = 280;
    static final double HEIGHT = 180;
    static final double MARGIN = 12;
    private static final double HINT_POINTS = 13;
    private static final double LONG_HINT_POINTS = 11;

    private final Graphics2D g;
    private final double unit;

    /** @param unit pixels per unit */
    LcdPen(Graphics2D g, double unit) {
        this.g = g;
        this.unit = unit;
    }

    Graphics2D graphics() {
        return g;
    }

    double unit() {
        return unit;
    }

    Font mono(double size, boolean bold) {
        return Theme.mono(size * unit / Theme.zoom(), bold);
    }

    Font sans(double size, boolean bold) {
        return Theme.sans(size * unit / Theme.zoom(), bold);
    }

    double width(Font font, String text) {
        return Drawing.width(font, text) / unit;
    }

    void left(String text, Font font, double x, double baseline) {
        g.setFont(font);
        g.drawString(text, (float) (x * unit), (float) (baseline * unit));
    }

    /** Writes left-aligned text, cut with an ellipsis to fit the room. */
    void left(String text, Font font, double x, double baseline, double room) {
        left(Drawing.fitted(font, text, room * unit), font, x, baseline);
    }

    /** The text, cut in front with an ellipsis to fit the room. */
    String fittedEnd(String text, Font font, double room) {
        return Drawing.fittedEnd(font, text, room * unit);
    }

    void right(String text, Font font, double x, double baseline) {
        g.setFont(font);
        Drawing.rightAligned(g, text, x * unit, baseline * unit);
    }

    void centred(String text, Font font, double baseline) {
        String fitted = Drawing.fitted(font, text, (WIDTH - 2 * MARGIN) * unit);
        left(fitted, font, (WIDTH - width(font, fitted)) / 2, baseline);
    }

    /** Writes a quiet line, centred; a long one is smaller. */
    void hint(String text, double baseline) {
        ink(Ink.LCD_QUIET);
        boolean fits = width(sans(HINT_POINTS, false), text) <= WIDTH - 2 * MARGIN;
        centred(text, sans(fits ? HINT_POINTS : LONG_HINT_POINTS, false), baseline);
        ink(Ink.LCD_INK);
    }

    void ink(Ink ink) {
        g.setColor(Theme.color(ink));
    }

    void fill(double x, double y, double width, double height) {
        Drawing.fillCrisp(g, x * unit, y * unit, width * unit, height * unit);
    }

    void round(double x, double y, double width, double height, double radius) {
        g.fill(Drawing.round(x * unit, y * unit, width * unit, height * unit, radius * unit));
    }

    void symbol(Symbol symbol, double x, double y, double size) {
        symbol.paint(g, x * unit, y * unit, size * unit);
    }

    /** Writes text in inverse video. */
    void inverse(String text, Font font, double x, double baseline, double height) {
        double boxWidth = width(font, text) + 8;
        ink(Ink.LCD_INK);
        round(x, baseline - height * 0.78, boxWidth, height, 3);
        ink(Ink.LCD_PAPER);
        left(text, font, x + 4, baseline);
        ink(Ink.LCD_INK);
    }

    /** A line of a wrapped text. @param start its first character in the text */
    record Line(int start, String text) {}

    /** Breaks a text into lines of that width, at blanks where possible, and at line breaks. */
    List<String> wrap(String text, Font font, double room) {
        return lines(text, font, room).stream().map(Line::text).toList();
    }

    /** Breaks a text as {@link #wrap} does; each line has its position in the text. */
    List<Line> lines(String text, Font font, double room) {
        List<Line> lines = new ArrayList<>();
        int start = 0;
        for (String paragraph : text.split("\n", -1)) {
            wrapParagraph(start, paragraph, font, room, lines);
            start += paragraph.length() + 1;
        }
        return lines;
    }

    private void wrapParagraph(int offset, String paragraph, Font font, double room, List<Line> lines) {
        int start = 0;
        while (start < paragraph.length()) {
            int end = start + 1;
            while (end < paragraph.length() && width(font, paragraph.substring(start, end + 1)) <= room) {
                end++;
            }
            if (end < paragraph.length()) {
                int blank = paragraph.lastIndexOf(' ', end);
                end = blank > start ? blank + 1 : end;
            }
            lines.add(new Line(offset + start, paragraph.substring(start, end)));
            start = end;
        }
        if (paragraph.isEmpty()) {
            lines.add(new Line(offset, ""));
        }
    }
}
