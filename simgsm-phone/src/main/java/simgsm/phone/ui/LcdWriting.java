package simgsm.phone.ui;

import java.util.List;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.TextEntry;
import simgsm.phone.store.StoredMessage;
import simgsm.sms.Alphabet;
import simgsm.sms.MessageSplitter;

/** Text entry on the display, entry of the receiver, progress of a sent message, and notes. */
final class LcdWriting {
    private static final int LINES = 4;
    private static final double LINE_HEIGHT = 19;
    private static final double HINT_BASELINE = 150;
    private static final double CHOICES_BASELINE = 151;

    // The text of a USSD dialogue, in the display's units.
    private static final double USSD_TOP = 36;
    private static final double USSD_BOTTOM = 120;
    private static final double USSD_REPLY = 26;
    private static final double USSD_LARGEST = 16;
    private static final double USSD_SMALLEST = 10;
    private static final double LEADING = 1.3;

    private final TextBundle texts;
    private final WordsText words;

    LcdWriting(TextBundle texts, WordsText words) {
        this.texts = texts;
        this.words = words;
    }

    void text(LcdPen pen, Screen.Writing writing) {
        pen.inverse(sign(writing.mode()), pen.mono(12, true), LcdPen.MARGIN - 2, 49, 17);
        counter(pen, writing.text());
        var font = pen.sans(15, false);
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN - 4;
        List<LcdPen.Line> lines = pen.lines(writing.text(), font, room);
        int caretLine = 0;
        while (caretLine < lines.size() - 1 && lines.get(caretLine + 1).start() <= writing.caret()) {
            caretLine++;
        }
        int first = Math.max(0, caretLine - LINES + 1);
        for (int i = first; i < Math.min(lines.size(), first + LINES); i++) {
            double baseline = 70 + (i - first) * LINE_HEIGHT;
            LcdPen.Line line = lines.get(i);
            pen.left(line.text(), font, LcdPen.MARGIN, baseline);
            if (i == caretLine) {
                String left = line.text().substring(0, writing.caret() - line.start());
                caret(pen, LcdPen.MARGIN + pen.width(font, left), baseline, writing.pending());
            }
        }
        if (writing.pending()) {
            choices(pen, writing.choices(), writing.text().charAt(writing.caret() - 1));
        } else if (writing.text().isEmpty()) {
            pen.hint(texts.of("lcd.hint.write.empty"), HINT_BASELINE);
        }
    }

    private static String sign(TextEntry.Mode mode) {
        return switch (mode) {
            case LOWER -> "abc";
            case CAPITAL -> "Abc";
            case UPPER -> "ABC";
            case NUMBERS -> "123";
        };
    }

    /** Characters left in the last part, and number of parts. */
    private void counter(LcdPen pen, String text) {
        MessageSplitter.Measure measure = MessageSplitter.measure(text);
        String alphabet = measure.alphabet() == Alphabet.GSM_7BIT ? "" : "Unicode ";
        String count = alphabet + texts.of("lcd.counter", measure.unitsLeft(), measure.parts());
        pen.right(count, pen.mono(13, true), LcdPen.WIDTH - LcdPen.MARGIN, 49);
    }

    /** Marks a letter that may still change by a bar; otherwise the caret follows it. */
    private static void caret(LcdPen pen, double x, double baseline, boolean pending) {
        if (pending) {
            pen.fill(x - 9, baseline + 3, 9, 2);
        } else {
            pen.fill(x + 1, baseline - 13, 1.6, 16);
        }
    }

    private static void choices(LcdPen pen, String letters, char chosen) {
        double x = LcdPen.MARGIN;
        var font = pen.mono(14, true);
        for (char letter : letters.toCharArray()) {
            String shown = letter == ' ' ? "\u2423" : letter == '\n' ? "\u21b5" : String.valueOf(letter);
            if (Character.toLowerCase(chosen) == letter) {
                pen.inverse(shown, font, x, CHOICES_BASELINE, 17);
            } else {
                pen.left(shown, font, x + 4, CHOICES_BASELINE);
            }
            x += 20;
        }
    }

    /** A number, with the name that belongs to it, or a name. */
    void entry(LcdPen pen, HandsetSnapshot phone, Screen.Entry entry) {
        pen.left(words.of(entry.title()), pen.sans(14, true), LcdPen.MARGIN, 52);
        entry.mode().ifPresent(mode -> pen.right(sign(mode), pen.mono(12, true), LcdPen.WIDTH - LcdPen.MARGIN, 52));
        LcdLine.paint(pen, entry.text(), entry.caret(), 96, !entry.choices().isEmpty());
        String name = phone.nameOf(entry.text());
        if (entry.mode().isEmpty() && !name.equals(entry.text())) {
            pen.left(name, pen.sans(14, false), LcdPen.MARGIN, 124, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
        }
        if (!entry.choices().isEmpty()) {
            choices(pen, entry.choices(), entry.text().charAt(entry.caret() - 1));
        } else if (!phone.station().card().isReady()) {
            pen.hint(texts.of("lcd.hint.emergency"), HINT_BASELINE);
        }
    }

    /** The progress of the last sent message; at the bottom the number of unread messages. */
    void sent(LcdPen pen, HandsetSnapshot phone, StoredMessage message) {
        pen.ink(Ink.LCD_QUIET);
        pen.centred(texts.of("lcd.to") + " " + phone.nameOf(message.party()), pen.sans(14, true), 62);
        pen.ink(Ink.LCD_INK);
        var font = pen.sans(15, true);
        double baseline = 92;
        for (String line : pen.wrap(CauseText.ofDelivery(texts, message), font, LcdPen.WIDTH - 2 * LcdPen.MARGIN)) {
            pen.centred(line.strip(), font, baseline);
            baseline += 20;
        }
        if (phone.unread() > 0) {
            pen.centred(texts.of("lcd.unread", phone.unread()), pen.sans(13, true), 140);
        }
    }

    /** The network's text, as large as it fits, above the reply, if one is expected. */
    void ussd(LcdPen pen, Screen.Ussd ussd) {
        boolean isWaiting = ussd.phase() == Screen.Ussd.Phase.WAITING;
        boolean isAsked = ussd.phase() == Screen.Ussd.Phase.ASKED;
        String text = isWaiting ? texts.of("lcd.ussd.waiting", ussd.text()) : ussd.text();
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN;
        double height = isAsked ? USSD_BOTTOM - USSD_REPLY : USSD_BOTTOM;
        double size = USSD_LARGEST;
        while (size > USSD_SMALLEST
                && pen.wrap(text, pen.sans(size, false), room).size() * size * LEADING > height) {
            size--;
        }
        var font = pen.sans(size, isWaiting);
        double baseline = USSD_TOP + size;
        for (String line : pen.wrap(text, font, room)) {
            pen.left(line, font, LcdPen.MARGIN, baseline);
            baseline += size * LEADING;
        }
        if (isAsked) {
            var typed = pen.mono(18, true);
            String reply = pen.fittedEnd(ussd.reply(), typed, room - 4);
            pen.left(reply, typed, LcdPen.MARGIN, USSD_TOP + USSD_BOTTOM - 4);
            caret(pen, LcdPen.MARGIN + pen.width(typed, reply), USSD_TOP + USSD_BOTTOM - 4, false);
        }
    }

    void note(LcdPen pen, Screen.Note note) {
        LcdLists.middle(pen, CauseText.ofNote(texts, note));
    }
}
