package simgsm.phone.ui;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.handset.MenuItem;
import simgsm.phone.handset.MessageFolder;
import simgsm.phone.handset.Screen;
import simgsm.phone.handset.StoredMessage;
import simgsm.ui.Symbol;

/** Menu, lists and messages on the display. */
final class LcdMessages {
    private static final int ROWS = 3;
    private static final double ROW_HEIGHT = 33;
    private static final double LIST_TOP = 56;
    private static final int LINES = 5;
    private static final double LINE_HEIGHT = 19;

    private final TextBundle texts;
    private final DateTimeFormatter when;

    LcdMessages(TextBundle texts, ZoneId zone) {
        this.texts = texts;
        this.when = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT).withZone(zone);
    }

    void menu(LcdPen pen, HandsetSnapshot phone, Screen.Menu menu) {
        MenuItem[] items = MenuItem.values();
        double height = 23;
        for (int i = 0; i < items.length; i++) {
            double top = 37 + i * height;
            boolean chosen = i == menu.selected();
            Ink ink = row(pen, top, height, chosen);
            pen.ink(chosen ? ink : Ink.LCD_QUIET);
            pen.left(String.valueOf(i + 1), pen.mono(13, true), LcdPen.MARGIN + 6, top + 16);
            pen.ink(ink);
            pen.left(
                    texts.of("menu." + items[i].name().toLowerCase(Locale.ROOT)), pen.sans(14, chosen), 36, top + 16.5);
            String count = countOf(phone, items[i]);
            pen.right(count, pen.mono(12, false), LcdPen.WIDTH - LcdPen.MARGIN - 8, top + 16);
        }
        pen.ink(Ink.LCD_INK);
        LcdHome.hint(pen, texts.of("lcd.hint.menu"));
    }

    private static String countOf(HandsetSnapshot phone, MenuItem item) {
        return switch (item) {
            case INBOX -> countOf(phone, MessageFolder.INBOX);
            case OUTBOX -> countOf(phone, MessageFolder.OUTBOX);
            case BROADCASTS -> countOf(phone, MessageFolder.BROADCASTS);
            default -> "";
        };
    }

    private static String countOf(HandsetSnapshot phone, MessageFolder box) {
        int unread = phone.unread(box);
        int all = phone.in(box).size();
        return unread > 0 ? unread + "/" + all : String.valueOf(all);
    }

    /** Paints the bar of the selected row. @return the ink of the row's text */
    private static Ink row(LcdPen pen, double top, double height, boolean chosen) {
        if (chosen) {
            pen.ink(Ink.LCD_INK);
            pen.round(LcdPen.MARGIN - 4, top, LcdPen.WIDTH - 2 * LcdPen.MARGIN + 8, height - 1, 4);
        }
        return chosen ? Ink.LCD_PAPER : Ink.LCD_INK;
    }

    void list(LcdPen pen, HandsetSnapshot phone, Screen.MessageList list) {
        List<StoredMessage> messages = phone.in(list.box());
        int size = messages.size();
        String title = texts.of("menu." + list.box().name().toLowerCase(Locale.ROOT));
        pen.left(title, pen.sans(13, true), LcdPen.MARGIN, 49);
        pen.right(size == 0 ? "0" : list.selected() + 1 + "/" + size, pen.mono(12, false), 268, 49);
        if (size == 0) {
            pen.centred(texts.of("lcd.empty"), pen.sans(14, false), 104);
        }
        int first = Math.max(0, Math.min(list.selected() - 1, size - ROWS));
        for (int i = first; i < Math.min(size, first + ROWS); i++) {
            entry(pen, messages.get(size - 1 - i), LIST_TOP + (i - first) * ROW_HEIGHT, i == list.selected());
        }
        pen.ink(Ink.LCD_INK);
        LcdHome.hint(pen, texts.of(hintOf(list.box(), size)));
    }

    private static String hintOf(MessageFolder box, int size) {
        if (size == 0) {
            return "lcd.hint.empty";
        }
        return box == MessageFolder.BROADCASTS ? "lcd.hint.broadcasts" : "lcd.hint.list";
    }

    private void entry(LcdPen pen, StoredMessage message, double top, boolean chosen) {
        Ink ink = row(pen, top, ROW_HEIGHT, chosen);
        pen.ink(ink);
        symbol(pen, message, LcdPen.MARGIN + 9, top + 10);
        pen.left(message.party(), pen.mono(13, true), 38, top + 14.5, 160);
        pen.right(when.format(message.at()), pen.mono(12, false), 264, top + 14.5);
        pen.left(message.text().replace('\n', ' '), pen.sans(12, false), 38, top + 28.5, 226);
    }

    /** Unread or read for a received message, the delivery mark for a sent one. */
    private static void symbol(LcdPen pen, StoredMessage message, double x, double y) {
        Symbol symbol = switch (message.delivery()) {
            case RECEIVED -> message.read() ? Symbol.ENVELOPE_OPEN : Symbol.ENVELOPE;
            case SENDING -> Symbol.RIGHT;
            case SENT -> Symbol.TICK;
            case DELIVERED -> Symbol.TICKS;
            case FAILED -> Symbol.CLOSE;
        };
        pen.symbol(symbol, x, y, 15);
    }

    void view(LcdPen pen, HandsetSnapshot phone, Screen.MessageView view) {
        List<StoredMessage> messages = phone.in(view.box());
        int index = messages.size() - 1 - view.selected();
        if (index < 0) {
            return;
        }
        StoredMessage message = messages.get(index);
        symbol(pen, message, LcdPen.MARGIN + 8, 44);
        pen.left(message.party(), pen.mono(13, true), 32, 49, 170);
        pen.right(when.format(message.at()), pen.mono(12, false), 268, 49);
        var font = pen.sans(14, false);
        List<String> lines = pen.wrap(message.text(), font, LcdPen.WIDTH - 2 * LcdPen.MARGIN - 8);
        int first = Math.min(view.scroll(), Math.max(0, lines.size() - LINES));
        for (int i = first; i < Math.min(lines.size(), first + LINES); i++) {
            pen.left(lines.get(i), font, LcdPen.MARGIN, 71 + (i - first) * LINE_HEIGHT);
        }
        if (lines.size() > LINES) {
            scrollBar(pen, first, lines.size());
        }
        LcdHome.hint(pen, status(view.box(), message));
    }

    private String status(MessageFolder box, StoredMessage message) {
        return switch (box) {
            case OUTBOX -> {
                String state = CauseText.ofDelivery(texts, message);
                yield message.delivery() == StoredMessage.Delivery.FAILED
                        ? state + "   " + texts.of("lcd.hint.again")
                        : state;
            }
            case INBOX -> texts.of("lcd.hint.message");
            case BROADCASTS -> texts.of("lcd.hint.broadcast");
        };
    }

    private static void scrollBar(LcdPen pen, int first, int lines) {
        double height = LINES * LINE_HEIGHT - 4;
        pen.ink(Ink.LCD_GHOST);
        pen.fill(270, 58, 2.5, height);
        pen.ink(Ink.LCD_INK);
        pen.fill(270, 58 + height * first / lines, 2.5, height * LINES / lines);
    }
}
