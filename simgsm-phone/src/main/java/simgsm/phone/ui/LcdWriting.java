package simgsm.phone.ui;

import java.util.List;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.handset.Screen;
import simgsm.phone.handset.StoredMessage;
import simgsm.phone.handset.TextEntry;
import simgsm.sms.Alphabet;
import simgsm.sms.MessageSplitter;

/** Text entry on the display, entry of the receiver, progress of a sent message, and notes. */
final class LcdWriting {
    private static final int LINES = 4;
    private static final double LINE_HEIGHT = 20;

    // The text of a USSD dialogue, in the display's units.
    private static final double USSD_TOP = 36;
    private static final double USSD_BOTTOM = 120;
    private static final double USSD_REPLY = 26;
    private static final double USSD_LARGEST = 16;
    private static final double USSD_SMALLEST = 10;
    private static final double LEADING = 1.3;

    private final TextBundle texts;

    LcdWriting(TextBundle texts) {
        this.texts = texts;
    }

    void text(LcdPen pen, Screen.Writing writing) {
        pen.inverse(sign(writing.mode()), pen.mono(12, true), LcdPen.MARGIN - 2, 49, 17);
        counter(pen, writing.text());
        var font = pen.sans(15, false);
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN - 4;
        List<String> lines = pen.wrap(writing.text(), font, room);
        int first = Math.max(0, lines.size() - LINES);
        for (int i = first; i < lines.size(); i++) {
            double baseline = 74 + (i - first) * LINE_HEIGHT;
            pen.left(lines.get(i), font, LcdPen.MARGIN, baseline);
            if (i == lines.size() - 1) {
                caret(pen, LcdPen.MARGIN + pen.width(font, lines.get(i)), baseline, writing.pending());
            }
        }
        if (writing.pending()) {
            choices(pen, writing);
        } else {
            LcdHome.hint(pen, texts.of(writing.text().isEmpty() ? "lcd.hint.write.empty" : "lcd.hint.write"));
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

    private static void choices(LcdPen pen, Screen.Writing writing) {
        char chosen = writing.text().charAt(writing.text().length() - 1);
        double x = LcdPen.MARGIN;
        var font = pen.mono(14, true);
        for (char letter : writing.choices().toCharArray()) {
            String shown = letter == ' ' ? "\u2423" : letter == '\n' ? "\u21b5" : String.valueOf(letter);
            if (Character.toLowerCase(chosen) == letter) {
                pen.inverse(shown, font, x, 169, 19);
            } else {
                pen.left(shown, font, x + 4, 169);
            }
            x += 20;
        }
    }

    void recipient(LcdPen pen, Screen.Recipient recipient) {
        pen.left(texts.of("lcd.to"), pen.sans(14, true), LcdPen.MARGIN, 56);
        var font = pen.mono(27, true);
        pen.left(recipient.number(), font, LcdPen.MARGIN, 98);
        pen.fill(LcdPen.MARGIN + pen.width(font, recipient.number()) + 2, 77, 2, 25);
        LcdHome.hint(pen, texts.of("lcd.hint.recipient"));
    }

    /** The progress of the last sent message; at the bottom the number of unread messages. */
    void sent(LcdPen pen, HandsetSnapshot phone, StoredMessage message) {
        pen.ink(Ink.LCD_QUIET);
        pen.centred(texts.of("lcd.to") + " " + message.party(), pen.mono(14, true), 62);
        pen.ink(Ink.LCD_INK);
        var font = pen.sans(15, true);
        double baseline = 92;
        for (String line : pen.wrap(CauseText.ofDelivery(texts, message), font, LcdPen.WIDTH - 2 * LcdPen.MARGIN)) {
            pen.centred(line.strip(), font, baseline);
            baseline += 20;
        }
        boolean failed = message.delivery() == StoredMessage.Delivery.FAILED;
        if (phone.unread() > 0) {
            pen.centred(texts.of("lcd.unread", phone.unread()), pen.sans(13, true), 140);
        }
        String hint = failed ? "lcd.hint.failed" : phone.unread() > 0 ? "lcd.hint.sent.unread" : "lcd.hint.note";
        LcdHome.hint(pen, texts.of(hint));
    }

    /** The network's text, as large as it fits; below it the reply, if one is expected. */
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
            pen.left(ussd.reply(), typed, LcdPen.MARGIN, USSD_TOP + USSD_BOTTOM - 4);
            caret(pen, LcdPen.MARGIN + pen.width(typed, ussd.reply()), USSD_TOP + USSD_BOTTOM - 4, false);
        }
        LcdHome.hint(pen, texts.of("lcd.hint.ussd." + ussd.phase().name().toLowerCase(Locale.ROOT)));
    }

    void note(LcdPen pen, Screen.Note note) {
        String key = "note." + note.kind().name().toLowerCase(Locale.ROOT);
        var font = pen.sans(15, true);
        List<String> lines = pen.wrap(texts.of(key, note.detail()), font, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
        for (int i = 0; i < lines.size(); i++) {
            pen.centred(lines.get(i).strip(), font, 100 - 10 * (lines.size() - 1) + 21 * i);
        }
        pen.ink(Ink.LCD_INK);
        LcdHome.hint(pen, texts.of("lcd.hint.note"));
    }
}
