package simgsm.phone.ui;

import java.util.Locale;
import java.util.Optional;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.phone.handset.CallSnapshot;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.store.CallRecord;
import simgsm.station.StationSnapshot;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.scope.CodecText;

/** The display in a call, while a call is held, and after its end. */
final class LcdCall {
    private static final double HINT_BASELINE = 151;
    private static final double KEYED_BASELINE = 113;
    private static final double HEARD_BASELINE = 135;
    private static final double CODEC_SIZE = 11;
    private static final double CODEC_GAP = 6;

    private final TextBundle texts;
    private final Locale language;
    private final LcdKeys keys;

    LcdCall(TextBundle texts, Locale language) {
        this.texts = texts;
        this.language = language;
        keys = new LcdKeys(texts);
    }

    /** The only call is held. */
    void held(LcdPen pen, HandsetSnapshot phone) {
        pen.left(texts.of("lcd.on_hold"), pen.sans(13, true), LcdPen.MARGIN, 53);
        String number = phone.call().held().orElseThrow();
        String party = number.isEmpty() ? texts.of("lcd.unknown") : phone.nameOf(number);
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN;
        pen.left(party, pen.sans(20, true), LcdPen.MARGIN, 83, room);
        over(phone).ifPresent(over -> pen.left(over, pen.sans(13, false), LcdPen.MARGIN, 116, room));
        pen.hint(texts.of("lcd.hint.held"), HINT_BASELINE);
    }

    /** The end of the other call, above the held one. */
    private Optional<String> over(HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        return call.ended().map(cause -> phone.nameOf(call.number()) + ": " + CauseText.of(texts, cause));
    }

    void ended(LcdPen pen, HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        double lift = LcdKeys.lift(pen, call);
        pen.centred(texts.of("lcd.ended"), pen.sans(14, true), 66 - lift / 2);
        pen.centred(CauseText.of(texts, call.ended().orElseThrow()), pen.sans(13, false), 88 - lift * 0.7);
        pen.ink(Ink.LCD_QUIET);
        String line = phone.nameOf(call.number()) + (call.seconds() > 0 ? "   " + time(call.seconds()) : "");
        pen.centred(line.strip(), pen.mono(13, false), 112 - lift);
        pen.ink(Ink.LCD_INK);
        keys.heard(pen, call, HEARD_BASELINE - lift, true);
    }

    void call(LcdPen pen, HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        String phase = phaseOf(texts, call);
        symbolOf(call)
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
        boolean hasSecond = call.waiting().isPresent() || call.held().isPresent();
        double lift = hasSecond || call.phase() != CallPhase.CONNECTED ? 0 : LcdKeys.lift(pen, call);
        party(pen, phone, lift > 0);
        if (call.phase() == CallPhase.CONNECTED) {
            keys.keyed(pen, call.keyed(), KEYED_BASELINE - lift);
            keys.heard(pen, call, HEARD_BASELINE - lift, !hasSecond);
        }
        if (call.waiting().isPresent()) {
            second(pen, phone, "lcd.waiting", call.waiting().get());
        } else if (call.held().isPresent()) {
            second(pen, phone, "lcd.held", call.held().get());
        } else if (call.heard().isEmpty() || call.phase() != CallPhase.CONNECTED) {
            pen.hint(texts.of(hintKey(phone)), HINT_BASELINE);
        }
    }

    /** The name of the other party above its number, or the number alone; small if a robot's words need the room. */
    private void party(LcdPen pen, HandsetSnapshot phone, boolean isSmall) {
        String number = phone.call().number();
        String name = phone.nameOf(number);
        double room = LcdPen.WIDTH - 2 * LcdPen.MARGIN;
        if (number.isEmpty()) {
            pen.left(texts.of("lcd.unknown"), pen.sans(20, true), LcdPen.MARGIN, 83, room);
        } else if (isSmall) {
            pen.left(name, pen.sans(13, true), LcdPen.MARGIN, 70, room);
        } else if (name.equals(number)) {
            pen.left(number, pen.mono(25, true), LcdPen.MARGIN, 83, room);
        } else {
            pen.left(name, pen.sans(20, true), LcdPen.MARGIN, 76, room);
            pen.ink(Ink.LCD_QUIET);
            pen.left(number, pen.mono(13, false), LcdPen.MARGIN, 92, room);
            pen.ink(Ink.LCD_INK);
        }
    }

    /** The other party, in inverse video. @param key text for waiting or held */
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

    /** The call's phase in words. */
    static String phaseOf(TextBundle texts, CallSnapshot call) {
        return texts.of(
                call.onHold()
                        ? "lcd.on_hold_by_peer"
                        : "lcd.call." + call.phase().name().toLowerCase(Locale.ROOT));
    }

    private static StatusMark symbolOf(CallSnapshot call) {
        return switch (call.phase()) {
            case CONNECTED -> call.onHold() ? StatusMark.HALF_DISC : StatusMark.DISC;
            case RINGING -> StatusMark.DIAMOND;
            default -> StatusMark.HALF_DISC;
        };
    }

    private static String time(int seconds) {
        return CallRecord.duration(seconds);
    }
}
