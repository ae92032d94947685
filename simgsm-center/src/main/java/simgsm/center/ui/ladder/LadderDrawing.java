package simgsm.center.ui.ladder;

import simgsm.center.msc.LadderEntry;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simgsm.draw.StatusMark;

/**
 * Draws the ladder, row by row: the heads of the lifelines, and rungs of time, arrow, name and protocol. Widths and heights
 * are in units.
 *
 * @param seenFrom left edge of the part that is in view, where the times are written
 * @param seenTo its right edge, where the protocols are written
 */
record LadderDrawing(Canvas canvas, Lifelines lifelines, double widthUnits, double seenFrom, double seenTo) {
    static final double HEAD_UNITS = 36;
    /** Height of the heads in a low window. */
    static final double LOW_HEAD_UNITS = 22;

    static final double RUNG_UNITS = 30;
    /** Height of a rung in a low window. */
    static final double LOW_RUNG_UNITS = 18;

    private static final double BOX_UNITS = 24;
    private static final double WIDEST_BOX_UNITS = 160;
    private static final double MARGIN_UNITS = 10;
    private static final double ARROW_HEAD_UNITS = 6;
    /** Gap between a name and the lines around it. */
    private static final double NAME_GAP_UNITS = 4;

    /** A ladder that is in view as a whole. */
    LadderDrawing(Canvas canvas, Lifelines lifelines, double widthUnits) {
        this(canvas, lifelines, widthUnits, 0, widthUnits);
    }

    private double px(double units) {
        return canvas.px(units);
    }

    /**
     * Draws the names of the lifelines.
     *
     * @param heightUnits the height of their boxes and the space around them
     */
    void heads(double heightUnits) {
        double boxUnits = Math.min(BOX_UNITS, heightUnits - 3);
        for (String name : lifelines.names()) {
            boolean isCenter = name.equals(LadderEntry.CENTER);
            double room = Math.min(lifelines.outerGap(widthUnits), WIDEST_BOX_UNITS) - 8;
            String fitted = fittedEnd(name, Face.MONO_STRONG, px(room - 12));
            double width = Math.min(px(room), canvas.width(fitted, Face.MONO_STRONG) + px(20));
            double x = px(lifelines.x(name, widthUnits));
            Outline box = Outline.round(x - width / 2, px((heightUnits - boxUnits) / 2), width, px(boxUnits), px(6));
            canvas.ink(isCenter ? Ink.ACCENT : Ink.CARD);
            canvas.fill(box);
            canvas.ink(isCenter ? Ink.ACCENT : Ink.CONTROL_LINE);
            canvas.pen(1);
            canvas.draw(box);
            canvas.ink(isCenter ? Ink.ON_ACCENT : Ink.TEXT);
            canvas.text(fitted, Face.MONO_STRONG, x, px(heightUnits / 2));
        }
        canvas.ink(Ink.LINE);
        canvas.bar(0, px(heightUnits) - 1, px(widthUnits), 1);
    }

    /**
     * Draws a message.
     *
     * @param behind the colour of the background
     */
    void rung(LadderRow row, double heightUnits, Ink behind) {
        canvas.ink(behind);
        canvas.fill(Outline.box(0, 0, px(widthUnits), px(heightUnits)));
        for (String name : lifelines.names()) {
            canvas.ink(name.equals(LadderEntry.CENTER) ? Ink.ACCENT : Ink.CONTROL_LINE);
            canvas.bar(px(lifelines.x(name, widthUnits)), 0, px(1), px(heightUnits));
        }
        arrow(row, heightUnits, behind);
        columns(row, heightUnits, behind);
    }

    /** Time and protocol, in front of lines that are scrolled below them. */
    private void columns(LadderRow row, double heightUnits, Ink behind) {
        Protocol protocol = Protocol.of(row.entry());
        double middle = px(heightUnits / 2);
        canvas.ink(behind);
        canvas.bar(px(seenFrom), 0, px(Lifelines.TIME_UNITS), px(heightUnits));
        canvas.bar(px(seenTo - Lifelines.TAG_UNITS), 0, px(Lifelines.TAG_UNITS), px(heightUnits));
        canvas.ink(Ink.QUIET);
        beginning(row.clock(), Face.MONO_SMALL, px(seenFrom + MARGIN_UNITS), middle);
        canvas.ink(protocol.ink());
        double tag = px(seenTo - MARGIN_UNITS) - canvas.width(protocol.tag(), Face.SMALL);
        beginning(protocol.tag(), Face.SMALL, tag, middle);
        if (row.entry().isCiphered()) {
            StatusMark.LOCK.draw(canvas, tag - px(9), middle, px(4.5), Ink.QUIET);
        }
    }

    private void beginning(String text, Face face, double x, double middle) {
        canvas.text(text, face, x + canvas.width(text, face) / 2, middle);
    }

    /**
     * Draws the arrow, and the name beside the centre. Messages of a terminal without a lifeline have half an arrow, and
     * the terminal's number before the name.
     */
    private void arrow(LadderRow row, double heightUnits, Ink behind) {
        LadderEntry entry = row.entry();
        double from = lifelines.x(entry.from(), widthUnits);
        double to = lifelines.x(entry.to(), widthUnits);
        double center = lifelines.x(LadderEntry.CENTER, widthUnits);
        String name = from >= 0 && to >= 0 ? entry.name() : row.terminal() + " " + entry.name();
        double start = from >= 0 ? from : center - lifelines.centerGap(widthUnits) / 2;
        double end = to >= 0 ? to : center + lifelines.centerGap(widthUnits) / 2;
        boolean isLow = heightUnits < RUNG_UNITS;
        double y = heightUnits - (isLow ? 3.5 : 6);
        double sign = Math.signum(end - start);
        double tip = end - sign * 2;
        canvas.ink(Protocol.of(entry).ink());
        canvas.pen(1.4);
        canvas.line(px(start), px(y), px(tip - sign * (ARROW_HEAD_UNITS - 1)), px(y));
        double back = tip - sign * ARROW_HEAD_UNITS * 1.4;
        double half = isLow ? 3 : ARROW_HEAD_UNITS * 0.7;
        canvas.fill(Outline.polygon(px(tip), px(y), px(back), px(y - half), px(back), px(y + half)));
        name(name, center, Math.min(start, end) < center, heightUnits, behind);
    }

    /** A name that is too long for its room is cut; a tool tip has all of it. */
    private void name(String name, double center, boolean isLeft, double heightUnits, Ink behind) {
        double gap = lifelines.centerGap(widthUnits);
        boolean isLarge = heightUnits >= RUNG_UNITS && canvas.width(name, Face.BASE) <= px(gap - 2 * NAME_GAP_UNITS);
        Face face = isLarge ? Face.BASE : Face.SMALL;
        Lifelines.Range room = lifelines.nameRoom(isLeft, widthUnits);
        double left = px(room.left() + NAME_GAP_UNITS);
        double right = px(room.right() - NAME_GAP_UNITS);
        String fitted = fitted(name, face, right - left);
        double width = canvas.width(fitted, face);
        double middleUnits = center + (isLeft ? -gap : gap) / 2;
        double x = Math.max(left, Math.min(right - width, px(middleUnits) - width / 2));
        boolean isLow = heightUnits < RUNG_UNITS;
        double middle = px((heightUnits - (isLow ? 5 : 9)) / 2);
        double half = px(isLow ? 6 : 7);
        canvas.ink(behind);
        canvas.bar(x - px(3), middle - half, width + px(6), 2 * half);
        canvas.ink(Ink.TEXT);
        beginning(fitted, face, x, middle);
    }

    private String fitted(String text, Face face, double room) {
        int end = text.length();
        String cut = text;
        while (end > 0 && canvas.width(cut, face) > room) {
            cut = text.substring(0, --end) + "\u2026";
        }
        return cut;
    }

    /** Truncates at the front, because numbers differ in their last digits. */
    private String fittedEnd(String text, Face face, double room) {
        int start = 0;
        String cut = text;
        while (start < text.length() && canvas.width(cut, face) > room) {
            cut = "\u2026" + text.substring(++start);
        }
        return cut;
    }
}
