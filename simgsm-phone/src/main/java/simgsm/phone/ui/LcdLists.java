package simgsm.phone.ui;

import java.util.List;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.Words;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.ui.Symbol;

/** Menus, lists, messages and other texts to read on the display. */
final class LcdLists {
    private static final double TITLE_BASELINE = 48;
    private static final double LIST_TOP = 55;
    private static final double LIST_BOTTOM = 155;
    private static final double ROW_HEIGHT = 20;
    private static final double TWO_LINES_HEIGHT = 33;
    private static final double RIGHT_EDGE = LcdPen.WIDTH - LcdPen.MARGIN;
    private static final int LINES = 5;
    private static final int LINES_ABOVE_STATUS = 4;
    private static final double LINE_HEIGHT = 19;
    private static final double FIRST_LINE = 70;
    private static final double STATUS_BASELINE = 150;

    private final TextBundle texts;
    private final WordsText words;

    LcdLists(TextBundle texts, WordsText words) {
        this.texts = texts;
        this.words = words;
    }

    void list(LcdPen pen, Screen.Listing list) {
        List<Screen.Row> rows = list.rows();
        int size = rows.size();
        String place = size == 0 ? "0" : list.selected() + 1 + "/" + size;
        title(pen, words.of(list.title()), place);
        if (size == 0) {
            pen.centred(texts.of("lcd.empty"), pen.sans(14, false), 104);
            return;
        }
        boolean twoLines = rows.stream().anyMatch(row -> !row.detail().isEmpty());
        double height = twoLines ? TWO_LINES_HEIGHT : ROW_HEIGHT;
        int shown = (int) ((LIST_BOTTOM - LIST_TOP) / height);
        int first = Math.max(0, Math.min(list.selected() - shown / 2, size - shown));
        for (int i = first; i < Math.min(size, first + shown); i++) {
            double top = LIST_TOP + (i - first) * height;
            int number = list.numbered() ? i + 1 : 0;
            row(pen, rows.get(i), number, top, height, i == list.selected());
        }
        if (size > shown) {
            scrollBar(pen, first, shown, size);
        }
        pen.ink(Ink.LCD_INK);
    }

    private static void title(LcdPen pen, String title, String right) {
        double room = RIGHT_EDGE - LcdPen.MARGIN - pen.width(pen.mono(12, false), right) - 6;
        pen.left(title, pen.sans(13, true), LcdPen.MARGIN, TITLE_BASELINE, room);
        pen.right(right, pen.mono(12, false), RIGHT_EDGE, TITLE_BASELINE);
    }

    private void row(LcdPen pen, Screen.Row row, int number, double top, double height, boolean chosen) {
        if (chosen) {
            pen.ink(Ink.LCD_INK);
            pen.round(LcdPen.MARGIN - 4, top, LcdPen.WIDTH - 2 * LcdPen.MARGIN + 8, height - 1, 4);
        }
        Ink ink = chosen ? Ink.LCD_PAPER : Ink.LCD_INK;
        double baseline = top + 14.5;
        double left = LcdPen.MARGIN + 4;
        if (row.mark() != Screen.Mark.NONE) {
            pen.ink(ink);
            mark(pen, row.mark(), left + 7, top + 10);
            left += 20;
        } else if (number > 0) {
            pen.ink(chosen ? ink : Ink.LCD_QUIET);
            pen.left(String.valueOf(number), pen.mono(13, true), left, baseline);
            left += 18;
        }
        pen.ink(ink);
        String note = row.at().map(words::time).orElseGet(() -> words.of(row.note()));
        var noteFont = row.at().isPresent() ? pen.mono(12, false) : pen.sans(12, false);
        double edge = RIGHT_EDGE - 6;
        pen.right(note, noteFont, edge, baseline);
        double room = edge - left - (note.isEmpty() ? 0 : pen.width(noteFont, note) + 6);
        pen.left(words.of(row.label()), pen.sans(13.5, chosen || !row.detail().isEmpty()), left, baseline, room);
        pen.left(row.detail(), pen.sans(12, false), left, top + 28.5, edge - left);
    }

    private static void mark(LcdPen pen, Screen.Mark mark, double x, double y) {
        Symbol symbol = switch (mark) {
            case CHOSEN -> Symbol.TICK;
            case NONE, NOT_CHOSEN -> null;
            case NAME -> Symbol.PERSON;
            case DIALLED -> Symbol.CALL_OUT;
            case RECEIVED -> Symbol.CALL_IN;
            case MISSED -> Symbol.CALL_MISSED;
            case UNREAD -> Symbol.ENVELOPE;
            case READ -> Symbol.ENVELOPE_OPEN;
            case DRAFT -> Symbol.EDIT;
            case SENDING -> Symbol.RIGHT;
            case SENT -> Symbol.TICK;
            case DELIVERED -> Symbol.TICKS;
            case FAILED -> Symbol.CLOSE;
        };
        if (symbol != null) {
            pen.symbol(symbol, x, y, 15);
        }
    }

    void message(LcdPen pen, HandsetSnapshot phone, Screen.MessageView view) {
        StoredMessage message = view.message();
        mark(pen, Screen.Mark.of(message), LcdPen.MARGIN + 8, 43);
        pen.left(phone.nameOf(message.party()), pen.sans(13, true), 32, TITLE_BASELINE, 180);
        pen.right(words.time(message.at()), pen.mono(12, false), RIGHT_EDGE, TITLE_BASELINE);
        boolean hasStatus = view.folder() == MessageFolder.OUTBOX;
        int room = hasStatus ? LINES_ABOVE_STATUS : LINES;
        var font = pen.sans(14, false);
        List<String> lines = pen.wrap(message.text(), font, LcdPen.WIDTH - 2 * LcdPen.MARGIN - 8);
        int first = Math.min(view.scroll(), Math.max(0, lines.size() - room));
        for (int i = first; i < Math.min(lines.size(), first + room); i++) {
            pen.left(lines.get(i), font, LcdPen.MARGIN, FIRST_LINE + (i - first) * LINE_HEIGHT);
        }
        if (lines.size() > room) {
            scrollBar(pen, first, room, lines.size());
        }
        if (hasStatus) {
            pen.hint(CauseText.ofDelivery(texts, message), STATUS_BASELINE);
        }
    }

    private static void scrollBar(LcdPen pen, int first, int shown, int all) {
        double height = LIST_BOTTOM - LIST_TOP;
        double x = LcdPen.WIDTH - 7;
        pen.ink(Ink.LCD_GHOST);
        pen.fill(x, LIST_TOP, 2.5, height);
        pen.ink(Ink.LCD_INK);
        pen.fill(x, LIST_TOP + height * first / all, 2.5, height * shown / all);
    }

    /** Writes a title above lines; a single line without a title is centred. */
    void details(LcdPen pen, Screen.Details details) {
        String title = words.of(details.title());
        if (title.isEmpty()) {
            middle(pen, words.of(details.lines().get(0)));
            return;
        }
        title(pen, title, "");
        double baseline = FIRST_LINE + 4;
        for (Words line : details.lines()) {
            pen.left(words.of(line), pen.sans(14, false), LcdPen.MARGIN, baseline, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
            baseline += 21;
        }
    }

    /** Writes a short text in the middle of the display. */
    static void middle(LcdPen pen, String text) {
        var font = pen.sans(15, true);
        List<String> lines = pen.wrap(text, font, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
        for (int i = 0; i < lines.size(); i++) {
            pen.centred(lines.get(i).strip(), font, 100 - 10 * (lines.size() - 1) + 21 * i);
        }
    }
}
