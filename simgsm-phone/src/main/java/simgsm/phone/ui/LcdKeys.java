package simgsm.phone.ui;

import java.awt.Font;
import java.util.List;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.CallSnapshot;
import simgsm.phone.ui.KeyGroups.Group;

/** The keys of a call on the display: those sent, in groups, and those heard, with their meaning in a robot's replies. */
final class LcdKeys {
    private static final double RIGHT_EDGE = LcdPen.WIDTH - LcdPen.MARGIN;
    private static final double LABEL_SIZE = 11;
    private static final double LABEL_GAP = 6;
    private static final double[] KEYED_SIZES = {20, 15};
    /** Gaps within an order and before the next order, in letter widths. */
    private static final double GAP = 0.4;

    private static final double WIDE_GAP = 1.2;
    private static final double MEANING_SIZE = 12.5;
    private static final double EARLIER_SIZE = 11.5;
    private static final double EARLIER_BELOW = 18;
    private static final double WORDS_PITCH = 12.5;
    private static final int MOST_WORDS_LINES = 3;
    private static final String CUT = "\u2026";
    private static final String BETWEEN = ", ";

    private final TextBundle texts;

    LcdKeys(TextBundle texts) {
        this.texts = texts;
    }

    /** Writes the newest keys that fit, in whole groups, after a label; an ellipsis replaces the older ones. */
    void keyed(LcdPen pen, String keys, double baseline) {
        if (keys.isEmpty()) {
            pen.ink(Ink.LCD_QUIET);
            pen.left(texts.of("lcd.nokeys"), pen.sans(12, false), LcdPen.MARGIN, baseline);
            pen.ink(Ink.LCD_INK);
            return;
        }
        double left = label(pen, "lcd.keyed", baseline);
        double room = RIGHT_EDGE - left;
        List<Group> groups = KeyGroups.of(keys);
        Font font = pen.mono(KEYED_SIZES[0], true);
        if (width(pen, font, groups) > room) {
            font = pen.mono(KEYED_SIZES[1], true);
        }
        int first = 0;
        double cut = pen.width(font, CUT);
        while (first < groups.size() - 1
                && width(pen, font, groups.subList(first, groups.size())) > room - (first > 0 ? cut : 0)) {
            first++;
        }
        if (first > 0) {
            pen.left(CUT, font, left, baseline);
        }
        double x = first > 0 ? left + cut : left;
        for (int i = first; i < groups.size(); i++) {
            x += i > first ? gap(pen, font, groups.get(i)) : 0;
            String shown = pen.fittedEnd(groups.get(i).keys(), font, RIGHT_EDGE - x);
            pen.left(shown, font, x, baseline);
            x += pen.width(font, shown);
        }
    }

    private static double gap(LcdPen pen, Font font, Group group) {
        return pen.width(font, "0") * (group.begins() ? WIDE_GAP : GAP);
    }

    private static double width(LcdPen pen, Font font, List<Group> groups) {
        double width = 0;
        for (Group group : groups) {
            width += pen.width(font, group.keys()) + (width > 0 ? gap(pen, font, group) : 0);
        }
        return width;
    }

    /** @return start of the text after the label */
    private double label(LcdPen pen, String key, double baseline) {
        Font font = pen.sans(LABEL_SIZE, false);
        String label = texts.of(key);
        pen.ink(Ink.LCD_QUIET);
        pen.left(label, font, LcdPen.MARGIN, baseline);
        pen.ink(Ink.LCD_INK);
        return LcdPen.MARGIN + pen.width(font, label) + LABEL_GAP;
    }

    /**
     * The newest key heard as a keycap, with its meaning; below it a robot's words, or the keys before it.
     *
     * @param showsMore true if there is room below
     */
    void heard(LcdPen pen, CallSnapshot call, double baseline, boolean showsMore) {
        String heard = call.heard();
        if (heard.isEmpty()) {
            return;
        }
        int newest = heard.length() - 1;
        double left = label(pen, "lcd.heard", baseline);
        Font keycap = pen.mono(19, true);
        String symbol = heard.substring(newest);
        pen.inverse(symbol, keycap, left, baseline + 1.5, 23);
        double from = left + pen.width(keycap, symbol) + 8 + LABEL_GAP;
        String meaning = meaning(call, heard.charAt(newest));
        if (!meaning.isEmpty()) {
            String words = texts.of("lcd.meaning", meaning);
            Font font = pen.sans(MEANING_SIZE, true);
            double shrink = Math.min(1, (RIGHT_EDGE - from) / pen.width(font, words));
            pen.left(words, pen.sans(MEANING_SIZE * shrink, true), from, baseline);
        }
        if (showsMore && !call.words().isEmpty()) {
            double below = baseline + EARLIER_BELOW;
            for (String line : words(pen, call)) {
                pen.left(line, pen.sans(EARLIER_SIZE, false), LcdPen.MARGIN, below);
                below += WORDS_PITCH;
            }
        } else if (showsMore && newest > 0) {
            earlier(pen, call, heard.substring(0, newest), baseline + EARLIER_BELOW);
        }
    }

    /** A robot's words in lines; their end, if there are more than {@value #MOST_WORDS_LINES}. */
    private static List<String> words(LcdPen pen, CallSnapshot call) {
        Font font = pen.sans(EARLIER_SIZE, false);
        String shown = call.words();
        List<String> lines = pen.wrap(shown, font, RIGHT_EDGE - LcdPen.MARGIN);
        while (lines.size() > MOST_WORDS_LINES) {
            shown = CUT + shown.substring(shown.indexOf(' ', 2));
            lines = pen.wrap(shown, font, RIGHT_EDGE - LcdPen.MARGIN);
        }
        return lines;
    }

    /** The room that further lines of a robot's words take from what is above them, in units. */
    static double lift(LcdPen pen, CallSnapshot call) {
        return (words(pen, call).size() - 1) * WORDS_PITCH;
    }

    /** Writes the newest keys that fit, the oldest of them first. */
    private void earlier(LcdPen pen, CallSnapshot call, String heard, double baseline) {
        double left = label(pen, "lcd.heard.before", baseline);
        Font font = pen.sans(EARLIER_SIZE, false);
        String shown = "";
        for (int i = heard.length() - 1; i >= 0; i--) {
            String more = item(call, heard.charAt(i)) + (shown.isEmpty() ? "" : BETWEEN + shown);
            if (pen.width(font, (i > 0 ? CUT + " " : "") + more) > RIGHT_EDGE - left) {
                shown = CUT + " " + shown;
                break;
            }
            shown = more;
        }
        pen.ink(Ink.LCD_QUIET);
        pen.left(shown, font, left, baseline);
        pen.ink(Ink.LCD_INK);
    }

    /** The text of a received key with its meaning, if it has one in a robot's replies. */
    private String item(CallSnapshot call, char key) {
        String meaning = meaning(call, key);
        return meaning.isEmpty() ? String.valueOf(key) : key + " " + meaning;
    }

    private String meaning(CallSnapshot call, char key) {
        return call.meaningOf(DtmfKey.of(key)).map(name -> texts.of(name)).orElse("");
    }
}
