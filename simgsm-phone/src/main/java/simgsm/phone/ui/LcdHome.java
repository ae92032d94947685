package simgsm.phone.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.CallSnapshot;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.store.MessageFolder;
import simgsm.ss.ServiceCode;
import simgsm.station.ServingCell;
import simgsm.station.StationSnapshot;

/** The home screen: standby, a number being typed, or a call by {@link LcdCall}. */
final class LcdHome {
    private static final double HINT_BASELINE = 151;
    /** 3 lines of news leave no room for the cell. */
    private static final int CROWDED = 3;

    private final TextBundle texts;
    private final LcdCall calls;

    LcdHome(TextBundle texts, Locale language) {
        this.texts = texts;
        calls = new LcdCall(texts, language);
    }

    void paint(LcdPen pen, HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        if (call.phase() != CallPhase.NONE) {
            calls.call(pen, phone);
        } else if (!phone.typed().isEmpty()) {
            typed(pen, phone);
        } else if (call.held().isPresent()) {
            calls.held(pen, phone);
        } else if (call.ended().isPresent()) {
            calls.ended(pen, phone);
        } else {
            rest(pen, phone);
        }
    }

    /** The operator's name, the own number, and news. */
    private void rest(LcdPen pen, HandsetSnapshot phone) {
        StationSnapshot station = phone.station();
        double number = 84;
        if (station.registered()) {
            pen.centred(LcdPainter.operatorOf(station), pen.sans(21, true), 70);
            number = 96;
        }
        pen.ink(Ink.LCD_QUIET);
        pen.centred(texts.of("lcd.own") + " " + phone.own().digits(), pen.mono(14, true), number);
        List<String> news = news(phone);
        if (station.registered() && news.size() < CROWDED) {
            station.cell().ifPresent(cell -> pen.centred(cell(texts, cell), pen.mono(11, false), 111));
        }
        pen.ink(Ink.LCD_INK);
        if (!station.registered()) {
            reason(pen, phone);
        } else if (news.isEmpty()) {
            pen.hint(texts.of("lcd.hint.rest"), 146);
        }
        double baseline = news.size() >= CROWDED ? 117 : 123;
        for (String line : news) {
            pen.centred(line, pen.sans(13, true), baseline);
            baseline += 16;
        }
    }

    static String cell(TextBundle texts, ServingCell cell) {
        return texts.of(
                "lcd.cell",
                String.valueOf(cell.identity()),
                String.valueOf(cell.areaCode()),
                String.valueOf(cell.dbm()));
    }

    private List<String> news(HandsetSnapshot phone) {
        List<String> news = new ArrayList<>();
        if (phone.station().registered()) {
            addCount(news, "lcd.unread", phone.unread());
            addCount(news, "lcd.missed", phone.missed());
            addCount(news, "lcd.unread.broadcasts", phone.unread(MessageFolder.BROADCASTS));
        }
        return news;
    }

    private void addCount(List<String> news, String key, int count) {
        if (count > 0) {
            news.add(texts.of(key, count));
        }
    }

    /** Wraps the reason if one line is too short. */
    private void reason(LcdPen pen, HandsetSnapshot phone) {
        var font = pen.sans(12.5, false);
        double baseline = 124;
        for (String line : pen.wrap(reason(phone), font, LcdPen.WIDTH - 2 * LcdPen.MARGIN)) {
            pen.centred(line.strip(), font, baseline);
            baseline += 16;
        }
    }

    private String reason(HandsetSnapshot phone) {
        if (!phone.station().card().isReady()) {
            return texts.of("lcd.sim." + phone.station().card().state().name().toLowerCase(Locale.ROOT));
        }
        return phone.station()
                .rejectCause()
                .map(cause -> CauseText.ofRefusal(texts, cause, phone.station().cardRefused(), phone.own()))
                .orElseGet(() -> texts.of(phone.station().linkUp() ? "lcd.registering" : "lcd.nocenter"));
    }

    private void typed(LcdPen pen, HandsetSnapshot phone) {
        LcdLine.paint(pen, phone.typed(), phone.caret(), 92, false);
        String name = phone.nameOf(phone.typed());
        if (!name.equals(phone.typed())) {
            pen.left(name, pen.sans(14, true), LcdPen.MARGIN, 120, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
        }
        pen.hint(texts.of("lcd.hint." + hint(phone.typed())), HINT_BASELINE);
    }

    /** No service code begins with {@code **#}: these are keys for a robot, typed after its call has ended. */
    static String hint(String typed) {
        return typed.startsWith("**#") ? "order" : ServiceCode.isCode(typed) ? "code" : "typed";
    }
}
