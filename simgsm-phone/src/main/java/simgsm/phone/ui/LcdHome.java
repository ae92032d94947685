package simgsm.phone.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.CallSnapshot;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.handset.ToneMeaning;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.store.CallRecord;
import simgsm.phone.store.MessageFolder;
import simgsm.station.ServingCell;
import simgsm.station.StationSnapshot;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Symbol;
import simgsm.ui.scope.CodecText;

/** The display in standby, while a number is typed, and in a call. */
final class LcdHome {
    private static final double HINT_BASELINE = 151;
    private static final int KEYED_SHOWN = 25;
    /** So many lines of news leave no room for the cell's. */
    private static final int CROWDED = 3;

    private static final int EARLIER_SHOWN = 5;

    private static final double MEANING_SIZE = 12.5;
    private static final double CODEC_SIZE = 11;
    private static final double CODEC_GAP = 6;

    private final TextBundle texts;
    private final Locale language;

    LcdHome(TextBundle texts, Locale language) {
        this.texts = texts;
        this.language = language;
    }

    void paint(LcdPen pen, HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        if (call.phase() != CallPhase.NONE) {
            call(pen, phone);
        } else if (!phone.typed().isEmpty()) {
            typed(pen, phone);
        } else if (call.held().isPresent()) {
            held(pen, phone);
        } else if (call.ended().isPresent()) {
            ended(pen, phone);
        } else {
            rest(pen, phone);
        }
    }

    /** The operator's name, the own number, and what is new. */
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
        return phone.station()
                .rejectCause()
                .map(cause -> CauseText.ofRefusal(texts, cause, phone.station().cardRefused(), phone.own()))
                .orElseGet(() -> texts.of(phone.station().linkUp() ? "lcd.registering" : "lcd.nocenter"));
    }

    /** There is only a call that is held. */
    private void held(LcdPen pen, HandsetSnapshot phone) {
        pen.left(texts.of("lcd.on_hold"), pen.sans(13, true), LcdPen.MARGIN, 53);
        String number = phone.call().held().orElseThrow();
        String party = number.isEmpty() ? texts.of("lcd.unknown") : phone.nameOf(number);
        pen.left(party, pen.sans(20, true), LcdPen.MARGIN, 83, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
        pen.hint(texts.of("lcd.hint.held"), HINT_BASELINE);
    }

    private void typed(LcdPen pen, HandsetSnapshot phone) {
        LcdLine.paint(pen, phone.typed(), phone.caret(), 92, false);
        String name = phone.nameOf(phone.typed());
        if (!name.equals(phone.typed())) {
            pen.left(name, pen.sans(14, true), LcdPen.MARGIN, 120, LcdPen.WIDTH - 2 * LcdPen.MARGIN);
        }
        pen.hint(texts.of("lcd.hint.typed"), HINT_BASELINE);
    }

    private void ended(LcdPen pen, HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        pen.centred(texts.of("lcd.ended"), pen.sans(14, true), 66);
        pen.centred(CauseText.of(texts, call.ended().orElseThrow()), pen.sans(13, false), 88);
        pen.ink(Ink.LCD_QUIET);
        String line = phone.nameOf(call.number()) + (call.seconds() > 0 ? "   " + time(call.seconds()) : "");
        pen.centred(line.strip(), pen.mono(13, false), 112);
        pen.ink(Ink.LCD_INK);
        tone(pen, call.heard(), 140);
    }

    private void call(LcdPen pen, HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        String phase = texts.of("lcd.call." + call.phase().name().toLowerCase(Locale.ROOT));
        symbolOf(call.phase())
                .draw(
                        new GraphicsCanvas(pen.graphics()),
                        19 * pen.unit(),
                        48 * pen.unit(),
                        6 * pen.unit(),
                        Ink.LCD_INK);
        pen.left(phase, pen.sans(13, true), 32, 53, 150);
        if (call.phase() == CallPhase.CONNECTED) {
            String time = time(call.seconds());
            double edge = LcdPen.WIDTH - LcdPen.MARGIN;
            pen.right(time, pen.mono(14, true), edge, 53);
            double from = 32 + pen.width(pen.sans(13, true), phase);
            codec(pen, phone.station(), from, edge - pen.width(pen.mono(14, true), time));
        }
        party(pen, phone);
        if (call.phase() == CallPhase.CONNECTED) {
            keyed(pen, call.keyed());
            boolean hasSecond = call.waiting().isPresent() || call.held().isPresent();
            tone(pen, call.heard(), hasSecond ? 134 : 143);
        }
        if (call.waiting().isPresent()) {
            second(pen, phone, "lcd.waiting", call.waiting().get());
        } else if (call.held().isPresent()) {
            second(pen, phone, "lcd.held", call.held().get());
        } else if (call.heard().isEmpty() || call.phase() != CallPhase.CONNECTED) {
            pen.hint(texts.of(hintKey(phone)), HINT_BASELINE);
        }
    }

    /** The name of the other party above its number, or the number alone. */
    private void party(LcdPen pen, HandsetSnapshot phone) {
        String number = phone.call().number();
        String name = phone.nameOf(number);
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN;
        if (number.isEmpty()) {
            pen.left(texts.of("lcd.unknown"), pen.sans(20, true), LcdPen.MARGIN, 83, room);
        } else if (name.equals(number)) {
            pen.left(number, pen.mono(25, true), LcdPen.MARGIN, 83, room);
        } else {
            pen.left(name, pen.sans(20, true), LcdPen.MARGIN, 76, room);
            pen.ink(Ink.LCD_QUIET);
            pen.left(number, pen.mono(13, false), LcdPen.MARGIN, 92, room);
            pen.ink(Ink.LCD_INK);
        }
    }

    /** The other party, in inverse video. @param key of the bundle: does it wait, or is it held? */
    private void second(LcdPen pen, HandsetSnapshot phone, String key, String number) {
        String party = number.isEmpty() ? texts.of("lcd.unknown") : phone.nameOf(number);
        pen.inverse(texts.of(key, party), pen.sans(12, true), LcdPen.MARGIN, 155, 15);
    }

    private static String hintKey(HandsetSnapshot phone) {
        CallPhase phase = phone.call().phase();
        return phase == CallPhase.CONNECTED && phone.settings().keyMode() == KeyMode.SIGNALLED
                ? "lcd.hint.call.signalled"
                : "lcd.hint.call." + phase.name().toLowerCase(Locale.ROOT);
    }

    /** The codec, centred in the free space of the line. */
    private void codec(LcdPen pen, StationSnapshot station, double from, double to) {
        String words = CodecText.of(station.codec(), station.heardCodec(), language);
        double natural = pen.width(pen.sans(CODEC_SIZE, false), words);
        double room = to - from - 2 * CODEC_GAP;
        var font = pen.sans(Math.min(CODEC_SIZE, CODEC_SIZE * room / natural), false);
        pen.ink(Ink.LCD_QUIET);
        pen.left(words, font, (from + to - pen.width(font, words)) / 2, 53);
        pen.ink(Ink.LCD_INK);
    }

    private static StatusMark symbolOf(CallPhase phase) {
        return switch (phase) {
            case CONNECTED -> StatusMark.DISC;
            case RINGING -> StatusMark.DIAMOND;
            default -> StatusMark.HALF_DISC;
        };
    }

    private void keyed(LcdPen pen, String keys) {
        String shown = keys.length() <= KEYED_SHOWN ? keys : "\u2026" + keys.substring(keys.length() - KEYED_SHOWN);
        var font = pen.mono(keys.length() <= 15 ? 20 : 15, true);
        if (!keys.isEmpty()) {
            pen.symbol(Symbol.RIGHT, LcdPen.MARGIN + 4, 107, 13);
            pen.left(shown, font, LcdPen.MARGIN + 15, 114);
        } else {
            pen.ink(Ink.LCD_QUIET);
            pen.left(texts.of("lcd.nokeys"), pen.sans(12, false), LcdPen.MARGIN, 114);
            pen.ink(Ink.LCD_INK);
        }
    }

    /**
     * The newest received key as a keycap, followed by its meaning in a robot's replies, if any; at the right edge the keys
     * before it.
     */
    private void tone(LcdPen pen, String heard, double baseline) {
        if (heard.isEmpty()) {
            return;
        }
        DtmfKey tone = DtmfKey.of(heard.charAt(heard.length() - 1));
        String symbol = String.valueOf(tone.symbol());
        pen.symbol(Symbol.LEFT, LcdPen.MARGIN + 4, baseline - 5, 13);
        pen.inverse(symbol, pen.mono(21, true), LcdPen.MARGIN + 14, baseline + 2, 26);
        String meaning = ToneMeaning.textKey(tone)
                .map(key -> texts.of("lcd.meaning", texts.of(key)))
                .orElse("");
        var font = pen.sans(MEANING_SIZE, false);
        String earlier = heard.substring(Math.max(0, heard.length() - 1 - EARLIER_SHOWN), heard.length() - 1);
        pen.ink(Ink.LCD_QUIET);
        pen.right(earlier, pen.mono(13, false), LcdPen.WIDTH - LcdPen.MARGIN, baseline);
        double room = LcdPen.WIDTH - LcdPen.MARGIN - 64 - pen.width(pen.mono(13, false), earlier);
        double natural = pen.width(font, meaning);
        pen.left(meaning, natural > room ? pen.sans(MEANING_SIZE * room / natural, false) : font, 57, baseline);
        pen.ink(Ink.LCD_INK);
    }

    private static String time(int seconds) {
        return CallRecord.duration(seconds);
    }
}
